#include "taut/app/cases/study/case_counter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::app {

bool CaseCounter::go_on() {
  const std::uint64_t done = ++done_;
  if (ended_) return false;
  if (!ask_) return true;
  const std::unique_lock turn(turn_, std::try_to_lock);
  if (!turn.owns_lock()) return true;
  if (ended_) return false;  // by the thread that told before
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(most_));
  const std::string words = exact_ ? fmt::format("{} of {} cases", done, most_) : fmt::format("{} cases", done);
  if (!ask_({.what = what_, .done = share, .words = words})) ended_ = true;
  return !ended_;
}

}  // namespace taut::app
