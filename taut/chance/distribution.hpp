#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace taut::chance {

/// phi((x - mean)/sd)/sd. sd > 0.
struct Normal {
  double mean = 0, sd = 1;
};

/// ln X is normal. Mean and sd are those of X itself, both > 0: sigma^2 = ln(1 + (sd/mean)^2), mu = ln mean -
/// sigma^2/2.
struct Lognormal {
  double mean = 1, sd = 1;
};

/// 1/(high - low) from low to high, low < high.
struct Uniform {
  double low = 0, high = 1;
};

/// Largest values: F(x) = exp(-exp(-(x - mode)/scale)); scale > 0. Mean mode + 0.5772 scale, sd 1.2825 scale.
struct Gumbel {
  double mode = 0, scale = 1;
};

/// P(X > x) = exp(-((x - shift)/scale)^shape) for x >= shift; shape, scale > 0.
struct Weibull {
  double shape = 1, scale = 1, shift = 0;
};

/// A density that rises from low to mode and falls to high; low <= mode <= high, low < high.
struct Triangular {
  double low = 0, mode = 0.5, high = 1;
};

/// Single values with their weights (>= 0, of any sum > 0); no weights: all alike.
struct Listed {
  std::vector<double> values = {}, weights = {};
};

using Law = std::variant<Normal, Lognormal, Uniform, Gumbel, Weibull, Triangular, Listed>;

/// The law of one input, SI. With `from` or `to` it is cut there and divided by what is left:
/// F_t(x) = (F(x) - F(from))/(F(to) - F(from)). A list cannot be cut.
struct Distribution {
  Law law;
  std::optional<double> from = {}, to = {};
};

/// What is wrong with the numbers of a distribution, for the user's eyes ("sd must be above 0"); empty: nothing. All
/// functions below expect a distribution without a mistake.
std::string mistake(const Distribution& d);

/// The word of a deck: "normal", "lognormal", ... "list".
const char* law_name(const Law& law);

/// False for a list: it has no density and no score of a value.
bool continuous(const Distribution& d);

/// P(X <= x) and P(X > x); each accurate in its own small tail.
double below(const Distribution& d, double x);
double above(const Distribution& d, double x);

/// The derivative of `below`, per unit of x; of a continuous distribution.
double density(const Distribution& d, double x);

/// x with below(d, x) = p, 0 <= p <= 1; of a list the least value with below >= p.
double value_at(const Distribution& d, double p);

/// x with below(d, x) = Phi(z), accurate in both tails (|z| up to 37): X = value_at_score(d, Z) with Z standard normal
/// has the law d.
double value_at_score(const Distribution& d, double z);

/// The inverse: the score of a value; -inf below and +inf above all values. Of a continuous distribution.
double score_of(const Distribution& d, double x);

/// Mean and standard deviation; of a cut law by quadrature over the score (relative error below 1e-8).
double mean(const Distribution& d);
double sd(const Distribution& d);

}  // namespace taut::chance
