#include "taut/catalogue/forestry/yarder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/yarders_csv.hpp"
#include "taut/catalogue/lookup.hpp"

namespace taut::catalogue {
namespace {

// outside of these a number stands in the wrong unit or column
constexpr double least_pull = 1e3, most_pull = 2e6;            // N
constexpr double most_capacity = 1e4;                          // m
constexpr double least_diameter = 4e-3, most_diameter = 0.06;  // of a rope, m

YarderDrum drum_in(CsvReader& csv) {
  YarderDrum drum;
  drum.line = csv.required_text("drum");
  drum.capacity = csv.optional_positive("capacity_m");
  drum.at_diameter = csv.optional_positive("at_diameter_mm");
  drum.core = csv.optional_positive("core_mm");
  drum.flange = csv.optional_positive("flange_mm");
  drum.face = csv.optional_positive("face_mm");
  drum.pull = csv.positive("pull_kN");
  drum.hold = csv.optional_positive("hold_kN");
  drum.speed = csv.optional_positive("speed_m_per_s");
  drum.trust = csv.trust("trust");
  drum.trust_text = csv.text("trust_text");
  return drum;
}

void check_drum(CsvReader& csv, const YarderDrum& drum) {
  if (drum.capacity.has_value() != drum.at_diameter.has_value())
    csv.fail("capacity_m", "a capacity and the diameter of its rope, at_diameter_mm, stand together");
  const int measures = static_cast<int>(drum.core.has_value()) + static_cast<int>(drum.flange.has_value()) +
                       static_cast<int>(drum.face.has_value());
  if (measures != 0 && measures != 3) csv.fail("core_mm", "core_mm, flange_mm and face_mm stand together");
  if (drum.capacity && measures != 0)
    csv.fail("capacity_m", "a drum has a capacity, or core_mm, flange_mm and face_mm: leave out one of the two");
  if (!drum.capacity && measures == 0)
    csv.fail("drum", "a drum needs capacity_m and at_diameter_mm, or core_mm, flange_mm and face_mm");
  if (measures == 3 && *drum.flange <= *drum.core) csv.fail("flange_mm", "flange_mm must be above core_mm");
  if (drum.capacity && *drum.capacity > most_capacity)
    csv.fail("capacity_m", fmt::format("{} m are no rope on a drum: look at the unit", short_number(*drum.capacity)));
  if (drum.at_diameter && (*drum.at_diameter < least_diameter || *drum.at_diameter > most_diameter)) {
    csv.fail("at_diameter_mm",
             fmt::format("{} mm is no diameter of a rope: look at the unit", short_number(*drum.at_diameter * 1e3)));
  }
  if (!csv.text("pull_kN").empty() && (drum.pull < least_pull || drum.pull > most_pull))
    csv.fail("pull_kN", fmt::format("{} kN is no pull of a yarder: look at the unit", short_number(drum.pull / 1e3)));
  if (drum.hold && *drum.hold < drum.pull) csv.fail("hold_kN", "a brake holds at least the pull of its drum");
}

}  // namespace

const YarderDrum* YarderRow::drum_of(std::string_view line) const {
  const auto found = std::find_if(drums.begin(), drums.end(), [&](const auto& drum) { return drum.line == line; });
  return found == drums.end() ? nullptr : &*found;
}

tl::expected<std::vector<YarderRow>, Diagnostics> read_yarders(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file),
                {{.name = "yarder"},
                 {.name = "drum"},
                 {.name = "capacity_m", .required = false},
                 {.name = "at_diameter_mm", .required = false},
                 {.name = "core_mm", .required = false},
                 {.name = "flange_mm", .required = false},
                 {.name = "face_mm", .required = false},
                 {.name = "pull_kN"},
                 {.name = "hold_kN", .required = false},
                 {.name = "speed_m_per_s", .required = false},
                 {.name = "tower_height_m", .required = false},
                 {.name = "trust"},
                 {.name = "trust_text", .required = false}});
  std::vector<YarderRow> rows;
  std::size_t mistakes = 0;
  while (csv.next()) {
    const std::string name = csv.required_text("yarder");
    const auto tower = csv.optional_positive("tower_height_m");
    YarderDrum drum = drum_in(csv);
    if (csv.mistakes() == mistakes) check_drum(csv, drum);
    const std::string wanted = normalised(name);
    const auto known =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return is_named(row.name, wanted); });
    if (known == rows.end()) {
      rows.push_back({.name = name, .tower_height = tower, .drums = {std::move(drum)}});
    } else {
      if (std::next(known) != rows.end())
        csv.fail("yarder", fmt::format("the drums of {} must stand together", in_quotes(name)));
      if (known->drum_of(drum.line) != nullptr)
        csv.fail("drum", fmt::format("{} has a drum {} already", in_quotes(name), in_quotes(drum.line)));
      if (tower && !known->tower_height) known->tower_height = tower;
      known->drums.push_back(std::move(drum));
    }
    mistakes = csv.mistakes();
  }
  if (rows.empty() && !csv.failed()) csv.fail("yarder", "the table has no rows, only the names of its columns");
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<YarderRow>& yarders() {
  static const std::vector<YarderRow> rows = [] {
    auto read = read_yarders(embedded::yarders_csv, "data/yarders/yarders.csv");
    expects(read.has_value(), read ? "" : to_text(read.error()));
    return std::move(*read);
  }();
  return rows;
}

Found<YarderRow> find_yarder(std::string_view name, const std::vector<YarderRow>& table) {
  const std::string wanted = normalised(name);
  std::vector<std::string> names;
  for (const YarderRow& row : table) {
    if (is_named(row.name, wanted)) return row;
    names.push_back(row.name);
  }
  return failure(fmt::format("no yarder {}", in_quotes(name)), nearest_names(name, names, suggested));
}

}  // namespace taut::catalogue
