#pragma once
// A made-up machine with a field of every kind, for the tests of this layer.

#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

namespace taut::io {

enum class Direction { inhaul, outhaul };

struct SampleRope {
  double diameter = 0;
  std::optional<double> strength;
  std::string construction = "6x36";

  static const Description& describe() {
    static const Description d = Describe<SampleRope>()
                                     .field(&SampleRope::diameter, "diameter", "d", si::m.in("mm"), "nominal diameter")
                                     .required()
                                     .above(0)
                                     .field(&SampleRope::strength, "strength", "F_min", si::N, "breaking force")
                                     .above(0)
                                     .field(&SampleRope::construction, "construction", "name of the construction");
    return d;
  }
};

struct SampleCase {
  std::string name;
  double angle = 0;
  int falls = 2;

  static const Description& describe() {
    static const Description d = Describe<SampleCase>()
                                     .field(&SampleCase::name, "name", "what the case is")
                                     .required()
                                     .field(&SampleCase::angle, "angle", "alpha", si::rad, "luffing angle")
                                     .at_least(0)
                                     .at_most(85 * 0.017453292519943295)
                                     .field(&SampleCase::falls, "falls", "k", si::one, "number of falls")
                                     .at_least(1);
    return d;
  }
};

struct Sample {
  double span = 0;
  std::vector<double> positions = {1.0};
  double friction = 0.1;
  double stiffness = 1e6;
  bool uphill = false;
  Direction direction = Direction::inhaul;
  std::string note;
  std::optional<int> sheaves;
  SampleRope rope;
  std::optional<SampleRope> second_rope;
  std::vector<SampleCase> cases;

  static const Description& describe() {
    static const Description d =
        Describe<Sample>()
            .field(&Sample::span, "span", "l", si::m, "horizontal span")
            .required()
            .above(0)
            .field(&Sample::positions, "positions", "x", si::m, "positions of the carriage")
            .at_least(0)
            .field(&Sample::friction, "friction", "mu", si::one, "coefficient of friction")
            .at_least(0)
            .below(1)
            .field(&Sample::stiffness, "stiffness", "C", si::N_per_m.in("MN/m"), "stiffness of the rope")
            .above(0)
            .may_be_infinite()
            .field(&Sample::uphill, "uphill", "whether the load goes uphill")
            .choice(&Sample::direction, "direction", {{"inhaul", Direction::inhaul}, {"outhaul", Direction::outhaul}},
                    "which way the carriage goes")
            .field(&Sample::note, "note", "a remark")
            .field(&Sample::sheaves, "sheaves", "n", si::one, "number of sheaves")
            .at_least(0)
            .at_most(20)
            .record(&Sample::rope, "rope", "the working rope")
            .record(&Sample::second_rope, "second_rope", "the other rope")
            .record(&Sample::cases, "cases", "load cases");
    return d;
  }
};

struct SamplePin {
  std::string name;
  Triple at{};
  std::string colour = "red";
  std::vector<std::string> free;

  static const Description& describe() {
    static const Description d = Describe<SamplePin>()
                                     .field(&SamplePin::at, "at", "", si::m, "place")
                                     .required()
                                     .at_most(1000)
                                     .field(&SamplePin::colour, "colour", "of its paint")
                                     .field(&SamplePin::free, "free", "directions in which it moves")
                                     .of({"x", "y", "z"});
    return d;
  }
};

struct SampleTilt {
  double tilt = 0;

  static const Description& describe() {
    static const Description d = Describe<SampleTilt>()
                                     .field(&SampleTilt::tilt, "tilt", "", si::rad.in("deg"), "from the horizontal")
                                     .required();
    return d;
  }
};

struct SampleStop {
  std::optional<std::string> over;
  std::optional<std::string> anchor;
  std::optional<Triple> axis;
  std::optional<SampleTilt> tilted;

  static const Description& describe() {
    static const Description d = Describe<SampleStop>()
                                     .field(&SampleStop::over, "over", "a sheave")
                                     .field(&SampleStop::anchor, "anchor", "a pin")
                                     .field(&SampleStop::axis, "axis", "", si::one, "axis of the sheave")
                                     .or_map(&SampleStop::tilted)
                                     .exactly_one({"over", "anchor"})
                                     .later("spring", "springs come with the dynamics");
    return d;
  }
};

struct SampleSign {
  std::string name;
  std::string sense;

  static const Description& describe() {
    static const Description d = Describe<SampleSign>().field(&SampleSign::sense, "sense", "in or out").required();
    return d;
  }
};

/// Names, vectors, lists of texts, short forms, and keys of which one is given.
struct SampleMachine {
  std::vector<SamplePin> pins;
  std::vector<SampleStop> path;
  std::vector<SampleSign> motion;

  static const Description& describe() {
    static const Description d = Describe<SampleMachine>()
                                     .named_records(&SampleMachine::pins, "pins", "pins of the machine")
                                     .shorthand("at")
                                     .record(&SampleMachine::path, "path", "stops of the rope")
                                     .named_records(&SampleMachine::motion, "motion", "motion of the sheaves")
                                     .shorthand("sense")
                                     .one_for_all()
                                     .later("signals", "signals come with the dynamics");
    return d;
  }
};

}  // namespace taut::io
