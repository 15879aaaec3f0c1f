#include "taut/machine/description/machine.hpp"

#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine {

const Description& Machine::describe() {
  static const Description d =
      Describe<Machine>()
          .field(&Machine::gravity, "gravity", "g", si::m_per_s2, "acceleration of free fall, along -z")
          .at_most(1e4)
          .at_least(0)
          .field(&Machine::temperature, "temperature", "", si::K.in("degC"), "of all ropes, such as 15 degC")
          .at_least(0)
          .named_records(&Machine::points, "points", "points of the ground or of a body")
          .shorthand("at")
          .named_records(&Machine::ropes, "ropes", "properties of ropes")
          .shorthand("rope")
          .named_records(&Machine::bodies, "bodies", "rigid bodies")
          .named_records(&Machine::sheaves, "sheaves", "sheaves and saddles")
          .named_records(&Machine::supports, "supports", "supports of a standing line: saddles")
          .named_records(&Machine::drums, "drums", "winch drums")
          .named_records(&Machine::carriages, "carriages", "carriages on a rope")
          .record(&Machine::reevings, "reevings", "which rope runs where")
          .record(&Machine::loads, "loads", "dead loads")
          .record(&Machine::rope_loads, "rope_loads", "forces along a rope between two of its neighbours")
          .record(&Machine::take_up, "take_up", "weights and screws that keep ropes tight")
          .named_records(&Machine::guys, "guys", "ropes from anchor to anchor, put up by tension or length")
          .named_records(&Machine::beams, "beams", "elastic struts and masts")
          .record(&Machine::terrain, "terrain", "ground under the line")
          .named_records(&Machine::signals, "signals", "quantities over time; where they are not used they do nothing")
          .shorthand("constant")
          .named_records(&Machine::markers, "markers", "places on bodies for contacts and observers")
          .shorthand("at")
          .named_records(&Machine::faces, "faces", "plane faces of bodies, for contacts")
          .record(&Machine::contacts, "contacts", "points of bodies on faces of others")
          .named_records(&Machine::actuators, "actuators", "cylinders")
          .record(&Machine::tensioners, "tensioners", "lengths of ropes changed by a signal")
          .record(&Machine::events, "events", "what happens at a time or on a condition, in a transient")
          .field(&Machine::observe, "observe",
                 "what a transient writes down: car.z, skyline.T_max, ext[2].T; without it the usual quantities")
          .named_records(&Machine::measures, "measures",
                         "quantities of a motion under names of their own, written down beside what 'observe' names");
  return d;
}

}  // namespace taut::machine

namespace taut::machine::description {

const Description& Point::describe() {
  static const Description d =
      Describe<Point>()
          .field(&Point::at, "at", "", si::m, "place in the frame of its body, or the ground's")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&Point::body, "body", "the body it belongs to; without it the ground");
  return d;
}

const Description& Rope::describe() {
  static const Description d =
      Describe<Rope>()
          .field(&Rope::rope, "rope", "id in the catalogue of ropes, as 'taut list ropes' shows it")
          .field(&Rope::mass, "mass", "m", si::kg_per_m, "mass per unstretched metre")
          .at_most(heaviest)
          .at_least(0)
          .field(
              &Rope::stiffness, "stiffness", "EA", si::N.in("MN"),
              "axial stiffness; of a rope of the catalogue without it metallic area times a modulus by construction; "
              ".inf: inextensible")
          .above(0)
          .may_be_infinite()
          .field(&Rope::breaking_force, "breaking_force", "F_min", si::N, "minimum breaking force")
          .above(0)
          .field(&Rope::diameter, "diameter", "d", si::m.in("mm"), "nominal diameter")
          .at_most(farthest)
          .above(0)
          .field(&Rope::expansion, "expansion", "a", si::per_K, "thermal expansion")
          .field(&Rope::reference_temperature, "reference_temperature", "", si::K.in("degC"),
                 "at which its length holds; without it the machine's temperature")
          .at_least(0)
          .field(&Rope::damping_ratio, "damping_ratio", "zeta", si::one,
                 "of the lowest mode in which it stretches; in motion, statics does not depend on it")
          .at_least(0)
          .field(&Rope::damping_time, "damping_time", "beta", si::s,
                 "T = EA (e + beta e'); in motion, statics does not depend on it")
          .at_least(0);
  return d;
}

