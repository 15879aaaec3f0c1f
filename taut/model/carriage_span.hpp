#pragma once
#include "taut/model/model.hpp"

namespace taut::model {

/// The model with a carriage moved to the span of its rope where x lies: a carriage that passes a support comes before
/// it in the rope's path, then behind it. The span is the one between two neighbours on the ground, the nearest one in
/// the path where there are several; without one the carriage stays in its span. The carriage starts on the straight
/// line between its neighbours, a clamp at its share of the rope.
Model with_carriage_at(Model model, int carriage, double x);

}  // namespace taut::model
