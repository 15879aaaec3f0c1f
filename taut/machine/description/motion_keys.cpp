#include "taut/machine/description/motion_keys.hpp"

#include <numbers>

#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine::description {

namespace {

constexpr double longest = 3.2e7;  ///< a year, within which a motion ends, s

}  // namespace

const Description& Move::describe() {
  static const Description d =
      Describe<Move>()
          .field(&Move::at, "at", "t", si::s, "time at which it begins")
          .at_least(0)
          .at_most(longest)
          .field(&Move::to, "to", "the value after the change, with its unit")
          .required()
          .field(&Move::over, "over", "dt", si::s, "duration; 0: a jump")
          .at_least(0)
          .at_most(longest)
          .field(&Move::smooth, "smooth", "rate and acceleration are zero at both ends")
          .field(&Move::half_cosine, "half_cosine", "half a cosine: the rate is zero at both ends");
  return d;
}

const Description& Ramp::describe() {
  static const Description d =
      Describe<Ramp>()
          .field(&Ramp::from, "from", "the value before, with its unit; default: 0")
          .field(&Ramp::to, "to", "the value after, with its unit")
          .required()
          .field(&Ramp::start, "start", "t", si::s, "time at which it begins")
          .at_least(0)
          .at_most(longest)
          .field(&Ramp::duration, "duration", "dt", si::s, "duration; 0: a jump")
          .at_least(0)
          .at_most(longest)
          .required()
          .field(&Ramp::smooth, "smooth", "rate and acceleration are zero at both ends")
          .field(&Ramp::half_cosine, "half_cosine", "half a cosine: the rate is zero at both ends");
  return d;
}

const Description& SignalTable::describe() {
  static const Description d =
      Describe<SignalTable>()
          .field(&SignalTable::t, "t", "t", si::s, "times, increasing; outside them the first or last value holds")
          .required()
          .field(&SignalTable::value, "value", "values at these times, with their unit")
          .required()
          .choice(&SignalTable::interpolation, "interpolation",
                  {{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}},
                  "linear between them, or a cubic spline with slope zero at both ends");
  return d;
}

const Description& Sine::describe() {
  static const Description d = Describe<Sine>()
                                   .field(&Sine::mean, "mean", "mean value; default: 0")
                                   .field(&Sine::amplitude, "amplitude", "amplitude, with its unit")
                                   .required()
                                   .field(&Sine::frequency, "frequency", "f", si::per_s.in("Hz"), "cycles per time")
                                   .above(0)
                                   .field(&Sine::period, "period", "T", si::s, "time of a cycle")
                                   .above(0)
                                   .field(&Sine::phase, "phase", "", si::rad, "phase at time 0")
                                   .exactly_one({"frequency", "period"});
  return d;
}

const Description& Signal::describe() {
  static const Description d =
      Describe<Signal>()
          .field(&Signal::constant, "constant", "a constant value, with its unit")
          .record(&Signal::ramp, "ramp", "from one value to another")
          .record(&Signal::table, "table", "values at given times")
          .record(&Signal::sine, "sine", "mean + amplitude sin(2 pi f t + phase)")
          .record(&Signal::sequence, "sequence", "changes one after the other, beginning from 0")
          .field(
              &Signal::formula, "formula",
              "of the time t: numbers with their units, + - * / ^, pi, and the functions sqrt abs min max sin cos tan "
              "asin acos atan atan2: '0.5 m/s * sin(90 deg/s * t)'. Hz is 2 pi rad/s, no cycle more: 'sin(3 Hz * t)' "
              "swings 3 times a second, 'sin(2*pi*3 Hz * t)' 18.85 times")
          .exactly_one({"constant", "ramp", "table", "sine", "sequence", "formula"});
  return d;
}

const Description& BodyMotion::describe() {
  static const Description d =
      Describe<BodyMotion>()
          .field(&BodyMotion::x, "x", "displacement from its place along x: a signal, or a length")
          .field(&BodyMotion::y, "y", "along y: a signal, or a length")
          .field(&BodyMotion::z, "z", "along z: a signal, or a length")
          .field(&BodyMotion::rx, "rx", "rotation about x, right-handed: a signal, or an angle")
          .field(&BodyMotion::ry, "ry", "rotation about y, right-handed: a signal, or an angle")
          .field(&BodyMotion::rz, "rz", "rotation about z, right-handed: a signal, or an angle");
  return d;
}

const Description& OverGround::describe() {
  static const Description d =
      Describe<OverGround>()
          .field(&OverGround::chainage, "chainage", "", si::m, "place of the foot along the line of the terrain")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&OverGround::offset, "offset", "", si::m,
                 "of the foot to the left of the line, seen towards growing chainage")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&OverGround::over_ground, "over_ground", "h", si::m,
                 "height over the ground at the foot, measured along the support")
          .at_least(0)
          .at_most(farthest)
          .required()
          .field(&OverGround::lean, "lean", "", si::rad.in("deg"),
                 "of the support from the vertical, towards growing chainage")
          .above(-std::numbers::pi / 2)
          .below(std::numbers::pi / 2);
  return d;
}

const Description& Marker::describe() {
  static const Description d =
      Describe<Marker>()
          .field(&Marker::at, "at", "", si::m, "place in the frame of its body, or of the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .or_map(&Marker::over_ground)
          .required()
          .field(&Marker::body, "body", "the body to which it belongs; default: the ground");
  return d;
}

const Description& Face::describe() {
  static const Description d =
      Describe<Face>()
          .field(&Face::body, "body", "the body to which it belongs; default: the ground")
          .field(&Face::from, "from", "", si::m, "one end, in the frame of its body")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&Face::to, "to", "", si::m, "the other end; there is no contact beyond the ends")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&Face::normal, "normal", "", si::one,
                 "direction out of the body, towards the points without contact; default: [0, 0, 1]");
  return d;
}