const Description& Body::describe() {
  static const Description d =
      Describe<Body>()
          .field(&Body::mass, "mass", "m", si::kg, "mass; its weight acts at the centre")
          .at_most(heaviest)
          .at_least(0)
          .field(&Body::at, "at", "", si::m, "place of its origin; where it is free, a first guess")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&Body::centre, "centre", "", si::m, "centre of mass, seen from the origin")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&Body::free, "free", "how it may move; nothing: fixed")
          .of({"x", "y", "z", "rx", "ry", "rz"})
          .field(&Body::guide, "guide", "", si::one, "direction of the slide on which alone it moves")
          .field(&Body::inertia, "inertia", "J", si::kg_m2,
                 "about the centre of mass: one for all axes, or Ixx, Iyy, Izz; statics does not depend on it")
          .at_least(0)
          .record(&Body::motion, "motion", "how it is driven; statics takes its place at the start")
          .field(
              &Body::on, "on",
              "the body in whose frame, as it is at the start, its place, axes and guide are given; else the ground's");
  return d;
}

const Description& Round::describe() {
  static const Description d =
      Describe<Round>()
          .field(&Round::at, "at", "", si::m, "centre, in the frame of its body, or the ground's")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&Round::body, "body", "the body it sits on; without it the ground")
          .field(&Round::diameter, "diameter", "D", si::m.in("mm"), "pitch diameter, at the rope's centre; 0: a point")
          .at_most(farthest)
          .at_least(0)
          .field(&Round::axis, "axis", "", si::one, "direction of its axis, in the frame of its body")
          .choice(&Round::law, "law", {{"sheave", RoundLaw::sheave}, {"saddle", RoundLaw::saddle}},
                  "a sheave turns (usual among sheaves), a saddle does not (usual among supports)")
          .field(&Round::friction, "friction", "mu", si::one, "of the rope in the groove; a sheave without it grips")
          .at_least(0)
          .field(&Round::efficiency, "efficiency", "eta", si::one, "of a turning sheave")
          .above(0)
          .at_most(1)
          .choice(&Round::uplift, "uplift",
                  {{"hold", Uplift::hold}, {"report", Uplift::report}, {"lift", Uplift::lift}},
                  "when the rope pulls upwards: hold it (usual for a sheave), report it (usual for a saddle), or let "
                  "it lift off")
          .field(&Round::inertia, "inertia", "J", si::kg_m2, "statics does not depend on it")
          .at_least(0)
          .record(&Round::motor, "motor", "the sheave drives its rope");
  return d;
}

const Description& PathElement::describe() {
  static const Description d =
      Describe<PathElement>()
          .field(&PathElement::anchor, "anchor", "the rope is fixed to this point, body, carriage or sheave's centre")
          .field(&PathElement::over, "over", "it runs over this sheave or support")
          .field(&PathElement::through, "through", "it carries this carriage")
          .field(&PathElement::drum, "drum", "it is wound on this drum")
          .field(&PathElement::parts, "parts", "n", si::one, "parts of the rope between two sheaves of a tackle")
          .at_least(1)
          .at_most(64)
          .field(&PathElement::between, "between", "the two sheaves of the tackle, 'over' and another one")
          .choice(&PathElement::side, "side", {{"left", Side::left}, {"right", Side::right}},
                  "where the sheave or drum lies beside the path, looking along its axis; without it the shorter way")
          .field(&PathElement::grip, "grip",
                 "an endless rope that passes its carriage twice: here it is fixed to it, there it carries it")
          .exactly_one({"anchor", "over", "through", "drum"});
  return d;
}

const Description& PutUp::describe() {
  static const Description d =
      Describe<PutUp>()
          .field(&PutUp::tension, "tension", "T", si::N, "base tension: when the line is put up")
          .at_most(strongest)
          .required()
          .above(0)
          .choice(&PutUp::at, "at", {{"start", BaseTensionAt::start}, {"end", BaseTensionAt::end}},
                  "the end of its path that has this tension")
          .field(&PutUp::with, "with",
                 "carriages, bodies and named loads that hang on the line while it is put up; without it the line is "
                 "empty");
  return d;
}

