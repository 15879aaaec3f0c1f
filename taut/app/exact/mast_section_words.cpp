#include <fmt/format.h>

#include "taut/app/exact/mast_section_exact.hpp"

namespace taut::app {
namespace {

using Exact = MastSectionExact;

void describe_position(Describe<Exact>& d) {
  const Unit mm = si::m.in("mm");
  d.field(&Exact::N_exact, "N_exact", "N_exact", si::N, "axial force at the foot with guys and second order");
  d.field(&Exact::Q_exact, "Q_exact", "Q_exact", si::N, "horizontal force at the foot with guys");
  d.field(&Exact::M_exact, "M_exact", "M_exact", si::N_m, "moment at the foot with guys and second order");
  d.field(&Exact::M_max_exact, "M_max_exact", "M_max_exact", si::N_m, "largest bending moment along the mast");
  d.field(&Exact::M_max_height_exact, "M_max_height_exact", "z_M", si::m, "height of the largest bending moment");
  d.field(&Exact::top_displacement_exact, "top_displacement_exact", "u_top", mm, "horizontal displacement of the top");
  d.field(&Exact::top_x_exact, "top_x_exact", "u_x", mm, "displacement of the top towards the span").detail();
  d.field(&Exact::top_y_exact, "top_y_exact", "u_y", mm, "displacement of the top normal to the span, to its left")
      .detail();
  d.field(&Exact::top_drop_exact, "top_drop_exact", "u_z", mm, "drop of the top by shortening and bending").detail();
  d.field(&Exact::sigma_exact, "sigma_exact", "sigma_exact", si::Pa, "largest stress along the mast");
  d.field(&Exact::sigma_height_exact, "sigma_height_exact", "z_sigma", si::m, "height of the largest stress");
}

void describe_worst(Describe<Exact>& d) {
  d.field(&Exact::sigma_worst_exact, "sigma_worst_exact", "sigma_worst", si::Pa,
          "largest stress along the mast at any carriage position");
  const char* const all = "of all load cases";
  d.field(&Exact::M_worst_exact, "M_worst_exact", "M_worst", si::N_m,
          fmt::format("largest moment at the foot {}", all));
  d.field(&Exact::N_worst_exact, "N_worst_exact", "N_worst", si::N,
          fmt::format("largest axial force at the foot {}", all));
  d.field(&Exact::N_least_exact, "N_least_exact", "N_least", si::N,
          fmt::format("least axial force at the foot {}; below 0 the foot is pulled up", all))
      .detail();
  d.field(&Exact::Q_worst_exact, "Q_worst_exact", "Q_worst", si::N,
          fmt::format("largest horizontal force at the foot {}", all));
  d.field(&Exact::guy_tension_max_exact, "guy_tension_max_exact", "T_guy", si::N,
          "largest tension of any guy at any carriage position and as it is put up");
  d.field(&Exact::guy_safety_min_exact, "guy_safety_min_exact", "S_guy", si::one,
          "smallest safety factor of any guy at any carriage position and as it is put up");
  d.field(&Exact::buckling_factor_exact, "buckling_factor_exact", "alpha_cr", si::one,
          "least factor of the axial force at which the mast, held by its guys, buckles, at any carriage position");
  d.field(&Exact::slack_guys_exact, "slack_guys_exact", "", si::one, "number of slack guys");
  d.field(&Exact::force_balance_exact, "force_balance_exact", "", si::N,
          "resultant of all forces on the mast (0 in equilibrium), worst position")
      .detail();
  d.field(&Exact::moment_balance_exact, "moment_balance_exact", "", si::N_m,
          "resultant of all moments about the foot (0 in equilibrium), worst position")
      .detail();
  d.field(&Exact::guy_closure_exact, "guy_closure_exact", "", si::m,
          "distance of a guy's computed end from its place, worst guy and position")
      .detail();
}

}  // namespace

const Description& MastSectionExact::describe() {
  static const Description description = [] {
    Describe<Exact> d;
    describe_position(d);
    describe_worst(d);
    return Description(d);
  }();
  return description;
}

}  // namespace taut::app
