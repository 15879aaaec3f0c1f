#pragma once
#include <string>
#include <variant>
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

/// How the ropes of a machine run in a state. The default: at rest.
struct RopeMotion {
  /// Of a rope or of one contact; with an empty name of all. A sign: the flow through the contact, along its path.
  struct Part {
    std::string name;
    std::variant<solve::Motion, int> sense;
  };
  std::vector<Part> parts;        ///< a later one counts before an earlier one
  std::string words = "at rest";  ///< "hoist", "head -1, block 1"

  /// What that means for a model: the machine's, or the same with a carriage in another span.
  solve::EquilibriumOptions options(const machine::Model& model) const;
};

/// The motion that a deck asks for; complaints at `path` of words and names that there are not.
RopeMotion rope_motion(const std::vector<MotionRequest>& motion, const machine::Model& model, const DeckPlace& path,
                       std::vector<Complaint>& complaints);

/// One word for the whole machine.
RopeMotion rope_motion(solve::Motion motion);

}  // namespace taut::study
