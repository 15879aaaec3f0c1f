#include "taut/chance/correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "taut/base/expects.hpp"
#include "taut/math/eigen_symmetric.hpp"

namespace taut::chance {
namespace {

constexpr double least_definite = 1e-10;

std::string pair_name(const CorrelatedPair& p, std::span<const std::string> names) {
  return fmt::format("'{}' and '{}' (r = {})", names[p.first], names[p.second], p.r);
}

std::string wrong_pair(std::span<const CorrelatedPair> pairs, std::span<const std::string> names) {
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (const CorrelatedPair& p : pairs) {
    expects(p.first < names.size() && p.second < names.size(), "a correlated pair names two of the inputs");
    if (p.first == p.second) return fmt::format("'{}' is correlated with itself: name two inputs", names[p.first]);
    if (!(std::abs(p.r) < 1)) {
      return fmt::format("the correlation of {} must lie between -1 and 1", pair_name(p, names));
    }
    if (!seen.insert(std::minmax(p.first, p.second)).second) {
      return fmt::format("the correlation of {} is given twice", pair_name(p, names));
    }
  }
  return {};
}

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// The pairs that pull the least eigenvalue down: v^T R v is the sum of v_i^2 and of 2 r v_i v_j, so those with a
/// negative term, the strongest first, as long as they are a tenth of it.
std::string indefinite(std::span<const CorrelatedPair> pairs, std::span<const std::string> names,
                       const SymmetricEigen& eigen) {
  const Eigen::VectorXd v = eigen.vectors.col(0);
  std::vector<std::pair<double, std::size_t>> terms;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double term = pairs[k].r * v[at(pairs[k].first)] * v[at(pairs[k].second)];
    if (term < 0) terms.emplace_back(term, k);
  }
  std::sort(terms.begin(), terms.end());
  std::string list;
  for (const auto& [term, k] : terms) {
    if (term > 0.1 * terms.front().first) break;
    list += (list.empty() ? "" : ", ") + pair_name(pairs[k], names);
  }
  // R + (s - 1)(R - I) has the least eigenvalue 1 - s (1 - eigenvalue)
  return fmt::format(
      "these correlations contradict each other: {}; the matrix is not positive definite (least eigenvalue {:.3g}). "
      "Multiply them by less than {:.3f}, or change one",
      list, eigen.values[0], 1 / (1 - std::min(eigen.values[0], 0.)));
}

}  // namespace

tl::expected<Correlation, std::string> correlation(std::span<const CorrelatedPair> pairs,
                                                   std::span<const std::string> names) {
  if (std::string text = wrong_pair(pairs, names); !text.empty()) return tl::unexpected(text);
  if (std::all_of(pairs.begin(), pairs.end(), [](const CorrelatedPair& p) { return p.r == 0; })) return Correlation{};
  const std::size_t n = names.size();
  Eigen::MatrixXd R = Eigen::MatrixXd::Identity(at(n), at(n));
  for (const CorrelatedPair& p : pairs) R(at(p.first), at(p.second)) = R(at(p.second), at(p.first)) = p.r;
  const SymmetricEigen eigen = symmetric_eigen(R);
  if (!(eigen.values[0] > least_definite)) return tl::unexpected(indefinite(pairs, names, eigen));

  Correlation c{.inputs = n, .lower = std::vector<double>(n * n, 0)};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = R(at(i), at(j));
      for (std::size_t k = 0; k < j; ++k) rest -= c.lower[i * n + k] * c.lower[j * n + k];
      c.lower[i * n + j] = i == j ? std::sqrt(rest) : rest / c.lower[j * n + j];
    }
  }
  return c;
}

bool independent(const Correlation& c) { return c.inputs == 0; }

std::vector<double> correlated(const Correlation& c, std::vector<double> u) {
  if (independent(c)) return u;
  const std::size_t n = c.inputs;
  expects(u.size() == n, "one number for each correlated input");
  for (std::size_t i = n; i-- > 0;) {
    double sum = 0;
    for (std::size_t k = 0; k <= i; ++k) sum += c.lower[i * n + k] * u[k];
    u[i] = sum;
  }
  return u;
}

std::vector<double> uncorrelated(const Correlation& c, std::vector<double> z) {
  if (independent(c)) return z;
  const std::size_t n = c.inputs;
  expects(z.size() == n, "one score for each correlated input");
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) z[i] -= c.lower[i * n + k] * z[k];
    z[i] /= c.lower[i * n + i];
  }
  return z;
}

std::vector<double> gradient_by_scores(const Correlation& c, std::vector<double> v) {
  if (independent(c)) return v;
  const std::size_t n = c.inputs;
  expects(v.size() == n, "one slope for each correlated input");
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) v[i] -= c.lower[k * n + i] * v[k];
    v[i] /= c.lower[i * n + i];
  }
  return v;
}

}  // namespace taut::chance
