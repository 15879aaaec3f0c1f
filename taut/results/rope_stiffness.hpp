#pragma once
#include <optional>
#include <string>

#include "taut/calc/result.hpp"
#include "taut/catalogue/modulus.hpp"
#include "taut/machine/description/machine.hpp"

namespace taut::results {

/// What the stiffness of a rope of the machine rests on that its deck leaves to the catalogue; nothing where the deck
/// gives it, and for names that are no rope.
std::optional<catalogue::RopeStiffness> assumed_stiffness(const machine::Machine& machine, const std::string& rope);

/// Of each rope that is in use and whose stiffness follows from its area and construction: the value ROPE.stiffness,
/// and a warning where it rests on unverified numbers.
void add_rope_stiffness(const machine::Machine& machine, Result& r);

}  // namespace taut::results
