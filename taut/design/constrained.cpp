#include "taut/design/constrained.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "taut/base/expects.hpp"

namespace taut::design {
namespace {

constexpr double nothing_there = 10;  // `over` of all constraints where f has no value
constexpr int bisections = 14;

double worst_of(const ConstrainedPoint& p) {
  double worst = -HUGE_VAL;
  for (const double one : p.over) worst = std::max(worst, one);
  return worst;
}

bool keeps_all(const ConstrainedPoint& p) { return !std::isnan(p.value) && !(worst_of(p) > 0); }

/// The search in unknowns from 0 to 1 over their ranges; of most_reserve one more, the bound of all constraints.
class Search {
 public:
  Search(const std::function<std::optional<ConstrainedPoint>(const std::vector<double>&)>& f, Sought sought,
         const std::vector<double>& low, const std::vector<double>& high)
      : f_(f), sought_(sought), low_(low), high_(high) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (high[i] > low[i]) free_.push_back(i);
    }
  }

  ConstrainedAnswer from(const std::vector<double>& start, const std::vector<double>& step,
                         const ConstrainedOptions& options) {
    x_ = start;
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = std::clamp(x_[i], low_[i], high_[i]);
    std::vector<double> unit(free_.size());
    for (std::size_t k = 0; k < free_.size(); ++k) unit[k] = (x_[free_[k]] - low_[free_[k]]) / width(k);
    if (!look(unit)) return std::move(best_);
    scale_ = std::max(std::abs(best_.at.value), 1e-12);
    if (std::isnan(scale_)) scale_ = 1;
    if (free_.empty()) return std::move(best_);
    std::vector<double> steps(free_.size());
    for (std::size_t k = 0; k < free_.size(); ++k) steps[k] = std::clamp(step[free_[k]] / width(k), 1e-3, 0.5);
    run(unit, steps, options);
    if (!best_.ended && best_.feasible && last_) bisect(options);
    return std::move(best_);
  }

 private:
  double width(std::size_t k) const { return high_[free_[k]] - low_[free_[k]]; }

