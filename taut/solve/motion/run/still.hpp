#pragma once
#include <Eigen/Core>
#include <set>
#include <string>

#include "taut/solve/motion/run/run.hpp"

/// The machine at rest in one moment of a run: what holds it there.
namespace taut::solve::dynamics {

/// How ropes and bearings are where the machine moves a little: what has a loss sticks, or gives way. Names of what
/// does one or the other.
std::set<std::string> set_grips(const Mechanism& m, bool stuck, Values& v);

/// The machine, without velocities, moved by a shape of all columns.
Values displaced_by(Run& run, const Eigen::VectorXd& x, const Values& from);

/// What goes away at the least push where the machine is now ("body 'mast' turns over about x"); empty where it comes
/// back or stays. What has friction sticks. The machine goes away where its stiffness is negative in some direction:
/// docs/theory/motion-energy.md.
std::string leaves_at_a_push(Run& run);

/// Notes an event "unstable", once, where the machine rests in such a place: at a moment of a quasi-static run, or at
/// one of a dynamic run in which nothing moves.
void note_unstable(Run& run);

}  // namespace taut::solve::dynamics
