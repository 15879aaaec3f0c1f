#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "taut/methods/mast_section/figures.hpp"

namespace taut::mast_section {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

Polyline box(double left, double bottom, double right, double top, Role role) {
  return {
      .points = {{.x = left, .y = bottom}, {.x = right, .y = bottom}, {.x = right, .y = top}, {.x = left, .y = top}},
      .role = role,
      .closed = true,
      .filled = true};
}

/// Length of the span side that stays in the picture: down to the ground, or a share of the mast's height.
double drawn_length(double height, double block, double alpha) {
  const double most = 0.9 * height;
  return std::sin(alpha) > 0 ? std::min(most, 0.95 * block / std::sin(alpha)) : most;
}

/// One rope: up from the drum, over the block, out into the span.
void add_rope(std::vector<Shape>& shapes, double block, double radius, double length, double alpha, Role role) {
  const Point leaves{.x = radius * std::sin(alpha), .y = block + radius * std::cos(alpha)};
  shapes.emplace_back(Circle{
      .center = {.x = 0, .y = block}, .radius = radius, .role = Role::body, .from = 0, .to = 0, .filled = false});
  shapes.emplace_back(Polyline{
      .points = {{.x = -radius, .y = 0}, {.x = -radius, .y = block}}, .role = role, .closed = false, .filled = false});
  shapes.emplace_back(Circle{.center = {.x = 0, .y = block},
                             .radius = radius,
                             .role = role,
                             .from = right_angle - alpha,
                             .to = 2 * right_angle,
                             .filled = false});
  shapes.emplace_back(
      Polyline{.points = {leaves, {.x = leaves.x + length * std::cos(alpha), .y = leaves.y - length * std::sin(alpha)}},
               .role = role,
               .closed = false,
               .filled = false});
}

void add_ground(std::vector<Shape>& shapes, double width, double height) {
  shapes.emplace_back(Polyline{.points = {{.x = -0.35 * height, .y = 0}, {.x = 0.9 * height, .y = 0}},
                               .role = Role::ground,
                               .closed = false,
                               .filled = false});
  shapes.emplace_back(box(-2 * width, -0.04 * height, 2 * width, 0, Role::ground));
}

void add_clamp(std::vector<Shape>& shapes, double width, double height, const Output& out) {
  shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = -0.04 * height},
                                 .fx = 0,
                                 .fy = out.N,
                                 .label = "N",
                                 .role = Role::second_force,
                                 .towards = true});
  shapes.emplace_back(ForceArrow{.at = {.x = -2 * width, .y = -0.02 * height},
                                 .fx = -out.Q,
                                 .fy = 0,
                                 .label = "Q",
                                 .role = Role::second_force,
                                 .towards = false});
  // The clamp holds the head back: its moment turns away from the span.
  shapes.emplace_back(Circle{.center = {.x = 0, .y = 0},
                             .radius = 3 * width,
                             .role = Role::second_force,
                             .from = 0.2 * std::numbers::pi,
                             .to = 0.8 * std::numbers::pi,
                             .filled = false});
  shapes.emplace_back(Label{.at = {.x = 2.6 * width, .y = 2.2 * width}, .text = "M"});
}

/// Forces on the head. Blocks at one height get one resultant, since both point the same way.
void add_forces(std::vector<Shape>& shapes, const Input& in, const Output& out) {
  const double sky = in.skyline_block_height, main = mainline_height(in);
  const auto arrow = [&](double at, double R, double gamma, const char* label) {
    shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = at},
                                   .fx = R * std::cos(gamma),
                                   .fy = -R * std::sin(gamma),
                                   .label = label,
                                   .role = Role::second_force,
                                   .towards = false});
  };
  const double F = out.F_span_sky;
  shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = sky},
                                 .fx = F * std::cos(out.alpha),
                                 .fy = -F * std::sin(out.alpha),
                                 .label = "F_span_sky",
                                 .role = Role::force,
                                 .towards = false});
  if (std::abs(sky - main) < 0.02 * sky) {
    arrow(sky, out.R_sky + out.R_main, out.gamma_sky, "R");
    return;
  }
  arrow(sky, out.R_sky, out.gamma_sky, "R_sky");
  arrow(main, out.R_main, out.gamma_main, "R_main");
}

