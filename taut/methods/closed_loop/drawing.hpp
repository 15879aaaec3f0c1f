#pragma once
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/methods/closed_loop/position.hpp"

namespace taut::closed_loop {

/// The loop to scale with its carriage and forces, for a solved position.
Drawing loop_drawing(const Input& in, const Output& out, const Display& display);

/// The loop as its deck describes it, ropes straight, without any tension.
Drawing loop_without_answer(const Input& in, const Display& display);

/// The forces at the carriage as a closed polygon, N.
Drawing force_polygon(const Input& in, const Output& out);

/// End tensions against position, in the closed-form tier: over the whole span by the deck's law (constant sag, winch
/// pull, ...), with the positions of the deck as points when it lists several.
Plot tension_plot(const Input& in, const Ropes& ropes, const std::vector<Row>& rows, const Engine& engine = no_engine);

/// Error of the paper's P_b, T_up and T_lA over the slope, at the deck's position and sag; against the closed-form
/// tier.
Plot error_plot(const Input& in, const Ropes& ropes, const Output& out);

}  // namespace taut::closed_loop
