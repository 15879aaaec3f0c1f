#include "taut/machine/description/machine.hpp"

#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine {

const Description& Machine::describe() {
  static const Description d =
      Describe<Machine>()
          .field(&Machine::gravity, "gravity", "g", si::m_per_s2, "acceleration of free fall, along -z")
          .at_most(1e4)
          .at_least(0)
          .field(&Machine::temperature, "temperature", "", si::K.in("degC"),
                 "temperature of all ropes and beams, such as 15 degC")
          .at_least(0)
          .at_most(description::hottest)
          .named_records(&Machine::points, "points", "points of the ground or of a body")
          .shorthand("at")
          .named_records(&Machine::ropes, "ropes", "properties of ropes")
          .shorthand("rope")
          .named_records(&Machine::bodies, "bodies", "rigid bodies")
          .named_records(&Machine::sheaves, "sheaves", "sheaves and saddles")
          .named_records(&Machine::supports, "supports", "supports of a standing line: saddles")
          .named_records(&Machine::drums, "drums", "winch drums")
          .named_records(&Machine::carriages, "carriages", "carriages on a rope")
          .record(&Machine::reevings, "reevings", "paths of the ropes")
          .record(&Machine::loads, "loads", "weights and forces of constant direction")
          .record(&Machine::rope_loads, "rope_loads", "forces along a branch of a rope")
          .record(&Machine::take_up, "take_up", "weights and screws that tighten ropes")
          .named_records(&Machine::guys, "guys", "ropes between two anchors, put up by tension or length")
          .named_records(&Machine::beams, "beams", "elastic struts and masts")
          .record(&Machine::terrain, "terrain", "ground under the line")
          .named_records(&Machine::signals, "signals", "quantities over time; a signal that no key uses has no effect")
          .shorthand("constant")
          .named_records(&Machine::markers, "markers", "places on bodies, for contacts and observed quantities")
          .shorthand("at")
          .named_records(&Machine::faces, "faces", "plane faces of bodies, for contacts")
          .record(&Machine::contacts, "contacts", "points of bodies on faces of others")
          .named_records(&Machine::actuators, "actuators", "cylinders")
          .record(&Machine::tensioners, "tensioners", "lengths of ropes changed by a signal")
          .record(&Machine::events, "events", "events of a transient, at a time or on a condition")
          .field(&Machine::observe, "observe",
                 "quantities that a transient records: car.z, skyline.T_max, ext[2].T, ext[2,7].x (joint 7 of a branch "
                 "in segments); default: tensions of ropes, places of free bodies, speeds of drums and motors, forces "
                 "of contacts and cylinders")
          .named_records(&Machine::measures, "measures",
                         "quantities of a motion under names of their own, recorded in addition to those of 'observe'");
  return d;
}

}  // namespace taut::machine

