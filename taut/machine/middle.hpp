#pragma once
#include "taut/machine/model.hpp"

namespace taut::machine {

/// The middle of all places of a machine, whole metres; 0 where the machine is larger than the way to it. At 500 km
/// from the origin (places in a national grid) two neighbouring numbers are 6e-11 m apart. Times the stiffness of a
/// short rope, 7 MN/m of 3 m, that is a force of 4e-4 N, and no place of a body could balance the machine better. So
/// equilibrium and motion count from the middle.
Vector3 far_middle(const Model& model);

/// The machine in coordinates that count from `middle`; `Model::origin` keeps where that is.
Model counted_from(const Vector3& middle, Model model);

}  // namespace taut::machine
