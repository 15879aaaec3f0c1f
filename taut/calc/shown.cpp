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

std::pair<std::string, std::string> brief_apart(const Check& c, const Display& display) {
  std::pair text{display.brief(c.value, c.unit), display.brief(c.limit, c.unit)};
  if (text.first != text.second) return text;
  constexpr int more_digits = 5;  // than the brief ones
  const int digits = digits_apart(c, display, more_digits);
  const auto exactly = [&](double x) {
    const std::string unit = display.unit(c.unit), number = short_number(display.from_si(x, c.unit), digits);
    return unit.empty() || !std::isfinite(x) ? number : fmt::format("{} {}", number, unit);
  };
  return {exactly(c.value), exactly(c.limit)};
}

std::pair<std::string, std::string> brief_apart(double one, double other, const Unit& unit, const Display& display) {
  Check c;
  c.value = one;
  c.limit = other;
  c.unit = unit;
  c.passes = one == other;
  if (c.passes) return {display.brief(one, unit), display.brief(other, unit)};
  return brief_apart(c, display);
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
