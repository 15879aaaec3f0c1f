#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/signal.hpp"

namespace taut::machine {

/// The signals of a machine, in the deck's order. Complains at "signals.NAME. ..." of texts that are no quantities, of
/// values of different kinds in one signal, of times that do not grow, of changes that overlap.
Array<Signal> signals_of(const Machine& machine, std::vector<Complaint>& complaints);

/// "0.5 m/s", "-3", ".5": meant as a quantity, not as a name.
bool looks_like_quantity(const std::string& text);

/// What a text stands for where a value in `unit` is wanted: the signal of that name, or a constant. Complains at
/// `path` when it is neither, or of another kind.
std::optional<Signal> signal_or_constant(const std::string& text, const Unit& unit, const Array<Signal>& signals,
                                         const std::string& path, std::vector<Complaint>& complaints);

}  // namespace taut::machine
