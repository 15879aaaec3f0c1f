#include "taut/structure/hollow_section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/calc/num.hpp"

namespace taut::structure {
namespace {

using catalogue::SectionRow;
using catalogue::SectionShape;
using std::numbers::pi;

constexpr double steel_density = 7850;  // kg/m3

/// What the four rounded corners of radius r leave out of the square ones, EN 10210-2 annex B.
struct Corner {
  double area;      ///< A_g of one, m2
  double centroid;  ///< from the side that `half` is measured to, m
  double inertia;   ///< I_gg of one about its own axis, m4
};
Corner corner(double radius) {
  const double c = (10 - 3 * pi) / (12 - 3 * pi);
  const double k = 1.0 / 3 - pi / 16 - 1 / (3 * (12 - 3 * pi));
  return {.area = (1 - pi / 4) * square(radius), .centroid = c * radius, .inertia = k * square(square(radius))};
}

struct Bending {
  double I, W_pl;
};
/// About the axis that halves `high`.
Bending bending(double high, double wide, const HollowSizes& s) {
  const double t = s.wall, h_i = high - 2 * t, b_i = wide - 2 * t;
  const Corner out = corner(s.outer_radius), in = corner(s.inner_radius);
  const double arm_out = high / 2 - out.centroid, arm_in = h_i / 2 - in.centroid;
  return {.I = (wide * cube(high) - b_i * cube(h_i)) / 12 - 4 * (out.inertia + out.area * square(arm_out)) +
               4 * (in.inertia + in.area * square(arm_in)),
          .W_pl = (wide * square(high) - b_i * square(h_i)) / 4 - 4 * out.area * arm_out + 4 * in.area * arm_in};
}

/// The middle line of the walls of a box: its length, and what it encloses.
struct MiddleLine {
  double length, enclosed;
  double K(double t) const { return 2 * enclosed * t / length; }
};
MiddleLine middle_line(const HollowSizes& s) {
  const double t = s.wall, R_c = (s.outer_radius + s.inner_radius) / 2;
  return {.length = 2 * (s.width + s.height - 2 * t) - 2 * R_c * (4 - pi),
          .enclosed = (s.width - t) * (s.height - t) - square(R_c) * (4 - pi)};
}

double torsion_of_box(const HollowSizes& s) {
  const double t = s.wall;
  const MiddleLine line = middle_line(s);
  return cube(t) * line.length / 3 + 2 * line.K(t) * line.enclosed;
}

void fill_box(const HollowSizes& s, SectionRow& row) {
  row.outer_radius = s.outer_radius;
  row.inner_radius = s.inner_radius;
  row.area =
      2 * s.wall * (s.width + s.height - 2 * s.wall) - (4 - pi) * (square(s.outer_radius) - square(s.inner_radius));
  const Bending y = bending(s.height, s.width, s), z = bending(s.width, s.height, s);
  row.I_y = y.I;
  row.I_z = z.I;
  row.W_pl_y = y.W_pl;
  row.W_pl_z = z.W_pl;
  row.I_t = torsion_of_box(s);
}

void fill_ring(const HollowSizes& s, SectionRow& row) {
  const double D = s.height, d = D - 2 * s.wall;
  row.outer_radius = D / 2;
  row.inner_radius = d / 2;
  row.area = pi / 4 * (square(D) - square(d));
  row.I_y = row.I_z = pi / 64 * (square(square(D)) - square(square(d)));
  row.W_pl_y = row.W_pl_z = (cube(D) - cube(d)) / 6;
  row.I_t = 2 * row.I_y;
}

}  // namespace

HollowSizes sizes_of(const SectionRow& row) {
  return {.shape = row.shape,
          .forming = row.forming,
          .height = row.height,
          .width = row.width,
          .wall = row.thickness,
          .outer_radius = row.outer_radius,
          .inner_radius = row.inner_radius};
}

SectionRow hollow_section(const HollowSizes& s) {
  expects(s.wall > 0 && s.width > 2 * s.wall && s.height >= s.width, "a hollow section encloses something");
  SectionRow row;
  row.shape = s.shape;
  row.forming = s.forming;
  row.height = s.height;
  row.width = s.width;
  row.thickness = s.wall;
  row.trust = catalogue::Trust::derived;
  row.trust_text = "computed from its sizes";
  const bool round = s.shape == SectionShape::chs;
  if (round) {
    expects(s.height == s.width, "a circular section has one diameter");
    fill_ring(s, row);
  } else {
    fill_box(s, row);
  }
  row.name =
      round ? fmt::format("CHS {:.6g}x{:.6g}", s.height * 1e3, s.wall * 1e3)
            : fmt::format("{} {:.6g}x{:.6g}x{:.6g}", to_text(s.shape), s.height * 1e3, s.width * 1e3, s.wall * 1e3);
  row.W_el_y = row.I_y / (s.height / 2);
  row.W_el_z = row.I_z / (s.width / 2);
  row.i_y = std::sqrt(row.I_y / row.area);
  row.i_z = std::sqrt(row.I_z / row.area);
  row.mass_per_length = row.area * steel_density;
  return row;
}

double enclosed_area(const SectionRow& row) {
  if (row.shape == SectionShape::chs) return pi / 4 * square(row.height - row.thickness);
  return middle_line(sizes_of(row)).enclosed;
}

double torsion_modulus(const SectionRow& row) {
  if (row.shape == SectionShape::chs) return 2 * row.I_t / row.height;
  const double t = row.thickness;
  return row.I_t / (t + middle_line(sizes_of(row)).K(t) / t);
}

SectionRow with_thinner_wall(const SectionRow& row, double share) {
  expects(share >= 0 && share < 1, "a wall keeps something of its thickness");
  if (share == 0) return row;
  const double left = 1 - share;
  HollowSizes sizes = sizes_of(row);
  sizes.wall *= left;
  sizes.outer_radius *= left;
  sizes.inner_radius *= left;
  SectionRow thin = hollow_section(sizes);
  thin.name = fmt::format("{} with its wall {:.3g} % thinner", row.name, share * 100);
  thin.standard = row.standard;
  thin.mass_per_length = row.mass_per_length;
  thin.trust = row.trust;
  thin.trust_text = row.trust_text;
  return thin;
}

HollowSizes with_usual_radii(HollowSizes s) {
  const bool cold = s.forming == catalogue::Forming::cold || s.forming == catalogue::Forming::welded;
  const double t = s.wall;
  const double out = !cold ? 1.5 : t <= 6.0001e-3 ? 2.0 : t <= 10.0001e-3 ? 2.5 : 3.0;
  s.outer_radius = out * t;
  s.inner_radius = (cold ? out - 1 : 1.0) * t;
  return s;
}

}  // namespace taut::structure
