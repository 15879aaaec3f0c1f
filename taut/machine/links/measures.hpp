#pragma once
#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Resolves the machine's `measures` into `model.measures`, in the deck's order, so that a mean may be taken while a
/// measure before it lies between two values. `model`: as for `observable`.
void add_measures(const Machine& machine, Model& model, std::vector<Complaint>& complaints);

/// Writes every measure down that `model.observed` has not got yet, and ties it to its place there.
void observe_measures(Model& model);

}  // namespace taut::machine
