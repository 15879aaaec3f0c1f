#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/rope.hpp"

namespace taut::catalogue {

/// Which ropes are wanted. What is left empty does not count. SI units.
struct RopeFilter {
  std::string construction;     ///< "6x36", "6x36WS", "6x36-IWRC": see matches_construction; a core in it counts too
  std::string core;             ///< "FC", "IWRC", "WSC" and their other names, see parse_core
  std::string standard;         ///< the beginning of its name: "EN", "GOST", "EN 12385-4"; case and spaces do not count
  std::optional<double> grade;  ///< Pa, within 0.5 MPa
  std::optional<double> min_breaking_force;  ///< N
  std::optional<double> min_diameter;        ///< m
  std::optional<double> max_diameter;        ///< m
  std::optional<double> min_area;            ///< m2
  Trust min_trust = Trust::unverified;       ///< the breaking force is trusted so far or better
};

bool matches(const RopeRow& row, const RopeFilter& filter);

/// The ropes of `table` that match, in the table's order.
std::vector<RopeRow> select_ropes(const RopeFilter& filter, const std::vector<RopeRow>& table = ropes());

/// What "the smallest rope" is.
enum class RopeOrder { breaking_force, diameter, area, mass };

/// The ropes that match, smallest first: candidates for "the smallest that passes", where the check is the caller's.
/// Equal ones follow in the order of diameter, area, breaking force, trust (better first), id: the order of `table`
/// does not count.
std::vector<RopeRow> ropes_by(RopeOrder order, const RopeFilter& filter, const std::vector<RopeRow>& table = ropes());

/// The row of the table with that id; case, spaces and the sign between numbers do not count. Null: none.
const RopeRow* rope_of_id(std::string_view id, const std::vector<RopeRow>& table = ropes());

/// A copy of it. On failure: the nearest ids.
Found<RopeRow> find_rope(std::string_view id, const std::vector<RopeRow>& table = ropes());

/// A rope by its properties, as a deck gives it: {construction: 6x36, core: IWRC, diameter: 16 mm, grade: 1960 MPa}.
struct RopeDescription {
  std::string construction;
  std::string core;             ///< may be empty when one core only is listed
  double diameter = 0.0;        ///< m
  std::optional<double> grade;  ///< Pa; may be left out when one grade only is listed
  std::string standard;         ///< may be empty; needed when two standards list the same rope
};

/// The one rope of that description. A row whose construction is written exactly as asked goes before one that only
/// belongs to its class. On failure the message says which property is to blame and what there is instead
/// (constructions, cores, nearest diameters, grades), and the candidates are ids.
Found<RopeRow> find_rope(const RopeDescription& wanted, const std::vector<RopeRow>& table = ropes());

}  // namespace taut::catalogue
