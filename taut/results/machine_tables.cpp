#include "taut/results/machine_tables.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/calc/none.hpp"
#include "taut/math/fixed_angles.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/study/rope_clearance.hpp"

namespace taut::results {
namespace {

using solve::ContactState;
using solve::EquilibriumResult;

const machine::Reeving& reeving_at(const machine::Model& m, int i) { return m.reevings[i]; }
const std::string& node_name(const machine::Model& m, int r, int n) { return reeving_at(m, r).nodes[n].name; }

void add_band(std::vector<Column>& columns, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    columns.push_back({std::string(name) + "_min", si::N});
    columns.push_back({std::string(name) + "_max", si::N});
  }
}

Table spans(const machine::Model& m, const solve::EquilibriumResult& e) {
  Table t{"spans",
          "Spans",
          {{"rope", si::one},
           {"from", si::one},
           {"to", si::one},
           {"T_from", si::N},
           {"T_to", si::N},
           {"H", si::N},
           {"V_from", si::N},
           {"V_to", si::N},
           {"chord", si::m},
           {"unstretched", si::m},
           {"stretched", si::m},
           {"sag", si::m}},
          {}};
  if (e.band) add_band(t.columns, {"T_from", "T_to"});
  if (!m.terrain.empty()) t.columns.push_back({"clearance", si::m});
  for (const auto& s : e.spans) {
    std::vector<Cell> row = {reeving_at(m, s.reeving).name,
                             node_name(m, s.reeving, s.from),
                             node_name(m, s.reeving, s.to),
                             s.T_from,
                             s.T_to,
                             s.H,
                             s.V_from,
                             s.V_to,
                             s.chord,
                             s.unstretched * (1 + reeving_at(m, s.reeving).thermal_strain),
                             s.stretched,
                             s.sag};
    if (e.band) row.insert(row.end(), {s.T_from_min, s.T_from_max, s.T_to_min, s.T_to_max});
    if (!m.terrain.empty()) row.emplace_back(study::rope_clearance(m, s).height);
    t.rows.push_back(std::move(row));
  }
  return t;
}

Table sheaves(const machine::Model& m, const solve::EquilibriumResult& e) {
  Table t{"sheaves",
          "Sheaves, supports and carriages on their ropes",
          {{"name", si::one},
           {"T_in", si::N},
           {"T_out", si::N},
           {"wrap", si::rad},
           {"Fx", si::N},
           {"Fy", si::N},
           {"Fz", si::N},
           {"resultant", si::N},
           {"state", si::one},
           {"rope", si::one}},
          {}};
  if (e.band) add_band(t.columns, {"T_in", "T_out"});
  for (const auto& c : e.contacts) {
    if (reeving_at(m, c.reeving).nodes[c.node].kind == machine::NodeKind::load) continue;
    std::vector<Cell> row = {node_name(m, c.reeving, c.node),
                             c.T_in,
                             c.T_out,
                             c.wrap,
                             c.force.x(),
                             c.force.y(),
                             c.force.z(),
                             c.force.norm(),
                             std::string(to_text(c.state)),
                             reeving_at(m, c.reeving).name};
    if (e.band) row.insert(row.end(), {c.T_in_min, c.T_in_max, c.T_out_min, c.T_out_max});
    t.rows.push_back(std::move(row));
  }
  return t;
}

Table bodies(const machine::Model& m, const solve::EquilibriumResult& e) {
  Table t{"bodies",
          "Bodies: places, rotations about x, then y, then z, and the force of what holds them",
          {{"name", si::one},
           {"x", si::m},
           {"y", si::m},
           {"z", si::m},
           {"rx", si::rad},
           {"ry", si::rad},
           {"rz", si::rad},
           {"Rx", si::N},
           {"Ry", si::N},
           {"Rz", si::N}},
          {}};
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    if (m.bodies[i].of_rope || !is_listed(m.bodies[i])) continue;
    const auto& [position, orientation] = e.state.bodies[i];
    const Vector3 turn = fixed_angles(orientation);
    const Vector3& hold = e.reactions[i];
    t.rows.push_back({m.bodies[i].name, position.x(), position.y(), position.z(), turn.x(), turn.y(), turn.z(),
                      hold.x(), hold.y(), hold.z()});
  }
  return t;
}

