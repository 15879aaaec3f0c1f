#include <fmt/format.h>

#include <cmath>
#include <set>

#include "taut/results/machine_tables.hpp"
#include "taut/solve/quantities.hpp"

namespace taut::results {
namespace {

/// Above, friction on a wet, oily or sap-covered rope is doubtful (mine hoists 0.20 to 0.25, ropeways 0.22 to 0.30).
constexpr double doubtful_friction = 0.4;

template <class Row, class Part>
std::vector<Row> rows_of(const study::EquilibriumRun& one, const Array<Part>& parts) {
  std::vector<Row> rows;
  for (const Part& part : parts) rows.push_back({one.model, one.result, part});
  return rows;
}

}  // namespace

void add_drive_tables(const study::EquilibriumRun& one, const std::function<void(Table)>& add) {
  if (!one.result.rope_loads.empty()) {
    add(make_table("rope_loads", "Forces along the ropes (on one copy; F is positive along the path)",
                   solve::rope_load_quantities(), rows_of<solve::RopeLoadRow>(one, one.result.rope_loads)));
  }
  if (!one.model.motors.empty()) {
    const auto drives = solve::drives(one.model, one.result);
    add(make_table("drives", "Driven sheaves", solve::drive_quantities(), rows_of<solve::DriveRow>(one, drives)));
  }
  if (!one.model.drums.empty()) {
    const auto drums = solve::drums(one.model, one.result);
    add(make_table("drums", "Drums", solve::drum_quantities(), rows_of<solve::DrumRow>(one, drums)));
  }
}

void add_drive_values(const MachineRun& run, Result& r) {
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    for (const auto& d : solve::drives(one.model, one.result)) {
      const std::string& name = one.model.reevings[d.reeving].nodes[d.node].name;
      for (const char* what : {"torque", "power"}) {
        const solve::DriveRow row{one.model, one.result, d};
        Value value = make_value(named(solve::drive_quantities(), what), row, name, one.ending, one.words);
        if (std::isnan(value.value)) continue;
        value.heading = heading_of(run, one);
        r.values.push_back(std::move(value));
      }
    }
  }
}

void warn_of_friction(const machine::Model& m, Result& r) {
  std::set<std::string> reported;
  for (const machine::Reeving& one : m.reevings) {
    for (const machine::Node& own : one.nodes) {
      if (!own.motor || !std::isfinite(own.law.friction)) continue;
      if (own.law.friction <= doubtful_friction || !reported.insert(own.name).second) continue;
      r.warnings.push_back(
          fmt::format("friction {:.3g} on '{}' is more than a wet, oily or sap-covered rope gives: mine hoists are "
                      "designed with 0.20 to 0.25, ropeways with 0.22 to 0.30",
                      own.law.friction, own.name));
    }
  }
}

}  // namespace taut::results