const Description& Reeving::describe() {
  static const Description d =
      Describe<Reeving>()
          .field(&Reeving::rope, "rope", "one of the ropes")
          .required()
          .field(&Reeving::name, "name", "for tables and links; without it the name of the rope")
          .record(&Reeving::path, "path", "from end to end")
          .required()
          .field(&Reeving::length, "length", "L", si::m, "unstretched length of the rope from end to end")
          .at_most(farthest)
          .above(0)
          .field(&Reeving::tension_at_start, "tension_at_start", "T", si::N,
                 "instead of the length: held constant in every state, as by a counterweight")
          .at_most(strongest)
          .above(0)
          .field(&Reeving::tension_at_end, "tension_at_end", "T", si::N,
                 "instead of the length: held constant in every state, as by a counterweight")
          .at_most(strongest)
          .above(0)
          .record(&Reeving::install, "install",
                  "instead of the length: tension when the line is put up; the length found there is kept")
          .field(&Reeving::copies, "copies", "n", si::one, "equal ropes beside each other")
          .at_least(1)
          .choice(&Reeving::haul, "haul", {{"to_start", Haul::to_start}, {"to_end", Haul::to_end}},
                  "which way it runs when hoisting or hauling in; without it to its drum or given tension, else to its "
                  "start")
          .field(&Reeving::segments, "segments", "n", si::one,
                 "in motion each free part is a chain of so many, with the rope's mass at their joints; 1: one piece")
          .at_least(1)
          .at_most(1000)
          .field(&Reeving::may_slack, "may_slack",
                 "it is meant to go slack; without it a slack rope is an unsafe warning")
          .field(&Reeving::closed, "closed", "an endless rope, from the last element back to the first");
  return d;
}

const Description& Load::describe() {
  static const Description d =
      Describe<Load>()
          .field(&Load::at, "at", "a body, a carriage, or a point or sheave on one")
          .required()
          .field(&Load::name, "name", "for paths and 'with'")
          .field(&Load::mass, "mass", "m", si::kg, "its weight acts downwards")
          .at_most(heaviest)
          .at_least(0)
          .field(&Load::force, "force", "F", si::N, "in the ground frame")
          .at_least(-strongest)
          .at_most(strongest)
          .record(&Load::dragged, "dragged", "the mass is a bunch of logs that drags one end over the ground")
          .exactly_one({"mass", "force"});
  return d;
}

const Description& TakeUp::describe() {
  static const Description d =
      Describe<TakeUp>()
          .field(&TakeUp::body, "body", "the body that it pulls")
          .required()
          .field(&TakeUp::weight, "weight", "m", si::kg, "a counterweight of this mass on a rope without loss")
          .at_most(heaviest)
          .at_least(0)
          .field(&TakeUp::screw, "screw", "F", si::N, "a force")
          .at_most(strongest)
          .at_least(0)
          .field(&TakeUp::along, "along", "", si::one, "direction of its pull, in the ground frame")
          .exactly_one({"weight", "screw"});
  return d;
}

const Description& Install::describe() {
  static const Description d =
      Describe<Install>()
          .field(&Install::tension, "tension", "T", si::N, "when it is put up, machine unloaded")
          .at_most(strongest)
          .required()
          .above(0)
          .choice(&Install::at, "at", {{"top", InstallAt::top}, {"anchor", InstallAt::anchor}},
                  "where: at its 'from' (top) or its 'to' (anchor)");
  return d;
}

const Description& Guy::describe() {
  static const Description d = Describe<Guy>()
                                   .field(&Guy::rope, "rope", "one of the ropes")
                                   .required()
                                   .field(&Guy::from, "from", "upper end: a point, body, carriage or sheave's centre")
                                   .required()
                                   .field(&Guy::to, "to", "lower end, its anchor")
                                   .required()
                                   .record(&Guy::install, "install", "tension when it is put up")
                                   .field(&Guy::length, "length", "L", si::m, "unstretched length")
                                   .at_most(farthest)
                                   .above(0)
                                   .exactly_one({"install", "length"});
  return d;
}

const Description& Terrain::describe() {
  static const Description d =
      Describe<Terrain>()
          .field(&Terrain::file, "file",
                 "CSV in metres: columns chainage (or x) and z, chainage growing; or x, y, z of a survey")
          .field(&Terrain::x, "x", "x", si::m, "places along the line, growing; with 'y' x of the ground frame")
          .field(&Terrain::y, "y", "y", si::m, "of a survey: y of the ground frame; its rows are projected on the line")
          .field(&Terrain::z, "z", "z", si::m, "height of the ground there")
          .field(&Terrain::between, "between",
                 "two points: the line runs from the first, where its chainage is 0, to the second; a survey without "
                 "it has the line from its first to its last row")
          .field(&Terrain::corridor, "corridor", "", si::m, "surveyed rows that are farther off the line get a warning")
          .at_least(0)
          .field(&Terrain::from, "from", "", si::m,
                 "where its x is 0, as [x, y] of the ground frame; for lines across the axes")
          .field(&Terrain::along, "along", "", si::one, "horizontal direction of its x, [x, y]");
  return d;
}

}  // namespace taut::machine::description
