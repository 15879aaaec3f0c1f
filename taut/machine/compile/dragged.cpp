#include "taut/machine/compile/dragged.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::machine {

Vector3 force_of(const description::Dragged& bunch, double mass, double gravity) {
  expects(bunch.along.size() == 2, "a horizontal direction has two components");
  const double alpha = bunch.ground_angle, delta = bunch.lift_angle, mu = bunch.friction;
  const Vector3 way = Vector3(bunch.along[0], bunch.along[1], 0).normalized();
  const Vector3 t = std::cos(alpha) * way + std::sin(alpha) * up();
  const Vector3 n = std::cos(alpha) * up() - std::sin(alpha) * way;
  const double weight = mass * gravity;
  // a bar that is lifted past the upright no longer lies on its rear end
  const double N =
      std::max(0.0, weight * (1 - bunch.share) * std::cos(alpha + delta) / (std::cos(delta) + mu * std::sin(delta)));
  return -weight * up() + N * (n - mu * t);
}

}  // namespace taut::machine
