#include "taut/solve/motion/step/stable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::solve::dynamics {

double equal_step(const TransientOptions& options, double step) {
  constexpr double rounding = 1e-9;
  const double lines = options.output_step > 0 ? options.output_step : options.duration / 1000;
  const double parts = std::ceil(lines / step * (1 - rounding));
  const bool fits = std::abs(parts * step - lines) <= rounding * lines;
  return fits || step >= lines ? step : lines / parts;
}

double stable_step(const Run& run) {
  constexpr double longer = 0.95 / verlet_share;  // than that share: until then the step stays
  const double step = run.options.step;
  if (run.options.method != TimeMethod::verlet || run.m.simple) return step;
  const double limit = stability_limit(run.m, run.before);
  // a run that begins with a finer step than the usual one, for its error, keeps it as fine
  const double share = std::min(verlet_share, step / run.result.stability_limit);
  return step > longer * share * limit ? equal_step(run.options, share * limit) : step;
}

void note_tension_errors(Run& run) {
  const double h = run.scheme.h;
  const bool late = run.options.method == TimeMethod::verlet;  // its dampers
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const Line& line = run.m.lines[i];
    const LineValues &was = run.before.lines[i], &is = run.now.lines[i];
    const double held = !late || sags(line, is) ? 0 : is.T - elastic_tension(line, is);
    const double held_before = !late || sags(line, was) ? 0 : was.T - elastic_tension(line, was);
    const double error = step_error(is.T - was.T, run.T_rate[i] * h, held - held_before);
    double& largest = run.T_error[line.reeving];
    if (error > largest) largest = error;  // not where no step is known before
    run.T_rate[i] = (is.T - was.T) / h;
  }
}

void forget_tension_rates(Run& run) {
  run.T_rate.assign(run.m.lines.size(), std::numeric_limits<double>::quiet_NaN());
  // at an unchanged time dampers hold whatever they have to; the first step is compared with what they can
  for (std::size_t i = 0; i < run.m.lines.size() && run.options.method == TimeMethod::verlet; ++i) {
    if (!sags(run.m.lines[i], run.before.lines[i])) pull(run.m.lines[i], run.before.lines[i]);
  }
}

double tension_error(const Run& run) {
  double error = 0;
  for (std::size_t r = 0; r < run.T_error.size(); ++r) {
    const double expected = run.T_expected.empty() ? 0 : run.T_expected[r];
    const double largest = std::max(run.T_largest[r], expected);
    if (largest > 0) error = std::max(error, run.T_error[r] / largest);
  }
  return error;
}

double largest_error(const TransientResult& result) {
  const bool runs_away = !std::isfinite(result.open);
  return runs_away ? std::numeric_limits<double>::infinity() : std::max(result.tension_error, result.open);
}

double shorter_step(const TransientOptions& options, const VerletRun& before, const VerletRun& last) {
  constexpr double safe = 0.8, most = 0.7, after_running_away = 0.1;
  if (!std::isfinite(last.error)) return equal_step(options, after_running_away * last.step);
  const bool known = before.step > 0 && std::isfinite(before.error) && before.error > last.error;
  const double order = known ? std::log(before.error / last.error) / std::log(before.step / last.step) : 2;
  const double shorter = safe * std::pow(last.error, -1 / std::clamp(order, 1.0, 2.0));
  return equal_step(options, last.step * std::min(most, shorter));
}

}  // namespace taut::solve::dynamics
