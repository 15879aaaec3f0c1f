
#include "taut/math/degree.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"

namespace taut::closed_loop {
namespace {

void describe_line(Describe<Input>& d) {
  d.field(&Input::span, "span", "l", si::m, "horizontal distance of the supports A (winch) and B (tail sheave)")
      .required()
      .above(0);
  d.field(&Input::slope, "slope", "alpha_s", si::rad,
          "slope of the chord from A to B; + when B is higher (downhill work)")
      .above(-60 * degree)
      .below(60 * degree);
  d.field(&Input::height_difference, "height_difference", "h", si::m,
          "height of B above A, in place of slope (negative when B is lower)");
  d.field(&Input::position, "position", "x", si::m,
          "horizontal distance from A to the carriage, one or a list; default: midspan")
      .above(0);
  d.choice(&Input::mode, "mode",
           {{"sag", Mode::sag},
            {"winch_pull", Mode::winch_pull},
            {"loop_length", Mode::loop_length},
            {"free_running", Mode::free_running}},
           "what is given: the sag, the winch pull, the length of the loop, or that the return rope runs freely at the "
           "carriage");
  d.field(&Input::sag, "sag", "f", si::m, "vertical sag of the lower branch at the carriage, under the chord").above(0);
  d.field(&Input::winch_pull, "winch_pull", "W", si::N, "pull of the winch on the traction rope (mode winch_pull)")
      .above(0);
  d.field(&Input::head_efficiency, "head_efficiency", "eta_A", si::one,
          "efficiency of the traction rope's sheaves at A: T_lA = winch_pull * head_efficiency hauled in, winch_pull / "
          "head_efficiency hauled out")
      .above(0)
      .at_most(1);
  d.field(&Input::loop_length, "loop_length", "L", si::m, "unstretched length of the whole loop (mode loop_length)")
      .above(0);
}

void describe_load(Describe<Input>& d) {
  d.field(&Input::gathering_force, "gathering_force", "S", si::N, "force in the gathering line").required().above(0);
  d.field(&Input::gathering_angle, "gathering_angle", "gamma", si::rad,
          "angle of the gathering line, down and toward B, measured from the line that gathering_angle_from names")
      .required()
      .at_least(0)
      .at_most(90 * degree);
  d.choice(&Input::gathering_angle_from, "gathering_angle_from",
           {{"vertical", AngleFrom::vertical}, {"horizontal", AngleFrom::horizontal}},
           "line from which gathering_angle is measured");
  d.field(&Input::return_weight, "return_weight", "q_b", si::N_per_m, "weight of the return rope per metre of rope")
      .above(0);
  d.field(&Input::traction_weight, "traction_weight", "q_T", si::N_per_m,
          "weight of the traction rope per metre of rope")
      .above(0);
  d.field(
      &Input::return_rope, "return_rope",
      "return rope of the catalogue, by id or by its properties, 6x36-IWRC 16 mm 1960 MPa; in place of return_weight");
  d.field(&Input::traction_rope, "traction_rope",
          "traction rope of the catalogue, by id or by its properties; in place of traction_weight");
  d.field(&Input::tail_efficiency, "tail_efficiency", "eta", si::one, "efficiency of one sheave at B")
      .required()
      .above(0)
      .at_most(1);
  d.field(&Input::tail_sheaves, "tail_sheaves", "", si::one, "number of such sheaves at B, one after the other")
      .at_least(1)
      .at_most(20);
}

void describe_carriage(Describe<Input>& d) {
  d.choice(&Input::carriage, "carriage", {{"single", Carriage::single}, {"two_section", Carriage::two_section}},
           "single, or two_section: rollers and clamp ahead, the gathering line on a second section behind them");
  d.field(&Input::section_distance, "section_distance", "d", si::m, "distance of the two sections").above(0);
  d.choice(&Input::distance_kind, "distance_kind",
           {{"horizontal", DistanceKind::horizontal}, {"rope", DistanceKind::rope}},
           "section_distance is a horizontal distance, or the length of the rope between the sections");
  d.choice(&Input::sag_of, "sag_of", {{"first", Section::first}, {"second", Section::second}},
           "the section at which sag is given");
  d.choice(&Input::position_of, "position_of", {{"first", Section::first}, {"second", Section::second}},
           "the section at which position is given");
  d.field(&Input::branch_distance, "branch_distance", "c", si::m, "distance of the upper branch from the lower one")
      .at_least(0);
  d.choice(&Input::branch_offset, "branch_offset",
           {{"normal", BranchOffset::normal}, {"vertical", BranchOffset::vertical}},
           "direction of that distance: normal to the chord, or vertical");
  d.field(&Input::carriage_weight, "carriage_weight", "W_c", si::N, "weight of the carriage").at_least(0);
  d.field(&Input::return_stiffness, "return_stiffness", "EA_b", si::N, "tensile stiffness EA of the return rope")
      .above(0)
      .may_be_infinite();
  d.field(&Input::traction_stiffness, "traction_stiffness", "EA_T", si::N, "tensile stiffness EA of the traction rope")
      .above(0)
      .may_be_infinite();
  d.choice(&Input::roller, "roller", {{"free", Roller::free}, {"vertical", Roller::vertical}},
           "free: the roller force is normal to the rope; vertical: it is vertical, as in the paper");
  d.choice(&Input::haul, "haul", {{"in", Haul::in}, {"out", Haul::out}},
           "in: T_uB = eta T_lB, the load moves to the winch; out: the opposite");
}

void describe_sizing(Describe<Input>& d) {
  d.field(&Input::safety_factor, "safety_factor", "n", si::one,
          "least breaking force / largest tension; it has no default")
      .above(1);
  d.field(&Input::wire_strength, "wire_strength", "sigma_pa", si::Pa,
          "minimum breaking force / metallic area of the rope (not the wire grade)")
      .above(0);
  d.field(&Input::weight_per_area, "weight_per_area", "k", si::N_per_m3,
          "rope weight per metre and metallic area; the paper's 0.01 kgf/(m mm^2)")
      .above(0);
  d.record(&Input::choose_ropes, "choose_ropes",
           "chooses the smallest catalogue ropes that pass safety_factor with their own weight");
  d.field(&Input::clearance, "clearance", "", si::m, "largest sag that the ground allows at the carriage").above(0);
}

}  // namespace

const Description& RopeFilter::describe() {
  static const Description d =
      Describe<RopeFilter>()
          .field(&RopeFilter::construction, "construction", "construction, such as 6x36; default: any")
          .field(&RopeFilter::core, "core", "core, FC, IWRC or WSC; default: any")
          .field(&RopeFilter::grade, "grade", "R", si::Pa, "nominal wire strength; default: any")
          .above(0);
  return d;
}

const Description& Input::describe() {
  static const Description all = [] {
    Describe<Input> d;
    describe_line(d);
    describe_load(d);
    describe_carriage(d);
    describe_sizing(d);
    return Description(d);
  }();
  return all;
}

namespace {

void describe_paper(Describe<Output>& d) {
  d.field(&Output::x, "x", "x", si::m, "position of the carriage for these values");
  d.field(&Output::f, "f", "f", si::m, "sag at the carriage");
  d.field(&Output::f_second, "f_second", "f_second", si::m, "a deeper sag with the same tension");
  d.field(&Output::q_b, "q_b", "q_b", si::N_per_m, "weight of the return rope").detail();
  d.field(&Output::q_T, "q_T", "q_T", si::N_per_m, "weight of the traction rope").detail();
  d.field(&Output::P, "P", "P", si::N, "load across the chord, with the carriage's weight").from("(3)");
  d.field(&Output::K, "K", "K", si::N, "pull along the chord").from("(2)");
  d.field(&Output::P_b, "P_b", "P_b", si::N, "load on the upper branch, oblique (two sections: corrected system)")
      .from("(1); (11*)-(16*)");
  d.field(&Output::P_b_no_weight, "P_b_no_weight", "P_b0", si::N, "the same without rope weights").from("(1), (4)");
  d.field(&Output::T_b, "T_b", "T_b", si::N, "tension of the upper branch, oblique").from("(5), (11)");
  d.field(&Output::T_n, "T_n", "T_n", si::N, "tension of the traction rope at the carriage, oblique").from("(6*)");
  d.field(&Output::T_up, "T_up", "T_up", si::N, "upper branch at its upper support, by the paper").from("(7)");
  d.field(&Output::T_lA_paper, "T_lA_paper", "T_lA_paper", si::N, "lower branch at A, by the paper, repaired")
      .from("(9*)");
  d.field(&Output::P_b_4_printed, "P_b_4_printed", "P_b_4_printed", si::N, "(4) as printed, with - 2l")
      .from("(4)")
      .detail();
  d.field(&Output::T_n_printed, "T_n_printed", "T_n_printed", si::N, "(6) as printed, with cos(gamma) and T_b")
      .from("(6)")
      .detail();
  d.field(&Output::T_lA_printed, "T_lA_printed", "T_lA_printed", si::N, "(9) as printed, without the factor 4")
      .from("(9)")
      .detail();
  d.field(&Output::delta_f, "delta_f", "delta_f", si::m, "sag of section 2 under the line from section 1 to B")
      .from("(11*)-(16*)");
  d.field(&Output::P_b_printed, "P_b_printed", "P_b_printed", si::N, "(11)-(16) as printed, unrounded")
      .from("(11)-(16)")
      .detail();
  d.field(&Output::delta_f_printed, "delta_f_printed", "delta_f_printed", si::m, "(11)-(16) as printed, unrounded")
      .from("(11)-(16)")
      .detail();
}

void describe_sections(Describe<Output>& d) {
  d.field(&Output::x_1, "x_1", "x_1", si::m, "position of section 1").from("closed-form tier");
  d.field(&Output::x_2, "x_2", "x_2", si::m, "position of section 2").from("closed-form tier");
  d.field(&Output::f_1, "f_1", "f_1", si::m, "sag at section 1").from("closed-form tier");
  d.field(&Output::f_2, "f_2", "f_2", si::m, "sag at section 2").from("closed-form tier");
}

void describe_closed(Describe<Output>& d) {
  d.field(&Output::N, "N", "N", si::N, "roller force on the upper branch").from("closed-form tier");
  d.field(&Output::P_v, "P_v", "P_v", si::N, "its vertical part").from("closed-form tier");
  d.field(&Output::P_b_closed, "P_b_closed", "P_b_closed", si::N, "its oblique part, to compare with P_b")
      .from("closed-form tier")
      .detail();
  d.field(&Output::delta_f_closed, "delta_f_closed", "delta_f_closed", si::m,
          "sag of section 2 under the line from section 1 to B")
      .from("closed-form tier")
      .detail();
  d.field(&Output::phi, "phi", "phi", si::rad,
          "inclination of the link from clamp to roller, positive when its top is toward A")
      .from("closed-form tier");
  d.field(&Output::T_uA, "T_uA", "T_uA", si::N, "upper branch at A").from("closed-form tier");
  d.field(&Output::T_uB, "T_uB", "T_uB", si::N, "upper branch at B").from("closed-form tier");
  d.field(&Output::T_lA, "T_lA", "T_lA", si::N, "lower branch (traction rope) at A").from("closed-form tier");
  d.field(&Output::T_lB, "T_lB", "T_lB", si::N, "lower branch (return rope) at B").from("closed-form tier");
  d.field(&Output::T_U, "T_U", "T_U", si::N, "upper branch at the carriage").from("closed-form tier");
  d.field(&Output::T_lLA, "T_lLA", "T_lLA", si::N, "traction rope at the carriage").from("closed-form tier");
  d.field(&Output::T_lLB, "T_lLB", "T_lLB", si::N, "return rope of the lower branch at the carriage")
      .from("closed-form tier");
  d.field(&Output::T_12, "T_12", "T_12", si::N, "return rope between the sections").from("closed-form tier");
  d.field(&Output::T_winch, "T_winch", "T_winch", si::N, "traction rope at the winch, behind the sheaves at A")
      .from("closed-form tier");
  d.field(&Output::H_1, "H_1", "H_1", si::N, "horizontal tension of the lower branch between A and the carriage")
      .from("closed-form tier")
      .detail();
  d.field(&Output::H_2, "H_2", "H_2", si::N, "horizontal tension of the lower branch between the carriage and B")
      .from("closed-form tier")
      .detail();
  d.field(&Output::H_3, "H_3", "H_3", si::N, "horizontal tension of the upper branch between A and the carriage")
      .from("closed-form tier")
      .detail();
  d.field(&Output::H_4, "H_4", "H_4", si::N, "horizontal tension of the upper branch between the carriage and B")
      .from("closed-form tier")
      .detail();
  d.field(&Output::T_end_max, "T_end_max", "T_end_max", si::N, "largest of the four end tensions at this position")
      .from("closed-form tier");
}

void describe_areas(Describe<Output>& d) {
  d.field(&Output::f_midspan, "f_midspan", "f_m", si::m, "sag with the carriage at midspan, that the areas take");
  d.field(&Output::F_return_paper, "F_return_paper", "F_return_paper", si::m2,
          "metallic area of the return rope, paper")
      .from("(8)");
  d.field(&Output::F_traction_paper, "F_traction_paper", "F_traction_paper", si::m2,
          "metallic area of the traction rope, paper")
      .from("(10)");
  d.field(&Output::F_return, "F_return", "F_return", si::m2, "metallic area of the return rope, corrected")
      .from("(8*)");
  d.field(&Output::F_traction, "F_traction", "F_traction", si::m2, "metallic area of the traction rope, corrected")
      .from("(10*)");
  d.field(&Output::safety_factor_return_paper, "safety_factor_return_paper", "n_8", si::one,
          "safety factor that the area by (8) has with its own weight")
      .from("closed-form tier");
  d.field(&Output::safety_factor_traction_paper, "safety_factor_traction_paper", "n_10", si::one,
          "safety factor that the area by (10) has with its own weight")
      .from("closed-form tier");
}

void describe_exact(Describe<Output>& d) {
  const auto add = [&](double Output::*at, const char* name, const Unit& unit, const char* words) {
    d.field(at, name, name, unit, words).from("exact catenaries");
  };
  const auto add_detail = [&](double Output::*at, const char* name, const Unit& unit, const char* words) {
    add(at, name, unit, words);
    d.detail();
  };
  add(&Output::P_b_exact, "P_b_exact", si::N, "load on the upper branch, oblique");
  add_detail(&Output::P_v_exact, "P_v_exact", si::N, "vertical part of the roller force on the upper branch");
  add_detail(&Output::N_exact, "N_exact", si::N, "roller force on the upper branch");
  add_detail(&Output::phi_exact, "phi_exact", si::rad,
             "inclination of the link from clamp to roller, positive when its top is toward A");
  add(&Output::T_uA_exact, "T_uA_exact", si::N, "upper branch at A");
  add(&Output::T_uB_exact, "T_uB_exact", si::N, "upper branch at B");
  add(&Output::T_lA_exact, "T_lA_exact", si::N, "lower branch (traction rope) at A");
  add(&Output::T_lB_exact, "T_lB_exact", si::N, "lower branch (return rope) at B");
  add_detail(&Output::T_U_exact, "T_U_exact", si::N, "upper branch at the carriage, the tighter side");
  add_detail(&Output::T_lLA_exact, "T_lLA_exact", si::N, "traction rope at the carriage");
  add_detail(&Output::T_lLB_exact, "T_lLB_exact", si::N, "return rope of the lower branch at the carriage");
  add_detail(&Output::T_12_exact, "T_12_exact", si::N, "return rope between the sections, its larger end");
  add(&Output::T_winch_exact, "T_winch_exact", si::N, "traction rope at the winch, behind the sheaves at A");
  add(&Output::T_max, "T_max", si::N,
      "largest tension of both ropes, anywhere and at the winch, over all positions that have an answer, hauled in and "
      "out");
  add(&Output::delta_f_exact, "delta_f_exact", si::m, "sag of section 2 under the line from section 1 to B");
  add(&Output::upper_sag_exact, "upper_sag_exact", si::m, "sag of the upper branch at the roller, under its own chord");
  add(&Output::loop_length_exact, "loop_length_exact", si::m, "unstretched length of the whole loop");
  add(&Output::traction_length_exact, "traction_length_exact", si::m,
      "unstretched length of the traction rope between A and the carriage");
  add(&Output::return_length_exact, "return_length_exact", si::m,
      "unstretched length of the return rope from the carriage over B to A");
  add_detail(&Output::residual_exact, "residual_exact", si::one,
             "largest unbalanced force at a node, over the largest tension; 1e-12: rounding level");
  add_detail(&Output::closure_exact, "closure_exact", si::one,
             "largest distance of the end of a rope from its node, over the span; 1e-12: rounding level");
}

}  // namespace

const Description& Output::describe() {
  static const Description all = [] {
    Describe<Output> d;
    describe_paper(d);
    describe_sections(d);
    describe_closed(d);
    describe_areas(d);
    describe_exact(d);
    return Description(d);
  }();
  return all;
}

}  // namespace taut::closed_loop
