#include <numbers>

#include "taut/machine/description/machine.hpp"
#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine::description {
namespace {

using std::numbers::pi;

}  // namespace

const Description& Carriage::describe() {
  static const Description d =
      Describe<Carriage>()
          .field(&Carriage::mass, "mass", "m", si::kg, "mass")
          .at_most(heaviest)
          .at_least(0)
          .field(&Carriage::rides, "rides", "the reeving it rides on")
          .required()
          .choice(&Carriage::hold, "hold",
                  {{"rolling", Hold::rolling}, {"clamped", Hold::clamped}, {"fixed_to", Hold::fixed_to}},
                  "rolling on the rope, clamped to it, or rolling and fixed to a second rope that carries it along")
          .field(&Carriage::fixed_to, "fixed_to", "the reeving that carries it along; its path goes through it too")
          .field(&Carriage::mainline, "mainline", "the reeving whose length sets its place in a load path")
          .field(&Carriage::haulback, "haulback", "the reeving that pulls it against the mainline")
          .field(&Carriage::friction, "friction", "mu", si::one, "of rolling on the rope")
          .at_least(0)
          .field(
              &Carriage::length_before, "length_before", "L", si::m,
              "clamped or fixed: unstretched rope between that reeving's start (an endless one's drive) and the place")
          .at_most(farthest)
          .above(0)
          .field(&Carriage::at, "at", "", si::m, "a first guess of its place")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&Carriage::rollers, "rollers", "n", si::one,
                 "rollers on the rope, at equal distances; with more than one the carriage pitches as they let it")
          .at_least(1)
          .at_most(16)
          .field(&Carriage::wheelbase, "wheelbase", "b", si::m, "from the first roller to the last one")
          .above(0)
          .at_most(100)
          .field(&Carriage::inertia, "inertia", "J", si::kg_m2,
                 "of one that pitches, about its centre of mass; statics does not depend on it")
          .at_least(0)
          .field(&Carriage::height, "height", "h", si::m,
                 "of the rollers over the carriage's origin, where its mass and loads hang and ropes are fixed; the "
                 "carriage then swings")
          .at_least(0)
          .at_most(100);
  return d;
}

const Description& Dragged::describe() {
  static const Description d =
      Describe<Dragged>()
          .field(&Dragged::ground_angle, "ground_angle", "alpha", si::rad.in("deg"),
                 "slope of the ground, positive where it rises in the direction of the way")
          .above(-pi / 2)
          .below(pi / 2)
          .required()
          .field(&Dragged::friction, "friction", "mu", si::one, "of the bunch on the ground")
          .at_least(0)
          .at_most(10)
          .required()
          .field(
              &Dragged::share, "share", "s", si::one,
              "of the bunch's weight that hangs on the carriage on level ground without friction: the distance of its "
              "centre from the dragged end over its length")
          .at_least(0)
          .at_most(1)
          .field(&Dragged::lift_angle, "lift_angle", "delta", si::rad.in("deg"), "of the bunch against the ground")
          .at_least(0)
          .below(pi / 2)
          .field(&Dragged::along, "along", "", si::one, "horizontal direction of the way, [x, y]");
  return d;
}

}  // namespace taut::machine::description
