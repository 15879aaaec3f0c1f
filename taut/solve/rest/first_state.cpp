#include "taut/solve/rest/first_state.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/math/index.hpp"

namespace taut::solve {
namespace {

constexpr double pull_of_weight = 0.2;  ///< a mainline's first tension, of the carriage's weight

/// The prescribed place on the straight line between the carriage's neighbours; none where they are not fixed, or
/// beside it.
std::optional<Vector3> on_line(const machine::Model& model, const machine::Carriage& carriage,
                               const machine::Prescribed& prescribed) {
  const machine::Reeving& rope = model.reevings[carriage.reeving];
  if (rope.closed || carriage.node < 1 || as_size(carriage.node) + 1 >= rope.nodes.size()) return std::nullopt;
  const machine::Node &before = rope.nodes[carriage.node - 1], &after = rope.nodes[carriage.node + 1];
  if (before.at.body != machine::ground || after.at.body != machine::ground) return std::nullopt;
  const Vector3 &from = before.at.at, &to = after.at.at;
  const Vector3& along = prescribed.along;
  const double part = (prescribed.x - along.dot(from)) / along.dot(to - from);
  if (!(part > 0 && part < 1)) return std::nullopt;
  return Vector3(from + part * (to - from));
}

/// The body moved to `place` as far as it is free.
void move_to(const Vector3& place, machine::Body& body) {
  for (int i = 0; i < 3; ++i) {
    const bool free =
        std::any_of(body.free.begin(), body.free.end(), [&](const machine::Freedom& way) { return way.along[i] != 0; });
    if (free) body.position[i] = place[i];
  }
}

/// Where it is put: a given height counts before the line between its neighbours.
std::optional<Vector3> first_place(const machine::Model& model, const machine::Carriage& carriage,
                                   const machine::Prescribed& prescribed) {
  const Vector3& described = model.bodies[carriage.body].position;
  const double ahead = prescribed.x - prescribed.along.dot(described);
  if (ahead == 0 && !prescribed.z) return std::nullopt;
  std::optional<Vector3> place = on_line(model, carriage, prescribed);
  if (!prescribed.z) return place;
  if (!place) place = described + ahead * prescribed.along;
  place->z() = *prescribed.z;
  return place;
}

/// The rope whose length follows from the height of its carriage begins without sag under the tension of two straight
/// branches that bear the load: on the side of its taut root, far from a loop so deep that it weighs as much.
void draw_to_height(const machine::Model& model, const machine::Carriage& carriage, machine::State& state) {
  const machine::Reeving& rope = model.reevings[carriage.reeving];
  const std::size_t count = rope.nodes.size(), first = as_size(carriage.node);
  const auto place = [&](std::size_t node) { return machine::in_ground(state, rope.nodes[node % count].at); };
  const std::size_t last = first + as_size(carriage.rollers) - 1;
  const double rises =
      (place(first + count - 1) - place(first)).normalized().z() + (place(last + 1) - place(last)).normalized().z();
  const double load = machine::weight_on(model, carriage.body) / rope.copies;
  const double T = rises > 0 ? load / rises : load;
  auto& branches = state.branches[carriage.reeving];
  for (std::size_t k = 0; k < branches.size(); ++k) {
    branches[k] = {};
    branches[k].length = machine::taut_length(state, rope, rope.nodes[k], rope.nodes[(k + 1) % count], T);
  }
}

}  // namespace

machine::State first_state(const machine::Model& model, const EquilibriumOptions& options) {
  if (!options.prescribed) return machine::initial_state(model);
  const machine::Carriage& carriage = model.carriages.at(as_size(options.prescribed->carriage));
  const machine::Prescribed& prescribed = *options.prescribed;
  const auto place = first_place(model, carriage, prescribed);
  if (!place && !carriage.mainline) return machine::initial_state(model);
  machine::Model there = model;
  if (place) move_to(*place, there.bodies[carriage.body]);
  machine::State state = machine::initial_state(there);
  if (prescribed.z) draw_to_height(there, carriage, state);
  if (!carriage.mainline) return state;
  const machine::Reeving& mainline = there.reevings[*carriage.mainline];
  const double weight = machine::weight_on(there, carriage.body);
  auto& branches = state.branches[*carriage.mainline];
  for (std::size_t k = 0; k < branches.size(); ++k) {
    const double straight =
        machine::straight_length(state, mainline.nodes[k], mainline.nodes[(k + 1) % mainline.nodes.size()]);
    const double own = mainline.weight * straight, T = pull_of_weight * weight + 2 * own;
    const double sag = T > 0 ? own / T : 0;
    branches[k].length = straight * (1 + sag * sag / 24) / (1 + T / mainline.stiffness);
  }
  return state;
}

}  // namespace taut::solve
