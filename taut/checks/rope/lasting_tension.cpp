#include "taut/checks/rope/lasting_tension.hpp"

#include <algorithm>
#include <iterator>

namespace taut::checks {

void LastingTension::take(double t, double T, long steps) {
  if (!all_.empty() && t == all_.back().t) {  // a moment that is shown twice
    const double more = std::max(T - all_.back().T, 0.0);
    if (all_.size() > 1) impulse_ += more * (t - all_[all_.size() - 2].t) / 2;
    all_.back().T += more;
    take_mean();
    return;
  }
  const bool unseen = !all_.empty() && t - all_.back().t > gap && steps - steps_ > 2;
  if (unseen || (!all_.empty() && t < all_.back().t)) {
    all_.clear();
    rising_.clear();
    impulse_ = 0;
  }
  steps_ = steps;
  if (!all_.empty()) impulse_ += (t - all_.back().t) * (all_.back().T + T) / 2;
  all_.push_back({.t = t, .T = T});
  while (!rising_.empty() && rising_.back().T >= T) rising_.pop_back();
  rising_.push_back({.t = t, .T = T});
  while (all_.size() > 1 && all_[1].t <= t - lasts) {
    impulse_ -= (all_[1].t - all_[0].t) * (all_[0].T + all_[1].T) / 2;
    all_.pop_front();
  }
  take_mean();
  while (rising_.front().t < all_.front().t) rising_.pop_front();
  if (all_.front().t > t - lasts || rising_.front().T <= largest_) return;
  largest_ = rising_.front().T;
  when_ = t;
}

/// Of the interval that ends at the last moment, whose first part may begin before it.
void LastingTension::take_mean() {
  const double begins = all_.back().t - lasts;
  if (all_.size() < 2 || all_.front().t > begins) return;
  const Moment &from = all_[0], &to = all_[1];
  const double share = (begins - from.t) / (to.t - from.t), T_begins = from.T + share * (to.T - from.T);
  const double mean = (impulse_ - (begins - from.t) * (from.T + T_begins) / 2) / lasts;
  if (mean <= mean_) return;
  mean_ = mean;
  when_mean_ = all_.back().t;
}

double LastingTension::before_end() const {
  if (all_.empty()) return 0;
  const auto later = std::find_if(all_.begin(), all_.end(), [&](const Moment& m) { return m.t > last_moment() - gap; });
  return later == all_.begin() ? later->T : std::prev(later)->T;
}

double LastingTension::largest_within(double within) const {
  double most = 0;
  for (auto m = all_.rbegin(); m != all_.rend() && m->t >= last_moment() - within; ++m) most = std::max(most, m->T);
  return most;
}

double LastingTension::growth(double within) const {
  if (all_.size() < 2) return 0;
  const double half = std::min(within, (last_moment() - all_.front().t) / 2);
  const double later = last_moment() - half;
  double before = 0, after = 0;
  for (const Moment& m : all_) {
    if (m.t < later - half) continue;
    double& most = m.t < later ? before : after;
    most = std::max(most, m.T);
  }
  return before > 0 ? std::max(after / before - 1, 0.0) : 0;
}

double LastingTension::at_end() const {
  if (all_.empty()) return 0;
  double impulse = 0, most = 0, mean = all_.back().T;
  for (std::size_t i = all_.size() - 1; i > 0; --i) {
    const Moment &from = all_[i - 1], &to = all_[i];
    impulse += (to.t - from.t) * (from.T + to.T) / 2;
    const double span = all_.back().t - from.t;
    mean = impulse / span;
    if (span >= gap) most = std::max(most, mean);
  }
  return most > 0 ? most : mean;
}

}  // namespace taut::checks
