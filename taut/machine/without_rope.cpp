#include "taut/machine/without_rope.hpp"

#include <algorithm>
#include <utility>

#include "taut/base/array.hpp"

namespace taut::machine {

std::optional<Model> without_rope(Model model, int reeving) {
  const auto needs = [&](const Carriage& car) {
    return car.reeving == reeving || (car.grip && car.grip->reeving == reeving);
  };
  if (std::any_of(model.carriages.begin(), model.carriages.end(), needs)) return std::nullopt;
  model.reevings.erase(model.reevings.begin() + reeving);
  const auto renumber = [&](int& rope) {
    if (rope > reeving) --rope;
  };
  for (Carriage& car : model.carriages) {
    renumber(car.reeving);
    if (car.grip) renumber(car.grip->reeving);
    for (std::optional<int>* rope : {&car.mainline, &car.haulback}) {
      if (*rope == reeving) rope->reset();
      if (*rope) renumber(**rope);
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
