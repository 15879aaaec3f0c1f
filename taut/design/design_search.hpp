#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "taut/design/design.hpp"
#include "taut/design/sizing.hpp"

namespace taut::design {

/// The last step of the search in an unknown, as a share of its range.
constexpr double finest_share = 2e-4;

/// The answer where the unknowns have these values.
struct DesignPoint {
  std::vector<double> values;
  design::SizingAnswer answer;
};

/// What a search has found.
struct DesignFound {
  std::vector<DesignPoint> points;  ///< of the grid, in its order, as far as the search came
  bool feasible = false;            ///< whether `best` passes all checks
  DesignPoint best;                 ///< with its neighbours where the unknowns have its values
  bool refined = false;             ///< its values are not those of the grid
  design::SizingCandidate nearest;  ///< where none passes: what comes nearest
  std::vector<double> nearest_values;
  std::map<std::string, std::string> unanswered;  ///< load cases that have no answer for any choice, and why
  /// A choice against which nothing stands but these; nothing: there is none.
  std::optional<DesignPlace> all_but_unanswered;
  double trials = 0;   ///< calculations of the machine with one choice and one set of values
  bool ended = false;  ///< from outside
};

/// At every place of the grid the least choice, tried in the order of cost where the cost is known before (masses,
/// prices, sizes), all of them where it is a result (tension, reserve). Then, unless `refine: false`, each choice that
/// is cheaper than the best and failed by little, and the best one itself from its three best places, within the ranges
/// by NLopt (constrained.hpp): to the least cost, or, where the unknowns do not change it, to the most
/// reserve.
DesignFound search_design(const DesignTask& task);

/// Whether the cost follows from the calculation and not from the choice.
bool is_measured(Seek seek);

}  // namespace taut::design
