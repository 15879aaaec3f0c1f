#include "taut/structure/section_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

WallClass wall_class(const char* name, double side, double t, double yield, double N, const WallStress& stress) {
  const double epsilon = epsilon_of(yield), c = side - 3 * t;
  const double bends = stress.across + stress.own;
  double alpha = 1, psi = 1;
  if (stress.axial <= 0 && bends == 0) {
    alpha = 0;  // pulled, or without any stress
    psi = -std::numeric_limits<double>::infinity();
  } else if (bends > 0) {
    alpha = std::clamp((1 + N / (2 * c * t * yield) + stress.across / bends) / 2, 0.0, 1.0);
    const double alike = stress.axial + stress.across, most = alike + stress.own;
    psi = most > 0 ? (alike - stress.own) / most : -std::numeric_limits<double>::infinity();
  }
  WallClass w{.wall = name,
              .slenderness = c / t,
              .limit_1 = limit_by_alpha(396, 36, epsilon, alpha),
              .limit_2 = limit_by_alpha(456, 41.5, epsilon, alpha),
              .limit_3 = 0,
              .value = 1};
  // elastic: never stricter than class 2, as plastic and elastic states are compared at unlike moments
  w.limit_3 = std::max(std::isinf(psi) ? psi * psi : limit_by_psi(epsilon, psi), w.limit_2);
  w.value = class_of(w.slenderness, w.limit_1, w.limit_2, w.limit_3);
  return w;
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
  const double axial = f.N / r.area, y = std::abs(f.M_y) / r.W_el_y, z = std::abs(f.M_z) / r.W_el_z;
  return {wall_class("web", r.height, t, yield, f.N, {.axial = axial, .across = z, .own = y}),
          wall_class("flange", r.width, t, yield, f.N, {.axial = axial, .across = y, .own = z})};
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
