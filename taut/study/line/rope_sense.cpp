#include "taut/study/line/rope_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "taut/solve/running.hpp"

namespace taut::study {
namespace {

constexpr double no_friction = 1e-6;  ///< difference of tensions, of the larger one
constexpr double no_way = 1e-3;       ///< of a rope, of the carriage's way: it gives a little and runs nowhere

/// The node beside which the rope does not run: a clamp, else the end without a winch.
std::optional<int> still_node(const machine::Reeving& rope, int reeving, const std::vector<Winch>& winches) {
  for (std::size_t n = 0; n < rope.nodes.size(); ++n) {
    if (rope.nodes[n].kind == machine::NodeKind::clamp) return static_cast<int>(n);
  }
  if (rope.closed) return std::nullopt;
  const bool driven = std::any_of(winches.begin(), winches.end(), [&](const Winch& w) { return w.reeving == reeving; });
  if (!driven) return 0;
  const auto has = [&](bool at_end) {
    return std::any_of(winches.begin(), winches.end(),
                       [&](const Winch& w) { return w.reeving == reeving && w.at_end == at_end; });
  };
  if (has(false) == has(true)) return std::nullopt;
  return has(true) ? 0 : static_cast<int>(rope.nodes.size()) - 1;
}

const solve::ContactResult* contact_of(const solve::EquilibriumResult& e, int reeving, int node) {
  const auto found = std::find_if(e.contacts.begin(), e.contacts.end(),
                                  [&](const auto& c) { return c.reeving == reeving && c.node == node; });
  return found == e.contacts.end() ? nullptr : &*found;
}

/// The sense in which friction holds back, 0: none does.
int sense_of(const solve::ContactResult& c) {
  const double more = c.T_out - c.T_in;
  if (std::abs(more) <= no_friction * std::max(c.T_in, c.T_out)) return 0;
  return more > 0 ? 1 : -1;
}

bool all_against(const RopeSense& s) { return s.driven && s.against > 0 && s.with == 0; }

}  // namespace

std::vector<Winch> winches_of(const machine::Model& m, const machine::Machine& machine, std::optional<int> carriage) {
  std::vector<Winch> all;
  const auto& drums = machine.drums;
  for (std::size_t r = 0; r < machine.reevings.size(); ++r) {
    const machine::Reeving& rope = m.reevings[r];
    const auto index = static_cast<int>(r);
    if (rope.closed) {
      all.push_back({rope.nodes.front().name, index, false, true, {}});
      continue;
    }
    const auto on_drum = [&](const machine::Node& n) {
      return std::any_of(drums.begin(), drums.end(), [&](const auto& d) { return d.name == n.name; });
    };
    const auto rides = [&](const machine::Node& n) { return carriage && n.at.body == m.carriages[*carriage].body; };
    const bool start = on_drum(rope.nodes.front()) || rope.given == machine::Given::tension_at_start;
    const bool end = on_drum(rope.nodes.back()) || rope.given == machine::Given::tension_at_end;
    const bool mainline =
        carriage && (m.carriages[*carriage].mainline == index || m.carriages[*carriage].haulback == index);
    if (start || (mainline && !end && !rides(rope.nodes.front()))) {
      all.push_back({rope.nodes.front().name, index, false, false, {}});
    }
    if (end || (mainline && !start && !rides(rope.nodes.back()))) {
      all.push_back({rope.nodes.back().name, index, true, false, {}});
    }
  }
  // two ropes that end in one place
  std::map<std::string, int> ropes_at;
  for (const Winch& w : all) ++ropes_at[w.name];
  for (Winch& w : all) {
    if (ropes_at[w.name] == 1) continue;
    if (std::any_of(drums.begin(), drums.end(), [&](const auto& d) { return d.name == w.name; })) w.shared = w.name;
    w.name += "." + m.reevings[w.reeving].name;
  }
  return all;
}

void RopeSenses::take(const machine::Model& m, const std::vector<LoadPathPoint>& points) {
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    const auto reeving = static_cast<int>(r);
    const bool driven =
        std::any_of(winches_.begin(), winches_.end(), [&](const Winch& w) { return w.reeving == reeving; });
    const std::optional<int> still = still_node(m.reevings[r], reeving, winches_);
    const LoadPathPoint* last = nullptr;
    for (const LoadPathPoint& point : points) {
      if (!still || !point.at.outcome.ok()) continue;
      if (last != nullptr) take(m, {.reeving = reeving, .still = *still, .driven = driven}, *last, point);
      last = &point;
    }
  }
}

