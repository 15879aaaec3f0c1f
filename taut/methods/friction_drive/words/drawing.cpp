#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/methods/friction_drive/figures.hpp"

namespace taut::friction_drive {
namespace {

constexpr double pi = std::numbers::pi;

/// Where the free branches leave the driving sheave and arrive at the idler.
struct Branches {
  Point slack, slack_end, tight, tight_end;
};

/// Direction of the upper branch's contact points.
double normal_of(const Layout& at) { return pi / 2 - (at.wrap - pi) / 2; }

Branches branches_of(const Layout& at) {
  const double normal = normal_of(at);
  const auto contact = [&](double center, double radius, double sign) {
    return Point{.x = center + radius * std::cos(normal), .y = sign * radius * std::sin(normal)};
  };
  return {.slack = contact(0, at.driving_radius, 1),
          .slack_end = contact(at.distance, at.idler_radius, 1),
          .tight = contact(0, at.driving_radius, -1),
          .tight_end = contact(at.distance, at.idler_radius, -1)};
}

void draw_force_along(Drawing& d, const Point& from, const Point& to, double force, const char* label, Role role) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  d.shapes.emplace_back(ForceArrow{.at = from,
                                   .fx = force * (to.x - from.x) / length,
                                   .fy = force * (to.y - from.y) / length,
                                   .label = label,
                                   .role = role,
                                   .towards = false});
}

std::string layout_words(const Layout& at) {
  return at.to_scale
             ? "Driving sheave left, idler right, in proportion to the wrap."
             : "Driving sheave left, idler right; this wrap needs a deflection sheave and is not drawn to scale.";
}

/// Sheaves, rope and the force of the cut, which are given.
void draw_given(const Input& in, Drawing& d) {
  const Layout at = layout_of(in);
  const double R = at.driving_radius, r = at.idler_radius, L = at.distance, normal = normal_of(at);
  d.name = "drive";
  d.legend = {{Role::rope, "saw rope"}};
  const auto circle = [&](double x, double radius, Role role, double from, double to) {
    d.shapes.emplace_back(
        Circle{.center = {.x = x, .y = 0}, .radius = radius, .role = role, .from = from, .to = to, .filled = false});
  };
  circle(0, R, Role::body, 0, 0);
  circle(L, r, Role::body, 0, 0);
  circle(0, R, Role::rope, normal, 2 * pi - normal);
  circle(L, r, Role::rope, -normal, normal);
  const auto [slack, slack_end, tight, tight_end] = branches_of(at);
  d.shapes.emplace_back(Polyline{.points = {slack, slack_end}, .role = Role::rope, .closed = false, .filled = false});
  d.shapes.emplace_back(Polyline{.points = {tight, tight_end}, .role = Role::rope, .closed = false, .filled = false});
  // The tight branch runs to the driving sheave; the cut holds it back.
  const Point middle{.x = tight.x + 0.6 * (tight_end.x - tight.x), .y = tight.y + 0.6 * (tight_end.y - tight.y)};
  draw_force_along(d, middle, tight_end, in.cutting_force, "P_p", Role::second_force);
  d.shapes.emplace_back(
      AngleMark{.center = {.x = 0, .y = 0}, .radius = 0.5 * R, .from = normal, .to = 2 * pi - normal, .text = "alpha"});
  d.shapes.emplace_back(Label{.at = {.x = -0.2 * R, .y = 0}, .text = "driving sheave"});
  d.shapes.emplace_back(Label{.at = {.x = L, .y = -0.4 * r}, .text = "idler"});
  if (in.sheave_radius)
    d.shapes.emplace_back(
        DimensionLine{.from = {.x = 0, .y = 0}, .to = {.x = 0, .y = R}, .offset = 0, .text = "R", .with_length = true});
}

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
  Drawing d;
  d.title = "Friction drive";
  d.caption = layout_words(at) +
              " Forces on the driving sheave are those of the drive that does not slip; W pulls the idler, P_p is the "
              "cut.";
  draw_given(in, d);
  const auto [slack, slack_end, tight, tight_end] = branches_of(at);
  draw_force_along(d, slack, slack_end, out.T_2_no_slip, "T_2", Role::force);
  draw_force_along(d, tight, tight_end, out.T_1_no_slip, "T_1", Role::force);
  d.shapes.emplace_back(ForceArrow{.at = {.x = at.distance, .y = 0},
                                   .fx = out.takeup_no_slip,
                                   .fy = 0,
                                   .label = "W",
                                   .role = Role::second_force,
                                   .towards = false});
  return d;
}

Drawing drive_without_answer(const Input& in) {
  Drawing d;
  d.title = "Drive as described; no answer was found";
  d.caption = layout_words(layout_of(in)) + " This is not an answer: no tension is known. P_p is the cut.";
  draw_given(in, d);
  d.legend.emplace_back(Role::second_force, "force of the cut");
  return d;
}

}  // namespace taut::friction_drive
