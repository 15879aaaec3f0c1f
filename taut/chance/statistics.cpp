#include "taut/chance/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "taut/base/expects.hpp"
#include "taut/base/on_limit.hpp"
#include "taut/chance/point_set.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double enough_beyond = 5;  // values a replicate beyond a quantile or a limit

void check(const Sample& s) {
  expects(s.confidence > 0.5 && s.confidence < 1, "a confidence lies above one half and below 1");
  expects(s.replicates == 1 || s.replicates >= least_replicates, "at least 16 replicates");
  expects(s.values.size() % s.replicates == 0, "replicates of the same number of cases");
}

std::span<const double> replicate(const Sample& s, std::size_t r) {
  const std::size_t n = s.values.size() / s.replicates;
  return s.values.subspan(r * n, n);
}

std::vector<double> known(std::span<const double> values) {
  std::vector<double> kept;
  kept.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(kept), [](double x) { return !std::isnan(x); });
  return kept;
}

double upper_t(double confidence, std::size_t count) {
  return student_value((1 + confidence) / 2, static_cast<double>(count - 1));
}

struct Moments {
  double n = 0, mean = none, variance = none, fourth = none;  // central; variance with n - 1
};

Moments moments(std::span<const double> values) {
  Moments m;
  double sum = 0;
  for (const double x : values) {
    if (std::isnan(x)) continue;
    sum += x;
    m.n += 1;
  }
  if (m.n == 0) return m;
  m.mean = sum / m.n;
  double second = 0;
  double fourth = 0;
  for (const double x : values) {
    if (std::isnan(x)) continue;
    const double d2 = (x - m.mean) * (x - m.mean);
    second += d2;
    fourth += d2 * d2;
  }
  m.fourth = fourth / m.n;
  if (m.n > 1) m.variance = second / (m.n - 1);
  return m;
}

double mean_square(std::span<const double> values, double about) {
  double n = 0;
  double sum = 0;
  for (const double x : values) {
    if (std::isnan(x)) continue;
    n += 1;
    sum += (x - about) * (x - about);
  }
  return n > 0 ? sum / n : none;
}

/// The pooled estimate with the interval from the same estimate of every replicate.
Estimate over_replicates(const Sample& s, double pooled,
                         const std::function<double(std::span<const double>)>& estimate) {
  std::vector<double> each(s.replicates);
  for (std::size_t r = 0; r < s.replicates; ++r) each[r] = estimate(replicate(s, r));
  return {.value = pooled, .interval = replicate_interval(pooled, each, s.confidence)};
}

double hazen(const std::vector<double>& sorted, double p) {
  if (sorted.empty()) return none;
  const auto last = static_cast<double>(sorted.size() - 1);
  const double place = std::clamp(p * static_cast<double>(sorted.size()) - 0.5, 0., last);
  const auto j = static_cast<std::size_t>(place);
  if (j + 1 == sorted.size()) return sorted[j];
  const double t = place - std::floor(place);
  return sorted[j] + t * (sorted[j + 1] - sorted[j]);
}

/// The least k from 0 to n with P(B <= k) > chance.
std::size_t least_above(std::size_t n, double p, double chance) {
  std::size_t low = 0;
  std::size_t high = n;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (binomial_below(static_cast<double>(middle), static_cast<double>(n), p) > chance) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

Interval order_interval(const std::vector<double>& sorted, double p, double confidence) {
  const std::size_t n = sorted.size();
  Interval i{.low = -unbounded, .high = unbounded};
  if (n == 0) return i;
  const double tail = (1 - confidence) / 2;
  // the largest l with P(B <= l - 1) <= tail is the least k with P(B <= k) > tail; x_(l) counts from 1
  if (const std::size_t l = least_above(n, p, tail); l >= 1) i.low = sorted[l - 1];
  // the least u with P(B >= u) <= tail, which is P(n - B <= n - u) <= tail
  if (const std::size_t l = least_above(n, 1 - p, tail); l >= 1) i.high = sorted[n - l];
  return i;
}

double hits_of(std::span<const double> values, const Limit& limit) {
  return static_cast<double>(
      std::count_if(values.begin(), values.end(), [&](double x) { return margin(limit, x) < 0; }));
}

double failures_of(std::span<const double> values) {
  return static_cast<double>(std::count_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }));
}

struct Count {
  double hits = 0, n = 0;
};

/// What counts of replicates that differ by one case at most say of the share. Their mean is between two whole numbers,
/// and the replicates are so many tries for the larger one. All alike, they do not tell which of both it is.
Interval of_neighbours(const std::vector<Count>& each, double confidence) {
  const auto fewer_hits = [](const Count& a, const Count& b) { return a.hits < b.hits; };
  const double least = std::min_element(each.begin(), each.end(), fewer_hits)->hits;
  const double most = std::max_element(each.begin(), each.end(), fewer_hits)->hits;
  if (most - least > 1) return {.low = unbounded, .high = -unbounded};
  const auto larger = std::count_if(each.begin(), each.end(), [&](const Count& c) { return c.hits > least; });
  const Interval of_larger =
      binomial_interval(static_cast<double>(larger), static_cast<double>(each.size()), confidence);
  const auto [fewest, all] =
      std::minmax_element(each.begin(), each.end(), [](const Count& a, const Count& b) { return a.n < b.n; });
  if (fewest->n == 0) return {.low = 0, .high = 1};
  const double low = larger == 0 ? -of_larger.high : of_larger.low;
  return {.low = (least + low) / all->n, .high = (least + of_larger.high) / fewest->n};
}

