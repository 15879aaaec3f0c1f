#include "taut/report/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "taut/base/version.hpp"
#include "taut/report/html_table.hpp"
#include "taut/report/sections.hpp"
#include "taut/report/steps.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

using Row = std::vector<std::string>;

std::string safe(std::string_view text) { return escape_markdown(text); }
std::string code(std::string_view text) {
  std::string inside = clean(text);
  std::replace(inside.begin(), inside.end(), '`', '\'');
  return inside.empty() ? inside : fmt::format("`{}`", inside);
}
std::string code_cell(std::string_view text) {
  std::string inside(text);
  std::replace(inside.begin(), inside.end(), '|', '/');
  return code(inside);
}

/// `align`: one letter per column, l or r.
std::string table(const Row& head, std::string_view align, const std::vector<Row>& rows) {
  const auto line = [](const Row& row) {
    std::string out = "|";
    for (const std::string& c : row) out += " " + c + " |";
    return out + "\n";
  };
  std::string out = line(head) + "|";
  for (const char a : align) out += a == 'r' ? "--:|" : "---|";
  out += "\n";
  for (const Row& row : rows) out += line(row);
  return out;
}

std::string section(std::string_view title, const std::string& body) {
  return body.empty() ? "" : fmt::format("\n## {}\n\n{}", title, body);
}

std::string list(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& l : lines) out += fmt::format("- {}\n", safe(l));
  return out;
}

std::string errors(const Result& r) {
  std::string out;
  for (const Diagnostic& d : r.errors) {
    out += fmt::format("- {}:{}:{}: {}\n", safe(d.file), d.place.line, d.place.column, safe(d.message));
  }
  return out;
}

std::string figures(const Result& r, bool plots) {
  std::string out;
  for (const Figure& f : r.figures) {
    const bool has_data = std::holds_alternative<Plot>(f) || std::holds_alternative<Profile>(f);
    if (has_data != plots) continue;
    const auto [title, caption, name] = std::visit(
        [](const auto& x) {
          return std::array<std::string, 3>{x.title, x.caption, x.name};
        },
        f);
    out += fmt::format("- {}{}{}{}\n", safe(title), caption.empty() ? "" : ": ", safe(caption),
                       plots && !name.empty() ? fmt::format(" (data: {}.csv)", safe(name)) : "");
  }
  return out;
}

std::string comparisons(const Result& r) {
  const Display display = display_of(r);
  if (r.comparisons.empty()) return {};
  std::vector<Row> rows;
  for (const Comparison& c : r.comparisons) {
    const ShownUnit u = shown_unit(c.unit, display);
    const auto number = [&](double x) { return number_shown(u.of(x)); };
    rows.push_back({code_cell(c.symbol), safe(c.quantity), number(c.printed) + (c.printed_unsafe ? " **unsafe**" : ""),
                    number(c.corrected), number(c.exact), unit_text(u), safe(c.build_by)});
  }
  return table({"", "quantity", "as printed", "corrected", "exact", "unit", "build by"}, "llrrrll", rows);
}

std::string values(const Result& r) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  for (const Value& v : r.values) {
    const ShownUnit u = shown_unit(v.unit, display);
    rows.push_back({code_cell(v.symbol), safe(v.label.empty() ? v.name : v.label), number_shown(u.of(v.value), 6),
                    unit_text(u), safe(v.source)});
  }
  return rows.empty() ? "" : table({"", "result", "value", "unit", "from"}, "llrll", rows);
}

std::string checks(const Result& r) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  rows.reserve(r.checks.size());
  for (const Check& c : r.checks) {
    rows.push_back({safe(c.name), quantity_shown(c.value, c.unit, display),
                    (c.sense == Sense::at_most ? "≤ " : "≥ ") + quantity_shown(c.limit, c.unit, display),
                    utilisation_text(c.utilisation), fmt::format("**{}**", outcome_text(c)), safe(c.rule),
                    safe(c.trust)});
  }
  return rows.empty() ? "" : table({"check", "value", "limit", "utilisation", "", "rule", "trust"}, "lrrrlll", rows);
}

std::string given(const Result& r) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  for (const Given& g : r.given) {
    std::string value;
    for (const double x : g.numbers) value += (value.empty() ? "" : ", ") + quantity_shown(x, g.unit, display, 6);
    if (g.numbers.empty()) value = safe(g.text);
    rows.push_back({code_cell(g.symbol), safe(g.words), value, code_cell(g.key), g.is_default ? "default" : "given"});
  }
  return rows.empty() ? "" : table({"", "quantity", "value", "key", ""}, "llrll", rows);
}

