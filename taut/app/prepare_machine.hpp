#pragma once
#include <functional>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/io/deck/node.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// Reads a deck's `machine` and `analyses` and notes every mistake; without mistakes returns the calculation, ready to
/// be called; else an empty one. `input`: the map with both keys; a terrain's file is looked for beside the file that
/// names it. `progress`: as in a Job; `display`: for the sentences of the result.
std::function<Result()> prepare_machine(const io::Node& input, Diagnostics& mistakes,
                                        std::function<bool(const Progress&)> progress = {},
                                        const Display& display = Display());

}  // namespace taut::app
