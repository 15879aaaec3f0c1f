#include "taut/structure/beam.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/base/expects.hpp"
#include "taut/math/roots.hpp"
#include "taut/structure/hollow_section.hpp"

namespace taut::structure {
namespace {

/// sigma, sqrt(3) tau: its length is the equivalent stress.
using StressPair = Eigen::Vector2d;

/// An ellipse around `centre`: centre + a cos f + b sin f.
struct Ellipse {
  StressPair centre, a, b;
};

/// The point of an ellipse that is farthest from the origin. By u = (cos f, sin f) half of the square of the distance
/// is u.Q u/2 + g.u; in the axes of Q, with u in the quadrant of g, its derivative g_2 cos f - g_1 sin f - (q_1 - q_2)
/// cos f sin f changes its sign once from 0 to 90 deg, as g_2/sin f - g_1/cos f - (q_1 - q_2) only falls.
StressPair farthest(const Ellipse& e) {
  const double aa = e.a.squaredNorm(), bb = e.b.squaredNorm(), ab = e.a.dot(e.b);
  const double turn = std::atan2(2 * ab, aa - bb) / 2, c = std::cos(turn), s = std::sin(turn);
  const StressPair first = c * e.a + s * e.b, second = c * e.b - s * e.a;
  const double g_1 = e.centre.dot(first), g_2 = e.centre.dot(second);
  const double apart = std::max(0.0, first.squaredNorm() - second.squaredNorm());
  const auto slope = [&](double f) {
    return std::abs(g_2) * std::cos(f) - std::abs(g_1) * std::sin(f) - apart * std::cos(f) * std::sin(f);
  };
  const double f = g_2 == 0 ? 0 : find_root(slope, 0, std::numbers::pi / 2).value_or(0);
  const auto point = [&](double at) {
    return StressPair(e.centre + std::copysign(std::cos(at), g_1) * first + std::copysign(std::sin(at), g_2) * second);
  };
  const StressPair found = point(f), end = point(std::numbers::pi / 2);
  return found.squaredNorm() >= end.squaredNorm() ? found : end;
}

constexpr double by_shear = std::numbers::sqrt3;

PointStress stress_of(const StressPair& p) { return {.sigma = std::abs(p.x()), .tau = std::abs(p.y()) / by_shear}; }

StressPair worst_of_tube(const BeamSection& b, const SectionForces& f, const StressPair& all) {
  const double M = std::hypot(f.bends_to_x, f.bends_to_y), V = std::hypot(f.shear_x, f.shear_y);
  const double along = M > 0 ? std::abs(f.shear_x * f.bends_to_x + f.shear_y * f.bends_to_y) / M : V;
  const double across = M > 0 ? std::abs(f.shear_x * f.bends_to_y - f.shear_y * f.bends_to_x) / M : 0;
  const double per_force = by_shear * b.shear_x.middle;
  return farthest({.centre = all, .a = {M / b.W_x, per_force * across}, .b = {0, per_force * along}});
}

/// Bending stress of a moment, force and shear stresses of one direction of a box.
struct Way {
  double sigma, V;
  const WallShear& shear;
};

/// Along a wall in the direction `wall`.
StressPair worst_of_wall(const Way& wall, const Way& across, const StressPair& all) {
  return farthest({.centre = all + StressPair(across.sigma, by_shear * wall.V * wall.shear.corner),
                   .a = {wall.sigma, by_shear * across.V * across.shear.corner},
                   .b = {0, by_shear * wall.V * (wall.shear.middle - wall.shear.corner)}});
}

/// Jourawski's formula V S/(I t), of a box: S of half a flange at its corners, of half the section in the middle.
WallShear box_shear(const catalogue::SectionRow& row, double I, double W_pl) {
  const double t = row.thickness;
  return {.corner = (row.height - t) * (row.width - t) / (4 * I), .middle = W_pl / (4 * I * t)};
}

}  // namespace

BeamSection beam_section(const catalogue::SectionRow& row, const Elasticity& steel) {
  const bool round = row.shape == catalogue::SectionShape::chs;
  return {.area = row.area,
          .EA = steel.E * row.area,
          .EI_x = steel.E * row.I_y,
          .EI_y = steel.E * row.I_z,
          .GJ = steel.G * row.I_t,
          .W_x = row.W_el_y,
          .W_y = row.W_el_z,
          .W_t = torsion_modulus(row),
          .shear_x = round ? round_shear(row.area) : box_shear(row, row.I_y, row.W_pl_y),
          .shear_y = round ? round_shear(row.area) : box_shear(row, row.I_z, row.W_pl_z),
          .weight = 0,
          .outline = round ? Outline::tube : Outline::box};
}

BeamSection tube_section(double diameter, double wall, const Elasticity& steel) {
  expects(diameter > 0 && wall > 0 && 2 * wall <= diameter, "a tube has a wall that fits into it");
  const double pi = std::numbers::pi, inner = diameter - 2 * wall;
  const double area = pi * (diameter - wall) * wall;
  const double I = pi / 64 * (std::pow(diameter, 4) - std::pow(inner, 4)), W = 2 * I / diameter;
  return {.area = area,
          .EA = steel.E * area,
          .EI_x = steel.E * I,
          .EI_y = steel.E * I,
          .GJ = 2 * steel.G * I,
          .W_x = W,
          .W_y = W,
          .W_t = 2 * W,
          .shear_x = round_shear(area),
          .shear_y = round_shear(area),
          .weight = 0,
          .outline = Outline::tube};
}

WallShear round_shear(double area) { return {.corner = 0, .middle = 2 / area}; }

double PointStress::equivalent() const { return std::hypot(sigma, by_shear * tau); }

PointStress most_stressed_point(const BeamSection& section, const SectionForces& f) {
  const double twist = section.W_t > 0 ? std::abs(f.torsion) / section.W_t : 0;
  const StressPair all(std::abs(f.axial) / section.area, by_shear * twist);
  if (section.outline != Outline::box) return stress_of(worst_of_tube(section, f, all));
  const Way x{.sigma = std::abs(f.bends_to_x) / section.W_x, .V = std::abs(f.shear_x), .shear = section.shear_x};
  const Way y{.sigma = std::abs(f.bends_to_y) / section.W_y, .V = std::abs(f.shear_y), .shear = section.shear_y};
  const StressPair along_x = worst_of_wall(x, y, all), along_y = worst_of_wall(y, x, all);
  return stress_of(along_x.squaredNorm() > along_y.squaredNorm() ? along_x : along_y);
}

double largest_stress(const BeamSection& section, const SectionForces& f) {
  return most_stressed_point(section, f).equivalent();
}

double largest_stress_in_corner(const BeamSection& section, const SectionForces& f) {
  if (section.outline != Outline::unsaid) return largest_stress(section, f);
  BeamSection box = section;
  box.outline = Outline::box;
  SectionForces over_corner = f;
  over_corner.bends_to_x = over_corner.bends_to_y = std::hypot(f.bends_to_x, f.bends_to_y) / std::numbers::sqrt2;
  return largest_stress(box, over_corner);
}

bool leaves_out_torsion(const BeamSection& section, const SectionForces& f) {
  if (section.W_t > 0) return false;
  const double stress = largest_stress(section, f), W = std::min(section.W_x, section.W_y);
  return std::hypot(stress, f.torsion / W) > stress;
}

}  // namespace taut::structure