Interval holding_both(const Interval& a, const Interval& b) {
  return {.low = std::min(a.low, b.low), .high = std::max(a.high, b.high)};
}

Estimate share(const Sample& s, const std::function<Count(std::span<const double>)>& count) {
  const Count all = count(s.values);
  if (all.n == 0) return {.value = none, .interval = {.low = 0, .high = 1}};
  const double p = all.hits / all.n;
  const Interval exact = binomial_interval(all.hits, all.n, s.confidence);
  if (s.replicates == 1) return {.value = p, .interval = exact};
  Estimate e = over_replicates(s, p, [&](std::span<const double> values) {
    const Count c = count(values);
    return c.n > 0 ? c.hits / c.n : none;
  });
  std::vector<Count> each;
  each.reserve(s.replicates);
  for (std::size_t r = 0; r < s.replicates; ++r) each.push_back(count(replicate(s, r)));
  e.interval = holding_both(e.interval, of_neighbours(each, s.confidence));
  e.interval = {.low = std::max(e.interval.low, 0.), .high = std::min(e.interval.high, 1.)};
  if (std::min(all.hits, all.n - all.hits) < enough_beyond * static_cast<double>(s.replicates)) {
    e.interval = holding_both(e.interval, exact);
  }
  return e;
}

}  // namespace

Interval replicate_interval(double pooled, std::span<const double> estimates, double confidence) {
  const Moments m = moments(estimates);
  if (m.n < static_cast<double>(least_replicates) || std::isnan(pooled)) return {.low = -unbounded, .high = unbounded};
  const double half = upper_t(confidence, static_cast<std::size_t>(m.n)) * std::sqrt(m.variance / m.n);
  return {.low = pooled - half, .high = pooled + half};
}

Interval binomial_interval(double hits, double n, double confidence) {
  expects(n > 0 && hits >= 0 && hits <= n, "hits of n cases");
  const double tail = (1 - confidence) / 2;
  return {.low = hits == 0 ? 0 : beta_value(tail, hits, n - hits + 1),
          .high = hits == n ? 1 : beta_value(1 - tail, hits + 1, n - hits)};
}

std::size_t failed_cases(const Sample& s) { return static_cast<std::size_t>(failures_of(s.values)); }

Estimate sample_mean(const Sample& s) {
  check(s);
  const Moments m = moments(s.values);
  if (s.replicates > 1) {
    return over_replicates(s, m.mean, [](std::span<const double> values) { return moments(values).mean; });
  }
  if (!(m.n > 1)) return {.value = m.mean, .interval = {.low = -unbounded, .high = unbounded}};
  const double half = upper_t(s.confidence, static_cast<std::size_t>(m.n)) * std::sqrt(m.variance / m.n);
  return {.value = m.mean, .interval = {.low = m.mean - half, .high = m.mean + half}};
}

Estimate sample_sd(const Sample& s) {
  check(s);
  const Moments m = moments(s.values);
  const double sd = std::sqrt(m.variance);
  Estimate e{.value = sd, .interval = {.low = 0, .high = unbounded}};
  if (s.replicates > 1) {
    // The mean square about the mean of all falls short of the variance by the variance of that mean, which n - 1 holds
    // to be that of independent values. The scatter of the replicates' means tells it; their own estimates have the
    // same mean as the pooled one.
    std::vector<double> means(s.replicates);
    for (std::size_t r = 0; r < s.replicates; ++r) means[r] = moments(replicate(s, r)).mean;
    const Moments of_means = moments(means);
    const double short_by = of_means.n > 1 ? of_means.variance / of_means.n : none;
    e = over_replicates(s, mean_square(s.values, m.mean) + short_by,
                        [&](std::span<const double> values) { return mean_square(values, m.mean) + short_by; });
    e.value = std::sqrt(e.value);
    e.interval = {.low = std::sqrt(std::max(e.interval.low, 0.)), .high = std::sqrt(e.interval.high)};
  } else if (m.n > 1 && sd > 0) {
    const double spread = std::sqrt(std::max(0., m.fourth - m.variance * m.variance) / m.n) / (2 * sd);
    const double half = normal_score((1 + s.confidence) / 2) * spread;
    e.interval = {.low = sd - half, .high = sd + half};
  }
  e.interval.low = std::max(e.interval.low, 0.);
  return e;
}

