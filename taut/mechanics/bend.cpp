#include "taut/mechanics/bend.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::mechanics {

using std::numbers::pi;

namespace {

/// Between the directions, in [0, pi]; without derivatives where they are equal.
Angle between(const Vector3& in, const Vector3& out) {
  Vector3 n = in.cross(out);
  const double size = n.norm();
  Angle angle{.value = std::atan2(size, in.dot(out))};
  if (size == 0) return angle;
  n /= size;
  angle.by_in = -n.cross(in);
  angle.by_out = n.cross(out);
  return angle;
}

}  // namespace

Angle turning(const Vector3& n, const Vector3& in, const Vector3& out, const Angle& wrap) {
  if (wrap.value > 0) {
    const Angle in_space = between(in, out);
    return in_space.value > wrap.value ? in_space : wrap;
  }
  const double aside_in = std::asin(std::clamp(n.dot(in), -1.0, 1.0)),
               aside_out = std::asin(std::clamp(n.dot(out), -1.0, 1.0));
  const double sense = aside_out > aside_in ? 1 : aside_out < aside_in ? -1 : 0;
  return {.value = std::abs(aside_out - aside_in),
          .by_in = -sense / std::cos(aside_in) * n,
          .by_out = sense / std::cos(aside_out) * n};
}

Bend bend(const machine::Node& node, const BranchEnd& end, const Vector3& in, const Vector3& out) {
  Bend b;
  if (end.radius != 0) {
    const Vector3 n = end.radius > 0 ? end.axis : Vector3(-end.axis);
    const Vector3 a = in - n * n.dot(in), c = out - n * n.dot(out);
    b.wrap.value = std::atan2(n.dot(a.cross(c)), a.dot(c));
    if (b.wrap.value < -pi / 2) b.wrap.value += 2 * pi;
    b.wrap.value += 2 * pi * node.turns;
    b.wrap.by_in = -n.cross(a) / a.squaredNorm();
    b.wrap.by_out = n.cross(c) / c.squaredNorm();
    b.turning = turning(n, in, out, b.wrap);
    return b;
  }
  b.wrap = between(in, out);
  if ((out - in).dot(node.support) <= 0) {
    b.turning = b.wrap;
    return b;
  }
  b.wrap = {.value = -b.wrap.value, .by_in = -b.wrap.by_in, .by_out = -b.wrap.by_out};
  return b;
}

Loss loss(const machine::ContactLaw& law, const Bend& bend) {
  const double bearing = -std::log(law.efficiency);
  if (std::isinf(law.friction)) {
    expects(std::isfinite(bearing), "a contact either turns or slips");
    return {.log = bearing, .by_turning = 0};
  }
  if (bend.turning.value <= 0) return {};
  const double grip = law.friction * bend.turning.value;
  return grip < bearing ? Loss{.log = grip, .by_turning = law.friction} : Loss{.log = bearing, .by_turning = 0};
}

double bearing_share(const machine::ContactLaw& law) { return (1 - law.efficiency) / (1 + law.efficiency); }

}  // namespace taut::mechanics
