#include "taut/machine/description/machine.hpp"
#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine::description {
namespace {

constexpr double slowest = 3600;  ///< brake, s

}  // namespace

const Description& Motor::describe() {
  static const Description d = Describe<Motor>()
                                   .field(&Motor::speed, "speed", "rim speed along the path: a signal, or a speed")
                                   .field(&Motor::torque, "torque",
                                          "torque along the path: a signal, or a moment; without it the torque follows")
                                   .field(&Motor::working_arc, "working_arc", "alpha", si::rad,
                                          "part of the wrap that transmits force (Andreev); default: the whole wrap")
                                   .above(0)
                                   .at_most(1e3);
  return d;
}

const Description& Drive::describe() {
  static const Description d =
      Describe<Drive>()
          .field(&Drive::speed, "speed",
                 "rope speed, taking in > 0: a signal, or a speed; in statics the drum does not turn")
          .field(&Drive::torque, "torque",
                 "torque, taking in > 0: a signal, or a moment; in statics the tension of the rope follows from it if "
                 "nothing else is given")
          .field(&Drive::pull, "pull", "tension of the rope where it leaves the drum: a signal, or a force")
          .choice(&Drive::brake, "brake", {{"set", Brake::set}, {"open", Brake::open}},
                  "set: the brake holds against any drive, up to 'brake_torque'; open without a drive: the drum turns "
                  "freely");
  return d;
}

const Description& Drum::describe() {
  static const Description d =
      Describe<Drum>()
          .field(&Drum::at, "at", "", si::m, "centre, in the frame of its body, or of the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .or_map(&Drum::over_ground)
          .required()
          .field(&Drum::body, "body", "the body that carries it; default: the ground")
          .field(&Drum::axis, "axis", "", si::one,
                 "direction of its axis, in the frame of its body; default: [0, 1, 0]")
          .field(&Drum::core_diameter, "core_diameter", "D", si::m.in("mm"), "diameter of the bare drum; 0: a point")
          .at_most(farthest)
          .at_least(0)
          .field(&Drum::layer, "layer", "k", si::one, "the layer from which the rope leaves; default: the first")
          .at_least(1)
          .record(&Drum::drive, "drive", "drive; without it the drum does not turn")
          .choice(&Drum::layers, "layers", {{"auto", Layers::automatic}},
                  "the layer follows from the length on the drum")
          .field(&Drum::length_on_drum, "length_on_drum", "L", si::m,
                 "unstretched rope on the drum, of each rope and copy that winds on it")
          .at_most(farthest)
          .at_least(0)
          .field(&Drum::wound_at, "wound_at", "T", si::N,
                 "winding tension of the rope on the drum; default: 0, in motion the tension at the start")
          .at_most(strongest)
          .at_least(0)
          .field(&Drum::face_width, "face_width", "B", si::m.in("mm"), "width between the flanges")
          .at_most(farthest)
          .above(0)
          .field(&Drum::flange_diameter, "flange_diameter", "D_f", si::m.in("mm"),
                 "flange diameter, which limits the layers")
          .at_most(farthest)
          .above(0)
          .field(&Drum::pitch, "pitch", "p", si::m.in("mm"), "distance from wrap to wrap; default: the rope diameter")
          .at_most(farthest)
          .above(0)
          .field(&Drum::layer_height, "layer_height", "h", si::m.in("mm"),
                 "distance from layer to layer; default: the rope diameter")
          .at_most(farthest)
          .above(0)
          .field(&Drum::inertia, "inertia", "J", si::kg_m2,
                 "moment of inertia of everything that turns with it; used in motion only")
          .at_least(0)
          .field(&Drum::drag, "drag", "c", si::N_m_s,
                 "viscous drag of its turning: moment by angular velocity; used in motion only, with an 'inertia'")
          .at_least(0)
          .at_most(strongest)
          .field(&Drum::brake_torque, "brake_torque", "M_b", si::N_m,
                 "moment above which the drum turns in its brake: in motion, and as a check at rest; default: it holds "
                 "anything")
          .above(0)
          .at_most(strongest)
          .field(&Drum::brake_delay, "brake_delay", "dt", si::s, "time from setting the brake until it begins to act")
          .at_least(0)
          .at_most(slowest)
          .field(&Drum::brake_rise, "brake_rise", "dt", si::s, "time in which its moment then grows to the full one")
          .at_least(0)
          .at_most(slowest);
  return d;
}

const Description& RopeLoad::describe() {
  static const Description d =
      Describe<RopeLoad>()
          .field(&RopeLoad::rope, "rope", "the reeving on which it acts")
          .required()
          .field(&RopeLoad::between, "between", "two neighbours of its path, the ends of the branch")
          .required()
          .field(&RopeLoad::tangential, "tangential", "F", si::N,
                 "force along the rope, in statics; without it and 'rate' the force that balances the motor's torque")
          .at_most(strongest)
          .at_least(0)
          .field(&RopeLoad::rate, "rate", "q", si::N_per_m, "force per unstretched metre, over a part of the branch")
          .at_most(strongest)
          .at_least(0)
          .choice(&RopeLoad::direction, "direction",
                  {{"against_motion", RopeLoadDirection::against_motion},
                   {"with_motion", RopeLoadDirection::with_motion},
                   {"along_path", RopeLoadDirection::along_path},
                   {"against_path", RopeLoadDirection::against_path}},
                  "direction of the force on the rope; at rest the motion is 'in'")
          .field(&RopeLoad::position, "position", "", si::one,
                 "place as a fraction of the unstretched branch, from the first of 'between'; default: 0.5")
          .above(0)
          .below(1)
          .field(&RopeLoad::from, "from", "", si::one, "fraction at which a rate begins; default: 0")
          .at_least(0)
          .at_most(1)
          .field(&RopeLoad::to, "to", "", si::one, "fraction at which a rate ends; default: 1")
          .at_least(0)
          .at_most(1)
          .field(&RopeLoad::elements, "elements", "n", si::one,
                 "number of parts into which a rate is divided; default: up to 16")
          .at_least(1)
          .at_most(64)
          .field(&RopeLoad::signal, "signal",
                 "in motion the force, or the rate, over time: a signal, whose sign does not count against the motion; "
                 "statics takes 'tangential' or 'rate'")
          .field(&RopeLoad::name, "name", "name in tables; default: ROPE.load");
  return d;
}

}  // namespace taut::machine::description
