#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "taut/calc/outcome.hpp"

namespace taut::design {

/// How one candidate fared.
struct SizingTrial {
  bool passes = false;
  double utilisation = 0;  ///< of the check that governs; NaN: no equilibrium
  std::string governs;     ///< its name, or why there is no equilibrium
  double measured = 0;     ///< what it costs, where only the trial tells
  bool ended = false;      ///< the search is to end; nothing else counts then
  bool skipped = false;    ///< set aside without a trial: does not count as one, and is not reported
};

struct SizingOptions {
  std::size_t most_trials = 20000;  ///< then the search ends without an answer
  std::size_t neighbours = 5;       ///< runner-ups that are kept on either side of the answer
  std::size_t more_trials = 40;     ///< spent behind the answer to find those above it
};

struct SizingCandidate {
  std::vector<std::size_t> choice;  ///< index in each list
  double cost = 0;
  SizingTrial trial;
};

struct SizingAnswer {
  Outcome outcome;  ///< infeasible: none passes, or the trials are spent
  SizingCandidate best;
  /// Cheaper ones that fail, nearest to the answer last; without an answer those that fail by least, the nearest last.
  std::vector<SizingCandidate> below;
  std::vector<SizingCandidate> above;  ///< the next ones that pass
  std::size_t trials = 0;              ///< up to the answer
  bool ended = false;                  ///< by a trial; the answer is that of the trials before
  bool measured = false;               ///< the costs are those that the trials tell
  /// Set aside without a trial, not costlier than the answer, in the order of the search: that none of them passes is
  /// not known.
  std::vector<SizingCandidate> aside;
};

/// The cheapest choice of one candidate from each list that passes: all choices are tried in the order of the sum of
/// their costs, equal sums by the indices. Nothing is assumed of `try_one`: a heavier rope may well fail where a
/// lighter one passes. costs[k] ascends and is not empty.
SizingAnswer cheapest(const std::vector<std::vector<double>>& costs,
                      const std::function<SizingTrial(const std::vector<std::size_t>&)>& try_one,
                      const SizingOptions& options = {});

/// The same where each trial tells its cost (`measured`), so that all of them are tried: counts[k] candidates in list
/// k, in the order of their indices. Of equal costs the first, with more reserve, is the answer; `below` are those that
/// fail by least. More choices than `most_trials`: none is tried.
SizingAnswer least_measured(const std::vector<std::size_t>& counts,
                            const std::function<SizingTrial(const std::vector<std::size_t>&)>& try_one,
                            const SizingOptions& options = {});

/// Tries choices that were set aside, `most` of them at most. What is left untried stays in `aside`; with none left the
/// answer is that of all choices. Where there are more than `most`, the costliest are tried first: their parts help
/// each other most.
void try_aside(SizingAnswer& answer, const std::function<SizingTrial(const std::vector<std::size_t>&)>& try_one,
               std::size_t most, const SizingOptions& options = {});

}  // namespace taut::design