/// What the drawing hangs on, m.
struct Frame {
  double sky = 0;          ///< height of the skyline's block
  double main = 0;         ///< of the mainline's block
  double width = 0;        ///< of the mast
  double radius = 0;       ///< of the skyline's block
  double main_radius = 0;  ///< smaller where both blocks stand at one height

  double height() const { return std::max(sky, main); }
};

Frame frame_of(const Input& in, double tube) {
  Frame k{.sky = in.skyline_block_height, .main = mainline_height(in)};
  k.width = std::clamp(tube, 0.005 * k.height(), 0.12 * k.height());
  k.radius = 0.03 * k.height() + k.width / 2;
  k.main_radius = std::abs(k.sky - k.main) < 0.02 * k.sky ? 0.7 * k.radius : k.radius;
  return k;
}

void add_ropes(std::vector<Shape>& shapes, const Frame& k, double alpha) {
  add_rope(shapes, k.main, k.main_radius, drawn_length(k.height(), k.main, alpha), alpha, Role::second_rope);
  add_rope(shapes, k.sky, k.radius, drawn_length(k.height(), k.sky, alpha), alpha, Role::rope);
}

void add_heights(std::vector<Shape>& shapes, const Frame& k) {
  const auto measure = [&](double at, double top, const char* text) {
    shapes.emplace_back(DimensionLine{.from = {.x = -at * k.height(), .y = 0},
                                      .to = {.x = -at * k.height(), .y = top},
                                      .offset = 0,
                                      .text = text,
                                      .with_length = true});
  };
  measure(0.2, k.sky, "h_sky");
  if (k.sky != k.main) measure(0.3, k.main, "h_main");
}

/// The span side's angle below the horizontal at the skyline's block.
void add_branch_angle(std::vector<Shape>& shapes, const Frame& k, double alpha) {
  shapes.emplace_back(Polyline{.points = {{.x = 0, .y = k.sky}, {.x = 0.5 * k.height(), .y = k.sky}},
                               .role = Role::axis,
                               .closed = false,
                               .filled = false});
  shapes.emplace_back(AngleMark{.center = {.x = 0, .y = k.sky},
                                .radius = 0.42 * k.height(),
                                .from = std::min(0.0, -alpha),
                                .to = std::max(0.0, -alpha),
                                .text = "alpha"});
}

/// The state that the drawings show: of several carriage positions the one that asks for the largest tube.
std::string state_drawn(const Output& out) {
  return std::isfinite(out.x) ? fmt::format("Ropes hauled in, carriage at {:.4g} m. ", out.x) : "Ropes hauled in. ";
}

/// What the drawings do not show.
std::string state_not_drawn(const Output& out) {
  const bool paid_out_is_worse = std::isfinite(out.M_payout) && out.M_payout > out.M;
  return paid_out_is_worse ? "Ropes paid out, which are not drawn, bend the mast more. " : "";
}

}  // namespace

double mainline_height(const Input& in) { return in.mainline_block_height.value_or(in.skyline_block_height); }

Drawing mast_drawing(const Input& in, const Output& out) {
  const Frame k = frame_of(in, out.D_tube);
  Drawing d{.name = "mast",
            .title = "Mast, ropes and forces",
            .caption = state_drawn(out) + state_not_drawn(out) +
                       "Mast and tube diameter to scale (blocks are not); force arrows to one scale; R is the sum "
                       "where both blocks are at one height. At the clamp: what holds the mast.",
            .shapes = {},
            .unit = si::m,
            .vertical_scale = 1,
            .legend = {{Role::rope, "skyline"},
                       {Role::second_rope, "mainline"},
                       {Role::force, "rope force"},
                       {Role::second_force, "resultant, reaction"}}};
  d.shapes.emplace_back(box(-k.width / 2, 0, k.width / 2, k.height(), Role::structure));
  add_ground(d.shapes, k.width, k.height());
  add_clamp(d.shapes, k.width, k.height(), out);
  add_ropes(d.shapes, k, out.alpha);
  add_forces(d.shapes, in, out);
  add_branch_angle(d.shapes, k, out.alpha);
  d.shapes.emplace_back(AngleMark{
      .center = {.x = 0, .y = k.sky}, .radius = 0.2 * k.height(), .from = -out.gamma_sky, .to = 0, .text = "gamma"});
  add_heights(d.shapes, k);
  return d;
}

