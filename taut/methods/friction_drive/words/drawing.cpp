#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/methods/friction_drive/figures.hpp"

namespace taut::friction_drive {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

Layout layout_of(const Input& in) {
  const double R = in.sheave_radius.value_or(0.3);
  // An open rope wraps the driving sheave by pi + 2 asin((R - r)/L).
  const double half_excess = (in.wrap - pi) / 2;
  const double least = -0.33, most = 0.46;
  const double x = std::clamp(half_excess, least, most);
  const double step = std::sin(x);
  double L = 4 * R;
  if (step > 0) L = std::min(L, std::max(0.6 * R / step, 1.5 * R));
  if (step < 0) L = std::min(L, std::max(-R / step, 3.1 * R));
  return {R, R - L * step, L, pi + 2 * x, x == half_excess};
}

Drawing drive_drawing(const Input& in, const Output& out) {
  const Layout at = layout_of(in);
  const double R = at.driving_radius, r = at.idler_radius, L = at.distance;
  const double normal = pi / 2 - (at.wrap - pi) / 2;  // direction of the upper branch's contact points
  const auto contact = [&](double center, double radius, double sign) {
    return Point{center + radius * std::cos(normal), sign * radius * std::sin(normal)};
  };
  Drawing d{
      "drive",
      "Friction drive",
      at.to_scale
          ? "Driving sheave left, idler right, in proportion to the wrap. Forces on the driving sheave are those of "
            "the drive that does not slip; W pulls the idler, P_p is the cut."
          : "Driving sheave left, idler right; this wrap needs a deflection sheave and is not drawn to scale. "
            "Forces are those of the drive that does not slip; W pulls the idler, P_p is the cut.",
      {},
      si::m,
      1,
      {{Role::rope, "saw rope"}}};
  d.shapes.emplace_back(Circle{{0, 0}, R, Role::body, 0, 0, false});
  d.shapes.emplace_back(Circle{{L, 0}, r, Role::body, 0, 0, false});
  d.shapes.emplace_back(Circle{{0, 0}, R, Role::rope, normal, 2 * pi - normal, false});
  d.shapes.emplace_back(Circle{{L, 0}, r, Role::rope, -normal, normal, false});
  const Point slack = contact(0, R, 1), tight = contact(0, R, -1);
  const Point slack_end = contact(L, r, 1), tight_end = contact(L, r, -1);
  d.shapes.emplace_back(Polyline{{slack, slack_end}, Role::rope, false, false});
  d.shapes.emplace_back(Polyline{{tight, tight_end}, Role::rope, false, false});
  const auto along = [&](Point from, Point to, double force, const char* label, Role role) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    d.shapes.emplace_back(
        ForceArrow{from, force * (to.x - from.x) / length, force * (to.y - from.y) / length, label, role, false});
  };
  along(slack, slack_end, out.T_2_no_slip, "T_2", Role::force);
  along(tight, tight_end, out.T_1_no_slip, "T_1", Role::force);
  // The tight branch runs to the driving sheave; the cut holds it back.
  const Point middle{tight.x + 0.6 * (tight_end.x - tight.x), tight.y + 0.6 * (tight_end.y - tight.y)};
  along(middle, tight_end, in.cutting_force, "P_p", Role::second_force);
  d.shapes.emplace_back(ForceArrow{{L, 0}, out.takeup_no_slip, 0, "W", Role::second_force, false});
  d.shapes.emplace_back(AngleMark{{0, 0}, 0.5 * R, normal, 2 * pi - normal, "alpha"});
  d.shapes.emplace_back(Label{{-0.2 * R, 0}, "driving sheave"});
  d.shapes.emplace_back(Label{{L, -0.4 * r}, "idler"});
  if (in.sheave_radius) d.shapes.emplace_back(DimensionLine{{0, 0}, {0, R}, 0, "R"});
  return d;
}

}  // namespace taut::friction_drive
