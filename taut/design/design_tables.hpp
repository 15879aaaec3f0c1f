#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/calc/value_kind.hpp"
#include "taut/design/design_search.hpp"

namespace taut::design {

/// "skyline: EN 12385-4|6x36-IWRC|20|1960; mainline: ...".
std::string names_of(const DesignSpace& space, const std::vector<std::size_t>& choice);

/// The table `design_runner_ups`: cheaper choices with what each fails by, the one chosen, the next that pass.
/// `chosen`: empty choice where none passes.
void add_runner_ups(const DesignTask& task, const design::SizingAnswer& answer, const design::SizingCandidate& chosen,
                    Result& r);

/// The table `design_trade_off`: over the grid of the unknowns the least choice, its cost, and what holds it.
void add_trade_off(const DesignTask& task, const std::vector<DesignPoint>& points, Result& r);

/// All of a design that was found: values, and the tables `design`, `design_sections`, `design_active`,
/// `design_runner_ups`, `design_trade_off` before those of the result.
void add_design(const DesignTask& task, const DesignFound& found, Result& r);

/// Those tables and values as described.
std::vector<TableWords> table_words();
const std::vector<ValueKind>& value_kinds();

}  // namespace taut::design
