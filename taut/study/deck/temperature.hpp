#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::study {

/// All ropes and beams at another temperature (K): their lengths at the reference temperature stay as they are. One
/// without a reference of its own has its length at the machine's temperature.
void set_temperature(machine::Model& model, const machine::Machine& machine, double temperature);

/// Lengths of ropes and beams without a reference temperature hold at the temperature (K) that the machine had before
/// another one was put into it; nothing: it had none.
void keep_references(machine::Machine& machine, const std::optional<double>& before);

/// Complains of ropes and beams whose reference temperature nobody says, at `path`: other temperatures would change
/// nothing.
void require_references(const machine::Machine& machine, const std::string& path, std::vector<Complaint>& complaints);

/// "-20 degC", for words.
std::string celsius(double kelvin);

}  // namespace taut::study