Table anchors(const machine::Model& m, const solve::EquilibriumResult& e) {
  Table t{"anchors",
          "Ends of the ropes: force of the rope on what holds it",
          {{"name", si::one}, {"rope", si::one}, {"T", si::N}, {"Fx", si::N}, {"Fy", si::N}, {"Fz", si::N}},
          {}};
  const auto add = [&](const solve::SpanResult& s, int n, double T, const Vector3& f) {
    if (reeving_at(m, s.reeving).nodes[n].kind != machine::NodeKind::anchor) return;
    t.rows.push_back({node_name(m, s.reeving, n), reeving_at(m, s.reeving).name, T, f.x(), f.y(), f.z()});
  };
  for (const auto& s : e.spans) {
    add(s, s.from, s.T_from, pull_on_start(s));
    add(s, s.to, s.T_to, pull_on_end(s));
  }
  return t;
}

/// Where a rope's largest tension is.
std::string place_of(const machine::Model& m, const solve::EquilibriumResult& e, const solve::RopeResult& r) {
  const auto& s = e.spans[r.span];
  return node_name(m, s.reeving, r.at_end ? s.to : s.from);
}

Table ropes(const machine::Model& m, const solve::EquilibriumResult& e) {
  Table t{"ropes",
          "Ropes",
          {{"name", si::one}, {"unstretched", si::m}, {"T_max", si::N}, {"where", si::one}, {"safety_factor", si::one}},
          {}};
  for (std::size_t i = 0; i < e.ropes.size(); ++i) {
    const auto& r = e.ropes[i];
    t.rows.push_back(
        {m.reevings[i].name, r.unstretched, r.T_max, place_of(m, e, r), r.safety_factor > 0 ? r.safety_factor : none});
  }
  return t;
}

Table closure(const solve::EquilibriumResult& e) {
  return {"closure",
          "How well the answer closes, worst of all",
          {{"rope_closure", si::m.in("mm")},
           {"force_residual", si::N.in("N")},
           {"balance", si::N.in("N")},
           {"iterations", si::one}},
          {{e.closure.rope, e.closure.force, e.closure.balance, static_cast<double>(e.closure.iterations)}}};
}

/// The nodes of a rope with the number of their turn at a name: a tackle's block has several.
struct Turn {
  std::string name;
  long nth = 0;
  bool fixed = false;  ///< an end of the rope
  bool load = false;   ///< a force on it
};
Array<Turn> turns_of(const machine::Reeving& r) {
  Array<Turn> all;
  for (const machine::Node& node : r.nodes) {
    const auto same = [&](const Turn& other) { return !other.fixed && other.name == node.name; };
    all.push_back({node.name, std::count_if(all.begin(), all.end(), same), node.kind == machine::NodeKind::anchor,
                   node.kind == machine::NodeKind::load});
  }
  return all;
}

/// The contact of that name and turn; nullptr where the rope does not touch it.
const solve::ContactResult* contact(const machine::Model& m, const solve::EquilibriumResult& e, int reeving,
                                    const Turn& turn) {
  const Array<Turn> turns = turns_of(reeving_at(m, reeving));
  for (const auto& c : e.contacts) {
    if (c.reeving != reeving) continue;
    const Turn& own = turns[c.node];
    if (own.name == turn.name && own.nth == turn.nth) return &c;
  }
  return nullptr;
}

Table load_path(const machine::Model& all, const LoadPathRun& run) {
  Table t{"load_path", fmt::format("Load path, {}", run.words), load_path_columns(all), {}};
  for (const LoadPathPart& part : run.parts) {
    for (const auto& point : part.result.points) {
      if (point.at.outcome.ok()) t.rows.push_back(load_path_row(all, part.model, point));
    }
  }
  return t;
}

}  // namespace

