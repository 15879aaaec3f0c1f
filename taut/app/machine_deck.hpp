#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/analysis/equilibrium.hpp"
#include "taut/calc/field.hpp"
#include "taut/model/machine.hpp"

namespace taut::app {

/// How one contact, or with an empty name every one, moves: hoist, lower, in, out, at_rest, or a sign: 1 along the
/// path, -1 against it, 0 at rest.
struct MotionRequest {
  std::string name;
  std::string sense;
  static const Description& describe();
};

struct EquilibriumRequest {
  std::optional<std::string> name;  ///< of its tables, when a deck has several
  std::vector<MotionRequest> motion;
  std::optional<std::string> carriage;  ///< put at x, instead of what its mainline or clamp says
  std::optional<double> x;
  static const Description& describe();
};

struct LoadPathRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0;
  double to = 0;
  int steps = 96;
  std::vector<MotionRequest> motion;
  static const Description& describe();
};

struct AnalysisRequest {
  std::optional<EquilibriumRequest> equilibrium;
  std::optional<LoadPathRequest> load_path;
  static const Description& describe();
};

/// A deck with `machine:` and `analyses:`. Without analyses: the equilibrium at rest.
struct MachineDeck {
  model::Machine machine;
  std::vector<AnalysisRequest> analyses;
  static const Description& describe();
};

/// The options that a motion asks for; complaints at `path`.
analysis::EquilibriumOptions options_of(const std::vector<MotionRequest>& motion, const model::Model& model,
                                        const std::string& path, std::vector<Complaint>& complaints);

}  // namespace taut::app
