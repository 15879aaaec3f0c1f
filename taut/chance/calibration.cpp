#include "taut/chance/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"
#include "taut/chance/counter.hpp"
#include "taut/chance/least_squares.hpp"
#include "taut/chance/standard_laws.hpp"
#include "taut/math/eigen_symmetric.hpp"

namespace taut::chance {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using FreeList = std::vector<FreeParameter>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double alike = 0.99;            // correlation of estimates that are not told apart
constexpr double null_eigenvalue = 1e-9;  // of J^T J with columns of unit length

Index index(std::size_t i) { return static_cast<Index>(i); }

double value_of(const FreeParameter& p, double t) { return p.low + t * (p.high - p.low); }

Point point_of(const FreeList& free, const VectorXd& t) {
  Point x(free.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = value_of(free[i], t[index(i)]);
  return x;
}

std::vector<VectorXd> starts_of(const FreeList& free, const CalibrationOptions& options) {
  std::vector<VectorXd> starts;
  for (std::size_t k = 0; k < std::max<std::size_t>(options.starts, 1); ++k) {
    VectorXd t(index(free.size()));
    for (std::uint32_t i = 0; i < free.size(); ++i) {
      t[index(i)] = k == 0 ? 0.5 : unit(random_bits(options.seed, Use::points, 0, k, i));
      if (const auto& start = free[i].start; k == 0 && start) {
        t[index(i)] = std::clamp((*start - free[i].low) / (free[i].high - free[i].low), 0., 1.);
      }
    }
    starts.push_back(t);
  }
  return starts;
}

/// What the Jacobian at the fit tells: covariance of t for unit sd, and who is not told from whom.
struct Told {
  MatrixXd covariance;        // of the unknowns that can be identified
  std::vector<bool> in_null;  // held by a null direction, or without effect
  std::vector<Inseparable> groups;
  int rank = 0;
};

Told told_by(const LeastSquares& fit) {
  const auto n = static_cast<std::size_t>(fit.t.size());
  Told told{.covariance = MatrixXd::Constant(fit.t.size(), fit.t.size(), no_number),
            .in_null = std::vector<bool>(n, false),
            .groups = {}};
  std::vector<std::size_t> active;
  const VectorXd lengths = fit.J.colwise().norm();
  for (std::size_t i = 0; i < n; ++i) {
    if (fit.held[i] != 0) continue;
    if (lengths[index(i)] > 0) {
      active.push_back(i);
    } else {
      told.in_null[i] = true;
    }
  }
  MatrixXd A(fit.J.rows(), index(active.size()));
  for (std::size_t a = 0; a < active.size(); ++a) {
    A.col(index(a)) = fit.J.col(index(active[a])) / lengths[index(active[a])];
  }
  const SymmetricEigen eigen = symmetric_eigen(A.transpose() * A);
  MatrixXd inverse = MatrixXd::Zero(A.cols(), A.cols());
  for (Index k = 0; k < A.cols(); ++k) {
    const VectorXd v = eigen.vectors.col(k);
    if (eigen.values[k] >= null_eigenvalue) {
      inverse += v * v.transpose() / eigen.values[k];
      ++told.rank;
      continue;
    }
    Inseparable group;
    std::vector<double> components;
    for (std::size_t a = 0; a < active.size(); ++a) {
      if (std::abs(v[index(a)]) < 0.1) continue;
      group.parameters.push_back(active[a]);
      components.push_back(v[index(a)]);
      told.in_null[active[a]] = true;
    }
    expects(components.size() >= 2, "columns of unit length depend on each other");
    group.correlation = components[0] * components[1] > 0 ? 1 : -1;
    told.groups.push_back(group);
  }
  for (std::size_t a = 0; a < active.size(); ++a) {
    for (std::size_t b = 0; b < active.size(); ++b) {
      const double both = lengths[index(active[a])] * lengths[index(active[b])];
      told.covariance(index(active[a]), index(active[b])) = inverse(index(a), index(b)) / both;
    }
  }
  return told;
}

/// Pairs whose estimates move almost as one.
void add_alike(std::vector<Inseparable>& groups, const Told& told) {
  const MatrixXd& C = told.covariance;
  for (Index i = 0; i < C.rows(); ++i) {
    for (Index j = i + 1; j < C.rows(); ++j) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      if (told.in_null[a] || told.in_null[b]) continue;
      const double correlation = C(i, j) / std::sqrt(C(i, i) * C(j, j));
      if (std::abs(correlation) >= alike) groups.push_back({{a, b}, correlation});
    }
  }
}

std::string with_others(std::size_t i, const std::vector<Inseparable>& groups, const FreeList& free) {
  std::string names;
  for (const Inseparable& group : groups) {
    if (std::find(group.parameters.begin(), group.parameters.end(), i) == group.parameters.end()) continue;
    for (const std::size_t other : group.parameters) {
      if (other != i) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", free[other].name);
    }
  }
  return names;
}

std::string why_not_identifiable(std::size_t i, const Calibration& c, const FreeList& free, bool no_effect) {
  if (const std::string others = with_others(i, c.inseparable, free); !others.empty()) {
    return fmt::format("the measurements cannot tell '{}' from {}: fix one of them, or measure something else",
                       free[i].name, others);
  }
  if (no_effect) return fmt::format("no measured quantity depends on '{}'", free[i].name);
  return fmt::format("the measurements do not narrow the bounds of '{}': its standard error is above half of them",
                     free[i].name);
}

CalibratedParameter at_bound(const FreeParameter& p, double value, int held) {
  CalibratedParameter result{
      .value = value, .standard_error = no_number, .spread = no_number, .interval = {.low = p.low, .high = p.high}};
  result.state = held < 0 ? ParameterState::at_low : ParameterState::at_high;
  result.note = fmt::format("'{}' ends at its {} bound: widen it, or doubt the model; no interval", p.name,
                            held < 0 ? "lower" : "upper");
  return result;
}

/// Of both ends of an interval.
struct Quantile {
  double own = 0, normal = 0;  ///< of the law of the estimates; of the normal law
};

/// The parameters with their intervals; `variance` of a residual is 1 where sd is given.
void describe(Calibration& c, const LeastSquares& fit, const FreeList& free, double variance,
              const Quantile& quantile) {
  Told told = told_by(fit);
  c.inseparable = told.groups;
  add_alike(c.inseparable, told);
  const std::size_t n = free.size();
  for (std::size_t i = 0; i < n; ++i) {
    const FreeParameter& p = free[i];
    const double value = value_of(p, fit.t[index(i)]);
    if (fit.held[i] != 0) {
      c.parameters.push_back(at_bound(p, value, fit.held[i]));
      continue;
    }
    CalibratedParameter result{
        .value = value, .standard_error = no_number, .spread = no_number, .interval = {.low = p.low, .high = p.high}};
    const double error = std::sqrt(variance * told.covariance(index(i), index(i)));
    const bool no_effect = !(fit.J.col(index(i)).norm() > 0);
    if (told.in_null[i] || error > 0.5) {
      result.state = ParameterState::not_identifiable;
      result.note = why_not_identifiable(i, c, free, no_effect);
    } else if (std::isnan(error)) {
      result.note = "as many parameters as measurements: give the standard deviations of these, or measure more";
    } else {
      result.standard_error = error * (p.high - p.low);
      const double half = quantile.own * result.standard_error;
      result.spread = half / quantile.normal;
      result.interval = {.low = std::max(p.low, value - half), .high = std::min(p.high, value + half)};
    }
    c.parameters.push_back(result);
  }
  c.covariance.assign(n * n, no_number);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (std::isnan(c.parameters[i].standard_error) || std::isnan(c.parameters[j].standard_error)) continue;
      c.covariance[i * n + j] =
          variance * told.covariance(index(i), index(j)) * (free[i].high - free[i].low) * (free[j].high - free[j].low);
    }
  }
}

