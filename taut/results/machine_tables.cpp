#include "taut/results/machine_tables.hpp"

#include <fmt/format.h>

#include "taut/results/load_path_table.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::results {
namespace {

using solve::EquilibriumResult;

Table spans(const machine::Model& m, const EquilibriumResult& e) {
  Quantities<solve::BranchRow> columns = solve::branch_quantities();
  if (e.band) columns = joined(columns, solve::branch_band_quantities());
  if (!m.terrain.empty()) columns = joined(columns, branch_terrain_quantities());
  std::vector<solve::BranchRow> rows;
  for (const auto& branch : e.branches) rows.push_back({m, e, branch});
  return make_table("spans", "Spans", columns, rows);
}

Table sheaves(const machine::Model& m, const EquilibriumResult& e) {
  Quantities<solve::ContactRow> columns = solve::contact_quantities();
  if (e.band) columns = joined(columns, solve::contact_band_quantities());
  std::vector<solve::ContactRow> rows;
  for (const auto& c : e.contacts) {
    if (m.reevings[c.reeving].nodes[c.node].kind != machine::NodeKind::load) rows.push_back({m, e, c});
  }
  return make_table("sheaves", "Sheaves, supports and carriages on their ropes", columns, rows);
}

Table bodies(const machine::Model& m, const EquilibriumResult& e) {
  std::vector<solve::BodyRow> rows;
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    if (!m.bodies[i].of_rope && is_listed(m.bodies[i])) rows.push_back({m, e, static_cast<int>(i)});
  }
  return make_table("bodies", "Bodies: places, rotations about x, then y, then z, and the force of what holds them",
                    as_details(solve::body_quantities()), rows);
}

Table anchors(const machine::Model& m, const EquilibriumResult& e) {
  std::vector<solve::RopeEndRow> rows;
  for (const auto& s : e.branches) {
    const auto& nodes = m.reevings[s.reeving].nodes;
    if (nodes[s.from].kind == machine::NodeKind::anchor) rows.push_back({m, s, false});
    if (nodes[s.to].kind == machine::NodeKind::anchor) rows.push_back({m, s, true});
  }
  return make_table("anchors", "Ends of the ropes: force of the rope on what holds it", solve::rope_end_quantities(),
                    rows);
}

Table ropes(const machine::Model& m, const EquilibriumResult& e) {
  std::vector<solve::RopeRow> rows;
  rows.reserve(e.ropes.size());
  for (std::size_t i = 0; i < e.ropes.size(); ++i) rows.push_back({m, e, static_cast<int>(i)});
  return make_table("ropes", "Ropes", solve::rope_quantities(), rows);
}

Table closure(const EquilibriumResult& e) {
  return make_table("closure", "How well the answer closes, worst of all", as_details(solve::closure_quantities()),
                    std::vector<solve::Closure>{e.closure});
}

}  // namespace

const Quantities<machine::PlaceOverGround>& over_ground_quantities() {
  using Row = machine::PlaceOverGround;
  static const Quantities<Row> all = {
      {"part", "", si::one, "what stands there", [](const Row& p) { return fmt::format("{} {}", p.kind, p.name); }},
      {"x", "x", si::m, "its place", [](const Row& p) { return p.at.x(); }},
      {"y", "y", si::m, "its place", [](const Row& p) { return p.at.y(); }},
      {"z", "z", si::m, "its height", [](const Row& p) { return p.at.z(); }},
      {"chainage", "", si::m, "of its foot along the line of the terrain", &Row::chainage},
      {"ground", "", si::m, "height of the terrain at its foot", &Row::ground},
      {"over_ground", "h", si::m, "from its foot, along the support", &Row::over_ground},
      {"offset", "", si::m, "from the line to the left, seen towards growing chainage", &Row::offset},
      {"lean", "", si::rad, "from the vertical towards growing chainage", &Row::lean}};
  return all;
}

const Quantities<solve::BranchRow>& branch_terrain_quantities() {
  static const Quantities<solve::BranchRow> all = {
      {"clearance", "", si::m, "least height of the branch over the ground, where there is terrain",
       [](const solve::BranchRow& r) { return study::rope_clearance(r.model, r.part).height; }}};
  return all;
}

void add_tables(const MachineRun& run, Result& r) {
  const auto add = [&](Table t, const study::EquilibriumRun& one) {
    t.name += one.ending;
    if (run.equilibria.size() > 1) t.title += fmt::format(" ({})", one.words);
    t.heading = heading_of(run, one);
    r.tables.push_back(std::move(t));
  };
  if (!run.model.over_ground.empty()) {
    r.tables.push_back(
        make_table("places", "Places given over the ground", over_ground_quantities(), run.model.over_ground));
  }
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    add(spans(one.model, one.result), one);
    add(sheaves(one.model, one.result), one);
    add(bodies(one.model, one.result), one);
    add(anchors(one.model, one.result), one);
    add(ropes(one.model, one.result), one);
    add_drive_tables(one, [&](Table t) { add(std::move(t), one); });
    add(closure(one.result), one);
  }
  for (const study::LoadPathRun& one : run.paths) {
    Table t = load_path_table(run.model, one);
    t.name += one.ending;
    t.heading = heading_of(run, one);
    r.tables.push_back(std::move(t));
  }
}

}  // namespace taut::results
