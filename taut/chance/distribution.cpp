#include "taut/chance/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A chance and the chance against it, so that the smaller one keeps its digits.
struct Chance {
  double below = 0, above = 1;
};

Chance chance_of_score(double z) { return {.below = normal_below(z), .above = normal_above(z)}; }

double score_of_chance(const Chance& c) {
  return c.below < c.above ? normal_score(c.below) : normal_score_above(c.above);
}

struct LogLaw {
  double mu = 0, sigma = 1;
};

LogLaw log_law(const Lognormal& d) {
  const double cov = d.sd / d.mean;
  const double variance = std::log1p(cov * cov);
  return {.mu = std::log(d.mean) - variance / 2, .sigma = std::sqrt(variance)};
}

// The uncut laws. chance_of: P(X <= x) and P(X > x); value_of: its inverse; density_of: its derivative.

Chance chance_of(const Normal& d, double x) { return chance_of_score((x - d.mean) / d.sd); }
double value_of(const Normal& d, const Chance& c) { return d.mean + d.sd * score_of_chance(c); }
double density_of(const Normal& d, double x) { return normal_density((x - d.mean) / d.sd) / d.sd; }

Chance chance_of(const Lognormal& d, double x) {
  if (x <= 0) return {.below = 0, .above = 1};
  const LogLaw l = log_law(d);
  return chance_of_score((std::log(x) - l.mu) / l.sigma);
}
double value_of(const Lognormal& d, const Chance& c) {
  const LogLaw l = log_law(d);
  return std::exp(l.mu + l.sigma * score_of_chance(c));
}
double density_of(const Lognormal& d, double x) {
  if (x <= 0) return 0;
  const LogLaw l = log_law(d);
  return normal_density((std::log(x) - l.mu) / l.sigma) / (l.sigma * x);
}

Chance chance_of(const Uniform& d, double x) {
  const double inside = std::clamp(x, d.low, d.high);
  return {.below = (inside - d.low) / (d.high - d.low), .above = (d.high - inside) / (d.high - d.low)};
}
double value_of(const Uniform& d, const Chance& c) {
  return c.below < c.above ? d.low + c.below * (d.high - d.low) : d.high - c.above * (d.high - d.low);
}
double density_of(const Uniform& d, double x) { return x < d.low || x > d.high ? 0 : 1 / (d.high - d.low); }

Chance chance_of(const Gumbel& d, double x) {
  const double e = std::exp(-(x - d.mode) / d.scale);
  return {.below = std::exp(-e), .above = -std::expm1(-e)};
}
double value_of(const Gumbel& d, const Chance& c) {
  const double minus_log = c.below < c.above ? -std::log(c.below) : -std::log1p(-c.above);
  return d.mode - d.scale * std::log(minus_log);
}
double density_of(const Gumbel& d, double x) {
  const double y = (x - d.mode) / d.scale;
  return std::exp(-y - std::exp(-y)) / d.scale;
}

Chance chance_of(const Weibull& d, double x) {
  if (x <= d.shift) return {.below = 0, .above = 1};
  const double hazard = std::pow((x - d.shift) / d.scale, d.shape);
  return {.below = -std::expm1(-hazard), .above = std::exp(-hazard)};
}
double value_of(const Weibull& d, const Chance& c) {
  const double hazard = c.below < c.above ? -std::log1p(-c.below) : -std::log(c.above);
  return d.shift + d.scale * std::pow(hazard, 1 / d.shape);
}
double density_of(const Weibull& d, double x) {
  if (x < d.shift) return 0;
  const double t = (x - d.shift) / d.scale;
  return d.shape / d.scale * std::pow(t, d.shape - 1) * std::exp(-std::pow(t, d.shape));
}

