#include "taut/app/exact/mast_wall.hpp"

#include <fmt/format.h>

#include <cmath>

namespace taut::app {

structure::WallClass wall_of(const mast_section::Input& in, const catalogue::SectionRow& section, double yield,
                             const mast_section::ClampForces& f) {
  return structure::section_class(section, yield, {.N = f.N, .M_y = mast_section::is_beyond_method(in) ? 0 : f.M});
}

namespace {

/// Of all load cases the wall that is nearest to class 4.
structure::WallClass worst_wall(const mast_section::Input& in, const mast_section::Solved& method, double yield) {
  structure::WallClass worst;
  for (const mast_section::ClampForces& f : method.forces) {
    const structure::WallClass one = wall_of(in, method.section->section, yield, f);
    if (worst.limit_3 == 0 || one.slenderness * worst.limit_3 > worst.slenderness * one.limit_3) worst = one;
  }
  return worst;
}

/// The yield stress up to which no wall is of class 4, of a steel that has at least `least` and at most `most`, Pa.
double yield_of_class_3(const mast_section::Input& in, const mast_section::Solved& method, double least, double most) {
  constexpr double step = 1e6;  // Pa: steels are graded by whole MPa
  const int steps = static_cast<int>((most - least) / step);
  for (int k = 1; k <= steps; ++k) {
    if (worst_wall(in, method, least + k * step).value > 3) return least + (k - 1) * step;
  }
  return least + steps * step;
}

}  // namespace

void check_wall(const mast_section::Input& in, const mast_section::Solved& method, Result& r) {
  const mast_section::Assessment& a = *method.section;
  const mast_section::StressLimit limit = mast_section::limit_of(in);
  const double least = a.allowable * limit.safety, most = mast_section::largest_yield(limit, a.section, a.allowable);
  const structure::WallClass wall = worst_wall(in, method, least);
  if (wall.value <= 3) {
    if (most <= least || worst_wall(in, method, most).value <= 3) return;
    r.unmade.push_back(fmt::format(
        "wall of {}: it yields before it buckles (EN 1993-1-1, class 3) up to a yield stress of {:.0f} MPa, and "
        "allowable_stress does not say the steel: give steel and safety in its place",
        a.section.name, std::floor(yield_of_class_3(in, method, least, most) / 1e6)));
    return;
  }
  Check c =
      make_check(fmt::format("wall of {}", a.section.name), wall.slenderness, si::one,
                 {.sense = Sense::at_most,
                  .limit = wall.limit_3,
                  .rule = fmt::format("{} of the {}, class {}{}: up to class 3, EN 1993-1-1, table 5.2{}",
                                      wall.wall == "tube" ? "D/t" : "c/t", wall.wall, wall.value,
                                      limit.given ? " with allowable_stress as yield stress, which is no less" : "",
                                      in.choose_section ? "; give a smaller 'largest_slenderness'" : ""),
                  .trust = "UNVERIFIED: EN 1993-1-1, table 5.2, recalled"});
  c.part = "mast";
  c.limits = false;
  r.checks.push_back(std::move(c));
}

}  // namespace taut::app
