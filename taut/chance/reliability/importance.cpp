#include "taut/chance/reliability/importance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/chance/counter.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance {
namespace {

constexpr std::uint64_t block = 1000;
constexpr double beyond_3_sigma = 0.00135;

/// The normals at the design points, with the upper ends of their shares of the unit interval.
struct Mixture {
  std::vector<Point> centres;
  std::vector<double> shares, ends;
};

Mixture mixture_of(const Form& form) {
  Mixture m;
  double most = 0;
  for (const DesignPoint& p : form.points) most = std::max(most, normal_above(std::abs(p.beta)));
  double whole = 0;
  for (const DesignPoint& p : form.points) {
    m.centres.push_back(p.scores);
    m.shares.push_back(std::max(normal_above(std::abs(p.beta)), most / 10));
    whole += m.shares.back();
  }
  double end = 0;
  for (double& share : m.shares) {
    share /= whole;
    m.ends.push_back(end += share);
  }
  m.ends.back() = 1;
  return m;
}

/// Sample `index`: its centre is chosen by column 0, its offsets are the columns after it.
Point sample_of(const Mixture& m, std::uint64_t seed, std::uint64_t index) {
  const double which = unit(random_bits(seed, Use::importance, 0, index, 0));
  const auto k = static_cast<std::size_t>(std::upper_bound(m.ends.begin(), m.ends.end(), which) - m.ends.begin());
  Point u = m.centres[std::min(k, m.centres.size() - 1)];
  for (std::uint32_t i = 0; i < u.size(); ++i)
    u[i] += normal_score(unit(random_bits(seed, Use::importance, 0, index, i + 1)));
  return u;
}

/// phi(u)/sum pi_k phi(u - c_k) = 1/sum pi_k exp(c_k.u - |c_k|^2/2).
double weight_of(const Mixture& m, const Point& u) {
  double sum = 0;
  for (std::size_t k = 0; k < m.centres.size(); ++k) {
    double exponent = 0;
    for (std::size_t i = 0; i < u.size(); ++i) exponent += m.centres[k][i] * (u[i] - m.centres[k][i] / 2);
    sum += m.shares[k] * std::exp(exponent);
  }
  return 1 / sum;
}

/// Sums of weights and of their squares: cases that keep the limit, that do not, that failed.
struct WeightSums {
  double n = 0, kept = 0, beyond = 0, failed = 0;
  double kept_squares = 0, beyond_squares = 0, failed_squares = 0;
};

/// A sample with its margin, NaN where it failed.
void take(double margin, double weight, ImportanceSampling& result, WeightSums& sums) {
  if (std::isnan(margin)) {
    ++result.failed;
    sums.failed += weight;
    sums.failed_squares += weight * weight;
  } else if (margin < 0) {
    ++result.beyond;
    sums.beyond += weight;
    sums.beyond_squares += weight * weight;
  } else {
    sums.kept += weight;
    sums.kept_squares += weight * weight;
  }
}

Weighted weighted(double value, double standard_error) {
  return {.value = value,
          .standard_error = standard_error,
          .variation = value > 0 ? standard_error / value : std::numeric_limits<double>::infinity()};
}

double error_of(double mean, double mean_square, double n) {
  return std::sqrt(std::max(0., mean_square - mean * mean) / n);
}

/// The numbers of the region beyond the limit. The coefficient of variation of what is sampled.
double estimate_beyond(ImportanceSampling& result, const WeightSums& s) {
  const double a = s.beyond / s.n;
  const double b = s.failed / s.n;
  // a case is beyond or failed, never both: the products vanish
  result.counted = weighted(a + b, error_of(a + b, (s.beyond_squares + s.failed_squares) / s.n, s.n));
  // ratio a/(1 - b): linearised, each sample counts (w_a + p w_b)/(1 - b)
  const double left = std::max(1 - b, std::numeric_limits<double>::min());
  const double p = a / left;
  const double squares = (s.beyond_squares + p * p * s.failed_squares) / s.n / (left * left);
  result.left_out = weighted(p, error_of(p, squares, s.n));
  return result.counted.variation;
}

/// The same by the region that keeps the limit: around its design points weights of the other side are unbounded.
double estimate_kept(ImportanceSampling& result, const WeightSums& s) {
  const double kept = s.kept / s.n;
  const double error = error_of(kept, s.kept_squares / s.n, s.n);
  result.counted = weighted(std::max(0., 1 - kept), error);
  return weighted(kept, error).variation;
}

/// (p - F)/(1 - F), linearised for its error; F is the failed share of the plain sample.
Weighted left_out_by(const Weighted& p, const std::optional<LimitProbability>& plain) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!plain || plain->failed == plain->cases) return {.value = none, .standard_error = none, .variation = none};
  const auto n = static_cast<double>(plain->cases);
  const double failed = static_cast<double>(plain->failed) / n;
  const double left = 1 - failed;
  const double by_failed = (1 - p.value) / left * std::sqrt(failed * left / n);
  return weighted(std::clamp((p.value - failed) / left, 0., 1.), std::hypot(p.standard_error, by_failed) / left);
}

