#include <algorithm>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/values.hpp"

// The method of integration: its numbers, what it makes of the last step before the next one begins.
namespace taut::solve::dynamics {

Scheme scheme_of(double rho) {
  Scheme s;
  s.alpha_m = (3 - rho) / (2 * (1 + rho));
  s.alpha_f = 1 / (1 + rho);
  s.gamma = 0.5 + s.alpha_m - s.alpha_f;
  return s;
}

Scheme scheme_of_euler() {
  Scheme s;
  s.alpha_m = s.alpha_f = s.gamma = 1;
  return s;
}

void begin_step(const Mechanism& m, const Scheme& s, const Values& before, Work& w) {
  if (s.at_rest) {
    w.q_star = before.q;
    std::fill(w.nu_star.begin(), w.nu_star.end(), 0.0);
    for (std::size_t i = 0; i < m.contacts.size(); ++i) {
      w.q_star[m.contacts[i].column] = before.contacts[i].rolled;
    }
    return;
  }
  const double of_mean = s.h * (1 - s.gamma / s.alpha_m), of_rate = s.h * s.gamma * (1 - s.alpha_f) / s.alpha_m;
  // the auxiliary rates stand (alpha_m - alpha_f) h beyond the start of the step
  const double reach = w.mean_step > 0 ? s.h / w.mean_step : 1;
  const auto mean = [&](double of_last, double now) { return now + reach * (of_last - now); };
  for (std::size_t c = 0; c < as_size(m.size); ++c) {
    w.q_star[c] = before.q[c] + of_mean * mean(w.q_mean[c], before.nu[c]) + of_rate * before.nu[c];
    w.nu_star[c] = before.nu[c] + of_mean * mean(w.nu_mean[c], before.rate[c]) + of_rate * before.rate[c];
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const std::size_t c = as_size(m.contacts[i].column);
    const double rate = before.contacts[i].roll_rate;
    w.q_star[c] = before.contacts[i].rolled + of_mean * mean(w.q_mean[c], rate) + of_rate * rate;
  }
}

void end_step(const Mechanism& m, const Scheme& s, const Values& before, const Values& now, Work& w) {
  const double reach = w.mean_step > 0 ? s.h / w.mean_step : 1;
  const auto next = [&](double mean, double was, double is) {
    return (s.alpha_f * is + (1 - s.alpha_f) * was - (1 - s.alpha_m) * (was + reach * (mean - was))) / s.alpha_m;
  };
  for (std::size_t c = 0; c < as_size(m.size); ++c) {
    w.q_mean[c] = next(w.q_mean[c], before.nu[c], now.nu[c]);
    w.nu_mean[c] = next(w.nu_mean[c], before.rate[c], now.rate[c]);
  }
  w.mean_step = s.h;
}

}  // namespace taut::solve::dynamics
