#include "taut/checks/mast/mast_checks_deck.hpp"

namespace taut::checks {

const Description& MastPieceRequest::describe() {
  static const Description d =
      Describe<MastPieceRequest>()
          .field(&MastPieceRequest::length, "length", "L", si::m, "length of the piece")
          .above(0)
          .at_most(1000)
          .required()
          .field(&MastPieceRequest::section, "section", "section of the catalogue; of a tapered piece at its lower end")
          .required()
          .field(&MastPieceRequest::top, "top",
                 "section at the upper end of a tapered piece: outer sizes and wall vary linearly");
  return d;
}

const Description& MastLoadRequest::describe() {
  using R = MastLoadRequest;
  static const Description d =
      Describe<R>()
          .field(&R::load_case, "case", "its load case")
          .field(&R::at, "at", "h", si::m, "height above the base; default: the top")
          .at_least(0)
          .at_most(1000)
          .field(&R::down, "down", "N", si::N, "compression of the mast")
          .at_least(-1e8)
          .at_most(1e8)
          .field(&R::across, "across", "H", si::N, "lateral force that bends the mast about its strong axis")
          .at_least(-1e8)
          .at_most(1e8)
          .field(&R::sideways, "sideways", "", si::N, "lateral force that bends the mast about its weak axis")
          .at_least(-1e8)
          .at_most(1e8)
          .field(&R::moment, "moment", "M", si::N_m, "bends as 'across' does")
          .at_least(-1e9)
          .at_most(1e9)
          .field(&R::sideways_moment, "sideways_moment", "", si::N_m, "bends as 'sideways' does")
          .at_least(-1e9)
          .at_most(1e9)
          .field(&R::torsion, "torsion", "T", si::N_m, "turns the mast about its axis; its foot holds it")
          .at_least(-1e9)
          .at_most(1e9);
  return d;
}

const Description& MastTerm::describe() {
  static const Description d = Describe<MastTerm>()
                                   .field(&MastTerm::factor, "factor", "gamma_F", si::one, "its partial factor")
                                   .at_least(0)
                                   .at_most(10)
                                   .required();
  return d;
}

const Description& MastCombinationRequest::describe() {
  static const Description d =
      Describe<MastCombinationRequest>()
          .named_records(
              &MastCombinationRequest::terms, "terms",
              "load cases, of a machine one analysis, each with its partial factor: `{work: 1.5}`; 'own_weight' "
              "names the weight of a mast with 'own_weight: true', whose factor is else the largest")
          .shorthand("factor")
          .rest();
  return d;
}

const Description& PlateRequest::describe() {
  using P = PlateRequest;
  static const Description d =
      Describe<P>()
          .field(&P::guys, "guys", "", si::one, "least number of guylines")
          .above(0)
          .at_most(100)
          .field(&P::guy_strength, "guy_strength", "", si::N, "least breaking force of each guyline")
          .above(0);
  return d;
}

namespace {

void add_own_mast(Describe<MastCheckRequest>& d) {
  using R = MastCheckRequest;
  d.field(&R::section, "section", "section of the catalogue; default for a mast of the machine: that of the beam")
      .record(&R::pieces, "pieces", "pieces of a stepped or tapered mast, from its base upwards, in place of 'section'")
      .field(&R::height, "height", "h", si::m, "height of a mast that is not in the machine")
      .above(0)
      .at_most(1000)
      .field(&R::steel, "steel", "steel grade; default for a mast of the machine: that of the beam")
      .choice(&R::base, "base", {{"clamped", MastBase::clamped}, {"hinge", MastBase::hinge}},
              "base of a mast that is not in the machine, clamped unless given")
      .field(&R::top_stiffness, "top_stiffness", "k", si::N_per_m.in("kN/m"),
             "lateral stiffness at its top, such as of guys; .inf: the top does not move")
      .may_be_infinite()
      .at_least(0)
      .record(&R::loads, "loads", "loads on a mast that is not in the machine")
      .field(&R::carries, "carries",
             "sheaves, supports and anchors of the machine whose ropes load such a mast, in every equilibrium and "
             "motion of the deck")
      .field(&R::foot, "foot", "", si::m, "its base, x, y, z; with 'carries'; default: 0, 0, 0")
      .field(&R::towards, "towards", "", si::one,
             "horizontal direction in which its strong axis bends; with 'carries'; default: [1, 0]")
      .field(
          &R::own_weight, "own_weight",
          "true: the weight of such a mast counts, times 'load_factor', or its factor in each of 'combinations', not "
          "times 'dynamic_factor'")
      .field(&R::sway, "sway", "phi", si::one, "inclination as built; default: by (5.5) of EN 1993-1-1")
      .at_least(0)
      .at_most(0.1)
      .field(&R::bow, "bow", "e_0/L", si::one, "bow as built over the buckling length; default: by table 5.1")
      .at_least(0)
      .at_most(0.05);
}

void add_factors(Describe<MastCheckRequest>& d) {
  using R = MastCheckRequest;
  d.field(&R::load_factor, "load_factor", "gamma_F", si::one,
          "partial factor of all forces, where there are no 'combinations'")
      .above(0)
      .at_most(10)
      .field(&R::dynamic_factor, "dynamic_factor", "phi", si::one,
             "dynamic factor of all forces, in addition to the partial factors")
      .at_least(1)
      .at_most(10)
      .field(&R::gamma_M0, "gamma_M0", "gamma_M0", si::one, "partial factor of sections")
      .at_least(1)
      .at_most(2)
      .field(&R::gamma_M1, "gamma_M1", "gamma_M1", si::one, "partial factor of members against buckling")
      .at_least(1)
      .at_most(2)
      .named_records(&R::combinations, "combinations",
                     "by name, each with its load cases (of a machine: one analysis) and their partial factors");
}

void add_resistance(Describe<MastCheckRequest>& d) {
  using R = MastCheckRequest;
  d.field(&R::wall_tolerance, "wall_tolerance", "", si::one,
          "fraction by which the wall is thinner than nominal: 0.10 in EN 10210 and 10219, 0.125 of seamless tubes")
      .at_least(0)
      .at_most(0.3)
      .choice(&R::curve, "curve",
              {{"by_section", MastCurve::by_section},
               {"a0", MastCurve::a0},
               {"a", MastCurve::a},
               {"b", MastCurve::b},
               {"c", MastCurve::c},
               {"d", MastCurve::d}},
              "buckling curve; by_section: hot-finished a (S460: a0), cold-formed c")
      .field(&R::buckling_length, "buckling_length", "L_cr", si::m,
             "buckling length of the whole mast; default: from the critical load of mast and machine together")
      .above(0)
      .at_most(10000)
      .field(&R::C_m, "C_m", "C_m", si::one, "equivalent moment factor: 0.9 of a mast that may sway")
      .at_least(0.4)
      .at_most(1)
      .field(
          &R::allowable_stress, "allowable_stress", "[sigma]", si::Pa,
          "allowable stress for the route of the mast paper, |N|/A + M/W without factors, in addition to EN 1993-1-1")
      .above(0)
      .field(&R::safety, "safety", "n", si::one, "the same as a safety factor on the yield stress: [sigma] = f_y/n")
      .at_least(1)
      .at_most(10)
      .field(&R::top_criterion, "top_criterion", "", si::one,
             "least stiffness of the guys at its top, as a multiple of N_cr/L of the mast hinged at both ends: 3 to 4 "
             "for a top that counts as fixed")
      .above(0)
      .at_most(100)
      .record(&R::plate, "plate", "requirements for guylines on the plate of the spar (WAC 296-54-553)")
      .record(&R::choose, "choose", "also lists the lightest sections that pass under these forces");
}

}  // namespace

const Description& MastCheckRequest::describe() {
  static const Description d = [] {
    Describe<MastCheckRequest> all;
    all.field(&MastCheckRequest::beams, "beams",
              "beams of the machine in line, from the base upwards; default: the beam of that name");
    add_own_mast(all);
    add_factors(all);
    add_resistance(all);
    return Description(all);
  }();
  return d;
}

}  // namespace taut::checks
