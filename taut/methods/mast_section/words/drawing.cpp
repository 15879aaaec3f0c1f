#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/methods/mast_section/figures.hpp"

namespace taut::mast_section {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

Polyline box(double left, double bottom, double right, double top, Role role) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, role, true, true};
}

/// Length of the span side that stays in the picture: down to the ground, or a share of the mast's height.
double drawn_length(double height, double block, double alpha) {
  const double most = 0.9 * height;
  return std::sin(alpha) > 0 ? std::min(most, 0.95 * block / std::sin(alpha)) : most;
}

/// One rope: up from the drum, over the block, out into the span.
void add_rope(std::vector<Shape>& shapes, double block, double radius, double length, double alpha, Role role) {
  const Point leaves{radius * std::sin(alpha), block + radius * std::cos(alpha)};
  shapes.emplace_back(Circle{{0, block}, radius, Role::body, 0, 0, false});
  shapes.emplace_back(Polyline{{{-radius, 0}, {-radius, block}}, role, false, false});
  shapes.emplace_back(Circle{{0, block}, radius, role, right_angle - alpha, 2 * right_angle, false});
  shapes.emplace_back(Polyline{
      {leaves, {leaves.x + length * std::cos(alpha), leaves.y - length * std::sin(alpha)}}, role, false, false});
}

void add_clamp(std::vector<Shape>& shapes, double width, double height, const Output& out) {
  shapes.emplace_back(Polyline{{{-0.35 * height, 0}, {0.9 * height, 0}}, Role::ground, false, false});
  shapes.emplace_back(box(-2 * width, -0.04 * height, 2 * width, 0, Role::ground));
  shapes.emplace_back(ForceArrow{{0, -0.04 * height}, 0, out.N, "N", Role::second_force, true});
  shapes.emplace_back(ForceArrow{{-2 * width, -0.02 * height}, -out.Q, 0, "Q", Role::second_force, false});
  // The clamp holds the head back: its moment turns away from the span.
  shapes.emplace_back(
      Circle{{0, 0}, 3 * width, Role::second_force, 0.2 * std::numbers::pi, 0.8 * std::numbers::pi, false});
  shapes.emplace_back(Label{{2.6 * width, 2.2 * width}, "M"});
}

/// Forces on the head. Blocks at one height get one resultant, since both point the same way.
void add_forces(std::vector<Shape>& shapes, const Input& in, const Output& out) {
  const double sky = in.skyline_block_height, main = mainline_height(in);
  const auto arrow = [&](double at, double R, double gamma, const char* label) {
    shapes.emplace_back(
        ForceArrow{{0, at}, R * std::cos(gamma), -R * std::sin(gamma), label, Role::second_force, false});
  };
  const double F = out.F_span_sky;
  shapes.emplace_back(
      ForceArrow{{0, sky}, F * std::cos(out.alpha), -F * std::sin(out.alpha), "F_span_sky", Role::force, false});
  if (std::abs(sky - main) < 0.02 * sky) {
    arrow(sky, out.R_sky + out.R_main, out.gamma_sky, "R");
    return;
  }
  arrow(sky, out.R_sky, out.gamma_sky, "R_sky");
  arrow(main, out.R_main, out.gamma_main, "R_main");
}

}  // namespace

double mainline_height(const Input& in) { return in.mainline_block_height.value_or(in.skyline_block_height); }

Drawing mast_drawing(const Input& in, const Output& out) {
  const double sky = in.skyline_block_height, main = mainline_height(in), height = std::max(sky, main);
  const double width = std::clamp(out.D_tube, 0.005 * height, 0.12 * height);
  const double radius = 0.03 * height + width / 2;
  Drawing d{"mast",
            "Mast, ropes and forces",
            "Mast and tube diameter to scale (blocks are not); force arrows to one scale; R is the sum where both "
            "blocks are at one height. At the clamp: what holds the "
            "mast.",
            {},
            si::m,
            1,
            {{Role::rope, "skyline"},
             {Role::second_rope, "mainline"},
             {Role::force, "rope force"},
             {Role::second_force, "resultant, reaction"}}};
  d.shapes.emplace_back(box(-width / 2, 0, width / 2, height, Role::structure));
  add_clamp(d.shapes, width, height, out);
  add_rope(d.shapes, main, std::abs(sky - main) < 0.02 * sky ? 0.7 * radius : radius,
           drawn_length(height, main, out.alpha), out.alpha, Role::second_rope);
  add_rope(d.shapes, sky, radius, drawn_length(height, sky, out.alpha), out.alpha, Role::rope);
  add_forces(d.shapes, in, out);
  d.shapes.emplace_back(Polyline{{{0, sky}, {0.5 * height, sky}}, Role::axis, false, false});
  d.shapes.emplace_back(
      AngleMark{{0, sky}, 0.42 * height, std::min(0.0, -out.alpha), std::max(0.0, -out.alpha), "alpha"});
  d.shapes.emplace_back(AngleMark{{0, sky}, 0.2 * height, -out.gamma_sky, 0, "gamma"});
  d.shapes.emplace_back(DimensionLine{{-0.2 * height, 0}, {-0.2 * height, sky}, 0, "h_sky"});
  if (sky != main) d.shapes.emplace_back(DimensionLine{{-0.3 * height, 0}, {-0.3 * height, main}, 0, "h_main"});
  return d;
}

Drawing force_polygon(const Input& in, const Output& out) {
  Drawing d{"force_polygon",
            "Force polygon of the blocks",
            "Span side and drum side of each rope make the resultant on its block; both resultants add up to Q across "
            "and N down.",
            {},
            si::N,
            1,
            {{Role::force, "rope force"}, {Role::second_force, "resultant"}}};
  const auto triangle = [&](Point from, double F_span, double T, double R, const char* span, const char* drum,
                            const char* resultant) {
    const double fx = F_span * std::cos(out.alpha), fy = -F_span * std::sin(out.alpha);
    d.shapes.emplace_back(ForceArrow{from, fx, fy, span, Role::force, false});
    d.shapes.emplace_back(ForceArrow{{from.x + fx, from.y + fy}, 0, -T, drum, Role::force, false});
    d.shapes.emplace_back(ForceArrow{from, fx, fy - T, R > 0 ? resultant : "", Role::second_force, false});
    return Point{from.x + fx, from.y + fy - T};
  };
  Point end = triangle({0, 0}, out.F_span_sky, in.skyline_force, out.R_sky, "F_span_sky", "T_sky", "R_sky");
  if (in.mainline_force > 0) {
    end = triangle(end, out.F_span_main, in.mainline_force, out.R_main, "F_span_main", "T_main", "R_main");
  }
  d.shapes.emplace_back(ForceArrow{{0, end.y}, out.Q, 0, "Q", Role::second_force, false});
  d.shapes.emplace_back(ForceArrow{{0, 0}, 0, -out.N, "N", Role::second_force, false});
  return d;
}

}  // namespace taut::mast_section
