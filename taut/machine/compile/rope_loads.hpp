#pragma once
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Complains of rope loads whose names, shares or amounts can't be right, by the description alone.
void check_rope_loads(const Machine& machine, std::vector<Complaint>& complaints);

/// Puts the rope loads into the paths of `model`, whose nodes are complete: each a node of kind load on a body of its
/// own, a rate as as many as it has elements, each in the middle of its part. `between` names two neighbours of the
/// path; where the path has them in the other order alone, the shares count from the other side. Carriages keep their
/// nodes.
void add_rope_loads(const Machine& machine, Model& model, std::vector<Complaint>& complaints);

}  // namespace taut::machine
