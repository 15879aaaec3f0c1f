#include "taut/report/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/base/version.hpp"
#include "taut/report/figure/any_figure.hpp"
#include "taut/report/page_one.hpp"
#include "taut/report/page_plan.hpp"
#include "taut/report/pictures.hpp"
#include "taut/report/sections.hpp"
#include "taut/report/steps.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/tables/check_table.hpp"
#include "taut/report/tables/html_table.hpp"
#include "taut/report/tables/inputs.hpp"
#include "taut/report/tables/thinning.hpp"
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

std::string figures(const std::vector<const Figure*>& all) {
  std::string out;
  for (const Figure* f : all) {
    const FigureWords w = words_of(*f);
    out += fmt::format("- {}{}{}{}\n", safe(w.title), w.caption.empty() ? "" : ": ", safe(w.caption),
                       w.csv.empty() ? "" : fmt::format(" (data: {})", safe(w.csv)));
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

std::string values(const std::vector<const Value*>& all, const Result& r) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  for (const Value* value : all) {
    const Value& v = *value;
    const ShownUnit u = shown_unit(v.unit, display);
    rows.push_back({code_cell(v.symbol), safe(v.label.empty() ? v.name : v.label), value_number(v.value, u),
                    unit_text(u), safe(v.source)});
  }
  return rows.empty() ? "" : table({"", "result", "value", "unit", "from"}, "llrll", rows);
}

/// Of all checks, or of the worst of each part.
std::string checks(const std::vector<const Check*>& all, const Display& display) {
  std::vector<Row> rows;
  rows.reserve(all.size());
  for (const Check* c : all) {
    rows.push_back({safe(c->name), safe(value_text(*c, display)), limit_text(*c, display),
                    utilisation_text(c->utilisation), fmt::format("**{}**", outcome_text(*c)), safe(c->rule),
                    safe(c->trust)});
  }
  return rows.empty() ? "" : table({"check", "value", "limit", "use", "", "rule", "limit is"}, "lrrrlll", rows);
}

std::string all_checks(const Result& r) {
  std::vector<const Check*> all;
  all.reserve(r.checks.size());
  for (const Check& c : r.checks) all.push_back(&c);
  return checks(all, display_of(r));
}

std::string given(const Result& r) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  for (const Given* g : single_inputs(r.given, false)) {
    rows.push_back({code_cell(g->symbol), safe(g->words),
                    safe(input_text(*g, display)) + (g->chosen ? " *chosen*" : ""), code_cell(g->key)});
  }
  std::string out = rows.empty() ? "" : table({"", "quantity", "value", "key"}, "llll", rows) + "\n";
  for (const InputTable& t : input_tables(r.given, display)) {
    Row head;
    std::string align;
    for (const InputColumn& c : t.columns) {
      head.push_back(safe(c.name) + (c.unit.empty() ? "" : fmt::format(" ({})", c.unit)));
      align += c.numbers ? 'r' : 'l';
    }
    std::vector<Row> parts;
    for (const auto& cells : t.rows) {
      Row row;
      for (const InputCell& c : cells) row.push_back(safe(c.text) + (c.chosen ? " *chosen*" : ""));
      parts.push_back(std::move(row));
    }
    out += fmt::format("### {}\n\n{}\n", safe(t.title), table(head, align, parts));
  }
  return out;
}

std::string defaults(const Result& r) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  for (const InputDefault& d : input_defaults(r.given, display)) {
    rows.push_back({code_cell(d.given->symbol), safe(d.given->words), safe(input_text(*d.given, display)),
                    code_cell(d.key), safe(d.parts)});
  }
  return rows.empty() ? "" : "### Inputs by default\n\n" + table({"", "quantity", "value", "key", "of"}, "lllll", rows);
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

