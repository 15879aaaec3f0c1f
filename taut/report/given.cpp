#include "taut/report/given.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "taut/report/html_table.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

/// Number and unit in a cell each; lists and words over both.
std::string given_cells(const Given& g, const Display& display) {
  const auto both = [](const std::string& text) {
    return fmt::format("<td class=\"val\" colspan=\"2\">{}</td>", escape(text));
  };
  if (g.numbers.empty()) return both(g.text.empty() ? "–" : g.text);
  const ShownUnit u = shown_unit(g.unit, display);
  const std::string unit = unit_text(u);
  if (g.numbers.size() == 1) {
    return cell(escape(number_shown(u.of(g.numbers[0]), 6)), "num") + cell(escape(unit), "u");
  }
  constexpr std::size_t most = 12;
  std::string out;
  for (std::size_t i = 0; i < std::min(most, g.numbers.size()); ++i) {
    if (i > 0) out += ", ";
    out += number_shown(u.of(g.numbers[i]), 6);
  }
  if (g.numbers.size() > most) out += fmt::format(", … ({} values)", g.numbers.size());
  return both(unit.empty() ? out : fmt::format("{}\u00A0{}", out, unit));
}

/// "cases[3].falls" -> cases, 3, falls; the list is empty for any other key.
struct RecordKey {
  std::string_view list;
  std::size_t index = 0;
  std::string_view field;
};

RecordKey record_key(std::string_view key) {
  const std::size_t open = key.rfind('[');
  const std::size_t close = key.find("].", open == std::string_view::npos ? 0 : open);
  if (open == std::string_view::npos || close == std::string_view::npos || open == 0) return {};
  RecordKey k{.list = key.substr(0, open), .index = 0, .field = key.substr(close + 2)};
  const auto [end, error] = std::from_chars(key.data() + open + 1, key.data() + close, k.index);
  return error == std::errc{} && end == key.data() + close ? k : RecordKey{};
}

/// The table of `list`, made when it is the first time.
Table& table_of(std::vector<Table>& all, std::string_view list) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Table& t) { return t.name == list; });
  if (at != all.end()) return *at;
  all.push_back({std::string(list), std::string(list), {}, {}});
  return all.back();
}

std::size_t column_of(Table& t, std::string_view field, const Unit& unit) {
  const auto at = std::find_if(t.columns.begin(), t.columns.end(), [&](const Column& c) { return c.name == field; });
  if (at != t.columns.end()) return static_cast<std::size_t>(at - t.columns.begin());
  t.columns.push_back({std::string(field), unit});
  return t.columns.size() - 1;
}

Cell cell_of(const Given& g) {
  if (g.numbers.size() == 1) return g.numbers[0];
  if (g.numbers.empty()) return g.text;
  return fmt::format("{} values", g.numbers.size());
}

}  // namespace

std::vector<Table> record_tables(const std::vector<Given>& given) {
  std::vector<Table> all;
  for (const Given& g : given) {
    const RecordKey key = record_key(g.key);
    if (key.list.empty()) continue;
    Table& t = table_of(all, key.list);
    const std::size_t column = column_of(t, key.field, g.unit);
    if (key.index > t.rows.size()) continue;  // not the order of a list
    if (key.index == t.rows.size()) t.rows.emplace_back();
    auto& row = t.rows[key.index];
    if (row.size() <= column) row.resize(column + 1, Cell{std::string{}});
    row[column] = cell_of(g);
  }
  std::erase_if(all, [](const Table& t) { return t.rows.size() < 2; });
  return all;
}

bool is_in_table(const Given& g, const std::vector<Table>& tables) {
  const RecordKey key = record_key(g.key);
  return std::any_of(tables.begin(), tables.end(), [&](const Table& t) { return t.name == key.list; });
}

std::string given_html(const Result& r) {
  if (r.given.empty()) return {};
  const Display display = display_of(r);
  const std::vector<Table> tables = record_tables(r.given);
  std::string rows;
  for (const Given& g : r.given) {
    if (is_in_table(g, tables)) continue;
    rows += fmt::format("<tr{}>", g.is_default ? " class=\"default\"" : "") + cell(symbol_html(g.symbol)) +
            cell(prose_html(g.words)) + given_cells(g, display) + cell(fmt::format("<code>{}</code>", escape(g.key))) +
            cell(g.is_default ? "default" : "given", "src") + "</tr>\n";
  }
  std::string out = fmt::format(
      "<table><thead><tr><th></th><th>quantity</th><th class=\"num\">value</th><th></th><th>key in the deck</th>"
      "<th></th></tr></thead><tbody>\n{}</tbody></table>\n",
      rows);
  for (const Table& t : tables) out += table_html(t, display);
  return out;
}

}  // namespace taut::report
