#pragma once
#include <string>

#include "taut/chance/reliability/limit_state.hpp"

namespace taut::chance {

/// A search for a point of the limit g = 0 that is nearest to the origin of the scores, with the constants of both
/// ways.
struct SearchOptions {
  double step = 0.01;       ///< of the differences, in scores; see form() for how it follows the noise
  double distance = 1e-4;   ///< |g|/|gradient| at the end, in scores
  double direction = 2e-3;  ///< part of u across the gradient at the end, as a share of max(1, |u|)
  double farthest = 10;     ///< |u| beyond which nothing is sought: a chance below 1e-23
  int most_iterations = 60;
};

/// What a search ends with.
struct Reached {
  bool converged = false;
  std::string reason = {};  ///< why not, for the user's eyes
  Point u = {};             ///< the last point
  Slope at = {};            ///< g and gradient there
};

/// The improved HL-RF iteration (Hasofer & Lind 1974, Rackwitz & Fiessler 1978; Zhang & Der Kiureghian 1995): the next
/// point lies on the line to  (grad.u - g)/|grad|^2 grad,  as far as |u|^2/2 + c |g| falls by Armijo's rule with
/// c = 2 max(|u|/|grad|, |u_next|^2/(2 |g|)); the halved steps are evaluated four at a time. Failed cases are no step.
Reached improved_hlrf(const LimitState& state, const Point& start, const SearchOptions& options);

/// The same point by sequential quadratic programming: least |u|^2/2 with g = 0 (SLSQP, Kraft 1988, as in NLopt),
/// judged by the same rule. A failed case ends it.
Reached slsqp(const LimitState& state, const Point& start, const SearchOptions& options);

}  // namespace taut::chance
