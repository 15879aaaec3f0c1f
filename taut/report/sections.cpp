#include "taut/report/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/quantity.hpp"
#include "taut/report/steps.hpp"
#include "taut/report/svg_drawing.hpp"
#include "taut/report/svg_plot.hpp"
#include "taut/report/symbol.hpp"
#include "taut/report/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

std::string cell(std::string_view inside, std::string_view kind = {}) {
  return kind.empty() ? fmt::format("<td>{}</td>", inside) : fmt::format("<td class=\"{}\">{}</td>", kind, inside);
}

std::string list_html(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& l : lines) out += fmt::format("<li>{}</li>\n", prose_html(l));
  return lines.empty() ? "" : fmt::format("<ul>\n{}</ul>\n", out);
}

std::string errors_html(const Result& r) {
  std::string out;
  for (const Diagnostic& d : r.errors) {
    std::string lines;  // the caret under the mistake needs its line breaks
    const std::string text = to_text(d);
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      lines += escape(text.substr(i, end - i)) + "\n";
      i = end + 1;
    }
    out += fmt::format("<pre>{}</pre>\n", lines);
  }
  return out;
}

std::string caption_html(const std::string& title, const std::string& caption, const std::string& more) {
  std::string out = "<figcaption>";
  if (!title.empty()) out += fmt::format("<b>{}</b> ", prose_html(title));
  if (!caption.empty()) out += prose_html(caption) + " ";
  if (!more.empty()) out += escape(more);
  return out + "</figcaption>";
}

std::string drawings_html(const Result& r) {
  std::string out;
  for (const Figure& f : r.figures) {
    const auto* d = std::get_if<Drawing>(&f);
    if (d == nullptr) continue;
    out += fmt::format("<figure>{}{}</figure>\n", drawing_svg(*d, r.display),
                       caption_html(d->title, d->caption, scale_words(*d)));
  }
  return out;
}

std::string plots_html(const Result& r) {
  std::string out;
  for (const Figure& f : r.figures) {
    const auto* p = std::get_if<Plot>(&f);
    if (p == nullptr) continue;
    const std::string data = p->name.empty() ? "" : fmt::format("Data: {}.csv", p->name);
    out += fmt::format("<figure>{}{}</figure>\n", plot_svg(*p, r.display), caption_html(p->title, p->caption, data));
  }
  return out;
}

std::string comparisons_html(const Result& r) {
  if (r.comparisons.empty()) return {};
  const bool exact =
      std::any_of(r.comparisons.begin(), r.comparisons.end(), [](const Comparison& c) { return !std::isnan(c.exact); });
  std::string rows;
  for (const Comparison& c : r.comparisons) {
    const ShownUnit u = shown_unit(c.unit, r.display);
    const auto number = [&](double x) { return std::isnan(x) ? "–" : escape(number_shown(u.of(x))); };
    const std::string mark = c.printed_unsafe ? " <span class=\"badge bad\">unsafe</span>" : "";
    rows += fmt::format("<tr{}>", c.printed_unsafe ? " class=\"unsafe\"" : "") + cell(symbol_html(c.symbol)) +
            cell(prose_html(c.quantity)) + cell(number(c.printed) + mark, "num") + cell(number(c.corrected), "num") +
            (exact ? cell(number(c.exact), "num") : "") + cell(escape(unit_text(u)), "u") +
            cell(prose_html(c.build_by)) + "</tr>\n";
  }
  return fmt::format(
      "<table><thead><tr><th></th><th>quantity</th><th class=\"num\">as printed</th><th class=\"num\">"
      "corrected</th>{}<th></th><th>build by</th></tr></thead><tbody>\n{}</tbody></table>\n",
      exact ? "<th class=\"num\">exact</th>" : "", rows);
}

std::string values_html(const Result& r) {
  if (r.values.empty()) return {};
  std::string rows;
  for (const Value& v : r.values) {
    const ShownUnit u = shown_unit(v.unit, r.display);
    rows += "<tr>" + cell(symbol_html(v.symbol)) + cell(prose_html(v.label.empty() ? v.name : v.label)) +
            cell(escape(number_shown(u.of(v.value), 6)), "num") + cell(escape(unit_text(u)), "u") +
            cell(escape(v.source), "src") + "</tr>\n";
  }
  return fmt::format(
      "<table><thead><tr><th></th><th>result</th><th class=\"num\">value</th><th></th><th>from</th></tr>"
      "</thead><tbody>\n{}</tbody></table>\n",
      rows);
}

