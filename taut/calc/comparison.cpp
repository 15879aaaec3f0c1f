#include "taut/calc/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "taut/calc/shown.hpp"

namespace taut {

const Quantities<Comparison>& comparison_quantities() {
  using Row = Comparison;
  static const Quantities<Row> all = {
      {"quantity", "", si::one, "what is compared, with the equation of the source", &Row::quantity},
      {"symbol", "", si::one, "its letter in the source", &Row::symbol},
      {"unit", "", si::one, "unit of the three numbers: SI, in CSV files the unit of print",
       [](const Row& c) { return std::string(c.unit.symbol); }},
      {"printed", "", si::one, "by the equation as the source prints it", &Row::printed},
      {"corrected", "", si::one, "by the corrected equation", &Row::corrected},
      {"exact", "", si::one, "of the engine, where it solves the same machine", &Row::exact},
      {"build_by", "", si::one, "which of them to build by, and why", &Row::build_by}};
  return all;
}

Table comparison_table(const std::vector<Comparison>& all) {
  return make_table("comparison", "Printed, corrected and exact", comparison_quantities(), all);
}

Table comparison_table(const std::vector<Comparison>& all, const Display& display) {
  std::vector<Comparison> shown = all;
  for (Comparison& c : shown) {
    const ShownUnit unit = shown_unit(c.unit, display);
    if (unit.name.empty()) continue;
    // a factor leaves 0.30000000000000004 of 0.3
    for (double* number : {&c.printed, &c.corrected, &c.exact})
      *number = std::isnan(*number) ? *number : std::stod(fmt::format("{:.12g}", unit.of(*number)));
  }
  Table table = comparison_table(shown);
  const auto at =
      std::find_if(table.columns.begin(), table.columns.end(), [](const Column& c) { return c.name == "unit"; });
  const auto column = static_cast<std::size_t>(at - table.columns.begin());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = display.unit(all[i].unit);
    table.rows[i][column] = name.empty() ? std::string("1") : name;
  }
  return table;
}

}  // namespace taut
