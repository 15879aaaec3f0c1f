#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/study/requests/analysis_requests.hpp"

namespace taut::study {

/// One rope tightened at one of its ends until something is reached.
struct PullRequest {
  std::string rope;
  RopeEnd end = RopeEnd::start;
  std::optional<double> force;       ///< N
  std::optional<double> take_up;     ///< m
  std::optional<std::string> until;  ///< a path as in `observe`, or a measure, that has moved ...
  std::optional<std::string> moves;  ///< ... by so much, with its unit
  static const Description& describe();
};

/// Loads that act together after the ropes are up.
struct LoadCaseRequest {
  std::string name;
  std::vector<machine::description::Load> loads;  ///< beside those of the machine
  static const Description& describe();
};

/// Ropes just so tight that none of them gets slacker than that in any case.
struct LeastTensionRequest {
  std::vector<std::string> ropes;
  double tension = 0;  ///< N
  std::vector<LoadCaseRequest> cases;
  static const Description& describe();
};

/// Ropes pulled tight in turn, or as little as keeps them taut.
struct PretensionRequest {
  enum class Start { settled, assembled };
  std::optional<std::string> name;  ///< ending of its tables' names
  std::vector<PullRequest> pull;    ///< in this order
  std::optional<LeastTensionRequest> least;
  int rounds = 1;        ///< and again from the first
  double longest = 0.5;  ///< m
  double tolerance = 1e-9;
  Start start = Start::settled;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

}  // namespace taut::study