std::string bar_html(const Check& c) {
  const double part = std::isnan(c.utilisation) ? 1 : std::clamp(c.utilisation, 0.0, 1.25) / 1.25;
  return fmt::format(
      "<svg class=\"bar\" width=\"84\" height=\"10\" viewBox=\"0 0 84 10\" aria-hidden=\"true\"><rect "
      "class=\"track\" width=\"84\" height=\"10\"/><rect class=\"{}\" width=\"{:.1f}\" height=\"10\"/>"
      "<path d=\"M67.2 0V10\"/></svg>",
      c.passes ? "good" : "bad", 84 * part);
}

std::string trust_html(const std::string& trust) {
  if (trust.empty()) return {};
  const bool doubt = is_unverified(trust);
  const std::string words = doubt ? "unverified" + trust.substr(std::string_view("unverified").size()) : trust;
  return fmt::format(" <span class=\"badge {}\">{}</span>", doubt ? "doubt" : "calm", escape(words));
}

std::string checks_html(const Result& r) {
  if (r.checks.empty()) return {};
  std::string rows;
  for (const Check& c : r.checks) {
    const ShownUnit u = shown_unit(c.unit, r.display);
    const std::string unit = escape(unit_text(u));
    const auto number = [&](double x) { return escape(number_shown(u.of(x))) + (unit.empty() ? "" : " " + unit); };
    rows += fmt::format("<tr class=\"{}\">", c.passes ? "good" : "bad") + cell(prose_html(c.name)) +
            cell(number(c.value), "num") + cell((c.sense == Sense::at_most ? "≤ " : "≥ ") + number(c.limit), "num") +
            cell(fmt::format("{} {}", bar_html(c), escape(utilisation_text(c.utilisation))), "util") +
            cell(fmt::format("<b>{}</b>", outcome_text(c)), "out") +
            cell(prose_html(c.rule) + trust_html(c.trust), "rule") + "</tr>\n";
  }
  return fmt::format(
      "<table class=\"checks\"><thead><tr><th>check</th><th class=\"num\">value</th><th class=\"num\">"
      "limit</th><th>utilisation</th><th></th><th>rule, trust of the limit</th></tr></thead><tbody>\n{}"
      "</tbody></table>\n",
      rows);
}

std::string given_value(const Given& g, const Display& display) {
  if (g.numbers.empty()) return escape(g.text.empty() ? "–" : g.text);
  if (g.numbers.size() == 1) return escape(quantity_shown(g.numbers[0], g.unit, display, 6));
  constexpr std::size_t most = 12;
  const ShownUnit u = shown_unit(g.unit, display);
  std::string out;
  for (std::size_t i = 0; i < std::min(most, g.numbers.size()); ++i) {
    if (i > 0) out += ", ";
    out += number_shown(u.of(g.numbers[i]), 6);
  }
  if (g.numbers.size() > most) out += fmt::format(", … ({} values)", g.numbers.size());
  const std::string unit = unit_text(u);
  return escape(unit.empty() ? out : fmt::format("{} {}", out, unit));
}

std::string given_html(const Result& r) {
  if (r.given.empty()) return {};
  std::string rows;
  for (const Given& g : r.given) {
    rows += fmt::format("<tr{}>", g.is_default ? " class=\"default\"" : "") + cell(symbol_html(g.symbol)) +
            cell(prose_html(g.words)) + cell(given_value(g, r.display), "val") +
            cell(fmt::format("<code>{}</code>", escape(g.key))) + cell(g.is_default ? "default" : "given", "src") +
            "</tr>\n";
  }
  return fmt::format(
      "<table><thead><tr><th></th><th>quantity</th><th class=\"val\">value</th><th>key in the deck</th>"
      "<th></th></tr></thead><tbody>\n{}</tbody></table>\n",
      rows);
}

