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
          .field(&PullRequest::force, "force", "F", si::N, "until its tension there is so much")
          .above(0)
          .at_most(pull_strongest)
          .field(&PullRequest::take_up, "take_up", "dL", si::m,
                 "until so much unstretched rope is taken out; below 0 it is let in")
          .at_least(-pull_farthest)
          .at_most(pull_farthest)
          .field(&PullRequest::until, "until", "until this begins to move: a path as in 'observe', or a measure")
          .exactly_one({"force", "take_up", "until"})
          .field(&PullRequest::moves, "moves", "of 'until': by so much, either way, with its unit");
  return d;
}

const Description& LoadCaseRequest::describe() {
  static const Description d =
      Describe<LoadCaseRequest>()
          .field(&LoadCaseRequest::name, "name", "of the case, for the tables")
          .required()
          .record(&LoadCaseRequest::loads, "loads", "beside those of the machine, after the ropes are up");
  return d;
}

const Description& LeastTensionRequest::describe() {
  static const Description d = Describe<LeastTensionRequest>()
                                   .field(&LeastTensionRequest::ropes, "ropes", "reevings or guys whose lengths follow")
                                   .required()
                                   .field(&LeastTensionRequest::tension, "tension", "s", si::N,
                                          "that each of them has where and when it is slackest")
                                   .above(0)
                                   .at_most(pull_strongest)
                                   .required()
                                   .record(&LeastTensionRequest::cases, "cases",
                                           "loads under which they are to stay taut; without any: as put up");
  return d;
}

const Description& PretensionRequest::describe() {
  static const Description d =
      Describe<PretensionRequest>()
          .field(&PretensionRequest::name, "name", "ending of its tables' names, when a deck has several")
          .field(&PretensionRequest::judge, "judge", "false: its states do not count for the verdict")
          .record(&PretensionRequest::pull, "pull", "ropes pulled tight, one after the other")
          .record(&PretensionRequest::least, "least", "lengths of ropes for which none gets too slack under any loads")
          .exactly_one({"pull", "least"})
          .field(&PretensionRequest::rounds, "rounds", "n", si::one, "so often, always from the first on")
          .at_least(1)
          .at_most(1000)
          .field(&PretensionRequest::longest, "longest", "dL", si::m, "a pull that takes out more finds no end")
          .above(0)
          .at_most(pull_farthest)
          .field(&PretensionRequest::tolerance, "tolerance", "", si::one,
                 "of tensions by the largest of the rope, of places by the machine's size")
          .at_least(1e-13)
          .at_most(1e-3)
          .choice(&PretensionRequest::start, "start", {{"settled", Start::settled}, {"assembled", Start::assembled}},
                  "of a machine with contacts or cylinders: settled: from the equilibrium at rest; assembled: from "
                  "places and lengths as described, where friction holds what it can");
  return d;
}

}  // namespace taut::study
