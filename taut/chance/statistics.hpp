#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace taut::chance {

/// A range that holds the true value with the confidence asked for; an end without a bound is infinite.
struct Interval {
  double low = 0, high = 0;
};

/// A number and its confidence interval, in the unit of the values.
struct Estimate {
  double value = 0;
  Interval interval;
};

/// The values of one output in the order of the cases, NaN where a case failed. Random points have one replicate; of
/// Latin hypercubes and Sobol points every replicate has the same number of consecutive cases (see PointSet), and there
/// must be at least 16: the interval is Student's over the replicates' own estimates,
/// pooled +- t_(R-1) s/sqrt(R), as the points of one replicate are not independent of each other.
struct Sample {
  std::span<const double> values;
  std::size_t replicates = 1;
  double confidence = 0.95;  ///< two-sided, 0.5 < confidence < 1
};

/// All estimates leave failed cases out and sum in the order of the cases.
std::size_t failed_cases(const Sample& s);

/// The mean. Random points: Student's interval. NaN without values; infinite interval with fewer than two, or where
/// fewer than 16 replicates have values.
Estimate sample_mean(const Sample& s);

/// The standard deviation. Random points: divisor n - 1; normal interval with the variance of s^2 by the fourth moment,
/// (m4 - s^4)/n, which is for large n and any law. Replicates: the root of the mean square about the mean of all, m,
/// and of the variance of m itself, s_r^2/R by the R replicates' means. It has no bias, as
/// E[mean (x - m)^2] = sigma^2 - Var m, where n - 1 holds Var m to be sigma^2/n: evenly spread points have less.
/// Interval: the root of the variance's.
Estimate sample_sd(const Sample& s);

/// The p-quantiles, 0 < p < 1, between order statistics that stand at p = (j - 1/2)/n (Hazen; Hyndman & Fan 1996, type
/// 5). Random points: distribution-free interval from the order statistics x_(l), x_(u) with P(B < l) and P(B >= u)
/// at most (1 - confidence)/2 each, B binomial(n, p) (David & Nagaraja, Order Statistics, section 7.1). Replicates:
/// no bound where fewer than 5 values of a replicate lie beyond the quantile.
std::vector<Estimate> quantiles(const Sample& s, std::span<const double> p);

/// Bins of equal width from the least to the largest value. Their number: range/width with Freedman & Diaconis' width
/// 2 (q75 - q25) n^(-1/3), rounded up, 1 to 60; one bin where all values are equal, the root of n where the quartiles
/// are. A value on an edge counts above it, the largest in the last bin.
struct Histogram {
  std::vector<double> edges;  ///< one more than bins; empty without values
  std::vector<std::uint64_t> counts;
};
Histogram histogram(std::span<const double> values);

enum class Bound { at_least, at_most };

/// What an output must keep; a case goes beyond it where the margin is below 0.
struct Limit {
  Bound bound = Bound::at_least;
  double value = 0;
};

/// at_least: output - value; at_most: value - output, with the rounding of a value on its limit (rounding_on). NaN of
/// NaN.
double margin(const Limit& limit, double output);

/// How probable it is that a limit is not kept. Random points: Clopper & Pearson's interval (1934), which holds for any
/// count. Replicates: Student's interval over them, within 0 and 1; where fewer than 5 cases a replicate (on average)
/// lie on either side of the limit, it is widened to hold Clopper & Pearson's too, as the scatter of a few counts says
/// little.
struct LimitProbability {
  std::uint64_t cases = 0, failed = 0, beyond = 0;
  Estimate left_out;  ///< beyond/(cases - failed): failed cases left out
  Estimate counted;   ///< (beyond + failed)/cases: failed cases counted as beyond; this one decides
};
LimitProbability limit_probability(const Sample& s, const Limit& limit);

/// limit_probability of the first cases, as their number grows: for random points at about `steps` counts with equal
/// ratios, for replicates after each one from the 16th on. The last is that of all cases.
std::vector<LimitProbability> convergence(const Sample& s, const Limit& limit, std::size_t steps = 40);

enum class Allowed { kept, exceeded, not_judged };

/// The interval of a probability against an allowed one: kept where it lies below or ends at it, exceeded where it lies
/// above, not judged where it straddles it.
Allowed judged(const Estimate& probability, double allowed);

/// About how many cases it takes until the interval no longer straddles `allowed`, if the estimate stays as it is: half
/// its width falls with the root of their number; where no case is beyond the limit, its upper end falls with the
/// number itself. Rounded up to two digits; empty where the estimate equals `allowed` or more than 1e12 are needed.
std::optional<std::uint64_t> cases_needed(const LimitProbability& probability, double allowed);

/// What the replicates' estimates say of the pooled one: pooled +- t s/sqrt(R). NaN estimates are left out; infinite
/// with fewer than 16.
Interval replicate_interval(double pooled, std::span<const double> estimates, double confidence);

/// Clopper & Pearson's interval of hits of n, 0 <= hits <= n, n > 0.
Interval binomial_interval(double hits, double n, double confidence);

}  // namespace taut::chance
