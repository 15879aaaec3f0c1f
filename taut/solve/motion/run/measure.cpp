#include <algorithm>
#include <cmath>

#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {
namespace {

using machine::description::Relative;

double scaled(const Run& run, const Values& v, const machine::Observable& what) {
  return what.factor * observe_as_it_is(run, v, what);
}

bool in_window(const Run& run, const Values& v, const machine::Observable& what) {
  const double x = what.mean_of ? observe(run, v, run.model.mean_windows[*what.mean_of]) : v.t;
  return x >= what.mean_from && x <= what.mean_to;
}

}  // namespace

double observe(const Run& run, const Values& v, const machine::Observable& what) {
  const double value = scaled(run, v, what);
  if (what.relative == Relative::none || !what.slot) return value + what.offset;
  const double reference = run.reference[*what.slot];
  if (what.relative == Relative::difference) {
    return (std::isnan(reference) ? 0 : value - reference) + what.offset;
  }
  return (std::isnan(reference) || reference == 0 ? 1 : value / reference) + what.offset;
}

void take_references(Run& run, const Values& v) {
  for (std::size_t i = 0; i < run.model.observed.size(); ++i) {
    const machine::Observable& what = run.model.observed[i];
    if (what.relative == Relative::none || !std::isnan(run.reference[i]) || v.t < what.since) continue;
    run.reference[i] = scaled(run, v, what);
  }
}

void add_to_mean(Run& run, const Values& v, std::size_t observed, double value) {
  const machine::Observable& what = run.model.observed[observed];
  if (!what.has_mean) return;
  Run::Mean& mean = run.means[observed];
  const bool inside = v.t >= what.since && in_window(run, v, what);
  // a step across the edge of the window does not count: steps are short against it
  if (inside && mean.inside) {
    mean.integral += (v.t - mean.last_t) * (value + mean.last_value) / 2;
    mean.duration += v.t - mean.last_t;
  }
  mean.inside = inside;
  mean.last_t = v.t;
  mean.last_value = value;
  if (mean.duration > 0) run.result.extremes[observed].mean = mean.integral / mean.duration;
}

void extend(Extreme& e, double value, double t, bool first) {
  if (first || value < e.min) {
    e.min = value;
    e.t_min = t;
  }
  if (first || value > e.max) {
    e.max = value;
    e.t_max = t;
  }
  e.end = value;
}

}  // namespace taut::solve::dynamics
