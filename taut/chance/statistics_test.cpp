#include "taut/chance/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "taut/chance/inputs.hpp"
#include "taut/chance/point_set.hpp"
#include "taut/math/roots.hpp"

namespace taut::chance::statistics_test {

const double failed = std::nan("");
constexpr double infinity = std::numeric_limits<double>::infinity();

bool holds(const Interval& i, double x) { return i.low <= x && x <= i.high; }

/// Y = -ln(U) (1 + V): mean 3/2, variance 2 7/3 - 9/4; P(Y > y) = integral of exp(-y/(1 + v)) over v.
std::vector<double> exponential(PointKind kind, std::uint64_t samples, std::uint64_t seed) {
  const PointSet set(kind, 2, samples, seed);
  std::vector<double> values;
  for (std::uint64_t k = 0; k < set.size(); ++k) {
    const Point u = set.at(k);
    values.push_back(-std::log(u[0]) * (1 + u[1]));
  }
  return values;
}

double exceeded(double y) {
  double sum = 0;
  for (int k = 0; k < 1000; ++k) sum += std::exp(-y / (1 + (k + 0.5) / 1000)) / 1000;
  return sum;
}

// Clopper & Pearson: 0 of n ends at 1 - (alpha/2)^(1/n); 4 of 10: 0.1216, 0.7376 (their chart; any table).
TEST(Statistics, clopper_pearson) {
  const Interval none = binomial_interval(0, 50, 0.95);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 1 - std::pow(0.025, 1. / 50), 1e-12);
  const Interval four = binomial_interval(4, 10, 0.95);
  EXPECT_NEAR(four.low, 0.1216, 5e-5);
  EXPECT_NEAR(four.high, 0.7376, 5e-5);
  EXPECT_EQ(binomial_interval(10, 10, 0.95).high, 1);
}

TEST(Statistics, failed_cases_both_ways) {
  const std::vector<double> v{1, 2, failed, 3, 4, 5, failed, 6, 7, 8};
  const LimitProbability p = limit_probability({.values = v}, {.bound = Bound::at_least, .value = 3});
  EXPECT_EQ(p.cases, 10u);
  EXPECT_EQ(p.failed, 2u);
  EXPECT_EQ(p.beyond, 2u);
  EXPECT_EQ(p.left_out.value, 0.25);
  EXPECT_EQ(p.counted.value, 0.4);
  EXPECT_NEAR(p.counted.interval.high, 0.7376, 5e-5);
  EXPECT_EQ(limit_probability({v}, {Bound::at_most, 5}).beyond, 3u);
  EXPECT_EQ(failed_cases({v}), 2u);
  EXPECT_EQ(sample_mean({v}).value, 4.5);
  EXPECT_NEAR(sample_sd({v}).value, std::sqrt(6.), 1e-15);
  const std::vector<double> all_failed{failed, failed};
  EXPECT_TRUE(std::isnan(limit_probability({all_failed}, {}).left_out.value));
  EXPECT_EQ(limit_probability({all_failed}, {}).counted.value, 1);
  EXPECT_TRUE(std::isnan(sample_mean({all_failed}).value));
}

// Gosset's sleep data (extra hours, drug 2 - drug 1): mean 1.58, 95 % interval 0.70 to 2.46.
TEST(Statistics, students_own_data) {
  const std::vector<double> hours{1.2, 2.4, 1.3, 1.3, 0, 1.0, 1.8, 0.8, 4.6, 1.4};
  const Estimate e = sample_mean({.values = hours});
  EXPECT_NEAR(e.value, 1.58, 1e-12);
  EXPECT_NEAR(e.interval.low, 0.7001142, 1e-6);
  EXPECT_NEAR(e.interval.high, 2.4598858, 1e-6);
}

