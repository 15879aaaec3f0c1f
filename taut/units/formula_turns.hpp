#pragma once
#include "taut/base/array.hpp"
#include "taut/units/expression.hpp"

namespace taut {

/// Where a formula turns. `kink`: it or its slope may jump there; else it may have an extreme.
struct Turn {
  double at = 0;
  bool kink = false;
};

/// The turns of a formula between `from` and `to`, increasing: between two of them it is smooth, and only rises, only
/// falls or stays. None is missing, however narrow: the interval is halved until bounds of the formula and its slope
/// over each part (interval arithmetic) leave none there. A kink is exact but for rounding, an extreme to 1e-9. Beyond
/// 1e5 parts at once the ends of those that are left stand for the turns in them. A place is the same whatever `from`
/// and `to` are.
Array<Turn> turns(const FormulaText& formula, double from, double to);

}  // namespace taut
