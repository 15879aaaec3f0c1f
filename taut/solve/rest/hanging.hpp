#pragma once
#include "taut/calc/outcome.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// How the carriages hang in an answer.
struct Hanging {
  Outcome outcome;      ///< not ok: one hangs upside down, or its rope would have to press it down; named
  bool lifted = false;  ///< the latter: an answer only where there is no other, and reported by its rollers' state
};

/// Equations of equilibrium have answers that no carriage takes: hanging over with its load above its rollers, or
/// pulled up from a rope that holds it down, from which it would lift off.
Hanging hanging(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e);

}  // namespace taut::solve
