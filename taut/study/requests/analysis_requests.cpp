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
                 "of a rope: id of a safety factor in the catalogue ('taut list rules'); it is checked, and it is the "
                 "limit if no other is given")
          .field(&RopeLimitRequest::clearance, "clearance", "c", si::m,
                 "of a rope: its least height above the ground between 'from' and 'to'")
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
          .field(&LimitsRequest::clearance, "clearance", "c", si::m, "least height of the carriage above the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&LimitsRequest::rope_clearance, "rope_clearance", "c", si::m,
                 "least height above the ground of the rope on which it rides, between 'from' and 'to'")
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
          .field(&PayloadRequest::name, "name", "appended to the names of its tables, when a deck has several")
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
          .record(&PayloadRequest::limits, "limits", "limits, at least one")
          .required()
          .field(&PayloadRequest::most, "most", "m", si::kg, "upper bound of the payload")
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
                 "its unstretched length, in place of that in the machine")
          .above(0)
          .at_most(farthest)
          .field(&GivenRequest::sag, "sag", "f", si::m,
                 "sag of the carriage below the line between its supports; without a carriage, of a free span below "
                 "its chord at half its horizontal length")
          .above(0)
          .at_most(farthest)
          .field(
              &GivenRequest::free_running, "free_running",
              "true: the carriage, rolling and without mainline, is in equilibrium at its place without another force")
          .field(&GivenRequest::of, "of",
                 "the rope that the winch pulls, or all ropes of the loop; default: this rope alone")
          .field(&GivenRequest::efficiency, "efficiency", "eta", si::one,
                 "efficiency of the lead sheaves of a winch: the tension of the rope is winch_pull times this")
          .above(0)
          .at_most(1)
          .choice(&GivenRequest::at, "at", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "end of the path at which the winch pulls")
          .field(&GivenRequest::span, "span", "", si::one,
                 "number of the free span with the sag, from 1; default: the longest")
          .at_least(1)
          .exactly_one({"winch_pull", "loop_length", "sag", "free_running"});
  return d;
}

const Description& InstallationGivenRequest::describe() {
  static const Description d =
      Describe<InstallationGivenRequest>()
          .field(&InstallationGivenRequest::tension, "tension", "T", si::N, "tension of the empty rope at one end")
          .above(0)
          .at_most(strongest)
          .field(&InstallationGivenRequest::length, "length", "L", si::m,
                 "unstretched length at the reference temperature")
          .above(0)
          .at_most(farthest)
          .field(&InstallationGivenRequest::sag, "sag", "f", si::m,
                 "sag of a free span below its chord, at half its horizontal length")
          .above(0)
          .at_most(farthest)
          .choice(&InstallationGivenRequest::at, "at", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "end of the path with this tension")
          .field(&InstallationGivenRequest::span, "span", "", si::one,
                 "number of the free span with the sag, from 1; default: the longest")
          .at_least(1)
          .field(&InstallationGivenRequest::temperature, "temperature", "", si::K.in("degC"),
                 "temperature at which it holds; the length found there is kept at the others. Default: it holds at "
                 "each temperature, and the length follows")
          .above(0)
          .at_most(2000)
          .exactly_one({"tension", "length", "sag"});
  return d;
}

const Description& InstallationRequest::describe() {
  static const Description d =
      Describe<InstallationRequest>()
          .field(&InstallationRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&InstallationRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&InstallationRequest::reeving, "reeving",
                 "the rope that is put up empty, without its carriages and what hangs on them")
          .required()
          .field(&InstallationRequest::temperatures, "temperatures", "", si::K.in("degC"),
                 "temperatures, such as 15 degC; default: that of the machine")
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
          .record(&InstallationRequest::given, "given", "tension, length or sag; default: what the reeving gives");
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
          .field(&PhaseRequest::load, "load", "m", si::kg, "load on the carriage, in addition to those of the machine")
          .at_least(0)
          .at_most(heaviest)
          .field(&PhaseRequest::from, "from", "x", si::m, "first place of the carriage, in place of that of the cycle")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&PhaseRequest::to, "to", "x", si::m, "last place")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&PhaseRequest::speed, "speed", "v", si::m_per_s,
                 "speed of the carriage, in place of that of the cycle")
          .above(0)
          .at_most(1000);
  return d;
}

const Description& CycleRequest::describe() {
  static const Description d =
      Describe<CycleRequest>()
          .field(&CycleRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&CycleRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&CycleRequest::carriage, "carriage", "the carriage that is moved")
          .required()
          .field(&CycleRequest::from, "from", "x", si::m, "first place of the carriage in the first phase")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&CycleRequest::to, "to", "x", si::m,
                 "last place in the first phase; phases without places of their own go back and forth")
          .at_least(-farthest)
          .at_most(farthest)
          .required()
          .field(&CycleRequest::steps, "steps", "n", si::one, "equal steps of each phase")
          .at_least(1)
          .at_most(10000)
          .field(&CycleRequest::along, "along", "", si::one, "as for a load path")
          .field(&CycleRequest::held, "held", "as for an equilibrium, at every position")
          .field(&CycleRequest::speed, "speed", "v", si::m_per_s, "speed of the carriage, for powers and times")
          .above(0)
          .at_most(1000)
          .record(&CycleRequest::phases, "phases", "phases in their order")
          .required();
  return d;
}

const Description& EnvelopeRequest::describe() {
  static const Description d =
      Describe<EnvelopeRequest>()
          .field(&EnvelopeRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&EnvelopeRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&EnvelopeRequest::carriage, "carriage",
                 "the carriage that is moved; without it the machine as described")
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
          .field(&EnvelopeRequest::load_at, "load_at", "the body or carriage with the loads; default: the carriage")
          .field(&EnvelopeRequest::loads, "loads", "m", si::kg, "loads, each in addition to those of the machine")
          .at_least(0)
          .at_most(heaviest)
          .field(&EnvelopeRequest::motions, "motions", "motions; default: at_rest")
          .of({"at_rest", "hoist", "lower", "in", "out"})
          .field(&EnvelopeRequest::temperatures, "temperatures", "", si::K.in("degC"),
                 "temperatures; default: that of the machine")
          .above(0)
          .at_most(2000);
  return d;
}

const Description& SweepRequest::describe() {
  static const Description d =
      Describe<SweepRequest>()
          .field(&SweepRequest::name, "name", "appended to the names of its tables, when a deck has several")
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
          .field(&SweepRequest::carriage, "carriage", "the carriage that is placed at x")
          .field(&SweepRequest::x, "x", "x", si::m, "its place")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&SweepRequest::along, "along", "", si::one, "as for an equilibrium")
          .field(&SweepRequest::held, "held", "as for an equilibrium");
  return d;
}

}  // namespace taut::study
