#pragma once
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// Factors of one rope class (EN 12385-4): from a diameter d and a grade R follow
/// area = area_factor d^2, mass per length = mass_factor d^2, breaking force = breaking_factor d^2 R.
struct RopeFactorRow {
  std::string construction;  ///< class: "6x36"
  std::string core;          ///< "FC", "IWRC", "WSC"
  std::string standard;
  double mass_factor = 0.0;      ///< kg/m3: 1e4 times the printed W (kg per 100 m and mm2)
  double area_factor = 0.0;      ///< C, without unit
  double breaking_factor = 0.0;  ///< K, without unit
  double fill_factor = 0.0;      ///< metallic area / circle = 4 C / pi
  Trust trust = Trust::unverified;
  std::string trust_text;
};

/// Reads a table of factors. Columns: construction, core, standard, mass_factor_kg_per_100m_per_mm2, area_factor,
/// breaking_factor, fill_factor, trust, and, if wanted, trust_text.
tl::expected<std::vector<RopeFactorRow>, Diagnostics> read_rope_factors(std::string_view csv, std::string file);

/// The built-in factors (data/ropes/rope_factors.csv).
const std::vector<RopeFactorRow>& rope_factors();

/// The factors of a class and core: "6x36WS" is met by class 6x36, see matches_construction.
Found<RopeFactorRow> find_rope_factors(std::string_view construction, std::string_view core);

}  // namespace taut::catalogue
