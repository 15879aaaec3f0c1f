#include "taut/units/any_quantity.hpp"

#include <fmt/format.h>

#include "taut/base/number.hpp"
#include "taut/units/display.hpp"

namespace taut {
namespace {

constexpr Unit celsius = si::K.in("degC");

/// Whether 0 of what the text is written in is not 0 of the kind: of a temperature in degC alone.
bool is_celsius(std::string_view text, const Unit& kind) {
  if (kind.dimension != si::K.dimension) return false;
  const std::size_t sign = text.substr(0, 1) == "+" ? 1 : 0;
  std::string_view unit = text.substr(sign + number_at_front(text.substr(sign)).length);
  while (!unit.empty() && (unit.front() == ' ' || unit.front() == '\t')) unit.remove_prefix(1);
  while (!unit.empty() && (unit.back() == ' ' || unit.back() == '\t')) unit.remove_suffix(1);
  return !unit_factor(unit, kind);
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
  auto x = parse_quantity(text, unit);
  if (x && is_celsius(text, unit)) *x -= zero_celsius;
  return x;
}

bool counts_from_zero_celsius(const Unit& unit) {
  return unit.dimension == si::K.dimension && unit.shown == celsius.shown;
}

tl::expected<AnyQuantity, UnitError> parse_any_quantity(std::string_view text) {
  const auto plain = parse_quantity(text, si::one);
  if (plain) return AnyQuantity{.value = *plain, .unit = si::one};
  for (const Unit& unit : display_kinds()) {
    const auto value = parse_quantity(text, unit);
    if (value) return AnyQuantity{.value = *value, .unit = is_celsius(text, unit) ? celsius : unit};
  }
  // not a number or not a unit: the same reason whatever is asked for
  if (plain.error().message.find("a plain number is expected here") == std::string::npos) {
    return tl::unexpected(plain.error());
  }
  return tl::unexpected(UnitError{.message = fmt::format("'{}' measures nothing that is known here", text),
                                  .offset = 0,
                                  .width = static_cast<int>(text.size())});
}

}  // namespace taut
