#pragma once
#include <string_view>
#include <tl/expected.hpp>

#include "taut/units/parse.hpp"

namespace taut {

inline constexpr double zero_celsius = 273.15;  ///< K

/// A quantity whose kind nobody said before.
struct AnyQuantity {
  double value = 0;  ///< SI
  Unit unit;
};

/// `number` with any unit of the allow-list, or a plain number: what it is follows from its unit. Force times length is
/// taken for a moment, a percentage for a plain number shown in %; the unit of a temperature in degC is `K` shown in
/// degC, that of a frequency in Hz `Hz`, with the cycles per second, that of a speed of turning `rad/s`. Errors as
/// those of `parse_quantity`, and units that together measure nothing that taut knows.
tl::expected<AnyQuantity, UnitError> parse_any_quantity(std::string_view text);

/// Whether its values are temperatures in degC, no differences of them.
bool counts_from_zero_celsius(const Unit& unit);

/// Whether its values are written in %: where an angle is asked for such a text is a slope, and its number alone is
/// not.
bool is_percentage(const Unit& unit);

/// Whether it is the unit of a speed of turning, written in Hz, deg/s or rad/s; what is in 1/s alone may be anything.
bool is_turning(const Unit& unit);

/// Whether a unit is that of a temperature, a reading: in K or degC, no difference of two.
bool is_temperature(const Unit& unit);

/// The unit of a difference of two values, of their deviation or error: of temperatures K, also where `display:` shows
/// them in degC, whose zero is none of a difference.
Unit difference_of(const Unit& unit);

/// As `parse_quantity`, a difference of two values: "1 degC" is 1 K there.
tl::expected<double, UnitError> parse_difference(std::string_view text, const Unit& unit);

/// Whether a value in one of them is a value in the other: the same dimension, both angles or neither.
bool same_kind(const Unit& a, const Unit& b);

}  // namespace taut
