#include "taut/study/line/carriage_way.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/line/terrain_tops.hpp"

namespace taut::study {
namespace {

/// Where a node stands whatever the load: on the ground, on a body that is held, on a mast but for what it bends.
std::optional<Vector3> stays_at(const machine::Model& model, const machine::Node& node) {
  if (node.at.body == machine::ground) return node.at.at;
  const machine::Body& body = model.bodies[node.at.body];
  if (!body.free.empty() && !body.beam) return std::nullopt;
  return Vector3(body.position + body.orientation * node.at.at);
}

}  // namespace

const machine::Node* support_at(const machine::Model& model, int carriage, double x, const Vector3& along) {
  const machine::Carriage& car = model.carriages[carriage];
  for (const machine::Node& node : model.reevings[car.reeving].nodes) {
    const auto place = stays_at(model, node);
    if (place && std::abs(place->dot(along) - x) <= std::max(node.radius, 1e-6)) return &node;
  }
  return machine::guide_at(model, carriage, x, along);
}

Array<WayPart> parts_of(const machine::Model& model, const Way& way) {
  const auto same_span = [&](const machine::Model& a, const machine::Model& b) {
    return a.carriages[way.carriage].node == b.carriages[way.carriage].node && machine::same_guides(a, b);
  };
  Array<WayPart> parts;
  for (int i = 0; i <= way.steps; i = parts.back().last + 1) {
    WayPart part{.model = machine::with_carriage_at(model, way.carriage, way.x(i), way.along),
                 .first = i,
                 .last = i,
                 .support = support_at(model, way.carriage, way.x(i), way.along)};
    while (part.support == nullptr && part.last < way.steps &&
           support_at(model, way.carriage, way.x(part.last + 1), way.along) == nullptr &&
           same_span(machine::with_carriage_at(model, way.carriage, way.x(part.last + 1), way.along), part.model)) {
      ++part.last;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

LoadPathOptions path_over(const Way& way, const WayPart& part) {
  LoadPathOptions options;
  options.carriage = way.carriage;
  options.from = way.x(part.first);
  options.to = way.x(part.last);
  options.along = way.along;
  options.steps = std::max(1, part.last - part.first);
  return options;
}

void look_over_tops(const machine::Model& model, const Way& way, const WayPlace& from, const WayPlace& to,
                    const std::function<WayPlace(machine::Model, double x)>& look) {
  TopsBetween tops(model, from, to);
  while (const auto x = tops.next()) {
    if (support_at(model, way.carriage, *x, way.along) != nullptr) continue;
    tops.take(look(machine::with_carriage_at(model, way.carriage, *x, way.along), *x));
  }
}

Way way_of(std::optional<int> carriage, const std::vector<double>& along, const std::string& path, Names& names) {
  Way way;
  way.carriage = carriage.value_or(0);
  check_hold(names.model, carriage, names.complaints);
  way.along = direction_of(along, path + ".along", names.complaints);
  return way;
}

Vector3 direction_of(const Array<double>& along, const DeckPlace& path, std::vector<Complaint>& complaints) {
  if (along.size() == 2 && std::hypot(along[0], along[1]) > 0) return Vector3(along[0], along[1], 0).normalized();
  complaints.push_back({path.text(), "a horizontal direction [x, y] is expected, not zero"});
  return Vector3::UnitX();
}

void check_hold(const machine::Model& model, std::optional<int> carriage, std::vector<Complaint>& complaints) {
  if (!carriage) return;
  const machine::Carriage& car = model.carriages[*carriage];
  const auto rope = [&](int i) -> const machine::Reeving& { return model.reevings[i]; };
  const auto by_length = [&](std::optional<int> i) { return i && rope(*i).given == machine::Given::length; };
  if (!by_length(car.mainline) || !by_length(car.haulback) || car.grip) return;
  const std::string at = fmt::format("machine.carriages.{}.haulback", car.name);
  if (std::any_of(complaints.begin(), complaints.end(), [&](const auto& c) { return c.path == at; })) return;
  complaints.push_back(
      {at, fmt::format("an analysis puts '{}' somewhere: then give the pull of '{}' or of '{}', not the "
                       "lengths of both",
                       car.name, rope(*car.haulback).name, rope(*car.mainline).name)});
}

}  // namespace taut::study
