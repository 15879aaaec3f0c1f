#pragma once
#include "taut/calc/result.hpp"
#include "taut/study/transient.hpp"

namespace taut::results {

/// The machine at the start, at its largest tension and at the end, with the forces of its ropes; the motion as an
/// animation and as a scene in space; observed quantities over time, those of one unit together, with the main events
/// marked; the energy over time.
void add_transient_figures(const study::TransientRun& run, Result& r);

/// Name of the motion's figure for page 1: its forces over time, else the animation; empty: it has neither.
std::string key_figure_of_motion(const study::TransientRun& run, const Result& r);

/// The machine in one frame, seen from its side, with the forces of its ropes.
Drawing drawing_at(const study::TransientRun& run, std::size_t frame, const std::string& title);

}  // namespace taut::results
