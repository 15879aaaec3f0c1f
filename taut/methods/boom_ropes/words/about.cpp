#include <iterator>

#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes {
namespace {

std::vector<Erratum> errata() {
  return {
      {.where = "text after (5)",
       .printed = "C1 = 2.72, C2 = 1.61 kN/m",
       .correct = "MN/m (kN/mm)",
       .evidence = "in kN/m the forces of Table 2 would stretch the ropes by 35 to 110 m",
       .test = "BoomRopesErrata.StiffnessIsInMeganewtons"},
      {.where = "text after (5)",
       .printed = "C1 = 2.72",
       .correct = "C1 = C2/2.07 = 0.778 MN/m",
       .evidence = "rows 1, 2, 3 and 8 of Table 2 give -dS2/dS1 = C2/C1 = 2.06 to 2.08; with the printed C1 row 3 "
                   "would be 197/120 "
                   "kN "
                   "instead of 162.5/43 kN",
       .test = "BoomRopesErrata.PrintedC1ContradictsTable2"},
      {.where = "conclusion",
       .printed = "jamming explains pretensions 2.4 to 2.5 times those of (3)",
       .correct = "the stiffness does: (3) with the corrected C1 asks for S20 > 166.5 kN",
       .evidence = "lambda_2 = 0.509; at Lb = 9 m and 77 deg the pads do not jam",
       .test = "BoomRopesErrata.StiffnessExplainsThePretension"},
      {.where = "results",
       .printed = "beta1 = 6.4 ... 1.67 deg for Mn = 0 ... 3.3 t",
       .correct = "Mn = 0.3 ... 3.3 t (hook block 0.3 t)",
       .evidence = "0 t gives 8.8 deg, 0.3 t gives 6.5 deg",
       .test = "BoomRopesErrata.LightestLoadIsTheHookBlock"},
      {.where = "captions",
       .printed = "Fig. 1: half-sheave of section 2; before Fig. 2: upper branch of the extension rope",
       .correct = "half-sheave of section 3; upper branch of the retraction rope",
       .evidence = "only a half-sheave on section 3 pulls it with 2 S1, as (1) has it",
       .test = "BoomRopesErrata.HalfSheaveBelongsToSection3"},
      {.where = "before (2)",
       .printed = "F = Sk + Fin + Ffr + (Gn + G3) sin(beta)",
       .correct = "a sum of projections: F = -Sk - d Ffr - (Gn + G3) sin(beta) + Fin",
       .evidence = "unsigned it contradicts (4), whose F is negative",
       .test = "BoomRopesErrata.SumOfProjections"},
      {.where = "(6)",
       .printed = "M = R D (1 - eta)/(2 (1 + eta))",
       .correct = "M = (Tin - Tout) D/2 with Tout = eta Tin",
       .evidence = "equal only for R = Tin + Tout, a wrap of 180 deg",
       .test = "BoomRopesErrata.SheaveMomentNeedsHalfTurn"},
      {.where = "Table 2, row 1",
       .printed = "95.5/181 kN",
       .correct = "93.4/185.4 kN",
       .evidence = "2 S10 - S20 = 10 kN, but the pads hold f0 G3 = 1.27 kN at the horizontal: section 3 slides",
       .test = "BoomRopesErrata.PublishedPretensionSlides"},
      {.where = "Table 2",
       .printed = "kappa S1 + S2 = 379 ... 393 kN",
       .correct = "constant for two elastic ropes with fixed anchors",
       .evidence = "379 in rows 1, 2, 3 and 8, up to 14 kN more while the boom moves",
       .test = "BoomRopesErrata.WeightedSumIsConstant"},
      {.where = "results",
       .printed = "beta1 = 0 deg at Lb = 17 m, Mn = 3.3 t",
       .correct = "15 to 16 deg",
       .evidence = "the lead line pulls with 5.1 kN, pads hold at least 6.3 kN",
       .test = "BoomRopesErrata.NoSlipAtTheHorizontal"},
      {.where = "results",
       .printed = "beta1 and beta2 without the overlap",
       .correct = "state the overlap after the jerk",
       .evidence = "at unchanged overlap both would be the same angle: 39 deg (hook), 50 deg (3.3 t) at 21 m",
       .test = "BoomRopesErrata.SlipAnglesNeedTheOverlap"},
      {.where = "static test",
       .printed = "Gn = 296.8 kN",
       .correct = "1.2 x 25 t, not the usual 1.25",
       .evidence = "296.8 kN is 30.25 t, of which 0.3 t hook block",
       .test = "BoomRopesErrata.StaticTestIsOnePointTwo"},
      {.where = "static part and model",
       .printed = "f0 = 0.15, later f0 = 0.155",
       .correct = "0.15 in (4), (5); 0.155 in the slip angles",
       .evidence = "6.49 and 1.68 deg need 0.155",
       .test = "BoomRopesErrata.TwoStaticFrictions"},
      {.where = "not stated",
       .printed = "",
       .correct = "the cylinder must hold twice |F|: about 0.66 MN in the static test",
       .evidence = "with these pretensions section 3 never rests on section 2",
       .test = "BoomRopesErrata.CylinderHoldsTwiceTheForce"},
  };
}

std::vector<std::string> limits() {
  constexpr const char* all[] = {
      "Three sections, section 3 moved by ropes only, travel of 3 in 2 equal to travel of 2 in 1",
      "(4), (5): no jamming, no sheave losses; use the sliding block for long booms and small angles",
      "F0 is taken with the boom horizontal",
      "Sliding: steady motion or its limit; a boom at rest can have any state between those of the two directions",
      "Geometry of the KS-55713-5K-1 in the defaults of sliding is calibrated or assumed, not published",
      "Not modelled: clearances of the pads, side loads, wind, bending of sections, rope breaks in time"};
  return {std::begin(all), std::end(all)};
}

}  // namespace

const Method& about() {
  static const Method m{
      .name = "boom_ropes",
      .title = "Extension and retraction ropes of a three-section telescopic boom",
      .source =
          "A. A. Reutov, Calculating and modeling rope mechanism of a mobile crane telescopic boom, 2021, no. 1, "
          "pp. 13-22, DOI 10.30987/2658-6436-2021-1-13-22",
      .short_source = "Reutov 2021",
      .scope =
          "Rope tensions of section 3 by (1)-(5), least pretensions, alternating tensioning (Table 1); with the block "
          "sliding "
          "also rope, pad and cylinder forces while sections 2 and 3 slide, jamming included. Statics in the luffing "
          "plane: no "
          "inertia, no swinging load, no rope dynamics.",
      .limits = limits(),
      .errata = errata()};
  return m;
}

}  // namespace taut::boom_ropes
