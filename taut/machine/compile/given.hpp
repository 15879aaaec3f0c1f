#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// A reeving as a deck describes it, with the data of its rope.
struct DescribedReeving {
  const description::Reeving& given;
  const RopeData& rope;
  const Array<RopeData>& ropes;  ///< all of the machine
  const std::string& path;       ///< in the deck, for complaints
};

/// Sets what is known of a rope besides its path, and its haul. A rope with ends: one of length, installation (its
/// length follows when it is put up), tension at either end, that of another rope, pull or torque of its drum; over a
/// sheave with a motor without a torque two of them. An endless one: its length, or its motor's torque. `model` has its
/// drums and motors.
void set_given(const Machine& machine, const Model& model, const DescribedReeving& described, Reeving& reeving,
               std::vector<Complaint>& complaints);

}  // namespace taut::machine
