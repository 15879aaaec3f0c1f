#pragma once
#include <vector>

#include "taut/units/names.hpp"

namespace taut {

/// One factor of a unit expression: a name of the list with its exponent.
struct UnitPower {
  const NameRow* row = nullptr;
  int exponent = 1;
};

/// How much one of a product of units is in the coherent SI unit: the double nearest to the exact value, so that
/// `1 cm^-3` is 1e6 and `1 kgf/mm2` 9806650, to the last bit. Zeros (degC) play no part.
double factor_of(const std::vector<UnitPower>& product);

}  // namespace taut