std::vector<Estimate> quantiles(const Sample& s, std::span<const double> p) {
  check(s);
  const auto sorted_of = [](std::span<const double> values) {
    std::vector<double> sorted = known(values);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const std::vector<double> all = sorted_of(s.values);
  std::vector<std::vector<double>> each;
  if (s.replicates > 1) {
    for (std::size_t r = 0; r < s.replicates; ++r) each.push_back(sorted_of(replicate(s, r)));
  }
  std::vector<Estimate> estimates;
  for (const double chance : p) {
    expects(chance > 0 && chance < 1, "a quantile's chance lies within 0 and 1");
    Estimate e{.value = hazen(all, chance), .interval = {}};
    if (s.replicates == 1) {
      e.interval = order_interval(all, chance, s.confidence);
    } else {
      std::vector<double> own;
      for (const auto& sorted : each) {
        const double beyond = static_cast<double>(sorted.size()) * std::min(chance, 1 - chance);
        own.push_back(beyond >= enough_beyond ? hazen(sorted, chance) : none);
      }
      e.interval = replicate_interval(e.value, own, s.confidence);
    }
    estimates.push_back(e);
  }
  return estimates;
}

Histogram histogram(std::span<const double> values) {
  std::vector<double> sorted = known(values);
  if (sorted.empty()) return {};
  std::sort(sorted.begin(), sorted.end());
  const double low = sorted.front();
  const double range = sorted.back() - low;
  const auto n = static_cast<double>(sorted.size());
  const double width = 2 * (hazen(sorted, 0.75) - hazen(sorted, 0.25)) / std::cbrt(n);
  double bins = 1;
  if (range > 0) bins = std::clamp(std::ceil(width > 0 ? range / width : std::sqrt(n)), 1., 60.);
  Histogram h;
  h.counts.resize(static_cast<std::size_t>(bins));
  for (std::size_t k = 0; k < h.counts.size(); ++k) h.edges.push_back(low + range * static_cast<double>(k) / bins);
  h.edges.push_back(sorted.back());
  std::size_t bin = 0;
  for (const double x : sorted) {
    while (bin + 1 < h.counts.size() && x >= h.edges[bin + 1]) ++bin;
    ++h.counts[bin];
  }
  return h;
}

double margin(const Limit& limit, double output) {
  const double left = limit.bound == Bound::at_least ? output - limit.value : limit.value - output;
  return left + rounding_on(limit.value);
}

LimitProbability limit_probability(const Sample& s, const Limit& limit) {
  check(s);
  LimitProbability p;
  p.cases = s.values.size();
  p.failed = failed_cases(s);
  p.beyond = static_cast<std::uint64_t>(hits_of(s.values, limit));
  p.left_out = share(s, [&](std::span<const double> values) {
    return Count{.hits = hits_of(values, limit), .n = static_cast<double>(values.size()) - failures_of(values)};
  });
  p.counted = share(s, [&](std::span<const double> values) {
    return Count{.hits = hits_of(values, limit) + failures_of(values), .n = static_cast<double>(values.size())};
  });
  return p;
}

std::vector<LimitProbability> convergence(const Sample& s, const Limit& limit, std::size_t steps) {
  check(s);
  const std::size_t n = s.values.size();
  std::vector<LimitProbability> all;
  if (s.replicates > 1) {
    for (std::size_t r = least_replicates; r <= s.replicates; ++r) {
      all.push_back(limit_probability(
          {.values = s.values.first(n / s.replicates * r), .replicates = r, .confidence = s.confidence}, limit));
    }
    return all;
  }
  std::size_t before = 0;
  for (std::size_t k = 1; k <= steps && n > 0; ++k) {
    const double ratio = static_cast<double>(k) / static_cast<double>(steps);
    const auto count = k == steps ? n : static_cast<std::size_t>(std::round(std::pow(static_cast<double>(n), ratio)));
    if (count <= before) continue;
    all.push_back(
        limit_probability({.values = s.values.first(count), .replicates = 1, .confidence = s.confidence}, limit));
    before = count;
  }
  return all;
}

Allowed judged(const Estimate& probability, double allowed) {
  if (probability.interval.high <= allowed) return Allowed::kept;
  if (probability.interval.low > allowed) return Allowed::exceeded;
  return Allowed::not_judged;
}

std::optional<std::uint64_t> cases_needed(const LimitProbability& probability, double allowed) {
  const auto& [value, interval] = probability.counted;
  const auto n = static_cast<double>(probability.cases);
  if (judged(probability.counted, allowed) != Allowed::not_judged) return probability.cases;
  // half of the whole interval: its two halves become alike as it shrinks
  const double ratio = (interval.high - interval.low) / 2 / std::abs(allowed - value);
  const double needed = value == 0 ? n * interval.high / allowed : n * ratio * ratio;
  if (!(needed < 1e12)) return std::nullopt;
  const double unit = std::pow(10, std::max(0., std::floor(std::log10(needed)) - 1));
  return static_cast<std::uint64_t>(std::ceil(needed / unit) * unit);
}

}  // namespace taut::chance
