#pragma once
#include "taut/machine/description/machine.hpp"
#include "taut/math/vector.hpp"

namespace taut::machine {

/// Force of a half-suspended bunch of logs on what carries its front end, N, in the ground frame. The bunch is a
/// straight bar of mass m; its front end hangs, its rear end is dragged up the ground in the direction t of the way
/// (ground angle alpha, normal n), the bar at the angle delta to the ground. The ground presses on the rear end with N
/// n and holds it back with -mu N t; moments about the front end give
///   N = m g (1 - s) cos(alpha + delta)/(cos delta + mu sin delta),
/// s the distance of the centre from the rear end over the length. What is left of the weight hangs on the carriage:
///   F = -m g z + N (n - mu t).
/// With delta = 0: s m g cos alpha across the ground, m g sin alpha + mu (1 - s) m g cos alpha along it, backwards. s =
/// 1 is a load that hangs free. N = 0 where alpha + delta reaches 90 degrees. docs/theory/carriages.md.
Vector3 force_of(const description::Dragged& bunch, double mass, double gravity);

}  // namespace taut::machine
