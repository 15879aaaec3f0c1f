#pragma once
#include <string>
#include <vector>

#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/equilibrium.hpp"

/// What holds a machine in the ground but for ropes.
namespace taut::checks {

/// A point of the ground on which beams stand, or the joint in the ground on which a body turns.
struct Footing {
  std::string name;             ///< of the point, or of the body
  std::vector<std::string> of;  ///< the beams, by name; none: the body
  std::vector<int> begin, end;  ///< beams of the model that begin there; that end there, joined to the ground
};

/// All of a machine. A body that moves along anything has none: no force holds it there.
std::vector<Footing> footings_of(const machine::Machine& described, const machine::Model& model);

/// The force of the machine on it, N; its z is positive where the machine pulls it up. Of a body whose joint the state
/// holds, as while guys are put up, 0.
Vector3 force_on(const Footing& footing, const machine::Model& model, const solve::EquilibriumResult& state);

/// A force on the ground up to which it is none, but what rounding leaves, N: of the largest force of the state, and of
/// the stiffest beam for the rounding of its ends.
double force_rounding(const machine::Model& model, const solve::EquilibriumResult& state);

}  // namespace taut::checks
