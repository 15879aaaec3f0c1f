#pragma once
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"

namespace taut::study {

/// Everything that is put up with a tension gets its length: the guys, then the lines; then screws are set. A model of
/// a builder or of machine::compile needs it before its first equilibrium, as a deck has it done by the program. Not
/// ok: why a guy or line can't be put up, or a screw set.
Outcome put_up_all(machine::Model& model);

}  // namespace taut::study
