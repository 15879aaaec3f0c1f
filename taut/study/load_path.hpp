#pragma once
#include <functional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/condition.hpp"

namespace taut::study {

/// Positions of a carriage, `steps` + 1 of them from `from` to `to`.
struct Way {
  int carriage = 0;
  double from = 0, to = 0;  ///< m
  int steps = 1;
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  double x(int i) const { return from + (to - from) * i / steps; }
};

/// Positions first .. last within one span, with the carriage in that span's place of its rope's path. `support`: the
/// single position lies on it, in no span.
struct WayPart {
  machine::Model model;
  int first = 0, last = 0;
  const machine::Node* support = nullptr;  ///< of the model that the parts were made of
};

/// A carriage moved along its line, at equal steps of x.
struct LoadPathOptions {
  int carriage = 0;
  double from = 0, to = 0;           ///< x of the carriage's body along `along`, m, either order
  int steps = 1;                     ///< intervals, >= 1: steps + 1 positions
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  solve::EquilibriumOptions equilibrium;
  std::optional<solve::Condition> condition;  ///< in place of what one rope has given, at every position
  std::function<bool(double x)> go_on;        ///< asked before every position; false ends the way there. May be empty
};

struct LoadPathPoint {
  double x = 0, z = 0;          ///< of the carriage, m
  double clearance = 0;         ///< z above the terrain, m; NaN without terrain there
  solve::EquilibriumResult at;  ///< spans, contacts, ropes there; its outcome tells where there is no equilibrium
};

struct LoadPath {
  Outcome outcome;              ///< the first position without equilibrium, named by its x
  Array<LoadPathPoint> points;  ///< one for each position, fewer where `go_on` ended it
};

/// Each position starts from the one before. A position without equilibrium stays in the list with its outcome.
LoadPath load_path(const machine::Model& model, const LoadPathOptions& options);

/// Height of the ground at x, linear between its points; NaN outside.
double ground_height(const Array<machine::GroundPoint>& terrain, double x);

}  // namespace taut::study
