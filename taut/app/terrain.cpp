#include "taut/app/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto end = line.find_first_of(",;\t");
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

/// Which cell of the head is the column of that letter, in metres.
std::optional<std::size_t> column_of(const std::vector<std::string_view>& head, char letter) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    const std::string_view name = head[i];
    if (name.empty() || (name.front() | 0x20) != letter) continue;
    const std::string_view rest = trimmed(name.substr(1));
    if (rest.empty() || rest == "[m]" || rest == "(m)" || rest == "_m") return i;
  }
  return std::nullopt;
}

}  // namespace

void read_terrain(std::string_view csv, const std::string& file, model::description::Terrain& terrain,
                  Diagnostics& mistakes) {
  if (csv.substr(0, 3) == "\xEF\xBB\xBF") csv.remove_prefix(3);
  const std::size_t before = mistakes.size();
  std::optional<std::size_t> x_column, z_column;
  bool has_head = false;
  int number = 0;
  while (!csv.empty() && mistakes.size() - before < most_mistakes) {
    const auto end = std::min(csv.find('\n'), csv.size());
    const std::string_view line = csv.substr(0, end);
    csv.remove_prefix(std::min(end + 1, csv.size()));
    ++number;
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const auto wrong = [&](std::string message) {
      mistakes.push_back({file, {number, 1}, std::move(message), std::string(trimmed(line).substr(0, 200)), 1});
    };
    const auto cells = cells_of(line);
    if (!has_head) {
      has_head = true;
      x_column = column_of(cells, 'x');
      z_column = column_of(cells, 'z');
      if (x_column && z_column) continue;
      wrong("the first line names the columns, among them 'x' and 'z' in metres");
      return;
    }
    if (std::max(*x_column, *z_column) >= cells.size()) {
      wrong(fmt::format("the line has {} cells", cells.size()));
      continue;
    }
    const auto x = parse_number(cells[*x_column]);
    const auto z = parse_number(cells[*z_column]);
    if (!x || !z) {
      wrong(fmt::format("{}: {}", x ? "z" : "x", x ? z.error().message : x.error().message));
    } else if (!terrain.x.empty() && *x <= terrain.x.back()) {
      wrong("x has to grow from line to line");
    } else {
      terrain.x.push_back(*x);
      terrain.z.push_back(*z);
    }
  }
  if (mistakes.size() == before && terrain.x.size() < 2) {
    mistakes.push_back({file, {std::max(number, 1), 1}, "a ground profile has two points at least", {}, 1});
  }
}

}  // namespace taut::app
