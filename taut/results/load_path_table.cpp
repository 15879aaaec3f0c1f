#include "taut/results/load_path_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/calc/none.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::results {
namespace {

const Quantities<solve::RopeRow>& rope_columns() {
  static const auto all = joined(picked(solve::rope_quantities(), {"T_max"}),
                                 as_details(picked(solve::rope_quantities(), {"unstretched"})));
  return all;
}

const Quantities<solve::ContactRow>& contact_columns() {
  static const auto all = as_details(picked(solve::contact_quantities(), {"T_in", "T_out", "wrap", "Fx", "Fz"}));
  return all;
}

const Quantities<solve::DrumRow>& drum_columns() {
  static const auto all = as_details(picked(solve::drum_quantities(), {"length", "layer", "torque"}));
  return all;
}

const Quantities<LoadPathRow>& place_columns() {
  static const Quantities<LoadPathRow> all = {
      {"x", "x", si::m, "place of the carriage along its way", [](const LoadPathRow& r) { return r.point.x; }},
      {"z", "z", si::m, "its height", [](const LoadPathRow& r) { return r.point.z; }},
      {"clearance", "", si::m, "its height over the ground; empty where there is no terrain",
       [](const LoadPathRow& r) { return r.point.clearance; }}};
  return all;
}

const Quantities<LoadPathRow>& closure_columns() {
  static const auto all =
      as_details(Quantities<LoadPathRow>{{"closure", "", si::m.in("mm"), "ends of branches and lengths of ropes",
                                          [](const LoadPathRow& r) { return r.point.at.closure.rope; }}});
  return all;
}

const Quantities<LoadPathRow>& terrain_columns() {
  static const Quantities<LoadPathRow> all = {
      {"rope_clearance", "", si::m, "least height of any rope over the ground",
       [](const LoadPathRow& r) { return study::rope_clearance(r.model, r.point.at).height; }}};
  return all;
}

QuantityWords tension_at_end(const std::string& rope, const std::string& end) {
  return {.name = fmt::format("{}.T_{}", rope, end),
          .symbol = "",
          .unit = si::N,
          .words = "tension at each end of its path",
          .detail = true};
}

/// One contact of a rope by its name and, as a tackle's block has several, the number of its turn.
struct Turn {
  std::string name;
  long number = 0;  ///< from 0
  bool operator==(const Turn& other) const { return name == other.name && number == other.number; }
};

/// Of the nodes of a rope, in its order.
Array<Turn> turns_of(const machine::Reeving& rope) {
  Array<Turn> all;
  for (std::size_t n = 0; n < rope.nodes.size(); ++n) {
    const auto before = rope.nodes.begin() + static_cast<std::ptrdiff_t>(n);
    all.push_back({rope.nodes[n].name, std::count_if(rope.nodes.begin(), before, [&](const machine::Node& other) {
                     return other.kind != machine::NodeKind::anchor && other.name == rope.nodes[n].name;
                   })});
  }
  return all;
}

/// Those that have columns: the contacts, not the ends nor the loads.
Array<Turn> contacts_of(const machine::Reeving& rope) {
  const Array<Turn> turns = turns_of(rope);
  Array<Turn> all;
  for (std::size_t n = 0; n < turns.size(); ++n) {
    const machine::NodeKind kind = rope.nodes[n].kind;
    if (kind != machine::NodeKind::anchor && kind != machine::NodeKind::load) all.push_back(turns[n]);
  }
  return all;
}

/// The contact of that turn; nullptr where the rope does not touch it.
const solve::ContactResult* contact(const machine::Model& m, const solve::EquilibriumResult& e, int reeving,
                                    const Turn& turn) {
  const Array<Turn> turns = turns_of(m.reevings[reeving]);
  const auto found = std::find_if(e.contacts.begin(), e.contacts.end(), [&](const solve::ContactResult& c) {
    return c.reeving == reeving && turns[c.node] == turn;
  });
  return found == e.contacts.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Column> load_path_columns(const machine::Model& all) {
  std::vector<Column> columns;
  add_columns(columns, place_columns());
  for (const machine::Reeving& r : all.reevings) {
    for (const machine::Node& end : {r.nodes.front(), r.nodes.back()}) {
      add_columns(columns, {tension_at_end(r.name, end.name)});
    }
    add_columns(columns, rope_columns(), r.name + ".");
  }
  for (const machine::Reeving& r : all.reevings) {
    for (const Turn& turn : contacts_of(r)) {
      const std::string number = turn.number == 0 ? std::string{} : fmt::format("[{}]", turn.number + 1);
      add_columns(columns, contact_columns(), fmt::format("{}.{}{}.", r.name, turn.name, number));
    }
  }
  for (const machine::Reeving& r : all.reevings) {
    for (const machine::Node& end : {r.nodes.front(), r.nodes.back()}) {
      if (end.drum && all.drums[*end.drum].length_on_drum) add_columns(columns, drum_columns(), end.name + ".");
    }
  }
  add_columns(columns, closure_columns());
  if (!all.terrain.empty()) add_columns(columns, terrain_columns());
  return columns;
}

std::vector<Cell> load_path_cells(const LoadPathRow& row) {
  const solve::EquilibriumResult& e = row.point.at;
  const auto count = static_cast<int>(row.all.reevings.size());
  std::vector<Cell> cells;
  add_cells(cells, place_columns(), row);
  for (int i = 0; i < count; ++i) {
    const solve::RopeRow rope{.model = row.model, .at = e, .reeving = i};
    add_cells(cells, solve::rope_end_tensions(), rope);
    add_cells(cells, rope_columns(), rope);
  }
  for (int i = 0; i < count; ++i) {
    for (const Turn& turn : contacts_of(row.all.reevings[i])) {
      if (const auto* c = contact(row.model, e, i, turn)) {
        add_cells(cells, contact_columns(), solve::ContactRow{row.model, e, *c});
      } else {
        cells.insert(cells.end(), contact_columns().size(), none);
      }
    }
  }
  for (const solve::DrumResult& d : solve::drums(row.all, e)) {
    if (d.length) add_cells(cells, drum_columns(), solve::DrumRow{row.all, e, d});
  }
  add_cells(cells, closure_columns(), row);
  if (!row.all.terrain.empty()) add_cells(cells, terrain_columns(), row);
  return cells;
}

Table load_path_table(const machine::Model& all, const study::LoadPathRun& run) {
  Table t{.name = "load_path",
          .title = fmt::format("Load path, {}", run.words),
          .columns = load_path_columns(all),
          .rows = {}};
  for (const study::LoadPathPart& part : run.parts) {
    for (const auto& point : part.result.points) {
      if (point.at.outcome.ok()) t.rows.push_back(load_path_cells({.all = all, .model = part.model, .point = point}));
    }
  }
  return t;
}

std::vector<QuantityWords> load_path_words() {
  std::vector<QuantityWords> all;
  const auto add = [&](const std::vector<QuantityWords>& more) { all.insert(all.end(), more.begin(), more.end()); };
  add(words_of(place_columns()));
  all.push_back(tension_at_end("ROPE", "ANCHOR"));
  add(prefixed("ROPE.", words_of(rope_columns())));
  add(prefixed("ROPE.NAME.", words_of(contact_columns())));
  add(prefixed("NAME.", words_of(drum_columns())));
  add(words_of(closure_columns()));
  add(words_of(terrain_columns()));
  return all;
}

}  // namespace taut::results
