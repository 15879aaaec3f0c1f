#include "taut/machine/without_rope.hpp"

#include <algorithm>
#include <utility>

#include "taut/base/array.hpp"

namespace taut::machine {

std::optional<Model> without_rope(Model model, int reeving) {
  const auto needs = [&](const Carriage& car) { return car.reeving == reeving || car.grip_reeving == reeving; };
  if (std::any_of(model.carriages.begin(), model.carriages.end(), needs)) return std::nullopt;
  model.reevings.erase(model.reevings.begin() + reeving);
  for (Carriage& car : model.carriages) {
    for (int* rope : {&car.reeving, &car.grip_reeving, &car.mainline, &car.haulback}) {
      if (*rope == reeving) *rope = -1;
      if (*rope > reeving) --*rope;
    }
  }
  model.tensioners.clear();
  model.events.clear();
  model.observed.clear();
  model.measures.clear();
  model.mean_windows.clear();
  return model;
}

State with_rope(State state, const Reeving& rope, int reeving, double tension) {
  Array<BranchState> own(rope.nodes.size() - 1);
  for (std::size_t k = 0; k < own.size(); ++k) {
    const Node &from = rope.nodes[k], &to = rope.nodes[k + 1];
    own[k].length = tension > 0 ? taut_length(state, rope, from, to, tension) : straight_length(state, from, to);
  }
  state.branches.insert(state.branches.begin() + reeving, std::move(own));
  state.touched.insert(state.touched.begin() + reeving, Array<bool>(rope.nodes.size(), true));
  return state;
}

}  // namespace taut::machine