void RopeSenses::take(const machine::Model& m, const Running& of, const LoadPathPoint& before,
                      const LoadPathPoint& now) {
  const auto [reeving, still, driven] = of;
  const machine::Reeving& rope = m.reevings[reeving];
  const double way = std::hypot(now.x - before.x, now.z - before.z);
  for (const solve::ContactResult& c : now.at.contacts) {
    if (c.reeving != reeving || c.node == still) continue;
    const machine::Node& node = rope.nodes[c.node];
    if (node.kind != machine::NodeKind::contact || node.motor) continue;
    const solve::ContactResult* const was = contact_of(before.at, reeving, c.node);
    const int declared = sense_of(c);
    if (was == nullptr || declared == 0 || sense_of(*was) != declared) continue;
    const double runs = solve::passed(m, before.at, now.at, reeving, c.node, still);
    if (runs == 0) continue;
    auto known = std::find_if(all_.begin(), all_.end(), [&](const RopeSense& s) {
      return s.rope == rope.name && s.contact == node.name && s.declared == declared;
    });
    if (known == all_.end()) {
      known = all_.insert(all_.end(), {rope.name, node.name, declared});
      known->driven = driven;
    }
    const double more = (std::abs(c.T_out - c.T_in) + std::abs(was->T_out - was->T_in)) / 2;
    (runs * declared > 0 ? known->taken : known->given) += rope.copies * more * std::abs(runs);
    if (std::abs(runs) > no_way * way) (runs * declared > 0 ? known->with : known->against) += std::abs(runs);
  }
}

std::optional<std::string> wrong_senses(const std::vector<RopeSense>& senses, const Display& display) {
  std::string words, signs;
  std::set<std::string> reported;
  for (const RopeSense& s : senses) {
    if (!all_against(s)) continue;
    const bool whole_rope = std::all_of(senses.begin(), senses.end(), [&](const RopeSense& other) {
      return other.rope != s.rope || (all_against(other) && other.declared == s.declared);
    });
    const std::string name = whole_rope ? s.rope : s.contact;
    if (!reported.insert(name).second) continue;
    const std::string way = display.brief(s.against, si::m);
    words += fmt::format("{}{}", words.empty() ? "" : "; ",
                         whole_rope ? fmt::format("{} runs {} against its motion", s.rope, way)
                                    : fmt::format("{} runs {} over {} against its motion", s.rope, way, s.contact));
    signs += fmt::format("{}{}: {}", signs.empty() ? "" : ", ", name, -s.declared);
  }
  if (words.empty()) return std::nullopt;
  return fmt::format(
      "{}, so that friction would give energy: declare 'motion: {{{}}}' (1 along its path, -1 against it)", words,
      signs);
}

std::vector<RopeSense> giving(const std::vector<RopeSense>& senses) {
  std::vector<RopeSense> some;
  std::copy_if(senses.begin(), senses.end(), std::back_inserter(some), [](const RopeSense& s) { return s.given > 0; });
  return some;
}

double energy_given(const std::vector<RopeSense>& senses) {
  return std::accumulate(senses.begin(), senses.end(), 0.0,
                         [](double sum, const RopeSense& s) { return sum + s.given; });
}

std::optional<std::string> contrary_senses(const std::vector<RopeSense>& senses) {
  const auto one_way = [&](bool against) {
    return std::find_if(senses.begin(), senses.end(), [&](const RopeSense& s) {
      return against ? all_against(s) : s.driven && s.with > 0 && s.against == 0;
    });
  };
  const auto there = one_way(false), back = one_way(true);
  if (there == senses.end() || back == senses.end()) return std::nullopt;
  return fmt::format(
      "{} over {} and {} over {} can't both run as declared, whichever way the carriage goes: turn one sign",
      there->rope, there->contact, back->rope, back->contact);
}

}  // namespace taut::study