Chance chance_of(const Triangular& d, double x) {
  const double inside = std::clamp(x, d.low, d.high);
  const double left = inside - d.low;
  const double right = d.high - inside;
  const double width = d.high - d.low;
  if (inside < d.mode) {
    const double p = left * left / (width * (d.mode - d.low));
    return {.below = p, .above = 1 - p};
  }
  const double q = right == 0 ? 0 : right * right / (width * (d.high - d.mode));
  return {.below = 1 - q, .above = q};
}
double value_of(const Triangular& d, const Chance& c) {
  const double width = d.high - d.low;
  if (c.below * width < d.mode - d.low) return d.low + std::sqrt(c.below * width * (d.mode - d.low));
  return d.high - std::sqrt(c.above * width * (d.high - d.mode));
}
double density_of(const Triangular& d, double x) {
  if (x < d.low || x > d.high) return 0;
  const double width = d.high - d.low;
  if (x < d.mode) return 2 * (x - d.low) / (width * (d.mode - d.low));
  if (x == d.mode) return 2 / width;
  return 2 * (d.high - x) / (width * (d.high - d.mode));
}

double weight(const Listed& d, std::size_t i) { return d.weights.empty() ? 1 : d.weights[i]; }

double whole_weight(const Listed& d) {
  double sum = 0;
  for (std::size_t i = 0; i < d.values.size(); ++i) sum += weight(d, i);
  return sum;
}

Chance chance_of(const Listed& d, double x) {
  double lower = 0;
  double upper = 0;
  for (std::size_t i = 0; i < d.values.size(); ++i) (d.values[i] <= x ? lower : upper) += weight(d, i);
  const double whole = whole_weight(d);
  return {.below = lower / whole, .above = upper / whole};
}
double value_of(const Listed& d, const Chance& c) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < d.values.size(); ++i) {
    if (weight(d, i) > 0) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return d.values[a] != d.values[b] ? d.values[a] < d.values[b] : a < b;
  });
  const double whole = whole_weight(d);
  double lower = 0;
  for (const std::size_t i : order) {
    lower += weight(d, i);
    if (lower >= c.below * whole) return d.values[i];
  }
  return d.values[order.back()];  // rounding of the sum
}
double density_of(const Listed& /*d*/, double /*x*/) {
  expects(false, "a list has no density");
  return 0;
}

Chance uncut(const Law& law, double x) {
  return std::visit([&](const auto& d) { return chance_of(d, x); }, law);
}

/// What the cut leaves: the chances of its two ends in the uncut law, and the chance between them.
struct Cut {
  Chance from, to;
  double mass = 1;
};

Cut cut_of(const Distribution& d) {
  Cut c{.from = {.below = 0, .above = 1}, .to = {.below = 1, .above = 0}};
  if (d.from) c.from = uncut(d.law, *d.from);
  if (d.to) c.to = uncut(d.law, *d.to);
  c.mass = c.from.below < 0.5 ? c.to.below - c.from.below : c.from.above - c.to.above;
  return c;
}

bool is_cut(const Distribution& d) { return d.from || d.to; }

double inside_cut(const Distribution& d, double x) {
  if (d.from) x = std::max(x, *d.from);
  if (d.to) x = std::min(x, *d.to);
  return x;
}

Chance chance_of(const Distribution& d, double x) {
  if (!is_cut(d)) return uncut(d.law, x);
  const Cut cut = cut_of(d);
  const Chance at = uncut(d.law, inside_cut(d, x));
  // differences of the small ones of both tails
  const auto between = [](const Chance& a, const Chance& b) {
    return a.below < 0.5 ? b.below - a.below : a.above - b.above;
  };
  return {.below = std::clamp(between(cut.from, at) / cut.mass, 0., 1.),
          .above = std::clamp(between(at, cut.to) / cut.mass, 0., 1.)};
}

double value_of(const Distribution& d, const Chance& c) {
  const auto of_law = [&](const Chance& chance) {
    return std::visit([&](const auto& law) { return value_of(law, chance); }, d.law);
  };
  if (!is_cut(d)) return of_law(c);
  const Cut cut = cut_of(d);
  // sums of positive terms: no digits are lost in either tail
  const Chance in_law{.below = cut.from.below + c.below * cut.mass, .above = cut.to.above + c.above * cut.mass};
  return inside_cut(d, of_law(in_law));
}

