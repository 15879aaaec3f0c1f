#pragma once
#include <functional>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// The machine at one value of a parameter, or why there is none.
using ModelAt = std::function<tl::expected<machine::Model, Outcome>(double value)>;

/// One value of the parameter and its equilibrium.
struct SweepPoint {
  double value = 0;
  machine::Model model;
  EquilibriumResult at;
};

/// Why a continuation does not reach its last value.
enum class SweepEnd {
  reached,         ///< it does
  no_equilibrium,  ///< beyond `end` there is none: a rope too short, nothing that holds
  turning_point,   ///< the equilibrium turns back at `end`: its state changes with the square root of the distance to
                   ///< it; or beyond it the machine jumps to another one
  no_machine,      ///< the value makes no machine
  interrupted      ///< SweepOptions::go_on said so
};

struct Sweep {
  Array<SweepPoint> points;  ///< values with an equilibrium, in order; of a sweep that ends early the last one is
                             ///< at `end`, the last value found to have one
  SweepEnd end = SweepEnd::reached;
  double value = 0;  ///< where it ends
  Outcome outcome;   ///< beyond that; ok when reached
};

struct SweepOptions {
  double from = 0, to = 0;
  int steps = 1;
  EquilibriumOptions equilibrium;
  std::function<bool(double value)> go_on = {};  ///< asked before every step; false ends the sweep there
};

/// Follows the equilibrium over a parameter at equal steps, each from the state before. Where it is lost, the value is
/// found by halving, to 1e-9 of the way, and so is a jump: a step that moves the machine much more than the one before
/// and does so however small the steps get. A machine whose ropes run otherwise than those before starts anew.
Sweep sweep(const ModelAt& model_at, const SweepOptions& options);

/// How far two states of one machine are apart: the largest way of a body's origin, turn (times the length) or change
/// of a branch's length (while the ropes touch the same supports), m. Infinite for different machines.
double distance(const machine::State& a, const machine::State& b, double length);

}  // namespace taut::solve
