#pragma once
#include <optional>
#include <string>

#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// Where a carriage that nothing but its rope holds comes to rest.
struct Rest {
  int carriage = 0;
  std::optional<machine::State> state;  ///< near its equilibrium; empty: there is none between its neighbours
  std::string reason;                   ///< without state: where it runs to, and what to do
};

/// A rolling carriage without mainline, haulback or grip stands where the bisector of its rope is vertical, if it does.
/// It is put at places between its neighbours in the rope's path (`equilibrium` with it prescribed); the force that
/// would hold it there tells which way it runs, and a place where that turns from one neighbour to the other, towards
/// the place, is halved down. Empty without such a carriage, or where no place has an answer. `options` without a
/// prescribed place.
std::optional<Rest> roll_to_rest(const machine::Model& model, const EquilibriumOptions& options);

/// Why a state is none for such a carriage: it hangs beyond a neighbour, at which it would have stopped. Empty
/// otherwise.
std::string rolled_away(const machine::Model& model, const machine::State& state);

}  // namespace taut::solve