std::string above_zero(const char* key, double value) {
  return value > 0 ? std::string() : fmt::format("{} must be above 0, not {}", key, value);
}

std::string first(std::string a, std::string b) { return a.empty() ? std::move(b) : std::move(a); }

std::string wrong(const Normal& d) { return above_zero("sd", d.sd); }
std::string wrong(const Lognormal& d) { return first(above_zero("mean", d.mean), above_zero("sd", d.sd)); }
std::string wrong(const Uniform& d) {
  return d.low < d.high ? std::string() : fmt::format("low ({}) must be below high ({})", d.low, d.high);
}
std::string wrong(const Gumbel& d) { return above_zero("scale", d.scale); }
std::string wrong(const Weibull& d) { return first(above_zero("shape", d.shape), above_zero("scale", d.scale)); }
std::string wrong(const Triangular& d) {
  if (d.low < d.high && d.low <= d.mode && d.mode <= d.high) return {};
  return fmt::format("mode ({}) must lie between low ({}) and high ({}), and low below high", d.mode, d.low, d.high);
}
std::string wrong(const Listed& d) {
  if (d.values.empty()) return "the list has no value";
  if (!d.weights.empty() && d.weights.size() != d.values.size()) {
    return fmt::format("{} weights for {} values: give a weight for each value, or none", d.weights.size(),
                       d.values.size());
  }
  if (std::any_of(d.weights.begin(), d.weights.end(), [](double w) { return !(w >= 0); })) {
    return "a weight must not be below 0";
  }
  return whole_weight(d) > 0 ? std::string() : "the sum of the weights must be above 0";
}

bool finite(const Law& law) {
  struct Numbers {
    bool operator()(const Normal& d) const { return std::isfinite(d.mean) && std::isfinite(d.sd); }
    bool operator()(const Lognormal& d) const { return std::isfinite(d.mean) && std::isfinite(d.sd); }
    bool operator()(const Uniform& d) const { return std::isfinite(d.low) && std::isfinite(d.high); }
    bool operator()(const Gumbel& d) const { return std::isfinite(d.mode) && std::isfinite(d.scale); }
    bool operator()(const Weibull& d) const {
      return std::isfinite(d.shape) && std::isfinite(d.scale) && std::isfinite(d.shift);
    }
    bool operator()(const Triangular& d) const {
      return std::isfinite(d.low) && std::isfinite(d.mode) && std::isfinite(d.high);
    }
    bool operator()(const Listed& d) const {
      const auto all = [](const std::vector<double>& list) {
        return std::all_of(list.begin(), list.end(), [](double x) { return std::isfinite(x); });
      };
      return all(d.values) && all(d.weights);
    }
  };
  return std::visit(Numbers(), law);
}

/// The mean of f(X) over a continuous law: the integral of f(x(z)) phi(z) over the score, cut where the inner law of a
/// triangle has its kink.
template <class F>
double expectation(const Distribution& d, const F& f) {
  const auto under = [&](double z) { return f(value_at_score(d, z)) * normal_density(z); };
  constexpr double far = 12;  // phi(12) = 2e-32
  double kink = 0;
  if (const auto* t = std::get_if<Triangular>(&d.law)) kink = std::clamp(score_of(d, t->mode), -far, far);
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const auto piece = [&](double a, double b) { return a < b ? Rule::integrate(under, a, b, 8, 1e-10) : 0.; };
  return piece(-far, kink) + piece(kink, far);
}

struct MeanAndSd {
  double mean = 0, sd = 1;
};

