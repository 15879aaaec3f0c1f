#include "taut/study/requests/analysis_requests.hpp"

namespace taut::study {
namespace {

constexpr double farthest = 1e6;
constexpr double strongest = 1e12;
constexpr double heaviest = 1e9;

}  // namespace

const Description& RopeLimitRequest::describe() {
  static const Description d =
      Describe<RopeLimitRequest>()
          .field(&RopeLimitRequest::tension, "tension", "T", si::N, "of a rope: its largest tension, anywhere in it")
          .above(0)
          .at_most(strongest)
          .field(&RopeLimitRequest::safety_factor, "safety_factor", "S", si::one,
                 "of a rope: breaking force over its largest tension, at least")
          .above(0)
          .at_most(1000)
          .field(&RopeLimitRequest::rule, "rule",
                 "of a rope: id of a safety factor of the catalogue ('taut list rules'); checked, and the limit where "
                 "no other is given")
          .field(&RopeLimitRequest::clearance, "clearance", "c", si::m,
                 "of a rope: its least height over the ground between 'from' and 'to'")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&RopeLimitRequest::pull, "pull", "F", si::N, "of a drum: its largest pull")
          .above(0)
          .at_most(strongest);
  return d;
}

const Description& LimitsRequest::describe() {
  static const Description d =
      Describe<LimitsRequest>()
          .field(&LimitsRequest::clearance, "clearance", "c", si::m, "least height of the carriage over the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&LimitsRequest::rope_clearance, "rope_clearance", "c", si::m,
                 "least height over the ground of the rope that it rides on, between 'from' and 'to'")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&LimitsRequest::break_angle, "break_angle", "", si::rad,
                 "largest angle by which a rope bends over a support")
          .above(0)
          .at_most(6.4)
          .field(&LimitsRequest::least_break_angle, "least_break_angle", "", si::rad,
                 "smallest angle by which a rope bends over a support: keeps it in its saddle")
          .at_least(-1.6)
          .at_most(6.4)
          .field(&LimitsRequest::lift_off, "lift_off", "true: no rope may pull a support upwards or leave it")
          .named_records(&LimitsRequest::named, "ropes", "limits of a rope, or of a drum's pull, by its name")
          .rest();
  return d;
}

const Description& PayloadRequest::describe() {
  static const Description d =
      Describe<PayloadRequest>()
          .field(&PayloadRequest::name, "name", "ending of its tables' names, when a deck has several")
          .field(&PayloadRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&PayloadRequest::carriage, "carriage", "the carriage that carries the payload")
          .required()
          .field(&PayloadRequest::from, "from", "x", si::m, "first place of the carriage")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&PayloadRequest::to, "to", "x", si::m, "last place; the same as 'from' for one place")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&PayloadRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .field(&PayloadRequest::along, "along", "", si::one, "as for a load path")
          .named_records(&PayloadRequest::motion, "motion", "as for an equilibrium; at rest the band counts")
          .shorthand("sense")
          .one_for_all()
          .field(&PayloadRequest::held, "held", "as for an equilibrium, at every position")
          .record(&PayloadRequest::limits, "limits", "what must not be exceeded")
          .required()
          .field(&PayloadRequest::most, "most", "m", si::kg, "no payload above this is looked for")
          .above(0)
          .at_most(heaviest);
  return d;
}

const Description& GivenRequest::describe() {
  static const Description d =
      Describe<GivenRequest>()
          .field(&GivenRequest::reeving, "reeving", "the rope whose length (or given tension) follows")
          .required()
          .field(&GivenRequest::winch_pull, "winch_pull", "F", si::N, "tension at its start; its length follows")
          .above(0)
          .at_most(strongest)
          .field(&GivenRequest::loop_length, "loop_length", "L", si::m,
                 "its unstretched length, in place of the machine's")
          .above(0)
          .at_most(farthest)
          .field(&GivenRequest::sag, "sag", "f", si::m,
                 "of the carriage below the line between its supports; without a carriage of a free span at half its "
                 "horizontal length, below its chord")
          .above(0)
          .at_most(farthest)
          .field(&GivenRequest::free_running, "free_running",
                 "true: the carriage, rolling and without mainline, stands at its place by itself")
          .field(&GivenRequest::of, "of",
                 "the rope that the winch pulls, or all ropes of the loop, where it is not this one alone")
          .field(&GivenRequest::efficiency, "efficiency", "eta", si::one,
                 "of a winch's lead: the rope's tension is winch_pull times this")
          .above(0)
          .at_most(1)
          .choice(&GivenRequest::at, "at", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "where the winch pulls: at the start or the end of the rope's path")
          .field(&GivenRequest::span, "span", "", si::one,
                 "number of the free span of the rope that has the sag, from 1; without it the longest")
          .at_least(1)
          .exactly_one({"winch_pull", "loop_length", "sag", "free_running"});
  return d;
}

const Description& InstallationGivenRequest::describe() {
  static const Description d =
      Describe<InstallationGivenRequest>()
          .field(&InstallationGivenRequest::tension, "tension", "T", si::N, "of the empty rope at one end")
          .above(0)
          .at_most(strongest)
          .field(&InstallationGivenRequest::length, "length", "L", si::m,
                 "unstretched, at the reference temperature; without any of the three the machine's own")
          .above(0)
          .at_most(farthest)
          .field(&InstallationGivenRequest::sag, "sag", "f", si::m,
                 "of a free span at half its horizontal length, below its chord")
          .above(0)
          .at_most(farthest)
          .choice(&InstallationGivenRequest::at, "at", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "end of the path at which the tension is")
          .field(&InstallationGivenRequest::span, "span", "", si::one,
                 "number of the free span that has the sag, from 1; without it the longest")
          .at_least(1)
          .field(&InstallationGivenRequest::temperature, "temperature", "", si::K.in("degC"),
                 "at which it holds, the length found is kept at all others; without it it holds at each temperature "
                 "and the length follows")
          .above(0)
          .at_most(2000)
          .exactly_one({"tension", "length", "sag"});
  return d;
}

