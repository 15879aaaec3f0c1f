#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/methods/mast_section/figures.hpp"

namespace taut::mast_section {
namespace {

const Unit mm = si::m.in("mm");

/// Heights where something happens: clamp, blocks (just below and just above, for the step of N), in ascending order.
std::vector<double> stations(const Input& in) {
  const double low = std::min(in.skyline_block_height, mainline_height(in));
  const double high = std::max(in.skyline_block_height, mainline_height(in));
  if (low == high) return {0, high};
  return {0, std::nextafter(low, 0), std::nextafter(low, high), high};
}

/// N and M just above the height z.
struct At {
  double N = 0;
  double M = 0;
};
At forces_at(const Input& in, const Output& out, double z) {
  At at;
  const auto add = [&](double h, double R, double gamma) {
    if (z > h) return;
    at.N += R * std::sin(gamma);
    at.M += R * std::cos(gamma) * (h - z);
  };
  add(in.skyline_block_height, out.R_sky, out.gamma_sky);
  add(mainline_height(in), out.R_main, out.gamma_main);
  return at;
}

Curve size_curve(const char* label, const std::vector<Position>& positions, double Output::*x, double Output::*y) {
  Curve c{.label = label, .x = {}, .y = {}, .dashed = false, .points_only = false};
  for (const Position& p : positions) {
    c.x.push_back(p.out.*x);
    c.y.push_back(p.outcome.ok() ? p.out.*y : not_computed);
  }
  return c;
}

/// Positions by their distance from the mast: a curve must not run to and fro.
std::vector<Position> by_distance(std::vector<Position> positions) {
  std::stable_sort(positions.begin(), positions.end(),
                   [](const Position& a, const Position& b) { return a.out.x < b.out.x; });
  return positions;
}

}  // namespace

Plot moment_plot(const Input& in, const Output& out) {
  Plot p{.name = "moment",
         .title = "Bending moment over the height",
         .caption = "Both blocks push the head towards the span.",
         .x = {.label = "height above the clamp", .unit = si::m},
         .y = {.label = "bending moment", .unit = si::N_m},
         .curves = {},
         .marks = {{.x = 0, .y = out.M, .label = "M at the clamp", .whole_line = false}}};
  Curve c{.label = "M", .x = stations(in), .y = {}, .dashed = false, .points_only = false};
  for (const double z : c.x) c.y.push_back(forces_at(in, out, z).M);
  p.curves.push_back(std::move(c));
  return p;
}

Plot stress_plot(const Input& in, const Output& out, const std::optional<Assessment>& section) {
  const double D = out.D_tube, c = in.tube_ratio;
  const double area = section ? section->section.area : std::numbers::pi * square(D) * (1 - square(c)) / 4;
  const double W = section ? section->section.W_el_y : std::numbers::pi * cube(D) * (1 - square(square(c))) / 32;
  const std::string name = section ? section->section.name : fmt::format("tube D_tube, c = {:.3g}", c);
  Plot p{.name = "stress",
         .title = "Largest stress over the height",
         .caption = "N/A + M/W on the side of the span, section constant.",
         .x = {.label = "height above the clamp", .unit = si::m},
         .y = {.label = "stress", .unit = si::Pa},
         .curves = {},
         .marks = {}};
  Curve total{.label = name, .x = stations(in), .y = {}, .dashed = false, .points_only = false};
  Curve axial{.label = "N/A alone", .x = stations(in), .y = {}, .dashed = true, .points_only = false};
  for (const double z : total.x) {
    const At at = forces_at(in, out, z);
    total.y.push_back(at.N / area + at.M / W);
    axial.y.push_back(at.N / area);
  }
  p.curves = {std::move(total), std::move(axial)};
  p.marks.push_back({0, section ? section->allowable : out.sigma_allow, "[sigma]", true});
  return p;
}

Plot angle_plot(const Input& in, const Output& out) {
  constexpr int points = 59;
  Input at = in;
  at.span.reset();
  std::vector<Position> all;
  Sheet<double> s;
  for (int i = 0; i < points; ++i) {
    at.branch_angle = least_branch_angle + (largest_branch_angle - least_branch_angle) * i / (points - 1);
    Position p;
    p.outcome = compute_at(at, 0, s, p.out);
    all.push_back(std::move(p));
  }
  Plot p{.name = "branch_angle",
         .title = "Sizes over the branch angle",
         .caption = "All else as given.",
         .x = {.label = "branch angle below the horizontal", .unit = si::rad},
         .y = {.label = "size", .unit = mm},
         .curves = {},
         .marks = {{.x = out.alpha, .y = out.D_tube, .label = "here", .whole_line = false}}};
  p.curves = {size_curve("tube, D_tube", all, &Output::alpha, &Output::D_tube),
              size_curve("tube, ropes paid out", all, &Output::alpha, &Output::D_tube_payout),
              size_curve("hollow square, B_hollow", all, &Output::alpha, &Output::B_hollow),
              size_curve("solid square, b_square", all, &Output::alpha, &Output::b_square)};
  p.curves[1].dashed = true;
  return p;
}

Plot position_size_plot(const std::vector<Position>& positions, const Output& out) {
  const auto all = by_distance(positions);
  Plot p{.name = "size_over_position",
         .title = "Section size over the carriage's position",
         .caption = "The largest size governs.",
         .x = {.label = "carriage's distance from the mast", .unit = si::m},
         .y = {.label = "size", .unit = mm},
         .curves = {},
         .marks = {{.x = out.x, .y = out.D_tube, .label = "governs", .whole_line = false}}};
  p.curves = {size_curve("tube, D_tube", all, &Output::x, &Output::D_tube),
              size_curve("tube, ropes paid out", all, &Output::x, &Output::D_tube_payout),
              size_curve("hollow square, B_hollow", all, &Output::x, &Output::B_hollow),
              size_curve("solid square, b_square", all, &Output::x, &Output::b_square)};
  p.curves[1].dashed = true;
  return p;
}

Plot position_force_plot(const std::vector<Position>& positions, const Output& out) {
  const auto all = by_distance(positions);
  return {.name = "force_over_position",
          .title = "Axial force and shear over the carriage's position",
          .caption = "At the clamp.",
          .x = {.label = "carriage's distance from the mast", .unit = si::m},
          .y = {.label = "force", .unit = si::N},
          .curves = {size_curve("axial force N", all, &Output::x, &Output::N),
                     size_curve("shear Q", all, &Output::x, &Output::Q)},
          .marks = {{.x = out.x, .y = out.N, .label = "governs", .whole_line = false}}};
}

Plot position_moment_plot(const std::vector<Position>& positions, const Output& out) {
  const auto all = by_distance(positions);
  return {.name = "moment_over_position",
          .title = "Bending moment over the carriage's position",
          .caption = "At the clamp.",
          .x = {.label = "carriage's distance from the mast", .unit = si::m},
          .y = {.label = "bending moment", .unit = si::N_m},
          .curves = {size_curve("M", all, &Output::x, &Output::M)},
          .marks = {{.x = out.x, .y = out.M, .label = "governs", .whole_line = false}}};
}

}  // namespace taut::mast_section
