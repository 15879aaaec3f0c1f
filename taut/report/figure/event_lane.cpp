#include "taut/report/figure/event_lane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>

#include "taut/report/figure/text_width.hpp"

namespace taut::report {
namespace {

constexpr double lane_gap = 8;
constexpr int most_word_rows = 2;
constexpr double number_gap = 4;

/// "slack skyline (39)" without its number, and the number; none: the words end otherwise.
struct Counted {
  Runs words;
  std::optional<int> number;
};

Counted counted(const Runs& runs) {
  Counted c{.words = runs, .number = {}};
  if (runs.empty()) return c;
  std::string& last = c.words.back().text;
  const std::size_t open = last.rfind(" (");
  if (open == std::string::npos || !last.ends_with(')')) return c;
  int number = 0;
  const char* const end = last.data() + last.size() - 1;
  const auto read = std::from_chars(last.data() + open + 2, end, number);
  if (read.ec != std::errc() || read.ptr != end) return c;
  last.erase(open);
  c.number = number;
  return c;
}

bool are_same(const Runs& a, const Runs& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Run& x, const Run& y) { return x.text == y.text && x.style == y.style; });
}

/// What happens at one moment: "a, b"; of parts that follow each other by number the first and the last, "a (31 to
/// 39)".
Runs together(const std::vector<Runs>& all) {
  Runs out;
  for (std::size_t i = 0; i < all.size();) {
    const Counted first = counted(all[i]);
    std::size_t next = i + 1;
    int low = first.number.value_or(0), high = low;
    while (first.number && next < all.size()) {
      const Counted other = counted(all[next]);
      if (!other.number || !are_same(other.words, first.words)) break;
      if (*other.number != low - 1 && *other.number != high + 1) break;
      low = std::min(low, *other.number);
      high = std::max(high, *other.number);
      ++next;
    }
    if (!out.empty()) out.push_back({.text = ", ", .style = Run::Style::plain});
    const bool many = next > i + 1;
    out.insert(out.end(), (many ? first.words : all[i]).begin(), (many ? first.words : all[i]).end());
    if (many) out.push_back({.text = fmt::format(" ({} to {})", low, high), .style = Run::Style::plain});
    i = next;
  }
  return out;
}

/// Words in rows, each centered on its mark or moved to the edge; false when there is no room.
bool put_words(Lane& lane, const std::vector<LaneMark>& marks, double low, double high, double font_size) {
  std::vector<double> end(most_word_rows, -HUGE_VAL);
  for (const LaneMark& m : marks) {
    const double wide = text_width(m.runs, font_size);
    if (wide > high - low) return false;
    const double center = std::clamp(m.at, low + wide / 2, high - wide / 2);
    int row = 0;
    while (row < most_word_rows && center - wide / 2 < end[static_cast<std::size_t>(row)] + lane_gap) ++row;
    if (row == most_word_rows) return false;
    end[static_cast<std::size_t>(row)] = center + wide / 2;
    lane.names.push_back(
        {.runs = m.runs, .center = center, .wide = wide, .row = row, .is_number = false, .mark = m.at});
    lane.rows = std::max(lane.rows, row + 1);
  }
  // a line from the second row must not run through a word of the first
  for (const Lane::Name& upper : lane.names) {
    for (const Lane::Name& lower : lane.names) {
      if (upper.row > lower.row && std::abs(upper.mark - lower.center) < lower.wide / 2 + 2) return false;
    }
  }
  return true;
}

void put_numbers(Lane& lane, const std::vector<LaneMark>& marks, double low, double high, double font_size) {
  std::vector<double> at, wide;
  std::vector<std::vector<Runs>> at_once;
  for (const LaneMark& m : marks) {
    if (!at.empty() && m.at - at.back() < 1) {
      at_once.back().push_back(m.runs);
      continue;
    }
    const std::string when = m.when.empty() ? "" : m.when + ": ";
    lane.list.push_back(
        {.number = static_cast<int>(lane.list.size()) + 1, .runs = {{.text = when, .style = Run::Style::plain}}});
    at_once.push_back({m.runs});
    at.push_back(m.at);
    wide.push_back(text_width(fmt::format("{}", lane.list.size()), font_size) + 7);
  }
  for (std::size_t i = 0; i < at_once.size(); ++i) {
    const Runs words = together(at_once[i]);
    lane.list[i].runs.insert(lane.list[i].runs.end(), words.begin(), words.end());
  }
  const double all = std::accumulate(wide.begin(), wide.end(), 0.0) + number_gap * static_cast<double>(wide.size());
  lane.rows = std::max(1, static_cast<int>(std::ceil(all / (high - low))));
  for (int row = 0; row < lane.rows; ++row) {
    std::vector<double> row_at, row_wide;
    std::vector<std::size_t> which;
    for (auto i = static_cast<std::size_t>(row); i < at.size(); i += static_cast<std::size_t>(lane.rows)) {
      which.push_back(i);
      row_at.push_back(at[i]);
      row_wide.push_back(wide[i]);
    }
    const std::vector<double> centers = spread(row_at, row_wide, number_gap, low, high);
    for (std::size_t k = 0; k < which.size(); ++k) {
      lane.names.push_back({.runs = {{.text = fmt::format("{}", which[k] + 1), .style = Run::Style::plain}},
                            .center = centers[k],
                            .wide = row_wide[k],
                            .row = row,
                            .is_number = true,
                            .mark = row_at[k]});
    }
  }
}

}  // namespace

std::vector<double> spread(const std::vector<double>& centers, const std::vector<double>& wide, double gap, double low,
                           double high) {
  std::vector<double> at = centers;
  if (at.empty()) return at;
  const std::size_t n = at.size();
  double needed = gap * static_cast<double>(n - 1);
  for (const double w : wide) needed += w;
  const double between = needed > high - low ? gap - (needed - (high - low)) / std::max<double>(1, double(n) - 1) : gap;
  double least = low;
  for (std::size_t i = 0; i < n; ++i) {
    at[i] = std::max(at[i], least + wide[i] / 2);
    least = at[i] + wide[i] / 2 + between;
  }
  double most = high;
  for (std::size_t i = n; i-- > 0;) {
    at[i] = std::min(at[i], most - wide[i] / 2);
    most = at[i] - wide[i] / 2 - between;
  }
  return at;
}

Lane lane_of(std::vector<LaneMark> marks, double low, double high, double font_size) {
  std::stable_sort(marks.begin(), marks.end(), [](const LaneMark& a, const LaneMark& b) { return a.at < b.at; });
  Lane words;
  if (put_words(words, marks, low, high, font_size)) return words;
  Lane numbers;
  put_numbers(numbers, marks, low, high, font_size);
  return numbers;
}

}  // namespace taut::report
