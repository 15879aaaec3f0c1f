#include <numbers>

#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
const Unit stiffness = si::N_per_m.in("MN/m");

const std::vector<std::pair<std::string, Operation>> operations = {
    {"lift", Operation::lift}, {"retract", Operation::retract}, {"extend", Operation::extend}};

void describe_geometry(Describe<Sliding>& t) {
  using S = Sliding;
  t.field(&S::retracted_length, "retracted_length", "L_b0", si::m, "boom length for which the overlaps are given")
      .above(0)
      .field(&S::stroke, "stroke", "s_max", si::m, "stroke of section 2 in 1, and of 3 in 2")
      .above(0)
      .field(&S::head_distance, "head_distance", "h_3", si::m,
             "distance of the hoist head from the rear pads of section 3")
      .above(0)
      .field(&S::center_3, "center_3", "c_3", si::m,
             "distance of the centre of gravity of section 3 from its rear pads")
      .field(&S::center_2, "center_2", "c_2", si::m,
             "distance of the centre of gravity of section 2 from its rear pads")
      .field(&S::overlap_23, "overlap_23", "a_23", si::m, "pad distance of sections 2 and 3, boom retracted")
      .above(0)
      .field(&S::overlap_12, "overlap_12", "a_12", si::m, "pad distance of sections 1 and 2, boom retracted")
      .above(0)
      .field(&S::gap, "gap", "e_23", si::m,
             "distance of the rear pads of section 3 ahead of those of section 2, boom retracted")
      .field(&S::pad_height_3, "pad_height_3", "b_3", si::m, "height of section 3 from pad to pad")
      .at_least(0)
      .field(&S::pad_height_2, "pad_height_2", "b_2", si::m, "height of section 2 from pad to pad")
      .at_least(0)
      .field(&S::offset_extension, "offset_extension", "z_1", si::m, "height of the extension ropes above the axis")
      .field(&S::offset_retraction, "offset_retraction", "z_2", si::m, "height of the retraction rope above the axis")
      .field(&S::offset_hoist, "offset_hoist", "z_h", si::m, "height of the hoist head above the axis")
      .field(&S::offset_lead, "offset_lead", "z_k", si::m, "height of the lead line of the hoist above the axis")
      .field(&S::offset_cylinder, "offset_cylinder", "z_c", si::m, "height of the cylinder above the axis");
}

void describe_loads(Describe<Sliding>& t) {
  using S = Sliding;
  t.field(&S::section2_weight, "section2_weight", "G_2", si::N, "weight of section 2")
      .at_least(0)
      .field(&S::sheave_efficiency_1, "sheave_efficiency_1", "eta_1", si::one,
             "efficiency of the sheave of the extension rope")
      .above(0)
      .at_most(1)
      .field(&S::sheave_efficiency_2, "sheave_efficiency_2", "eta_2", si::one,
             "efficiency of the sheave of the retraction rope")
      .above(0)
      .at_most(1)
      .field(&S::extension_length, "extension_length", "l_1h", si::m, "length of half of the extension rope")
      .above(0)
      .field(&S::retraction_length, "retraction_length", "l_2", si::m, "length of the retraction rope")
      .above(0)
      .field(&S::S10, "S10", "S_10", si::N,
             "pretension of the extension rope, one branch; default: 'S10' of the input, else 95.5 kN")
      .at_least(0)
      .field(&S::S20, "S20", "S_20", si::N,
             "pretension of the retraction rope; default: 'S20' of the input, else 187 kN")
      .at_least(0)
      .field(&S::kinetic_friction, "kinetic_friction", "f", si::one, "kinetic friction of the pads")
      .at_least(0)
      .field(&S::static_friction, "static_friction", "f_0", si::one, "static friction of the pads, for slip_angles")
      .at_least(0)
      .field(&S::extension_stiffness, "extension_stiffness", "C_1", stiffness,
             "stiffness of half of the extension rope")
      .above(0)
      .field(&S::retraction_stiffness, "retraction_stiffness", "C_2", stiffness, "stiffness of the retraction rope")
      .above(0)
      .field(&S::minimum_tension, "minimum_tension", "S_low", si::N, "tension below which a rope counts as slack")
      .above(0)
      .field(&S::falls, "falls", "K", si::one, "falls of the hoist tackle; default: 8 when lifting, else 6")
      .at_least(1)
      .field(&S::boom_length, "boom_length", "L_b", si::m, "boom lengths to compute")
      .required()
      .above(0)
      .field(&S::luffing_angle, "luffing_angle", "beta", si::rad, "luffing angles to compute")
      .required()
      .above(-right_angle)
      .at_most(right_angle)
      .field(&S::suspended_weight, "suspended_weight", "G_n", si::N, "weights of hook block and load to compute")
      .required()
      .at_least(0)
      .choice(&S::operation, "operation", operations, "extend, retract, or lift with the boom at rest")
      .record(&S::slip_angles, "slip_angles", "luffing angles at which section 3 slides after a rope has broken");
}

}  // namespace

