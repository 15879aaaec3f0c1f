#include "taut/report/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/report/sections.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

using Row = std::vector<std::string>;
constexpr int longest_words = 60;
constexpr int most_lines = 38;  ///< of a summary: with the names of the written files 40
constexpr std::size_t most_comparisons = 8;
constexpr int summary_digits = 4, all_digits = 6;
constexpr std::size_t few_answers = 4;  ///< so many have two lines each in a summary

std::string padded(const std::string& text, int width, bool right) {
  const std::string space(static_cast<std::size_t>(std::max(0, width - length(text))), ' ');
  return right ? space + text : text + space;
}

/// Columns as wide as their widest cell, two spaces between, indented by two; `right` says which are right-aligned.
std::string aligned(const std::vector<Row>& rows, const std::vector<bool>& right) {
  std::vector<int> widths(right.size(), 0);
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], length(row[k]));
  }
  std::string out;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (widths[k] > 0) line += (k > 0 ? "  " : " ") + padded(row[k], widths[k], right[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

std::string painted(const std::string& text, Mood mood, const TerminalOptions& o) {
  if (!o.colour || mood == Mood::neutral) return text;
  const char* colour = mood == Mood::good ? "1;32" : mood == Mood::warning ? "1;33" : "1;31";
  return fmt::format("\x1b[{}m{}\x1b[0m", colour, text);
}

std::string hanging(const std::string& first, const std::string& text, int width) {
  const int indent = length(first);
  std::string out = first;
  const auto lines = wrapped(clean(text), std::max(20, width - indent));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) out += std::string(static_cast<std::size_t>(indent), ' ');
    out += lines[i] + "\n";
  }
  return out;
}

std::string head(const Result& r, const TerminalOptions& o) {
  const auto fit = [&](const std::string& text) { return o.all ? text : shortened(clean(text), o.width - 2); };
  std::string out = hanging("", fit(r.title.empty() ? r.method_title : r.title), o.width);
  if (const std::string line = project_line(r.project); !line.empty()) out += hanging("  ", fit(line), o.width);
  if (!r.source.empty()) out += hanging("  ", fit(r.source), o.width);
  if (!r.deck_hash.empty()) {
    out += fmt::format("  deck {}, hash {}, --set {}\n", clean(r.deck_name), clean(r.deck_hash.substr(0, shown_hash)),
                       clean(overrides_text(r)));
  }
  int widest = 0;
  const std::vector<Answer> answers = answers_beside_checks(r);
  for (const Answer& a : answers) widest = std::max(widest, length(clean(a.label)));
  const int lines_each = answers.size() <= few_answers ? 2 : 1;
  for (const Answer& a : answers) {
    const std::string label = clean(a.label);
    const auto gap = static_cast<std::size_t>(widest) + 2 - static_cast<std::size_t>(length(label));
    const int room = lines_each * (o.width - widest - 2) - 12 * (lines_each - 1);  // words are not cut at a line's end
    out += hanging(label + std::string(gap, ' '), o.all ? a.text : shortened(clean(a.text), room), o.width);
  }
  return out;
}

/// The last line: the verdict and its sentence.
std::string verdict_line(const Result& r, const TerminalOptions& o) {
  const Banner v = banner(r);
  std::string out = "\n";
  if (!v.scope.empty()) out += hanging("", o.all ? v.scope : shortened(clean(v.scope), 2 * o.width - 20), o.width);
  return out + painted(v.headline, v.mood, o) + ": " + clean(v.detail) + "\n";
}

std::string words(const std::string& text) { return shortened(clean(text), longest_words); }

/// All warnings, or the gravest of them.
std::string warnings(const Result& r, const TerminalOptions& o) {
  if (r.warnings.empty()) return {};
  std::string out = "\nWarnings\n";
  if (o.all) {
    for (const std::string& w : r.warnings) out += hanging("  ! ", w, o.width);
    return out;
  }
  const std::vector<std::string> all = warnings_by_weight(r);
  const std::size_t shown = std::min(most_summary_warnings, all.size());
  bool cut = false;
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string whole = clean(all[i]);
    cut = cut || length(whole) > longest_summary_warning;
    out += hanging("  ! ", shortened(whole, longest_summary_warning), o.width);
  }
  if (all.size() > shown) return out + fmt::format("  {} more: --all\n", all.size() - shown);
  return cut ? out + "  In full: --all\n" : out;
}

