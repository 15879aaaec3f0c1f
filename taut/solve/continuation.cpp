#include "taut/solve/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/math/index.hpp"

namespace taut::solve {
namespace {

constexpr int most_step_halvings = 30;
constexpr double sudden = 8;          ///< times the way of the step before: may be a jump
constexpr double stays_sudden = 0.5;  ///< of the way, however small the steps: is one
/// Near a turning point the state goes with the root of the distance: from 4 d to d it goes as far as from d to 0; else
/// three times as far.
constexpr double turning = 0.6;
constexpr double look_back = 0.02;  ///< of a step, the d of that

bool same_ropes(const machine::Model& a, const machine::Model& b) {
  return a.bodies.size() == b.bodies.size() &&
         std::equal(
             a.reevings.begin(), a.reevings.end(), b.reevings.begin(), b.reevings.end(),
             [](const machine::Reeving& x, const machine::Reeving& y) { return x.nodes.size() == y.nodes.size(); });
}

/// Whether bodies that are held in some directions are held at the same places there: a state keeps them.
bool same_guides(const machine::Model& a, const machine::Model& b) {
  constexpr std::size_t all_ways = 6;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const machine::Body &one = a.bodies[i], &other = b.bodies[i];
    const bool rides = std::any_of(a.carriages.begin(), a.carriages.end(),
                                   [&](const machine::Carriage& car) { return as_size(car.body) == i; });
    if (one.beam || rides || one.free.size() == all_ways) continue;
    if (one.position != other.position || one.orientation != other.orientation) return false;
  }
  return true;
}

/// The machine's size, m.
double size_of(const EquilibriumResult& r) {
  double size = 1e-3;
  for (const BranchResult& s : r.branches) size = std::max(size, s.chord);
  return size;
}

class Follow {
 public:
  Follow(const ModelAt& model_at, const SweepOptions& options) : model_at_(model_at), options_(options) {}

  Sweep run() {
    for (int i = 0; i <= options_.steps; ++i) {
      const double value = step_between(options_.from, options_.to, i, options_.steps);
      if (options_.go_on && !options_.go_on(value))
        return ends(sweep_.points.empty() ? value : near()->value, SweepEnd::interrupted);
      SweepPoint next;
      const bool found = solve(value, near(), next);
      if (sweep_.points.empty()) {
        if (!found) return ends(options_.from, no_machine_ ? SweepEnd::no_machine : SweepEnd::no_equilibrium);
      } else if (!found || jumps(next)) {
        return narrow(value, found);
      }
      if (!sweep_.points.empty()) last_way_ = way(sweep_.points.back(), next);
      sweep_.points.push_back(std::move(next));
    }
    sweep_.value = options_.to;
    return std::move(sweep_);
  }

 private:
  /// Where to start from: the last point, if its ropes run in the same way.
  const SweepPoint* near() const { return sweep_.points.empty() ? nullptr : &sweep_.points.back(); }

  bool solve(double value, const SweepPoint* near, SweepPoint& point) {
    auto model = model_at_(value);
    no_machine_ = !model;
    if (!model) {
      sweep_.outcome = model.error();
      return false;
    }
    point.value = value;
    point.model = std::move(*model);
    const bool follows =
        near != nullptr && same_ropes(near->model, point.model) && same_guides(near->model, point.model);
    point.at = equilibrium(point.model, options_.equilibrium, follows ? std::optional(near->at.state) : std::nullopt);
    if (!point.at.outcome.ok()) sweep_.outcome = point.at.outcome;
    return point.at.outcome.ok();
  }

  static double way(const SweepPoint& a, const SweepPoint& b) {
    return distance(a.at.state, b.at.state, size_of(a.at));
  }

