#include "taut/units/any_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "taut/base/number.hpp"
#include "taut/units/display.hpp"

namespace taut {
namespace {

constexpr Unit celsius = si::K.in("degC"), percent = si::one.in("%");

/// A frequency or speed of turning by the unit that it is written in, so that it can be written down again.
constexpr Unit frequency_in(std::string_view unit) {
  Unit copy = si::per_s.in(unit);
  copy.symbol = unit;
  return copy;
}
constexpr Unit hertz = frequency_in("Hz"), turning = frequency_in("rad/s");

/// What stands behind the number.
std::string_view unit_in(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const std::size_t sign = text.substr(0, 1) == "+" ? 1 : 0;
  std::string_view unit = text.substr(sign + number_at_front(text.substr(sign)).length);
  while (!unit.empty() && (unit.front() == ' ' || unit.front() == '\t')) unit.remove_prefix(1);
  while (!unit.empty() && (unit.back() == ' ' || unit.back() == '\t')) unit.remove_suffix(1);
  return unit;
}

/// Whether 0 of what the text is written in is not 0 of the kind: of a temperature in degC alone.
bool is_celsius(std::string_view text, const Unit& kind) {
  return kind.dimension == si::K.dimension && !unit_factor(unit_in(text), kind);
}

/// The unit of a text that measures something of that kind.
Unit unit_of(std::string_view text, const Unit& kind) {
  if (is_celsius(text, kind)) return celsius;
  if (kind.dimension != si::per_s.dimension) return kind;
  const std::string_view unit = unit_in(text);
  // a turn of 2 pi rad is one cycle; 1/s counts as it is for both
  if (*unit_factor(unit, turning) == *unit_factor(unit, hertz)) return kind;
  return unit.find("Hz") != std::string_view::npos ? hertz : turning;
}

}  // namespace

bool same_kind(const Unit& a, const Unit& b) { return a.dimension == b.dimension && a.is_angle == b.is_angle; }

bool is_temperature(const Unit& unit) { return unit.dimension == si::K.dimension && unit.kind == si::K.kind; }

Unit difference_of(const Unit& unit) {
  if (!is_temperature(unit)) return unit;
  // with a kind of its own, that no `display:` names
  return {.dimension = unit.dimension,
          .symbol = "K",
          .shown = "K",
          .is_angle = false,
          .kind = "difference of temperatures"};
}

tl::expected<double, UnitError> parse_difference(std::string_view text, const Unit& unit) {
  const std::string plain = with_plain_signs(text);
  text = plain;
  auto x = parse_quantity(text, unit);
  if (x && is_celsius(text, unit)) *x -= zero_celsius;
  return x;
}

bool is_percentage(const Unit& unit) { return !unit.needs_text() && unit.shown == percent.shown; }

bool is_turning(const Unit& unit) {
  return unit.dimension == si::per_s.dimension && (counts_cycles(unit) || unit.shown == turning.shown);
}

bool counts_from_zero_celsius(const Unit& unit) {
  return unit.dimension == si::K.dimension && unit.shown == celsius.shown;
}

tl::expected<AnyQuantity, UnitError> parse_any_quantity(std::string_view text) {
  const std::string plain = with_plain_signs(text);
  text = plain;
  const auto number = parse_quantity(text, si::one);
  if (number) return AnyQuantity{.value = *number, .unit = unit_in(text) == percent.shown ? percent : si::one};
  for (const Unit& unit : display_kinds()) {
    if (!parse_quantity(text, unit)) continue;
    const Unit own = unit_of(text, unit);
    return AnyQuantity{.value = *parse_quantity(text, own), .unit = own};
  }
  // not a number or not a unit: the same reason whatever is asked for
  if (number.error().message.find("a plain number is expected here") == std::string::npos) {
    return tl::unexpected(number.error());
  }
  return tl::unexpected(UnitError{.message = fmt::format("'{}' measures nothing that is known here", text),
                                  .offset = 0,
                                  .width = static_cast<int>(text.size())});
}

}  // namespace taut
