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
  Curve c{label, {}, {}, false, false};
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
  Plot p{"moment",
         "Bending moment over the height",
         "Both blocks push the head towards the span.",
         {"height above the clamp", si::m},
         {"bending moment", si::N_m},
         {},
         {{0, out.M, "M at the clamp", false}}};
  Curve c{"M", stations(in), {}, false, false};
  for (const double z : c.x) c.y.push_back(forces_at(in, out, z).M);
  p.curves.push_back(std::move(c));
  return p;
}

Plot stress_plot(const Input& in, const Output& out, const std::optional<Assessment>& section) {
  const double D = out.D_tube, c = in.tube_ratio;
  const double area = section ? section->section.area : std::numbers::pi * square(D) * (1 - square(c)) / 4;
  const double W = section ? section->section.W_el_y : std::numbers::pi * cube(D) * (1 - square(square(c))) / 32;
  const std::string name = section ? section->section.name : fmt::format("tube D_tube, c = {:.3g}", c);
  Plot p{"stress",
         "Largest stress over the height",
         "N/A + M/W on the side of the span, section constant.",
         {"height above the clamp", si::m},
         {"stress", si::Pa},
         {},
         {}};
  Curve total{name, stations(in), {}, false, false};
  Curve axial{"N/A alone", stations(in), {}, true, false};
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
  Plot p{"branch_angle",
         "Sizes over the branch angle",
         "All else as given.",
         {"branch angle below the horizontal", si::rad},
         {"size", mm},
         {},
         {{out.alpha, out.D_tube, "here", false}}};
  p.curves = {size_curve("tube, D_tube", all, &Output::alpha, &Output::D_tube),
              size_curve("tube, ropes paid out", all, &Output::alpha, &Output::D_tube_payout),
              size_curve("hollow square, B_hollow", all, &Output::alpha, &Output::B_hollow),
              size_curve("solid square, b_square", all, &Output::alpha, &Output::b_square)};
  p.curves[1].dashed = true;
  return p;
}

Plot position_size_plot(const std::vector<Position>& positions, const Output& out) {
  const auto all = by_distance(positions);
  Plot p{"size_over_position",
         "Section size over the carriage's position",
         "The largest size governs.",
         {"carriage's distance from the mast", si::m},
         {"size", mm},
         {},
         {{out.x, out.D_tube, "governs", false}}};
  p.curves = {size_curve("tube, D_tube", all, &Output::x, &Output::D_tube),
              size_curve("tube, ropes paid out", all, &Output::x, &Output::D_tube_payout),
              size_curve("hollow square, B_hollow", all, &Output::x, &Output::B_hollow),
              size_curve("solid square, b_square", all, &Output::x, &Output::b_square)};
  p.curves[1].dashed = true;
  return p;
}

Plot position_force_plot(const std::vector<Position>& positions, const Output& out) {
  const auto all = by_distance(positions);
  return {
      "force_over_position",
      "Axial force and shear over the carriage's position",
      "At the clamp.",
      {"carriage's distance from the mast", si::m},
      {"force", si::N},
      {size_curve("axial force N", all, &Output::x, &Output::N), size_curve("shear Q", all, &Output::x, &Output::Q)},
      {{out.x, out.N, "governs", false}}};
}

Plot position_moment_plot(const std::vector<Position>& positions, const Output& out) {
  const auto all = by_distance(positions);
  return {"moment_over_position",
          "Bending moment over the carriage's position",
          "At the clamp.",
          {"carriage's distance from the mast", si::m},
          {"bending moment", si::N_m},
          {size_curve("M", all, &Output::x, &Output::M)},
          {{out.x, out.M, "governs", false}}};
}

}  // namespace taut::mast_section