/// Whether two fits differ in an identified parameter, by more than three standard errors and a twentieth of its
/// range.
bool different(const Calibration& best, const Point& other, const FreeList& free) {
  for (std::size_t i = 0; i < free.size(); ++i) {
    const CalibratedParameter& p = best.parameters[i];
    if (p.state == ParameterState::not_identifiable) continue;
    const double apart = std::abs(other[i] - p.value);
    if (apart > 0.05 * (free[i].high - free[i].low) && !(apart <= 3 * p.standard_error)) return true;
  }
  return false;
}

/// The converged fits from all starts, the best first; `failed`: why others did not converge.
std::vector<LeastSquares> fits_of(const Residuals& residuals, const FreeList& free, const CalibrationOptions& options,
                                  std::string& failed) {
  std::vector<LeastSquares> fits;
  for (const VectorXd& start : starts_of(free, options)) {
    LeastSquares fit =
        least_squares(residuals, start, {.step = options.step, .most_iterations = options.most_iterations});
    if (fit.converged) {
      fits.push_back(std::move(fit));
    } else if (failed.find(fit.reason) == std::string::npos) {
      failed += (failed.empty() ? "" : "; ") + fit.reason;
    }
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const LeastSquares& a, const LeastSquares& b) { return a.r.squaredNorm() < b.r.squaredNorm(); });
  return fits;
}