MeanAndSd uncut_moments(const Law& law) {
  struct Of {
    MeanAndSd operator()(const Normal& d) const { return {.mean = d.mean, .sd = d.sd}; }
    MeanAndSd operator()(const Lognormal& d) const { return {.mean = d.mean, .sd = d.sd}; }
    MeanAndSd operator()(const Uniform& d) const {
      return {.mean = (d.low + d.high) / 2, .sd = (d.high - d.low) / std::sqrt(12.)};
    }
    MeanAndSd operator()(const Gumbel& d) const {
      return {.mean = d.mode + std::numbers::egamma * d.scale, .sd = std::numbers::pi / std::sqrt(6.) * d.scale};
    }
    MeanAndSd operator()(const Weibull& d) const {
      const double g1 = std::tgamma(1 + 1 / d.shape);
      const double g2 = std::tgamma(1 + 2 / d.shape);
      return {.mean = d.shift + d.scale * g1, .sd = d.scale * std::sqrt(std::max(0., g2 - g1 * g1))};
    }
    MeanAndSd operator()(const Triangular& d) const {
      const double left = d.mode - d.low;
      const double right = d.high - d.mode;
      return {.mean = (d.low + d.mode + d.high) / 3,
              .sd = std::sqrt((left * left + left * right + right * right) / 18)};
    }
    MeanAndSd operator()(const Listed& d) const {
      const double whole = whole_weight(d);
      MeanAndSd m{.mean = 0, .sd = 0};
      for (std::size_t i = 0; i < d.values.size(); ++i) m.mean += weight(d, i) / whole * d.values[i];
      for (std::size_t i = 0; i < d.values.size(); ++i) {
        m.sd += weight(d, i) / whole * (d.values[i] - m.mean) * (d.values[i] - m.mean);
      }
      m.sd = std::sqrt(m.sd);
      return m;
    }
  };
  return std::visit(Of(), law);
}

}  // namespace

std::string mistake(const Distribution& d) {
  if (!finite(d.law)) return "a number of the distribution is not finite";
  if (std::string text = std::visit([](const auto& law) { return wrong(law); }, d.law); !text.empty()) return text;
  if (!is_cut(d)) return {};
  if (!continuous(d)) return "a list cannot be truncated: leave its values out";
  const double from = d.from.value_or(-endless);
  const double to = d.to.value_or(endless);
  if (!(from < to)) return fmt::format("truncated from {} to {}: the first must be below the second", from, to);
  if (!(cut_of(d).mass > 0)) return fmt::format("nothing of the distribution lies from {} to {}", from, to);
  return {};
}

const char* law_name(const Law& law) {
  constexpr const char* names[] = {"normal", "lognormal", "uniform", "gumbel", "weibull", "triangular", "list"};
  static_assert(std::size(names) == std::variant_size_v<Law>);
  return names[law.index()];
}

bool continuous(const Distribution& d) { return !std::holds_alternative<Listed>(d.law); }

double below(const Distribution& d, double x) { return chance_of(d, x).below; }

double above(const Distribution& d, double x) { return chance_of(d, x).above; }

double density(const Distribution& d, double x) {
  if (inside_cut(d, x) != x) return 0;
  const double uncut_density = std::visit([&](const auto& law) { return density_of(law, x); }, d.law);
  return is_cut(d) ? uncut_density / cut_of(d).mass : uncut_density;
}

double value_at(const Distribution& d, double p) {
  expects(p >= 0 && p <= 1, "a chance lies from 0 to 1");
  return value_of(d, {.below = p, .above = 1 - p});
}

double value_at_score(const Distribution& d, double z) {
  if (const auto* normal = std::get_if<Normal>(&d.law); normal && !is_cut(d)) return normal->mean + normal->sd * z;
  if (const auto* lognormal = std::get_if<Lognormal>(&d.law); lognormal && !is_cut(d)) {
    const LogLaw l = log_law(*lognormal);
    return std::exp(l.mu + l.sigma * z);
  }
  return value_of(d, chance_of_score(z));
}

double score_of(const Distribution& d, double x) {
  expects(continuous(d), "a value of a list has no score");
  return score_of_chance(chance_of(d, x));
}

double mean(const Distribution& d) {
  if (!is_cut(d)) return uncut_moments(d.law).mean;
  return expectation(d, [](double x) { return x; });
}

double sd(const Distribution& d) {
  if (!is_cut(d)) return uncut_moments(d.law).sd;
  const double middle = mean(d);
  return std::sqrt(expectation(d, [&](double x) { return (x - middle) * (x - middle); }));
}

}  // namespace taut::chance
