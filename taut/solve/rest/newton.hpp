#pragma once
#include <optional>

#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// How an iteration ended.
struct Iteration {
  bool converged = false;
  int steps = 0;
  std::optional<mechanics::NoBranch> stopped;  ///< the branch that had no solution at the last point tried
  bool singular = false;                       ///< something is not held: a step without end
  std::optional<int> deep;          ///< the branch that the last step tried would have made a deep loop (fed_rope.hpp)
  std::optional<int> undetermined;  ///< a branch whose force could be another as well, found by newton_with_forces
};

/// Damped Newton with the natural monotonicity test: a step is accepted when the next one, by the old derivatives,
/// would be shorter. It does not depend on how equations are scaled: Deuflhard, Newton Methods for Nonlinear Problems
/// (2004), sec. 3.3. `tolerance`: as in EquilibriumOptions. On return c and e are the last accepted point. No step
/// passes the place where a fed rope becomes a deep loop; the start is no such place.
Iteration newton(const mechanics::System& system, mechanics::Configuration& c, mechanics::Evaluation& e,
                 double tolerance, int most_steps);

/// The same of a machine among whose unknowns are forces, from near its answer. Where every row is closed the step that
/// is left says how well these forces are known: it goes on until that is within `tolerance` of the largest force, or
/// gets no shorter, and has not converged where more than 1e-7 stays.
Iteration newton_with_forces(const mechanics::System& system, mechanics::Configuration& c, mechanics::Evaluation& e,
                             double tolerance, int most_steps);

/// The overdamped fall of the bodies to a stable equilibrium, by implicit steps that grow as the forces settle
/// (pseudo-transient continuation: Kelley, Keyes, SIAM J. Numer. Anal. 35 (1998) 508): from a start where ropes are
/// slack or far from their places. It ends within 1e-4 of equilibrium, for `newton` to finish. `most_growth`: of the
/// worst force in one step; infinite is quick where bodies fall into slack ropes, a small one careful. `ropes`: how
/// much of the drag between bodies holds back a rope over its contacts and where it is fed in; little, and tensions
/// even out before bodies move far.
Iteration relax(const mechanics::System& system, mechanics::Configuration& c, mechanics::Evaluation& e, int most_steps,
                double most_growth, double ropes);

}  // namespace taut::solve
