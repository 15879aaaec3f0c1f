#include "taut/machine/description/machine.hpp"
#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine::description {

const Description& Motor::describe() {
  static const Description d =
      Describe<Motor>()
          .field(&Motor::speed, "speed", "of its rim, along the path: a signal, or a speed")
          .field(&Motor::torque, "torque", "along the path: a signal, or a moment; without it whatever the rope takes")
          .field(&Motor::working_arc, "working_arc", "alpha", si::rad,
                 "part of the wrap that can pull, after Andreev; without it all of it")
          .above(0)
          .at_most(1e3);
  return d;
}

const Description& Drive::describe() {
  static const Description d =
      Describe<Drive>()
          .field(&Drive::speed, "speed", "of the rope, taking in > 0: a signal, or a speed; in statics the drum holds")
          .field(&Drive::torque, "torque",
                 "taking in > 0: a signal, or a moment; in statics the rope's tension follows from it where nothing "
                 "else is "
                 "given")
          .field(&Drive::pull, "pull", "tension of the rope where it leaves the drum: a signal, or a force")
          .choice(&Drive::brake, "brake", {{"set", Brake::set}, {"open", Brake::open}},
                  "set: it holds, whatever drives it; open and nothing else: it turns freely");
  return d;
}

const Description& Drum::describe() {
  static const Description d =
      Describe<Drum>()
          .field(&Drum::at, "at", "", si::m, "centre, in the frame of its body, or the ground's")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&Drum::body, "body", "the body it sits on; without it the ground")
          .field(&Drum::axis, "axis", "", si::one, "direction of its axis")
          .field(&Drum::core_diameter, "core_diameter", "D", si::m.in("mm"), "of the bare drum; 0: a point")
          .at_most(farthest)
          .at_least(0)
          .field(&Drum::layer, "layer", "k", si::one, "the layer that the rope leaves; without it the first")
          .at_least(1)
          .record(&Drum::drive, "drive", "what drives it; nothing: it holds its rope")
          .choice(&Drum::layers, "layers", {{"auto", Layers::automatic}},
                  "the layer follows from the length on the drum")
          .field(&Drum::length_on_drum, "length_on_drum", "L", si::m, "unstretched rope on the drum")
          .at_most(farthest)
          .at_least(0)
          .field(&Drum::wound_at, "wound_at", "T", si::N, "tension at which the rope was wound; without it none")
          .at_most(strongest)
          .at_least(0)
          .field(&Drum::face_width, "face_width", "B", si::m.in("mm"), "between the flanges")
          .at_most(farthest)
          .above(0)
          .field(&Drum::flange_diameter, "flange_diameter", "D_f", si::m.in("mm"), "limits the layers")
          .at_most(farthest)
          .above(0)
          .field(&Drum::pitch, "pitch", "p", si::m.in("mm"), "from wrap to wrap; without it the rope's diameter")
          .at_most(farthest)
          .above(0)
          .field(&Drum::layer_height, "layer_height", "h", si::m.in("mm"),
                 "from layer to layer; without it the rope's diameter")
          .at_most(farthest)
          .above(0)
          .field(&Drum::inertia, "inertia", "J", si::kg_m2,
                 "with all that turns with it; statics does not depend on it")
          .at_least(0);
  return d;
}

const Description& RopeLoad::describe() {
  static const Description d =
      Describe<RopeLoad>()
          .field(&RopeLoad::rope, "rope", "the reeving it acts on")
          .required()
          .field(&RopeLoad::between, "between", "two neighbours of its path")
          .required()
          .field(&RopeLoad::tangential, "tangential", "F", si::N,
                 "force along the rope, in statics; without it and 'rate': what the motor's torque overcomes")
          .at_most(strongest)
          .at_least(0)
          .field(&RopeLoad::rate, "rate", "q", si::N_per_m,
                 "force per unstretched metre, spread over a part of the span")
          .at_most(strongest)
          .at_least(0)
          .choice(&RopeLoad::direction, "direction",
                  {{"against_motion", RopeLoadDirection::against_motion},
                   {"with_motion", RopeLoadDirection::with_motion},
                   {"along_path", RopeLoadDirection::along_path},
                   {"against_path", RopeLoadDirection::against_path}},
                  "of the force on the rope; at rest the motion is 'in'")
          .field(&RopeLoad::position, "position", "", si::one,
                 "share of the span's rope from the first of 'between' to the force; without it 0.5")
          .above(0)
          .below(1)
          .field(&RopeLoad::from, "from", "", si::one, "share where a rate begins; without it 0")
          .at_least(0)
          .at_most(1)
          .field(&RopeLoad::to, "to", "", si::one, "share where a rate ends; without it 1")
          .at_least(0)
          .at_most(1)
          .field(&RopeLoad::elements, "elements", "n", si::one,
                 "parts into which a rate is divided; without it up to 16")
          .at_least(1)
          .at_most(64)
          .field(&RopeLoad::signal, "signal",
                 "in motion the force, or the rate, over time: a signal; statics takes 'tangential' or 'rate'")
          .field(&RopeLoad::name, "name", "for tables; without it ROPE.load");
  return d;
}

}  // namespace taut::machine::description