// n = 20, p = 0.5: x_(6), x_(15) (P(B <= 5) = 0.0207); no upper bound of the 99 % quantile.
TEST(Statistics, quantile_between_order_statistics) {
  std::vector<double> v(20);
  std::iota(v.rbegin(), v.rend(), 1.);
  const auto q = quantiles({.values = v}, std::vector<double>{0.5, 0.99, 0.975});
  EXPECT_EQ(q[0].value, 10.5);
  EXPECT_EQ(q[0].interval.low, 6);
  EXPECT_EQ(q[0].interval.high, 15);
  EXPECT_EQ(q[1].interval.high, infinity);
  EXPECT_GT(q[1].interval.low, 15);
  EXPECT_EQ(q[2].value, 20);
}

// 300 seeds: the truth lies inside of nine tenths of the 95 % intervals at least, of every kind of points, of mean, sd,
// quantile and probability; and the width of the intervals is no excuse: Sobol's are narrower than random ones'.
TEST(Statistics, intervals_hold_the_truth) {
  const double middle = *find_root([](double y) { return exceeded(y) - 0.5; }, 0, 5);
  double width_random = 0;
  for (const PointKind kind : {PointKind::random, PointKind::latin, PointKind::sobol}) {
    int mean = 0;
    int sd = 0;
    int median = 0;
    int probability = 0;
    double width = 0;
    constexpr int seeds = 300;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const auto v = exponential(kind, 4096, seed);
      const Sample s{.values = v, .replicates = kind == PointKind::random ? 1u : 16u};
      mean += holds(sample_mean(s).interval, 1.5);
      sd += holds(sample_sd(s).interval, std::sqrt(14. / 3 - 2.25));
      median += holds(quantiles(s, std::vector<double>{0.5})[0].interval, middle);
      const Estimate p = limit_probability(s, {.bound = Bound::at_most, .value = 2}).counted;
      probability += holds(p.interval, exceeded(2));
      width += p.interval.high - p.interval.low;
    }
    for (const int count : {mean, sd, median, probability}) {
      EXPECT_GE(count, 0.9 * seeds) << static_cast<int>(kind) << ' ' << mean << ' ' << sd << ' ' << median;
      EXPECT_LE(count, seeds);
    }
    EXPECT_LT(mean, seeds);
    if (kind == PointKind::random) width_random = width;
    if (kind == PointKind::sobol) {
      EXPECT_LT(width, width_random / 3);
    }
  }
}

// Of uniform numbers, whose standard deviation is 1/sqrt(12). Points of a net have a mean far nearer to the true one
// than independent ones, sigma^2/n off: n - 1 as a divisor made the middle of the interval 1/(2 n) of it too large,
// which is more than its width (at 2048 points 7 of 8 intervals missed the truth).
TEST(Statistics, the_interval_of_the_sd_of_a_net_holds_the_truth) {
  constexpr int seeds = 300;
  int held = 0;
  double off = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const PointSet points(PointKind::sobol, 1, 2048, seed);
    std::vector<double> v;
    v.reserve(points.size());
    for (std::uint64_t i = 0; i < points.size(); ++i) v.push_back(2 + 2 * points.at(i)[0]);
    const Estimate sd = sample_sd({.values = v, .replicates = points.replicates()});
    held += holds(sd.interval, 2 / std::sqrt(12.));
    off += (sd.value * std::sqrt(12.) / 2 - 1) / seeds;
    const auto& [low, high] = sd.interval;
    EXPECT_NEAR(sd.value * sd.value, (low * low + high * high) / 2, 1e-12) << "the middle is that of the variance";
  }
  EXPECT_GE(held, 0.9 * seeds);
  EXPECT_LT(held, seeds);
  EXPECT_LT(std::abs(off), 2e-5) << "1/(2 n) is 2.4e-4";
}

// Independent values in replicates: without bias too, as the scatter of the means is what n - 1 holds it to be.
TEST(Statistics, the_sd_of_independent_replicates_has_no_bias) {
  constexpr int seeds = 4000;
  double variance = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const PointSet points(PointKind::random, 1, 32, seed);
    std::vector<double> v;
    v.reserve(points.size());
    for (std::uint64_t i = 0; i < points.size(); ++i) v.push_back(points.at(i)[0]);
    variance += std::pow(sample_sd({.values = v, .replicates = 16}).value, 2) / seeds;
  }
  // the variance of s^2 is (m4 - s^4)/n = (1/80 - 1/144)/32, its root over the seeds 2.1e-4; n as a divisor: 2.6e-3 off
  EXPECT_NEAR(variance, 1. / 12, 8e-4);
}

