#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Sets what is known of a rope besides its path, and its haul. A rope with ends: one of length, installation (its
/// length follows when it is put up), tension at either end, pull or torque of its drum; over a sheave with a motor
/// without a torque two of them. An endless one: its length, or its motor's torque. `model` has its drums and motors.
/// `path`: of the reeving, for complaints.
void set_given(const Machine& machine, const Model& model, const description::Reeving& given, const RopeData& rope,
               const std::string& path, Reeving& reeving, std::vector<Complaint>& complaints);

}  // namespace taut::machine