const Description& InstallationRequest::describe() {
  static const Description d =
      Describe<InstallationRequest>()
          .field(&InstallationRequest::name, "name", "ending of its tables' names, when a deck has several")
          .field(&InstallationRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&InstallationRequest::reeving, "reeving",
                 "the rope that is put up empty: without its carriages, and "
                 "without what hangs on them")
          .required()
          .field(&InstallationRequest::temperatures, "temperatures", "", si::K.in("degC"),
                 "at each of these, such as 15 degC; without them the machine's")
          .above(0)
          .at_most(2000)
          .field(&InstallationRequest::from, "from", "", si::K.in("degC"), "first temperature, in place of a list")
          .above(0)
          .at_most(2000)
          .field(&InstallationRequest::to, "to", "", si::K.in("degC"), "last temperature")
          .above(0)
          .at_most(2000)
          .field(&InstallationRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .record(&InstallationRequest::given, "given", "tension, length or sag; without it what the machine gives");
  return d;
}

const Description& PhaseRequest::describe() {
  static const Description d =
      Describe<PhaseRequest>()
          .field(&PhaseRequest::name, "name", "such as 'inhaul loaded'")
          .required()
          .named_records(&PhaseRequest::motion, "motion", "as for an equilibrium: in, out, ...")
          .shorthand("sense")
          .one_for_all()
          .field(&PhaseRequest::load, "load", "m", si::kg, "on the carriage, beside the machine's own loads")
          .at_least(0)
          .at_most(heaviest)
          .field(&PhaseRequest::from, "from", "x", si::m, "first place of the carriage, in place of the cycle's")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&PhaseRequest::to, "to", "x", si::m, "last place")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&PhaseRequest::speed, "speed", "v", si::m_per_s,
                 "of the carriage along its way, in place of the cycle's")
          .above(0)
          .at_most(1000);
  return d;
}

const Description& CycleRequest::describe() {
  static const Description d =
      Describe<CycleRequest>()
          .field(&CycleRequest::name, "name", "ending of its tables' names, when a deck has several")
          .field(&CycleRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&CycleRequest::carriage, "carriage", "the carriage that is moved")
          .required()
          .field(&CycleRequest::from, "from", "x", si::m, "first place of the carriage in the first phase")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&CycleRequest::to, "to", "x", si::m,
                 "last place there; phases without places of their own go back and forth")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&CycleRequest::steps, "steps", "n", si::one, "equal steps of each phase")
          .at_least(1)
          .at_most(10000)
          .field(&CycleRequest::along, "along", "", si::one, "as for a load path")
          .field(&CycleRequest::held, "held", "as for an equilibrium, at every position")
          .field(&CycleRequest::speed, "speed", "v", si::m_per_s,
                 "of the carriage along its way: gives powers and times")
          .above(0)
          .at_most(1000)
          .record(&CycleRequest::phases, "phases", "one after the other")
          .required();
  return d;
}

const Description& EnvelopeRequest::describe() {
  static const Description d =
      Describe<EnvelopeRequest>()
          .field(&EnvelopeRequest::name, "name", "ending of its tables' names, when a deck has several")
          .field(&EnvelopeRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&EnvelopeRequest::carriage, "carriage",
                 "the carriage that is moved; without it the machine as it stands")
          .field(&EnvelopeRequest::from, "from", "x", si::m, "first place of the carriage")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&EnvelopeRequest::to, "to", "x", si::m, "last place")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&EnvelopeRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .field(&EnvelopeRequest::along, "along", "", si::one, "as for a load path")
          .field(&EnvelopeRequest::held, "held", "as for an equilibrium, at every position")
          .field(&EnvelopeRequest::load_at, "load_at",
                 "the body or carriage that gets the loads; without it the carriage")
          .field(&EnvelopeRequest::loads, "loads", "m", si::kg, "each of these, beside the machine's own loads")
          .at_least(0)
          .at_most(heaviest)
          .field(&EnvelopeRequest::motions, "motions", "each of these; without them at_rest")
          .of({"at_rest", "hoist", "lower", "in", "out"})
          .field(&EnvelopeRequest::temperatures, "temperatures", "", si::K.in("degC"),
                 "each of these; without them the machine's")
          .above(0)
          .at_most(2000);
  return d;
}

const Description& SweepRequest::describe() {
  static const Description d =
      Describe<SweepRequest>()
          .field(&SweepRequest::name, "name", "ending of its tables' names, when a deck has several")
          .field(&SweepRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&SweepRequest::parameter, "parameter",
                 "a number of the machine by its path in the deck: 'loads[0].mass', 'reevings.skyline.length', "
                 "'temperature', 'points.head[2]', 'loads[0].force.angle'")
          .required()
          .field(&SweepRequest::from, "from", "first value, with the unit of the parameter")
          .required()
          .field(&SweepRequest::to, "to", "last value")
          .required()
          .field(&SweepRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .named_records(&SweepRequest::motion, "motion", "as for an equilibrium")
          .shorthand("sense")
          .one_for_all()
          .field(&SweepRequest::carriage, "carriage", "the carriage that is held at x")
          .field(&SweepRequest::x, "x", "x", si::m, "its place")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&SweepRequest::along, "along", "", si::one, "as for an equilibrium")
          .field(&SweepRequest::held, "held", "as for an equilibrium");
  return d;
}

}  // namespace taut::study
