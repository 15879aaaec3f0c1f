#include "taut/solve/band.hpp"

#include <algorithm>

#include "taut/solve/running.hpp"

namespace taut::solve {
namespace {

void widen(double& low, double& high, double T) {
  low = std::min(low, T);
  high = std::max(high, T);
}

void widen(EquilibriumResult& result, const EquilibriumResult& other) {
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    BranchResult& branch = result.branches[k];
    widen(branch.T_from_min, branch.T_from_max, other.branches[k].T_from);
    widen(branch.T_to_min, branch.T_to_max, other.branches[k].T_to);
  }
  for (std::size_t k = 0; k < result.contacts.size(); ++k) {
    ContactResult& contact = result.contacts[k];
    widen(contact.T_in_min, contact.T_in_max, other.contacts[k].T_in);
    widen(contact.T_out_min, contact.T_out_max, other.contacts[k].T_out);
  }
  for (std::size_t r = 0; r < result.ropes.size(); ++r) {
    RopeResult& rope = result.ropes[r];
    if (other.ropes[r].T_max <= rope.T_max) continue;
    const double unstretched = rope.unstretched;
    rope = other.ropes[r];
    rope.unstretched = unstretched;
  }
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
  const machine::Model held = with_loads_held(model);
  result.band = true;
  for (const Motion motion : {Motion::in, Motion::out}) {
    EquilibriumOptions moving = options;
    moving.motion = motion;
    moving.held = true;  // its friction holds it at rest
    const EquilibriumResult other = equilibrium(held, moving, result.state);
    if (other.outcome.ok() && other.branches.size() == result.branches.size()) {
      widen(result, other);
    } else {
      result.band = false;
    }
  }
}

}  // namespace taut::solve
