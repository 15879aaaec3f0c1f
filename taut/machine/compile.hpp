#pragma once
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// The machine with its names resolved, checked, ready to be solved. Either a model or every mistake, each with the
/// path of its place below `machine` ("reevings[1].path[0].anchor"). Bodies: those of the description, then one for
/// each carriage, then the sections of beams to which something is fixed. Reevings: those of the description, then one
/// for each guy; a guy's tension at its installation is its given tension until `installed`. A terrain's file has been
/// read into its x and z before. A clamped carriage without `length_before` is put at the share of the length where it
/// stands.
tl::expected<Model, std::vector<Complaint>> compile(const Machine& machine);

}  // namespace taut::machine
