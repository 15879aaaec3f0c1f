#pragma once
#include <vector>

namespace taut::report {

/// 1, 2 or 5 times a power of ten, the largest that is not above `x`. x > 0 and finite.
double nice_below(double x);

/// Round numbers from `low` to `high` (both inside the range or beyond it by less than a step), about `count` of them.
/// low < high, both finite.
std::vector<double> nice_ticks(double low, double high, int count);

/// Decimals that tell neighbouring ticks apart.
int tick_decimals(const std::vector<double>& ticks);

}  // namespace taut::report
