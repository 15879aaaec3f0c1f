#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/solve/motion/transient.hpp"
#include "taut/units/display.hpp"

namespace taut::results {

/// The state in which a motion begins with such branches; empty where it has none.
std::optional<solve::TransientFrame> start_as(const machine::Model& model, solve::TransientOptions options,
                                              solve::Branches branches);
/// The state in which a motion begins that is the same but for the sag of its ropes; empty where it has none.
std::optional<solve::TransientFrame> hanging_start(const machine::Model& model, solve::TransientOptions options);

/// Whether forces along it, its rope loads, keep free parts of a rope with weight straight in any motion.
bool kept_straight(const machine::Reeving& rope);
bool any_kept_straight(const machine::Model& model);

/// What ropes pull at rest with their sag.
struct Sagging {
  std::vector<double> T;  ///< by reeving: the largest tension, N
  /// Whether those that forces along them keep straight sag here too; false: `T` has them straight.
  bool with_loads = true;
};
/// From the state `hangs`, in which all others hang, and, where ropes are kept straight, from statics, which lets those
/// hang too: where it has the machine at rest from which the motion begins. None where neither is known.
std::optional<Sagging> with_sag(const machine::Model& model, const std::optional<solve::TransientFrame>& hangs,
                                solve::Start start);

/// The largest weight of a free straight part of a rope over its tension, 1 where it is slack; 0: no part is straight,
/// or the rope has no weight. A part goes from round to round, past forces along the rope.
double heaviest_share(const machine::Model& model, const solve::TransientFrame& begin, std::size_t reeving);

/// Of an analysis whose ropes may be straight, with the state `begin` and the same with their sag, `hangs`: what its
/// numbers leave out, a sentence for each rope. Named are ropes that pull harder with their sag by more than 5 % of the
/// largest tension that they have in motion, `peaks` by reeving (empty: that of `begin`), and, where they do not hang,
/// those that weigh more than 5 % of their tension. Left out are ropes with less than a hundredth of their breaking
/// force, or of the largest tension of the machine: slack ropes pull by their weight alone.
std::vector<std::string> sag_warnings(const std::string& analysis, const machine::Model& model,
                                      const solve::TransientFrame& begin, const std::optional<Sagging>& hangs,
                                      const std::vector<double>& peaks = {}, const Display& display = {});

}  // namespace taut::results
