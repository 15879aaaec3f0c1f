#include "taut/methods/friction_drive/friction_drive.hpp"

namespace taut::friction_drive {
namespace {

using Inputs = Describe<Input>;
using Outputs = Describe<Output>;

void describe_grip(Outputs& d) {
  d.field(&Output::euler_ratio, "euler_ratio", "euler_ratio", si::one, "tight over slack branch on the full wrap")
      .from("Euler");
  d.field(&Output::andreev_ratio, "andreev_ratio", "andreev_ratio", si::one, "the same on the working arc")
      .from("Andreev");
  d.field(&Output::phi, "phi", "phi", si::rad, "working arc").from("Andreev");
  d.field(&Output::e, "e", "e", si::one, "exp(mu phi): largest ratio of the branches without the centrifugal tension");
  d.field(&Output::c, "c", "c", si::N, "centrifugal tension q U^2");
}

void describe_paper(Outputs& d) {
  d.field(&Output::P_slack, "P_slack", "P_slack", si::N, "slack branch at the limit of slip").from("(15)");
  d.field(&Output::P_tight, "P_tight", "P_tight", si::N, "tight branch at the limit of slip").from("(16)");
  d.field(&Output::P_tight_printed, "P_tight_printed", "P_tight_printed", si::N, "the same by (13) as printed, wrong")
      .from("(13)");
  d.field(&Output::P_T, "P_T", "P_T", si::N, "pull of the drive at the limit of slip").from("(17)");
  d.field(&Output::P_M, "P_M", "P_M", si::N,
          "initial tension, (18) as derived correctly; the drive slips with it, or lacks its reserve")
      .from("(18) derived");
  d.field(&Output::P_M_printed, "P_M_printed", "P_M_printed", si::N, "initial tension, (18) as printed").from("(18)");
  d.field(&Output::P_M_3_printed, "P_M_3_printed", "P_M_3_printed", si::N,
          "initial tension by (3) as printed, wrong sign")
      .from("(3)");
  d.field(&Output::T_1, "T_1", "T_1", si::N, "tight branch under P_M").from("before (3)");
  d.field(&Output::T_2, "T_2", "T_2", si::N, "slack branch under P_M").from("before (3)");
  d.field(&Output::slip_ratio, "slip_ratio", "slip_ratio", si::one,
          "(T_1 - c)/(T_2 - c) of the paper's branches under P_M; above e they slip")
      .from("(13)");
  d.field(&Output::cutting_force_at_P_M, "cutting_force_at_P_M", "P_p_at_P_M", si::N,
          "largest cutting force that the drive can transmit with P_M");
}

void describe_no_slip(Outputs& d) {
  d.field(&Output::T_1_no_slip, "T_1_no_slip", "T_1_no_slip", si::N, "tight branch of the drive that does not slip");
  d.field(&Output::T_2_no_slip, "T_2_no_slip", "T_2_no_slip", si::N, "slack branch of the drive that does not slip");
  d.field(&Output::takeup_no_slip, "takeup_no_slip", "W_no_slip", si::N,
          "pull on the idler of the drive that does not slip, without the idler loss");
  d.field(&Output::takeup_with_idler_loss, "takeup_with_idler_loss", "W_idler_loss", si::N,
          "the same with the idler loss of (14)");
  d.field(&Output::takeup_15_16, "takeup_15_16", "W_15_16", si::N, "pull on the idler by (15), (16)");
  d.field(&Output::speed_of_lost_grip, "speed_of_lost_grip", "U_lost", si::m_per_s,
          "speed at which a screw take-up set to takeup_no_slip at rest has no grip left");
}

void describe_machine(Outputs& d) {
  d.field(&Output::F_0, "F_0", "F_0", si::N, "tension of each branch at rest under takeup_no_slip");
  d.field(&Output::sigma_0, "sigma_0", "sigma_0", si::Pa, "stress at rest").from("F_0 = A sigma_0");
  d.field(&Output::sigma_tight, "sigma_tight", "sigma_tight", si::Pa,
          "stress in the tight branch by the method, whatever the take-up; without bending");
  d.field(&Output::torque, "torque", "M", si::N_m, "torque of the driving sheave at the limit of slip")
      .from("(1), (2)");
  d.field(&Output::torque_working, "torque_working", "M_working", si::N_m, "torque of the cutting force")
      .from("(1), (2)");
  d.field(&Output::power, "power", "power", si::W, "P_T U: power at the limit of slip");
  d.field(&Output::power_working, "power_working", "power_working", si::W, "P_p U: power into the cut");
  d.field(&Output::diameter_ratio, "diameter_ratio", "D/d", si::one, "sheave diameter over rope diameter");
  d.field(&Output::safety_factor, "safety_factor", "S", si::one, "minimum breaking force over the largest tension");
}

void describe_exact(Inputs& d) {
  d.record(&Input::take_up, "take_up",
           "take-up, for the exact solution; default: takeup_with_idler_loss of the method");
  d.field(&Input::rope_stiffness, "rope_stiffness", "EA", si::N,
          "stiffness EA, for the creep; default: 100 GPa times the area")
      .above(0);
  d.field(&Input::centre_distance, "centre_distance", "", si::m,
          "distance of driving sheave and idler, for the length of the rope with a screw; with sheave_radius the arcs "
          "count too")
      .above(0);
  d.field(&Input::idler_radius, "idler_radius", "", si::m,
          "radius of the idler to the rope's centre: `checks` need it for D/d, groove pressure and life")
      .above(0);
  d.choice(&Input::cut, "cut", {{"at_idler", CutPlace::at_idler}, {"in_tight_branch", CutPlace::in_tight_branch}},
           "place of the cutting force in the exact solution: at_idler (the idler feels the whole tight tension, as in "
           "the method), or in the middle of the tight branch");
}

}  // namespace

const Description& TakeUp::describe() {
  static const Description d =
      Describe<TakeUp>()
          .field(&TakeUp::weight, "weight", "W", si::N, "constant pull on the idler; or give mass or screw")
          .above(0)
          .field(&TakeUp::mass, "mass", "", si::kg, "mass of a weight that pulls the idler")
          .above(0)
          .field(&TakeUp::screw, "screw", "W_0", si::N, "fixed centres: pull on the idler, set at rest without load")
          .above(0)
          .exactly_one({"weight", "mass", "screw"});
  return d;
}

const Description& Input::describe() {
  static const Description description = [] {
    Inputs d;
    d.field(&Input::cutting_force, "cutting_force", "P_p", si::N, "cutting force on the rope").required().above(0);
    d.field(&Input::friction, "friction", "mu", si::one,
            "friction of the rope on the driving sheave; a warning above 0.4")
        .required()
        .above(0)
        .at_most(1.5);
    d.field(&Input::wrap, "wrap", "alpha", si::rad, "wrap angle on the driving sheave")
        .required()
        .above(0)
        .at_most(100);
    d.field(&Input::rope_mass, "rope_mass", "q", si::kg_per_m, "mass per metre of the rope with its cutters")
        .required()
        .at_least(0);
    d.field(&Input::speed, "speed", "U", si::m_per_s, "speed of the rope").required().at_least(0);
    d.field(&Input::grip_reserve, "grip_reserve", "m", si::one, "reliability factor of grip").at_least(1);
    d.field(&Input::section_factor, "section_factor", "k", si::one,
            "k = (1 - nu) S_x^2 / (I_x F) of Andreev's formula; readings: 0.126 or 0.56 for a solid round")
        .at_least(0)
        .at_most(1);
    d.field(&Input::fill_ratio, "fill_ratio", "K_fill", si::one,
            "fill factor of the rope over the largest of its family")
        .at_least(0)
        .at_most(1);
    d.field(&Input::rest_arc, "rest_arc", "alpha_rest", si::rad, "arc of rest m_a d/R, subtracted from the wrap")
        .at_least(0);
    d.field(&Input::idler_loss, "idler_loss", "r", si::one, "factor of idler and bearing losses in (14)").at_least(1);
    d.field(&Input::rope_area, "rope_area", "A", si::m2, "metallic area of the rope; default: that of `rope`").above(0);
    d.field(&Input::sheave_radius, "sheave_radius", "R", si::m, "radius of the driving sheave to the rope's centre")
        .above(0);
    d.field(&Input::rope, "rope",
            "rope of the catalogue, by id or in words: \"6x36-IWRC 16 mm 1960 MPa\"; for stress, D/d, safety factor");
    describe_exact(d);
    return Description(d);
  }();
  return description;
}

const Description& Output::describe() {
  static const Description description = [] {
    Outputs d;
    describe_grip(d);
    describe_paper(d);
    describe_no_slip(d);
    describe_machine(d);
    return Description(d);
  }();
  return description;
}

namespace {

std::vector<Erratum> errata() {
  return {{.where = "(3)",
           .printed = "(P_T + P_p) (e+1)/(e-1)",
           .correct = "(P_T - P_p) (e+1)/(e-1)",
           .evidence = "difference of T_1 and T_2 of the line above; (18) needs the minus",
           .test = "FrictionDriveCase.SignOfEquation3"},
          {.where = "(18)",
           .printed = "no m on the centrifugal term",
           .correct = "c (e+1) (m (e-1)/(e-1.08) - 1)",
           .evidence = "(3) with (15) to (17); both agree for m = 1 only",
           .test = "FrictionDriveCase.PrintedEquation18HoldsForMOneOnly"},
          {.where = "(13)",
           .printed = "P_tight = c + P_slack e",
           .correct = "P_tight = c + (P_slack - c) e",
           .evidence = "numerical integration of dP/d(alpha) = mu (P - c)",
           .test = "FrictionDriveCase.PrintedEquation13IsNotTheIntegral"},
          {.where = "Euler's line and text",
           .printed = "running-on branch and working branch",
           .correct = "one branch, here the tight one",
           .evidence = "the force that the driving sheave draws in",
           .test = "FrictionDriveCase.TightBranchIsDrawnIn"},
          {.where = "T_1, T_2, (18)",
           .printed = "P_M of (18) as initial tension",
           .correct = "takeup_no_slip",
           .evidence = "with P_M the branches break the no-slip condition that the paper starts from",
           .test = "FrictionDriveCase.PaperDriveSlips"}};
}

}  // namespace

const Method& about() {
  static const Method m{
      .name = "friction_drive",
      .title = "Initial tension of a rope-saw and of friction drives in general",
      .source =
          "P. B. Ryabukhin, I. V. Grigoriev, V. A. Ivanov: Calculation method of the initial tension of "
          "the flexible cutting tool of "
          "the saw unit for group bucking. Systems. Methods. Technologies, 2022, no. 2, pp. 48-54, doi "
          "10.18324/2077-5415-2022-2-48-54 (in Russian)",
      .short_source = "Ryabukhin et al. 2022",
      .scope =
          "Branch forces of an endless rope on a driving sheave and an idler pulled by a constant force, "
          "with centrifugal tension, "
          "idler loss and Andreev's working arc; the paper's initial tension and the pull that keeps the "
          "rope from slipping.",
      .limits = {"the tension is the same at every moment: no start, no fluctuation of the cutting force",
                 "constant friction along the arc; a wet, oily or sap-covered rope has far less than 0.4",
                 "the rope has no bending stiffness; its weight on the sheave is left out",
                 "k of Andreev's formula is not settled in the literature: compare the table of readings"},
      .errata = errata()};
  return m;
}

}  // namespace taut::friction_drive
