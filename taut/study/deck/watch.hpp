#pragma once
#include <functional>
#include <string>
#include <utility>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"

namespace taut::study {

/// A long analysis of many states, seen from outside: tells how far it is, and whether it was asked to end. What was
/// computed before stays.
class Watch {
 public:
  /// `ask`: as in a Job, may be empty; outlives this. `what`: the analysis; `steps`: how many states it has, at most;
  /// `display`: units of its places.
  Watch(const std::function<bool(const Progress&)>& ask, std::string what, int steps, Display display = {})
      : ask_(ask), what_(std::move(what)), steps_(steps), display_(std::move(display)) {}

  /// Before each state, in words ("x = 12 m"); false: it is to end, from then on for good.
  bool go_on(const std::string& words);
  /// The same for a state at a place x, m.
  bool go_on_at(double x);

  bool ended() const { return ended_; }

  /// When it was ended, the result says so and where.
  void note(Result& r) const;

 private:
  const std::function<bool(const Progress&)>& ask_;
  std::string what_;
  int steps_;
  Display display_;
  int done_ = 0;
  bool ended_ = false;
  std::string where_;
};

}  // namespace taut::study