const Description& Case::describe() {
  static const Description d =
      Describe<Case>()
          .field(&Case::name, "name", "name of the case in tables")
          .choice(&Case::operation, "operation", operations, "lift (boom at rest), retract or extend (the boom)")
          .required()
          .field(&Case::luffing_angle, "luffing_angle", "beta", si::rad, "angle of the boom above the horizontal")
          .required()
          .above(-right_angle)
          .at_most(right_angle)
          .field(&Case::suspended_weight, "suspended_weight", "G_n", si::N, "weight of hook block and load together")
          .required()
          .at_least(0)
          .field(&Case::falls, "falls", "K", si::one, "falls of the hoist tackle")
          .required()
          .at_least(1);
  return d;
}

const Description& Slip::describe() {
  static const Description d =
      Describe<Slip>()
          .field(&Slip::boom_length, "boom_length", "L_b", si::m, "boom length before the rope broke")
          .required()
          .above(0)
          .field(&Slip::suspended_weight, "suspended_weight", "G_n", si::N, "weight of hook block and load together")
          .required()
          .at_least(0)
          .field(&Slip::overlap_change, "overlap_change", "Delta_a", si::m,
                 "change of the overlap of sections 2 and 3 by the jerk (+ pulled in, - pushed out)")
          .field(&Slip::falls, "falls", "K", si::one, "falls of the hoist tackle")
          .at_least(1);
  return d;
}

const Description& Sliding::describe() {
  static const Description d = [] {
    Describe<Sliding> t;
    describe_geometry(t);
    describe_loads(t);
    return Description(t);
  }();
  return d;
}

const Description& Input::describe() {
  static const Description d =
      Describe<Input>()
          .field(&Input::section_weight, "section_weight", "G_3", si::N, "weight of section 3")
          .required()
          .above(0)
          .field(&Input::pad_friction, "pad_friction", "f_0", si::one, "friction coefficient of the pads")
          .required()
          .at_least(0)
          .field(&Input::tackle_efficiency, "tackle_efficiency", "zeta", si::one, "efficiency of the hoist tackle")
          .required()
          .above(0)
          .at_most(1)
          .field(&Input::extension_stiffness, "extension_stiffness", "C_1", stiffness,
                 "stiffness of half of the extension rope")
          .required()
          .above(0)
          .field(&Input::retraction_stiffness, "retraction_stiffness", "C_2", stiffness,
                 "stiffness of the retraction rope")
          .required()
          .above(0)
          .choice(&Input::tensioned_last, "tensioned_last",
                  {{"extension", Rope::extension}, {"retraction", Rope::retraction}}, "rope that was tensioned last")
          .field(&Input::tensioning_steps, "tensioning_steps", "n", si::one, "steps of the alternating tensioning")
          .at_least(0)
          .at_most(1000)
          .field(&Input::slip_friction, "slip_friction", "f_0s", si::one,
                 "static friction of the pads, for slip angles")
          .at_least(0)
          .field(&Input::S10, "S10", "S_10", si::N,
                 "pretension of the extension rope (one branch), checked against (3); default: that of 'sliding'")
          .at_least(0)
          .field(&Input::S20, "S20", "S_20", si::N,
                 "pretension of the retraction rope, checked against (3); default: that of 'sliding'")
          .at_least(0)
          .field(&Input::stiffness_ratio, "stiffness_ratio", "kappa", si::one,
                 "C_2/C_1 as measured (fall of S_2 per rise of S_1), for the corrected stiffness")
          .above(0)
          .record(&Input::cases, "cases", "load cases for which the ropes are tensioned")
          .record(&Input::sliding, "sliding", "quasi-static model of sections 2 and 3 sliding on their pads");
  return d;
}

