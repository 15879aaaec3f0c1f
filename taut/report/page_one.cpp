#include "taut/report/page_one.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "taut/base/version.hpp"
#include "taut/calc/answers.hpp"
#include "taut/report/figure/any_figure.hpp"
#include "taut/report/pictures.hpp"
#include "taut/report/sections.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/tables/check_table.hpp"
#include "taut/report/tables/html_table.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

constexpr int longest_title = 150, longest_line = 110, longest_source = 230, longest_reason = 330, longest_scope = 220,
              longest_answer_label = 24, longest_answer_text = taut::longest_answer, longest_caption = 240;
constexpr std::size_t most_answers = 12;
constexpr std::size_t most_errors = 8;
constexpr std::size_t most_table_columns = 7;

std::string_view mood_class(Mood m) {
  switch (m) {
    case Mood::good:
      return "good";
    case Mood::warning:
      return "warning";
    case Mood::bad:
      return "bad";
    case Mood::neutral:
      break;
  }
  return "neutral";
}

std::string short_html(std::string_view text, int most) { return prose_html(shortened(clean(text), most)); }

std::string line_html(std::string_view kind, std::string_view text, int most = longest_line) {
  return text.empty() ? "" : fmt::format("<p class=\"{}\">{}</p>\n", kind, short_html(text, most));
}

std::string head_html(const Result& r) {
  std::string out = fmt::format("<header>\n<h1>{}</h1>\n", escape(shortened(clean(title_of(r)), longest_title)));
  out += line_html("project", project_line(r.project));
  if (title_of(r) != r.method_title) out += line_html("method", r.method_title);
  return out + line_html("source", r.source, longest_source) + "</header>\n";
}

std::string verdict_html(const Result& r) {
  const Banner v = banner(r);
  std::string out = fmt::format("<div class=\"verdict {}\"><p><b>{} {}</b> {}</p>", mood_class(v.mood), v.icon,
                                escape(v.headline), short_html(v.detail, longest_reason));
  if (!v.scope.empty()) out += fmt::format("<p class=\"scope\">{}</p>", short_html(v.scope, longest_scope));
  return out + "</div>\n";
}

std::string answers_html(const Result& r) {
  std::string out;
  const std::vector<Answer> all = answers_beside_checks(r);
  const std::size_t shown = std::min(all.size(), most_answers);
  for (std::size_t i = 0; i < shown; ++i) {
    const Answer& a = all[i];
    const bool again = i > 0 && all[i - 1].label == a.label;
    out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", again ? std::string() : short_html(a.label, longest_answer_label),
                       short_html(a.text, longest_answer_text));
  }
  if (shown < all.size()) out += fmt::format("<dt></dt><dd>{} more below</dd>\n", all.size() - shown);
  return out.empty() ? out : fmt::format("<dl class=\"answers\">\n{}</dl>\n", out);
}

/// Height of an <svg> over its width, as its attributes say; 0 when it has none.
double aspect_of(const std::string& svg) {
  const auto attribute = [&](std::string_view name) {
    const std::size_t at = svg.find(name);
    return at == std::string::npos ? 0.0 : std::strtod(svg.c_str() + at + name.size(), nullptr);
  };
  const double width = attribute(" width=\""), height = attribute(" height=\"");
  return width > 0 ? height / width : 0;
}

/// Without checks: the first results, or the first table.
std::string main_values_html(const Result& r) {
  const Display display = display_of(r);
  std::string rows;
  std::size_t count = 0;
  for (const Value& v : r.values) {
    if (v.detail || count == most_summary_rows) continue;
    ++count;
    rows += "<tr>" + cell(short_html(v.label.empty() ? v.name : v.label, longest_line), "name") +
            cell(escape(value_shown(v.value, v.unit, display)), "num") + "</tr>\n";
  }
  if (!rows.empty()) {
    return fmt::format(
        "<table class=\"worst values\"><thead><tr><th>result</th><th "
        "class=\"num\">value</th></tr></thead><tbody>\n{}</tbody>"
        "</table>\n",
        rows);
  }
  for (const Table& t : r.tables) {
    if (t.detail || t.rows.empty()) continue;
    Table first{.name = t.name, .title = t.title, .columns = t.columns, .rows = t.rows};
    first.columns.resize(std::min(first.columns.size(), most_table_columns));
    return table_html(first, display, {.rows = most_summary_rows, .parts = 1});
  }
  return {};
}

std::string warnings_html(const Result& r) {
  const std::vector<std::string> all = warnings_by_weight(r);
  if (all.empty()) return {};
  const std::size_t shown = std::min(all.size(), most_summary_warnings);
  std::string out;
  for (std::size_t i = 0; i < shown; ++i)
    out += fmt::format("<li>{}</li>\n", short_html(all[i], longest_summary_warning));
  if (shown < all.size()) out += fmt::format("<li class=\"more\">{} more on page 2</li>\n", all.size() - shown);
  return fmt::format("<aside><b>{}</b>\n<ul>\n{}</ul></aside>\n",
                     r.unsafe.empty() ? "Warnings" : "Unsafe or unverified", out);
}

