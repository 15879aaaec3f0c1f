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

/// Ways in which a motor with a speed turns, along the path of its rope and against it; neither where the signal has
/// no known range.
std::pair<bool, bool> turns_of(const machine::Drive& drive) {
  if (drive.kind != machine::DriveKind::speed) return {false, false};
  const auto range = machine::range_of(drive.signal);
  return range ? std::pair(range->most > 0, range->least < 0) : std::pair(false, false);
}

int sense_of(const Array<int>& flow) {
  const auto moves = std::find_if(flow.begin(), flow.end(), [](int f) { return f != 0; });
  return moves == flow.end() ? 0 : *moves;
}

}  // namespace

/// `motion` says which way a driven rope runs, not the sign of its motor's speed: one of the states has to agree with
/// it.
void DriveUses::keep_sense(const machine::Model& m, const machine::Reeving& rope, int sense, const std::string& words) {
  for (const machine::Node& node : rope.nodes) {
    if (!node.motor || node.kind != machine::NodeKind::drive) continue;
    const auto [along, against] = turns_of(m.motors[*node.motor].drive);
    if (!along && !against) continue;
    Runs& runs = runs_[node.name];
    runs.as_driven = runs.as_driven || (sense > 0 ? along : against);
    if (!runs.words.empty()) continue;
    runs.words = fmt::format(
        "'{}' is judged only while it runs {} its path ({}); the speed of its motor '{}' is the other way: give "
        "'motion' the other sense, or the speed its other sign",
        rope.name, sense > 0 ? "along" : "against", words, node.name);
  }
}

/// An unknown load balances the motor; where it would have to draw the rope, the motor does not turn the machine.
void DriveUses::keep_runs(const machine::Model& m, const solve::EquilibriumResult& state, const std::string& words) {
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    if (const int sense = sense_of(state.flow[r]); sense != 0) keep_sense(m, m.reevings[r], sense, words);
  }
  constexpr double rounding = 1e-9;  // of the tensions at a load
  for (const solve::ContactResult& c : state.contacts) {
    const machine::Reeving& rope = m.reevings[c.reeving];
    const machine::Node& node = rope.nodes[c.node];
    if (node.kind != machine::NodeKind::load || !node.load.open) continue;
    const double draws = sense_of(state.flow[c.reeving]) * (c.T_in - c.T_out);
    if (draws <= rounding * (c.T_in + c.T_out)) continue;
    const machine::Node& drive = rope.nodes.front();
    unmade_.try_emplace(
        {{.kind = PartKind::sheave, .name = drive.name}, "open_load"},
        fmt::format("{}: the torque of '{}' is less than its rope needs to run that way: '{}' would have to draw the "
                    "rope with {}. Give a larger torque, the torque its other sign, or 'motion' the other sense",
                    words, drive.name, node.name, display_.brief(rope.copies * draws, si::N)));
  }
}

/// A drum turns one way: all ropes that run on it or off it have to agree on which. At rest they are asked as they run
/// while the machine hauls in. Which side a rope leaves it follows from the places where the path gives none.
void DriveUses::keep_winding(const machine::Model& m, const Array<solve::DrumResult>& ends, Array<Array<int>> flow) {
  if (ends.size() < 2) return;
  const auto runs = [](const Array<Array<int>>& flow) {
    return std::any_of(flow.begin(), flow.end(), [](const Array<int>& rope) {
      return std::any_of(rope.begin(), rope.end(), [](int f) { return f != 0; });
    });
  };
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

/// A motion turns a drum as its ropes are described. What is asked is whether that is meant, where no side is given.
void DriveUses::take_winding(const machine::Model& m, Array<solve::DrumResult> ends) {
  std::set<int> by_place;
  for (const solve::DrumResult& d : ends) {
    const machine::Reeving& rope = m.reevings[d.reeving];
    if ((d.at_end ? rope.nodes.back() : rope.nodes.front()).side_by_place) by_place.insert(d.drum);
  }
  const auto given = [&](const solve::DrumResult& d) { return !by_place.contains(d.drum); };
  ends.erase(std::remove_if(ends.begin(), ends.end(), given), ends.end());
  keep_winding(m, ends, {});
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
