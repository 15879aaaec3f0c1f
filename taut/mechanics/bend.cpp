#include "taut/mechanics/bend.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::mechanics {

using std::numbers::pi;

Bend bend(const machine::Node& node, const BranchEnd& end, const Vector3& in, const Vector3& out) {
  Bend b;
  if (end.radius != 0) {
    const Vector3 n = end.radius > 0 ? end.axis : Vector3(-end.axis);
    const Vector3 a = in - n * n.dot(in), c = out - n * n.dot(out);
    b.wrap = std::atan2(n.dot(a.cross(c)), a.dot(c));
    if (b.wrap < -pi / 2) b.wrap += 2 * pi;
    b.wrap += 2 * pi * node.turns;
    b.by_in = -n.cross(a) / a.squaredNorm();
    b.by_out = n.cross(c) / c.squaredNorm();
    return b;
  }
  Vector3 n = in.cross(out);
  const double size = n.norm();
  b.wrap = std::atan2(size, in.dot(out));
  if (size == 0) return b;
  n /= size;
  if ((out - in).dot(node.support) > 0) {
    n = -n;
    b.wrap = -b.wrap;
  }
  b.by_in = -n.cross(in);
  b.by_out = n.cross(out);
  return b;
}

Loss loss(const machine::ContactLaw& law, double wrap) {
  const double bearing = -std::log(law.efficiency);
  if (std::isinf(law.friction)) {
    expects(std::isfinite(bearing), "a contact either turns or slips");
    return {.log = bearing, .by_wrap = 0};
  }
  if (wrap <= 0) return {};
  const double grip = law.friction * wrap;
  return grip < bearing ? Loss{.log = grip, .by_wrap = law.friction} : Loss{.log = bearing, .by_wrap = 0};
}

double bearing_share(const machine::ContactLaw& law) { return (1 - law.efficiency) / (1 + law.efficiency); }

}  // namespace taut::mechanics