/// Fits that lie clearly elsewhere with chi squared within `as_good` of the best, each once.
void add_other_fits(Calibration& c, const std::vector<LeastSquares>& fits, const FreeList& free, double as_good) {
  for (const LeastSquares& other : fits) {
    const Point x = point_of(free, other.t);
    if (other.r.squaredNorm() > c.chi_squared + as_good || !different(c, x, free)) continue;
    const bool known = std::any_of(c.other_fits.begin(), c.other_fits.end(), [&](const Point& y) {
      for (std::size_t i = 0; i < free.size(); ++i) {
        if (std::abs(y[i] - x[i]) > 0.05 * (free[i].high - free[i].low)) return false;
      }
      return true;
    });
    if (!known) c.other_fits.push_back(x);
  }
}

/// The model's rows less the measurements, in standard deviations; `evaluations` counts the cases.
Residuals residuals_of(const Evaluate& model, const FreeList& free, const Measured& measured,
                       std::uint64_t& evaluations) {
  return [&](const std::vector<VectorXd>& points) {
    Points x;
    x.reserve(points.size());
    for (const VectorXd& t : points) x.push_back(point_of(free, t));
    const auto rows = model(x);
    expects(rows.size() == x.size(), "the model gives a row for each point");
    evaluations += rows.size();
    std::vector<VectorXd> all;
    all.reserve(rows.size());
    for (const auto& row : rows) {
      expects(row.size() == measured.values.size(), "the model gives an output for each measurement");
      VectorXd r(index(row.size()));
      for (std::size_t j = 0; j < row.size(); ++j) {
        r[index(j)] = (row[j] - measured.values[j]) / (measured.sd.empty() ? 1 : measured.sd[j]);
      }
      all.push_back(std::move(r));
    }
    return all;
  };
}

}  // namespace

std::string mistake(const std::vector<FreeParameter>& free, const Measured& measured) {
  if (free.empty()) return "no parameter is free: name one at least";
  if (measured.values.empty()) return "nothing was measured";
  for (const FreeParameter& p : free) {
    if (!(std::isfinite(p.low) && std::isfinite(p.high) && p.low < p.high)) {
      return fmt::format("'{}': the lower bound ({}) must be below the upper one ({})", p.name, p.low, p.high);
    }
  }
  if (!measured.sd.empty() && measured.sd.size() != measured.values.size()) {
    return fmt::format("{} standard deviations for {} measurements: give one for each, or none", measured.sd.size(),
                       measured.values.size());
  }
  for (std::size_t j = 0; j < measured.values.size(); ++j) {
    if (!std::isfinite(measured.values[j])) return fmt::format("measurement {} is not a number", j + 1);
    if (!measured.sd.empty() && !(measured.sd[j] > 0 && std::isfinite(measured.sd[j]))) {
      return fmt::format("the standard deviation of measurement {} must be above 0", j + 1);
    }
  }
  return {};
}

Calibration calibrate(const Evaluate& model, const std::vector<FreeParameter>& free, const Measured& measured,
                      const CalibrationOptions& options) {
  expects(mistake(free, measured).empty(), "free parameters with bounds, measurements with a standard deviation");
  const bool given = !measured.sd.empty();
  const std::size_t m = measured.values.size();
  Calibration c;
  const Residuals residuals = residuals_of(model, free, measured, c.evaluations);
  std::string failed;
  const std::vector<LeastSquares> fits = fits_of(residuals, free, options, failed);
  if (fits.empty()) {
    c.reason = "the calibration has not converged from any start: " + failed;
    return c;
  }
  const LeastSquares& fit = fits.front();
  c.status = CalibrationStatus::found;
  c.chi_squared = fit.r.squaredNorm();
  c.freedom = static_cast<int>(m) - told_by(fit).rank;
  c.sd = given || c.freedom <= 0 ? no_number : std::sqrt(c.chi_squared / c.freedom);
  c.p_value = given && c.freedom > 0 ? chi_squared_above(c.chi_squared, c.freedom) : no_number;
  const double upper = (1 + options.confidence) / 2;
  const double variance = given ? 1 : c.sd * c.sd;
  const double normal = normal_score(upper);
  const double own = given ? normal : c.freedom > 0 ? student_value(upper, c.freedom) : no_number;
  describe(c, fit, free, variance, {.own = own, .normal = normal});
  for (std::size_t j = 0; j < m; ++j) {
    c.residuals.push_back(-fit.r[index(j)] * (given ? measured.sd[j] : 1));
    c.model.push_back(measured.values[j] - c.residuals.back());
  }
  add_other_fits(c, fits, free, 4 * (given ? 1 : c.chi_squared / std::max(c.freedom, 1)));
  return c;
}

}  // namespace taut::chance
