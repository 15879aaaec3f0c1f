#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// A carriage as its maker lists it, or a class of carriages. SI units; empty where it is not known.
struct CarriageRow {
  std::string name;                  ///< "LARIX MOKO-25"
  std::string kind;                  ///< "slack-pulling, own diesel engine"
  double mass = 0;                   ///< without load, kg
  double payload = 0;                ///< rated: the largest load, kg
  std::optional<double> rope_least;  ///< diameter of the rope on which it rides, m
  std::optional<double> rope_most;   ///< m
  std::optional<int> rollers;
  std::optional<double> wheelbase;  ///< from the first roller to the last, m
  Trust trust = Trust::unverified;
  std::string trust_text;  ///< where the numbers come from, one sentence
};

/// Reads a table of carriages. Columns: name, mass_kg, payload_kg, trust, and, if wanted, kind, rope_least_mm,
/// rope_most_mm, rollers, wheelbase_m, trust_text; their cells may be empty.
///
/// Beyond what CsvReader checks, refuses a least rope above the largest, rollers that are no whole number from 1 to 16,
/// a wheelbase without at least two rollers, and a mass or a payload outside 10 kg to 100 t.
tl::expected<std::vector<CarriageRow>, Diagnostics> read_carriages(std::string_view csv, std::string file);

/// The built-in carriages (data/carriages/carriages.csv), in the file's order.
const std::vector<CarriageRow>& carriages();

/// The carriage of that name; case and spaces do not count. On failure: the nearest names.
Found<CarriageRow> find_carriage(std::string_view name, const std::vector<CarriageRow>& table = carriages());

}  // namespace taut::catalogue
