#pragma once
#include <string_view>
#include <vector>

#include "taut/units/dimension.hpp"

namespace taut {

/// One unit name that a deck may use: our own list stands before UDUNITS, which reads `ton` as a short ton and `a` as
/// an are.
struct NameRow {
  std::string_view name;
  std::string_view udunits;  ///< the same unit in UDUNITS-2 spelling
  std::string_view meaning;
  std::string_view kind;
  Dimension dimension;
  bool is_angle = false;
};

/// A name that people mean different things by, with what to write instead.
struct RefusedName {
  std::string_view name;
  std::string_view choices;
};

const std::vector<NameRow>& name_rows();
const std::vector<RefusedName>& refused_names();

}  // namespace taut
