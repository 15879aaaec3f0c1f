#pragma once
#include "taut/base/array.hpp"
#include "taut/mechanics/system.hpp"

namespace taut::mechanics {

/// Forces along the free rope (nodes of kind load), docs/theory/rope-load.md. At such a point the rope goes on in its
/// direction d and loses or gains tension: T_out d - T_in d + F d = 0; the point lies at a share p of the unstretched
/// rope between the next nodes of other kinds: sum of the L before it = p sum of all L.

/// The force at a turn of kind load, along the path, of one copy of the rope, N. A rate's part: q p_part sum of L.
double rope_load(const System& system, const Configuration& c, const Evaluation& e, int turn);

/// Adds the forces to the balance of their points and fills the rows of their places.
void add_rope_loads(const System& system, const Configuration& c, Evaluation& e);

/// The derivatives of both.
void add_rope_loads(const System& system, const Configuration& c, const Evaluation& e,
                    const Array<BranchColumns>& columns, Entries& J);

}  // namespace taut::mechanics
