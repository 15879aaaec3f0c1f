#pragma once
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::study {

/// How one contact, or with an empty name every one, moves: hoist, lower, in, out, at_rest, or a sign: 1 along the
/// path, -1 against it, 0 at rest.
struct MotionRequest {
  std::string name;
  std::string sense;
  static const Description& describe();
};

/// The options that a motion asks for; complaints at `path`.
solve::EquilibriumOptions options_of(const std::vector<MotionRequest>& motion, const machine::Model& model,
                                     const std::string& path, std::vector<Complaint>& complaints);

/// "at rest", "hoist", "head -1, block 1".
std::string words_of(const std::vector<MotionRequest>& motion);

}  // namespace taut::study
