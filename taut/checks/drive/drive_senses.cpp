#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "taut/checks/drive/drive_uses.hpp"
#include "taut/solve/drives.hpp"
#include "taut/solve/running.hpp"

/// Which way drums turn, and how ropes run on them.
namespace taut::checks {
namespace {

/// Of the way that a drum lets out: taking in less than that is no hauling, but a drum that is stopped.
constexpr double least_haul = 0.01;

/// Whether the tension of a rope changes over a node while it runs.
bool loses_at(const machine::Node& node) {
  return node.kind == machine::NodeKind::contact && node.law.efficiency < 1 && node.law.friction != 0;
}
bool loses(const machine::Reeving& rope) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& node) { return loses_at(node); });
}

std::string paid_out_words(const std::string& rope, const std::string& drum, const std::string& words) {
  return fmt::format(
      "'{}' is judged only while it runs off '{}' over some of its sheaves, or without their loss ({}): "
      "add an equilibrium at rest, or with 'motion: in'",
      rope, drum, words);
}

}  // namespace

/// A drum turns one way: all ropes that run on it or off it have to agree on which. At rest they are asked as they run
/// while the machine hauls in. Which side a rope leaves it follows from the places where the path gives none.
void DriveUses::keep_winding(const machine::Model& m, const Array<solve::DrumResult>& ends,
                             const solve::EquilibriumResult& state) {
  if (ends.size() < 2) return;
  const auto runs = [](const Array<Array<int>>& flow) {
    return std::any_of(flow.begin(), flow.end(), [](const Array<int>& rope) {
      return std::any_of(rope.begin(), rope.end(), [](int f) { return f != 0; });
    });
  };
  Array<Array<int>> flow = state.flow;
  if (!runs(flow)) {
    solve::EquilibriumOptions hauling;
    hauling.motion = solve::Motion::in;
    flow = solve::flow_of(m, hauling);
  }
  struct Turn {
    int sense = 1;  // of the drum
    int reeving = 0;
  };
  std::map<int, Turn> turns;  // by the first of its ropes
  for (const solve::DrumResult& d : ends) {
    const Array<int>& rope = flow[d.reeving];
    if (rope.empty()) continue;
    const int along = d.at_end ? rope.back() : rope.front();
    if (along == 0) continue;
    const int turn = d.sense * (d.at_end ? along : -along);
    const Turn first = turns.try_emplace(d.drum, Turn{.sense = turn, .reeving = d.reeving}).first->second;
    if (first.sense == turn) continue;
    const std::string& name = m.drums[d.drum].name;
    const machine::Reeving &one = m.reevings[first.reeving], &other = m.reevings[d.reeving];
    unmade_.try_emplace(
        {{.kind = PartKind::drum, .name = name}, "winding"},
        first.reeving == d.reeving
            ? fmt::format("'{0}' would have to turn both ways at once: both ends of '{1}' are on it. Describe two "
                          "ropes, which meet where it stands",
                          name, one.name)
            : fmt::format("'{0}' would have to turn both ways at once, as '{1}' and '{2}' run on it and off it. Where "
                          "it takes both in, give the 'side' on which each leaves it; where '{2}' runs off while '{1}' "
                          "is hauled in, as a counterweight's does, give '{2}' 'haul: {3}'",
                          name, one.name, other.name, other.haul > 0 ? "to_start" : "to_end"));
  }
}

/// Where sheaves lose, a rope pulls less while it runs off its drum than at rest and hauled in; so it does where a map
/// of senses lets it run off over one of them, or leaves one out: that one loses nothing then.
void DriveUses::keep_senses(const machine::Model& m, const Array<solve::DrumResult>& ends,
                            const solve::EquilibriumResult& state, const std::string& words) {
  for (const solve::DrumResult& d : ends) {
    const machine::Reeving& rope = m.reevings[d.reeving];
    const Array<int>& flow = state.flow[d.reeving];
    const int hauls = d.at_end ? 1 : -1;
    const int at_drum = d.at_end ? flow.back() : flow.front();  // 0 in a map: it names contacts
    bool loses_all = true, loses_any = false, stands = true;
    for (std::size_t n = 0; n < flow.size(); ++n) {
      const machine::Node& node = rope.nodes[n];
      stands = stands && flow[n] == 0;
      if (!loses_at(node)) continue;
      loses_any = true;
      loses_all = loses_all && (machine::rides(m, node) || flow[n] == hauls);
    }
    if (!loses_any || stands || at_drum == hauls || (at_drum == 0 && loses_all)) {
      hauled_.insert(rope.name);
      continue;
    }
    paid_out_.try_emplace(rope.name, paid_out_words(rope.name, m.drums[d.drum].name, words));
  }
}

void DriveUses::take_way(const Array<solve::DrumResult>& drums, double time) {
  if (!(time > 0)) hauls_.clear();  // a motion begins
  for (const solve::DrumResult& d : drums) {
    const double speed = d.speed.value_or(0);
    if (!(time > 0) || !(d.pull > 0) || std::abs(speed) < standing_drum) continue;
    Haul& way = hauls_[d.reeving];
    (speed > 0 ? way.in : way.out) += std::abs(speed) * time;
    way.drum = d.drum;
  }
}

/// A motion that lets a loaded rope off its drum and never takes it in shows of its losses those that help.
void DriveUses::take_hauled(const machine::Model& m, const std::string& words) {
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    const machine::Reeving& rope = m.reevings[i];
    const Haul way = hauls_[static_cast<int>(i)];
    if (way.out == 0 || way.in > least_haul * way.out || !loses(rope)) {
      hauled_.insert(rope.name);
    } else if (at_rest_.contains(rope.name)) {
      paid_out_.try_emplace(rope.name, paid_out_words(rope.name, m.drums[way.drum].name, words));
    }
  }
  hauls_.clear();
}

}  // namespace taut::checks
