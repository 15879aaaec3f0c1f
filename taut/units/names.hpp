#pragma once
#include <string_view>
#include <vector>

#include "taut/units/dimension.hpp"

namespace taut {

/// How much one of a unit is in the coherent SI unit: over/under, times pi where it is an angle's. Both are whole
/// numbers below 2^53, so that nothing is rounded before the product of a whole expression is.
struct UnitScale {
  double over = 1;
  double under = 1;
  bool times_pi = false;
  double zero = 0;  ///< what 0 of it is in the SI unit: 273.15 K for degC
};

/// One unit name that a deck may use. The list is our own: others read `ton` as a short ton and `a` as an are.
struct NameRow {
  std::string_view name;
  std::string_view meaning;
  std::string_view kind;
  Dimension dimension;
  bool is_angle = false;
  UnitScale scale = {};
};

/// A name that people mean different things by, with what to write instead.
struct RefusedName {
  std::string_view name;
  std::string_view choices;
};

const std::vector<NameRow>& name_rows();
const std::vector<RefusedName>& refused_names();

}  // namespace taut
