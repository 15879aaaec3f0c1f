#pragma once
#include <string>
#include <vector>

#include "taut/solve/motion/transient.hpp"

namespace taut::results {

/// The state in which a motion begins that is the same but for the sag of its ropes; nothing in it where it has none.
solve::TransientFrame hanging_start(const machine::Model& model, solve::TransientOptions options);

/// A rope that a motion or its vibrations take for straight, and that pulls harder where it sags.
struct SaggingRope {
  std::string name;
  double straight = 0;  ///< largest tension of its branches where the motion begins, N
  double sagging = 0;   ///< the same with its sag, N
};

/// Ropes whose tension in `hangs`, where they sag, is above that of `begin` by more than 5 % of the largest tension
/// that they have in motion, `peaks` by reeving (empty: that of `begin`). Left out are ropes with less than a hundredth
/// of their breaking force, or of the largest tension of the machine: slack ropes pull by their weight alone.
std::vector<SaggingRope> ropes_that_sag(const machine::Model& model, const solve::TransientFrame& begin,
                                        const solve::TransientFrame& hangs, const std::vector<double>& peaks = {});

/// "modes: 'span' begins straight with 5.003 kN; with its sag it has 36.2 kN: use 'branches: catenary'".
std::string sag_words(const std::string& analysis, const SaggingRope& rope);

}  // namespace taut::results
