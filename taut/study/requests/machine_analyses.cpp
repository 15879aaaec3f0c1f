#include "taut/study/requests/machine_analyses.hpp"

namespace taut::study {

const Description& EquilibriumRequest::describe() {
  static const Description d =
      Describe<EquilibriumRequest>()
          .field(&EquilibriumRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&EquilibriumRequest::judge, "judge", "false: its states do not count for the verdict")
          .named_records(&EquilibriumRequest::motion, "motion",
                         "hoist, lower, in, out, at_rest, or a sign for each contact by name: 1 along the path, -1 "
                         "against it, 0 at rest")
          .shorthand("sense")
          .one_for_all()
          .field(&EquilibriumRequest::carriage, "carriage", "the carriage that is placed at x")
          .field(&EquilibriumRequest::x, "x", "x", si::m, "place of the carriage; the quantity that holds it follows")
          .at_least(-1e6)
          .at_most(1e6)
          .field(&EquilibriumRequest::z, "z", "z", si::m,
                 "height of the carriage; the given length or tension of the rope on which it rides follows")
          .at_least(-1e6)
          .at_most(1e6)
          .field(&EquilibriumRequest::along, "along", "", si::one,
                 "horizontal direction [x, y] along which its x is measured, from the origin")
          .field(&EquilibriumRequest::held, "held",
                 "true: something besides the ropes holds the carriage at x; false: where it needs a force along its "
                 "track there is no answer")
          .record(&EquilibriumRequest::given, "given", "a required result, in place of the given quantity of one rope");
  return d;
}

const Description& LoadPathRequest::describe() {
  static const Description d =
      Describe<LoadPathRequest>()
          .field(&LoadPathRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&LoadPathRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&LoadPathRequest::carriage, "carriage", "the carriage that is moved")
          .required()
          .field(&LoadPathRequest::from, "from", "x", si::m, "first place of the carriage")
          .at_least(-1e6)
          .at_most(1e6)
          .required()
          .field(&LoadPathRequest::to, "to", "x", si::m, "last place")
          .at_least(-1e6)
          .at_most(1e6)
          .required()
          .field(&LoadPathRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .field(&LoadPathRequest::along, "along", "", si::one,
                 "horizontal direction [x, y] along which 'from' and 'to' are measured, from the origin")
          .named_records(&LoadPathRequest::motion, "motion", "as for an equilibrium")
          .shorthand("sense")
          .one_for_all()
          .field(&LoadPathRequest::held, "held", "as for an equilibrium, at every position")
          .record(&LoadPathRequest::given, "given", "as for an equilibrium, at every position");
  return d;
}

const Description& AnalysisRequest::describe() {
  static const Description d =
      Describe<AnalysisRequest>()
          .record(&AnalysisRequest::equilibrium, "equilibrium", "the machine in equilibrium")
          .record(&AnalysisRequest::load_path, "load_path", "a carriage moved along its line")
          .record(&AnalysisRequest::payload, "payload", "the largest load within all limits")
          .record(&AnalysisRequest::installation, "installation",
                  "an empty rope put up: tensions, sags and lengths by temperature")
          .record(&AnalysisRequest::cycle, "cycle", "pulls and energies of a working cycle")
          .record(&AnalysisRequest::envelope, "envelope", "worst cases for sizing")
          .record(&AnalysisRequest::sweep, "sweep", "the equilibrium over a number of the deck")
          .record(&AnalysisRequest::transient, "transient", "a motion of the machine")
          .record(&AnalysisRequest::modes, "modes", "small vibrations: frequencies, damping, shapes")
          .record(&AnalysisRequest::pretension, "pretension", "ropes tightened one after the other, as they are put up")
          .exactly_one({"equilibrium", "load_path", "payload", "installation", "cycle", "envelope", "sweep",
                        "transient", "modes", "pretension"});
  return d;
}

}  // namespace taut::study
