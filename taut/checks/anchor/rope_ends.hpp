#pragma once
#include <algorithm>
#include <string>

#include "taut/checks/check_state.hpp"

namespace taut::checks {

/// A rope that pulls at a place.
struct RopePull {
  const machine::Reeving& rope;
  Vector3 force = Vector3::Zero();  ///< of all its copies, N
  double tension = 0;               ///< of one copy, the larger one of both sides of a round, N
};

/// The ends of ropes at a place: calls `take(RopePull)`.
template <class Take>
void each_end_at(const CheckState& state, const std::string& name, Take&& take) {
  for (const CheckBranch& b : state.branches) {
    const machine::Reeving& rope = state.model->reevings[b.reeving];
    if (rope.closed) continue;
    const int last = static_cast<int>(rope.nodes.size()) - 1;
    if (b.from == 0 && rope.nodes.front().name == name)
      take(RopePull{rope, rope.copies * b.on_start, b.on_start.norm()});
    if (b.to == last && rope.nodes.back().name == name) take(RopePull{rope, rope.copies * b.on_end, b.on_end.norm()});
  }
}

/// The same of all that pulls there: ends, and rope over a round of that name.
template <class Take>
void each_pull_at(const CheckState& state, const std::string& name, Take&& take) {
  each_end_at(state, name, take);
  for (const CheckContact& c : state.contacts) {
    const machine::Reeving& rope = state.model->reevings[c.reeving];
    if (rope.nodes[c.node].name != name) continue;
    double tension = 0;
    for (const CheckBranch& b : state.branches) {
      if (b.reeving != c.reeving) continue;
      if (b.from == c.node) tension = std::max(tension, b.on_start.norm());
      if (b.to == c.node) tension = std::max(tension, b.on_end.norm());
    }
    take(RopePull{rope, rope.copies * c.force, tension});
  }
}

}  // namespace taut::checks
