#pragma once
#include "taut/units/expression.hpp"

namespace taut {

/// A value and its first two derivatives by the variable.
struct Jet {
  double value = 0, first = 0, second = 0;
  constexpr Jet() = default;
  constexpr Jet(double v, double v_1, double v_2) : value(v), first(v_1), second(v_2) {}
};

/// The value of a formula where the variable has the value `variable`, SI. Not finite where the text has no value: 1/t
/// at 0.
Jet jet_at(const FormulaText& formula, double variable);

}  // namespace taut
