#pragma once
#include <optional>
#include <string>

#include "taut/calc/field.hpp"

namespace taut::machine::description {

/// Interval of a mean: between two times, or while another quantity lies between two values.
struct MeanWindow {
  std::optional<std::string> of;  ///< a path as in `observe`, or a measure; default: the time
  std::string from, to;           ///< with their units
  static const Description& describe();
};

enum class Taken { automatic, mean, end, min, max };
enum class Relative { none, difference, ratio };

/// An observed quantity of a motion under its own name: relative to another body, scaled, shifted, or from a given
/// time.
struct Measure {
  std::string name;
  std::string of;                        ///< a path as in `observe`
  std::optional<std::string> seen_from;  ///< a body: places, velocities and rotations relative to its origin and axes
  double factor = 1;
  std::optional<std::string> offset;  ///< added, with its unit
  double since = 0;                   ///< s; earlier values do not count for min, max and the reference value
  Relative relative = Relative::none;
  std::optional<MeanWindow> mean;
  Taken value = Taken::automatic;
  static const Description& describe();
};

}  // namespace taut::machine::description
