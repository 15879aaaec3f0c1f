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
  return {.driving_radius = R,
          .idler_radius = R - L * step,
          .distance = L,
          .wrap = pi + 2 * x,
          .to_scale = x == half_excess};
}

Drawing drive_drawing(const Input& in, const Output& out) {
  const Layout at = layout_of(in);
  const double R = at.driving_radius, r = at.idler_radius, L = at.distance;
  const double normal = pi / 2 - (at.wrap - pi) / 2;  // direction of the upper branch's contact points
  const auto contact = [&](double center, double radius, double sign) {
    return Point{.x = center + radius * std::cos(normal), .y = sign * radius * std::sin(normal)};
  };
  Drawing d{
      .name = "drive",
      .title = "Friction drive",
      .caption =
          at.to_scale
              ? "Driving sheave left, idler right, in proportion to the wrap. Forces on the driving sheave are those "
                "of "
                "the drive that does not slip; W pulls the idler, P_p is the cut."
              : "Driving sheave left, idler right; this wrap needs a deflection sheave and is not drawn to scale. "
                "Forces are those of the drive that does not slip; W pulls the idler, P_p is the cut.",
      .shapes = {},
      .unit = si::m,
      .vertical_scale = 1,
      .legend = {{Role::rope, "saw rope"}}};
  d.shapes.emplace_back(
      Circle{.center = {.x = 0, .y = 0}, .radius = R, .role = Role::body, .from = 0, .to = 0, .filled = false});
  d.shapes.emplace_back(
      Circle{.center = {.x = L, .y = 0}, .radius = r, .role = Role::body, .from = 0, .to = 0, .filled = false});
  d.shapes.emplace_back(Circle{.center = {.x = 0, .y = 0},
                               .radius = R,
                               .role = Role::rope,
                               .from = normal,
                               .to = 2 * pi - normal,
                               .filled = false});
  d.shapes.emplace_back(Circle{
      .center = {.x = L, .y = 0}, .radius = r, .role = Role::rope, .from = -normal, .to = normal, .filled = false});
  const Point slack = contact(0, R, 1), tight = contact(0, R, -1);
  const Point slack_end = contact(L, r, 1), tight_end = contact(L, r, -1);
  d.shapes.emplace_back(Polyline{.points = {slack, slack_end}, .role = Role::rope, .closed = false, .filled = false});
  d.shapes.emplace_back(Polyline{.points = {tight, tight_end}, .role = Role::rope, .closed = false, .filled = false});
  const auto along = [&](Point from, Point to, double force, const char* label, Role role) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    d.shapes.emplace_back(ForceArrow{.at = from,
                                     .fx = force * (to.x - from.x) / length,
                                     .fy = force * (to.y - from.y) / length,
                                     .label = label,
                                     .role = role,
                                     .towards = false});
  };
  along(slack, slack_end, out.T_2_no_slip, "T_2", Role::force);
  along(tight, tight_end, out.T_1_no_slip, "T_1", Role::force);
  // The tight branch runs to the driving sheave; the cut holds it back.
  const Point middle{.x = tight.x + 0.6 * (tight_end.x - tight.x), .y = tight.y + 0.6 * (tight_end.y - tight.y)};
  along(middle, tight_end, in.cutting_force, "P_p", Role::second_force);
  d.shapes.emplace_back(ForceArrow{.at = {.x = L, .y = 0},
                                   .fx = out.takeup_no_slip,
                                   .fy = 0,
                                   .label = "W",
                                   .role = Role::second_force,
                                   .towards = false});
  d.shapes.emplace_back(
      AngleMark{.center = {.x = 0, .y = 0}, .radius = 0.5 * R, .from = normal, .to = 2 * pi - normal, .text = "alpha"});
  d.shapes.emplace_back(Label{.at = {.x = -0.2 * R, .y = 0}, .text = "driving sheave"});
  d.shapes.emplace_back(Label{.at = {.x = L, .y = -0.4 * r}, .text = "idler"});
  if (in.sheave_radius)
    d.shapes.emplace_back(
        DimensionLine{.from = {.x = 0, .y = 0}, .to = {.x = 0, .y = R}, .offset = 0, .text = "R", .with_length = true});
  return d;
}

}  // namespace taut::friction_drive