  /// Whether the step to `next` stays much longer than the one before it, however it is divided.
  bool jumps(const SweepPoint& next) {
    const SweepPoint& last = sweep_.points.back();
    if (!same_ropes(last.model, next.model)) return false;
    const double whole = way(last, next);
    if (whole <= sudden * std::max(last_way_, 1e-6 * size_of(last.at))) return false;
    SweepPoint low = last, high = next;
    for (int i = 0; i < most_step_halvings / 2; ++i) {
      SweepPoint middle;
      if (!solve((low.value + high.value) / 2, &low, middle)) return true;
      const bool far = way(low, middle) > way(middle, high);
      (far ? high : low) = std::move(middle);
      if (way(low, high) < stays_sudden * whole) return false;
    }
    return true;
  }

  /// Halves the step in which the equilibrium is lost. What is found but far away counts as lost.
  Sweep narrow(double lost, bool jumped) {
    SweepPoint low = sweep_.points.back();
    const double first = low.value;
    const double step = lost - first;
    double far = std::numeric_limits<double>::infinity();
    if (jumped) {
      SweepPoint next;
      if (solve(lost, &low, next)) far = stays_sudden * way(low, next);
    }
    bool no_machine = no_machine_;
    Outcome why = sweep_.outcome;
    for (int i = 0; i < most_step_halvings; ++i) {
      SweepPoint middle;
      const bool found = solve((low.value + lost) / 2, &low, middle);
      if (found && way(low, middle) < far) {
        low = std::move(middle);
        continue;
      }
      lost = (low.value + lost) / 2;
      if (!found) {
        no_machine = no_machine_;
        why = sweep_.outcome;
      }
    }
    sweep_.outcome = jumped ? infeasible("the machine jumps to another equilibrium") : why;
    const bool turns = !no_machine && (jumped || turns_back(low, step, first));
    const double end = low.value;
    if (end != first) sweep_.points.push_back(std::move(low));
    return ends(end, no_machine ? SweepEnd::no_machine : turns ? SweepEnd::turning_point : SweepEnd::no_equilibrium);
  }

  /// By the states a little and four times as far before the end.
  bool turns_back(const SweepPoint& end, double step, double first) {
    const double d = look_back * step;
    if (std::abs(end.value - first) < 4 * std::abs(d) && sweep_.points.size() < 2) return false;
    const Outcome kept = sweep_.outcome;
    SweepPoint near_end, farther;
    const bool found = solve(end.value - d, &end, near_end) && solve(end.value - 4 * d, &near_end, farther);
    sweep_.outcome = kept;
    return found && way(near_end, end) > turning * way(farther, near_end);
  }

  Sweep ends(double value, SweepEnd how) {
    sweep_.value = value;
    sweep_.end = how;
    return std::move(sweep_);
  }

  const ModelAt& model_at_;
  const SweepOptions& options_;
  Sweep sweep_;
  double last_way_ = std::numeric_limits<double>::infinity();
  bool no_machine_ = false;
};

}  // namespace

double distance(const machine::State& a, const machine::State& b, double length) {
  if (a.bodies.size() != b.bodies.size() || a.branches.size() != b.branches.size()) {
    return std::numeric_limits<double>::infinity();
  }
  double most = 0;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    most = std::max(most, (a.bodies[i].position - b.bodies[i].position).norm());
    most = std::max(most, length * (a.bodies[i].orientation - b.bodies[i].orientation).cwiseAbs().maxCoeff());
  }
  if (a.touched != b.touched) return most;  // a rope that leaves a support joins two branches in no time
  for (std::size_t r = 0; r < a.branches.size(); ++r) {
    if (a.branches[r].size() != b.branches[r].size()) return std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < a.branches[r].size(); ++k) {
      most = std::max(most, std::abs(a.branches[r][k].length - b.branches[r][k].length));
    }
  }
  return most;
}

Sweep sweep(const ModelAt& model_at, const SweepOptions& options) {
  expects(options.steps >= 1, "a sweep has a step");
  return Follow(model_at, options).run();
}

}  // namespace taut::solve