bool is_number_column(const Table& t, std::size_t k) {
  return std::any_of(t.rows.begin(), t.rows.end(),
                     [&](const auto& row) { return k < row.size() && std::holds_alternative<double>(row[k]); });
}

/// Which rows to show: all, or the first ones and the last few with a gap.
std::vector<std::size_t> shown_rows(const Table& t) {
  constexpr std::size_t last = 10;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (t.rows.size() <= most_rows || i < most_rows - last || i + last >= t.rows.size()) all.push_back(i);
  }
  return all;
}

/// Cells of one column, in the order of `rows`.
std::vector<std::string> column_cells(const Table& t, std::size_t k, const std::vector<std::size_t>& rows,
                                      const Display& display) {
  const ShownUnit u = shown_unit(t.columns[k].unit, display);
  std::vector<double> numbers;
  for (const std::size_t i : rows) {
    const auto* x = k < t.rows[i].size() ? std::get_if<double>(&t.rows[i][k]) : nullptr;
    numbers.push_back(x == nullptr ? NAN : u.of(*x));
  }
  const std::vector<std::string> shown = column_shown(numbers);
  std::vector<std::string> cells;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const auto& row = t.rows[rows[n]];
    const auto* words = k < row.size() ? std::get_if<std::string>(&row[k]) : nullptr;
    cells.push_back(words == nullptr ? cell(escape(shown[n]), "num") : cell(prose_html(*words)));
  }
  return cells;
}

std::string table_html(const Table& t, const Display& display) {
  const auto rows = shown_rows(t);
  std::string head;
  std::vector<std::vector<std::string>> columns;
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    const std::string unit = unit_text(shown_unit(t.columns[k].unit, display));
    const std::string name = to_html(label_runs(t.columns[k].name));
    head += fmt::format("<th{}>{}{}</th>", is_number_column(t, k) ? " class=\"num\"" : "", name,
                        unit.empty() ? "" : fmt::format("<br><span class=\"u\">{}</span>", escape(unit)));
    columns.push_back(column_cells(t, k, rows, display));
  }
  std::string body;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (n > 0 && rows[n] != rows[n - 1] + 1) {
      body += fmt::format("<tr class=\"gap\"><td colspan=\"{}\">… {} rows left out …</td></tr>\n", t.columns.size(),
                          t.rows.size() - rows.size());
    }
    body += "<tr>";
    for (const auto& column : columns) body += column[n];
    body += "</tr>\n";
  }
  const std::string cut = rows.size() == t.rows.size()
                              ? ""
                              : fmt::format("<p class=\"cut\">{} of {} rows are shown; {}.csv has all of them.</p>\n",
                                            rows.size(), t.rows.size(), escape(t.name));
  return fmt::format(
      "<div class=\"wide\"><table class=\"{}\"><caption>{}</caption><thead><tr>{}</tr></thead><tbody>\n"
      "{}</tbody></table></div>\n{}",
      t.columns.size() > 8 ? "dense" : "data", prose_html(t.title.empty() ? t.name : t.title), head, body, cut);
}

std::string tables_html(const Result& r) {
  std::string out;
  for (const Table& t : r.tables) {
    if (t.name == "comparison" && !r.comparisons.empty()) continue;  // shown above, with its marks
    if (!t.columns.empty()) out += table_html(t, r.display);
  }
  return out;
}

}  // namespace

std::vector<Section> sections(const Result& r) {
  std::vector<Section> all{{"errors", "Mistakes in the deck", errors_html(r)},
                           {"warnings", "Warnings", list_html(r.warnings)},
                           {"drawings", "Drawings", drawings_html(r)},
                           {"comparison", "Printed, corrected, exact", comparisons_html(r)},
                           {"results", "Results", values_html(r)},
                           {"checks", "Checks", checks_html(r)},
                           {"given", "Given", given_html(r)},
                           {"calculation", "Calculation", steps_html(r)},
                           {"plots", "Plots", plots_html(r)},
                           {"tables", "Tables", tables_html(r)},
                           {"assumptions", "Assumptions", list_html(r.assumptions)}};
  std::erase_if(all, [](const Section& s) { return s.html.empty(); });
  return all;
}

}  // namespace taut::report
