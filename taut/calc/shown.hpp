#pragma once

namespace taut {

/// Whether `a` is below `b` in the five significant digits that a reader is shown. False when one is NaN.
bool shown_below(double a, double b);

}  // namespace taut
