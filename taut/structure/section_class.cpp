#include "taut/structure/section_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace taut::structure {
namespace {

using catalogue::SectionRow;
using catalogue::SectionShape;

constexpr double reference_yield = 235e6;  // Pa
constexpr const char* table_5_2 = "EN 1993-1-1, table 5.2";

double epsilon_of(double yield) { return std::sqrt(reference_yield / yield); }

double limit_by_alpha(double factor_high, double factor_low, double epsilon, double alpha) {
  if (alpha > 0.5) return factor_high * epsilon / (13 * alpha - 1);
  return alpha > 0 ? factor_low * epsilon / alpha : std::numeric_limits<double>::infinity();
}

double limit_by_psi(double epsilon, double psi) {
  return psi > -1 ? 42 * epsilon / (0.67 + 0.33 * psi) : 62 * epsilon * (1 - psi) * std::sqrt(-psi);
}

/// Stresses of two parallel walls of a box, Pa: alike over the wall, and at its ends by bending in its own plane.
struct WallStress {
  double axial, across, own;
};

WallClass wall_class(const char* name, double slenderness, double yield, double alpha, const WallStress& stress) {
  const double epsilon = epsilon_of(yield), never = -std::numeric_limits<double>::infinity();
  // the most pressed of both walls, at its ends; psi of one that is pressed nowhere
  const double alike = stress.axial + stress.across, most = alike + stress.own;
  const double psi = most > 0 ? (alike - stress.own) / most : never;
  WallClass w{.wall = name,
              .slenderness = slenderness,
              .alpha = alpha,
              .limit_1 = limit_by_alpha(396, 36, epsilon, alpha),
              .limit_2 = limit_by_alpha(456, 41.5, epsilon, alpha),
              .limit_3 = 0,
              .value = 1};
  // elastic: never stricter than class 2, as plastic and elastic states are compared at unlike moments
  w.limit_3 = std::max(std::isinf(psi) ? psi * psi : limit_by_psi(epsilon, psi), w.limit_2);
  w.value = class_of(w.slenderness, w.limit_1, w.limit_2, w.limit_3);
  return w;
}

/// A thin box under yield stress by the lengths of the middle lines of its walls, m.
struct ThinBox {
  double web, flange;
};

/// How far the more pressed web and flange are pressed, from the edge that they share, m.
struct Pressed {
  double web, flange;
};

/// Where the neutral axis crosses both of two opposite walls: the pressed length of the more pressed one. `own` bends
/// them in their plane, `other` is the length of the walls between them, of which one is pressed and one pulled; n =
/// N/(t f_y). Empty where the axis does not cross both.
///
/// With their cuts at z_1 and z_2 from their middles, d = z_2 - z_1: N = -2 t f_y (z_1 + z_2), M_own = t f_y (K -
/// d^2/2) with K = other side + side^2/2 - n^2/8, M_across = t f_y other d.
std::optional<double> across_opposite(double side, double other, double n, double own, double across) {
  if (std::abs(n) > 2 * side) return std::nullopt;
  const double K = side * (other + side / 2) - n * n / 8;
  const double d = 2 * K * across / (other * own + std::sqrt(square(other * own) + 2 * K * square(across)));
  if (std::abs(n) / 4 + d / 2 > side / 2) return std::nullopt;
  return side / 2 + n / 4 + d / 2;
}

/// Where a pull leaves but a corner pressed: q of the web and p of the flange, p + q = L = web + flange - |n|/2. M_y =
/// t f_y (L (web - L) + 2 L p - p^2) grows with p and M_z = t f_y (L flange - p^2) falls. A moment ratio beyond that of
/// the ends of p has the neutral axis along a wall: that wall counts as pressed as a whole.
Pressed at_corner(const ThinBox& box, double n, double M_y, double M_z) {
  const double L = box.web + box.flange - std::abs(n) / 2;
  if (L <= 0) return {.web = box.web, .flange = box.flange};  // more than all of it can bear
  const double a = M_y - M_z, b = L * M_z, c = L * (M_z * (box.web - L) - M_y * box.flange);
  const auto beyond = [&](double p) { return (a * p + 2 * b) * p + c; };  // M_z M_y(p) - M_y M_z(p)
  const double least = std::max(0.0, L - box.web), most = std::min(box.flange, L);
  if (beyond(most) <= 0) return {.web = L - most, .flange = box.flange};
  if (beyond(least) >= 0) return {.web = box.web, .flange = least};
  const double p = std::clamp(-c / (b + std::sqrt(std::max(b * b - a * c, 0.0))), least, most);
  return {.web = L - p, .flange = p};
}

/// In the plastic state under N, with moments in the ratio of M_y and M_z grown up to it; one of them is not 0.
Pressed pressed_in(const ThinBox& box, double n, double M_y, double M_z) {
  if (const auto web = across_opposite(box.web, box.flange, n, M_y, M_z)) return {.web = *web, .flange = box.flange};
  if (const auto flange = across_opposite(box.flange, box.web, n, M_z, M_y)) return {.web = box.web, .flange = *flange};
  if (n >= 0) return {.web = box.web, .flange = box.flange};  // but a corner, or less, is pulled
  return at_corner(box, n, M_y, M_z);
}

}  // namespace

