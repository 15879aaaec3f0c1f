#include "taut/chance/reliability/design_point.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <numeric>

namespace taut::chance {
namespace {

double dot(const Point& a, const Point& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.); }

double length(const Point& a) { return std::sqrt(dot(a, a)); }

Point moved(const Point& from, double by, const Point& along) {
  Point to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += by * along[i];
  return to;
}

constexpr const char* failed_at = "the case failed before the limit was reached";
constexpr const char* flat = "the margin does not change with the inputs";

/// Whether u is the end: on the limit, and along the gradient.
bool at_end(const Point& u, const Slope& at, const SearchOptions& options) {
  const double steep = at.steepness;
  if (!(std::abs(at.margin) / steep <= options.distance)) return false;
  const Point across = moved(u, -dot(u, at.gradient) / (steep * steep), at.gradient);
  return length(across) <= options.direction * std::max(1., length(u));
}

/// The first of the halved steps along d that lowers the merit enough; empty: none.
Point shortened(const LimitState& state, const Reached& from, const Point& d, double c) {
  constexpr double least_share = 0.1;  // of the fall that the slope promises (Armijo)
  constexpr int batches = 3;
  constexpr int in_batch = 4;
  const double g = from.at.margin;
  const double merit = dot(from.u, from.u) / 2 + c * std::abs(g);
  const double fall = dot(from.u, d) + c * (g < 0 ? -1 : 1) * dot(from.at.gradient, d);
  double share = 1;
  for (int batch = 0; batch < batches; ++batch) {
    Points tries;
    for (int k = 0; k < in_batch; ++k) tries.push_back(moved(from.u, std::ldexp(share, -k), d));
    const std::vector<double> margins = state.margins(tries);
    for (std::size_t k = 0; k < tries.size(); ++k, share /= 2) {
      const double after = dot(tries[k], tries[k]) / 2 + c * std::abs(margins[k]);
      if (after <= merit + least_share * share * std::min(fall, 0.)) return tries[k];
    }
  }
  return {};
}

/// A C library calls back: exceptions wait here until it has returned.
struct Programme {
  const LimitState& state;
  const SearchOptions& options;
  double scale = 1;
  nlopt_opt optimiser = nullptr;
  std::exception_ptr thrown;
  bool failed = false;
};

double half_square(unsigned n, const double* u, double* gradient, void* /*data*/) {
  double sum = 0;
  for (unsigned i = 0; i < n; ++i) {
    sum += u[i] * u[i] / 2;
    if (gradient) gradient[i] = u[i];
  }
  return sum;
}

double scaled_margin(unsigned n, const double* u, double* gradient, void* data) {
  auto& programme = *static_cast<Programme*>(data);
  try {
    const Point point(u, u + n);
    if (!gradient) {
      const double g = programme.state.margins({point}).front();
      if (!std::isnan(g)) return g / programme.scale;
    } else if (const Slope s = slope(programme.state, point, programme.options.step);
               !std::isnan(s.margin) && !std::isnan(s.steepness)) {
      for (unsigned i = 0; i < n; ++i) gradient[i] = s.gradient[i] / programme.scale;
      return s.margin / programme.scale;
    }
    programme.failed = true;
  } catch (...) {
    programme.thrown = std::current_exception();
  }
  nlopt_force_stop(programme.optimiser);
  if (gradient) std::fill_n(gradient, n, 0);
  return 0;
}

}  // namespace

Reached improved_hlrf(const LimitState& state, const Point& start, const SearchOptions& options) {
  constexpr double longest = 3;  // step, in scores: the limit is not a plane for longer
  Reached r{.u = start};
  for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
    r.at = slope(state, r.u, options.step);
    const double steep = r.at.steepness;
    if (std::isnan(r.at.margin) || std::isnan(steep)) {
      r.reason = failed_at;
      return r;
    }
    if (!(steep > 0)) {
      r.reason = flat;
      return r;
    }
    if (at_end(r.u, r.at, options)) {
      r.converged = true;
      return r;
    }
    const double along = (dot(r.at.gradient, r.u) - r.at.margin) / (steep * steep);
    Point d = moved(Point(r.u.size(), 0), along, r.at.gradient);
    const double next = length(d);
    d = moved(d, -1, r.u);
    const double size = length(d);
    const double g = std::abs(r.at.margin);
    double c = length(r.u) / steep;
    if (g > options.distance * steep) c = std::max(c, next * next / (2 * g));
    if (size > longest) {
      for (double& x : d) x *= longest / size;
    }
    const Point to = shortened(state, r, d, 2 * c);
    if (to.empty()) {
      r.reason = "no step comes nearer to the limit (failed cases, a kink, or noise)";
      return r;
    }
    r.u = to;
    if (length(r.u) > options.farthest) {
      r.reason = fmt::format("no limit within {} standard deviations", options.farthest);
      return r;
    }
  }
  r.reason = fmt::format("not converged after {} steps", options.most_iterations);
  return r;
}

Reached slsqp(const LimitState& state, const Point& start, const SearchOptions& options) {
  Programme programme{.state = state, .options = options, .thrown = nullptr};
  Reached r{.u = start};
  r.at = slope(state, start, options.step);
  if (std::isnan(r.at.margin) || std::isnan(r.at.steepness)) {
    r.reason = failed_at;
    return r;
  }
  programme.scale = std::max(r.at.steepness, 1e-3 * std::abs(r.at.margin));
  if (!(programme.scale > 0)) {
    r.reason = flat;
    return r;
  }
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
      nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(start.size())), &nlopt_destroy);
  programme.optimiser = optimiser.get();
  nlopt_set_lower_bounds1(programme.optimiser, -options.farthest);
  nlopt_set_upper_bounds1(programme.optimiser, options.farthest);
  nlopt_set_min_objective(programme.optimiser, half_square, nullptr);
  nlopt_add_equality_constraint(programme.optimiser, scaled_margin, &programme, options.distance / 10);
  nlopt_set_xtol_abs1(programme.optimiser, options.distance / 10);
  nlopt_set_maxeval(programme.optimiser, options.most_iterations);
  double least = 0;
  nlopt_optimize(programme.optimiser, r.u.data(), &least);  // whatever it says, the end is judged below
  if (programme.thrown) std::rethrow_exception(programme.thrown);
  if (programme.failed) {
    r.reason = failed_at;
    return r;
  }
  r.at = slope(state, r.u, options.step);
  r.converged = r.at.steepness > 0 && at_end(r.u, r.at, options) && length(r.u) <= options.farthest;
  if (!r.converged) r.reason = "sequential quadratic programming did not reach the limit";
  return r;
}

}  // namespace taut::chance
