#include "taut/app/design_deck.hpp"

#include <memory>
#include <utility>

namespace taut::app {

const Description& DesignRopeRequest::describe() {
  using R = DesignRopeRequest;
  static const Description d =
      Describe<R>()
          .field(&R::construction, "construction", "6x36, 6x36WS, ...; without it any")
          .field(&R::core, "core", "FC, IWRC, WSC; without it any")
          .field(&R::standard, "standard", "beginning of its name: EN, GOST 2688")
          .field(&R::grade, "grade", "R_r", si::Pa, "of the wires")
          .above(1e8)
          .at_most(5e9)
          .field(&R::least_diameter, "least_diameter", "d", si::m.in("mm"), "smallest")
          .above(0)
          .field(&R::most_diameter, "most_diameter", "d", si::m.in("mm"), "largest")
          .above(0)
          .choice(&R::trust, "trust",
                  {{"any", LeastTrust::any}, {"derived", LeastTrust::derived}, {"verified", LeastTrust::verified}},
                  "least trust of the breaking force")
          .field(&R::modulus, "modulus", "E", si::Pa.in("GPa"), "on the metallic area: the stiffness is E A")
          .above(1e9)
          .at_most(2.2e11);
  return d;
}

const Description& DesignSectionRequest::describe() {
  using R = DesignSectionRequest;
  static const Description d = [] {
    Description own;
    own.make_default = [] { return std::static_pointer_cast<void>(std::make_shared<R>()); };
    for (Field f : SectionChoice::describe().fields) {
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
  static const Description d = Describe<R>()
                                   .field(&R::parameter, "parameter",
                                          "its path below 'machine', as in a sweep: reevings.skyline.tension_at_start")
                                   .required()
                                   .field(&R::from, "from", "first value, with its unit")
                                   .required()
                                   .field(&R::to, "to", "last value")
                                   .required()
                                   .field(&R::steps, "steps", "n", si::one, "equal steps between them")
                                   .at_least(1)
                                   .at_most(200);
  return d;
}

const Description& DesignRequest::describe() {
  using R = DesignRequest;
  static const Description d =
      Describe<R>()
          .choice(&R::seek, "seek",
                  {{"lightest", Seek::lightest}, {"smallest", Seek::smallest}, {"cheapest", Seek::cheapest}},
                  "least mass of the ropes that are free, least sum of their diameters, or least price")
          .field(&R::catalogue, "catalogue", "a file of ropes (CSV) in place of the built-in ones, beside the deck")
          .named_records(&R::ropes, "ropes", "ropes of the machine that are chosen, by name")
          .named_records(&R::sections, "sections", "beams of the machine whose section is chosen, by name")
          .named_records(&R::unknowns, "unknowns", "numbers of the machine that are free, by a name of yours")
          .field(&R::refine, "refine",
                 "moves the unknowns of the least choice on between their places, to the most reserve")
          .field(&R::runner_ups, "runner_ups", "", si::one, "choices told on either side of the answer")
          .at_least(0)
          .at_most(100)
          .field(&R::most_trials, "most_trials", "", si::one, "after so many choices the search ends")
          .at_least(1)
          .at_most(1000000);
  return d;
}

}  // namespace taut::app