std::string step(const Step& s, const Display& display) {
  switch (s.kind) {
    case Step::Kind::heading:
      return fmt::format("### {}\n\n", safe(s.words));
    case Step::Kind::note:
      return safe(s.words) + "\n\n";
    case Step::Kind::given:
      return fmt::format("- {} = {}: {}\n\n", code(s.symbol), quantity_shown(s.value, s.unit, display, 6),
                         safe(s.words));
    case Step::Kind::root:
    case Step::Kind::equation:
      break;
  }
  const std::string number = s.eq.empty() ? "" : fmt::format("({}) ", s.eq);
  const std::string value = fmt::format("{} = **{}**", code(s.symbol), quantity_shown(s.value, s.unit, display, 6));
  const std::string formula = formula_text(s.formula);
  const bool root = s.kind == Step::Kind::root;
  const std::string left = root ? "0" : s.symbol;
  std::string out =
      fmt::format("- {}{}{}\n", safe(number), formula.empty() ? "" : code(left + " = " + formula) + "; ", value);
  const std::string source = source_without_number(s);
  if (!formula.empty()) out += fmt::format("  - {}\n", code(left + " = " + numbers_text(s.formula)));
  if (!source.empty()) out += fmt::format("  - {}\n", safe(source));
  return out + "\n";
}

std::string steps(const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const Step& s : r.steps) out += step(s, display);
  return out;
}

std::string data_table(const Table& t, const Display& display) {
  Row head;
  std::string align;
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    const std::string unit = unit_text(shown_unit(t.columns[k].unit, display));
    head.push_back(safe(t.columns[k].name) + (unit.empty() ? "" : " (" + unit + ")"));
    const bool number = !t.rows.empty() && k < t.rows[0].size() && std::holds_alternative<double>(t.rows[0][k]);
    align += number ? 'r' : 'l';
  }
  std::vector<Row> rows;
  for (std::size_t i = 0; i < std::min(most_rows, t.rows.size()); ++i) {
    Row row;
    for (std::size_t k = 0; k < t.columns.size() && k < t.rows[i].size(); ++k) {
      const auto* x = std::get_if<double>(&t.rows[i][k]);
      row.push_back(x != nullptr ? number_shown(shown_unit(t.columns[k].unit, display).of(*x))
                                 : safe(std::get<std::string>(t.rows[i][k])));
    }
    rows.push_back(std::move(row));
  }
  std::string out = fmt::format("### {}\n\n{}\n", safe(t.title.empty() ? t.name : t.title), table(head, align, rows));
  if (t.rows.size() > most_rows) {
    out += fmt::format("{} of {} rows are shown; {}.csv has all of them.\n\n", most_rows, t.rows.size(), safe(t.name));
  }
  return out;
}

std::string tables(const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const Table& t : r.tables) {
    if ((t.name != "comparison" || r.comparisons.empty()) && !t.columns.empty() && !t.rows.empty())
      out += data_table(t, display);
  }
  return out;
}

}  // namespace

std::string to_markdown(const Result& r) {
  const Banner v = banner(r);
  const std::string title = r.title.empty() ? r.method_title : r.title;
  std::string out = fmt::format("# {}\n\n", safe(title.empty() ? "Calculation" : title));
  if (const std::string line = project_line(r.project); !line.empty()) out += safe(line) + "\n\n";
  if (!r.title.empty() && !r.method_title.empty()) out += safe(r.method_title) + "\n\n";
  if (!r.source.empty()) out += fmt::format("Source: {}\n\n", safe(r.source));
  out += fmt::format("**{}**{}{}\n", safe(v.headline), v.detail.empty() ? "" : ": ", safe(v.detail));
  if (!v.scope.empty()) out += fmt::format("\n{}\n", safe(v.scope));
  out += section("Mistakes in the deck", errors(r));
  out += section("Warnings", list(r.warnings));
  out += section("Drawings", figures(r, false));
  out += section(comparison_title(r), comparisons(r));
  out += section("Results", values(r));
  out += section("Checks", checks(r));
  out += section("Given", given(r));
  out += section("Calculation", steps(r));
  out += section("Plots", figures(r, true));
  out += section("Tables", tables(r));
  out += section("Assumptions", list(r.assumptions));
  out += fmt::format("\ntaut {}", version);
  if (!r.deck_name.empty()) out += fmt::format(", deck {}", safe(r.deck_name));
  if (!r.deck_hash.empty()) out += fmt::format(", hash {}, --set {}", safe(r.deck_hash), safe(overrides_text(r)));
  return out + "\n";
}

}  // namespace taut::report
