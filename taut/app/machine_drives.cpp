#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "taut/analysis/drives.hpp"
#include "taut/analysis/running.hpp"
#include "taut/app/machine_tables.hpp"
#include "taut/app/none.hpp"

namespace taut::app {
namespace {

/// Above, friction on a wet, oily or sap-covered rope is doubtful (mine hoists 0.20 to 0.25, ropeways 0.22 to 0.30).
constexpr double doubtful_friction = 0.4;

using Flow = std::vector<std::vector<int>>;

Flow flow_of(const EquilibriumRun& one) {
  std::vector<Complaint> told_before;
  return analysis::flow_of(one.model, options_of(one.motion, one.model, {}, told_before));
}

const model::Reeving& rope(const model::Model& m, int i) { return m.reevings[static_cast<std::size_t>(i)]; }
const model::Node& node(const model::Model& m, int r, int n) { return rope(m, r).nodes[static_cast<std::size_t>(n)]; }

Table rope_loads(const model::Model& m, const analysis::EquilibriumResult& e) {
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

Table drives(const model::Model& m, const std::vector<analysis::DriveResult>& all) {
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
    const model::Node& own = node(m, d.reeving, d.node);
    const bool grips = std::isfinite(own.law.friction);
    t.rows.push_back({own.name, rope(m, d.reeving).name, d.T_in, d.T_out, d.centrifugal, d.torque, d.wrap,
                      grips ? d.slip_arc : none, grips ? d.rest_arc : none, d.ratio, grips ? d.limit : none, d.creep,
                      d.speed.value_or(none), d.speed ? d.power : none, d.power_loads.value_or(none),
                      d.power_losses.value_or(none), d.power_carriages.value_or(none), d.power_creep.value_or(none)});
  }
  return t;
}

Table drums(const model::Model& m, const std::vector<analysis::DrumResult>& all) {
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
    const model::Drum& drum = m.drums[static_cast<std::size_t>(d.drum)];
    const double power = d.speed ? rope(m, d.reeving).copies * d.pull * *d.speed : none;
    t.rows.push_back({drum.name, rope(m, d.reeving).name, static_cast<double>(d.layer), d.radius,
                      d.wraps.value_or(none), d.length.value_or(none), d.capacity.value_or(none), d.pull, d.torque,
                      d.pull_last_layer.value_or(none), d.speed.value_or(none), power});
  }
  return t;
}

void keep_worst(std::map<std::string, Check>& worst, Check check) {
  const auto at = worst.find(check.name);
  if (at == worst.end() || check.utilisation > at->second.utilisation) worst[check.name] = std::move(check);
}

/// Whether a motor's torque is no more than a limit: with the length and all loads given there is nothing it could set.
/// A signal is no limit: it changes.
bool is_limit(const model::Model& m, const model::Reeving& r) {
  const int motor = r.nodes.front().motor;
  if (motor < 0 || !m.motors[static_cast<std::size_t>(motor)].drive.signal.name.empty()) return false;
  const bool open = std::any_of(r.nodes.begin(), r.nodes.end(),
                                [](const model::Node& n) { return n.kind == model::NodeKind::load && n.load.open; });
  return r.closed && r.given == model::Given::length && r.nodes.front().tension_drop && !open;
}

void check_drive(const model::Model& m, const analysis::DriveResult& d, std::map<std::string, Check>& worst) {
  const model::Node& own = node(m, d.reeving, d.node);
  if (std::isfinite(own.law.friction)) {
    keep_worst(worst,
               make_check(own.name + ".grip", d.ratio, Sense::at_most, d.limit, si::one,
                          d.centrifugal > 0
                              ? "ratio of tensions less m v^2 that friction holds, exp(mu theta), Euler-Eytelwein"
                              : "ratio of tensions that friction holds, exp(mu theta), Euler-Eytelwein",
                          "derived"));
  }
  if (!is_limit(m, rope(m, d.reeving))) return;
  const double most = std::abs(*own.tension_drop) * own.radius * rope(m, d.reeving).copies;
  keep_worst(worst, make_check(own.name + ".torque", std::abs(d.torque), Sense::at_most, most, si::N_m,
                               "the motor's torque", "user"));
}

void check_drum(const model::Model& m, const analysis::DrumResult& d, std::map<std::string, Check>& worst) {
  const model::Drum& drum = m.drums[static_cast<std::size_t>(d.drum)];
  const std::string& name = drum.name;
  if (drum.drive.kind == model::DriveKind::torque && drum.drive.signal.name.empty()) {
    const double most = at(drum.drive.signal, 0).value;
    // the rope's tension follows from it, or it is a limit
    if (d.torque < most * (1 - 1e-9) || d.torque > most * (1 + 1e-9)) {
      keep_worst(worst,
                 make_check(name + ".torque", d.torque, Sense::at_most, most, si::N_m, "the drum's torque", "user"));
    }
  }
  if (d.length && d.capacity) {
    keep_worst(worst, make_check(name + ".capacity", *d.length, Sense::at_most, *d.capacity, si::m,
                                 "rope that the drum takes within its flanges", "derived"));
  }
  if (d.length && *d.length < 0) {
    keep_worst(worst, make_check(name + ".length_on_drum", *d.length, Sense::at_least, 0, si::m,
                                 "rope left on the drum", "derived"));
  }
}

void add_drive_values(const model::Model& m, const analysis::DriveResult& d, const EquilibriumRun& one, Result& r) {
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
  if (!one.model.motors.empty()) add(drives(one.model, analysis::drives(one.model, flow_of(one), one.result)));
  if (!one.model.drums.empty()) add(drums(one.model, analysis::drums(one.model, flow_of(one), one.result)));
}

void add_drum_columns(const model::Model& m, std::vector<Column>& columns) {
  for (const model::Reeving& one : m.reevings) {
    for (const model::Node& end : {one.nodes.front(), one.nodes.back()}) {
      if (end.drum < 0 || !m.drums[static_cast<std::size_t>(end.drum)].length_on_drum) continue;
      columns.push_back({end.name + ".length", si::m});
      columns.push_back({end.name + ".layer", si::one});
      columns.push_back({end.name + ".torque", si::N_m});
    }
  }
}

void add_drum_cells(const model::Model& m, const analysis::EquilibriumResult& e, std::vector<Cell>& row) {
  Flow none_runs;
  for (const model::Reeving& one : m.reevings) none_runs.emplace_back(one.nodes.size(), 0);
  for (const analysis::DrumResult& d : analysis::drums(m, none_runs, e)) {
    if (d.length) row.insert(row.end(), {*d.length, static_cast<double>(d.layer), d.torque});
  }
}

void add_drives(const MachineRun& run, Result& r) {
  std::map<std::string, Check> worst;
  for (const EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    for (const auto& d : analysis::drives(one.model, flow_of(one), one.result)) {
      check_drive(one.model, d, worst);
      add_drive_values(one.model, d, one, r);
    }
    for (const auto& d : analysis::drums(one.model, flow_of(one), one.result)) check_drum(one.model, d, worst);
  }
  for (const LoadPathRun& path : run.paths) {
    for (const LoadPathPart& part : path.parts) {
      std::vector<Complaint> told_before;
      const Flow flow = analysis::flow_of(part.model, options_of(path.motion, part.model, {}, told_before));
      for (const auto& point : part.result.points) {
        if (!point.at.outcome.ok()) continue;
        for (const auto& d : analysis::drives(part.model, flow, point.at)) check_drive(part.model, d, worst);
        for (const auto& d : analysis::drums(part.model, flow, point.at)) check_drum(part.model, d, worst);
      }
    }
  }
  for (auto& [name, check] : worst) r.checks.push_back(std::move(check));
  std::set<std::string> told;
  for (const model::Reeving& one : run.model.reevings) {
    for (const model::Node& own : one.nodes) {
      if (own.kind != model::NodeKind::drive || !std::isfinite(own.law.friction)) continue;
      if (own.law.friction <= doubtful_friction || !told.insert(own.name).second) continue;
      r.warnings.push_back(
          fmt::format("friction {:.3g} on '{}' is more than a wet, oily or sap-covered rope gives: mine hoists are "
                      "designed with 0.20 to 0.25, ropeways with 0.22 to 0.30",
                      own.law.friction, own.name));
    }
  }
}

}  // namespace taut::app
