#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// One rope in one grade, as a table lists it. SI units.
struct RopeRow {
  std::string id;                   ///< "EN 12385-4|6x36-IWRC|16|1960": standard, construction and core, d in mm, grade
  std::string standard;             ///< "EN 12385-4"
  std::string construction;         ///< "6x36", "6x19(1+6+6/6)", "compacted"
  std::string core;                 ///< "FC", "IWRC", "WSC", or empty when not known
  double diameter = 0.0;            ///< nominal, m
  double area = 0.0;                ///< metallic area, m2; E belongs to this area, never to the circle
  double mass_per_length = 0.0;     ///< kg/m
  std::optional<double> grade;      ///< nominal wire strength, Pa; none for ropes sold without one
  double breaking_force = 0.0;      ///< minimum breaking force, N
  Trust trust = Trust::unverified;  ///< of the breaking force
  Trust area_trust = Trust::unverified;
  std::string trust_text;       ///< where the numbers come from, one sentence
  std::optional<double> price;  ///< per metre, in whatever money
};

/// Reads a table of ropes. Columns: id, standard, construction, core, d_mm, area_mm2, mass_kg_per_m, grade_MPa, mbf_kN,
/// trust, and, if wanted, area_trust (else as trust), price_per_m and trust_text. core and grade_MPa may be empty.
///
/// Beyond what CsvReader checks, refuses a metallic area above that of the circle of d, a breaking force above
/// area x grade, and a mass or a breaking force that no metal of that area has: each is a slip of unit or column.
///
/// @param csv   the table's text
/// @param file  its name in messages
tl::expected<std::vector<RopeRow>, Diagnostics> read_ropes(std::string_view csv, std::string file);

/// The built-in ropes (data/ropes/ropes.csv), in the file's order.
const std::vector<RopeRow>& ropes();

}  // namespace taut::catalogue