const Description& FaceContact::describe() {
  static const Description d =
      Describe<FaceContact>()
          .field(&FaceContact::name, "name", "name in tables; default: the name of its point")
          .field(&FaceContact::point, "point", "a point or marker of one body")
          .required()
          .field(&FaceContact::face, "face", "a face of another body")
          .required()
          .field(&FaceContact::stiffness, "stiffness", "k", si::N_per_m, "stiffness normal to the face")
          .above(0)
          .required()
          .field(&FaceContact::damping, "damping", "c", si::N_s_per_m, "damping normal to the face, while in contact")
          .at_least(0)
          .field(&FaceContact::tangential_stiffness, "tangential_stiffness", "k_t", si::N_per_m,
                 "stiffness along the face while it sticks; default: half of the stiffness")
          .above(0)
          .field(&FaceContact::tangential_damping, "tangential_damping", "c_t", si::N_s_per_m,
                 "damping along the face while it sticks; default: half of the damping")
          .at_least(0)
          .field(&FaceContact::clearance, "clearance", "", si::m.in("mm"), "gap that has to close first")
          .at_least(0)
          .field(&FaceContact::static_friction, "static_friction", "f_0", si::one, "static friction coefficient")
          .at_least(0)
          .field(&FaceContact::kinetic_friction, "kinetic_friction", "f_inf", si::one,
                 "kinetic friction coefficient, of fast sliding; default: the static one")
          .at_least(0)
          .field(&FaceContact::stribeck_speed, "stribeck_speed", "v_s", si::m_per_s,
                 "sliding speed over which friction falls from static to kinetic; default: 0.01 m/s")
          .above(0);
  return d;
}

const Description& ActuatorLaw::describe() {
  static const Description d =
      Describe<ActuatorLaw>()
          .field(&ActuatorLaw::F0, "F0", "F_0", si::N, "force at the reference speed")
          .at_least(-strongest)
          .at_most(strongest)
          .required()
          .field(&ActuatorLaw::gain, "gain", "r", si::N_s_per_m, "force per difference of speed")
          .at_least(0)
          .required()
          .field(&ActuatorLaw::reference, "reference", "the reference speed: a signal, or a speed")
          .required();
  return d;
}

const Description& Actuator::describe() {
  static const Description d =
      Describe<Actuator>()
          .field(&Actuator::from, "from", "a point, marker or body")
          .required()
          .field(&Actuator::to, "to", "a point, marker or body")
          .required()
          .field(&Actuator::force, "force", "pushes the two apart: a signal, or a force")
          .record(&Actuator::law, "law", "force F0 + gain (reference - speed)")
          .field(&Actuator::speed, "speed", "speed at which the two move apart: a signal, or a speed")
          .choice(
              &Actuator::mode, "mode",
              {{"extend", ActuatorMode::extend},
               {"retract", ActuatorMode::retract},
               {"lock", ActuatorMode::lock},
               {"free", ActuatorMode::free}},
              "retract: reference speed reversed, without F0; lock: constant length; free: no force. Locked or free, "
              "and set to nothing else by an event, it needs no force, law or speed")
          .field(&Actuator::lock_stiffness, "lock_stiffness", "k", si::N_per_m, "stiffness while it is locked")
          .above(0)
          .field(&Actuator::lock_damping, "lock_damping", "c", si::N_s_per_m,
                 "damping while it is locked; default: none")
          .at_least(0)
          .field(&Actuator::force_limit, "force_limit", "F_max", si::N,
                 "largest force in both directions, unless locked; default: no limit")
          .above(0);
  return d;
}

const Description& Tensioner::describe() {
  static const Description d =
      Describe<Tensioner>()
          .field(&Tensioner::reeving, "reeving", "a reeving by name, or by its number from 1")
          .required()
          .choice(&Tensioner::end, "end", {{"start", RopeEnd::start}, {"end", RopeEnd::end}}, "end of the rope")
          .field(&Tensioner::change, "change",
                 "change of the unstretched length: a signal, or a length; positive lengthens")
          .required();
  return d;
}

const Description& Event::describe() {
  static const Description d =
      Describe<Event>()
          .field(&Event::at, "at", "t", si::s, "time of the event")
          .at_least(0)
          .at_most(longest)
          .field(&Event::when, "when",
                 "condition at which the event occurs, 'car.z > 12 m', with any quantity that 'observe' takes")
          .field(&Event::over, "over", "dt", si::s, "of a break: time in which the tension falls to zero")
          .at_least(0)
          .at_most(longest)
          .field(&Event::breaks, "break", "a reeving that breaks, or one of its branches: ext[2]")
          .field(&Event::stop, "stop", "true: the run ends")
          .field(&Event::actuator, "actuator", "an actuator that changes its mode")
          .field(&Event::brake, "brake", "a drum whose brake is set, or with 'mode: open' opened")
          .field(&Event::drive, "drive",
                 "a drum or driven sheave that gets a new speed, torque or pull; a brake that is set stays set")
          .field(&Event::mode, "mode",
                 "new mode of an actuator: extend, retract, lock, free; of a brake: set (the default), open")
          .field(&Event::speed, "speed", "new speed of a drive: a signal, or a speed")
          .field(&Event::torque, "torque", "new torque of a drive: a signal, or a moment")
          .field(&Event::pull, "pull", "new pull of a drum drive: a signal, or a force")
          .exactly_one({"at", "when"})
          .exactly_one({"break", "stop", "actuator", "brake", "drive"});
  return d;
}

}  // namespace taut::machine::description