TEST(Statistics, a_value_on_its_limit_is_not_beyond_it) {
  const std::vector<double> v = {30e3 * (1 + 2e-13), 29e3, 30e3 * (1 + 1e-8), 31e3};
  EXPECT_EQ(limit_probability({.values = v}, {.bound = Bound::at_most, .value = 30e3}).beyond, 2U);
  const std::vector<double> w = {3 * (1 - 2e-13), 3 * (1 - 1e-8)};
  EXPECT_EQ(limit_probability({.values = w}, {.bound = Bound::at_least, .value = 3}).beyond, 1U);
}

// No case beyond the limit in any replicate: the scatter is 0, the upper bound is not.
TEST(Statistics, a_rare_case_is_no_impossible_one) {
  const std::vector<double> v(1600, 5.);
  const LimitProbability p = limit_probability({.values = v, .replicates = 16}, {.bound = Bound::at_least, .value = 3});
  EXPECT_EQ(p.counted.value, 0);
  EXPECT_NEAR(p.counted.interval.high, 1 - std::pow(0.025, 1. / 1600), 1e-9);
  EXPECT_EQ(judged(p.counted, 1e-2), Allowed::kept);
  EXPECT_EQ(judged(p.counted, 1e-3), Allowed::not_judged);
  const auto needed = cases_needed(p, 1e-3);
  ASSERT_TRUE(needed);
  EXPECT_NEAR(static_cast<double>(*needed), 3700, 100);
  const std::vector<double> enough(*needed / 16 * 16 + 16, 5.);
  EXPECT_EQ(judged(limit_probability({enough, 16}, {Bound::at_least, 3}).counted, 1e-3), Allowed::kept);
}

// A net puts 6 of its 32 points below 6/32 of an input, and a seventh below 0.188 in one of 62 scramblings. 16 that
// agree do not say that there is no seventh: on paper 1 - 0.025^(1/16) of a case is left open on either side.
TEST(Statistics, replicates_that_agree_are_no_certainty) {
  std::vector<double> v;
  for (int r = 0; r < 16; ++r) {
    for (int k = 0; k < 32; ++k) v.push_back((k + 0.9) / 32);
  }
  const LimitProbability p =
      limit_probability({.values = v, .replicates = 16}, {.bound = Bound::at_least, .value = 0.188});
  EXPECT_EQ(p.counted.value, 6. / 32);
  const double open = 1 - std::pow(0.025, 1. / 16);
  EXPECT_NEAR(p.counted.interval.low, (6 - open) / 32, 1e-12);
  EXPECT_NEAR(p.counted.interval.high, (6 + open) / 32, 1e-12);
  EXPECT_EQ(judged(p.counted, 0.1879), Allowed::not_judged);
  EXPECT_EQ(judged(p.counted, 0.2), Allowed::kept);
  v[6] = 0.1;  // one replicate has a seventh: Clopper and Pearson's 1 of 16
  const LimitProbability one =
      limit_probability({.values = v, .replicates = 16}, {.bound = Bound::at_least, .value = 0.188});
  const Interval of_16 = binomial_interval(1, 16, 0.95);
  EXPECT_NEAR(one.counted.interval.high, (6 + of_16.high) / 32, 1e-12);
  EXPECT_LT(one.counted.interval.low, (6 + of_16.low) / 32 + 1e-12);
}

