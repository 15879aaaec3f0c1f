#include "taut/app/explain/described.hpp"

#include <fmt/format.h>

#include "taut/app/compare.hpp"
#include "taut/app/design/design_space.hpp"
#include "taut/app/methods.hpp"
#include "taut/calc/comparison.hpp"
#include "taut/checks/described.hpp"
#include "taut/design/design_tables.hpp"
#include "taut/results/described.hpp"

namespace taut::app {
namespace {

std::vector<TableWords> tables_of_design() {
  std::vector<TableWords> all = design::table_words();
  all.push_back(cases_words());
  return all;
}

}  // namespace

std::vector<TableGroup> table_groups() {
  std::vector<TableGroup> all = {{.title = "Tables of checks",
                                  .words = "Of a machine or a method with `checks:`.",
                                  .tables = checks::table_words()},
                                 {.title = "Tables of a design",
                                  .words = "Of a machine or a method with `design:`.",
                                  .tables = tables_of_design()},
                                 {.title = "Tables of the methods",
                                  .words = "Of every method whose paper is corrected or solved by the engine too.",
                                  .tables = {{.name = "comparison",
                                              .rows = "every quantity that is printed and corrected, or exact",
                                              .columns = words_of(comparison_quantities())}}}};
  for (const MethodEntry& method : methods()) {
    const std::string& name = method.about->name;
    all.push_back({.title = fmt::format("Tables of `method: {}`", name),
                   .words = fmt::format("Besides its values, which stand with the keys of `{}` above.", name),
                   .tables = method.tables});
  }
  all.push_back({.title = "Table of `taut compare`",
                 .words = "Of a set of decks beside published values.",
                 .tables = {compared_words()}});
  return all;
}

std::vector<ValueGroup> value_groups() {
  return {{.title = "Values of a machine", .values = results::value_kinds()},
          {.title = "Values of the verdict and of checks", .values = checks::value_kinds()},
          {.title = "Values of a design", .values = design::value_kinds()}};
}

}  // namespace taut::app
