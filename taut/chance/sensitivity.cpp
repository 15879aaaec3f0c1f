#include "taut/chance/sensitivity.hpp"

#include <cmath>
#include <limits>

#include "taut/base/expects.hpp"

namespace taut::chance {
namespace {

/// The sums over the base points of a replicate.
struct Sums {
  double n = 0, mean = 0, squares = 0;  // of A and B, their deviations squared
  std::vector<double> from_b, from_a;   // sums of (f_B - f_ABi)^2, (f_A - f_ABi)^2
};

bool complete(std::span<const double> row) {
  for (const double f : row) {
    if (std::isnan(f)) return false;
  }
  return true;
}

Sums sums_of(std::span<const double> outputs, std::size_t inputs) {
  const std::size_t row = inputs + 2;
  Sums s{.from_b = std::vector<double>(inputs, 0), .from_a = std::vector<double>(inputs, 0)};
  for (std::size_t at = 0; at < outputs.size(); at += row) {
    const auto f = outputs.subspan(at, row);
    if (!complete(f)) continue;
    for (const double value : {f[0], f[1]}) {
      s.n += 1;
      const double before = value - s.mean;
      s.mean += before / s.n;
      s.squares += before * (value - s.mean);
    }
    for (std::size_t i = 0; i < inputs; ++i) {
      s.from_b[i] += (f[1] - f[2 + i]) * (f[1] - f[2 + i]);
      s.from_a[i] += (f[0] - f[2 + i]) * (f[0] - f[2 + i]);
    }
  }
  return s;
}

double variance(const Sums& s) { return s.squares / (s.n - 1); }

/// sum/(2 N V) with N = n/2 base points and V = squares/(n - 1).
double half_share(const Sums& s, double sum) {
  if (!(s.n > 2) || is_leftover(std::sqrt(variance(s)), s.mean)) return std::numeric_limits<double>::quiet_NaN();
  return sum / s.n / variance(s);
}

}  // namespace

bool is_leftover(double difference, double value) {
  constexpr double solved_to = 1e-10;
  return std::abs(difference) <= solved_to * std::abs(value);
}

SaltelliPlan::SaltelliPlan(PointKind kind, std::size_t inputs, std::uint64_t cases, std::uint64_t seed)
    : base_(kind, 2 * inputs, (cases + inputs + 1) / (inputs + 2), seed) {}

Point SaltelliPlan::at(std::uint64_t index) const {
  const std::size_t d = inputs();
  const Point both = base_.at(index / (d + 2));
  const std::size_t k = index % (d + 2);
  const auto half = static_cast<std::ptrdiff_t>(d);
  if (k == 1) return {both.begin() + half, both.end()};
  Point a(both.begin(), both.begin() + half);
  if (k >= 2) a[k - 2] = both[d + k - 2];
  return a;
}

std::string indices_refused(const Inputs& inputs) {
  if (independent(inputs.correlation)) return {};
  return "Sobol indices divide the variance among independent inputs; these are correlated. Leave out 'correlate', or "
         "ask for the importance of FORM";
}

Sensitivity sensitivity(const SaltelliPlan& plan, std::span<const double> outputs, double confidence) {
  expects(outputs.size() == plan.size(), "one output for each case of the plan");
  const std::size_t d = plan.inputs();
  const std::size_t row = d + 2;
  const Sums all = sums_of(outputs, d);

  std::size_t replicates = plan.base().replicates();
  if (replicates == 1) replicates = least_replicates;
  const std::size_t base = outputs.size() / row;
  std::vector<Sums> each;
  for (std::size_t r = 0; r < replicates && base >= 2 * replicates; ++r) {
    const std::size_t from = r * base / replicates;
    const std::size_t to = (r + 1) * base / replicates;
    each.push_back(sums_of(outputs.subspan(from * row, (to - from) * row), d));
  }
  const auto estimate = [&](const auto& index) {
    std::vector<double> own;
    own.reserve(each.size());
    for (const Sums& s : each) own.push_back(index(s));
    const double pooled = index(all);
    return Estimate{.value = pooled, .interval = replicate_interval(pooled, own, confidence)};
  };
  Sensitivity result{.left_out = base - static_cast<std::uint64_t>(all.n / 2), .base = base};
  result.varies = !(all.n > 2) || !is_leftover(std::sqrt(variance(all)), all.mean);
  for (std::size_t i = 0; i < d; ++i) {
    result.of.push_back({.first = estimate([&](const Sums& s) { return 1 - half_share(s, s.from_b[i]); }),
                         .total = estimate([&](const Sums& s) { return half_share(s, s.from_a[i]); })});
  }
  return result;
}

Points tornado_points(const Inputs& inputs, double p) {
  expects(p > 0 && p < 0.5, "a chance below one half");
  Point medians;
  for (const Distribution& d : inputs.of) medians.push_back(value_at(d, 0.5));
  Points points{medians};
  for (std::size_t i = 0; i < medians.size(); ++i) {
    for (const double chance : {p, 1 - p}) {
      points.push_back(medians);
      points.back()[i] = value_at(inputs.of[i], chance);
    }
  }
  return points;
}

}  // namespace taut::chance