std::vector<Column> load_path_columns(const machine::Model& all) {
  std::vector<Column> columns = {{"x", si::m}, {"z", si::m}, {"clearance", si::m}};
  for (const machine::Reeving& r : all.reevings) {
    columns.push_back({fmt::format("{}.T_{}", r.name, r.nodes.front().name), si::N});
    columns.push_back({fmt::format("{}.T_{}", r.name, r.nodes.back().name), si::N});
    columns.push_back({fmt::format("{}.T_max", r.name), si::N});
    columns.push_back({fmt::format("{}.unstretched", r.name), si::m});
  }
  for (const machine::Reeving& r : all.reevings) {
    for (const Turn& turn : turns_of(r)) {
      if (turn.fixed || turn.load) continue;
      const std::string which =
          fmt::format("{}.{}{}", r.name, turn.name, turn.nth == 0 ? std::string{} : fmt::format("[{}]", turn.nth + 1));
      columns.push_back({which + ".T_in", si::N});
      columns.push_back({which + ".T_out", si::N});
      columns.push_back({which + ".wrap", si::rad});
      columns.push_back({which + ".Fx", si::N});
      columns.push_back({which + ".Fz", si::N});
    }
  }
  add_drum_columns(all, columns);
  columns.push_back({"closure", si::m.in("mm")});
  if (!all.terrain.empty()) columns.push_back({"rope_clearance", si::m});
  return columns;
}

std::vector<Cell> load_path_row(const machine::Model& all, const machine::Model& m, const study::LoadPathPoint& point) {
  std::vector<Cell> row = {point.x, point.z, point.clearance};
  const solve::EquilibriumResult& e = point.at;
  const auto count = static_cast<int>(all.reevings.size());
  for (int i = 0; i < count; ++i) {
    const auto own = [&](const auto& s) { return s.reeving == i; };
    const auto first = std::find_if(e.spans.begin(), e.spans.end(), own);
    const auto last = std::find_if(e.spans.rbegin(), e.spans.rend(), own);
    const auto& rope = e.ropes[i];
    row.insert(row.end(), {first->T_from, last->T_to, rope.T_max, rope.unstretched});
  }
  for (int i = 0; i < count; ++i) {
    for (const Turn& turn : turns_of(reeving_at(all, i))) {
      if (turn.fixed || turn.load) continue;
      const auto* c = contact(m, e, i, turn);
      if (c == nullptr) {
        row.insert(row.end(), {none, none, none, none, none});
      } else {
        row.insert(row.end(), {c->T_in, c->T_out, c->wrap, c->force.x(), c->force.z()});
      }
    }
  }
  add_drum_cells(all, e, row);
  row.emplace_back(e.closure.rope);
  if (!all.terrain.empty()) row.emplace_back(study::rope_clearance(m, e).height);
  return row;
}

Vector3 pull_on_start(const solve::SpanResult& span) {
  Vector3 along = span.end - span.start;
  along.z() = 0;
  if (along.norm() > 0) along.normalize();
  return span.H * along + span.V_from * up();
}

Vector3 pull_on_end(const solve::SpanResult& span) {
  Vector3 along = span.end - span.start;
  along.z() = 0;
  if (along.norm() > 0) along.normalize();
  return -span.H * along - span.V_to * up();
}

std::string_view to_text(solve::ContactState state) {
  switch (state) {
    case solve::ContactState::turning:
      return "turning";
    case solve::ContactState::slipping:
      return "slipping";
    case solve::ContactState::stuck:
      return "stuck";
    case solve::ContactState::held:
      return "held";
    case solve::ContactState::pulled:
      return "pulled";
    case solve::ContactState::lifted:
      return "lifted";
  }
  return "";
}

void add_tables(const MachineRun& run, Result& r) {
  const auto add = [&](Table t, const std::string& ending, const std::string& words) {
    t.name += ending;
    if (run.equilibria.size() > 1) t.title += fmt::format(" ({})", words);
    r.tables.push_back(std::move(t));
  };
  for (const EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    add(spans(one.model, one.result), one.ending, one.words);
    add(sheaves(one.model, one.result), one.ending, one.words);
    add(bodies(one.model, one.result), one.ending, one.words);
    add(anchors(one.model, one.result), one.ending, one.words);
    add(ropes(one.model, one.result), one.ending, one.words);
    add_drive_tables(one, [&](Table t) { add(std::move(t), one.ending, one.words); });
    add(closure(one.result), one.ending, one.words);
  }
  for (const LoadPathRun& one : run.paths) {
    Table t = load_path(run.model, one);
    t.name += one.ending;
    r.tables.push_back(std::move(t));
  }
}

}  // namespace taut::results
