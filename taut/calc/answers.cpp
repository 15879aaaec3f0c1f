#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "taut/calc/verdict.hpp"

namespace taut {
namespace {

constexpr std::string_view between = "; ";

/// The check with the largest utilisation of each part, the largest first, as in the table of page 1.
std::vector<const Check*> worst_checks(const Result& r) {
  std::vector<const Check*> worst;
  for (const Check& c : r.checks) {
    if (c.refused) continue;
    const auto same = std::find_if(worst.begin(), worst.end(),
                                   [&](const Check* other) { return !c.part.empty() && other->part == c.part; });
    if (same == worst.end()) {
      worst.push_back(&c);
    } else if (severity(c) > severity(**same)) {
      *same = &c;
    }
  }
  std::stable_sort(worst.begin(), worst.end(),
                   [](const Check* a, const Check* b) { return severity(*a) > severity(*b); });
  return worst;
}

/// "skyline.safety_factor 0.72", "mast: strength of CHS 610x25 0.97".
std::string use_words(const Check& c) {
  const bool named = c.part.empty() || c.name.starts_with(c.part + ".") || c.name.ends_with(c.part);
  const std::string number =
      std::isnan(c.utilisation) ? std::string("no number") : fmt::format("{:.3g}", c.utilisation);
  return fmt::format("{}{}{} {}{}", named ? "" : c.part, named ? "" : ": ", c.name, number, c.passes ? "" : " (fails)");
}

/// What comes first on the page.
int rank(const Answer& a) {
  if (a.label == carries_label) return 0;
  if (a.label == build_label || a.label == nearest_label || a.label == needs_label) return 1;
  return a.label == given_label ? 2 : 3;
}

std::string_view settled_label(const std::optional<Verdict>& verdict) {
  if (!verdict) return nearest_label;
  switch (verdict->kind) {
    case VerdictKind::passes:
    case VerdictKind::passes_with_warnings:
      return build_label;
    case VerdictKind::not_judged:
      return given_label;
    case VerdictKind::fails:
    case VerdictKind::no_answer:
      break;
  }
  return nearest_label;
}

const Cell* cell_of(const Table& t, std::size_t row, std::string_view column) {
  const auto at = std::find_if(t.columns.begin(), t.columns.end(), [&](const Column& c) { return c.name == column; });
  const auto k = static_cast<std::size_t>(at - t.columns.begin());
  if (row >= t.rows.size() || k >= t.rows[row].size()) return nullptr;
  return &t.rows[row][k];
}

}  // namespace

void add_answer_line(Result& r, std::string_view label, const std::vector<std::string>& all) {
  constexpr std::size_t room_for_more = 10;
  std::vector<std::string> parts;
  std::copy_if(all.begin(), all.end(), std::back_inserter(parts),
               [](const std::string& part) { return !part.empty(); });
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t room = longest_answer - (i + 1 < parts.size() ? room_for_more : 0);
    if (i > 0 && text.size() + between.size() + parts[i].size() > room) {
      text += fmt::format("{}{} more", between, parts.size() - i);
      break;
    }
    text += (i == 0 ? std::string() : std::string(between)) + parts[i];
  }
  if (!text.empty()) r.answers.push_back({std::string(label), std::move(text)});
}

double number_in(const Table& t, std::size_t row, std::string_view column) {
  const Cell* cell = cell_of(t, row, column);
  const double* number = cell == nullptr ? nullptr : std::get_if<double>(cell);
  return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
}

std::string text_in(const Table& t, std::size_t row, std::string_view column) {
  const Cell* cell = cell_of(t, row, column);
  const std::string* text = cell == nullptr ? nullptr : std::get_if<std::string>(cell);
  return text == nullptr ? std::string() : *text;
}

double number_of(const Result& r, const std::string& value) {
  const Value* found = r.find_value(value);
  return found == nullptr ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

void finish_answers(Result& r) {
  if (r.status == Status::bad_deck) {
    r.answers.clear();
    return;
  }
  const std::string_view settled = settled_label(verdict_of(r));
  for (Answer& a : r.answers) {
    if (a.label == build_label) a.label = settled;
  }
  std::stable_sort(r.answers.begin(), r.answers.end(),
                   [](const Answer& a, const Answer& b) { return rank(a) < rank(b); });
  std::vector<std::string> uses;
  for (const Check* c : worst_checks(r)) uses.push_back(use_words(*c));
  r.answers.resize(std::min(r.answers.size(), most_answers - (uses.empty() ? 0 : 1)));
  add_answer_line(r, uses_label, uses);
}

}  // namespace taut
