#include "taut/checks/rope/rope_life_deck.hpp"

namespace taut::checks {

const Description& DutyRequest::describe() {
  static const Description d =
      Describe<DutyRequest>()
          .field(&DutyRequest::name, "name", "name of the duty")
          .required()
          .field(
              &DutyRequest::cycles, "cycles", "n", si::one,
              "working cycles in the life required: one bends the rope once on each round and half on a drum; lifting "
              "and lowering are two")
          .above(0)
          .at_most(1e12)
          .required()
          .field(&DutyRequest::load, "load", "", si::one, "fraction of the largest tension at each round")
          .above(0)
          .at_most(2)
          .field(&DutyRequest::over, "over", "the rounds that bend the rope in this duty, by name; default: all");
  return d;
}

const Description& LifeConstantsRequest::describe() {
  static const Description d = Describe<LifeConstantsRequest>()
                                   .choice(&LifeConstantsRequest::count, "count",
                                           {{"mean_break", LifeCount::mean_break},
                                            {"break_10", LifeCount::break_10},
                                            {"discard", LifeCount::discard},
                                            {"discard_10", LifeCount::discard_10}},
                                           "the number that they give: mean number of bendings to the break, that "
                                           "which 90 % of ropes reach, and the same two to discard")
                                   .field(&LifeConstantsRequest::a, "a", "a_i", si::one, "a0, a1, a2, a3")
                                   .required();
  return d;
}

const Description& LifeRequest::describe() {
  static const Description d =
      Describe<LifeRequest>()
          .record(&LifeRequest::constants, "constants",
                  "Feyrer's constants of this rope; default: one recalled set, unverified")
          .field(&LifeRequest::bent_length, "bent_length", "l", si::m,
                 "length of rope that is bent; default, and taken where it is shorter: 60 d")
          .above(0)
          .at_most(1e5)
          .field(&LifeRequest::core_factor, "core_factor", "f_C", si::one,
                 "endurance factor of core and strands; default: that of the rules")
          .above(0)
          .at_most(10)
          .field(&LifeRequest::reverse_weight, "reverse_weight", "", si::one,
                 "weight of a bending opposite to the one before; default: 2, unverified")
          .at_least(1)
          .at_most(20)
          .field(&LifeRequest::donandt_force, "donandt_force", "S_D", si::N,
                 "Donandt force of this rope on its smallest sheave, above which wires yield in bending")
          .above(0);
  return d;
}

}  // namespace taut::checks