// True shares between two counts of a net: the interval holds them in nine of ten seeds at least.
TEST(Statistics, a_share_between_two_counts_of_a_net_is_held) {
  for (const double share : {0.188, 0.2, 0.3125 + 0.01, 0.49}) {
    int held = 0;
    constexpr int seeds = 200;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const PointSet points(PointKind::sobol, 1, 512, seed);
      std::vector<double> v;
      v.reserve(points.size());
      for (std::uint64_t i = 0; i < points.size(); ++i) v.push_back(points.at(i)[0]);
      const Sample s{.values = v, .replicates = points.replicates()};
      held += holds(limit_probability(s, {.bound = Bound::at_least, .value = share}).counted.interval, share);
    }
    EXPECT_GE(held, 0.93 * seeds) << share;
  }
}

TEST(Statistics, cases_needed_until_it_is_judged) {
  std::vector<double> v(1000, 1.);
  std::fill_n(v.begin(), 12, -1.);
  const LimitProbability p = limit_probability({.values = v}, {.bound = Bound::at_least, .value = 0});
  ASSERT_EQ(judged(p.counted, 0.01), Allowed::not_judged);
  const auto needed = cases_needed(p, 0.01);
  ASSERT_TRUE(needed);
  const auto n = static_cast<double>(*needed);
  EXPECT_EQ(judged({0.012, binomial_interval(0.012 * n, n, 0.95)}, 0.01), Allowed::exceeded);
  EXPECT_EQ(judged({0.012, binomial_interval(0.006 * n, n / 2, 0.95)}, 0.01), Allowed::not_judged);
  EXPECT_FALSE(cases_needed(p, 0.012));
  EXPECT_EQ(judged(p.counted, 0.5), Allowed::kept);
  EXPECT_EQ(judged(p.counted, 1e-4), Allowed::exceeded);
  EXPECT_EQ(cases_needed(p, 0.5), 1000u);
}

TEST(Statistics, histogram_counts_every_case) {
  const auto v = exponential(PointKind::random, 5000, 4);
  const Histogram h = histogram(v);
  EXPECT_EQ(h.edges.size(), h.counts.size() + 1);
  EXPECT_EQ(std::accumulate(h.counts.begin(), h.counts.end(), std::uint64_t{0}), 5000u);
  EXPECT_GT(h.counts.size(), 20u);
  EXPECT_LE(h.counts.size(), 60u);
  const std::vector<double> five{0, 1, 1, failed, 2, 4};
  const Histogram few = histogram(five);  // width 2 (q75 - q25)/5^(1/3) with q75 = 2.5, q25 = 0.75
  EXPECT_EQ(few.counts, (std::vector<std::uint64_t>{3, 2}));
  EXPECT_EQ(few.edges, (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(histogram(std::vector<double>(7, 3.)).counts, (std::vector<std::uint64_t>{7}));
  EXPECT_TRUE(histogram({}).counts.empty());
}

TEST(Statistics, convergence_ends_with_all_cases) {
  const auto v = exponential(PointKind::random, 1000, 4);
  const auto all = convergence({.values = v}, {.bound = Bound::at_most, .value = 2}, 20);
  EXPECT_EQ(all.back().cases, 1000u);
  EXPECT_EQ(all.back().counted.value, limit_probability({v}, {Bound::at_most, 2}).counted.value);
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_GT(all[k].cases, all[k - 1].cases);
  const auto sobol = exponential(PointKind::sobol, 20ULL * 64, 4);
  EXPECT_EQ(convergence({sobol, 20}, {Bound::at_most, 2}).size(), 5u);
}

// Too few replicates have values, or too few values lie beyond the quantile: no bound.
TEST(Statistics, no_bound_without_evidence) {
  std::vector<double> v = exponential(PointKind::sobol, 16ULL * 64, 4);
  EXPECT_EQ(quantiles({v, 16}, std::vector<double>{0.99})[0].interval.high, infinity);
  EXPECT_LT(quantiles({v, 16}, std::vector<double>{0.9})[0].interval.high, infinity);
  std::fill_n(v.begin(), 64, failed);
  EXPECT_EQ(sample_mean({v, 16}).interval.high, infinity);
}

}  // namespace taut::chance::statistics_test
