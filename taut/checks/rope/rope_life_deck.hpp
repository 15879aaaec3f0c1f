#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

namespace taut::checks {

/// What a rope does so often in the life that is wanted of it.
struct DutyRequest {
  std::string name;
  double cycles = 0;
  double load = 1;                ///< share of the largest tension at each round
  std::vector<std::string> over;  ///< rounds that bend the rope in it; empty: all
  static const Description& describe();
};

enum class LifeCount { mean_break, break_10, discard, discard_10 };

/// The user's own constants of Feyrer's equation.
struct LifeConstantsRequest {
  LifeCount count = LifeCount::mean_break;
  std::vector<double> a;
  static const Description& describe();
};

struct LifeRequest {
  std::vector<LifeConstantsRequest> constants;
  std::optional<double> bent_length;  ///< m
  std::optional<double> core_factor;  ///< f_C
  std::optional<double> reverse_weight;
  std::optional<double> donandt_force;  ///< N
  static const Description& describe();
};

}  // namespace taut::checks
