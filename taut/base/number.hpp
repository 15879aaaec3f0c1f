#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace taut {

/// The decimal number that a text begins with.
struct NumberAtFront {
  double value = 0;        ///< the double nearest to what is written
  std::size_t length = 0;  ///< bytes that the number takes; 0: the text does not begin with a number
  bool in_range = true;    ///< false: too large for a double, or so small that it would be zero
};

/// Reads a sign or none, digits with one decimal point or none, and an exponent or none: "-12.5e3". The language of
/// the system plays no part. Spaces, "inf", "nan", hexadecimal digits and signs between thousands are no number.
NumberAtFront number_at_front(std::string_view text);

/// The number that the whole text is; empty when it is none, or out of range.
std::optional<double> parse_double(std::string_view text);

/// A place, m, as a sentence tells it: so many digits, and to the centimetre from 10 km on, where map coordinates are:
/// "12.3457", "2600030.25".
std::string place_number(double x, int digits = 6);

/// The i-th of `steps` equal steps from one number to another, 0 <= i <= steps: from + (to - from) i/steps, the last
/// exactly `to`, where the formula may miss it by its last digit.
constexpr double step_between(double from, double to, int i, int steps) {
  return i == steps ? to : from + (to - from) * i / steps;
}

}  // namespace taut
