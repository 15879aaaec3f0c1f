#include "taut/chance/reliability/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "taut/base/expects.hpp"
#include "taut/chance/counter.hpp"
#include "taut/chance/reliability/sorm.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance {
namespace {

constexpr std::size_t most_points = 12;
constexpr std::size_t most_axes = 8;
constexpr double start_distance = 2;

double squared(const Point& a) { return std::inner_product(a.begin(), a.end(), a.begin(), 0.); }

double distance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

double radius_of_one(double beta) { return 0.25 * std::max(1., std::abs(beta)); }

Point normal_point(std::uint64_t seed, Use use, std::uint64_t index, std::size_t inputs) {
  Point u(inputs);
  for (std::uint32_t i = 0; i < inputs; ++i) u[i] = normal_score(unit(random_bits(seed, use, 0, index, i)));
  return u;
}

/// Cases beyond the limit among scattered ones, nearest first, each well apart from those before it.
Points scattered_starts(const LimitState& state, double at_origin, std::uint64_t seed) {
  constexpr std::size_t count = 256;
  constexpr double spread = 2.5;
  constexpr std::size_t most = 4;
  Points scattered;
  for (std::size_t k = 0; k < count; ++k) {
    scattered.push_back(normal_point(seed, Use::screen, k, state.size()));
    for (double& x : scattered.back()) x *= spread;
  }
  const std::vector<double> g = state.margins(scattered);
  Points beyond;
  for (std::size_t k = 0; k < count; ++k) {
    if (!std::isnan(g[k]) && (g[k] < 0) != (at_origin < 0)) beyond.push_back(scattered[k]);
  }
  std::sort(beyond.begin(), beyond.end(), [](const Point& a, const Point& b) { return squared(a) < squared(b); });
  Points starts;
  for (const Point& u : beyond) {
    const bool apart =
        std::all_of(starts.begin(), starts.end(), [&](const Point& other) { return distance(u, other) > 2; });
    if (apart && starts.size() < most) starts.push_back(u);
  }
  return starts;
}

Points starts_of(const LimitState& state, double at_origin, std::uint64_t seed) {
  const std::size_t n = state.size();
  Points starts{Point(n, 0)};
  for (std::size_t k = 0; k < std::min(n, most_axes); ++k) {
    Point along(n, 0);
    if (n <= most_axes) {
      along[k] = start_distance;
    } else {
      along = normal_point(seed, Use::screen, 1000 + k, n);
      const double length = std::sqrt(squared(along));
      for (double& x : along) x *= start_distance / length;
    }
    starts.push_back(along);
    for (double& x : along) x = -x;
    starts.push_back(along);
  }
  if (n == 1) {
    for (const double far : {-4., 4.}) starts.push_back({far});  // five in all
  }
  for (const Point& u : scattered_starts(state, at_origin, seed)) starts.push_back(u);
  return starts;
}

double beta_of(const Reached& r) {
  return -std::inner_product(r.u.begin(), r.u.end(), r.at.gradient.begin(), 0.) / r.at.steepness;
}

std::vector<double> importance_of(const LimitState& state, const Slope& at) {
  std::vector<double> gamma = gradient_by_scores(state.inputs().correlation, at.gradient);
  const double whole = squared(gamma);
  for (double& x : gamma) x = x * x / whole;
  return gamma;
}

/// All searches of one question, and what they have found.
class Searches {
 public:
  Searches(const LimitState& state, const FormOptions& options, double at_origin, Form& result)
      : state_(state), options_(options), at_origin_(at_origin), result_(result) {}

  void from(const Point& start, bool both_ways) {
    Reached first = improved_hlrf(state_, start, options_.search);
    if (!first.converged || both_ways) take(slsqp(state_, start, options_.search));
    take(first);
  }

 private:
  void take(const Reached& r) {
    ++result_.searches;
    if (!r.converged) {
      ++reasons_[r.reason];
      return;
    }
    ++result_.converged;
    const double beta = beta_of(r);
    // with the other sign the limit is crossed nearer to the origin
    if (std::abs(beta) > 1e-3 && (beta < 0) != (at_origin_ < 0)) return;
    for (DesignPoint& known : result_.points) {
      if (distance(known.scores, r.u) >= radius_of_one(known.beta)) continue;
      ++known.searches;
      if (std::abs(beta) < std::abs(known.beta) - 1e-3) known = described(r, beta, known.searches);
      return;
    }
    if (result_.points.size() + saddles_.size() >= 3 * most_points) return;
    if (is_saddle(r, beta)) return;
    result_.points.push_back(described(r, beta, 1));
  }