std::string data_table(const Table& t, const TableLimits& limits, const Display& display) {
  Row head;
  std::string align;
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    const std::string unit = unit_text(shown_unit(t.columns[k].unit, display));
    head.push_back(safe(t.columns[k].name) + (unit.empty() ? "" : " (" + unit + ")"));
    const bool number = !t.rows.empty() && k < t.rows[0].size() && std::holds_alternative<double>(t.rows[0][k]);
    align += number ? 'r' : 'l';
  }
  std::vector<Row> rows;
  const std::vector<std::size_t> shown = rows_that_matter(t, limits.rows);
  for (const std::size_t i : shown) {
    Row row;
    for (std::size_t k = 0; k < t.columns.size() && k < t.rows[i].size(); ++k) {
      const auto* x = std::get_if<double>(&t.rows[i][k]);
      row.push_back(x != nullptr ? number_shown(shown_unit(t.columns[k].unit, display).of(*x))
                                 : safe(std::get<std::string>(t.rows[i][k])));
    }
    rows.push_back(std::move(row));
  }
  std::string out = fmt::format("### {}\n\n{}\n", safe(t.title.empty() ? t.name : t.title), table(head, align, rows));
  if (shown.size() < t.rows.size()) {
    out += fmt::format("{} of {} rows: ends, extremes, changes; all in {}.csv\n\n", shown.size(), t.rows.size(),
                       safe(t.name));
  }
  return out;
}

std::string tables(const std::vector<const Table*>& all, const TableLimits& limits, const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const Table* t : all) out += data_table(*t, limits, display);
  return out;
}

std::string results(const PagePlan& plan, const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const ResultGroup& group : groups_of(plan)) {
    if (!group.heading.empty()) out += fmt::format("\n**{}**\n\n", safe(group.heading));
    out += values(group.values, r) + "\n";
    for (const Table* t : group.tables) out += data_table(without_detail(*t), plan.limits, display);
  }
  return out;
}

std::string answers(const Result& r) {
  std::string out;
  for (const Answer& a : answers_beside_checks(r)) out += fmt::format("- **{}** {}\n", safe(a.label), safe(a.text));
  return out.empty() ? out : "\n" + out;
}

/// Page 1.
std::string summary(const Result& r) {
  const Banner v = banner(r);
  std::string out = fmt::format("# {}\n\n", safe(title_of(r)));
  if (const std::string line = project_line(r.project); !line.empty()) out += safe(line) + "\n\n";
  if (!r.title.empty() && !r.method_title.empty()) out += safe(r.method_title) + "\n\n";
  if (!r.source.empty()) out += fmt::format("Source: {}\n\n", safe(r.source));
  out += fmt::format("**{}**{}{}\n", safe(v.headline), v.detail.empty() ? "" : ": ", safe(v.detail));
  if (!v.scope.empty()) out += fmt::format("\n{}\n", safe(v.scope));
  out += answers(r);
  std::vector<const Check*> worst = worst_by_part(r);
  worst.resize(std::min(worst.size(), most_summary_rows));
  out += section("The worst check of each part", checks(worst, display_of(r)));
  return out;
}

}  // namespace

std::string to_markdown(const Result& r) {
  const PagePlan plan = plan_pages(r);
  std::string out = summary(r);
  out += section("Mistakes in the deck", errors(r));
  out += section("Warnings", list(warnings_by_weight(r)));
  out += section("Inputs", given(r));
  out += section("Checks", all_checks(r));
  out += section(comparison_title(r), comparisons(r));
  out += section("Calculation", steps(r));
  out += section("Results", results(plan, r));
  out += section("Pictures", figures(figures_in_order(r)));
  out += section("Assumptions", list(r.assumptions));
  out += section("Appendix",
                 values(plan.appendix_values, r) + tables(plan.appendix_tables, plan.appendix_limits, r) + defaults(r));
  out += fmt::format("\ntaut {}", version);
  if (!r.deck_name.empty()) out += fmt::format(", deck {}", safe(r.deck_name));
  if (!r.deck_hash.empty()) out += fmt::format(", hash {}, --set {}", safe(r.deck_hash), safe(overrides_text(r)));
  return out + "\n";
}

}  // namespace taut::report
