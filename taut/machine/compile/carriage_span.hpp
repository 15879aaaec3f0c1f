#pragma once
#include "taut/machine/model.hpp"

namespace taut::machine {

/// The model with a carriage moved to the span of its rope where the coordinate x = place . along lies: a carriage that
/// passes a support comes before it in the rope's path, then behind it, and so does the grip of a rope that carries it
/// along. The span is the one between two neighbours that are on no carriage, the nearest one in the path where there
/// are several; without one the carriage stays in its span. The carriage starts on the straight line between its
/// neighbours, turned along it where it pitches, a clamp at its share of the rope. Guides that hold ahead of it
/// (guides.hpp) are in the paths where they hold at x. `along`: horizontal unit vector.
Model with_carriage_at(Model model, int carriage, double x, const Vector3& along = Vector3::UnitX());

}  // namespace taut::machine
