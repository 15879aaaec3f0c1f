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
          .field(&Carriage::library, "carriage",
                 "a carriage by its name in the catalogue (taut list carriages): mass, rated payload, rope diameters, "
                 "rollers and wheelbase, where the deck does not give them")
          .field(&Carriage::catalogue, "catalogue",
                 "a file of carriages (CSV) in place of the built-in ones, beside the deck")
          .field(&Carriage::mass, "mass", "m", si::kg, "mass")
          .at_most(heaviest)
          .at_least(0)
          .field(&Carriage::rides, "rides", "the reeving it rides on")
          .required()
          .choice(&Carriage::hold, "hold",
                  {{"rolling", Hold::rolling}, {"clamped", Hold::clamped}, {"fixed_to", Hold::fixed_to}},
                  "rolling on the rope, clamped to it, or rolling on it and fixed to a second, running rope")
          .field(&Carriage::fixed_to, "fixed_to",
                 "the second reeving, to which it is fixed; its path has the carriage too")
          .field(&Carriage::mainline, "mainline", "the reeving whose length determines its place in a load path")
          .field(&Carriage::haulback, "haulback", "the reeving that pulls it against the mainline")
          .field(&Carriage::friction, "friction", "mu", si::one, "rolling friction on the rope")
          .at_least(0)
          .field(&Carriage::length_before, "length_before", "L", si::m,
                 "clamped or fixed: unstretched length from the start of that reeving (closed: from its drive) to the "
                 "clamp")
          .at_most(farthest)
          .above(0)
          .field(&Carriage::at, "at", "", si::m, "a first guess of its place")
          .at_least(-farthest)
          .at_most(farthest)
          .or_map(&Carriage::over_ground)
          .field(&Carriage::rollers, "rollers", "n", si::one,
                 "number of rollers, at equal distances; with more than one the carriage pitches")
          .at_least(1)
          .at_most(16)
          .field(&Carriage::wheelbase, "wheelbase", "b", si::m, "distance from the first roller to the last")
          .above(0)
          .at_most(100)
          .field(&Carriage::inertia, "inertia", "J", si::kg_m2,
                 "moment of inertia of a carriage that pitches, about its centre of mass; used in motion only")
          .at_least(0)
          .field(&Carriage::height, "height", "h", si::m,
                 "height of the rollers above the origin of the carriage, at which its mass, loads and ropes act; the "
                 "carriage then swings")
          .at_least(0)
          .at_most(100)
          .field(&Carriage::rated_payload, "rated_payload", "", si::kg,
                 "largest load on it: checked in every state, and a limit of each payload analysis")
          .above(0)
          .at_most(heaviest)
          .field(&Carriage::rope_diameters, "rope_diameters", "d", si::m.in("mm"),
                 "least and largest diameter of the rope on which it rides: checked")
          .above(0)
          .at_most(1);
  return d;
}

const Description& Dragged::describe() {
  static const Description d =
      Describe<Dragged>()
          .field(&Dragged::ground_angle, "ground_angle", "alpha", si::rad.in("deg"),
                 "slope of the ground, positive where it rises in the direction of travel")
          .above(-pi / 2)
          .below(pi / 2)
          .required()
          .field(&Dragged::friction, "friction", "mu", si::one, "friction of the bunch on the ground")
          .at_least(0)
          .at_most(10)
          .required()
          .field(&Dragged::share, "share", "s", si::one,
                 "part of the weight that the carriage carries on level ground without friction: distance of the "
                 "centre of mass from the dragged end over the length")
          .at_least(0)
          .at_most(1)
          .field(&Dragged::lift_angle, "lift_angle", "delta", si::rad.in("deg"), "angle between bunch and ground")
          .at_least(0)
          .below(pi / 2)
          .field(&Dragged::along, "along", "", si::one, "horizontal direction of travel, [x, y]")
          .required();
  return d;
}

}  // namespace taut::machine::description
