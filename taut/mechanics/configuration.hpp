#pragma once
#include "taut/mechanics/system.hpp"

namespace taut::mechanics {

/// The unknowns' values in a state of the machine.
Configuration configuration_of(const Layout& layout, const machine::State& state);

/// The same back: puts them into the state.
void keep(const Layout& layout, const Configuration& c, machine::State& state);

/// The configuration of `state`, with every branch that has no shape there (a loose loop on a sheave) drawn taut.
Configuration usable_start(const System& system, const machine::State& state);

/// The same with every branch drawn taut that can be: to 0.999 of its straight length; one that does not stretch stays.
Configuration taut_start(const System& system, const machine::State& state);

}  // namespace taut::mechanics
