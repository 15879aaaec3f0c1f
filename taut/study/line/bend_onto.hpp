#pragma once
#include "taut/machine/model.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::study {

/// How far a rope is bent onto a support, rad; below 0 it would lift off. `wrap`: its bend there as solved; `in`,
/// `out`: its directions before and behind along the path, of any length, not 0.
///
/// Of a round it is the wrap about its axis. A point has no axis, and a bend in plan does not hold the rope on it:
/// there it is how much less steeply the rope goes on than it comes, in the direction in which it could lift off, else
/// upwards. In one upright plane that is the whole bend. A point with an upright axis holds the rope aside: the wrap.
double bend_onto(const machine::Node& node, double wrap, const Vector3& in, const Vector3& out);

/// At a contact of a state at rest. A slack branch goes along its chord.
double bend_onto(const machine::Model& model, const solve::EquilibriumResult& state,
                 const solve::ContactResult& contact);

}  // namespace taut::study
