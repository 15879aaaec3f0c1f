#include "taut/chance/least_squares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/math/dense_lu.hpp"

namespace taut::chance {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// On which side of t both neighbours lie: 0 one on each, 1 above (near 0), -1 below (near 1).
double inner_side(double t, double h) { return t < h ? 1 : t > 1 - h ? -1 : 0; }

/// The difference quotient of r at t from its neighbours a, b; a is the nearer one where both lie on one side. One of
/// them is enough where the other failed.
VectorXd quotient(const VectorXd& r, const VectorXd& a, const VectorXd& b, double side, double h) {
  if (side != 0) return b.hasNaN() ? VectorXd(side * (a - r) / h) : VectorXd(side * (4 * a - 3 * r - b) / (2 * h));
  if (a.hasNaN()) return (b - r) / h;
  if (b.hasNaN()) return (r - a) / h;
  return (b - a) / (2 * h);
}

/// dr/dt by central differences; near a bound by three points on the inner side. Empty where too many cases failed.
std::optional<MatrixXd> jacobian(const Residuals& residuals, const VectorXd& t, const VectorXd& r, double h) {
  std::vector<VectorXd> points;
  for (Index i = 0; i < t.size(); ++i) {
    const double side = inner_side(t[i], h);
    for (const double step : {side == 0 ? -h : side * h, side == 0 ? h : 2 * side * h}) {
      points.push_back(t);
      points.back()[i] += step;
    }
  }
  const std::vector<VectorXd> at = residuals(points);
  MatrixXd J(r.size(), t.size());
  for (Index i = 0; i < t.size(); ++i) {
    const auto first = static_cast<std::size_t>(2 * i);
    J.col(i) = quotient(r, at[first], at[first + 1], inner_side(t[i], h), h);
  }
  if (J.hasNaN()) return std::nullopt;
  return J;
}

std::vector<int> held_at_bounds(const VectorXd& t, const VectorXd& slope) {
  std::vector<int> held(static_cast<std::size_t>(t.size()), 0);
  for (Index i = 0; i < t.size(); ++i) {
    if (t[i] <= 0 && slope[i] > 0) held[static_cast<std::size_t>(i)] = -1;
    if (t[i] >= 1 && slope[i] < 0) held[static_cast<std::size_t>(i)] = 1;
  }
  return held;
}

/// The damped step over the unknowns that are not held, cut at the bounds.
VectorXd damped_step(const LeastSquares& at, const VectorXd& slope, const VectorXd& scale, double damping) {
  const Index n = at.t.size();
  MatrixXd A = at.J.transpose() * at.J;
  VectorXd b = -slope;
  A.diagonal() += damping * scale;
  for (Index i = 0; i < n; ++i) {
    if (at.held[static_cast<std::size_t>(i)] == 0) continue;
    A.row(i).setZero();
    A.col(i).setZero();
    A(i, i) = 1;
    b[i] = 0;
  }
  VectorXd to = at.t + DenseLu(A).solve(b);
  for (Index i = 0; i < n; ++i) to[i] = std::clamp(to[i], 0., 1.);
  return to - at.t;
}

}  // namespace

LeastSquares least_squares(const Residuals& residuals, const VectorXd& start, const LeastSquaresOptions& options) {
  constexpr double least_fall = 1e-10;  // of the sum of squares, as a share of it, at the end
  constexpr double least_step = 1e-9;   // of an unknown
  constexpr double most_damping = 1e12;
  LeastSquares at{.t = start};
  at.r = residuals({start}).front();
  if (at.r.hasNaN()) {
    at.reason = "the case at the start failed";
    return at;
  }
  VectorXd scale = VectorXd::Zero(start.size());
  double damping = 1e-3;
  for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
    const auto J = jacobian(residuals, at.t, at.r, options.step);
    if (!J) {
      at.reason = "cases beside the fit failed";
      return at;
    }
    at.J = *J;
    const VectorXd slope = at.J.transpose() * at.r;
    at.held = held_at_bounds(at.t, slope);
    scale = scale.cwiseMax(at.J.colwise().squaredNorm().transpose());
    // an unknown without any effect stays where it is
    const VectorXd damped = scale.unaryExpr([](double x) { return x > 0 ? x : 1.; });
    const double cost = at.r.squaredNorm();
    for (;;) {
      const VectorXd step = damped_step(at, slope, damped, damping);
      const double promised = -(2 * slope.dot(step) + (at.J * step).squaredNorm());
      if (!(promised > least_fall * cost) || step.cwiseAbs().maxCoeff() < least_step || damping > most_damping) {
        at.converged = damping <= most_damping || !(promised > 1e-4 * cost);
        if (!at.converged) at.reason = "no step lowers the residuals (failed cases, or a kink)";
        return at;
      }
      const VectorXd r = residuals({at.t + step}).front();
      const double fall = cost - r.squaredNorm();
      if (fall > 1e-4 * promised) {  // false where a case failed
        at.t += step;
        at.r = r;
        damping = std::max(damping * (fall > 0.5 * promised ? 0.1 : 0.5), 1e-12);
        break;
      }
      damping *= 10;
    }
  }
  at.reason = fmt::format("not converged after {} steps", options.most_iterations);
  return at;
}

}  // namespace taut::chance
