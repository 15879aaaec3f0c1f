#include "taut/study/deck/watch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::study {

bool Watch::go_on(const std::string& words) {
  if (ended_ || !ask_) return !ended_;
  const double part = static_cast<double>(std::min(done_, steps_)) / std::max(1, steps_);
  ++done_;
  if (ask_({.what = what_, .done = part, .words = words})) return true;
  ended_ = true;
  where_ = words;
  return false;
}

bool Watch::go_on_at(double x) { return ended_ || !ask_ ? !ended_ : go_on("x = " + display_.brief(x, si::m)); }

void Watch::note(Result& r) const {
  if (!ended_ || r.interrupted) return;
  r.interrupted = true;
  r.status = Status::not_converged;
  r.message = fmt::format("{}: interrupted before {}; everything here ends there", what_, where_);
}

}  // namespace taut::study