Drawing mast_without_answer(const Input& in, const Output& out) {
  const bool known = std::isfinite(out.alpha);
  const double alpha = known ? out.alpha : 0;
  const Frame k = frame_of(in, 0.03 * in.skyline_block_height);
  Drawing d{.name = "mast",
            .title = "Mast as described; no answer was found",
            .caption = std::string("This is not an answer: the width of the mast is not known. Forces of the ropes "
                                   "at their drums.") +
                       (known ? "" : " The branch angle is not known: the ropes are drawn level."),
            .shapes = {},
            .unit = si::m,
            .vertical_scale = 1,
            .legend = {{Role::rope, "skyline"}, {Role::second_rope, "mainline"}, {Role::force, "rope force"}}};
  d.shapes.emplace_back(box(-k.width / 2, 0, k.width / 2, k.height(), Role::structure));
  add_ground(d.shapes, k.width, k.height());
  add_ropes(d.shapes, k, alpha);
  const auto pull = [&](double x, double y, double T, const char* label) {
    if (T > 0)
      d.shapes.emplace_back(ForceArrow{
          .at = {.x = -x, .y = y}, .fx = 0, .fy = -T, .label = label, .role = Role::force, .towards = false});
  };
  pull(k.radius, 0.6 * k.sky, in.skyline_force, "T_sky");
  pull(k.main_radius, 0.4 * k.main, in.mainline_force, "T_main");
  if (known) add_branch_angle(d.shapes, k, alpha);
  add_heights(d.shapes, k);
  return d;
}

Drawing force_polygon(const Input& in, const Output& out) {
  Drawing d{
      .name = "force_polygon",
      .title = "Force polygon of the blocks",
      .caption = state_drawn(out) +
                 "Span side and drum side of each rope make the resultant on its block; both resultants add up to Q "
                 "across and N down.",
      .shapes = {},
      .unit = si::N,
      .vertical_scale = 1,
      .legend = {{Role::force, "rope force"}, {Role::second_force, "resultant"}}};
  const auto triangle = [&](Point from, double F_span, double T, double R, const char* span, const char* drum,
                            const char* resultant) {
    const double fx = F_span * std::cos(out.alpha), fy = -F_span * std::sin(out.alpha);
    d.shapes.emplace_back(
        ForceArrow{.at = from, .fx = fx, .fy = fy, .label = span, .role = Role::force, .towards = false});
    d.shapes.emplace_back(ForceArrow{.at = {.x = from.x + fx, .y = from.y + fy},
                                     .fx = 0,
                                     .fy = -T,
                                     .label = drum,
                                     .role = Role::force,
                                     .towards = false});
    d.shapes.emplace_back(ForceArrow{.at = from,
                                     .fx = fx,
                                     .fy = fy - T,
                                     .label = R > 0 ? resultant : "",
                                     .role = Role::second_force,
                                     .towards = false});
    return Point{.x = from.x + fx, .y = from.y + fy - T};
  };
  Point end = triangle({.x = 0, .y = 0}, out.F_span_sky, in.skyline_force, out.R_sky, "F_span_sky", "T_sky", "R_sky");
  if (in.mainline_force > 0) {
    end = triangle(end, out.F_span_main, in.mainline_force, out.R_main, "F_span_main", "T_main", "R_main");
  }
  d.shapes.emplace_back(ForceArrow{
      .at = {.x = 0, .y = end.y}, .fx = out.Q, .fy = 0, .label = "Q", .role = Role::second_force, .towards = false});
  d.shapes.emplace_back(ForceArrow{
      .at = {.x = 0, .y = 0}, .fx = 0, .fy = -out.N, .label = "N", .role = Role::second_force, .towards = false});
  return d;
}

}  // namespace taut::mast_section
