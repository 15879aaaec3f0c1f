#pragma once
#include "taut/calc/outcome.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// Not ok where the rope whose length follows from where a carriage is put (its mainline) hangs in a loop of more than
/// ten times its way: a second answer of the same equations, in which the weight of kilometres of rope pulls where the
/// taut rope of the first one would; no winch pays it out.
Outcome no_far_loop(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e);

}  // namespace taut::solve