/// Who may sign: only what passes.
std::string signature_html(const Result& r) {
  const auto verdict = verdict_of(r);
  const bool passes =
      verdict && (verdict->kind == VerdictKind::passes || verdict->kind == VerdictKind::passes_with_warnings);
  if (!passes) return fmt::format("<span class=\"unsigned\">{}: not for signature</span>", escape(banner(r).headline));
  return fmt::format("<span class=\"signature\">checked {}<span class=\"rule\"></span></span>",
                     escape(shortened(clean(r.project.checked_by), 40)));
}

std::string foot_html(const Result& r) {
  std::string deck;
  if (!r.deck_name.empty()) deck += fmt::format("deck {}, ", shortened(clean(r.deck_name), 60));
  if (!r.deck_hash.empty()) {
    deck += fmt::format("hash {}, --set {}, ", clean(r.deck_hash.substr(0, shown_hash)),
                        shortened(clean(overrides_text(r)), 80));
  }
  return fmt::format("<div class=\"foot\"><span>{}taut {}</span>{}</div>\n", escape(deck), version, signature_html(r));
}

// Sizes in print, mm, as assets/page.css sets them.
constexpr double title_line = 6.8, text_line = 4.55, small_line = 4.05, table_line = 3.67, table_row = 4.75;
constexpr double block_gap = 2.5, verdict_frame = 11, side_frame = 8.5, side_gap = 1.2, foot_height = 10,
                 caption_height = 4.8;
constexpr double text_character = 1.7, small_character = 1.55, table_character = 1.5;
constexpr double side_share = 0.31;  ///< of the width, for warnings beside the table

/// Lines that a text takes in a room of so many mm.
double lines_in(std::string_view text, int most, double room, double character) {
  if (text.empty()) return 0;
  return std::ceil(std::min(length(text), most) / std::max(1.0, std::floor(room / character)));
}

double table_height(const Result& r) {
  const std::size_t rows = r.checks.empty() ? most_summary_rows : std::min(worst_by_part(r).size(), most_summary_rows);
  return table_row * static_cast<double>(rows + 1);
}

/// Height of the warnings in a column as wide as `room`.
double warnings_height(const Result& r, double room) {
  constexpr double frame_and_bullet = 10;
  const std::vector<std::string> all = warnings_by_weight(r);
  if (all.empty()) return 0;
  double height = side_frame + (all.size() > most_summary_warnings ? table_line : 0);
  for (std::size_t i = 0; i < std::min(all.size(), most_summary_warnings); ++i) {
    height +=
        side_gap + table_line * lines_in(all[i], longest_summary_warning, room - frame_and_bullet, table_character);
  }
  return height;
}

/// How the table and the warnings share the foot of the page.
struct BelowPicture {
  double height = 0;
  bool stacked = false;  ///< the warnings below the table, over the full width
};

BelowPicture below_picture(const Result& r, const PrintedSheet& sheet) {
  const double table = table_height(r), full = warnings_height(r, sheet.width);
  if (full == 0) return {.height = table};
  const double beside = std::max(table, warnings_height(r, side_share * sheet.width));
  const double stacked = table + block_gap + full;
  return stacked < beside ? BelowPicture{.height = stacked, .stacked = true} : BelowPicture{.height = beside};
}

/// Height that the texts of page 1 leave for its pictures, mm, estimated from below.
double room_for_pictures(const Result& r, const PrintedSheet& sheet) {
  constexpr double gaps = 6 * block_gap, reserve = 8, label_width = 26, headline_width = 50, title_character = 2.9;
  const Banner v = banner(r);
  const double inner = sheet.width - 10;
  const double small_lines = lines_in(r.source, longest_source, sheet.width, small_character) +
                             lines_in(project_line(r.project), longest_line, sheet.width, small_character) +
                             (title_of(r) != r.method_title ? 1 : 0) +
                             lines_in(v.scope, longest_scope, inner, small_character);
  const std::string headline(static_cast<std::size_t>(headline_width / text_character), ' ');
  const double detail_lines = lines_in(headline + v.detail, longest_reason, inner, text_character);
  double used = title_line * lines_in(title_of(r), longest_title, sheet.width, title_character) +
                small_line * small_lines + verdict_frame + text_line * (detail_lines - 1);
  const std::vector<Answer> answers = answers_beside_checks(r);
  for (std::size_t i = 0; i < std::min(answers.size(), most_answers); ++i) {
    used += 0.6 + text_line * lines_in(answers[i].text, longest_answer_text, sheet.width - label_width, text_character);
  }
  return sheet.height - gaps - reserve - foot_height - used - below_picture(r, sheet).height;
}

/// The words below a figure of page 1. That of a drawing says which state it shows, and of a machine without an answer
/// that it is none; what else a plot says stands with it on its own page.
std::string words_below(const Figure& figure, const Result& r) {
  const FigureWords w = words_of(figure);
  const std::string title = short_html(w.title, longest_line), caption = short_html(w.caption, longest_caption);
  if (r.status != Status::ok) return fmt::format("<b>{}.</b> {}", title, caption);
  const bool plot = std::holds_alternative<Plot>(figure) || caption.empty();
  return plot ? title : fmt::format("{}. {}", title, caption);
}

