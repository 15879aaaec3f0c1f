#pragma once
#include <string>

#include "taut/base/array.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {

/// All that the integrator remembers at the time reached, as a list of numbers: with it a run goes on as if it had
/// never stopped, to the last bit when its steps are given.
Array<double> memory_of(Run& run);

/// What became of such a list: in the last two cases nothing is changed.
enum class Remembered {
  taken,
  other,   ///< none, or of another machine, method or share of damping
  damaged  ///< of this run, but numbers are missing or left over
};
/// `forgotten`: a measure of the run that needs what was before, and that the list does not have; else it stays.
Remembered take_memory(Run& run, const Array<double>& memory, std::string& forgotten);

}  // namespace taut::solve::dynamics
