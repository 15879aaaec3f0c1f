#include "taut/calc/shown.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace taut {

bool shown_below(double a, double b) { return a < b && fmt::format("{:.4e}", a) != fmt::format("{:.4e}", b); }

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
