#include "taut/calc/shown.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace taut {

bool shown_below(double a, double b) { return a < b && fmt::format("{:.4e}", a) != fmt::format("{:.4e}", b); }

int digits_apart(const Check& c, const Display& display, int least) {
  if (c.passes || !std::isfinite(c.value) || !std::isfinite(c.limit)) return least;
  const double value = display.from_si(c.value, c.unit), limit = display.from_si(c.limit, c.unit);
  int digits = least;
  while (digits < std::numeric_limits<double>::max_digits10 &&
         short_number(value, digits) == short_number(limit, digits))
    ++digits;
  return digits;
}

Display display_of(const Result& r) {
  std::map<std::string, std::string> units;
  for (const auto& [kind, unit] : r.display) {
    if (check_display(kind, unit)) units.emplace(kind, unit);
  }
  return Display(std::move(units));
}

ShownUnit shown_unit(const Unit& unit, const Display& display) {
  return {.display = display, .unit = unit, .name = display.unit(unit)};
}

}  // namespace taut
