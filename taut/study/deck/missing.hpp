#pragma once
#include <string>
#include <vector>

#include "taut/calc/outcome.hpp"
#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"

namespace taut::study {

/// States of which something is to be told, as stretches: each of neighbouring states of one analysis.
class Stretches {
 public:
  /// The next state of an analysis; every state is shown, in order. `why`: what the warning says of this state; empty:
  /// the warning leaves it out. `words`: its name, "load path, in, x = 12 m".
  void take(const std::string& why, const std::string& words, const std::string& analysis);
  bool any() const { return !all_.empty(); }
  /// "load path, in, x = 12 m to x = 14 m (3 states); x = 20 m: ...", with the reason of the first.
  std::string words() const;
  /// The same without the reason.
  std::string places() const;
  /// "load path, in, x = 12 m to x = 14 m (3 states) and on 1 more stretch: ...".
  std::string words_of_first() const;

 private:
  struct Stretch {
    std::string from, to;  ///< words of its first and last state
    int states = 0;

    /// `other`: a state told just before, of which common words are left out.
    [[nodiscard]] std::string words(const std::string& other) const;
  };
  std::vector<Stretch> all_;
  std::string why_, analysis_;  ///< of the first; of the last state that was taken
  bool open_ = false;           ///< whether the last state that was taken is in the last stretch
};

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