/// Lines that they take in print.
double lines_below(const Figure& figure, const Result& r, const PrintedSheet& sheet) {
  const FigureWords w = words_of(figure);
  const bool plot = r.status == Status::ok && std::holds_alternative<Plot>(figure);
  const std::string words = plot ? w.title : w.title + w.caption;
  return lines_in(words + w.scale, longest_line + longest_caption, sheet.width, small_character);
}

/// Adds a figure to page 1; its height in print, mm, 0 when there is nothing to draw.
double add_figure(const Figure& figure, const Result& r, const PrintedSheet& sheet, PageOne& page) {
  const std::string picture = figure_svg(figure, display_of(r));
  if (!picture.starts_with("<svg")) return 0;
  const double aspect = aspect_of(picture);
  page.html += fmt::format(
      "<figure class=\"key\" style=\"flex-grow:{:.0f};--aspect:{:.3f}\"><div class=\"frame\">{}</div>"
      "<figcaption>{} {}</figcaption></figure>\n",
      std::max(1.0, 100 * aspect), aspect, picture, words_below(figure, r), escape(words_of(figure).scale));
  page.figures.push_back(&figure);
  return sheet.width * aspect + caption_height + small_line * (lines_below(figure, r, sheet) - 1) + block_gap;
}

void add_pictures(const Result& r, const PrintedSheet& sheet, PageOne& page) {
  constexpr double least_height = 55, least_second = 58;  // mm
  const Figure* key = key_figure(r);
  const double room = room_for_pictures(r, sheet);
  const double height = key == nullptr || room < least_height ? 0 : add_figure(*key, r, sheet, page);
  if (height == 0) {
    page.html += "<div class=\"room\"></div>\n";
    return;
  }
  if (room - height < least_second) return;
  const auto second = std::find_if(r.figures.begin(), r.figures.end(),
                                   [&](const Figure& f) { return &f != key && std::holds_alternative<Plot>(f); });
  if (second != r.figures.end()) add_figure(*second, r, sheet, page);
}

}  // namespace

std::string title_of(const Result& r) {
  if (!r.title.empty()) return r.title;
  return r.method_title.empty() ? "Calculation" : r.method_title;
}

std::string full_texts_html(const Result& r) {
  std::string out;
  const auto add = [&](std::string_view name, std::string_view text, int most) {
    if (length(clean(text)) > most) out += fmt::format("<p><b>{}</b> {}</p>\n", name, prose_html(text));
  };
  const Banner v = banner(r);
  add("Title:", title_of(r), longest_title);
  add("Project:", project_line(r.project), longest_line);
  add("Method:", r.method_title, longest_line);
  add("Source:", r.source, longest_source);
  add("Verdict:", v.detail, longest_reason);
  add("Scope:", v.scope, longest_scope);
  if (!r.deck_hash.empty()) add("Set over the deck:", overrides_text(r), 80);
  const std::vector<Answer> answers = answers_beside_checks(r);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    add(escape(answers[i].label) + ":", answers[i].text, i < most_answers ? longest_answer_text : 0);
  }
  return out;
}

std::string errors_html(const Result& r, std::size_t most) {
  std::string out;
  for (std::size_t n = 0; n < std::min(most, r.errors.size()); ++n) {
    std::string lines;  // the caret under the mistake needs its line breaks
    const std::string text = to_text(r.errors[n]);
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      lines += escape(text.substr(i, end - i)) + "\n";
      i = end + 1;
    }
    out += fmt::format("<pre>{}</pre>\n", lines);
  }
  return out;
}

PageOne page_one(const Result& r, const PrintedSheet& sheet) {
  PageOne page{.html = "<section class=\"sheet\" id=\"page-1\">\n" + head_html(r) + verdict_html(r), .figures = {}};
  if (!r.errors.empty()) {
    page.html += "<div class=\"mistakes\">\n" + errors_html(r, most_errors);
    if (r.errors.size() > most_errors)
      page.html += fmt::format("<p>{} more below</p>\n", r.errors.size() - most_errors);
    page.html += "</div>\n" + foot_html(r) + "</section>\n";
    return page;
  }
  page.html += answers_html(r);
  add_pictures(r, sheet, page);
  const std::string table = r.checks.empty() ? main_values_html(r) : worst_checks_html(r);
  const std::string warnings = warnings_html(r);
  if (!table.empty() || !warnings.empty()) {
    const char* const kind = warnings.empty() || below_picture(r, sheet).stacked ? " alone" : "";
    page.html += fmt::format("<div class=\"below{}\">\n{}{}</div>\n", kind,
                             table.empty() ? "" : fmt::format("<div class=\"wide\">{}</div>\n", table), warnings);
  }
  page.html += foot_html(r) + "</section>\n";
  return page;
}

}  // namespace taut::report