  bool is_saddle(const Reached& r, double beta) {
    for (const Point& saddle : saddles_) {
      if (distance(saddle, r.u) < radius_of_one(beta)) return true;
    }
    shape_ = curved(state_, r.u, r.at, options_.curvature_step);
    if (!shape_ || nearest(beta, *shape_)) return false;
    // the least of 1 + beta k: the least curvature where beta > 0
    if (beta < 0) return false;
    saddles_.push_back(r.u);
    const Point along = shape_->least;
    for (const double aside : {-1., 1.}) {
      Point start = r.u;
      for (std::size_t i = 0; i < start.size(); ++i) start[i] += aside * along[i];
      from(start, false);
    }
    return true;
  }

  DesignPoint described(const Reached& r, double beta, std::size_t searches) {
    DesignPoint p{.scores = r.u,
                  .values = values_at_scores(state_.inputs(), r.u),
                  .beta = beta,
                  .probability = normal_above(beta),
                  .importance = importance_of(state_, r.at),
                  .curvatures = {},
                  .breitung = std::numeric_limits<double>::quiet_NaN(),
                  .searches = searches};
    if (const auto shape = curved(state_, r.u, r.at, options_.curvature_step)) {
      p.curvatures = shape->curvatures;
      p.breitung = breitung(beta, *shape);
    }
    return p;
  }

  const LimitState& state_;
  const FormOptions& options_;
  double at_origin_;
  Form& result_;
  Points saddles_;
  std::optional<Curved> shape_;

 public:
  std::map<std::string, int> reasons_;
};

std::string why_refused(const LimitState& state, double at_origin) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (!continuous(state.inputs().of[i])) {
      return fmt::format(
          "input {} is a list of values; FORM needs a continuous distribution of every input. Ask for "
          "quantiles by samples instead",
          i + 1);
    }
  }
  if (std::isnan(at_origin)) {
    return "the case with all inputs at their medians failed, so there is nothing from where FORM could start. Sample "
           "instead";
  }
  return {};
}

}  // namespace

Form form(const LimitState& state, const FormOptions& options) {
  expects(state.size() > 0, "FORM needs an input");
  Form result;
  const std::uint64_t before = state.evaluations();
  const Point origin(state.size(), 0);
  const double at_origin = why_refused(state, 0).empty() ? state.margins({origin}).front() : 0;
  result.reason = why_refused(state, at_origin);
  if (!result.reason.empty()) {
    result.status = FormStatus::refused;
    result.evaluations = state.evaluations() - before;
    return result;
  }
  FormOptions tuned = options;
  const Points starts = starts_of(state, at_origin, options.seed);
  result.starts = starts.size();
  // the step where truncation h^2 and noise/h are alike; at one of both places the slope may vanish by symmetry
  double steep = 0;
  double rough = 0;
  for (const Point& u : {starts.front(), starts.back()}) {
    const double here = slope(state, u, options.search.step).steepness;
    if (here > steep) steep = here;
    rough = std::max(rough, noise(state, u));
  }
  if (steep > 0) tuned.search.step = std::max(options.search.step, std::min(std::cbrt(rough / steep), 0.2));
  tuned.curvature_step = std::max(options.curvature_step, 2 * tuned.search.step);
  Searches searches(state, tuned, at_origin, result);
  for (const Point& start : starts) searches.from(start, &start == &starts.front());

  std::stable_sort(result.points.begin(), result.points.end(),
                   [](const DesignPoint& a, const DesignPoint& b) { return std::abs(a.beta) < std::abs(b.beta); });
  if (result.points.size() > most_points) result.points.resize(most_points);
  result.evaluations = state.evaluations() - before;
  if (!result.points.empty()) {
    result.status = FormStatus::found;
    return result;
  }
  std::string list;
  for (const auto& [reason, count] : searches.reasons_) {
    list += fmt::format("{}{} ({} of {} searches)", list.empty() ? "" : "; ", reason, count, result.searches);
  }
  if (list.empty()) list = "every search ended at a point that is not the nearest one of the limit";
  result.reason = fmt::format("FORM has found no design point: {}. Sample instead", list);
  return result;
}

}  // namespace taut::chance
