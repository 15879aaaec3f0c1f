#include "taut/report/tables/html_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "taut/report/tables/thinning.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

bool is_number_column(const Table& t, std::size_t k) {
  return std::any_of(t.rows.begin(), t.rows.end(),
                     [&](const auto& row) { return k < row.size() && std::holds_alternative<double>(row[k]); });
}

constexpr int own_digits = 4;
constexpr int column_digits = 4;  ///< of the largest number of a column; all digits are in the CSV file
constexpr std::size_t most_without_headings = 40;
constexpr std::size_t most_of_quantity = 12;  ///< characters of a number with its unit, which stay in one line

/// Whether a column says the unit of its row's numbers.
bool rows_have_units(const Table& t) {
  return std::any_of(t.columns.begin(), t.columns.end(), [](const Column& c) { return c.name == "unit"; });
}

/// What the rows of a long list are parts of, by row: of "row 4, 52 deg: S1" beside "row 4, 52 deg: S2" what stands
/// before the colon, where rows beside each other share it. Empty: of nothing, or the list is short.
std::vector<std::string> parts_of_list(const Table& t) {
  std::vector<std::string> parts(t.rows.size());
  if (t.rows.size() <= most_without_headings || !is_list(t)) return parts;
  const auto before_colon = [&](std::size_t i) {
    const auto& words = std::get<std::string>(t.rows[i][0]);
    const auto colon = words.rfind(": ");
    return colon == std::string::npos ? std::string() : words.substr(0, colon);
  };
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const std::string part = before_colon(i);
    if (!part.empty() && part == before_colon(i + 1)) parts[i] = parts[i + 1] = part;
  }
  return parts;
}

/// Cells of one column, in the order of `rows`.
std::vector<std::string> column_cells(const Table& t, std::size_t k, const std::vector<std::size_t>& rows,
                                      const std::vector<std::string>& parts, const Display& display) {
  const ShownUnit u = shown_unit(t.columns[k].unit, display);
  std::vector<double> numbers;
  for (const std::size_t i : rows) {
    const auto* x = k < t.rows[i].size() ? std::get_if<double>(&t.rows[i][k]) : nullptr;
    numbers.push_back(x == nullptr ? NAN : u.of(*x));
  }
  std::vector<std::string> shown = column_shown(numbers, column_digits);
  if (rows_have_units(t) && t.columns[k].unit.symbol == si::one.symbol) {  // each of another size
    std::transform(numbers.begin(), numbers.end(), shown.begin(), [](double x) { return number_shown(x, own_digits); });
  }
  std::vector<std::string> cells;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const auto& row = t.rows[rows[n]];
    const auto* words = k < row.size() ? std::get_if<std::string>(&row[k]) : nullptr;
    const std::string& part = parts[rows[n]];
    const std::size_t said = k == 0 && !part.empty() ? part.size() + 2 : 0;  // by the heading of its part
    const bool quantity = words != nullptr && !part.empty() && words->size() <= most_of_quantity &&
                          words->find_first_of("0123456789") <= 1;  // behind a sign
    cells.push_back(words == nullptr ? cell(escape(shown[n]), "num")
                                     : cell(prose_html(words->substr(said)), quantity ? "short" : ""));
  }
  return cells;
}

