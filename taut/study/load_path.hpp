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
  double x(int i) const;             ///< of the i-th step
};

/// Positions first .. last within one span, with the carriage in that span's place of its rope's path. `support`: the
/// single position lies on it, in no span. `beside`: a single place between the positions instead, just beside a
/// support that the carriage passes, where the rope bends most over it; first = last is the position before it.
struct WayPart {
  machine::Model model;
  int first = 0, last = 0;
  const machine::Node* support = nullptr;       ///< of the model that the parts were made of
  std::optional<double> beside = std::nullopt;  ///< m
};

/// Options: a carriage is moved along its line, in equal steps of x.
struct LoadPathOptions {
  int carriage = 0;
  double from = 0, to = 0;           ///< first and last x of the body of the carriage along `along`, m, in either order
  int steps = 1;                     ///< intervals, >= 1: steps + 1 positions, and those over tops of the ground
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  solve::EquilibriumOptions equilibrium;
  std::optional<solve::Condition> condition;  ///< replaces the given quantity of one rope, at every position
  std::function<bool(double x)> go_on;  ///< called before every position; false ends the load path there. May be empty
};

struct LoadPathPoint {
  double x = 0, z = 0;          ///< of the carriage, m
  double clearance = 0;         ///< z above the terrain, m; NaN where there is no terrain
  solve::EquilibriumResult at;  ///< the equilibrium there; its outcome is not ok where there is none
};

struct LoadPath {
  Outcome outcome;              ///< not ok: that of the first position without equilibrium; the message gives its x
  Array<LoadPathPoint> points;  ///< [position]; fewer where `go_on` ended it
};

/// The carriage that moves. Throws ContractViolation for steps < 1, a carriage that the model has not, and ends that
/// are not finite.
const machine::Carriage& carriage_on_path(const machine::Model& model, const LoadPathOptions& options);

/// The model with the carriage of a load path put at x, where that is in the span of the model's path; else the model.
machine::Model standing_at(const machine::Model& model, const LoadPathOptions& options, double x);

/// The equilibria along a load path. Each search starts from an extrapolation of the positions before it, and where
/// that leads to none, from the place alone. A position without equilibrium stays in the list with its outcome. Where
/// the carriage is nearer to the ground over a top of the terrain within a step than at both its ends, the lowest such
/// place is in the list too, between them. Throws ContractViolation where carriage_on_path does.
LoadPath load_path(const machine::Model& model, const LoadPathOptions& options);

/// One position, from a state near it, else from the place alone. Throws as load_path does.
LoadPathPoint load_path_at(const machine::Model& model, const LoadPathOptions& options, double x,
                           const std::optional<machine::State>& start = std::nullopt);

/// Height of the ground at x, m, linear between the points of the terrain; NaN outside.
double ground_height(const Array<machine::GroundPoint>& terrain, double x);

}  // namespace taut::study
