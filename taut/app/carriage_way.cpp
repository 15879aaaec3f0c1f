#include "taut/app/carriage_way.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/model/carriage_span.hpp"

namespace taut::app {

const model::Node* support_at(const model::Model& model, int carriage, double x) {
  const model::Carriage& car = model.carriages[static_cast<std::size_t>(carriage)];
  for (const model::Node& node : model.reevings[static_cast<std::size_t>(car.reeving)].nodes) {
    if (node.at.body == model::ground && std::abs(node.at.at.x() - x) <= std::max(node.radius, 1e-6)) return &node;
  }
  return nullptr;
}

std::vector<WayPart> parts_of(const model::Model& model, const Way& way) {
  const auto node = [&](const model::Model& m) { return m.carriages[static_cast<std::size_t>(way.carriage)].node; };
  std::vector<WayPart> parts;
  for (int i = 0; i <= way.steps; i = parts.back().last + 1) {
    WayPart part{model::with_carriage_at(model, way.carriage, way.x(i)), i, i,
                 support_at(model, way.carriage, way.x(i))};
    while (part.support == nullptr && part.last < way.steps &&
           support_at(model, way.carriage, way.x(part.last + 1)) == nullptr &&
           node(model::with_carriage_at(model, way.carriage, way.x(part.last + 1))) == node(part.model)) {
      ++part.last;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace taut::app
