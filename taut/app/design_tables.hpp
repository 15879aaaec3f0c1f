#pragma once
#include <string>
#include <vector>

#include "taut/analysis/sizing.hpp"
#include "taut/app/design.hpp"

namespace taut::app {

/// The answer where the unknowns have these values.
struct DesignPoint {
  std::vector<double> values;
  analysis::SizingAnswer answer;
};

/// "skyline: EN 12385-4|6x36-IWRC|20|1960; mainline: ...".
std::string names_of(const DesignSpace& space, const std::vector<std::size_t>& choice);

/// The table `design_runner_ups`: cheaper choices with what each fails by, the one chosen, the next that pass.
void add_runner_ups(const MachineDeck& deck, const DesignSpace& space, const analysis::SizingAnswer& answer, Result& r);

/// The table `design_trade_off`: over the values of the unknowns the least choice, its cost, and what holds it.
void add_trade_off(const MachineDeck& deck, const DesignSpace& space, const std::vector<DesignPoint>& points,
                   Result& r);

/// All of a design that was found: values, and the tables `design`, `design_active`, `design_runner_ups`,
/// `design_trade_off` before those of the machine.
void add_design(const MachineDeck& deck, const DesignSpace& space, const std::vector<DesignPoint>& points,
                const DesignPoint& best, Result& r);

}  // namespace taut::app
