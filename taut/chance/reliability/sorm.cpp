#include "taut/chance/reliability/sorm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/chance/standard_laws.hpp"
#include "taut/math/eigen_symmetric.hpp"

namespace taut::chance {
namespace {

/// Columns 1 .. n-1 of the Householder reflection that turns e_0 into the gradient: a basis across it.
Eigen::MatrixXd across(const std::vector<double>& gradient) {
  const auto n = static_cast<Eigen::Index>(gradient.size());
  Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(gradient.data(), n);
  v /= v.norm();
  v[0] += v[0] < 0 ? -1 : 1;
  const Eigen::MatrixXd reflection = Eigen::MatrixXd::Identity(n, n) - 2 / v.squaredNorm() * v * v.transpose();
  return reflection.rightCols(n - 1);
}

Point vector_of(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace

std::optional<Curved> curved(const LimitState& state, const Point& u, const Slope& at, double step) {
  const Eigen::MatrixXd Q = across(at.gradient);
  const Eigen::Index m = Q.cols();
  if (m == 0) return Curved{};
  const Eigen::VectorXd centre = Eigen::Map<const Eigen::VectorXd>(u.data(), m + 1);
  Points points{u};
  // on the diagonal along q_i, beside it along q_i + q_j
  const auto both_sides = [&](const Eigen::VectorXd& along) {
    points.push_back(vector_of(centre + step * along));
    points.push_back(vector_of(centre - step * along));
  };
  for (Eigen::Index i = 0; i < m; ++i) {
    both_sides(Q.col(i));
    for (Eigen::Index j = 0; j < i; ++j) both_sides(Q.col(i) + Q.col(j));
  }
  const std::vector<double> g = state.margins(points);
  if (std::any_of(g.begin(), g.end(), [](double x) { return std::isnan(x); })) return std::nullopt;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(m, m);
  std::size_t k = 1;
  const auto second = [&] {
    const double difference = g[k] - 2 * g[0] + g[k + 1];
    k += 2;
    return difference / (step * step);
  };
  for (Eigen::Index i = 0; i < m; ++i) {
    H(i, i) = second();
    for (Eigen::Index j = 0; j < i; ++j) H(i, j) = second();
  }
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) H(i, j) = (H(i, j) - H(i, i) - H(j, j)) / 2;
  }
  const SymmetricEigen eigen = symmetric_eigen(H / at.steepness);
  Curved shape{.curvatures = vector_of(eigen.values), .least = vector_of(Q * eigen.vectors.col(0))};
  std::reverse(shape.curvatures.begin(), shape.curvatures.end());
  return shape;
}

bool nearest(double beta, const Curved& shape) {
  return std::all_of(shape.curvatures.begin(), shape.curvatures.end(), [&](double k) { return 1 + beta * k > 0; });
}

double breitung(double beta, const Curved& shape) {
  if (!nearest(beta, shape)) return std::numeric_limits<double>::quiet_NaN();
  double product = 1;
  for (const double k : shape.curvatures) product *= 1 + beta * k;
  const double tail = normal_above(std::abs(beta)) / std::sqrt(product);
  return beta < 0 ? 1 - tail : std::min(tail, 1.);
}

}  // namespace taut::chance
