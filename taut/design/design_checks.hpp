#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/design/sizing.hpp"

/// What the checks of a result say to a search.
namespace taut::design {

/// The check that decides: of those that fail the worst, else the one nearest to its limit. What has a check that was
/// asked for and not made, a missing state, or a chosen part (in `list_of`) without a limit does not pass.
design::SizingTrial trial_of(const Result& r, const std::map<std::string, std::size_t>& list_of = {});

/// Takes the checks of these names out of a result, those of a load case ("no slip [full]") too.
void disregard(const std::vector<std::string>& names, Result& r);

/// The checks of a result as constraints that stay the same ones from place to place: by name and occurrence, those of
/// the first result each by itself and the worst of all others behind them. <= 0 exactly where a check passes: its
/// utilisation less 1, between -10 and 10.
class CheckConstraints {
 public:
  std::vector<double> of(const Result& r);
  /// Where there is no result.
  std::vector<double> nothing() const;

 private:
  std::map<std::string, std::size_t> slots_;
  std::size_t count_ = 0;
};

/// How each candidate of several lists fares in the checks of its own part, whatever is chosen of the other lists.
class CandidateRecord {
 public:
  /// `list_of`: by the part of a check the list whose choice it judges; outlives this.
  explicit CandidateRecord(const std::map<std::string, std::size_t>& list_of) : list_of_(&list_of) {}

  void take(const std::vector<std::size_t>& choice, const Result& r);

  /// Of a choice with a candidate that has failed at least twice, by more than what other choices have changed so far
  /// in any candidate of its list (the square of the largest ratio, 1.05 at least): that failure. Never of a single
  /// list.
  std::optional<design::SizingTrial> hopeless(const std::vector<std::size_t>& choice) const;

 private:
  struct Fate {
    int trials = 0;
    double least = 0, most = 0;  ///< utilisation
    std::string governs;
  };
  const std::map<std::string, std::size_t>* list_of_;
  std::map<std::pair<std::size_t, std::size_t>, Fate> fates_;  ///< by list and candidate
  std::map<std::size_t, double> changed_;                      ///< by list
};

}  // namespace taut::design
