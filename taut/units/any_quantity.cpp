#include "taut/units/any_quantity.hpp"

#include <fmt/format.h>

#include "taut/units/display.hpp"

namespace taut {

bool same_kind(const Unit& a, const Unit& b) { return a.dimension == b.dimension && a.is_angle == b.is_angle; }

tl::expected<AnyQuantity, UnitError> parse_any_quantity(std::string_view text) {
  const auto plain = parse_quantity(text, si::one);
  if (plain) return AnyQuantity{.value = *plain, .unit = si::one};
  for (const Unit& unit : display_kinds()) {
    const auto value = parse_quantity(text, unit);
    if (value) return AnyQuantity{.value = *value, .unit = unit};
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