/// "boom_length" reads as words; a symbol stays one.
std::string heading(std::string name) {
  if (split_symbol(name).is_word) std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

std::string cell(std::string_view inside, std::string_view kind) {
  return kind.empty() ? fmt::format("<td>{}</td>", inside) : fmt::format("<td class=\"{}\">{}</td>", kind, inside);
}

namespace {

/// Characters that stand side by side on a page, and those between two columns; a number takes no fewer than these.
constexpr std::size_t most_characters = 104;
constexpr std::size_t between_columns = 2;
constexpr std::size_t number_characters = 6;
constexpr std::size_t most_leading = 3;  ///< columns that are repeated

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0, length = 0;
  for (const char c : text) {
    length = c == ' ' ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  return longest;
}

/// What does not break into two lines: the longest word of a column's head and cells.
std::size_t width_of(const Table& t, std::size_t k) {
  std::size_t width = std::max(longest_word(heading(t.columns[k].name)), number_characters);
  for (const auto& row : t.rows) {
    const auto* words = k < row.size() ? std::get_if<std::string>(&row[k]) : nullptr;
    if (words != nullptr) width = std::max(width, longest_word(*words));
  }
  return width + between_columns;
}

/// The columns in which something stands; what is not known of any row says nothing on paper.
std::vector<std::size_t> filled_columns(const Table& t) {
  std::vector<std::size_t> filled;
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    const bool any = std::any_of(t.rows.begin(), t.rows.end(), [&](const auto& row) {
      if (k >= row.size()) return false;
      const auto* words = std::get_if<std::string>(&row[k]);
      return words != nullptr ? !words->empty() : !std::isnan(std::get<double>(row[k]));
    });
    if (any) filled.push_back(k);
  }
  return filled;
}

/// The columns that say what a row is about: the words it begins with, else its first number.
std::vector<std::size_t> leading(const Table& t, const std::vector<std::size_t>& columns) {
  std::vector<std::size_t> lead;
  for (const std::size_t k : columns) {
    if (is_number_column(t, k) || lead.size() == most_leading) break;
    lead.push_back(k);
  }
  if (lead.empty() && !columns.empty()) lead.push_back(columns.front());
  return lead;
}

/// The table's columns in parts that fit a page: those that say what a row is about lead each.
std::vector<std::vector<std::size_t>> parts_of(const Table& t) {
  const std::vector<std::size_t> columns = filled_columns(t);
  const std::vector<std::size_t> lead = leading(t, columns);
  std::vector<std::vector<std::size_t>> parts(1);
  std::size_t width = 0;
  for (const std::size_t k : columns) {
    const std::size_t own = width_of(t, k);
    const std::size_t used = parts.back().size();
    if (used > lead.size() && (used >= most_columns || width + own > most_characters)) {
      parts.push_back(lead);
      width = 0;
      for (const std::size_t l : lead) width += width_of(t, l);
    }
    parts.back().push_back(k);
    width += own;
  }
  return parts;
}

std::string part_html(const Table& t, const std::vector<std::size_t>& part, const std::vector<std::size_t>& rows,
                      const std::string& caption, const Display& display) {
  const std::vector<std::string> above = parts_of_list(t);
  std::string head;
  std::vector<std::vector<std::string>> columns;
  for (const std::size_t k : part) {
    const std::string unit = unit_text(shown_unit(t.columns[k].unit, display));
    const std::string name = to_html(label_runs(heading(t.columns[k].name)));
    head += fmt::format("<th{}>{}{}</th>", is_number_column(t, k) ? " class=\"num\"" : "", name,
                        unit.empty() ? "" : fmt::format("<br><span class=\"u\">{}</span>", escape(unit)));
    columns.push_back(column_cells(t, k, rows, above, display));
  }
  std::string body;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (const std::string& now = above[rows[n]]; n > 0 ? now != above[rows[n - 1]] : !now.empty()) {
      body += now.empty() ? "</tbody><tbody>\n"
                          : fmt::format("</tbody><tbody class=\"part\">\n<tr><th colspan=\"{}\">{}</th></tr>\n",
                                        part.size(), prose_html(now));
    }
    body += "<tr>";
    for (const auto& column : columns) body += column[n];
    body += "</tr>\n";
  }
  return fmt::format(
      "<div class=\"wide{}\"><p class=\"caption\">{}</p><table class=\"data\"><thead><tr>{}</tr></thead><tbody>\n"
      "{}</tbody></table></div>\n",
      rows.size() <= 12 ? " small" : "", caption, head, body);
}

}  // namespace

std::string csv_link(std::string_view name) { return fmt::format("<a href=\"{0}.csv\">{0}.csv</a>", escape(name)); }

