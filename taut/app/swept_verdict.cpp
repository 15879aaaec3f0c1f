#include "taut/app/swept_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <utility>
#include <vector>

#include "taut/checks/described.hpp"
#include "taut/results/merge.hpp"

namespace taut::app {
namespace {

constexpr double rounding = 1e-9;  ///< of a number: the same state found once more

/// Whether it is the worse value of a name; a number is worse than none.
bool is_worse(double one, double known, Sense side) {
  if (!std::isfinite(known)) return std::isfinite(one);
  const double by = side == Sense::at_least ? known - one : one - known;
  return by > rounding * std::abs(known);
}

/// One value of each name: the worse one.
void keep_worst(Value one, std::vector<Value>& values) {
  const auto known = std::find_if(values.begin(), values.end(), [&](const Value& v) { return v.name == one.name; });
  if (known == values.end()) {
    values.push_back(std::move(one));
  } else if (is_worse(one.value, known->value, *checks::worst_side(one.name))) {
    *known = std::move(one);
  }
}

/// The largest number of a row in these columns; NaN: none.
double largest_of(const Table& table, const std::vector<Cell>& row, const std::vector<std::string>& columns) {
  double largest = std::nan("");
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double* number = std::get_if<double>(&row[i]);
    if (number != nullptr && std::find(columns.begin(), columns.end(), table.columns[i].name) != columns.end()) {
      largest = std::fmax(largest, *number);
    }
  }
  return largest;
}

/// One row of each part, which the first column names: the worse one.
void keep_worst_rows(const Table& one, std::vector<Table>& tables) {
  const std::vector<std::string> columns = checks::worst_columns(one.name);
  if (columns.empty()) return;
  const auto known = std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return t.name == one.name; });
  if (known == tables.end()) {
    tables.push_back(one);
    return;
  }
  const std::vector<std::string> alone = checks::largest_columns(one.name);
  for (std::vector<Cell> row : one.rows) {
    const auto same = std::find_if(known->rows.begin(), known->rows.end(),
                                   [&](const std::vector<Cell>& other) { return other.front() == row.front(); });
    if (same == known->rows.end()) {
      known->rows.push_back(row);
      continue;
    }
    std::vector<Cell>& kept = *same;
    const bool worse = is_worse(largest_of(one, row, columns), largest_of(*known, kept, columns), Sense::at_most);
    if (worse) std::swap(kept, row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (std::find(alone.begin(), alone.end(), one.columns[i].name) == alone.end()) continue;
      const double *other = std::get_if<double>(&row[i]), *own = std::get_if<double>(&kept[i]);
      if (other != nullptr && (own == nullptr || is_worse(*other, *own, Sense::at_most))) kept[i] = row[i];
    }
  }
}

About about_of(const Result& r, const std::string& sentence) {
  const auto found = r.about.find(sentence);
  return found == r.about.end() ? About{} : found->second;
}

/// Whether a name may have this letter: a number beside one is a part of a name, as in r2 and 6x36.
bool of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Numbers that stand by themselves, "-1.5e+03", are what a sentence has another one of in each state.
std::string without_numbers(const std::string& sentence) {
  static const std::regex number(R"([-+]?\d+(\.\d+)?(e[-+]?\d+)?)");
  std::string kind;
  auto at = sentence.cbegin();
  for (std::sregex_iterator found(at, sentence.cend(), number), none; found != none; ++found) {
    const auto from = sentence.cbegin() + found->position(), to = from + found->length();
    const bool named = (from != sentence.cbegin() && of_name(*(from - 1))) || (to != sentence.cend() && of_name(*to));
    const bool quoted = from != sentence.cbegin() && *(from - 1) == '\'';
    kind.append(at, named || quoted ? to : from);
    at = to;
  }
  return kind.append(at, sentence.cend());
}

}  // namespace

bool SweptVerdict::is_new(const std::string& sentence) { return known_.insert(without_numbers(sentence)).second; }

bool SweptVerdict::is_new(const std::string& kind, const std::string& sentence, const About& about) {
  // what no state loads is one thing, whichever states the sentence names
  return about.no_load.empty()
             ? is_new(fmt::format("{} {} {} {}", kind, static_cast<int>(about.part.kind), about.part.name, sentence))
             : known_.insert(kind + " " + about.no_load).second;
}

void SweptVerdict::take(Result at, const std::string& words) {
  if (at.status != Status::ok) {
    std::string sentence = fmt::format("{}: its checks have no answer: {}", words, at.message);
    if (is_new("no answer")) all_.unmade.push_back(std::move(sentence));
    return;
  }
  for (Check& one : at.checks) {
    if (one.where.empty()) one.where = words;
    all_.checks.push_back(std::move(one));
  }
  for (Value& one : at.values) {
    if (!checks::worst_side(one.name)) continue;
    one.label += fmt::format(", {}", words);
    keep_worst(std::move(one), values_);
  }
  for (const Table& one : at.tables) keep_worst_rows(one, tables_);
  take_warnings(at, words);
  for (std::string& one : at.unmade) {
    const About own = about_of(at, one);
    if (!is_new("unmade", one, own)) continue;
    all_.about.insert_or_assign(one, own);
    all_.unmade.push_back(std::move(one));
  }
  all_.loaded.merge(at.loaded);
  for (std::string& one : at.unjudged) {
    if (is_new("unjudged " + one)) all_.unjudged.push_back(std::move(one));
  }
}

void SweptVerdict::take_warnings(const Result& at, const std::string& words) {
  for (const std::string& one : at.warnings) {
    const bool unsafe = std::find(at.unsafe.begin(), at.unsafe.end(), one) != at.unsafe.end();
    const About own = about_of(at, one);
    if (!is_new(unsafe ? "unsafe" : "warning", one, own)) continue;
    std::string sentence = own.no_load.empty() ? fmt::format("{}: {}", words, one) : one;
    all_.about.insert_or_assign(sentence, own);
    unsafe ? warn_unsafe(all_, std::move(sentence)) : all_.warnings.push_back(std::move(sentence));
  }
}

void SweptVerdict::put_into(Result& r) { results::append(all_, r); }

void SweptVerdict::put_numbers_into(Result& r) && {
  for (Value& one : values_) keep_worst(std::move(one), r.values);
  for (const Table& one : tables_) keep_worst_rows(one, r.tables);
}

}  // namespace taut::app
