#include "taut/methods/closed_loop/closed_loop.hpp"

namespace taut::closed_loop {
namespace {

std::vector<Erratum> errata() {
  return {
      {.where = "(1)",
       .printed = "P_ax",
       .correct = "P_bx, the load of the upper branch",
       .evidence = "term by term from the two branches; limit cases eta = 1, 0",
       .test = "ClosedLoopErrata.Equation1BalancesBothBranches"},
      {.where = "(4)",
       .printed = "[l(cot gamma +- tan alpha) - 2l]",
       .correct = "[... - 2f]",
       .evidence = "2l gives -190 kgf, 2f the published 1160 kgf",
       .test = "ClosedLoop.Equation4SubtractsTwiceTheSagNotTheSpan"},
      {.where = "(6)",
       .printed = "T_b + S cos(gamma)/cos(alpha)",
       .correct = "T_b/eta + S sin(gamma)/cos(alpha)",
       .evidence = "contradicts (2), its own '= T_b + K', and (14): the sheave stands between T_b and T_n",
       .test = "ClosedLoopErrata.Equation6FollowsTheRopeOverTheSheave"},
      {.where = "(7), (8)",
       .printed = "the return rope is dimensioned by its tension in the upper branch",
       .correct = "its highest tension is behind the sheave: T_lB = T_uB/eta; (8*) puts eta before 8 sigma",
       .evidence = "in the example the rope from (8) has a safety factor of 3.12 instead of 3.5",
       .test = "ClosedLoop.Equation8UndersizesTheReturnRope"},
      {.where = "(8), (10)",
       .printed = "0.01 ln(...)",
       .correct = "0.01 l n (...)",
       .evidence = "from (7), (9) with q = 0.01 F; the logarithm of a length has no meaning",
       .test = "ClosedLoopErrata.Equations8And10MakeTensionTimesSafetyTheStrength"},
      {.where = "(9)",
       .printed = "(l -+ f sin 2 alpha) [(P - P_b) l + 2 K f cos^2 alpha]",
       .correct = "(l +- f sin 2 alpha) [4 (P - P_b) l cos(alpha) + 8 K f cos^2 alpha], q_T for q_n",
       .evidence = "(10) has the right bracket; a level chord must give H",
       .test = "ClosedLoopErrata.Equation9AgreesWithTheLevelChord"},
      {.where = "(3)-(9)",
       .printed = "the roller force is taken as vertical, its slope component 'almost zero'",
       .correct = "a free roller presses normal to the rope: T_lA = (9) - P_b sin(alpha_s) at midspan",
       .evidence =
           "energy: without friction and gamma = 0 the net pull on the load P must be P sin(alpha), by (9) it is zero",
       .test = "ClosedLoopErrata.FreeRollerPullsTheLoadUpTheSlope"},
      {.where = "(11)-(16)",
       .printed = "one x, x (q_T - q_b), P and K on the chord AB, the same T_B2 in (12) and (13), f_2 = f_1 + delta_f",
       .correct = "x_1 and x_2 = x_1 + d, (q_T - q_b) x_1^2/x_2, S resolved on alpha_1, equal H, f_2 = f_1 (l - "
                  "x_2)/(l - x_1) + "
                  "delta_f",
       .evidence = "an independent solution of the two-section carriage with catenaries",
       .test = "ClosedLoopErrata.TwoSectionSystemAgreesWithCatenaries"},
      {.where = "(16)",
       .printed = "tan alpha = tan alpha + ...",
       .correct = "tan alpha_1 = tan alpha_s + f_1/(l - x_1)",
       .evidence = "misprint",
       .test = "ClosedLoopErrata.TwoSectionSystemAgreesWithCatenaries"},
      {.where = "example",
       .printed = "T = 700/delta_f - 14.5e3; P_b = 1230 kgf, delta_f = 0.097 m",
       .correct = "7.7e3/delta_f - 1.45e3; printed system P_b = 1115 kgf, corrected 1134 kgf, delta_f = 0.98 m",
       .evidence = "the published pair solves neither the printed nor the repaired system",
       .test = "ClosedLoopErrata.PublishedTwoSectionAnswerSolvesNothing"},
      {.where = "conclusion",
       .printed = "moving the first section 3 m ahead raises P_b by 70 kgf",
       .correct = "it lowers P_b by about 2.7 %",
       .evidence = "single and two-section carriage side by side",
       .test = "ClosedLoopErrata.SectionAheadLowersTheLoad"},
  };
}

}  // namespace

const Method& about() {
  static const Method method{
      .name = "closed_loop",
      .title = "Closed loop of two ropes with jointly loaded branches",
      .source =
          "V. D. Martynikhin: Raschet tyagovo-nesushchikh kanatov s parallelnymi sovmestno nagruzhennymi vetvyami, "
          "obrazuyushchimi zamknutyi kontur (Design of traction-carrying ropes with parallel, jointly loaded branches "
          "that "
          "form "
          "a closed loop), about 1971, in Russian",
      .short_source = "Martynikhin 1971",
      .scope =
          "Statics of a yarding line whose return rope is led back over the tail sheave, so that its upper branch "
          "carries "
          "part of the load: "
          "load "
          "share of the branches, tensions, rope areas, single and two-section carriage, in-haul and out-haul. The "
          "closed-form "
          "tier (parabolas, roller normal to the rope, true end tensions) stands beside the paper's formulas. Not "
          "modelled: "
          "rolling resistance, bending stiffness of the rope, branches that are not parallel, a rigid carriage, "
          "bending "
          "over "
          "sheaves, splices and wear, several spans (use the product of efficiencies as an estimate), dynamics, wind, "
          "temperature. Exact elastic catenaries of the same loop are given too.",
      .limits =
          {"0 < eta <= 1, |alpha_s| < 60 deg, 0 <= gamma < 90 deg from the vertical",
           "Paper's formulas: local slope f/min(x, l - x) <= 0.2 and |alpha_s| <= 10 deg (P_b and T_lA then "
           "within 7 %)",
           "(8), (10): load at midspan",
           "Closed-form tier: end tensions within 2 % of catenaries for f/min(x, l - x) <= 0.2 and ropes that weigh "
           "no more than P"},
      .errata = errata()};
  return method;
}

}  // namespace taut::closed_loop
