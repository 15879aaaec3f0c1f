#pragma once
#include "taut/solve/motion/parts/values.hpp"

/// Inertia of ropes along themselves: where they run with a rim, and where they stand. docs/theory/motion.md.
namespace taut::solve::dynamics {

/// Finds which halves of which lines run with a rim or are held (Line::rim, held, along), and what each rim has to take
/// along beyond light rounds (Contact::beyond), by the lengths that `start` shares out.
void mark_ropes_along(Mechanism& m, const DynamicState& start);

/// Takes what accelerates the rope at the ends of the line i out of its tension there, or adds it: LineValues::surge.
void add_surge(const Mechanism& m, const Scheme& s, const Values& before, std::size_t i, Values& now);

/// Adds the rows of the bodies at the ends of the line i, and the slopes of its tensions there by the freedoms of the
/// bodies. After the line's own rows.
void assemble_along(Mechanism& m, std::size_t i, const Values& now, Work& w);

/// How the tensions at a contact, in and out, follow the acceleration of its spin, N s2.
struct SurgeSlopes {
  double in = 0, out = 0;
};
SurgeSlopes surge_slopes(const Mechanism& m, const Contact& contact, const Values& before, const Values& now);

/// What the inertia of the rope along itself has on the body at an end of the line i, N, beside that of its mass
/// carried along by the body. In a motion: at rest there is none.
Vector3 force_along(const Mechanism& m, std::size_t i, std::size_t end, const Values& now);

/// What the rope gets of kinetic energy beyond that of its mass carried along by the bodies, W.
double power_along(const Mechanism& m, const Values& now);

}  // namespace taut::solve::dynamics
