#pragma once
#include <functional>
#include <optional>

#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Whether a sheave has no given side.
bool has_open_sides(const machine::Model& model);

/// A sheave without a given side that its rope passes on the outer side of its bend.
struct WrongSide {
  int reeving = 0, node = 0;
  double by = 0;  ///< how far the bend over the sheave's centre is on the other side, rad, > 0
};

/// The worst one in an answer. The rope takes the inner side of its bend, as its own directions are there: the wrap
/// that it would have if all rounds were points, with the sag that it has, is not negative, and where the rope comes
/// back it goes round by less than half a turn. A rope that comes back beside itself, nearer than the sheave is wide,
/// has no inner side.
std::optional<WrongSide> wrong_side(const machine::Model& model, const EquilibriumResult& result);

/// An equilibrium whose open sides follow from the answer and not from the places that the description gives:
/// `solve` solves a model with its sides, and each sheave that is passed on its outer side takes the other one, the
/// worst first. Where a rope comes back beside itself, nearer than the sheave is wide, the side of the description
/// stands. Where no side of a sheave is the inner one, where the rope runs nearly straight, the side with the larger
/// wrap stands; infeasible with the sheave's name where both wraps are negative. The state tells the sides.
EquilibriumResult on_inner_sides(
    const machine::Model& model, const std::optional<machine::State>& start,
    const std::function<EquilibriumResult(const machine::Model&, const std::optional<machine::State>&)>& solve);

}  // namespace taut::solve
