#include "taut/report/tables/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace taut::report {
namespace {

/// Rows chosen so far: those that have to stay, and others up to `most`.
struct Chosen {
  std::size_t most;
  std::set<std::size_t> rows = {};

  bool full() const { return rows.size() >= most; }
  void keep(std::size_t row) { rows.insert(row); }
  void add(std::size_t row) {
    if (!full()) rows.insert(row);
  }
};

const std::string* words_in(const Table& t, std::size_t row, std::size_t column) {
  return column < t.rows[row].size() ? std::get_if<std::string>(&t.rows[row][column]) : nullptr;
}

/// The rows at which a text becomes another one. Where every row has another text, none: it is a list of names.
std::vector<std::size_t> changes(const Table& t, std::size_t column) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 1; i < t.rows.size(); ++i) {
    const std::string* before = words_in(t, i - 1, column);
    const std::string* now = words_in(t, i, column);
    if (before != nullptr && now != nullptr && *before != *now) rows.push_back(i);
  }
  if (2 * rows.size() > t.rows.size()) rows.clear();
  return rows;
}

void keep_extremes(const Table& t, std::size_t column, Chosen& chosen) {
  std::size_t least = t.rows.size(), largest = t.rows.size();
  const auto number = [&](std::size_t row) { return std::get<double>(t.rows[row][column]); };
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (column >= t.rows[i].size()) continue;
    const auto* x = std::get_if<double>(&t.rows[i][column]);
    if (x == nullptr || std::isnan(*x)) continue;
    if (least == t.rows.size() || *x < number(least)) least = i;
    if (largest == t.rows.size() || *x > number(largest)) largest = i;
  }
  if (least == t.rows.size() || number(least) == number(largest)) return;
  chosen.keep(largest);
  chosen.keep(least);
}

/// Halves the widest gap until enough rows are there.
void fill_gaps(Chosen& chosen) {
  while (!chosen.full()) {
    std::size_t widest = 1, middle = 0;
    for (auto at = chosen.rows.begin(); std::next(at) != chosen.rows.end(); ++at) {
      const std::size_t gap = *std::next(at) - *at;
      if (gap > widest) {
        widest = gap;
        middle = *at + gap / 2;
      }
    }
    if (widest == 1) return;
    chosen.add(middle);
  }
}

}  // namespace

std::vector<std::size_t> rows_that_matter(const Table& t, std::size_t most) {
  const std::size_t count = t.rows.size();
  Chosen chosen{.most = std::max<std::size_t>(most, 2)};
  if (count <= chosen.most) {
    for (std::size_t i = 0; i < count; ++i) chosen.rows.insert(i);
    return {chosen.rows.begin(), chosen.rows.end()};
  }
  chosen.keep(0);
  chosen.keep(count - 1);
  for (std::size_t k = 0; k < t.columns.size(); ++k) keep_extremes(t, k, chosen);
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    for (const std::size_t row : changes(t, k)) {
      chosen.add(row - 1);
      chosen.add(row);
    }
  }
  fill_gaps(chosen);
  return {chosen.rows.begin(), chosen.rows.end()};
}

bool is_list(const Table& t) {
  std::set<std::string_view> names;
  return std::all_of(t.rows.begin(), t.rows.end(), [&](const auto& row) {
    const auto* words = row.empty() ? nullptr : std::get_if<std::string>(&row[0]);
    return words != nullptr && !words->empty() && names.insert(*words).second;
  });
}

}  // namespace taut::report
