#include "taut/solve/band.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/senses.hpp"
#include "taut/solve/running.hpp"

namespace taut::solve {
namespace {

void widen(double& low, double& high, double other_low, double other_high) {
  low = std::min(low, other_low);
  high = std::max(high, other_high);
}

void widen(EquilibriumResult& result, const EquilibriumResult& other) {
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
  for (std::size_t r = 0; r < result.ropes.size(); ++r) {
    RopeResult& rope = result.ropes[r];
    if (other.ropes[r].T_max <= rope.T_max) continue;
    const double unstretched = rope.unstretched;
    rope = other.ropes[r];
    rope.unstretched = unstretched;
  }
}

bool at_rest(const EquilibriumOptions& options) { return options.motion == Motion::at_rest && options.flow.empty(); }

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

/// The motions that bound what is at rest: both of the machine as a whole, and both of each rope to its own winch where
/// a carriage's mainline draws another one.
Array<EquilibriumOptions> motions_at_rest(const machine::Model& model, const EquilibriumOptions& options) {
  EquilibriumOptions moving = options;
  moving.held = true;  // its friction holds it at rest
  moving.creep.clear();
  for (const machine::Reeving& rope : model.reevings) moving.creep.emplace_back(rope.nodes.size(), 0);
  const Array<bool> follows = machine::hauling_in(model, options.prescribed).follows;
  const bool draws = std::any_of(follows.begin(), follows.end(), [](bool one) { return one; });
  Array<EquilibriumOptions> all;
  for (const bool each_to_its_winch : {false, true}) {
    if (each_to_its_winch && !draws) break;
    moving.each_to_its_winch = each_to_its_winch;
    for (const Motion motion : {Motion::in, Motion::out}) {
      moving.motion = motion;
      all.push_back(moving);
    }
  }
  return all;
}

}  // namespace

bool differs_in_motion(const machine::Model& model) {
  for (const machine::Reeving& rope : model.reevings) {
    if (rope.mass * rope.speed > 0) return true;
    for (const machine::Node& node : rope.nodes) {
      if (node.kind == machine::NodeKind::contact && node.law.efficiency < 1 && node.law.friction > 0) return true;
    }
  }
  return false;
}

void add_band(const machine::Model& model, const EquilibriumOptions& options, EquilibriumResult& result) {
  const Array<Array<int>> creep = creep_of(model, options);
  const bool creeps = any_nonzero(creep);
  if (!options.band || (!creeps && !at_rest(options)) || !differs_in_motion(model)) return;
  result.band = true;
  const auto take = [&](const machine::Model& moved, const EquilibriumOptions& moving) {
    EquilibriumResult other = equilibrium(moved, moving, result.state);
    const bool same = other.outcome.ok() && other.branches.size() == result.branches.size() &&
                      other.contacts.size() == result.contacts.size();
    if (!same) {
      result.band = false;
      result.unbounded = other.outcome.ok() ? "it touches other supports there" : other.outcome.message;
      return;
    }
    if (result.unbounded.empty()) result.unbounded = other.unbounded;
    result.band = result.band && other.unbounded.empty();
    widen(result, other);
    std::move(other.bounds.begin(), other.bounds.end(), std::back_inserter(result.bounds));
    other.bounds.clear();
    result.bounds.push_back(std::move(other));
  };
  if (!creeps) {
    const machine::Model held = with_loads_held(model);
    for (const EquilibriumOptions& moving : motions_at_rest(model, options)) take(held, moving);
    return;
  }
  EquilibriumOptions moving = options;
  moving.creep.clear();
  moving.creep_without_loss = false;
  moving.band = false;
  // a support that the carriage comes to holds as the rope ran over it before: each side for itself
  for (const auto& [before, after] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    moving.flow = crept(result.flow, creep, before, after);
    if (moving.flow != result.flow) take(model, moving);  // else it is the answer
  }
}

}  // namespace taut::solve
