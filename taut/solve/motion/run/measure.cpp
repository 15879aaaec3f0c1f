#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {
namespace {

using machine::description::Relative;

double scaled(const Run& run, const Values& v, const machine::Observable& what) {
  return what.factor * observe_as_it_is(run, v, what);
}

/// A value as its measure wants it.
double as_seen(const Run& run, const machine::Observable& what, double value) {
  if (what.relative == Relative::none || !what.slot) return value + what.offset;
  const double reference = run.reference[*what.slot];
  if (what.relative == Relative::difference) {
    return (std::isnan(reference) ? 0 : value - reference) + what.offset;
  }
  return (std::isnan(reference) || reference == 0 ? 1 : value / reference) + what.offset;
}

/// A part of a step, in shares of it.
struct Part {
  double from = 0, to = 1;
};

/// The part of a step in which a quantity lies between two bounds, straight from `was` to `is`.
Part within(double was, double is, double least, double most) {
  if (was == is) return {0, was >= least && was <= most ? 1.0 : 0.0};
  const double a = (least - was) / (is - was), b = (most - was) / (is - was);
  return {std::max(0.0, std::min(a, b)), std::min(1.0, std::max(a, b))};
}

double between(double was, double is, double share) { return was + share * (is - was); }

/// The value where `since` lies in the step that has ended; else that at its end.
double at_since(const Run::Measured& all, const machine::Observable& what, double t) {
  if (!(all.t < what.since)) return all.now;
  return between(all.value, all.now, (what.since - all.t) / (t - all.t));
}

void add_to_mean(const Run& run, const machine::Observable& what, double t, double window, Run::Measured& all) {
  if (!what.has_mean || !(t > all.t)) return;
  const Part inside = within(all.window, window, what.mean_from, what.mean_to);
  const Part later = within(all.t, t, what.since, std::numeric_limits<double>::infinity());
  const double from = std::max(inside.from, later.from), to = std::min(inside.to, later.to);
  if (!(to > from)) return;
  const double duration = (to - from) * (t - all.t);
  all.integral += duration * as_seen(run, what, between(all.value, all.now, (from + to) / 2));
  all.duration += duration;
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Before its `since` a measure has no value.
constexpr Extreme unseen{.min = none, .max = none, .t_min = none, .t_max = none, .end = none};

}  // namespace

double observe(const Run& run, const Values& v, const machine::Observable& what) {
  return as_seen(run, what, scaled(run, v, what));
}

void measure(Run& run, const Values& v) {
  const bool first = run.result.steps == 0;
  const auto& observed = run.model.observed;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const machine::Observable& what = observed[i];
    run.measured[i].now = scaled(run, v, what);
    if (what.relative == Relative::none || !std::isnan(run.reference[i]) || v.t < what.since) continue;
    run.reference[i] = at_since(run.measured[i], what, v.t);
  }
  for (std::size_t i = 0; i < observed.size(); ++i) {
    const machine::Observable& what = observed[i];
    Run::Measured& all = run.measured[i];
    Extreme& e = run.result.extremes[i];
    if (v.t < what.since) {
      e = unseen;
    } else {
      const bool begins = all.t < what.since;
      if (begins) extend(e, as_seen(run, what, at_since(all, what, v.t)), what.since, true);
      extend(e, as_seen(run, what, all.now), v.t, first && !begins);
    }
    const double window = what.mean_of ? observe(run, v, run.model.mean_windows[*what.mean_of]) : v.t;
    add_to_mean(run, what, v.t, window, all);
    if (all.duration > 0) e.mean = all.integral / all.duration;
    all.t = v.t;
    all.value = all.now;
    all.window = window;
  }
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
