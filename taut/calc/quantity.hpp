#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/units/unit.hpp"

namespace taut {

/// What a person reads of one result. In a description a word in capitals stands for a name of the deck, a number or a
/// word of a few: "ROPE.T_max", "sag_N".
struct QuantityWords {
  std::string name;    ///< of its column; of a value behind the part's name and a dot: "T_from"
  std::string symbol;  ///< the letter of the theory pages, "T_0"; may be empty
  Unit unit;           ///< SI, with the unit of print; texts and counts: si::one
  std::string words;   ///< one line: what it is, "tension where the branch begins"
  bool detail =
      false;  ///< not what an analysis is about: its values and columns stand in the appendix of a report only
};

/// One result, described once. Columns of tables, values, and the reference follow from it, as inputs follow from
/// `describe`. `Row` holds all that the getter needs: a branch with the model and the state that it belongs to.
template <class Row>
struct Quantity {
  Quantity(std::string name, std::string symbol, const Unit& unit, std::string words,
           std::function<Cell(const Row&)> getter)
      : about{.name = std::move(name), .symbol = std::move(symbol), .unit = unit, .words = std::move(words)},
        of(std::move(getter)) {}

  QuantityWords about;
  std::function<Cell(const Row&)> of;  ///< its number in SI (NaN: none here), or its text
};

template <class Row>
using Quantities = std::vector<Quantity<Row>>;

/// What is said of each of them: for tables that are described, not filled.
template <class Row>
std::vector<QuantityWords> words_of(const Quantities<Row>& quantities) {
  std::vector<QuantityWords> all;
  for (const Quantity<Row>& q : quantities) all.push_back(q.about);
  return all;
}

/// A table of a result as a reader looks it up: its name without an analysis' ending, what its rows are, its columns.
struct TableWords {
  std::string name;  ///< "life_ROPE"
  std::string rows;  ///< "every bend in every duty"
  std::vector<QuantityWords> columns;
};

/// The same with something before each name: "ROPE.".
std::vector<QuantityWords> prefixed(const std::string& prefix, std::vector<QuantityWords> all);

[[noreturn]] void no_such_quantity(std::string_view name);

/// The one of that name; throws where there is none.
template <class Row>
const Quantity<Row>& named(const Quantities<Row>& quantities, std::string_view name) {
  for (const Quantity<Row>& q : quantities) {
    if (q.about.name == name) return q;
  }
  no_such_quantity(name);
}

/// Those of these names, in this order.
template <class Row>
Quantities<Row> picked(const Quantities<Row>& quantities, const std::vector<std::string_view>& names) {
  Quantities<Row> all;
  for (const std::string_view name : names) all.push_back(named(quantities, name));
  return all;
}

/// The same, all of them details.
template <class Row>
Quantities<Row> as_details(Quantities<Row> quantities) {
  for (Quantity<Row>& q : quantities) q.about.detail = true;
  return quantities;
}
std::vector<QuantityWords> as_details(std::vector<QuantityWords> words);

template <class Row>
Quantities<Row> joined(Quantities<Row> first, const Quantities<Row>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Their columns behind those that are there, under `prefix` and their names.
template <class Row>
void add_columns(std::vector<Column>& columns, const Quantities<Row>& quantities, const std::string& prefix = {}) {
  for (const Quantity<Row>& q : quantities) columns.push_back({prefix + q.about.name, q.about.unit, q.about.detail});
}

/// Columns for what is described without a getter.
void add_columns(std::vector<Column>& columns, const std::vector<QuantityWords>& words);

/// Their cells behind those that are there.
template <class Row>
void add_cells(std::vector<Cell>& cells, const Quantities<Row>& quantities, const Row& row) {
  for (const Quantity<Row>& q : quantities) cells.push_back(q.of(row));
}

/// A table with a column for each quantity and a line for each row; all of its columns details: so is the table.
template <class Row>
Table make_table(std::string name, std::string title, const Quantities<Row>& quantities, const std::vector<Row>& rows) {
  Table t{.name = std::move(name), .title = std::move(title), .columns = {}, .rows = {}};
  add_columns(t.columns, quantities);
  t.detail =
      !t.columns.empty() && std::all_of(t.columns.begin(), t.columns.end(), [](const Column& c) { return c.detail; });
  for (const Row& row : rows) add_cells(t.rows.emplace_back(), quantities, row);
  return t;
}

/// A line behind those of the result's table of that name; the first line begins the table.
template <class Row>
void add_line(Result& r, const std::string& name, const std::string& title, const Quantities<Row>& quantities,
              const Row& row) {
  auto table = std::find_if(r.tables.begin(), r.tables.end(), [&](const Table& t) { return t.name == name; });
  if (table == r.tables.end()) {
    table = r.tables.insert(table, make_table(name, title, quantities, std::vector<Row>{}));
  }
  add_cells(table->rows.emplace_back(), quantities, row);
}

/// The value of one row, a number: "skyline.T_max_2", and in words "largest tension of skyline (hoist)". `ending`: of
/// the analysis; `state`: where the number holds.
template <class Row>
Value make_value(const Quantity<Row>& q, const Row& row, const std::string& part, const std::string& ending,
                 const std::string& state) {
  const std::string name = part + "." + q.about.name + ending;
  return {name,
          std::get<double>(q.of(row)),
          q.about.unit,
          name,
          q.about.words + " of " + part + " (" + state + ")",
          {},
          q.about.detail};
}

}  // namespace taut