namespace {

/// The unit of this SI symbol; null: none that a person chooses another for.
const Unit* unit_of_symbol(std::string_view symbol) {
  const auto& all = display_kinds();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Unit& u) { return u.symbol == symbol; });
  return at == all.end() ? nullptr : &*at;
}

/// Numbers that rounding left of 0 beside those of rows with the same unit, in column `unit`.
void drop_traces(Table& t, std::size_t unit) {
  constexpr double trace = 1e-12;
  std::map<std::string, double> largest;
  const auto each = [&](auto&& use) {
    for (auto& row : t.rows) {
      const auto* const name = unit < row.size() ? std::get_if<std::string>(&row[unit]) : nullptr;
      if (name == nullptr) continue;
      for (std::size_t k = 0; k < row.size() && k < t.columns.size(); ++k) {
        auto* const number = std::get_if<double>(&row[k]);
        if (number != nullptr && t.columns[k].unit.symbol == si::one.symbol) use(*number, largest[*name]);
      }
    }
  };
  each([](double x, double& most) {
    if (std::isfinite(x)) most = std::max(most, std::abs(x));
  });
  each([](double& x, double most) {
    if (std::abs(x) < trace * most) x = 0;
  });
}

/// Rows that name their own SI unit, in the units of print.
Table in_units_of_print(Table t, const Display& display) {
  const auto unit = std::find_if(t.columns.begin(), t.columns.end(), [](const Column& c) { return c.name == "unit"; });
  if (unit == t.columns.end()) return t;
  const auto at = static_cast<std::size_t>(unit - t.columns.begin());
  for (auto& row : t.rows) {
    auto* const name = at < row.size() ? std::get_if<std::string>(&row[at]) : nullptr;
    const Unit* const own = name == nullptr ? nullptr : unit_of_symbol(*name);
    if (own == nullptr) continue;
    const ShownUnit shown = shown_unit(*own, display);
    *name = unit_text(shown);
    for (std::size_t k = 0; k < row.size() && k < t.columns.size(); ++k) {
      auto* const number = std::get_if<double>(&row[k]);
      if (number != nullptr && t.columns[k].unit.symbol == si::one.symbol) *number = shown.of(*number);
    }
  }
  drop_traces(t, at);
  if (const std::size_t si_words = t.title.rfind(" (SI)"); si_words != std::string::npos) t.title.erase(si_words, 5);
  return t;
}

}  // namespace

std::string table_html(const Table& stored, const Display& display, const TableLimits& limits) {
  if (stored.rows.empty() || stored.columns.empty()) return {};
  const Table t = in_units_of_print(stored, display);
  const auto rows = rows_that_matter(t, limits.rows);
  const auto parts = parts_of(t);
  const std::size_t shown_parts = std::min(parts.size(), limits.parts);
  const std::string title = prose_html(t.title.empty() ? t.name : t.title);
  std::string out;
  for (std::size_t i = 0; i < shown_parts; ++i) {
    const std::string caption = parts.size() == 1 ? title : fmt::format("{} ({} of {})", title, i + 1, parts.size());
    out += part_html(t, parts[i], rows, caption, display);
  }
  std::string cut;
  if (rows.size() < t.rows.size()) {
    cut = fmt::format("{} of {} rows: ends, extremes, changes", rows.size(), t.rows.size());
  }
  if (shown_parts < parts.size()) {
    cut += fmt::format("{}columns up to {}", cut.empty() ? "" : "; ",
                       escape(heading(t.columns[parts[shown_parts - 1].back()].name)));
  }
  if (cut.empty()) return out;
  return out + fmt::format("<p class=\"cut\">{}; all in {}</p>\n", cut, csv_link(t.name));
}

double printed_height(const Table& t, const TableLimits& limits) {
  if (t.rows.empty() || t.columns.empty()) return 0;
  constexpr double row = 4.8, around = 19;  // mm
  const auto rows = static_cast<double>(rows_that_matter(t, limits.rows).size());
  const auto parts = static_cast<double>(std::min(parts_of(t).size(), limits.parts));
  return parts * (around + rows * row);
}

}  // namespace taut::report
