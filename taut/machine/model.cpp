#include "taut/machine/model.hpp"

#include <algorithm>

namespace taut::machine {

double weight_on(const Model& model, int body) {
  double weight = model.bodies[body].mass * model.gravity;
  for (const Load& load : model.loads) weight += load.at.body == body ? load.force.norm() : 0;
  return weight;
}

double terrain_x(const Model& model, const Vector3& place) {
  return model.terrain_along.dot(place - model.terrain_from);
}

int branch_count(const Reeving& reeving) {
  const auto nodes = static_cast<int>(reeving.nodes.size());
  return reeving.closed ? nodes : nodes - 1;
}

bool rides(const Model& model, const Node& node) {
  return std::any_of(model.carriages.begin(), model.carriages.end(),
                     [&](const Carriage& car) { return car.body == node.at.body; });
}

}  // namespace taut::machine
