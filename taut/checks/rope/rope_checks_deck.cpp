#include "taut/checks/rope/rope_checks_deck.hpp"

namespace taut::checks {

const Description& HoistRequest::describe() {
  static const Description d =
      Describe<HoistRequest>()
          .choice(
              &HoistRequest::hoisting_class, "class",
              {{"HC1", HoistClass::HC1}, {"HC2", HoistClass::HC2}, {"HC3", HoistClass::HC3}, {"HC4", HoistClass::HC4}},
              "hoisting class")
          .required()
          .field(&HoistRequest::speed, "speed", "v_h", si::m_per_s, "steady hoisting speed")
          .at_least(0)
          .at_most(20)
          .required();
  return d;
}

const Description& En13001Request::describe() {
  static const Description d =
      Describe<En13001Request>()
          .field(&En13001Request::bends, "bends", "w_tot", si::one,
                 "number of bendings in the design life; default: the static proof alone")
          .above(0)
          .field(&En13001Request::spectrum, "spectrum", "k_r", si::one, "spectrum factor of the rope force; default: 1")
          .above(0)
          .at_most(1)
          .field(&En13001Request::factor, "factor", "f_f", si::one,
                 "product of the factors of influence: D/d, grade, fleet angle, groove; default: 1")
          .above(0)
          .at_most(5);
  return d;
}

namespace {

void add_place(Describe<RopeCheckRequest>& d) {
  using R = RopeCheckRequest;
  d.field(&R::termination, "termination",
          "how its ends are fixed: `socket`, `swaged_socket`, `sleeve`, `hand_splice`, `wedge_socket`, `clips`, "
          "`ferrule_eye` (taut list rules --name termination)")
      .field(&R::termination_efficiency, "termination_efficiency", "eta_T", si::one,
             "strength of its terminations over that of the rope, in place of that of the rules")
      .above(0)
      .at_most(1)
      .field(&R::temperature, "temperature", "t", si::K,
             "temperature of the rope in use; default: the highest of the machine, where that is above 100 degC")
      .at_least(173.15)
      .at_most(873.15)
      .choice(&R::sheave_weakening, "sheave_weakening",
              {{"by_field", Choose::by_field}, {"counts", Choose::yes}, {"covered", Choose::no}},
              "counts: the safety factor must hold with the reduced strength on a sheave too; covered: the factor "
              "includes this; by_field: covered for cranes and ropeways")
      .choice(&R::running, "running", {{"by_field", Choose::by_field}, {"runs", Choose::yes}, {"stands", Choose::no}},
              "runs: it runs over its sheaves, and D/d is checked; by_field: all but skyline, guyline, stay, track "
              "rope and cableway")
      .field(&R::diameter_ratio, "diameter_ratio", "D/d", si::one,
             "least D/d, in place of that of the rules: one for all, or for sheaves and for drums")
      .above(1)
      .at_most(500)
      .field(&R::compensating, "compensating", "compensating sheaves, by name");
}

void add_rope(Describe<RopeCheckRequest>& d) {
  using R = RopeCheckRequest;
  d.field(&R::rope, "rope",
          "rope of the catalogue, for what the deck does not say of a rope that it describes by values")
      .field(&R::breaking_force, "breaking_force", "F_min", si::N, "value where neither deck nor catalogue gives it")
      .above(0)
      .field(&R::diameter, "diameter", "d", si::m.in("mm"), "value where neither deck nor catalogue gives it")
      .above(0)
      .at_most(0.3)
      .field(&R::construction, "construction", "construction of a rope that is not in the catalogue: 6x36WS-IWRC")
      .field(&R::core, "core", "FC, IWRC or WSC, of a rope that is not in the catalogue")
      .field(&R::grade, "grade", "R_r", si::Pa, "grade of its wires, where the catalogue does not give it")
      .above(1e8)
      .at_most(5e9)
      .field(&R::area, "area", "A", si::m2, "metallic area, where the catalogue does not give it")
      .above(0)
      .choice(&R::groove, "groove",
              {{"none", Groove::none},
               {"wood", Groove::wood},
               {"cast_iron", Groove::cast_iron},
               {"cast_steel", Groove::cast_steel},
               {"chilled_iron", Groove::chilled_iron},
               {"manganese_steel", Groove::manganese_steel}},
              "groove material of its sheaves and drums, for the groove pressure")
      .field(&R::groove_pressure, "groove_pressure", "p", si::Pa,
             "largest groove pressure, in place of that of the rules")
      .above(0)
      .field(&R::wire_diameter, "wire_diameter", "delta", si::m.in("mm"),
             "diameter of its outer wires; default: a fraction of d by the construction")
      .above(0)
      .below(0.02)
      .field(&R::bending_modulus, "bending_modulus", "E_r", si::Pa.in("GPa"),
             "modulus of the rope, for the bending stress")
      .above(1e9)
      .at_most(2.2e11)
      .choice(&R::drum, "drum",
              {{"unsaid", DrumFace::unsaid}, {"smooth", DrumFace::smooth}, {"grooved", DrumFace::grooved}},
              "face of the drum, for the fleet angle and the layers")
      .field(&R::fleet_angle, "fleet_angle", "", si::rad,
             "largest fleet angle at the flanges, in place of that of the rules")
      .above(0)
      .below(1.5)
      .field(&R::rated_pull, "rated_pull", "F_1", si::N, "rated pull of the winch in its first layer")
      .above(0)
      .record(&R::en13001, "en13001", "proofs of EN 13001-3-2")
      .record(&R::duty, "duty", "duties of the rope in the life required, for its life in bending cycles")
      .record(&R::life, "life", "data for the life")
      .field(&R::discard, "discard", "true: a table of the discard criteria");
}

}  // namespace

const Description& RopeCheckRequest::describe() {
  using R = RopeCheckRequest;
  static const Description d = [] {
    Describe<R> all;
    all.field(&R::field, "field",
              "field of use, one or a list: rules below 'safety.' such as skyline.ch, crane_running, mainline.ch_at "
              "(taut list rules --name safety)")
        .field(&R::group, "class", "group of the mechanism, M1 to M8")
        .field(&R::safety_factor, "safety_factor", "Z_p", si::one, "least breaking force over the largest tension")
        .at_least(1)
        .at_most(50)
        .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one, "peak over static tension")
        .at_least(1)
        .at_most(20)
        .record(&R::hoist, "hoist", "dynamic factor of hoisting by class and speed, EN 13001-2")
        .field(&R::dynamic_safety_factor, "dynamic_safety_factor", "", si::one,
               "least breaking force over the peak tension")
        .at_least(1)
        .at_most(50)
        .field(&R::elastic_limit, "elastic_limit", "", si::one,
               "largest peak tension over breaking force; default: 0.60 of the rules, by which a rope fails but does "
               "not pass; one that is given is a limit of its strength")
        .above(0)
        .at_most(1);
    add_place(all);
    add_rope(all);
    return static_cast<Description>(all);
  }();
  return d;
}

}  // namespace taut::checks
