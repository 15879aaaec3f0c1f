#include "taut/checks/rope/lasting_tension.hpp"

namespace taut::checks {

void LastingTension::take(double t, double T, long steps) {
  const bool unseen = !times_.empty() && t - times_.back() > gap && steps - steps_ > 2;
  if (unseen || (!times_.empty() && t <= times_.back())) {
    times_.clear();
    rising_.clear();
  }
  steps_ = steps;
  times_.push_back(t);
  while (!rising_.empty() && rising_.back().T >= T) rising_.pop_back();
  rising_.push_back({.t = t, .T = T});
  while (times_.size() > 1 && times_[1] <= t - lasts) times_.pop_front();
  while (rising_.front().t < times_.front()) rising_.pop_front();
  if (times_.front() > t - lasts || rising_.front().T <= largest_) return;
  largest_ = rising_.front().T;
  when_ = t;
}

}  // namespace taut::checks
