#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

namespace taut::checks {

/// What is checked of a tree that carries a line: a spar, a tail tree, an intermediate support; by the name of the
/// saddle or sheave on it.
struct SupportCheckRequest {
  std::string name;
  std::optional<double> tree_diameter;  ///< at breast height, m
  std::optional<double> height;         ///< of the saddle over the ground, m; default: from the terrain
  double lashing = 3;                   ///< of the lashing above the saddle, m
  std::vector<std::string> with;        ///< other sheaves on the same tree, and points of it at which ropes end
  double dynamic_factor = 1;
  static const Description& describe();
};

}  // namespace taut::checks