/// The outcome of a check; in a summary that of its part, of which nobody may say that it passes when it has no limit.
std::string outcome_word(const Check& c, const Result& r, const TerminalOptions& o) {
  return !o.all && c.passes && lacks_limit(c, r) ? "not judged" : std::string(outcome_text(c));
}

/// Behind the numbers of a check: what is to be known of its limit, and of its part.
std::string limit_words(const Check& c, const Result& r, const TerminalOptions& o) {
  std::string words = is_unverified(c.trust) ? "limit unverified" : "";
  if (outcome_word(c, r, o) == outcome_text(c)) return words;
  return fmt::format("{}{}{}", words, words.empty() ? "" : ", ", no_limit_of_part);
}

std::string check_lines(const std::vector<const Check*>& checks, const Result& r, const TerminalOptions& o) {
  const Display display = display_of(r);
  std::vector<Row> rows;
  rows.reserve(checks.size());
  for (const Check* check : checks) {
    const Check& c = *check;
    const int digits = digits_apart(c, display, o.all ? all_digits : summary_digits);
    rows.push_back({outcome_word(c, r, o), words(c.name), quantity_plain(c.value, c.unit, display, digits),
                    c.sense == Sense::at_most ? "<=" : ">=", quantity_plain(c.limit, c.unit, display, digits),
                    utilisation_text(c.utilisation), limit_words(c, r, o)});
  }
  std::string text = aligned(rows, {false, false, true, false, true, true, false});
  if (!o.colour) return text;
  std::string out;
  std::size_t at = 0;
  for (const Check* c : checks) {  // colour after the columns are set: escapes have no width
    const std::size_t end = text.find('\n', at) + 1;
    const std::string word = outcome_word(*c, r, o);
    const Mood mood = !c->passes ? Mood::bad : word == outcome_text(*c) ? Mood::good : Mood::neutral;
    out += "  " + painted(word, mood, o) + text.substr(at + 2 + word.size(), end - at - 2 - word.size());
    at = end;
  }
  return out;
}

/// All checks, or the worst of each part.
std::string checks(const Result& r, const TerminalOptions& o) {
  if (r.checks.empty()) return {};
  std::vector<const Check*> shown;
  if (o.all) {
    for (const Check& c : r.checks) shown.push_back(&c);
    return "\nChecks\n" + check_lines(shown, r, o);
  }
  shown = worst_by_part(r);
  shown.resize(std::min(shown.size(), most_summary_rows));
  std::string out = "\nThe worst check of each part\n" + check_lines(shown, r, o);
  if (shown.size() < r.checks.size()) out += fmt::format("  {} more: --all\n", r.checks.size() - shown.size());
  return out;
}

std::string comparison_lines(const Result& r, std::size_t most) {
  if (r.comparisons.empty()) return {};
  const Display display = display_of(r);
  std::vector<Row> rows{{"", "as printed", "corrected", "exact", "", ""}};
  std::vector<Comparison> shown = r.comparisons;
  if (most < shown.size()) {
    std::stable_partition(shown.begin(), shown.end(), [](const Comparison& c) { return c.printed_unsafe; });
    shown.resize(most);
  }
  for (const Comparison& c : shown) {
    const ShownUnit u = shown_unit(c.unit, display);
    const auto number = [&](double x) { return std::isnan(x) ? std::string{} : number_plain(u.of(x)); };
    rows.push_back({words(c.quantity), number(c.printed), number(c.corrected), number(c.exact), u.name,
                    c.printed_unsafe ? "printed value is unsafe" : ""});
  }
  if (!has_exact(r)) rows[0][3].clear();
  return fmt::format("\n{}\n", comparison_title(r)) + aligned(rows, {false, true, true, true, false, false});
}

std::string value_lines(const Result& r, std::size_t most, const TerminalOptions& o) {
  if (most == 0) return {};
  const Display display = display_of(r);
  std::vector<Row> rows;
  for (const Value& v : r.values) {
    if (rows.size() == most) break;
    if (v.detail && !o.all) continue;
    const ShownUnit u = shown_unit(v.unit, display);
    const std::string label = clean(v.label);
    rows.push_back({words(v.name), number_plain(u.of(v.value), o.all ? all_digits : summary_digits), u.name,
                    o.all ? label : shortened(label, longest_words)});
  }
  return "\nResults\n" + aligned(rows, {false, true, false, false});
}

constexpr std::size_t most_table_rows = 8;
constexpr std::size_t most_turned_rows = 3;