CrossForces operator*(double factor, const CrossForces& f) {
  return {.N = factor * f.N,
          .V_y = factor * f.V_y,
          .V_z = factor * f.V_z,
          .M_y = factor * f.M_y,
          .M_z = factor * f.M_z,
          .torsion = factor * f.torsion};
}

CrossForces operator+(const CrossForces& a, const CrossForces& b) {
  return {.N = a.N + b.N,
          .V_y = a.V_y + b.V_y,
          .V_z = a.V_z + b.V_z,
          .M_y = a.M_y + b.M_y,
          .M_z = a.M_z + b.M_z,
          .torsion = a.torsion + b.torsion};
}

int class_of(double slenderness, double limit_1, double limit_2, double limit_3) {
  return slenderness <= limit_1 ? 1 : slenderness <= limit_2 ? 2 : slenderness <= limit_3 ? 3 : 4;
}

std::vector<WallClass> wall_classes(const SectionRow& r, double yield, const CrossForces& f) {
  const double t = r.thickness;
  if (r.shape == SectionShape::chs) {
    const double e2 = reference_yield / yield, slenderness = r.height / t;
    return {{.wall = "tube",
             .slenderness = slenderness,
             .limit_1 = 50 * e2,
             .limit_2 = 70 * e2,
             .limit_3 = 90 * e2,
             .value = class_of(slenderness, 50 * e2, 70 * e2, 90 * e2)}};
  }
  const double M_y = std::abs(f.M_y), M_z = std::abs(f.M_z);
  const double axial = f.N / r.area, y = M_y / r.W_el_y, z = M_z / r.W_el_z;
  const ThinBox box{.web = r.height - t, .flange = r.width - t};
  Pressed pressed{.web = 0, .flange = 0};
  if (M_y > 0 || M_z > 0) {
    pressed = pressed_in(box, f.N / (t * yield), M_y / (M_y + M_z), M_z / (M_y + M_z));
  } else if (f.N > 0) {
    pressed = {.web = box.web, .flange = box.flange};
  }
  const auto wall = [&](const char* name, double side, double length, const WallStress& stress) {
    const double c = side - 3 * t;  // flat, between corners that reach t beyond the middle lines of the walls across
    return wall_class(name, c / t, yield, std::clamp((length - t) / c, 0.0, 1.0), stress);
  };
  return {wall("web", r.height, pressed.web, {.axial = axial, .across = z, .own = y}),
          wall("flange", r.width, pressed.flange, {.axial = axial, .across = y, .own = z})};
}

WallClass section_class(const SectionRow& r, double yield, const CrossForces& f) {
  const std::vector<WallClass> all = wall_classes(r, yield, f);
  const auto next = [](const WallClass& w) {
    return w.slenderness / (w.value == 1 ? w.limit_1 : w.value == 2 ? w.limit_2 : w.limit_3);
  };
  return *std::max_element(all.begin(), all.end(), [&](const WallClass& a, const WallClass& b) {
    return a.value != b.value ? a.value < b.value : next(a) < next(b);
  });
}

WallClass write_class(const SectionRow& r, double yield, const CrossForces& f, Sheet<Num>& s) {
  const WallClass w = section_class(r, yield, f);
  const Num f_y = s.named("f_y", si::Pa, yield), t = s.named("t", si::m.in("mm"), r.thickness);
  const Num f_235 = s.named("f_235", si::Pa, reference_yield);
  s.eq("", "epsilon", si::one, sqrt(f_235 / f_y), table_5_2);
  if (w.wall == "tube") {
    s.eq("", "D/t", si::one, s.named("D", si::m.in("mm"), r.height) / t, table_5_2);
  } else {
    const bool web = w.wall == "web";
    const Num side = s.named(web ? "h" : "b", si::m.in("mm"), web ? r.height : r.width);
    s.eq("", web ? "c_w/t" : "c_f/t", si::one, (side - 3 * t) / t, fmt::format("{}, {}", table_5_2, w.wall));
  }
  s.note([&] {
    return fmt::format("Limits of classes 1, 2, 3 of the {} under these forces: {:.4g}, {:.4g}, {:.4g}: class {}.",
                       w.wall, w.limit_1, w.limit_2, w.limit_3, w.value);
  });
  return w;
}

std::string class_4_words(const SectionRow& r, const WallClass& w) {
  if (w.value < 4) return {};
  return fmt::format(
      "{} is of class 4: {} {:.4g} of its {} is above {:.4g}; its wall buckles before it yields (EN 1993-1-{}), which "
      "is not computed: take a thicker wall, a smaller outside or a lower steel grade",
      r.name, w.wall == "tube" ? "D/t" : "c/t", w.slenderness, w.wall, w.limit_3, w.wall == "tube" ? "6" : "5");
}

}  // namespace taut::structure
