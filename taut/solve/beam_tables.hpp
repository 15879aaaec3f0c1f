#pragma once
#include <functional>

#include "taut/base/array.hpp"
#include "taut/mechanics/system.hpp"
#include "taut/solve/beam_result.hpp"

namespace taut::solve {

/// What a solved configuration says of its beams; critical factors are left open.
Array<BeamResult> beam_results(const mechanics::System& system, const mechanics::Configuration& c);

/// Tells `act` the forces of all beams on the bodies (or the ground) at the ends of their pieces, and adds the beams'
/// weights to `outside`.
void act_beams(const mechanics::System& system, const mechanics::Configuration& c,
               const std::function<void(int, const Vector3&)>& act, Vector3& outside);

/// Fills the critical factors. Not ok: a beam is bent beyond what is one, or the equilibrium is not stable; the message
/// names the beam and says what to change.
Outcome check_beams(const mechanics::System& system, const mechanics::Configuration& c, Array<BeamResult>& results);

/// Whether an equilibrium found is one to stay in, without the factors, which cost ten times more: where a beam buckles
/// the message does not name it.
Outcome beams_stay(const mechanics::System& system, const mechanics::Configuration& c);

}  // namespace taut::solve
