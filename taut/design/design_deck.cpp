#include "taut/design/design_deck.hpp"

#include <utility>

namespace taut::design {

const Description& DesignRopeRequest::describe() {
  using R = DesignRopeRequest;
  static const Description d =
      Describe<R>()
          .field(&R::construction, "construction", "6x36, 6x36WS, ...; default: any")
          .field(&R::core, "core", "FC, IWRC, WSC; default: any")
          .field(&R::standard, "standard", "beginning of its name: EN, GOST 2688")
          .field(&R::grade, "grade", "R_r", si::Pa, "grade of the wires")
          .above(1e8)
          .at_most(5e9)
          .field(&R::least_diameter, "least_diameter", "d", si::m.in("mm"), "smallest")
          .above(0)
          .field(&R::most_diameter, "most_diameter", "d", si::m.in("mm"), "largest")
          .above(0)
          .choice(&R::trust, "trust",
                  {{"any", catalogue::Trust::unverified},
                   {"derived", catalogue::Trust::derived},
                   {"verified", catalogue::Trust::verified}},
                  "least trust of the breaking force")
          .field(
              &R::modulus, "modulus", "E", si::Pa.in("GPa"),
              "modulus on the metallic area: the stiffness is E A; default: by its construction, as of a rope of the "
              "catalogue; in a method 100 GPa, in a closed loop what its input takes without a stiffness")
          .above(1e9)
          .at_most(2.2e11);
  return d;
}

const Description& DesignSectionRequest::describe() {
  using R = DesignSectionRequest;
  static const Description d = [] {
    Description own =
        Describe<R>().field(&R::price, "price", "", si::one, "price per kilogram, for 'cheapest'").at_least(0);
    for (Field f : checks::SectionChoice::describe().fields) {
      if (f.key == "least_trust") f.key = "trust";
      f.slot = [slot = f.slot](void* s) { return slot(&static_cast<R*>(s)->which); };
      own.fields.push_back(std::move(f));
    }
    return own;
  }();
  return d;
}

const Description& DesignUnknownRequest::describe() {
  using R = DesignUnknownRequest;
  static const Description d =
      Describe<R>()
          .field(&R::parameter, "parameter",
                 "its path below 'machine' or 'input', as in a sweep: reevings.skyline.tension_at_start; or from "
                 "'analyses' on: analyses[0].equilibrium.given.sag")
          .required()
          .field(&R::along_with, "along_with", "paths of other numbers that change by the same amount")
          .field(&R::from, "from", "one end of its range, with its unit")
          .required()
          .field(&R::to, "to", "the other end")
          .required()
          .field(&R::start, "start", "start of the search, in addition to the places of the grid")
          .field(&R::steps, "steps", "n", si::one, "equal steps of the grid; default: 4, with a 'start' none")
          .at_least(1)
          .at_most(200)
          .field(&R::price, "price", "", si::one, "price per metre, newton, kilogram, ..., for 'cheapest'")
          .at_least(0);
  return d;
}

const Description& DesignSettingRequest::describe() {
  using R = DesignSettingRequest;
  static const Description d =
      Describe<R>().field(&R::value, "value", "the number in this case, with its unit").required();
  return d;
}

const Description& DesignCaseRequest::describe() {
  using R = DesignCaseRequest;
  static const Description d =
      Describe<R>()
          .named_records(&R::settings, "settings",
                         "paths as in a 'parameter', each with its value: `{loads.car.mass: 2 t}`")
          .shorthand("value")
          .rest();
  return d;
}

const Description& DesignRequest::describe() {
  using R = DesignRequest;
  static const Description d =
      Describe<R>()
          .choice(&R::seek, "seek",
                  {{"lightest", Seek::lightest},
                   {"smallest", Seek::smallest},
                   {"cheapest", Seek::cheapest},
                   {"least_tension", Seek::least_tension},
                   {"most_reserve", Seek::most_reserve}},
                  "objective: least mass, least sum of diameters and heights, least price, smallest largest tension, "
                  "or lowest governing utilisation")
          .field(&R::of, "of", "rope or reeving whose largest tension is minimised (least_tension); default: all")
          .field(&R::catalogue, "catalogue", "a file of ropes (CSV) in place of the built-in ones, beside the deck")
          .named_records(&R::ropes, "ropes", "ropes of the machine or the method that are chosen, by name")
          .named_records(&R::sections, "sections", "beams of the machine, or masts, whose section is chosen, by name")
          .named_records(&R::unknowns, "unknowns", "free numbers, by a name of your own")
          .named_records(&R::cases, "cases",
                         "load cases, each with the values that differ from the deck; the checks of all have to pass")
          .field(&R::disregard, "disregard", "checks that the design need not pass, by name; they remain in the result")
          .field(&R::refine, "refine", "true: the unknowns also vary between the places of their grid")
          .field(&R::runner_ups, "runner_ups", "", si::one, "number of choices listed on either side of the answer")
          .at_least(0)
          .at_most(100)
          .field(&R::most_trials, "most_trials", "", si::one, "largest number of choices tried")
          .at_least(1)
          .at_most(1000000);
  return d;
}

}  // namespace taut::design
