#include "taut/machine/without_rope.hpp"

#include <algorithm>

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

}  // namespace taut::machine