  std::vector<double> real(const std::vector<double>& unit) const {
    std::vector<double> x = x_;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      x[free_[k]] = std::clamp(low_[free_[k]] + unit[k] * width(k), low_[free_[k]], high_[free_[k]]);
    }
    return x;
  }

  bool better(const ConstrainedPoint& a, const ConstrainedPoint& b) const {
    const bool kept = keeps_all(a);
    if (kept != keeps_all(b)) return kept;
    if (kept && sought_ == Sought::least_value && a.value != b.value) return a.value < b.value;
    return worst_of(a) < worst_of(b);
  }

  /// What f gives at a point; false where the search is to end.
  bool look(const std::vector<double>& unit) {
    if (best_.ended) return false;
    if (unit == last_unit_ && last_) return true;
    const std::vector<double> x = real(unit);
    auto point = f_(x);
    if (!point) {
      best_.ended = true;
      return false;
    }
    if (constraints_ == 0) constraints_ = point->over.size();
    expects(point->over.size() == constraints_, "as many constraints at every point");
    if (best_.evaluations++ == 0 || better(*point, best_.at)) {
      best_.x = x;
      best_.at = *point;
      best_.feasible = keeps_all(*point);
    }
    last_unit_ = unit;
    last_ = std::move(point);
    return true;
  }

  double over(std::size_t i) const { return std::isnan(last_->value) ? nothing_there : last_->over[i]; }

  static std::vector<double> unit_of(unsigned n, const double* x) { return {x, x + n}; }

  // f as NLopt calls it; it may not throw through NLopt, which is C.
  static double objective(unsigned n, const double* x, double* /*gradient*/, void* self) {
    auto& own = *static_cast<Search*>(self);
    const bool reserve = own.sought_ == Sought::most_reserve;
    if (!own.guarded(unit_of(reserve ? n - 1 : n, x))) return 0;
    if (reserve) return x[n - 1];
    // where there is no value the constraints say so
    return std::isnan(own.last_->value) ? 1 : own.last_->value / own.scale_;
  }

  static void constraints(unsigned m, double* g, unsigned n, const double* x, double* /*gradient*/, void* self) {
    auto& own = *static_cast<Search*>(self);
    const bool reserve = own.sought_ == Sought::most_reserve;
    const bool known = own.guarded(unit_of(reserve ? n - 1 : n, x));
    for (unsigned i = 0; i < m; ++i) g[i] = known ? own.over(i) - (reserve ? x[n - 1] : 0) : 0;
  }

  bool guarded(const std::vector<double>& unit) {
    try {
      if (look(unit)) return true;
    } catch (...) {
      thrown_ = std::current_exception();
      best_.ended = true;
    }
    nlopt_force_stop(optimiser_);
    return false;
  }

  void run(std::vector<double> unit, std::vector<double> steps, const ConstrainedOptions& options) {
    const bool reserve = sought_ == Sought::most_reserve && constraints_ > 0;
    if (sought_ == Sought::most_reserve && !reserve) return;
    std::vector<double> least(unit.size(), 0);
    std::vector<double> most(unit.size(), 1);
    if (reserve) {
      unit.push_back(std::min(worst_of(best_.at), nothing_there));
      steps.push_back(0.2);
      least.push_back(-2 * nothing_there);
      most.push_back(2 * nothing_there);
    }
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(NLOPT_LN_COBYLA, static_cast<unsigned>(unit.size())), &nlopt_destroy);
    optimiser_ = optimiser.get();
    nlopt_set_lower_bounds(optimiser_, least.data());
    nlopt_set_upper_bounds(optimiser_, most.data());
    nlopt_set_initial_step(optimiser_, steps.data());
    nlopt_set_min_objective(optimiser_, objective, this);
    if (constraints_ > 0) {
      nlopt_add_inequality_mconstraint(optimiser_, static_cast<unsigned>(constraints_), constraints, this, nullptr);
    }
    nlopt_set_xtol_abs1(optimiser_, options.tolerance);
    nlopt_set_maxeval(optimiser_, options.most_evaluations);
    double value = 0;
    nlopt_optimize(optimiser_, unit.data(), &value);  // whatever it says: the best point was kept on the way
    optimiser_ = nullptr;
    if (thrown_) std::rethrow_exception(thrown_);
  }

  /// Constraints are met to a tolerance, from either side: from the best point that keeps them towards the last one.
  void bisect(const ConstrainedOptions& options) {
    if (keeps_all(*last_) || sought_ == Sought::most_reserve) return;
    const std::vector<double> far = last_unit_;
    std::vector<double> near(free_.size());
    for (std::size_t k = 0; k < free_.size(); ++k) near[k] = (best_.x[free_[k]] - low_[free_[k]]) / width(k);
    double kept = 0;
    double broken = 1;
    for (int i = 0; i < bisections && (broken - kept) > options.tolerance / 16; ++i) {
      const double t = (kept + broken) / 2;
      std::vector<double> unit(near.size());
      for (std::size_t k = 0; k < unit.size(); ++k) unit[k] = near[k] + t * (far[k] - near[k]);
      if (!look(unit)) return;
      (keeps_all(*last_) ? kept : broken) = t;
    }
  }

  const std::function<std::optional<ConstrainedPoint>(const std::vector<double>&)>& f_;
  Sought sought_;
  const std::vector<double>& low_;
  const std::vector<double>& high_;
  std::vector<std::size_t> free_;
  std::vector<double> x_;
  ConstrainedAnswer best_;
  std::vector<double> last_unit_;
  std::optional<ConstrainedPoint> last_;
  std::size_t constraints_ = 0;
  double scale_ = 1;
  nlopt_opt optimiser_ = nullptr;
  std::exception_ptr thrown_;
};

}  // namespace

ConstrainedAnswer least_within(const std::function<std::optional<ConstrainedPoint>(const std::vector<double>&)>& f,
                               Sought sought, const ConstrainedUnknowns& unknowns, const ConstrainedOptions& options) {
  const auto& [start, low, high, step] = unknowns;
  const std::size_t n = start.size();
  expects(n > 0 && low.size() == n && high.size() == n && step.size() == n, "bounds and steps belong to each unknown");
  return Search(f, sought, low, high).from(start, step, options);
}

}  // namespace taut::design
