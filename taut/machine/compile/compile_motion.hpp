#pragma once
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/compile.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/links/links.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

using Complaints = std::vector<Complaint>;

/// Inertia and driven motion of the bodies of a description, which stand in the model already: those that are driven
/// are put where their signals have them at t = 0.
void add_body_motion(const Machine& machine, Model& model, Complaints& complaints);

/// Drums and motors with what drives them.
void add_drives(const Machine& machine, Model& model, Complaints& complaints);

/// Faces, contacts, actuators, tensioners, then events and observables; the reevings have their nodes by now.
void add_motion(const Machine& machine, const Links& links, ModelFor use, Model& model, Complaints& complaints);

}  // namespace taut::machine
