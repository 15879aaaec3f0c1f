#pragma once
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// What drums and motors are to the ropes on them, in a model whose nodes are complete: the layers of drums, the
/// tension drop of driven sheaves by their torque, T_in - T_out = M/(R copies), the speed of driven ropes, at the
/// start. `ropes`: of each reeving of the description.
void finish_drives(const Machine& machine, const Array<RopeData>& ropes, Model& model);

}  // namespace taut::machine
