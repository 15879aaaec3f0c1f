#include "taut/report/tables/given.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "taut/report/tables/html_table.hpp"
#include "taut/report/tables/inputs.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr std::string_view chosen_mark = " <em class=\"chosen\">chosen</em>";
constexpr std::size_t points_in_line = 10;
constexpr std::size_t most_beside = 14;  ///< rows of a table that may stand beside others, and is not broken
constexpr std::size_t least_points = 5;

/// Lists that belong together, "machine.terrain.x" and ".z": as many numbers, below the same key.
bool is_profile(const Given& a, const Given& b) {
  const auto above = [](const std::string& key) { return key.substr(0, key.rfind('.')); };
  return a.numbers.size() == b.numbers.size() && a.numbers.size() >= least_points &&
         a.numbers.size() <= most_numbers_of_input && above(a.key) == above(b.key);
}

/// A table on its side: a line for each list, `points_in_line` columns; then the next lines.
std::string profile_html(const std::vector<const Given*>& lists, const Display& display) {
  const std::size_t count = lists.front()->numbers.size();
  std::string rows;
  for (std::size_t from = 0; from < count; from += points_in_line) {
    for (const Given* g : lists) {
      const ShownUnit u = shown_unit(g->unit, display);
      rows += fmt::format("<tr><th>{} <span class=\"u\">{}</span></th>", escape(g->key.substr(g->key.rfind('.') + 1)),
                          escape(unit_text(u)));
      for (std::size_t i = from; i < std::min(count, from + points_in_line); ++i) {
        rows += cell(escape(number_shown(u.of(g->numbers[i]), 6)), "num");
      }
      rows += "</tr>\n";
    }
  }
  const std::string key = lists.front()->key.substr(0, lists.front()->key.rfind('.'));
  return fmt::format(
      "<div class=\"wide\"><table class=\"profile\"><caption><code>{}</code>, {} points</caption><tbody>\n{}"
      "</tbody></table></div>\n",
      escape(key), count, rows);
}

std::string single_row(const Given& g, const Display& display) {
  return "<tr>" + cell(symbol_html(g.symbol)) + cell(prose_html(g.words)) +
         cell(escape(input_text(g, display)) + (g.chosen ? std::string(chosen_mark) : ""), "val") +
         cell(fmt::format("<code>{}</code>", escape(g.key))) + "</tr>\n";
}

std::string singles_html(const std::vector<const Given*>& single, const Display& display) {
  std::string rows, profiles;
  for (std::size_t i = 0; i < single.size(); ++i) {
    std::vector<const Given*> lists{single[i]};
    while (i + 1 < single.size() && is_profile(*single[i], *single[i + 1])) lists.push_back(single[++i]);
    if (lists.size() > 1) {
      profiles += profile_html(lists, display);
    } else {
      rows += single_row(*single[i], display);
    }
  }
  if (rows.empty()) return profiles;
  return fmt::format(
             "<div class=\"wide\"><table><thead><tr><th></th><th>quantity</th><th>value</th><th>key in the deck</th>"
             "</tr></thead><tbody>\n{}</tbody></table></div>\n",
             rows) +
         profiles;
}

std::string input_table_html(const InputTable& t) {
  std::string head, body;
  for (const InputColumn& c : t.columns) {
    head += fmt::format("<th{}{}>{}{}</th>", c.numbers ? " class=\"num\"" : "",
                        c.words.empty() ? "" : fmt::format(" title=\"{}\"", escape(c.words)), escape(c.name),
                        c.unit.empty() ? "" : fmt::format("<br><span class=\"u\">{}</span>", escape(c.unit)));
  }
  for (const auto& row : t.rows) {
    body += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string text = escape(row[k].text) + (row[k].chosen ? std::string(chosen_mark) : "");
      body += k == 0 ? fmt::format("<th>{}</th>", text) : cell(text, t.columns[k].numbers ? "num" : "val");
    }
    body += "</tr>\n";
  }
  return fmt::format(
      "<div class=\"wide{}\"><table class=\"parts\"><caption>{}</caption><thead><tr>{}</tr></thead><tbody>\n{}"
      "</tbody></table></div>\n",
      t.rows.size() <= most_beside ? " beside" : "", escape(t.title), head, body);
}

}  // namespace

std::string given_html(const Result& r) {
  const Display display = display_of(r);
  std::string out = singles_html(single_inputs(r.given, false), display);
  for (const InputTable& t : input_tables(r.given, display)) out += input_table_html(t);
  return out;
}

std::string defaults_html(const Result& r) {
  const Display display = display_of(r);
  std::string rows;
  for (const InputDefault& d : input_defaults(r.given, display)) {
    rows += "<tr>" + cell(symbol_html(d.given->symbol)) + cell(prose_html(d.given->words)) +
            cell(escape(input_text(*d.given, display)), "val") + cell(fmt::format("<code>{}</code>", escape(d.key))) +
            cell(escape(d.parts)) + "</tr>\n";
  }
  if (rows.empty()) return {};
  return fmt::format(
      "<div class=\"wide\"><table><caption>Inputs by "
      "default</caption><thead><tr><th></th><th>quantity</th><th>value</th>"
      "<th>key in the deck</th><th>of</th></tr></thead><tbody>\n{}</tbody></table></div>\n",
      rows);
}

}  // namespace taut::report