const Description& Output::describe() {
  static const Description d = [] {
    using O = Output;
    Describe<O> t;
    const auto add = [&t](double O::*member, const char* key, const char* symbol, const Unit& unit, const char* words,
                          const char* from) { t.field(member, key, symbol, unit, words).from(from); };
    t.field(&O::F, "F", "F", si::N,
            "F_1, F_2, ... by case: sum of the longitudinal forces on section 3 except those of the ropes")
        .from("(4)-(5)");
    add(&O::F0_extension, "F0_extension", "F_0e", si::N, "F at horizontal, extension rope tensioned last", "(2)");
    add(&O::F0_retraction, "F0_retraction", "F_0r", si::N, "F at horizontal, retraction rope tensioned last", "(2)");
    add(&O::lambda_1, "lambda_1", "lambda_1", si::one, "part of a change of F that each extension branch takes", "(2)");
    add(&O::lambda_2, "lambda_2", "lambda_2", si::one, "part of a change of F that the retraction rope takes", "(2)");
    add(&O::S10_min, "S10_min", "S_10min", si::N, "least pretension of the extension rope, one branch", "(3)");
    add(&O::S20_min, "S20_min", "S_20min", si::N, "least pretension of the retraction rope", "(3)");
    add(&O::S10_balance, "S10_balance", "S_10b", si::N, "S10 that holds S20_min when tensioned_last is done", "(1)");
    add(&O::S10_set, "S10_set", "S_10set", si::N, "pretension used for the table of cases", "(1)");
    add(&O::S20_set, "S20_set", "S_20set", si::N, "pretension used for the table of cases", "(1)");
    add(&O::F0_set, "F0_set", "F_0", si::N, "F under the pretension used", "(1)");
    add(&O::S10_set_corrected, "S10_set_corrected", "S_10setc", si::N,
        "pretension that settles by the corrected C_1, where section 3 slides", "(1*)");
    add(&O::S20_set_corrected, "S20_set_corrected", "S_20setc", si::N, "the same for the retraction rope", "(1*)");
    add(&O::C1_corrected, "C1_corrected", "C_1c", stiffness, "C_1 from the measured stiffness ratio", "(2*)");
    add(&O::lambda_1_corrected, "lambda_1_corrected", "lambda_1c", si::one, "with the corrected C_1", "(2*)");
    add(&O::lambda_2_corrected, "lambda_2_corrected", "lambda_2c", si::one, "with the corrected C_1", "(2*)");
    add(&O::S10_min_corrected, "S10_min_corrected", "S_10minc", si::N, "with the corrected C_1", "(3*)");
    add(&O::S20_min_corrected, "S20_min_corrected", "S_20minc", si::N, "with the corrected C_1", "(3*)");
    add(&O::S10_balance_corrected, "S10_balance_corrected", "S_10bc", si::N, "with the corrected C_1", "(1)");
    add(&O::beta1_light, "beta1_light", "beta_1l", si::rad,
        "angle above which section 3 slides in without ropes, lightest load of the retract cases, no jamming", "(5)");
    add(&O::beta1_heavy, "beta1_heavy", "beta_1h", si::rad, "the same with the heaviest load", "(5)");
    const char* const model = "sliding model";
    add(&O::Fh, "Fh", "F_h", si::N, "cylinder force at the position with the largest absolute value, + pushes out",
        model);
    add(&O::S1, "S1", "S_1", si::N, "extension rope at that position, one branch at section 3", model);
    add(&O::S2, "S2", "S_2", si::N, "retraction rope at that position, at section 3", model);
    add(&O::Fh_max, "Fh_max", "F_hmax", si::N, "largest cylinder force of the grid", model);
    add(&O::Fh_min, "Fh_min", "F_hmin", si::N, "smallest cylinder force of the grid", model);
    add(&O::S1_max, "S1_max", "S_1max", si::N, "largest tension of the extension rope", model);
    add(&O::S1_min, "S1_min", "S_1min", si::N, "smallest tension of the extension rope", model);
    add(&O::S2_max, "S2_max", "S_2max", si::N, "largest tension of the retraction rope", model);
    add(&O::S2_min, "S2_min", "S_2min", si::N, "smallest tension of the retraction rope", model);
    add(&O::governing_angle, "governing_angle", "beta_g", si::rad, "luffing angle of Fh, S1, S2", model);
    add(&O::governing_length, "governing_length", "L_bg", si::m, "boom length of Fh, S1, S2", model);
    add(&O::governing_weight, "governing_weight", "G_ng", si::N, "suspended weight of Fh, S1, S2", model);
    return Description(t);
  }();
  return d;
}

}  // namespace taut::boom_ropes
