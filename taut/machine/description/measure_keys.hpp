#pragma once
#include <optional>
#include <string>

#include "taut/calc/field.hpp"

namespace taut::machine::description {

/// Where a mean is taken: between two times, or while another quantity lies between two values.
struct MeanWindow {
  std::optional<std::string> of;  ///< a path as in `observe`, or a measure; default: the time
  std::string from, to;           ///< with their units
  static const Description& describe();
};

enum class Taken { automatic, mean, end, min, max };
enum class Relative { none, difference, ratio };

/// A quantity of a motion under a name of its own: seen from another body, scaled, shifted, from a time on.
struct Measure {
  std::string name;
  std::string of;                        ///< a path as in `observe`
  std::optional<std::string> seen_from;  ///< a body: places, speeds and rotations in its axes, from its origin
  double factor = 1;
  std::optional<std::string> offset;  ///< added, with its unit
  double since = 0;                   ///< s: what was before does not count for min, max and the reference
  Relative relative = Relative::none;
  std::optional<MeanWindow> mean;
  Taken value = Taken::automatic;
  static const Description& describe();
};

}  // namespace taut::machine::description