namespace taut::machine::description {

const Description& Point::describe() {
  static const Description d =
      Describe<Point>()
          .field(&Point::at, "at", "", si::m, "place in the frame of its body, or of the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .or_map(&Point::over_ground)
          .required()
          .field(&Point::body, "body", "the body to which it belongs; default: the ground");
  return d;
}

const Description& Rope::describe() {
  static const Description d =
      Describe<Rope>()
          .field(&Rope::rope, "rope",
                 "id in the catalogue of ropes, as 'taut list ropes' shows it, or the properties of one of its ropes: "
                 "'6x36-IWRC 20 mm 1960 MPa'")
          .field(&Rope::mass, "mass", "m", si::kg_per_m, "mass per unstretched metre")
          .at_most(heaviest)
          .at_least(0)
          .field(&Rope::stiffness, "stiffness", "EA", si::N.in("MN"),
                 "axial stiffness EA; default for a rope of the catalogue: metallic area times a modulus by "
                 "construction; .inf: inextensible")
          .above(0)
          .may_be_infinite()
          .field(&Rope::breaking_force, "breaking_force", "F_min", si::N, "minimum breaking force")
          .above(0)
          .field(&Rope::diameter, "diameter", "d", si::m.in("mm"), "nominal diameter")
          .at_most(farthest)
          .above(0)
          .field(&Rope::expansion, "expansion", "a", si::per_K, "thermal expansion")
          .at_least(-most_expansion)
          .at_most(most_expansion)
          .field(&Rope::reference_temperature, "reference_temperature", "", si::K.in("degC"),
                 "temperature at which lengths are given; default: that of the machine")
          .at_least(0)
          .at_most(hottest)
          .field(&Rope::damping_ratio, "damping_ratio", "zeta", si::one,
                 "damping ratio of the lowest mode that stretches it; used in motion only")
          .at_least(0)
          .field(&Rope::damping_time, "damping_time", "beta", si::s, "T = EA (e + beta e'); used in motion only")
          .at_least(0);
  return d;
}

const Description& Turned::describe() {
  static const Description d = Describe<Turned>()
                                   .field(&Turned::rx, "rx", "", si::rad.in("deg"), "about x, first")
                                   .field(&Turned::ry, "ry", "", si::rad.in("deg"), "then about y")
                                   .field(&Turned::rz, "rz", "", si::rad.in("deg"), "then about z");
  return d;
}

const Description& Body::describe() {
  static const Description d =
      Describe<Body>()
          .field(&Body::mass, "mass", "m", si::kg, "mass; its weight acts at the centre of mass")
          .at_most(heaviest)
          .at_least(0)
          .field(&Body::at, "at", "", si::m, "place of its origin; of a free body a first guess")
          .at_least(-farthest)
          .at_most(farthest)
          .or_map(&Body::over_ground)
          .field(&Body::centre, "centre", "", si::m, "centre of mass relative to the origin; default: there")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&Body::free, "free",
                 "degrees of freedom along and about the axes of the ground, of a body 'on' another along and about "
                 "those of that "
                 "one at the start; none: fixed")
          .of({"x", "y", "z", "rx", "ry", "rz"})
          .field(&Body::guide, "guide", "", si::one, "direction of its only translation, a slide")
          .field(&Body::inertia, "inertia", "J", si::kg_m2,
                 "about the centre of mass: one for all axes, or Ixx, Iyy, Izz; used in motion only")
          .at_least(0)
          .record(&Body::motion, "motion", "given motion; statics takes its place at the start")
          .record(&Body::turned, "turned",
                  "rotations about the axes of the ground at the start, right-handed; of a free body a first guess")
          .field(&Body::on, "on",
                 "the body in whose frame at the start its place, axes, freedoms and guide are given; default: the "
                 "ground");
  return d;
}

const Description& Round::describe() {
  static const Description d =
      Describe<Round>()
          .field(&Round::at, "at", "", si::m, "centre, in the frame of its body, or of the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .or_map(&Round::over_ground)
          .required()
          .field(&Round::body, "body", "the body that carries it; default: the ground")
          .field(&Round::diameter, "diameter", "D", si::m.in("mm"),
                 "pitch diameter, to the centre of the rope; 0: a point")
          .at_most(farthest)
          .at_least(0)
          .field(&Round::axis, "axis", "", si::one,
                 "direction of its axis, in the frame of its body; default: [0, 1, 0], on the ground across the line "
                 "in plan")
          .choice(&Round::law, "law", {{"sheave", RoundLaw::sheave}, {"saddle", RoundLaw::saddle}},
                  "a sheave turns (default in sheaves), a saddle does not (default in supports)")
          .field(&Round::friction, "friction", "mu", si::one,
                 "friction coefficient of the rope in the groove; on a sheave without it the rope does not slip")
          .at_least(0)
          .field(&Round::efficiency, "efficiency", "eta", si::one, "T_small/T_large over the turning sheave")
          .above(0)
          .at_most(1)
          .choice(&Round::uplift, "uplift",
                  {{"hold", Uplift::hold}, {"report", Uplift::report}, {"lift", Uplift::lift}},
                  "where the rope pulls upwards: hold it (default of a sheave), report it (default of a saddle), or "
                  "let it lift off")
          .field(&Round::inertia, "inertia", "J", si::kg_m2, "moment of inertia; used in motion only; default: none")
          .at_least(0)
          .field(&Round::drag, "drag", "c", si::N_m_s,
                 "viscous drag of its turning: moment by angular velocity; used in motion only, with an 'inertia'")
          .at_least(0)
          .at_most(strongest)
          .field(&Round::holds, "holds",
                 "'ahead_of CARRIAGE': it holds a rope that ends at this carriage only while the carriage has not "
                 "passed it; default: always")
          .field(
              &Round::one_wheel, "one_wheel",
              "true: one wheel with a groove for each rope, and each turn of one, that runs over it; default: "
              "sheaves beside each other that turn by themselves, each with the inertia and drag, one for each of the "
              "'copies' of a rope too; a driven sheave is always one wheel")
          .record(&Round::motor, "motor", "the sheave drives its rope");
  return d;
}

const Description& PathElement::describe() {
  static const Description d =
      Describe<PathElement>()
          .field(&PathElement::anchor, "anchor",
                 "the rope is fixed to this point, body, carriage or centre of a sheave")
          .field(&PathElement::over, "over", "the rope runs over this sheave or support")
          .field(&PathElement::through, "through", "the rope carries this carriage")
          .field(&PathElement::drum, "drum", "the rope is wound on this drum")
          .field(&PathElement::parts, "parts", "n", si::one, "parts of the rope between two sheaves of a tackle")
          .at_least(1)
          .at_most(64)
          .field(&PathElement::between, "between", "the two sheaves of the tackle, 'over' and another one")
          .field(&PathElement::turns, "turns", "", si::one,
                 "whole turns round the sheave or support, as on a capstan or a bollard, besides the wrap between its "
                 "neighbours")
          .at_least(0)
          .at_most(20)
          .choice(&PathElement::side, "side", {{"left", Side::left}, {"right", Side::right}},
                  "side of the path on which the sheave or drum lies, looking along its axis; default: by the bend of "
                  "the rope in equilibrium")
          .field(&PathElement::grip, "grip",
                 "of an endless rope that passes its carriage twice: true where it is fixed to the carriage")
          .exactly_one({"anchor", "over", "through", "drum"});
  return d;
}

const Description& PutUp::describe() {
  static const Description d =
      Describe<PutUp>()
          .field(&PutUp::tension, "tension", "T", si::N, "base tension, when the line is put up")
          .at_most(strongest)
          .required()
          .above(0)
          .choice(&PutUp::at, "at", {{"start", BaseTensionAt::start}, {"end", BaseTensionAt::end}},
                  "the end of its path that has this tension")
          .field(&PutUp::with, "with",
                 "carriages, bodies and named loads on the line while it is put up; default: the line is empty");
  return d;
}

const Description& Reeving::describe() {
  static const Description d =
      Describe<Reeving>()
          .field(&Reeving::rope, "rope", "one of the ropes")
          .required()
          .field(&Reeving::name, "name", "name in tables and references; default: the name of the rope")
          .record(&Reeving::path, "path", "elements from end to end")
          .required()
          .field(&Reeving::length, "length", "L", si::m, "unstretched length of the rope from end to end")
          .at_most(farthest)
          .above(0)
          .field(&Reeving::tension_at_start, "tension_at_start", "T", si::N,
                 "in place of the length: tension that is constant in every state at rest, as by a counterweight; a "
                 "motion begins with it and keeps the length")
          .at_most(strongest)
          .above(0)
          .field(&Reeving::tension_at_end, "tension_at_end", "T", si::N,
                 "in place of the length: tension that is constant in every state at rest, as by a counterweight; a "
                 "motion begins with it and keeps the length")
          .at_most(strongest)
          .above(0)
          .field(
              &Reeving::tension_equals, "tension_equals",
              "in place of the length: a rope; at rest as described both have the same tension at the start of their "
              "paths, and the length found there is kept")
          .record(&Reeving::install, "install",
                  "in place of the length: tension when the line is put up; the length found there is kept")
          .field(&Reeving::copies, "copies", "n", si::one, "number of equal parallel ropes")
          .at_least(1)
          .choice(&Reeving::haul, "haul", {{"to_start", Haul::to_start}, {"to_end", Haul::to_end}},
                  "direction when hoisting or hauling in; default: to its drum or given tension, a mainline or "
                  "haulback off from its carriage, others as these draw them along")
          .field(&Reeving::segments, "segments", "n", si::one,
                 "in motion the number of segments of each branch, with the mass of the rope at their joints, which "
                 "may run over rounds and onto drums")
          .at_least(1)
          .at_most(1000)
          .field(&Reeving::may_slack, "may_slack", "true: it may go slack without an unsafe warning")
          .field(&Reeving::closed, "closed", "an endless rope, from the last element back to the first");
  return d;
}

const Description& Load::describe() {
  static const Description d =
      Describe<Load>()
          .field(&Load::at, "at", "a body, a carriage, or a point or sheave on one")
          .required()
          .field(&Load::name, "name", "name for paths and for 'with'")
          .field(&Load::mass, "mass", "m", si::kg, "mass; its weight acts downwards")
          .at_most(heaviest)
          .at_least(0)
          .field(&Load::force, "force", "F", si::N, "force in the ground frame")
          .at_least(-strongest)
          .at_most(strongest)
          .field(
              &Load::signal, "signal",
              "in motion the size of the force over time, in the direction of 'force': a signal; statics takes 'force'")
          .record(&Load::dragged, "dragged", "the mass is a bunch of logs that drags one end over the ground")
          .exactly_one({"mass", "force"});
  return d;
}

const Description& TakeUp::describe() {
  static const Description d =
      Describe<TakeUp>()
          .field(&TakeUp::body, "body", "the body that is pulled")
          .required()
          .field(&TakeUp::weight, "weight", "m", si::kg, "a counterweight of this mass on a rope without loss")
          .at_most(heaviest)
          .at_least(0)
          .field(&TakeUp::screw, "screw", "F", si::N, "its force; in which states, 'keeps' says")
          .at_most(strongest)
          .at_least(0)
          .choice(&TakeUp::keeps, "keeps", {{"place", ScrewKeeps::place}, {"force", ScrewKeeps::force}},
                  "of a screw: its place, where it pulls with its force at rest without the machine's loads; or its "
                  "force in every state, as a ram does. Default: its force, and the machine is not judged")
          .field(&TakeUp::along, "along", "", si::one, "direction of its pull, in the ground frame")
          .exactly_one({"weight", "screw"});
  return d;
}

const Description& Install::describe() {
  static const Description d =
      Describe<Install>()
          .field(&Install::tension, "tension", "T", si::N, "tension when it is put up, machine unloaded")
          .at_most(strongest)
          .required()
          .above(0)
          .choice(&Install::at, "at", {{"top", InstallAt::top}, {"anchor", InstallAt::anchor}},
                  "end with this tension: 'from' (top) or 'to' (anchor)");
  return d;
}

const Description& Guy::describe() {
  static const Description d =
      Describe<Guy>()
          .field(&Guy::rope, "rope", "one of the ropes")
          .required()
          .field(&Guy::from, "from", "upper end: a point, body, carriage or centre of a sheave")
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
                 "CSV in metres: columns chainage (or x) and z, chainage increasing; or x, y, z of a survey")
          .field(&Terrain::x, "x", "x", si::m, "chainages, increasing; with 'y': x in the ground frame")
          .field(&Terrain::y, "y", "y", si::m, "of a survey: y in the ground frame; its rows are projected on the line")
          .field(&Terrain::z, "z", "z", si::m, "height of the ground there")
          .field(&Terrain::between, "between",
                 "two points: the line runs from the first (chainage 0) to the second; default for a survey: from its "
                 "first to its last row")
          .field(
              &Terrain::corridor, "corridor", "", si::m,
              "a warning names surveyed rows, and ropes with a carriage, farther off the line than this; a clearance "
              "that is asked of such a rope is not judged")
          .at_least(0)
          .field(&Terrain::from, "from", "", si::m,
                 "place with chainage 0, [x, y] in the ground frame; for lines oblique to the axes")
          .field(&Terrain::along, "along", "", si::one, "horizontal direction of the chainage, [x, y]");
  return d;
}

}  // namespace taut::machine::description
