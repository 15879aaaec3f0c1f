#pragma once
#include <string>
#include <vector>

#include "taut/machine/model.hpp"
#include "taut/units/display.hpp"

namespace taut::results {

/// Loads on bodies that cannot move, and the mass of one that hangs on ropes: they go to the ground, and no rope and no
/// beam feels them. One sentence for each body; a driven body, and a section of a beam, are none of them. A body hangs
/// where all its ropes lead up from it, as the deck describes it, by more than 45 deg: guys lead down from a tower, and
/// less steeply up from an anchor.
std::vector<std::string> fixed_load_warnings(const machine::Model& model, const Display& display = {});

/// A sentence of a load that its own body bears.
struct LoadAcross {
  std::string text;
  bool unsafe = true;  ///< false: of a body with one freedom that a part of its load moves: rails bear the rest
};

/// Loads, or parts of them from 1 % on, that do no work in any freedom of their body, where it turns all
/// directions across its axis counted: as if the body stood fast there. One for each body that is free; those of
/// `fixed_load_warnings` and driven ones are none of them.
std::vector<LoadAcross> load_across_warnings(const machine::Model& model);

/// Ropes tied to, or led over, a place of the ground where a beam stands or has its free end: a fixed point in the air,
/// while the beam feels nothing of them. One sentence for each place.
std::vector<std::string> rope_beside_beam_warnings(const machine::Model& model);

/// Guys with both ends at fixed points: whatever the machine bears, they keep their tension. `first`: the index of the
/// first guy among the reevings; the others follow it.
std::vector<std::string> fixed_guy_warnings(const machine::Model& model, std::size_t first);

}  // namespace taut::results
