#include "taut/solve/band.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/senses.hpp"
#include "taut/solve/running.hpp"

namespace taut::solve {
namespace {
using Flow = Array<Array<int>>;

void widen(double& low, double& high, double other_low, double other_high) {
  low = std::min(low, other_low);
  high = std::max(high, other_high);
}

/// Whether ropes touch the same supports in both.
bool touch_alike(const EquilibriumResult& a, const EquilibriumResult& b) {
  return std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                    [](const BranchResult& one, const BranchResult& o) {
                      return one.reeving == o.reeving && one.from == o.from && one.to == o.to;
                    });
}

/// The branch of an answer in which the end of another's branch lies, whatever supports the rope touches in each.
int branch_with(const EquilibriumResult& result, const BranchResult& branch, bool at_end) {
  int found = 0;
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    const BranchResult& one = result.branches[k];
    const bool back_to_start = branch.to <= branch.from;  // the last one of a rope without ends
    const bool within = at_end && !back_to_start ? one.from < branch.to : one.from <= branch.from;
    if (one.reeving == branch.reeving && within) found = static_cast<int>(k);
  }
  return found;
}

void widen_columns(EquilibriumResult& result, const EquilibriumResult& other) {
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    BranchResult& branch = result.branches[k];
    const BranchResult& o = other.branches[k];
    widen(branch.T_from_min, branch.T_from_max, o.T_from_min, o.T_from_max);
    widen(branch.T_to_min, branch.T_to_max, o.T_to_min, o.T_to_max);
  }
  for (std::size_t k = 0; k < result.contacts.size(); ++k) {
    ContactResult& contact = result.contacts[k];
    const ContactResult& o = other.contacts[k];
    widen(contact.T_in_min, contact.T_in_max, o.T_in_min, o.T_in_max);
    widen(contact.T_out_min, contact.T_out_max, o.T_out_min, o.T_out_max);
  }
}

void widen(EquilibriumResult& result, const EquilibriumResult& other) {
  if (touch_alike(result, other)) {
    widen_columns(result, other);
  } else {
    result.band = false;
  }
  for (std::size_t r = 0; r < result.ropes.size(); ++r) {
    RopeResult& rope = result.ropes[r];
    if (other.ropes[r].T_max <= rope.T_max) continue;
    const double unstretched = rope.unstretched;
    rope = other.ropes[r];
    rope.unstretched = unstretched;
    rope.branch = branch_with(result, other.branches[rope.branch], rope.at_end);
  }
}

bool any_nonzero(const Array<Array<int>>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](const Array<int>& rope) {
    return std::any_of(rope.begin(), rope.end(), [](int node) { return node != 0; });
  });
}

/// With the rope drawn to its carriage (1) or let out (-1) over the supports before it and after it on the path.
Array<Array<int>> crept(Array<Array<int>> flow, const Array<Array<int>>& creep, int before, int after) {
  for (std::size_t r = 0; r < creep.size(); ++r) {
    for (std::size_t n = 0; n < creep[r].size(); ++n) {
      if (creep[r][n] != 0) flow[r][n] = creep[r][n] * (creep[r][n] > 0 ? before : after);
    }
  }
  return flow;
}

constexpr int most_parts = 4;  ///< all combinations of their senses are solved; of more parts some

/// Contacts that turn their sense together: their places, {reeving, node}.
using Together = std::vector<std::pair<int, int>>;

Flow turned(Flow flow, const Together& part) {
  for (const auto& [r, n] : part) flow[r][n] = -flow[r][n];
  return flow;
}

/// Without repetition.
void add(Array<Flow>& all, Flow flow) {
  if (std::find(all.begin(), all.end(), flow) == all.end()) all.push_back(std::move(flow));
}

/// Flows that bound an answer.
struct Bounding {
  Array<Flow> flows;
  std::string left_out = {};  ///< of their combinations; empty: none is
};

/// Flows with all combinations of the senses of the parts; of many parts `first` and those in which one of them turns.
/// `first`: some of the combinations, which come first.
Bounding combined(const Array<Flow>& first, const Array<Together>& parts) {
  Array<Flow> all;
  for (const Flow& flow : first) add(all, flow);
  Array<Flow> wider = all;
  const bool every = static_cast<int>(parts.size()) <= most_parts;
  if (every) wider.resize(1);
  for (const Together& part : parts) {
    const Array<Flow> known = every ? wider : all;
    for (const Flow& flow : known) wider.push_back(turned(flow, part));
  }
  for (Flow& flow : wider) add(all, std::move(flow));
  if (every) return {.flows = std::move(all)};
  return {.flows = std::move(all),
          .left_out = fmt::format("{} ropes, or sides of carriages on them, may run each its own way, and some "
                                  "combinations alone are solved; say by 'haul' how ropes run",
                                  parts.size())};
}

