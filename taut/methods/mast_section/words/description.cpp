#include <fmt/format.h>

#include <numbers>

#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/methods/mast_section/position.hpp"

namespace taut::mast_section {

const Description& Span::describe() {
  static const Description d =
      Describe<Span>()
          .field(&Span::length, "length", "l", si::m, "span of the line, horizontal")
          .required()
          .above(0)
          .field(&Span::chord_slope, "chord_slope", "psi", si::rad,
                 "slope of the chord, positive when it falls away from the mast")
          .above(-std::numbers::pi / 2)
          .below(std::numbers::pi / 2)
          .field(&Span::carriage_position, "carriage_position", "x", si::m,
                 "horizontal distance of the carriage from the mast; of a list the worst one governs")
          .required()
          .above(0)
          .field(&Span::rope_weight, "rope_weight", "w", si::N_per_m, "weight of the skyline per metre")
          .required()
          .at_least(0)
          .field(&Span::load, "load", "Q_load", si::N, "load on the skyline: carriage, lifted share of the load, ropes")
          .required()
          .at_least(0)
          .field(&Span::horizontal_tension, "horizontal_tension", "H", si::N,
                 "horizontal component of the skyline's tension")
          .required()
          .above(0);
  return d;
}

const Description& ChooseSection::describe() {
  static const Description d =
      Describe<ChooseSection>()
          .choice(&ChooseSection::shape, "shape",
                  {{"any", SectionKind::any},
                   {"CHS", SectionKind::chs},
                   {"SHS", SectionKind::shs},
                   {"RHS", SectionKind::rhs}},
                  "kind of section; any: the lightest of all")
          .choice(&ChooseSection::forming, "forming",
                  {{"any", FormingChoice::any},
                   {"hot", FormingChoice::hot},
                   {"cold", FormingChoice::cold},
                   {"seamless", FormingChoice::seamless},
                   {"welded", FormingChoice::welded}},
                  "hot-finished, cold-formed; GOST: seamless, welded")
          .field(&ChooseSection::standard, "standard", "beginning of the standard's name: EN 10210, GOST")
          .choice(&ChooseSection::least_trust, "least_trust",
                  {{"verified", LeastTrust::verified},
                   {"derived", LeastTrust::derived},
                   {"unverified", LeastTrust::unverified}},
                  "least trust of the section's numbers")
          .field(&ChooseSection::largest_slenderness, "largest_slenderness", "", si::one,
                 "largest ratio of outer size to wall; thinner walls may buckle locally below the yield stress")
          .above(0);
  return d;
}

const Description& GuyInstall::describe() {
  static const Description d =
      Describe<GuyInstall>()
          .field(&GuyInstall::tension, "tension", "T_0", si::N, "tension while the mast is vertical and unloaded")
          .required()
          .above(0)
          .choice(&GuyInstall::at, "at", {{"top", GuyEnd::top}, {"anchor", GuyEnd::anchor}},
                  "the end that has this tension");
  return d;
}

const Description& Guy::describe() {
  static const Description d =
      Describe<Guy>()
          .field(&Guy::rope, "rope", "rope of the catalogue, by id or by its properties; or give stiffness and weight")
          .field(&Guy::stiffness, "stiffness", "EA", si::N, "stiffness EA; default: modulus times area")
          .above(0)
          .field(&Guy::modulus, "modulus", "E", si::Pa, "modulus of the rope on its metallic area")
          .above(0)
          .field(&Guy::weight, "weight", "w", si::N_per_m, "weight per metre; default: that of the rope")
          .at_least(0)
          .field(&Guy::breaking_force, "breaking_force", "F_min", si::N,
                 "minimum breaking force; default: that of the rope")
          .above(0)
          .field(&Guy::plan_angle, "plan_angle", "", si::rad,
                 "direction of the anchor in plan, counter-clockwise from the direction of the span; 180 deg: behind "
                 "the mast")
          .required()
          .at_least(-2 * std::numbers::pi)
          .at_most(2 * std::numbers::pi)
          .field(&Guy::anchor_distance, "anchor_distance", "", si::m,
                 "horizontal distance of the anchor from the axis of the mast")
          .required()
          .above(0)
          .field(&Guy::anchor_height, "anchor_height", "", si::m,
                 "height of the anchor above the clamp; negative below it")
          .field(&Guy::attachment_height, "attachment_height", "", si::m,
                 "height of the upper end of the guy above the clamp; default: that of the higher block")
          .above(0)
          .record(&Guy::install, "install", "installed tension; or give length")
          .shorthand("tension")
          .field(&Guy::length, "length", "L_0", si::m, "unstretched length; or give install")
          .above(0)
          .field(&Guy::may_slack, "may_slack", "true: it may go slack without an unsafe warning")
          .exactly_one({"install", "length"});
  return d;
}

const Description& Input::describe() {
  static const Description d =
      Describe<Input>()
          .field(&Input::skyline_force, "skyline_force", "T_sky", si::N, "largest force in the skyline")
          .required()
          .above(0)
          .field(&Input::mainline_force, "mainline_force", "T_main", si::N, "largest force in the mainline")
          .required()
          .at_least(0)
          .field(&Input::skyline_block_height, "skyline_block_height", "h_sky", si::m,
                 "height of the skyline block above the clamp")
          .required()
          .above(0)
          .field(&Input::mainline_block_height, "mainline_block_height", "h_main", si::m,
                 "height of the mainline block above the clamp; default: as the skyline's")
          .above(0)
          .field(&Input::block_friction, "block_friction", "f", si::one,
                 "friction of the rope on the block; the paper: 0.10 to 0.16")
          .at_least(0)
          .at_most(0.5)
          .choice(&Input::wrap, "wrap", {{"geometric", Wrap::geometric}, {"paper", Wrap::paper}},
                  "wrap angle on the block: 90 deg + alpha, or the paper's 120 deg for any alpha")
          .field(&Input::paid_out_force, "paid_out_force", "T_out", si::N,
                 "largest force of a rope while it is paid out, at which its brake slips; default: the full force")
          .above(0)
          .field(&Input::branch_angle, "branch_angle", "alpha", si::rad,
                 "angle of the span side of the ropes below the horizontal, negative when it rises; or give span")
          .at_least(least_branch_angle)
          .at_most(largest_branch_angle)
          .record(&Input::span, "span", "the span, from which the branch angle follows; or give branch_angle")
          .field(&Input::allowable_stress, "allowable_stress", "[sigma]", si::Pa,
                 "allowable stress; or give steel and safety")
          .above(0)
          .field(&Input::steel, "steel", "steel grade of the catalogue, EN 10210-1 S355H; with safety")
          .field(&Input::safety, "safety", "n", si::one,
                 "yield stress over allowable stress; by second order also what the ropes' forces are multiplied by")
          .at_least(1)
          .field(&Input::tube_ratio, "tube_ratio", "c", si::one, "inner over outer diameter of the tube")
          .at_least(0)
          .below(1)
          .field(&Input::section, "section", "catalogue section to check, CHS 508x16; RHS about the strong axis")
          .record(&Input::choose_section, "choose_section", "which catalogue sections may be chosen; or give section")
          .record(&Input::guys, "guys", "guylines, for the exact solution; not in the published method")
          .field(&Input::lateral_force, "lateral_force", "P_y", si::N,
                 "horizontal force normal to the span at the skyline block, to the left when looking towards the span, "
                 "for the exact solution: haulback rope, wind")
          .choice(&Input::base, "base", {{"clamped", Base::clamped}, {"hinged", Base::hinged}},
                  "foot of the mast in the exact solution; hinged needs guys");
  return d;
}

namespace {

void describe_forces(Describe<Output>& d) {
  d.field(&Output::x, "x", "x", si::m, "governing carriage position");
  d.field(&Output::f_x, "f_x", "f_x", si::m, "sag of the skyline at the carriage").from("(11)");
  d.field(&Output::alpha, "alpha", "alpha", si::rad, "angle of the span side below the horizontal").from("(10)");
  d.field(&Output::wrap, "wrap", "epsilon", si::rad, "wrap angle of the rope on its block");
  d.field(&Output::F_span_sky, "F_span_sky", "F_span_sky", si::N, "skyline force on the span side").from("(1)");
  d.field(&Output::R_sky, "R_sky", "R_sky", si::N, "resultant on the skyline block").from("(4), (5)");
  d.field(&Output::gamma_sky, "gamma_sky", "gamma_sky", si::rad, "angle of R_sky below the horizontal")
      .from("(8), (9) corrected");
  d.field(&Output::gamma_sky_printed, "gamma_sky_printed", "gamma_sky_printed", si::rad,
          "the same by (9) as printed, wrong")
      .from("(9)");
  d.field(&Output::F_span_main, "F_span_main", "F_span_main", si::N, "mainline force on the span side").from("(1)");
  d.field(&Output::R_main, "R_main", "R_main", si::N, "resultant on the mainline block").from("(4), (6)");
  d.field(&Output::gamma_main, "gamma_main", "gamma_main", si::rad, "angle of R_main below the horizontal")
      .from("(8), (9) corrected");
  d.field(&Output::N, "N", "N", si::N, "axial force at the clamp, compression positive").from("figure 7");
  d.field(&Output::M, "M", "M", si::N_m, "bending moment at the clamp, towards the span").from("figure 7");
  d.field(&Output::Q, "Q", "Q", si::N, "shear at the clamp, towards the span").from("figure 7");
}

void describe_sizes(Describe<Output>& d) {
  d.field(&Output::sigma_allow, "sigma_allow", "[sigma]", si::Pa, "allowable stress used");
  d.field(&Output::b_square, "b_square", "b_square", si::m.in("mm"), "side of the solid square, ropes hauled in only")
      .from("(15), (16)");
  d.field(&Output::B_hollow, "B_hollow", "B_hollow", si::m.in("mm"),
          "outer side of the hollow square, twice the inner one, ropes hauled in only")
      .from("table, 4/3 and 6.40");
  d.field(&Output::B_hollow_printed, "B_hollow_printed", "B_hollow_printed", si::m.in("mm"),
          "the same with the table's 1.33 and 6.41")
      .from("table");
  d.field(&Output::D_tube, "D_tube", "D_tube", si::m.in("mm"), "outer diameter of the tube, ropes hauled in only")
      .from("table, 4/pi and 32/pi");
  d.field(&Output::D_tube_printed, "D_tube_printed", "D_tube_printed", si::m.in("mm"),
          "the same with the table's 1.27 and 10, too small")
      .from("table");
  d.field(&Output::t_tube, "t_tube", "t_tube", si::m.in("mm"), "wall of the tube D_tube");
  d.field(&Output::N_payout, "N_payout", "N_payout", si::N, "axial force while the ropes are paid out under load")
      .from("(2) corrected");
  d.field(&Output::M_payout, "M_payout", "M_payout", si::N_m, "moment while the ropes are paid out under load")
      .from("(3) corrected");
  d.field(&Output::D_tube_payout, "D_tube_payout", "D_tube_payout", si::m.in("mm"),
          "tube for the ropes paid out under load");
  d.field(&Output::D_tube_mixed, "D_tube_mixed", "D_tube_mixed", si::m.in("mm"),
          "tube for one rope hauled in, the other paid out under load, the worse of both ways")
      .from("(2), (3) corrected for one rope");
  d.field(&Output::D_tube_rest, "D_tube_rest", "D_tube_rest", si::m.in("mm"),
          "tube for a rope at rest, full force on both sides of its block")
      .from("(2), (3) corrected, at rest");
  d.field(
      &Output::D_tube_worst, "D_tube_worst", "D_tube_worst", si::m.in("mm"),
      "outer diameter of the tube for whatever the ropes do: the largest of D_tube, D_tube_payout, D_tube_mixed and "
      "D_tube_rest");
  d.field(&Output::section_stress, "section_stress", "sigma", si::Pa, "stress in the section checked or chosen")
      .from("(12)-(14)");
  d.field(&Output::section_allowable, "section_allowable", "[sigma]", si::Pa,
          "allowable stress at that section's wall");
  d.field(&Output::section_mass, "section_mass", "m", si::kg_per_m, "mass per metre of that section");
}

}  // namespace

const Description& Output::describe() {
  static const Description description = [] {
    Describe<Output> d;
    describe_forces(d);
    describe_sizes(d);
    return Description(d);
  }();
  return description;
}

namespace {

std::vector<Erratum> errata() {
  return {{.where = "(9)",
           .printed = "gamma = asin(T sin beta / R) - alpha",
           .correct = "gamma = alpha + asin(T sin beta / R), taken as atan2 of the components",
           .evidence = "vector sum of the two branches; (8) solved for gamma",
           .test = "MastSectionCase.GammaLiesBelowTheBranch"},
          {.where = "wrap angle",
           .printed = "120 deg for every branch angle",
           .correct = "90 deg + alpha",
           .evidence = "geometry of figure 5: the drum side is vertical",
           .test = "MastSectionCase.WrapFollowsTheBranch"},
          {.where = "table, hollow square",
           .printed = "[sigma] b^3 - 1.33 N b - 6.41 M = 0, b not named",
           .correct = "the unknown is the outer side B; 4/3 and 6.40",
           .evidence = "A = 3 b^2, W = 1.25 b^3 with the inner side b = B/2",
           .test = "MastSectionCase.HollowSquareCarriesTheStress"},
          {.where = "table, tube",
           .printed = "coefficients 1.27 and 10",
           .correct = "4/pi and 32/pi = 10.186",
           .evidence = "the stress in the tube of the printed coefficients exceeds [sigma]",
           .test = "MastSectionCase.PrintedTubeIsTooSmall"},
          {.where = "model",
           .printed = "guylines and buckling left out",
           .correct = "to be checked apart; the program warns",
           .evidence = "the paper says so itself",
           .test = "MastSectionCase.WarnsOfWhatIsLeftOut"},
          {.where = "(2), (3)",
           .printed = "the drum side always carries the larger force",
           .correct = "while a rope is paid out under load the span side does",
           .evidence = "Euler's formula with the motion reversed",
           .test = "MastSectionCase.PayingOutBendsMore"}};
}

}  // namespace

const Method& about() {
  static const Method m{
      .name = "mast_section",
      .title = "Mast section of a tractor-mounted cable yarder",
      .source =
          "A. O. Shoshin, A. V. Dorozhko, V. Shtollmann, S. V. Yarmolik: Method for determining the parameters of the "
          "tower section of a cable yarding based on a tractor. Proceedings of BSTU, issue 1, 2022, no. 1 (252), pp. "
          "155-164 (in "
          "Russian)",
      .short_source = "Shoshin et al. 2022",
      .scope =
          "Smallest solid square, hollow square or tube of a mast that is clamped at its foot and carries the blocks "
          "of "
          "skyline and mainline, by stress under axial force and bending. Leaves out guylines, buckling, local "
          "buckling, "
          "own weight, wind, dynamics and fatigue.",
      .limits =
          {"branch angle from -60 to 85 deg below the horizontal",
           "block friction from 0 to 0.5; the paper: 0.10 to 0.16",
           "the drum side of each rope runs straight down the mast", "both ropes leave the mast in one vertical plane",
           "elastic material, section constant over the height",
           "alpha of (10) points from the block to the carriage; a heavy skyline leaves the mast a little steeper"},
      .errata = errata()};
  return m;
}

}  // namespace taut::mast_section
