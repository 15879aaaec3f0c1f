#pragma once
#include <string>
#include <tl/expected.hpp>

#include "taut/solve/motion/transient.hpp"

namespace taut::results {

/// A state as JSON text: all numbers in as many digits as bring the same number back, with the names of the machine's
/// bodies, ropes, drums, driven sheaves, cylinders and contacts. `damping_ratio`: of ropes that give none.
std::string to_json(const solve::DynamicState& state, const machine::Model& model, double damping_ratio = 0);

/// The state that such a text holds, for a machine that has the same of all of them. The error says what does not fit,
/// or that the text is no state. Drives, signals, modes of cylinders and events are those of the machine from then on;
/// an event that has happened does not happen again, and what it has done stays. A rope with another damping than it
/// had then is damped by that: a ratio is one of the lowest mode where the first motion began.
tl::expected<solve::DynamicState, std::string> state_from_json(const std::string& text, const machine::Model& model,
                                                               double damping_ratio = 0);

}  // namespace taut::results