bool runs_with_loss(const machine::Reeving& rope) {
  return rope.mass * rope.speed > 0 || std::any_of(rope.nodes.begin(), rope.nodes.end(), machine::loses);
}

/// At rest each rope is held as it ran last, whatever the others did: one on which a carriage rolls at the carriage and
/// on either side of it. Ropes of which the deck says how they run, run together.
Array<Together> parts_at_rest(const machine::Model& model, const machine::Senses& in) {
  Array<Together> all;
  Together told;
  for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
    const machine::Reeving& rope = model.reevings[r];
    if (!runs_with_loss(rope)) continue;
    std::map<int, Together> by_side;
    for (int n = 0; n < static_cast<int>(rope.nodes.size()); ++n) {
      const bool counts = rope.mass * rope.speed > 0 || machine::loses(rope.nodes[n]);
      if (counts) (rope.haul_is_told ? told : by_side[in.creep[r][n]]).emplace_back(r, n);
    }
    for (auto& [side, part] : by_side) all.push_back(std::move(part));
  }
  if (!told.empty()) all.push_back(std::move(told));
  return all;
}

/// The flows that bound what is at rest. First both motions of the machine as a whole, and of each rope to its own
/// winch.
Bounding at_rest(const machine::Model& model, const EquilibriumOptions& options) {
  const machine::Senses in = machine::hauling_in(model, options.prescribed);
  EquilibriumOptions moving = options;
  Array<Flow> first;
  for (const Motion motion : {Motion::in, Motion::out}) {
    moving.motion = motion;
    first.push_back(flow_of(model, moving));
  }
  for (const int sense : {1, -1}) {
    Flow& each = first.emplace_back(in.flow);
    for (Array<int>& rope : each) {
      for (int& node : rope) node *= sense;
    }
  }
  return combined(first, parts_at_rest(model, in));
}

/// The flows of an answer in motion with what creeps drawn and let out. A support that a carriage comes to holds as the
/// rope ran over it before: each side of a carriage for itself, and each rope.
Bounding in_motion(const Flow& flow, const Flow& creep) {
  Array<Together> parts;
  for (std::size_t r = 0; r < creep.size(); ++r) {
    for (const int side : {1, -1}) {
      Together part;
      for (std::size_t n = 0; n < creep[r].size(); ++n) {
        if (creep[r][n] == side) part.emplace_back(static_cast<int>(r), static_cast<int>(n));
      }
      if (!part.empty()) parts.push_back(std::move(part));
    }
  }
  Array<Flow> first;
  for (const auto& [before, after] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    first.push_back(crept(flow, creep, before, after));
  }
  return combined(first, parts);
}

}  // namespace

Array<Array<Array<int>>> flows_at_rest(const machine::Model& model) { return at_rest(model, {}).flows; }

bool differs_in_motion(const machine::Model& model) {
  for (const machine::Reeving& rope : model.reevings) {
    if (rope.mass * rope.speed > 0) return true;
    if (std::any_of(rope.nodes.begin(), rope.nodes.end(), machine::loses)) return true;
  }
  return false;
}

void add_band(const machine::Model& model, const EquilibriumOptions& options, const Array<Array<int>>& creep,
              EquilibriumResult& result) {
  const bool creeps = any_nonzero(creep);
  const bool rests = options.motion == Motion::at_rest && options.flow.empty() && !creeps;
  if (!options.band || (!creeps && !rests) || !differs_in_motion(model)) return;
  result.band = true;
  EquilibriumOptions moving = options;
  moving.creep.clear();
  moving.creep_without_loss = false;
  moving.band = false;
  if (rests) moving.held = true;  // its friction holds it at rest
  const machine::Model held = rests ? with_loads_held(model) : model;
  Bounding bounding = rests ? at_rest(model, options) : in_motion(result.flow, creep);
  result.unbounded = std::move(bounding.left_out);
  for (Flow& flow : bounding.flows) {
    if (flow == result.flow) continue;  // it is the answer
    moving.flow = std::move(flow);
    EquilibriumResult other = equilibrium(held, moving, result.state);
    if (!other.outcome.ok()) {
      result.band = false;
      if (result.unheld.empty()) {
        result.unheld = fmt::format("friction may act in a direction that has no answer: {}", other.outcome.message);
      }
      continue;
    }
    widen(result, other);
    result.bounds.push_back(std::move(other));
  }
}

}  // namespace taut::solve
