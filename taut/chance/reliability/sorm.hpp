#pragma once
#include <optional>

#include "taut/chance/reliability/design_point.hpp"

namespace taut::chance {

/// The shape of the limit at a design point.
struct Curved {
  /// Main curvatures k_i of g = 0, falling; positive where it bends away from the origin of a safe median. n - 1.
  std::vector<double> curvatures;
  /// The unit direction of the least curvature, in scores.
  Point least;
};

/// Curvatures by second differences of g in the plane across the gradient (one batch of n (n - 1) + 1 points),
/// k = eigenvalues of Q^T H Q/|gradient|. Empty where a case failed.
std::optional<Curved> curved(const LimitState& state, const Point& u, const Slope& at, double step);

/// Whether the point is a nearest one of the limit, 1 + beta k_i > 0 for all; else it is a saddle of the distance.
bool nearest(double beta, const Curved& shape);

/// Breitung's probability (1984, equation 4.5): Phi(-beta) prod (1 + beta k_i)^(-1/2) for beta >= 0, 1 - the same of
/// -beta and -k for beta < 0. Asymptotic for a large |beta|; NaN where the point is not nearest.
double breitung(double beta, const Curved& shape);

}  // namespace taut::chance
