#include "taut/app/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

constexpr std::size_t most_mistakes = 10;

std::string_view trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r\"");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r\"") - from + 1);
}

/// What separates the cells of a file, by its first line: a comma is part of a number where there is another one.
char separator_of(std::string_view line) {
  for (const char one : {'\t', ';'}) {
    if (line.find(one) != std::string_view::npos) return one;
  }
  return ',';
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

/// A column of the file: which cell of a line, and its unit.
struct TerrainColumn {
  std::size_t cell = 0;
  double metres = 1;  ///< in one unit of it
};

/// The unit behind a column's name: "[m]", "(ft)", "_m" or nothing for metres; none when it is no length.
std::optional<double> metres_of(std::string_view rest) {
  if (rest.empty() || rest == "_m") return 1;
  const bool brackets = (rest.front() == '[' && rest.back() == ']') || (rest.front() == '(' && rest.back() == ')');
  if (!brackets || rest.size() < 3) return std::nullopt;
  const auto factor = unit_factor(trimmed(rest.substr(1, rest.size() - 2)), si::m);
  if (!factor) return std::nullopt;
  return *factor;
}

/// Which cell of the head has one of these names, and a unit of length.
std::optional<TerrainColumn> column_of(const std::vector<std::string_view>& head,
                                       std::initializer_list<std::string_view> names) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    for (const std::string_view name : names) {
      const bool begins = head[i].size() >= name.size() &&
                          std::equal(name.begin(), name.end(), head[i].begin(),
                                     [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b + ('a' - 'A') : b); });
      if (!begins) continue;
      if (const auto metres = metres_of(trimmed(head[i].substr(name.size()))))
        return TerrainColumn{.cell = i, .metres = *metres};
    }
  }
  return std::nullopt;
}

/// Where a line has its cells. With y: of a survey.
struct TerrainColumns {
  std::optional<TerrainColumn> x, y, z;

  bool known() const { return x && z; }
  std::size_t last() const { return std::max({x->cell, z->cell, y ? y->cell : 0}); }
};

TerrainColumns named_columns(const std::vector<std::string_view>& head) {
  TerrainColumns columns{.x = column_of(head, {"x"}), .y = column_of(head, {"y"}), .z = column_of(head, {"z"})};
  if (columns.x && columns.y) return columns;
  columns.y.reset();
  if (!columns.x) columns.x = column_of(head, {"chainage", "station"});
  return columns;
}

/// Of a file without a head, whose first line is numbers already.
TerrainColumns columns_by_count(const std::vector<std::string_view>& cells) {
  if (!std::all_of(cells.begin(), cells.end(), [](std::string_view c) { return parse_number(c).has_value(); }))
    return {};
  if (cells.size() == 2) return {.x = TerrainColumn{.cell = 0}, .y = std::nullopt, .z = TerrainColumn{.cell = 1}};
  if (cells.size() == 3)
    return {.x = TerrainColumn{.cell = 0}, .y = TerrainColumn{.cell = 1}, .z = TerrainColumn{.cell = 2}};
  return {};
}

class TerrainReader {
 public:
  TerrainReader(const std::string& file, machine::description::Terrain& terrain, Diagnostics& mistakes)
      : file_(file), terrain_(terrain), mistakes_(mistakes), before_(mistakes.size()) {}

  void read(std::string_view csv) {
    if (csv.substr(0, 3) == "\xEF\xBB\xBF") csv.remove_prefix(3);
    while (!csv.empty() && mistakes_.size() - before_ < most_mistakes) {
      const auto end = std::min(csv.find('\n'), csv.size());
      line_ = csv.substr(0, end);
      csv.remove_prefix(std::min(end + 1, csv.size()));
      ++number_;
      if (trimmed(line_).empty() || trimmed(line_).front() == '#') continue;
      if (separator_ == 0) separator_ = separator_of(line_);
      if (!take(cells_of(line_, separator_))) return;
    }
    if (mistakes_.size() == before_ && terrain_.x.size() < 2) {
      mistakes_.push_back(
          {file_, {.line = std::max(number_, 1), .column = 1}, "a ground profile has two points at least", {}, 1});
    }
  }

 private:
  void wrong(std::string message) {
    mistakes_.push_back(
        {file_, {.line = number_, .column = 1}, std::move(message), std::string(trimmed(line_).substr(0, 200)), 1});
  }

  /// False where there is no use in reading on.
  bool take(const std::vector<std::string_view>& cells) {
    if (columns_.known()) return take_row(cells), true;
    width_ = cells.size();
    columns_ = named_columns(cells);
    if (columns_.known()) return true;
    columns_ = columns_by_count(cells);
    if (columns_.known()) return take_row(cells), true;
    wrong(
        "the first line names the columns: chainage (or x) and z of a profile, or x, y and z of a survey, in metres, "
        "or with a unit of length as in \"x [ft]\"; without names two columns are chainage and z, three are x, y and "
        "z");
    return false;
  }

  void take_row(const std::vector<std::string_view>& cells) {
    const auto more = cells.begin() + static_cast<std::ptrdiff_t>(std::min(width_, cells.size()));
    const bool too_many = std::any_of(more, cells.end(), [](std::string_view c) { return !c.empty(); });
    if (too_many || cells.size() <= columns_.last())
      return wrong(fmt::format("the line has {} cells, the first one has {}", cells.size(), width_));
    const auto x = number(cells, columns_.x, "x");
    const auto y = number(cells, columns_.y, "y");
    const auto z = number(cells, columns_.z, "z");
    if (!x || !z || (columns_.y && !y)) return;
    if (!columns_.y && !terrain_.x.empty() && *x <= terrain_.x.back()) return wrong("x has to grow from line to line");
    terrain_.x.push_back(*x);
    if (y) terrain_.y.push_back(*y);
    terrain_.z.push_back(*z);
  }

  std::optional<double> number(const std::vector<std::string_view>& cells, const std::optional<TerrainColumn>& column,
                               const char* name) {
    if (!column) return std::nullopt;
    const auto read = parse_number(cells[column->cell]);
    if (read) return *read * column->metres;
    wrong(fmt::format("{}: {}", name, read.error().message));
    return std::nullopt;
  }

  const std::string& file_;
  machine::description::Terrain& terrain_;
  Diagnostics& mistakes_;
  std::size_t before_;
  std::string_view line_;
  int number_ = 0;
  char separator_ = 0;     // 0: not known yet
  std::size_t width_ = 0;  // cells of the first line
  TerrainColumns columns_;
};

}  // namespace

void read_terrain(std::string_view csv, const std::string& file, machine::description::Terrain& terrain,
                  Diagnostics& mistakes) {
  TerrainReader(file, terrain, mistakes).read(csv);
}

std::optional<std::string> survey_warning(const machine::Model& model, const Display& display) {
  const machine::OffLine& off = model.terrain_off_line;
  if (off.rows == 0) return std::nullopt;
  return fmt::format(
      "terrain: {} of the {} rows of the survey {} off the line by more than the corridor, row {} the most, by {} at "
      "{} "
      "along the line; their heights are taken for the ground under the line",
      off.rows, model.terrain.size(), off.rows == 1 ? "is" : "are", off.farthest, display.brief(off.distance, si::m),
      display.brief(off.chainage, si::m));
}

}  // namespace taut::app
