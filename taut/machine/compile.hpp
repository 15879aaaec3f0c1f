#pragma once
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// What is asked of a model. At rest nothing is written down, so that a deck that names nothing to observe has nothing
/// observed.
enum class ModelFor { rest, motion };

/// Resolves the names of a description and checks it: every single value as a deck is checked when it is read
/// (broken_fields), and what several of them say together. Returns a model, or every mistake, each with its place below
/// `machine` ("reevings[1].path[0].anchor").
/// Order of bodies: those of the description, one for each carriage, the sections of beams to which something is fixed.
/// Order of reevings: those of the description, one for each guy. A guy put up by tension has this tension as its given
/// quantity; solve::installed then replaces it by a length.
/// A terrain file must have been read into x and z before. A clamped carriage without `length_before` divides its rope
/// at its place, in proportion to the path.
tl::expected<Model, std::vector<Complaint>> compile(const Machine& machine, ModelFor use = ModelFor::motion);

}  // namespace taut::machine
