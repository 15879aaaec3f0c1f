#include "taut/app/analysis_requests.hpp"

namespace taut::app {
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
          .record(&PayloadRequest::limits, "limits", "what must not be exceeded")
          .required()
          .field(&PayloadRequest::most, "most", "m", si::kg, "no payload above this is looked for")
          .above(0)
          .at_most(heaviest);
  return d;
}

}  // namespace taut::app
