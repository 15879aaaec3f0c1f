#include "taut/calc/comparison.hpp"

namespace taut {

const Quantities<Comparison>& comparison_quantities() {
  using Row = Comparison;
  static const Quantities<Row> all = {
      {"quantity", "", si::one, "what is compared, with the equation of the source", &Row::quantity},
      {"symbol", "", si::one, "its letter in the source", &Row::symbol},
      {"unit", "", si::one, "SI unit of the three numbers", [](const Row& c) { return std::string(c.unit.symbol); }},
      {"printed", "", si::one, "by the equation as the source prints it", &Row::printed},
      {"corrected", "", si::one, "by the corrected equation", &Row::corrected},
      {"exact", "", si::one, "of the engine, where it solves the same machine", &Row::exact},
      {"build_by", "", si::one, "which of them to build by, and why", &Row::build_by}};
  return all;
}

Table comparison_table(const std::vector<Comparison>& all) {
  return make_table("comparison", "Printed, corrected and exact", comparison_quantities(), all);
}

}  // namespace taut
