#pragma once
#include <string_view>
#include <tl/expected.hpp>

#include "taut/units/parse.hpp"

namespace taut {

/// A quantity whose kind nobody said before.
struct AnyQuantity {
  double value = 0;  ///< SI
  Unit unit;
};

/// `number` with any unit of the allow-list, or a plain number: what it is follows from its unit. Force times length is
/// taken for a moment, a percentage for a plain number. Errors as those of `parse_quantity`, and units that together
/// measure nothing that taut knows.
tl::expected<AnyQuantity, UnitError> parse_any_quantity(std::string_view text);

/// Whether a value in one of them is a value in the other: the same dimension, both angles or neither.
bool same_kind(const Unit& a, const Unit& b);

}  // namespace taut
