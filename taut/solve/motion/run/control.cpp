#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/math/index.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double least_share = 1e-5;  ///< of the tolerance that any step may use
constexpr long patient_steps = 150'000, steps_to_twice = 10'000;
constexpr double most_impatience = 8;

/// Error of the trapezoidal rule in one step, from the prediction of Adams and Bashforth (Gear 1971, sec. 9): a third
/// of the difference for equal steps.
double error_by_prediction(const Run& run, double x, double x_before, double rate, double rate_old) {
  const double h = run.scheme.h, ratio = h / run.h_last;
  const double predicted = x_before + h / 2 * ((2 + ratio) * rate - ratio * rate_old);
  return std::abs(x - predicted) / (3 * (1 + 1 / ratio));
}

/// Error of the tensions, as a share, where a rope that slid has turned back within the step: the law of sliding held
/// to its end, so that the rope went on too far by the way that it came back.
double error_by_turning(const Run& run, std::size_t i) {
  const ContactValues &was = run.before.contacts[i], &is = run.now.contacts[i];
  const double way = is.grip == Grip::forward ? 1 : is.grip == Grip::backward ? -1 : 0;
  const double back = -way * is.slip_rate, on = way * was.slip_rate;
  if (back <= 0 || on <= 0) return 0;
  const double too_far = back * back / (2 * (back + on)) * run.scheme.h;
  const double largest = run.T_largest[run.m.contacts[i].reeving];
  return largest > 0 ? stiffness_at(run.m, run.m.contacts[i], run.now) * too_far / largest : 0;
}

/// How far bodies that signals move are beside a straight way in the middle of the step, as a share of the machine's
/// size: so goes what is observed between two steps. It is known without a step before.
double error_by_signals(const Run& run) {
  double error = 0;
  for (const machine::Body& body : run.model.bodies) {
    for (const machine::DrivenWay& way : body.driven) {
      const auto value = [&](double t) { return machine::at(way.signal, t).value; };
      const double from = run.before.t, to = run.now.t;
      const double off = value((from + to) / 2) - (value(from) + value(to)) / 2;
      error = std::max(error, std::abs(off) / (way.about == Vector3::Zero() ? run.m.size_of_machine : 1));
    }
  }
  return error;
}

}  // namespace

double impatience(const Run& run) {
  if (run.options.step > 0 || run.options.method != TimeMethod::implicit) return 1;
  const auto more = static_cast<double>(run.result.steps - patient_steps) / static_cast<double>(steps_to_twice);
  return std::clamp(1 + more, 1.0, most_impatience);
}

void note_impatience(Run& run) {
  const bool begins = run.result.steps == patient_steps + 1 && impatience(run) > 1;
  if (begins) note(run, run.now.t, "coarser", "");
}

void book_step(Run& run, bool rough) { add_step(run.m, run.before, run.now, run.ledger, rough); }

double floor_of(const Run& run) { return run.floor * impatience(run); }

namespace {

/// What the books lack before and after the step, and what is turned over then, J.
struct Books {
  double before, now, turnover;
};

Books books_over_step(const Run& run) {
  Ledger ledger = run.ledger;
  const double before = told(ledger).residual;
  add_step(run.m, run.before, run.now, ledger);
  return {before, told(ledger).residual, ledger.turnover};
}

}  // namespace

bool snatches_too_far(const Run& run) {
  constexpr double share = 1e-3;
  if (run.m.lossless || run.scheme.h / 2 <= floor_of(run)) return false;  // shorter ones are Euler's
  bool snatches = false;
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    snatches = snatches || (run.before.lines[i].T <= 0) != (run.now.lines[i].T <= 0);
  }
  if (!snatches) return false;
  const auto [before, now, turnover] = books_over_step(run);
  return std::abs(now - before) > share * turnover;
}

double resolving_step(const Run& run) {
  const double fastest = std::max(highest_frequency(run.m, run.before), 1 / run.options.duration);
  return std::min(std::cbrt(run.options.tolerance) / (2 * fastest), run.options.duration / 100);
}

double largest_tension(const Run& run) {
  double largest = 0;
  for (const double T : run.T_largest) largest = std::max(largest, T);
  return largest;
}

double error_of(const Run& run, bool kink) {
  const double by_signals = error_by_signals(run) / run.options.tolerance;
  if (run.known < 2) return by_signals;
  const double h = run.scheme.h;
  double error = 0;
  for (const Body& body : run.m.bodies) {
    for (int k = 0; k < body.count; ++k) {
      const std::size_t c = as_size(body.first + k);
      const double size = body.about[as_size(k)] == Vector3::Zero() ? run.m.size_of_machine : 1;
      error = std::max(error,
                       error_by_prediction(run, run.now.q[c], run.before.q[c], run.before.nu[c], run.nu_old[c]) / size);
    }
  }
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    error = std::max(error, error_by_turning(run, i));
    if (run.m.contacts[i].spin < 0) continue;
    const std::size_t c = as_size(run.m.contacts[i].column);
    error = std::max(error, error_by_prediction(run, run.now.contacts[i].rolled, run.before.contacts[i].rolled,
                                                run.before.contacts[i].roll_rate, run.nu_old[c]) /
                                run.m.size_of_machine);
  }
  const double h1 = run.h_last, h2 = run.h_older;
  const double third = h * h / (2 * (h + h1) * (h + h1 + h2));
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    const double T0 = run.before.lines[i].T, T1 = run.T_old[i], T2 = run.T_older[i];
    const double first = (T0 - T1) / h1, second = (first - (T1 - T2) / h2) / (h1 + h2);
    const double predicted = T0 + h * (first + (h + h1) * second);
    const double largest = run.T_largest[run.m.lines[i].reeving];
    // differences of slip amplify what rounding leaves of a length
    const Line& line = run.m.lines[i];
    const double rates = line.contact[0] >= 0 || line.contact[1] >= 0 ? run.scheme.slip_now : 0;
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * line.stiffness * (1 + line.damping * rates);
    const double off = std::abs(run.now.lines[i].T - predicted) - rounding * (1 + h / h1) * (1 + h / h2);
    if (largest > 0) error = std::max(error, third * off / largest);
  }
  return std::max(by_signals, error / (run.options.tolerance * allowed_share(run, kink)));
}

double allowed_share(const Run& run, bool kink) {
  // what shakes without end, and fast, is resolved within each swing then, no more over all of them together
  const double share = least_share * std::pow(impatience(run), 3);
  return kink ? 1 : std::clamp(run.scheme.h / run.options.duration, share, 1.0);
}

void keep_history(Run& run) {
  run.nu_old = run.before.nu;
  run.rate_old = run.before.rate;
  std::swap(run.T_older, run.T_old);
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) run.T_old[i] = run.before.lines[i].T;
  run.h_older = run.h_last;
  run.h_last = run.scheme.h;
  ++run.known;
}

}  // namespace taut::solve::dynamics
