#pragma once
#include <vector>

#include "taut/calc/figure.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes {

/// Pictures of a computed calculation: forces by case, tensioning by step; with the sliding block the boom to scale
/// with its forces, ropes and pads along the boom, the force balance of section 3, and F_h, S_1, S_2 over the boom
/// length.
std::vector<Figure> figures(const Input& in, const Output& out, const Display& display);

/// The boom as its sliding block describes it, in the first position, with its weights only. Without that block, which
/// has its sizes, the calculation always has an answer.
Drawing boom_without_answer(const Input& in, const Display& display);

}  // namespace taut::boom_ropes