LimitProbability plain_sample(const LimitState& state, std::uint64_t count, const ImportanceOptions& options) {
  std::vector<double> margins;
  for (std::uint64_t from = 0; from < count; from += block) {
    Points points;
    for (std::uint64_t k = from; k < std::min(from + block, count); ++k) {
      Point u(state.size());
      for (std::uint32_t i = 0; i < u.size(); ++i) {
        u[i] = normal_score(unit(random_bits(options.seed, Use::plain, 0, k, i)));
      }
      points.push_back(std::move(u));
    }
    const std::vector<double> g = state.margins(points);
    margins.insert(margins.end(), g.begin(), g.end());
  }
  return limit_probability({.values = margins, .confidence = options.confidence},
                           {.bound = Bound::at_least, .value = 0});
}

Estimate share_of(std::uint64_t hits, std::uint64_t cases, double confidence) {
  if (cases == 0) return {.value = std::numeric_limits<double>::quiet_NaN(), .interval = {.low = 0, .high = 1}};
  const auto k = static_cast<double>(hits);
  const auto n = static_cast<double>(cases);
  return {.value = k / n, .interval = binomial_interval(k, n, confidence)};
}

/// `given` with cases added until there are `count`.
std::optional<LimitProbability> completed(const LimitState& state, const std::optional<LimitProbability>& given,
                                          std::uint64_t count, const ImportanceOptions& options) {
  const std::uint64_t before = given ? given->cases : 0;
  if (before >= count) return given;
  const LimitProbability own = plain_sample(state, count - before, options);
  if (before == 0) return own;
  LimitProbability all{.cases = before + own.cases,
                       .failed = given->failed + own.failed,
                       .beyond = given->beyond + own.beyond,
                       .left_out = {},
                       .counted = {}};
  all.left_out = share_of(all.beyond, all.cases - all.failed, options.confidence);
  all.counted = share_of(all.beyond + all.failed, all.cases, options.confidence);
  return all;
}

/// In how many plain cases a missed region of the probability `missed`, beside one of the probability `known`, shows:
/// more cases lie there than `known` explains, in all samples but a share of (1 - confidence)/2. No fewer than clean
/// cases bring Clopper & Pearson's upper end down to `missed`; at most `plain_samples`.
std::uint64_t cases_to_see(double known, const ImportanceOptions& options) {
  const auto shows = [&](std::uint64_t cases) {
    const auto n = static_cast<double>(cases);
    double unexplained = std::ceil(n * known);
    while (1 - binomial_below(unexplained - 1, n, known) >= beyond_3_sigma) ++unexplained;
    return binomial_below(unexplained - 1, n, std::min(1., known + options.missed)) <= (1 - options.confidence) / 2;
  };
  const double clean = std::log((1 - options.confidence) / 2) / std::log1p(-options.missed);
  auto low = static_cast<std::uint64_t>(clean);
  std::uint64_t high = options.plain_samples;
  if (high <= low || !shows(high)) return high;
  while (high - low > 1) {
    const std::uint64_t middle = (low + high) / 2;
    (shows(middle) ? high : low) = middle;
  }
  return high;
}

