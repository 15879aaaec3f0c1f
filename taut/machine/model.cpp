#include "taut/machine/model.hpp"

namespace taut::machine {

double terrain_x(const Model& model, const Vector3& place) {
  return model.terrain_along.dot(place - model.terrain_from);
}

int branch_count(const Reeving& reeving) {
  const auto nodes = static_cast<int>(reeving.nodes.size());
  return reeving.closed ? nodes : nodes - 1;
}

}  // namespace taut::machine
