#include "taut/chance/reliability/limit_state.hpp"

#include <cmath>

#include "taut/base/expects.hpp"

namespace taut::chance {

std::vector<double> LimitState::margins(const Points& scores) const {
  Points values;
  values.reserve(scores.size());
  for (const Point& u : scores) values.push_back(values_at_scores(inputs_, u));
  const auto rows = evaluate_(values);
  expects(rows.size() == scores.size(), "the model gives a row for each point");
  evaluations_ += rows.size();
  std::vector<double> g;
  g.reserve(rows.size());
  for (const auto& row : rows) {
    expects(output_ < row.size(), "the limited output is one of the model's");
    g.push_back(margin(limit_, row[output_]));
  }
  return g;
}

Slope slope(const LimitState& state, const Point& u, double step) {
  Points points{u};
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (const double h : {-step, step}) {
      points.push_back(u);
      points.back()[i] += h;
    }
  }
  const std::vector<double> g = state.margins(points);
  Slope s{.margin = g[0], .gradient = std::vector<double>(u.size())};
  double squares = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double below = g[1 + 2 * i];
    const double above = g[2 + 2 * i];
    double& d = s.gradient[i];
    d = (above - below) / (2 * step);
    if (std::isnan(below)) d = (above - g[0]) / step;
    if (std::isnan(above)) d = (g[0] - below) / step;
    squares += d * d;
  }
  s.steepness = std::sqrt(squares);
  return s;
}

double noise(const LimitState& state, const Point& u) {
  constexpr std::size_t count = 7;
  constexpr double apart = 1e-3;
  Points points(count, u);
  const double along = apart / std::sqrt(static_cast<double>(u.size()));
  for (std::size_t k = 0; k < count; ++k) {
    for (double& x : points[k]) x += (static_cast<double>(k) - 3) * along;
  }
  std::vector<double> table = state.margins(points);
  // the variance of a k-th difference is (2k)!/(k!)^2 that of one value
  double binomial = 1;
  double variance = 0;
  for (std::size_t k = 1; k < count; ++k) {
    double squares = 0;
    for (std::size_t i = 0; i + k < count; ++i) {
      table[i] = table[i + 1] - table[i];
      squares += table[i] * table[i];
    }
    binomial *= 2. * (2. * static_cast<double>(k) - 1) / static_cast<double>(k);
    if (k >= 4) variance += squares / static_cast<double>(count - k) / binomial / 3;
  }
  return std::isnan(variance) ? 0 : std::sqrt(variance);
}

}  // namespace taut::chance
