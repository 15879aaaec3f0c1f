#include "taut/base/number.hpp"

#include <fmt/format.h>
#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale is of POSIX
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): strtod_l is of the C library

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace taut {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t end_of_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// Where the number at the front ends, and where its exponent begins (there, too, when it has none).
struct Ends {
  std::size_t mantissa = 0;
  std::size_t number = 0;
};

Ends ends_of(std::string_view text) {
  const std::size_t first = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  std::size_t end = end_of_digits(text, first);
  std::size_t digits = end - first;
  if (end < text.size() && text[end] == '.') {
    const std::size_t fraction = end_of_digits(text, end + 1);
    digits += fraction - end - 1;
    if (digits > 0) end = fraction;
  }
  if (digits == 0) return {};
  Ends ends{.mantissa = end, .number = end};
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t power = end + (sign ? 2 : 1);
    const std::size_t after = end_of_digits(text, power);
    if (after > power) ends.number = after;
  }
  return ends;
}

/// The nearest double to a text that is a number. std::from_chars would do, but libc++ has none for doubles before 20,
/// and strtod follows the language of the system.
double nearest_double(std::string_view number) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  std::array<char, 64> near{};
  if (number.size() < near.size()) {
    std::copy(number.begin(), number.end(), near.begin());
    return strtod_l(near.data(), nullptr, plain);
  }
  return strtod_l(std::string(number).c_str(), nullptr, plain);
}

}  // namespace

NumberAtFront number_at_front(std::string_view text) {
  const Ends ends = ends_of(text);
  if (ends.number == 0) return {};
  const double value = nearest_double(text.substr(0, ends.number));
  const bool is_zero = std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(ends.mantissa),
                                   [](char c) { return !is_digit(c) || c == '0'; });
  return {.value = value, .length = ends.number, .in_range = std::isfinite(value) && (value != 0 || is_zero)};
}

std::optional<double> parse_double(std::string_view text) {
  const NumberAtFront front = number_at_front(text);
  if (text.empty() || front.length != text.size() || !front.in_range) return std::nullopt;
  return front.value;
}

std::string place_number(double x, int digits) {
  constexpr double far = 1e4, centimetres = 100;  // m; in a metre
  if (!(std::abs(x) >= far)) return fmt::format("{:.{}g}", x, digits);
  return fmt::format("{:.10g}", std::round(x * centimetres) / centimetres);
}

}  // namespace taut
