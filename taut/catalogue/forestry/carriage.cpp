#include "taut/catalogue/forestry/carriage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/carriages_csv.hpp"

namespace taut::catalogue {
namespace {

// outside of these a number stands in the wrong unit or column
constexpr double least_mass = 10, most_mass = 1e5;  // kg
constexpr double most_rollers = 16;

double mass_in(CsvReader& csv, const char* column) {
  const double mass = csv.positive(column);
  if (!csv.text(column).empty() && (mass < least_mass || mass > most_mass)) {
    csv.fail(column,
             fmt::format("{} kg is no mass of a carriage or of its load: look at the unit", short_number(mass)));
  }
  return mass;
}

std::optional<int> rollers_in(CsvReader& csv) {
  const auto number = csv.optional_positive("rollers");
  if (!number) return std::nullopt;
  if (*number != std::floor(*number) || *number > most_rollers) {
    csv.fail("rollers", fmt::format("{} is not a number of rollers, 1 to 16", short_number(*number)));
    return std::nullopt;
  }
  return static_cast<int>(*number);
}

}  // namespace

tl::expected<std::vector<CarriageRow>, Diagnostics> read_carriages(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file),
                {{.name = "name"},
                 {.name = "kind", .required = false},
                 {.name = "mass_kg"},
                 {.name = "payload_kg"},
                 {.name = "rope_least_mm", .required = false},
                 {.name = "rope_most_mm", .required = false},
                 {.name = "rollers", .required = false},
                 {.name = "wheelbase_m", .required = false},
                 {.name = "trust"},
                 {.name = "trust_text", .required = false}});
  std::vector<CarriageRow> rows;
  while (csv.next()) {
    CarriageRow row;
    row.name = csv.unique("name");
    row.kind = csv.text("kind");
    row.mass = mass_in(csv, "mass_kg");
    row.payload = mass_in(csv, "payload_kg");
    row.rope_least = csv.optional_positive("rope_least_mm");
    row.rope_most = csv.optional_positive("rope_most_mm");
    if (row.rope_least.has_value() != row.rope_most.has_value())
      csv.fail(row.rope_least ? "rope_most_mm" : "rope_least_mm", "rope_least_mm and rope_most_mm stand together");
    if (row.rope_least && row.rope_most && *row.rope_least > *row.rope_most)
      csv.fail("rope_least_mm", "is above rope_most_mm");
    row.rollers = rollers_in(csv);
    row.wheelbase = csv.optional_positive("wheelbase_m");
    if (row.wheelbase && row.rollers.value_or(1) < 2)
      csv.fail("wheelbase_m", "a wheelbase needs at least two 'rollers'");
    row.trust = csv.trust("trust");
    row.trust_text = csv.text("trust_text");
    rows.push_back(std::move(row));
  }
  if (rows.empty() && !csv.failed()) csv.fail("name", "the table has no rows, only the names of its columns");
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<CarriageRow>& carriages() {
  static const std::vector<CarriageRow> rows = [] {
    auto read = read_carriages(embedded::carriages_csv, "data/carriages/carriages.csv");
    expects(read.has_value(), read ? "" : to_text(read.error()));
    return std::move(*read);
  }();
  return rows;
}

Found<CarriageRow> find_carriage(std::string_view name, const std::vector<CarriageRow>& table) {
  const std::string wanted = normalised(name);
  std::vector<std::string> names;
  for (const CarriageRow& row : table) {
    if (is_named(row.name, wanted)) return row;
    names.push_back(row.name);
  }
  return failure(fmt::format("no carriage {}", in_quotes(name)), nearest_names(name, names, suggested));
}

}  // namespace taut::catalogue
