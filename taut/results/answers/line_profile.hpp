#pragma once
#include "taut/calc/figure.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::results {

/// The state in which a line is drawn, and the carriage that moves along it.
struct DrawnLine {
  const machine::Model& model;
  const solve::EquilibriumResult& state;
  const study::Way& way;
};

/// A profile of the line seen across the carriage's way: ground, supports, ropes, carriage. Its places are the
/// caller's.
Profile line_profile(const DrawnLine& line);

/// The height of a body, m: the least of an answer and its bounds, in any of which friction may hold it.
double lowest(const solve::EquilibriumResult& answer, int body);

/// Puts the places in the order of x; `decisive` stays the same place.
void sort_places(Profile& profile);

/// The profile of a load path: over its places the largest share of a breaking force that a rope bears, or, where no
/// breaking force is known, the largest tension; the rope that governs. Drawn where that is largest. No places: no
/// state.
Profile load_path_profile(const MachineRun& run, const study::LoadPathRun& path);

}  // namespace taut::results
