#include "taut/catalogue/rope.hpp"

#include <fmt/format.h>

#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/ropes_csv.hpp"
#include "taut/catalogue/lookup.hpp"

namespace taut::catalogue {
namespace {

constexpr double rounding = 1.001;  // tables print 3 to 5 digits
// outside of these a number stands in the wrong unit or column
constexpr double least_density = 5e3, most_density = 2e4;      // mass over metallic area, kg/m3
constexpr double least_strength = 3e8, most_strength = 2.5e9;  // of wires, or breaking force over metallic area, Pa

void check_plausible(CsvReader& csv, const RopeRow& row) {
  const double circle = std::numbers::pi / 4.0 * row.diameter * row.diameter;
  if (row.area > rounding * circle) {
    csv.fail("area_mm2",
             fmt::format("a metallic area of {} mm2 does not fit into a rope of {} mm ({} mm2)",
                         short_number(row.area * 1e6), short_number(row.diameter * 1e3), short_number(circle * 1e6)));
    return;
  }
  const double density = row.mass_per_length / row.area;
  if (density < least_density || density > most_density) {
    csv.fail("mass_kg_per_m",
             fmt::format("{} kg/m on {} mm2 are {} g per m and mm2; wire ropes have 8 to 11: look at the "
                         "units of both",
                         short_number(row.mass_per_length), short_number(row.area * 1e6), short_number(density / 1e3)));
  }
  if (row.grade && (*row.grade < least_strength || *row.grade > most_strength)) {
    csv.fail("grade_MPa", fmt::format("{} MPa is no grade of a rope; wires have 1370 to 2160: look at the unit",
                                      short_number(*row.grade / 1e6)));
    return;
  }
  if (row.grade && row.breaking_force > rounding * row.area * *row.grade) {
    csv.fail("mbf_kN", fmt::format("a breaking force of {} kN is above area x grade = {} kN",
                                   short_number(row.breaking_force / 1e3), short_number(row.area * *row.grade / 1e3)));
    return;
  }
  const double stress = row.breaking_force / row.area;
  if (stress < least_strength || stress > most_strength) {
    csv.fail(
        "mbf_kN",
        fmt::format("a breaking force of {} kN on {} mm2 is {} MPa; steel wire ropes have 800 to 2200: look "
                    "at the units of both",
                    short_number(row.breaking_force / 1e3), short_number(row.area * 1e6), short_number(stress / 1e6)));
  }
}

}  // namespace

tl::expected<std::vector<RopeRow>, Diagnostics> read_ropes(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file),
                {{.name = "id"},
                 {.name = "standard"},
                 {.name = "construction"},
                 {.name = "core"},
                 {.name = "d_mm"},
                 {.name = "area_mm2"},
                 {.name = "mass_kg_per_m"},
                 {.name = "grade_MPa"},
                 {.name = "mbf_kN"},
                 {.name = "trust"},
                 {.name = "area_trust", .required = false},
                 {.name = "price_per_m", .required = false},
                 {.name = "trust_text", .required = false}});
  std::vector<RopeRow> rows;
  std::size_t mistakes = 0;
  while (csv.next()) {
    RopeRow row;
    row.id = csv.unique("id");
    row.standard = csv.required_text("standard");
    row.construction = csv.required_text("construction");
    row.core = csv.text("core");
    row.diameter = csv.positive("d_mm");
    row.area = csv.positive("area_mm2");
    row.mass_per_length = csv.positive("mass_kg_per_m");
    row.grade = csv.optional_positive("grade_MPa");
    row.breaking_force = csv.positive("mbf_kN");
    row.trust = csv.trust("trust");
    row.area_trust = csv.text("area_trust").empty() ? row.trust : csv.trust("area_trust");
    row.trust_text = csv.text("trust_text");
    row.price = csv.optional_positive("price_per_m");
    if (csv.mistakes() == mistakes) check_plausible(csv, row);
    mistakes = csv.mistakes();
    rows.push_back(std::move(row));
  }
  if (rows.empty() && !csv.failed()) csv.fail("id", "the table has no rows, only the names of its columns");
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<RopeRow>& ropes() {
  static const std::vector<RopeRow> rows = [] {
    auto read = read_ropes(embedded::ropes_csv, "data/ropes/ropes.csv");
    expects(read.has_value(), read ? "" : to_text(read.error()));
    return std::move(*read);
  }();
  return rows;
}

}  // namespace taut::catalogue