std::string cell_text(const Cell& cell, const ShownUnit& u) {
  if (const auto* text = std::get_if<std::string>(&cell)) return words(*text);
  const double x = std::get<double>(cell);
  return std::isnan(x) ? std::string("-") : number_plain(u.of(x));
}

/// A head line with units, then the rows; as columns when `turned`.
std::vector<Row> table_rows(const Table& t, const Display& display, bool turned) {
  std::vector<Row> rows(t.rows.size() + 1);
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    const ShownUnit u = shown_unit(t.columns[k].unit, display);
    rows[0].push_back(u.name.empty() ? t.columns[k].name : fmt::format("{} [{}]", t.columns[k].name, u.name));
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      rows[i + 1].push_back(k < t.rows[i].size() ? cell_text(t.rows[i][k], u) : std::string{});
    }
  }
  if (!turned) return rows;
  std::vector<Row> columns(t.columns.size());
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
  }
  return columns;
}

std::string aligned_table(const std::vector<Row>& rows, bool turned) {
  std::vector<bool> right(rows[0].size(), !turned);
  for (std::size_t k = 0; k < right.size(); ++k) {
    const std::string& first = rows.size() > 1 ? rows[1][k] : rows[0][k];
    const bool number = !first.empty() && first.find_first_not_of("0123456789.-+e") == std::string::npos;
    right[k] = !turned && number;
  }
  return aligned(rows, right);
}

/// The table with rows as rows, or as columns where it is too wide for that; empty when it is too long for either.
std::string short_table(const Table& t, const Display& display, int width) {
  for (const bool turned : {false, true}) {
    if (t.rows.size() > (turned ? most_turned_rows : most_table_rows)) continue;
    const std::string text = aligned_table(table_rows(t, display, turned), turned);
    if (turned || length(text.substr(0, text.find('\n'))) <= width) return text;
  }
  return {};
}

/// Short tables, and where the others are found.
std::string tables(const Result& r, const TerminalOptions& o) {
  const Display display = display_of(r);
  std::string out;
  std::string elsewhere;
  for (const Table& t : r.tables) {
    if (t.rows.empty() || t.columns.empty()) continue;
    const std::string text = short_table(t, display, o.width);
    if (!text.empty()) {
      out += fmt::format("\n{}\n{}", clean(t.title.empty() ? t.name : t.title), text);
    } else {
      elsewhere += fmt::format("{}{} ({} rows)", elsewhere.empty() ? "" : ", ", t.name, t.rows.size());
    }
  }
  if (!elsewhere.empty()) out += "\n" + hanging("In the report and as CSV with -o: ", elsewhere, o.width);
  return out;
}

int lines_of(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

/// What a summary leaves out, and where it is.
std::string hint(const Result& r, std::size_t shown_values, std::size_t shown_comparisons) {
  std::vector<std::string> more;
  const std::size_t comparisons = r.comparisons.size() - std::min(shown_comparisons, r.comparisons.size());
  if (comparisons > 0) more.push_back(fmt::format("{} more comparison{}", comparisons, comparisons == 1 ? "" : "s"));
  if (r.values.size() > shown_values) more.push_back(fmt::format("{} more values", r.values.size() - shown_values));
  if (!r.tables.empty()) more.push_back(fmt::format("{} table{}", r.tables.size(), r.tables.size() == 1 ? "" : "s"));
  if (more.empty()) return {};
  return fmt::format("\nWith --all: {}. With -o DIR: the report and every table as CSV.\n", fmt::join(more, ", "));
}

}  // namespace

std::string to_terminal(const Result& r, const TerminalOptions& o) {
  std::string out = head(r, o) + warnings(r, o) + checks(r, o);
  const std::string end = verdict_line(r, o);
  if (o.all) {
    return out + comparison_lines(r, r.comparisons.size()) + value_lines(r, r.values.size(), o) + tables(r, o) + end;
  }
  constexpr int hint_lines = 2;
  constexpr int heading_lines = 3;  // of a list with the names of its columns
  const auto room = [&] {
    const int left = most_lines - lines_of(out) - lines_of(end) - hint_lines - heading_lines;
    return static_cast<std::size_t>(std::max(0, left));
  };
  const std::size_t compared = std::min(most_comparisons, room());
  if (compared > 0) out += comparison_lines(r, compared);
  const auto main_values = std::count_if(r.values.begin(), r.values.end(), [](const Value& v) { return !v.detail; });
  const std::size_t shown = std::min(static_cast<std::size_t>(main_values), room());
  out += value_lines(r, shown, o) + hint(r, shown, compared);
  return out + end;
}

}  // namespace taut::report
