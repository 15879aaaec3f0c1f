#include "taut/study/requests/pretension_deck.hpp"

namespace taut::study {
namespace {

constexpr double pull_strongest = 1e12;
constexpr double pull_farthest = 1e4;

}  // namespace

const Description& PullRequest::describe() {
  static const Description d =
      Describe<PullRequest>()
          .field(&PullRequest::rope, "rope", "the rope that is pulled: a reeving or a guy")
          .required()
          .choice(&PullRequest::end, "end", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "the end of its path with the tensioner")
          .field(&PullRequest::force, "force", "F", si::N, "tension there at which the pull ends")
          .above(0)
          .at_most(pull_strongest)
          .field(&PullRequest::take_up, "take_up", "dL", si::m,
                 "unstretched rope taken out, at which the pull ends; below 0 let in")
          .at_least(-pull_farthest)
          .at_most(pull_farthest)
          .field(&PullRequest::until, "until",
                 "quantity at whose movement the pull ends: a path as in 'observe', or a measure")
          .exactly_one({"force", "take_up", "until"})
          .field(&PullRequest::moves, "moves",
                 "movement of 'until' at which the pull ends, in either direction, with its unit");
  return d;
}

const Description& LoadCaseRequest::describe() {
  static const Description d = Describe<LoadCaseRequest>()
                                   .field(&LoadCaseRequest::name, "name", "name of the case in tables")
                                   .required()
                                   .record(&LoadCaseRequest::loads, "loads",
                                           "loads in addition to those of the machine, after the ropes are put up");
  return d;
}

const Description& LeastTensionRequest::describe() {
  static const Description d = Describe<LeastTensionRequest>()
                                   .field(&LeastTensionRequest::ropes, "ropes", "reevings or guys whose lengths follow")
                                   .required()
                                   .field(&LeastTensionRequest::tension, "tension", "s", si::N,
                                          "smallest tension of each rope, over its length and all cases")
                                   .above(0)
                                   .at_most(pull_strongest)
                                   .required()
                                   .record(&LeastTensionRequest::cases, "cases", "load cases; without any: as put up");
  return d;
}

const Description& PretensionRequest::describe() {
  static const Description d =
      Describe<PretensionRequest>()
          .field(&PretensionRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&PretensionRequest::judge, "judge", "false: its states do not count for the verdict")
          .record(&PretensionRequest::pull, "pull", "pulls, one after the other")
          .record(&PretensionRequest::least, "least",
                  "lengths of ropes for which each keeps a least tension under all loads")
          .exactly_one({"pull", "least"})
          .field(&PretensionRequest::rounds, "rounds", "n", si::one,
                 "number of times that the list of pulls is repeated")
          .at_least(1)
          .at_most(1000)
          .field(&PretensionRequest::longest, "longest", "dL", si::m, "largest length that a pull may take out")
          .above(0)
          .at_most(pull_farthest)
          .field(&PretensionRequest::tolerance, "tolerance", "", si::one,
                 "tolerance of tensions relative to the largest of the rope, of places relative to the size of the "
                 "machine")
          .at_least(1e-13)
          .at_most(1e-3)
          .choice(&PretensionRequest::start, "start", {{"settled", Start::settled}, {"assembled", Start::assembled}},
                  "of a machine with contacts or cylinders. settled: from the equilibrium at rest; assembled: from "
                  "places and lengths as described, held by friction");
  return d;
}

}  // namespace taut::study
