#include <fmt/format.h>

#include <cmath>
#include <set>

#include "taut/calc/none.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/solve/drives.hpp"

namespace taut::results {
namespace {

/// Above, friction on a wet, oily or sap-covered rope is doubtful (mine hoists 0.20 to 0.25, ropeways 0.22 to 0.30).
constexpr double doubtful_friction = 0.4;

const machine::Reeving& rope(const machine::Model& m, int i) { return m.reevings[i]; }
const machine::Node& node(const machine::Model& m, int r, int n) { return rope(m, r).nodes[n]; }

Table rope_loads(const machine::Model& m, const solve::EquilibriumResult& e) {
  Table t{"rope_loads",
          "Forces along the ropes (on one copy; F is positive along the path)",
          {{"name", si::one},
           {"rope", si::one},
           {"F", si::N},
           {"T_in", si::N},
           {"T_out", si::N},
           {"x", si::m},
           {"y", si::m},
           {"z", si::m}},
          {}};
  for (const auto& one : e.rope_loads) {
    t.rows.push_back({node(m, one.reeving, one.node).name, rope(m, one.reeving).name, one.along_path, one.T_in,
                      one.T_out, one.at.x(), one.at.y(), one.at.z()});
  }
  return t;
}

Table drives(const machine::Model& m, const std::vector<solve::DriveResult>& all) {
  Table t{"drives",
          "Driven sheaves",
          {{"name", si::one},
           {"rope", si::one},
           {"T_in", si::N},
           {"T_out", si::N},
           {"centrifugal", si::N},
           {"torque", si::N_m},
           {"wrap", si::rad},
           {"slip_arc", si::rad},
           {"rest_arc", si::rad},
           {"ratio", si::one},
           {"limit", si::one},
           {"creep", si::one},
           {"speed", si::m_per_s},
           {"power", si::W},
           {"power_loads", si::W},
           {"power_losses", si::W},
           {"power_carriages", si::W},
           {"power_creep", si::W}},
          {}};
  for (const auto& d : all) {
    const machine::Node& own = node(m, d.reeving, d.node);
    const bool grips = std::isfinite(own.law.friction);
    t.rows.push_back({own.name, rope(m, d.reeving).name, d.T_in, d.T_out, d.centrifugal, d.torque, d.wrap,
                      grips ? d.slip_arc : none, grips ? d.rest_arc : none, d.ratio, grips ? d.limit : none, d.creep,
                      d.speed.value_or(none), d.speed ? d.power : none, d.power_loads.value_or(none),
                      d.power_losses.value_or(none), d.power_carriages.value_or(none), d.power_creep.value_or(none)});
  }
  return t;
}

Table drums(const machine::Model& m, const std::vector<solve::DrumResult>& all) {
  Table t{"drums",
          "Drums",
          {{"name", si::one},
           {"rope", si::one},
           {"layer", si::one},
           {"radius", si::m.in("mm")},
           {"wraps", si::one},
           {"length", si::m},
           {"capacity", si::m},
           {"pull", si::N},
           {"torque", si::N_m},
           {"pull_last_layer", si::N},
           {"speed", si::m_per_s},
           {"power", si::W}},
          {}};
  for (const auto& d : all) {
    const machine::Drum& drum = m.drums[d.drum];
    const double power = d.speed ? rope(m, d.reeving).copies * d.pull * *d.speed : none;
    t.rows.push_back({drum.name, rope(m, d.reeving).name, static_cast<double>(d.layer), d.radius,
                      d.wraps.value_or(none), d.length.value_or(none), d.capacity.value_or(none), d.pull, d.torque,
                      d.pull_last_layer.value_or(none), d.speed.value_or(none), power});
  }
  return t;
}

void add_drive_values(const machine::Model& m, const solve::DriveResult& d, const EquilibriumRun& one, Result& r) {
  const std::string& name = node(m, d.reeving, d.node).name;
  const auto add = [&](const char* what, double value, const Unit& unit, const char* words) {
    const std::string key = fmt::format("{}.{}{}", name, what, one.ending);
    r.values.push_back({key, value, unit, key, fmt::format("{} of {} ({})", words, name, one.words), {}});
  };
  add("torque", d.torque, si::N_m, "torque");
  if (d.speed) add("power", d.power, si::W, "power");
}

}  // namespace

void add_drive_tables(const EquilibriumRun& one, const std::function<void(Table)>& add) {
  if (!one.result.rope_loads.empty()) add(rope_loads(one.model, one.result));
  if (!one.model.motors.empty()) add(drives(one.model, solve::drives(one.model, one.result)));
  if (!one.model.drums.empty()) add(drums(one.model, solve::drums(one.model, one.result)));
}

void add_drum_columns(const machine::Model& m, std::vector<Column>& columns) {
  for (const machine::Reeving& one : m.reevings) {
    for (const machine::Node& end : {one.nodes.front(), one.nodes.back()}) {
      if (end.drum < 0 || !m.drums[end.drum].length_on_drum) continue;
      columns.push_back({end.name + ".length", si::m});
      columns.push_back({end.name + ".layer", si::one});
      columns.push_back({end.name + ".torque", si::N_m});
    }
  }
}

void add_drum_cells(const machine::Model& m, const solve::EquilibriumResult& e, std::vector<Cell>& row) {
  for (const solve::DrumResult& d : solve::drums(m, e)) {
    if (d.length) row.insert(row.end(), {*d.length, static_cast<double>(d.layer), d.torque});
  }
}

void add_drive_values(const MachineRun& run, Result& r) {
  for (const EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    for (const auto& d : solve::drives(one.model, one.result)) add_drive_values(one.model, d, one, r);
  }
}

void warn_of_friction(const machine::Model& m, Result& r) {
  std::set<std::string> reported;
  for (const machine::Reeving& one : m.reevings) {
    for (const machine::Node& own : one.nodes) {
      if (own.kind != machine::NodeKind::drive || !std::isfinite(own.law.friction)) continue;
      if (own.law.friction <= doubtful_friction || !reported.insert(own.name).second) continue;
      r.warnings.push_back(
          fmt::format("friction {:.3g} on '{}' is more than a wet, oily or sap-covered rope gives: mine hoists are "
                      "designed with 0.20 to 0.25, ropeways with 0.22 to 0.30",
                      own.law.friction, own.name));
    }
  }
}

}  // namespace taut::results
