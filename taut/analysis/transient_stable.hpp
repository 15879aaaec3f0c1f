#pragma once
#include "taut/analysis/transient_run.hpp"

namespace taut::analysis::dynamics {

/// Verlet's step where none is given, as a share of the stability limit.
constexpr double verlet_share = 0.8;

/// The step, shortened so that the lines written down are a whole number of steps apart, s: one shorter step at each of
/// them, again and again, would excite the fastest vibrations though every step is below the stability limit.
double equal_step(const TransientOptions& options, double step);

/// Verlet's step now, s: the fixed one of the options (any other method's too), shorter where branches have become so
/// short that it would not be stable any more.
double stable_step(const Run& run);

}  // namespace taut::analysis::dynamics
