#include "taut/catalogue/rope_factor.hpp"

#include <fmt/format.h>

#include "taut/base/expects.hpp"
#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/rope_factors_csv.hpp"

namespace taut::catalogue {

tl::expected<std::vector<RopeFactorRow>, Diagnostics> read_rope_factors(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file),
                {{.name = "construction"},
                 {.name = "core"},
                 {.name = "standard"},
                 {.name = "mass_factor_kg_per_100m_per_mm2"},
                 {.name = "area_factor"},
                 {.name = "breaking_factor"},
                 {.name = "fill_factor"},
                 {.name = "trust"},
                 {.name = "trust_text", .required = false}});
  std::vector<RopeFactorRow> rows;
  while (csv.next()) {
    RopeFactorRow row;
    row.construction = csv.required_text("construction");
    row.core = csv.required_text("core");
    row.standard = csv.required_text("standard");
    row.mass_factor = csv.positive("mass_factor_kg_per_100m_per_mm2");
    row.area_factor = csv.positive("area_factor");
    row.breaking_factor = csv.positive("breaking_factor");
    row.fill_factor = csv.positive("fill_factor");
    row.trust = csv.trust("trust");
    row.trust_text = csv.text("trust_text");
    rows.push_back(std::move(row));
  }
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<RopeFactorRow>& rope_factors() {
  static const std::vector<RopeFactorRow> rows = [] {
    auto read = read_rope_factors(embedded::rope_factors_csv, "data/ropes/rope_factors.csv");
    expects(read.has_value(), read ? "" : to_text(read.error()));
    return std::move(*read);
  }();
  return rows;
}

Found<RopeFactorRow> find_rope_factors(std::string_view construction, std::string_view core) {
  const std::string wanted_core = parse_core(core).value_or(std::string(core));
  std::vector<std::string> names;
  for (const RopeFactorRow& row : rope_factors()) {
    if (row.core == wanted_core && matches_construction(construction, row.construction)) return row;
    names.push_back(fmt::format("{}-{}", row.construction, row.core));
  }
  const std::string name = fmt::format("{}-{}", construction, core);
  return tl::unexpected(
      LookupError{.message = fmt::format("no factors for a rope {}; there are {}", name, listed(names, 30)),
                  .candidates = nearest_names(name, names, 3)});
}

}  // namespace taut::catalogue
