#include "taut/app/exact/friction_drive_exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/app/exact/rope_doubts.hpp"
#include "taut/base/gravity.hpp"
#include "taut/calc/shown.hpp"
#include "taut/methods/friction_drive/rope_strength.hpp"

namespace taut::app {
namespace {

constexpr double usual_modulus = 100e9;  // of steel ropes on the metallic area

double stiffness_of(const friction_drive::Input& in) {
  if (in.rope_stiffness) return *in.rope_stiffness;
  if (in.rope_area) return usual_modulus * *in.rope_area;
  if (const auto rope = rope_of(in)) return usual_modulus * rope->area;
  return std::numeric_limits<double>::infinity();
}

/// `of_method`: which pull of the method it is, where the deck has no take-up.
std::string take_up_words(const friction_drive::Input& in, const solve::BeltDrive& d, const char* of_method,
                          const Display& display) {
  const std::string pull = display.brief(d.pull, si::N);
  if (!in.take_up) return fmt::format("a weight that pulls {}, {}", pull, of_method);
  if (in.take_up->screw) return fmt::format("a screw set to {} at rest", pull);
  return fmt::format("a weight that pulls {}", pull);
}

void add_words(const friction_drive::Input& in, const solve::BeltDrive& d, const solve::BeltDriveState& s,
               const char* of_method, const Display& display, Result& r) {
  r.assumptions.push_back(fmt::format(
      "Exact column: {}; T_1 = r T_2 + P_p, {}; the rope creeps on the last part of the working arc only. Branches "
      "are straight.",
      take_up_words(in, d, of_method, display),
      d.place == solve::LoadPlace::at_idler ? "the idler feels the whole tight tension"
                                            : "the cut lies in the middle of the tight branch"));
  if (std::isinf(d.stiffness)) {
    r.assumptions.emplace_back("No creep is computed: give rope_stiffness, rope_area or rope.");
  } else if (!in.rope_stiffness) {
    r.assumptions.push_back(fmt::format("EA = {}: 100 GPa on the rope's metallic area; give rope_stiffness.",
                                        display.brief(d.stiffness, si::N)));
  }
  if (s.slips) {
    r.warnings.push_back(
        fmt::format("with {} the drive slips: it passes on {} of the {} cutting force; the exact tensions are those at "
                    "the limit of slip",
                    take_up_words(in, d, of_method, display), display.brief(s.load, si::N),
                    display.brief(in.cutting_force, si::N)));
  }
}

FrictionDriveExact values_from(const friction_drive::Input& in, const solve::BeltDrive& d,
                               const solve::BeltDriveState& s) {
  FrictionDriveExact e;
  e.take_up_exact = s.pull;
  e.T_1_exact = s.T_1;
  e.T_2_exact = s.T_2;
  if (in.rope_area) {
    e.sigma_tight_exact = s.T_1 / *in.rope_area;
  } else if (const auto rope = rope_of(in)) {
    e.sigma_tight_exact = s.T_1 / rope->area;
  }
  e.cutting_force_exact = s.load;
  e.slip_arc_exact = s.slip_arc;
  e.arc_used_exact = s.slip_arc / d.working_arc;
  e.slips_exact = s.slips ? 1 : 0;
  if (std::isfinite(d.stiffness)) {
    e.creep_exact = s.creep;
    e.creep_speed_exact = s.creep * in.speed;
  }
  if (d.take_up == solve::TakeUp::screw) e.closure_exact = s.stretch;
  return e;
}

void add_comparisons(const friction_drive::Output& o, const FrictionDriveExact& e, Result& r) {
  const auto add = [&](const char* what, const char* symbol, double paper, double corrected, double exact) {
    r.comparisons.push_back({what, symbol, si::N, paper, corrected, exact,
                             "exact: what the take-up really sets; corrected: the drive that does not slip",
                             shown_below(paper, exact)});
  };
  add("tight branch under the cut", "T_1", o.T_1, o.T_1_no_slip, e.T_1_exact);
  add("slack branch under the cut", "T_2", o.T_2, o.T_2_no_slip, e.T_2_exact);
  add("pull on the idler while it runs", "W", o.P_M, o.takeup_no_slip, e.take_up_exact);
}

}  // namespace

solve::BeltDrive belt_drive(const friction_drive::Input& in, const friction_drive::Output& out) {
  solve::BeltDrive d;
  d.friction = in.friction;
  d.wrap = in.wrap;
  d.working_arc = std::min(out.phi, in.wrap);
  d.momentum_flow = out.c;
  d.idler_loss = in.idler_loss;
  d.load = in.cutting_force;
  d.place =
      in.cut == friction_drive::CutPlace::at_idler ? solve::LoadPlace::at_idler : solve::LoadPlace::in_tight_branch;
  d.stiffness = stiffness_of(in);
  if (in.centre_distance) {
    d.branch = *in.centre_distance;
    d.radius = in.sheave_radius.value_or(0);
  }
  if (!in.take_up) {
    d.pull = std::isfinite(out.takeup_with_idler_loss) ? out.takeup_with_idler_loss : out.takeup_no_slip;
  } else if (in.take_up->screw) {
    d.take_up = solve::TakeUp::screw;
    d.pull = *in.take_up->screw;
  } else {
    d.pull = in.take_up->weight ? *in.take_up->weight : *in.take_up->mass * standard_gravity;
  }
  return d;
}

namespace {

/// Whether the take-up of the deck holds the pull of the sheave with its reserve, as the method has it:
/// m (T_1 - T_2) <= (e - 1)(T_2 - c), as an arc.
void check_grip(const friction_drive::Input& in, const solve::BeltDrive& d, const solve::BeltDriveState& s, Result& r) {
  const char* const name = "grip with the take-up, exact";
  const double m = in.grip_reserve;
  if (s.slips) {
    r.checks.push_back(make_check(
        name, m * in.cutting_force, si::N,
        {.sense = Sense::at_most,
         .limit = s.load,
         .rule = fmt::format("m = {:.4g} times the cutting force against what the slipping drive passes on", m),
         .trust = "derived"}));
    return;
  }
  const double arc = std::log1p(m * (s.T_1 - s.T_2) / (s.T_2 - d.momentum_flow)) / d.friction;
  r.checks.push_back(make_check(
      name, arc, si::rad,
      {.sense = Sense::at_most,
       .limit = d.working_arc,
       .rule = fmt::format("slip arc ln(1 + m (T_1 - T_2)/(T_2 - c))/mu, m = {:.4g}, against the working arc", m),
       .trust = "derived"}));
}

/// rope_mass is with the cutters: more than the bare rope has is no slip, less is one.
void warn_of_values(const friction_drive::Input& in, const solve::BeltDrive& d, double tension, const Display& display,
                    Result& r) {
  MethodRope rope{.name = "rope",
                  .rope = in.rope,
                  .own = {},
                  .tension = tension,
                  .stiffness_key = in.rope_stiffness ? "rope_stiffness" : "rope_area",
                  .metal = in.rope_area.has_value()};
  const auto row = rope_of(in);
  if (row && in.rope_mass < row->mass_per_length) rope.own.mass = in.rope_mass;
  if (in.rope_stiffness || in.rope_area) rope.own.stiffness = d.stiffness;
  warn_of_rope(rope, display, r);
}

/// Adds the exact column to the method's result.
void complete_friction_drive(const friction_drive::Input& in, const friction_drive::Output& out, const Display& display,
                             Result& r) {
  const solve::BeltDrive d = belt_drive(in, out);
  solve::BeltDriveState s;
  const Outcome outcome = solve::solve(d, s);
  if (!outcome.ok()) {
    r.status = outcome.status;
    r.message = outcome.message;
    return;
  }
  const FrictionDriveExact e = values_from(in, d, s);
  if (const auto rope = rope_of(in)) friction_drive::take_tension(*rope, e.T_1_exact, r);
  const bool as_asked = std::isfinite(out.takeup_with_idler_loss);
  add_words(in, d, s,
            as_asked ? "as the method says to build" : "the one without slip, as with the idler loss none is enough",
            display, r);
  warn_of_values(in, d, e.T_1_exact, display, r);
  add_comparisons(out, e, r);
  if (in.take_up) check_grip(in, d, s, r);
  const auto values = values_of(FrictionDriveExact::describe(), &e);
  r.values.insert(r.values.end(), values.begin(), values.end());
}

}  // namespace

Result run_friction_drive(const friction_drive::Input& in, const Display& display) {
  friction_drive::Output out;
  Result r = friction_drive::run(in, out, display);
  if (r.status == Status::ok && out.phi > 0) complete_friction_drive(in, out, display, r);
  return r;
}

const Description& FrictionDriveExact::describe() {
  using Exact = FrictionDriveExact;
  static const Description description = [] {
    Describe<Exact> d;
    d.field(&Exact::take_up_exact, "take_up_exact", "W_exact", si::N, "pull on the idler while the rope runs");
    d.field(&Exact::T_1_exact, "T_1_exact", "T_1_exact", si::N, "tight branch with this take-up");
    d.field(&Exact::T_2_exact, "T_2_exact", "T_2_exact", si::N, "slack branch with this take-up");
    d.field(&Exact::sigma_tight_exact, "sigma_tight_exact", "sigma_exact", si::Pa,
            "stress in the tight branch with this take-up, without bending");
    d.field(&Exact::cutting_force_exact, "cutting_force_exact", "P_exact", si::N,
            "cutting force that the drive transmits; less than given where it slips");
    d.field(&Exact::slip_arc_exact, "slip_arc_exact", "phi_slip", si::rad, "arc on which the rope creeps");
    d.field(&Exact::arc_used_exact, "arc_used_exact", "", si::one, "slip arc over working arc");
    d.field(&Exact::creep_exact, "creep_exact", "", si::one, "creep speed over rope speed, (T_1 - T_2)/EA");
    d.field(&Exact::creep_speed_exact, "creep_speed_exact", "", si::m_per_s, "creep speed");
    d.field(&Exact::slips_exact, "slips_exact", "", si::one, "1: the drive slips on its whole arc; 0: it holds");
    d.field(&Exact::closure_exact, "closure_exact", "", si::one,
            "error of the rope length with a screw take-up, over the length")
        .detail();
    return Description(d);
  }();
  return description;
}

}  // namespace taut::app
