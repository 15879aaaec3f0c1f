#pragma once
#include <string>

#include "taut/base/stretches.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"

namespace taut::study {

/// Counts the states of an analysis that have no answer. What exists is given; what is missing is said and is not
/// judged. Only an analysis without any state has failed.
class Missing {
 public:
  void take(const Outcome& outcome, const std::string& where);
  /// Of a carriage at x, m.
  void take(const Outcome& outcome, double x, const Display& display = {});
  bool any() const { return missing_ > 0; }
  /// "load path, in: no equilibrium at 3 of 96 places, x = 12 m to x = 14 m (2 states); x = 20 m; the first: ..." as a
  /// warning; the status where all miss.
  /// `judged`: for the verdict too.
  void note(Result& r, const std::string& analysis, bool judged) const;

 private:
  int missing_ = 0, places_ = 0;
  Outcome why_;
  std::string first_;
  Stretches where_;
};

/// Whether a result, one of many cases, is an answer: not where a state is missing of which its deck asks.
Outcome outcome_of_case(const Result& r);

/// Notes the first failure of a calculation in the result: its status, and `what` before its message.
void note_failure(Result& r, const Outcome& outcome, const std::string& what);

}  // namespace taut::study
