#pragma once
#include <string>
#include <vector>

#include "taut/machine/model.hpp"

namespace taut::results {

/// Loads on bodies that cannot move: their force goes to the ground, and no rope and no beam feels it. One sentence for
/// each body; a driven body, and a section of a beam, are none of them.
std::vector<std::string> fixed_load_warnings(const machine::Model& model);

}  // namespace taut::results
