#pragma once
#include <string>

#include "taut/checks/check_state.hpp"

namespace taut::checks {

/// The ends of ropes at a place: calls `take(reeving, pull of all its copies)`, N.
template <class Take>
void each_end_at(const CheckState& state, const std::string& name, Take&& take) {
  for (const CheckBranch& b : state.branches) {
    const machine::Reeving& rope = state.model->reevings[b.reeving];
    if (rope.closed) continue;
    const int last = static_cast<int>(rope.nodes.size()) - 1;
    if (b.from == 0 && rope.nodes.front().name == name) take(rope, Vector3(rope.copies * b.on_start));
    if (b.to == last && rope.nodes.back().name == name) take(rope, Vector3(rope.copies * b.on_end));
  }
}

/// The same of all that pulls there: ends, and rope over a round of that name.
template <class Take>
void each_pull_at(const CheckState& state, const std::string& name, Take&& take) {
  each_end_at(state, name, take);
  for (const CheckContact& c : state.contacts) {
    const machine::Reeving& rope = state.model->reevings[c.reeving];
    if (rope.nodes[c.node].name == name) take(rope, Vector3(rope.copies * c.force));
  }
}

}  // namespace taut::checks
