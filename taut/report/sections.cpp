#include "taut/report/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "taut/report/page_one.hpp"
#include "taut/report/page_plan.hpp"
#include "taut/report/pictures.hpp"
#include "taut/report/steps.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/tables/check_table.hpp"
#include "taut/report/tables/given.hpp"
#include "taut/report/tables/html_table.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

/// The table of a comparison of decks with published values.
constexpr std::string_view compared_table = "compared";

std::string list_html(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& l : lines) out += fmt::format("<li>{}</li>\n", prose_html(l));
  return lines.empty() ? "" : fmt::format("<ul>\n{}</ul>\n", out);
}

std::string comparisons_html(const Result& r) {
  const Display display = display_of(r);
  if (r.comparisons.empty()) return {};
  const bool exact = has_exact(r);
  std::string rows;
  for (const Comparison& c : r.comparisons) {
    const ShownUnit u = shown_unit(c.unit, display);
    const auto shown = column_shown({u.of(c.printed), u.of(c.corrected), u.of(c.exact)});
    const bool seen = shown[0] != shown[1] || (exact && shown[0] != shown[2]);
    const bool unsafe = c.printed_unsafe && seen;
    const std::string mark = unsafe ? "<span class=\"badge bad\">printed value is unsafe</span> " : "";
    rows += fmt::format("<tr{}>", unsafe ? " class=\"unsafe\"" : "") + cell(symbol_html(c.symbol)) +
            cell(prose_html(c.quantity)) + cell(escape(shown[0]), "num") + cell(escape(shown[1]), "num") +
            (exact ? cell(escape(shown[2]), "num") : "") + cell(escape(unit_text(u)), "u") +
            cell(mark + prose_html(c.build_by)) + "</tr>\n";
  }
  return fmt::format(
      "<div class=\"wide\"><table><thead><tr><th></th><th>quantity</th><th class=\"num\">as printed</th><th "
      "class=\"num\">"
      "corrected</th>{}<th></th><th>build by</th></tr></thead><tbody>\n{}</tbody></table></div>\n",
      exact ? "<th class=\"num\">exact</th>" : "", rows);
}

/// The largest finite amount among the values of each unit.
std::map<std::string_view, double> largest_by_unit(const std::vector<const Value*>& values) {
  std::map<std::string_view, double> largest;
  for (const Value* v : values) {
    double& amount = largest[v->unit.symbol];
    if (std::isfinite(v->value)) amount = std::max(amount, std::abs(v->value));
  }
  return largest;
}

/// A trace that rounding left of 0: beside values of the same unit nobody reads it.
bool is_nothing(double value, double largest) {
  constexpr double share = 1e-12;
  return std::abs(value) < share * largest;
}

std::string values_html(const std::vector<const Value*>& values, std::string_view caption, const Result& r) {
  const Display display = display_of(r);
  const bool sources = std::any_of(values.begin(), values.end(), [](const Value* v) { return !v->source.empty(); });
  const std::map<std::string_view, double> largest = largest_by_unit(values);
  std::string rows;
  for (const Value* value : values) {
    const Value& v = *value;
    const ShownUnit u = shown_unit(v.unit, display);
    rows += "<tr>" + cell(symbol_html(v.symbol)) + cell(prose_html(v.label.empty() ? v.name : v.label)) +
            cell(escape(value_number(is_nothing(v.value, largest.at(v.unit.symbol)) ? 0 : v.value, u)), "num") +
            cell(escape(unit_text(u)), "u") +
            (sources ? cell(prose_html(v.source), length(v.source) <= 24 ? "src short" : "src") : "") + "</tr>\n";
  }
  if (rows.empty()) return {};
  return fmt::format(
      "<div class=\"wide\"><table>{}<thead><tr><th></th><th>result</th><th class=\"num\">value</th><th></th>"
      "{}</tr></thead><tbody>\n{}</tbody></table></div>\n",
      caption.empty() ? "" : fmt::format("<caption>{}</caption>", caption), sources ? "<th>from</th>" : "", rows);
}