bool disagree(const Weighted& p, const LimitProbability& plain) {
  const auto n = static_cast<double>(plain.cases);
  const auto hits = static_cast<double>(plain.beyond + plain.failed);
  constexpr double few = 10;
  if (std::min(hits, n * p.value) >= few && std::min(n - hits, n - n * p.value) >= few) {
    const double either = std::max(hits / n * (1 - hits / n), p.value * (1 - p.value)) / n;
    return std::abs(hits / n - p.value) > 3 * std::sqrt(either + p.standard_error * p.standard_error);
  }
  const double most = std::clamp(p.value + 3 * p.standard_error, 0., 1.);
  const double least = std::clamp(p.value - 3 * p.standard_error, 0., 1.);
  return 1 - binomial_below(hits - 1, n, most) < beyond_3_sigma || binomial_below(hits, n, least) < beyond_3_sigma;
}

}  // namespace

ImportanceSampling importance_sampling(const LimitState& state, const Form& form, const ImportanceOptions& options,
                                       const std::optional<LimitProbability>& plain) {
  ImportanceSampling result;
  if (form.status != FormStatus::found) {
    result.reason = form.reason;
    return result;
  }
  const Mixture mixture = mixture_of(form);
  // all points of one form have the same sign
  const bool by_kept = form.points.front().beta < 0;
  WeightSums sums;
  double variation = 0;
  do {
    Points points;
    for (std::uint64_t k = 0; k < block; ++k) points.push_back(sample_of(mixture, options.seed, result.samples + k));
    const std::vector<double> g = state.margins(points);
    for (std::size_t k = 0; k < points.size(); ++k) take(g[k], weight_of(mixture, points[k]), result, sums);
    result.samples += block;
    sums.n = static_cast<double>(result.samples);
    variation = by_kept ? estimate_kept(result, sums) : estimate_beyond(result, sums);
  } while (result.samples < options.most_samples && !(variation <= options.wanted_variation));

  const Weighted& p = result.counted;
  const std::uint64_t beyond = result.beyond + result.failed;
  if (!(variation <= options.worst_variation)) {
    result.plain = completed(state, plain, options.plain_samples, options);
    result.status = ImportanceStatus::not_converged;
    result.reason = fmt::format(
        "importance sampling has not converged: {} of {} samples {} the limit, coefficient of variation {:.2g} "
        "(at most {})",
        by_kept ? result.samples - beyond : beyond, result.samples, by_kept ? "keep" : "lie beyond", variation,
        options.worst_variation);
    return result;
  }
  const double sampled = (by_kept ? 1 - p.value : p.value) + 3 * p.standard_error;
  result.plain = completed(state, plain, cases_to_see(std::clamp(sampled, 0., 1.), options), options);
  if (by_kept) result.left_out = left_out_by(p, result.plain);
  if (result.plain && disagree(p, *result.plain)) {
    result.status = ImportanceStatus::disagrees;
    result.reason = fmt::format(
        "sampling at the design points gives {:.3g}, a plain sample of {} cases {:.3g}: they differ by more than 3 "
        "standard deviations, so FORM has missed a way to {}",
        p.value, result.plain->cases, result.plain->counted.value, by_kept ? "keep the limit" : "fail");
    return result;
  }
  result.status = ImportanceStatus::found;
  if (p.value < 1e-4) {
    result.rests_on = fmt::format("rests on {} samples around the design points, of which {} lie beyond the limit",
                                  result.samples, beyond);
  }
  return result;
}

}  // namespace taut::chance
