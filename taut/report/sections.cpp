#include "taut/report/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/report/figure/animation.hpp"
#include "taut/report/figure/svg_drawing.hpp"
#include "taut/report/figure/svg_plot.hpp"
#include "taut/report/figure/svg_profile.hpp"
#include "taut/report/given.hpp"
#include "taut/report/html_table.hpp"
#include "taut/report/steps.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

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
  const Display display = display_of(r);
  std::string out;
  for (const Figure& f : r.figures) {
    const auto* d = std::get_if<Drawing>(&f);
    if (d == nullptr) continue;
    out += fmt::format("<figure>{}{}</figure>\n", drawing_svg(*d, display),
                       caption_html(d->title, d->caption, scale_words(*d)));
  }
  return out;
}

/// Each on a page of its own, turned, in print.
std::string profiles_html(const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const Figure& f : r.figures) {
    const auto* p = std::get_if<Profile>(&f);
    if (p == nullptr) continue;
    out += fmt::format("<figure class=\"landscape\">{}{}</figure>\n", profile_svg(*p, display, turned_width),
                       caption_html(p->title, p->caption,
                                    profile_scale_words(*p, turned_width) + fmt::format(" Data: {}.csv", p->name)));
  }
  return out;
}

std::string animations_html(const Result& r) {
  const Display display = display_of(r);
  std::string out;
  int number = 0;
  for (const Figure& f : r.figures) {
    const auto* a = std::get_if<Animation>(&f);
    const std::string moving = a == nullptr ? std::string{} : animation_html(*a, display, number);
    if (moving.empty()) continue;
    ++number;
    out += fmt::format("<figure>{}{}</figure>\n", moving, caption_html(a->title, a->caption, {}));
  }
  return out;
}

std::string plots_html(const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const Figure& f : r.figures) {
    const auto* p = std::get_if<Plot>(&f);
    if (p == nullptr) continue;
    const std::string data = p->name.empty() ? "" : fmt::format("Data: {}.csv", p->name);
    out += fmt::format("<figure>{}{}</figure>\n", plot_svg(*p, display), caption_html(p->title, p->caption, data));
  }
  return out;
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
      "<table><thead><tr><th></th><th>quantity</th><th class=\"num short\">as printed</th><th class=\"num\">"
      "corrected</th>{}<th></th><th>build by</th></tr></thead><tbody>\n{}</tbody></table>\n",
      exact ? "<th class=\"num\">exact</th>" : "", rows);
}

std::string values_html(const Result& r) {
  const Display display = display_of(r);
  if (r.values.empty()) return {};
  std::string rows;
  for (const Value& v : r.values) {
    const ShownUnit u = shown_unit(v.unit, display);
    rows += "<tr>" + cell(symbol_html(v.symbol)) + cell(prose_html(v.label.empty() ? v.name : v.label)) +
            cell(escape(number_shown(u.of(v.value), 6)), "num") + cell(escape(unit_text(u)), "u") +
            cell(prose_html(v.source), length(v.source) <= 24 ? "src short" : "src") + "</tr>\n";
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
  const Display display = display_of(r);
  if (r.checks.empty()) return {};
  std::string rows;
  const std::string* part = nullptr;
  const bool parts = std::any_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return !c.part.empty(); });
  for (const Check& c : r.checks) {
    if (parts && (part == nullptr || *part != c.part)) {
      rows += fmt::format("<tr class=\"part\"><th colspan=\"6\">{}</th></tr>\n",
                          c.part.empty() ? "General" : escape(c.part));
    }
    part = &c.part;
    const ShownUnit u = shown_unit(c.unit, display);
    const std::string unit = escape(unit_text(u));
    const auto number = [&](double x) { return escape(number_shown(u.of(x))) + (unit.empty() ? "" : " " + unit); };
    rows += fmt::format("<tr class=\"{}\">", c.passes ? "good" : "bad") + cell(prose_html(name_below_part(c))) +
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

std::string tables_html(const Result& r) {
  const Display display = display_of(r);
  std::string out;
  for (const Table& t : r.tables) {
    if (t.name == "comparison" && !r.comparisons.empty()) continue;  // shown above, with its marks
    if (!t.columns.empty()) out += table_html(t, display);
  }
  return out;
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

std::vector<Section> sections(const Result& r) {
  std::vector<Section> all{{.id = "errors", .title = "Mistakes in the deck", .html = errors_html(r)},
                           {.id = "warnings", .title = "Warnings", .html = list_html(r.warnings)},
                           {.id = "profiles", .title = "Profile of the line", .html = profiles_html(r)},
                           {.id = "drawings", .title = "Drawings", .html = drawings_html(r)},
                           {.id = "animation", .title = "Motion", .html = animations_html(r)},
                           {.id = "comparison", .title = comparison_title(r), .html = comparisons_html(r)},
                           {.id = "results", .title = "Results", .html = values_html(r)},
                           {.id = "checks", .title = "Checks", .html = checks_html(r)},
                           {.id = "given", .title = "Given", .html = given_html(r)},
                           {.id = "calculation", .title = "Calculation", .html = steps_html(r)},
                           {.id = "plots", .title = "Plots", .html = plots_html(r)},
                           {.id = "tables", .title = "Tables", .html = tables_html(r)},
                           {.id = "assumptions", .title = "Assumptions", .html = list_html(r.assumptions)}};
  std::erase_if(all, [](const Section& s) { return s.html.empty(); });
  return all;
}

}  // namespace taut::report
