#pragma once
#include <Eigen/Core>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// The stiffness of a machine against moving its bodies, N/m, N or N m: ropes and dead forces as in the Jacobian, the
/// unknowns that are no places and the points of rope loads eliminated, beams left out. Not symmetric where ropes lose
/// on rounds, or forces act along them.
struct PlacesStiffness {
  Array<int> freedoms;     ///< of the layout's dofs, by row
  Eigen::MatrixXd matrix;  ///< rows: what holds the freedom back; columns: which one moves
};

/// Around the equilibrium `c`; `e` becomes the evaluation without beams. A carriage prescribed by its ropes may move as
/// they let it, all as long as they are; one that a force holds may not. Empty where the ropes alone leave it
/// undetermined.
std::optional<PlacesStiffness> places_stiffness(const mechanics::System& system, const mechanics::Configuration& c,
                                                mechanics::Evaluation& e);

/// Of the rows of `all`, those of what moves with beams: nothing else is coupled to one of theirs.
Array<int> rows_with_beams(const mechanics::System& system, const PlacesStiffness& all);

}  // namespace taut::solve
