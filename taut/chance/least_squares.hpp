#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace taut::chance {

/// The weighted residuals r of each point in one batch; a NaN anywhere in a row: the case failed.
using Residuals = std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>& points)>;

struct LeastSquaresOptions {
  double step = 1e-3;  ///< of the differences
  int most_iterations = 100;
};

/// The end of a search for the least |r|^2.
struct LeastSquares {
  bool converged = false;
  std::string reason = {};     ///< why not
  Eigen::VectorXd t = {};      ///< where, 0 to 1
  Eigen::VectorXd r = {};      ///< residuals there
  Eigen::MatrixXd J = {};      ///< dr/dt there
  std::vector<int> held = {};  ///< of each unknown: -1 held at 0, 1 held at 1 by the slope, else 0
};

/// Levenberg-Marquardt in unknowns from 0 to 1, from `start`; see calibrate().
LeastSquares least_squares(const Residuals& residuals, const Eigen::VectorXd& start,
                           const LeastSquaresOptions& options);

}  // namespace taut::chance
