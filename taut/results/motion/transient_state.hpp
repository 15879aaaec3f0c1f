#pragma once
#include <string>
#include <tl/expected.hpp>

#include "taut/solve/motion/transient.hpp"

namespace taut::results {

/// A state as JSON text: all numbers in as many digits as bring the same number back, with the names of the machine's
/// bodies, ropes and drums.
std::string to_json(const solve::DynamicState& state, const machine::Model& model);

/// The state that such a text holds, for a machine that has the same bodies, ropes, drums and events by name and
/// number. The error says what does not fit, or that the text is no state.
tl::expected<solve::DynamicState, std::string> state_from_json(const std::string& text, const machine::Model& model);

}  // namespace taut::results
