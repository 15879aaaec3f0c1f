#pragma once
#include <string>
#include <vector>

#include "taut/methods/closed_loop/closed_loop.hpp"

namespace taut::closed_loop {

/// What the ropes that (8) and (10) ask for really have: with the weights k F of these areas, the load at midspan and
/// the same sag, `safety_factor_return_paper` = sigma F_return_paper over the largest tension of that rope by the
/// closed form, and the same of the traction rope. Says so in `warnings` where it is less than the deck's safety
/// factor. Nothing where the areas were not computed.
void prove_paper_choice(const Input& in, Output& out, const Display& display, std::vector<std::string>& warnings);

}  // namespace taut::closed_loop
