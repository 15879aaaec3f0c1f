#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "taut/app/job.hpp"

/// Decks of machines run from a text, and their results looked up.
namespace taut_test {

inline taut::Result run_text(const std::string& text, const std::vector<std::string>& set = {}) {
  return taut::app::run(taut::app::Job{.text = text, .name = "deck.yaml", .set = set});
}

inline double value_of(const taut::Result& r, const std::string& name) {
  const taut::Value* v = r.find_value(name);
  EXPECT_NE(v, nullptr) << name << "; " << r.message << to_text(r.errors);
  return v == nullptr ? std::nan("") : v->value;
}

inline const taut::Table& table_of(const taut::Result& r, const std::string& name) {
  static const taut::Table empty;
  const taut::Table* t = r.find_table(name);
  EXPECT_NE(t, nullptr) << name << "; " << r.message << to_text(r.errors);
  return t == nullptr ? empty : *t;
}

/// Of a result that ends with the expression: a copy, so that `const Table& t = table_of(run_text(...), ...)` stands.
inline taut::Table table_of(taut::Result&& r, const std::string& name) { return table_of(std::as_const(r), name); }

inline taut::Cell any_cell(const taut::Table& t, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < t.columns.size(); ++i) {
    if (t.columns[i].name == column) return t.rows.at(row).at(i);
  }
  ADD_FAILURE() << t.name << " has no column " << column;
  return std::nan("");
}

inline double cell(const taut::Table& t, std::size_t row, const std::string& column) {
  const taut::Cell found = any_cell(t, row, column);
  return std::holds_alternative<double>(found) ? std::get<double>(found) : std::nan("");
}

inline std::string text_cell(const taut::Table& t, std::size_t row, const std::string& column) {
  const taut::Cell found = any_cell(t, row, column);
  return std::holds_alternative<std::string>(found) ? std::get<std::string>(found) : std::string{};
}

inline const taut::Check& check_of(const taut::Result& r, const std::string& name) {
  static const taut::Check none;
  const auto found = std::find_if(r.checks.begin(), r.checks.end(), [&](const auto& c) { return c.name == name; });
  EXPECT_NE(found, r.checks.end()) << "no check " << name << to_text(r.errors) << r.message;
  return found == r.checks.end() ? none : *found;
}

/// Of a result that ends with the expression: a copy, as of a table.
inline taut::Check check_of(taut::Result&& r, const std::string& name) { return check_of(std::as_const(r), name); }

inline bool has_check(const taut::Result& r, const std::string& name) {
  return std::any_of(r.checks.begin(), r.checks.end(), [&](const auto& c) { return c.name == name; });
}

/// The row whose cell in `column` has this text.
inline std::size_t row_of(const taut::Table& t, const std::string& column, const std::string& text) {
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (text_cell(t, i, column) == text) return i;
  }
  ADD_FAILURE() << t.name << " has no row " << text;
  return 0;
}

/// Both have the same exit code and this text among the errors; for decks with a mistake.
inline void expect_mistake(const taut::Result& r, const std::string& text) {
  EXPECT_EQ(exit_code(r), 2) << text;
  EXPECT_NE(to_text(r.errors).find(text), std::string::npos) << text << "\n" << to_text(r.errors);
}

/// A skyline over two saddles with a carriage on a mainline from a drum, over a ground; `%A` is what the analyses are.
inline std::string skyline_deck(const std::string& analyses) {
  return R"(taut: 1
machine:
  temperature: 15 degC
  points: {stump: [0 m, 0 m, 4 m], tower: [360 m, 0 m, 124 m]}
  ropes:
    skyline: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 280 kN}
    mainline: {mass: 0.54 kg/m, stiffness: 7 MN, breaking_force: 110 kN}
  supports:
    jack1: {at: [110 m, 0 m, 33 m], diameter: 400 mm, friction: 0.1}
    jack2: {at: [240 m, 0 m, 78 m], friction: 0.1}
  drums:
    winch: {at: [362 m, 0 m, 122 m], core_diameter: 500 mm}
  carriages:
    car: {mass: 350 kg, rides: skyline, hold: rolling, mainline: mainline}
  reevings:
    - {rope: skyline, path: [{anchor: stump}, {over: jack1}, {through: car}, {over: jack2}, {anchor: tower}], length: 382 m}
    - {rope: mainline, path: [{drum: winch}, {anchor: car}], length: 192 m}
  loads: [{at: car, mass: 0 kg}]
  terrain: {x: [0 m, 110 m, 170 m, 240 m, 360 m], z: [-4 m, 22 m, 34 m, 66 m, 106 m]}
analyses:
)" + analyses +
         "\n";
}

/// A mast by its method: `input` are more lines of its input, `behind` more blocks.
inline std::string mast_deck(const std::string& input, const std::string& behind) {
  return R"(taut: 1
method: mast_section
input:
  skyline_force: 100 kN
  mainline_force: 40 kN
  skyline_block_height: 8 m
  branch_angle: 12 deg
  allowable_stress: 160 MPa
  )" + input +
         "\n" + behind;
}

}  // namespace taut_test
