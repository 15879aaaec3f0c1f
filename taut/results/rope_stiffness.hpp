#pragma once
#include <map>
#include <string>

#include "taut/calc/result.hpp"
#include "taut/catalogue/rope.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"
#include "taut/units/display.hpp"

namespace taut::results {

/// The rows that a design has put in, by the names of ropes.
using ChosenRopes = std::map<std::string, catalogue::RopeRow>;

/// Of each rope that is in use and whose stiffness follows from its area and construction: the value ROPE.stiffness,
/// and a warning where it rests on unverified numbers.
void add_rope_stiffness(const machine::Machine& machine, Result& r);

/// Values of the deck, or by the modulus of a design, in place of those of a rope's row of the catalogue that no rope
/// of that row has: a slip of a unit (kN, MN). The mass per metre, the diameter and the breaking force are compared
/// with those of the row, the stiffness with its metallic area times the least modulus of a new rope and that of the
/// wire. Unsafe warnings; a breaking force that is far below that of the row is a plain one. No weight (0 kg/m) and no
/// stretch (.inf) are ways to calculate.
void warn_of_rope_values(const machine::Machine& machine, const ChosenRopes& chosen, Result& r);

/// Ropes that their largest tension, ROPE.T_max of `r`, strains by more than a steel rope bears: unsafe for a rope of
/// the catalogue, else a plain warning.
void warn_of_strain(const machine::Machine& machine, const ChosenRopes& chosen, const machine::Model& model,
                    const Display& display, Result& r);

}  // namespace taut::results