/// The numbers of what is not shown here, and where it is.
std::string elsewhere_html(const PagePlan& plan) {
  std::string names;
  if (!plan.appendix_values.empty()) names = fmt::format("{} more values", plan.appendix_values.size());
  for (const Table* t : plan.appendix_tables) {
    if (std::find(plan.tables.begin(), plan.tables.end(), t) != plan.tables.end()) continue;
    names += (names.empty() ? "" : ", ") + csv_link(t->name);
  }
  if (names.empty()) return {};
  return fmt::format("<p class=\"cut\">In the appendix: {}</p>\n", names);
}

std::string results_html(const Result& r, const PagePlan& plan) {
  const Display display = display_of(r);
  std::string out;
  for (const ResultGroup& group : groups_of(plan)) {
    std::string own = values_html(group.values, {}, r);
    for (const Table* t : group.tables) {
      if (t->name != compared_table) own += table_html(without_detail(*t), display, plan.limits);
    }
    if (!group.heading.empty() && !own.empty()) out += fmt::format("<h3>{}</h3>\n", prose_html(group.heading));
    out += own;
  }
  return out + elsewhere_html(plan);
}

/// The checks of a comparison are the rows of its table.
std::string all_checks_html(const Result& r, const PagePlan& plan) {
  const auto compared =
      std::find_if(plan.tables.begin(), plan.tables.end(), [](const Table* t) { return t->name == compared_table; });
  return compared == plan.tables.end() ? checks_html(r) : table_html(**compared, display_of(r), plan.limits);
}

std::string appendix_html(const Result& r, const PagePlan& plan, FiguresAbove& above) {
  const Display display = display_of(r);
  std::string out = values_html(plan.appendix_values, "Further values", r);
  for (const Table* t : plan.appendix_tables) out += table_html(*t, display, plan.appendix_limits);
  out += defaults_html(r);
  return out + pictures_html(plan.appendix_pictures, r, above);
}

/// Warnings in full, and what page 1 shortens.
std::string notes_html(const Result& r) {
  const std::string texts = full_texts_html(r);
  return list_html(warnings_by_weight(r)) + texts;
}

}  // namespace

std::string overrides_text(const Result& r) {
  return r.overrides.empty() ? "none" : fmt::format("{}", fmt::join(r.overrides, "; "));
}

bool has_exact(const Result& r) {
  return std::any_of(r.comparisons.begin(), r.comparisons.end(),
                     [](const Comparison& c) { return !std::isnan(c.exact); });
}

std::string comparison_title(const Result& r) {
  return has_exact(r) ? "Printed, corrected and exact" : "Printed against corrected";
}

std::vector<Section> sections(const Result& r, const std::vector<const Figure*>& shown) {
  const PagePlan plan = plan_pages(r, shown);
  FiguresAbove above;
  const std::string pictures = pictures_html(plan.pictures, r, above);
  std::vector<Section> all{
      {.id = "errors", .title = "Mistakes in the deck", .html = errors_html(r, r.errors.size()), .numbered = false},
      {.id = "warnings",
       .title = r.warnings.empty() ? "Page 1 in full" : "Warnings",
       .html = notes_html(r),
       .numbered = false},
      {.id = "inputs", .title = "Inputs", .html = given_html(r)},
      {.id = "checks", .title = "Checks", .html = all_checks_html(r, plan)},
      {.id = "comparison", .title = comparison_title(r), .html = comparisons_html(r)},
      {.id = "calculation", .title = "Calculation", .html = steps_html(r)},
      {.id = "results", .title = "Results", .html = results_html(r, plan)},
      {.id = "assumptions", .title = "Assumptions", .html = list_html(r.assumptions)},
      {.id = "pictures", .title = "Pictures", .html = pictures},
      {.id = "appendix", .title = "Appendix", .html = appendix_html(r, plan, above), .numbered = false}};
  std::erase_if(all, [](const Section& s) { return s.html.empty(); });
  return all;
}

}  // namespace taut::report
