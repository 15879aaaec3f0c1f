#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/compile/path.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Whether a carriage turns about the horizontal axis across its rope: with rollers apart, or above its origin.
bool pitches(const description::Carriage& carriage);

/// The carriage as a body that may move in space, and pitch where it does.
Body body_of(const description::Carriage& carriage);

/// Turns a body that pitches to where it is looked for first: its y lies level across `chord` and is its axis of pitch;
/// its x points along the chord, or, hanging from a single roller, level. A chord straight up counts as along x.
void turn_along(Body& body, const Vector3& chord, int rollers);

/// Its nodes on a rope that passes it: one for each roller, from its rear (x < 0) to its front, or the clamp. `place`:
/// of its origin.
Array<Stop> stops_of(const description::Carriage& carriage, int index, const Place& place, bool grips);

/// Complains of fields that do not go together.
void check(const description::Carriage& carriage, const std::string& path, std::vector<Complaint>& complaints);

/// The compiled carriage; complains of ropes that do not pass it as it says. `stops`: by reeving.
Carriage carriage_of(const Machine& machine, std::size_t index, const Array<Reeving>& reevings,
                     const Array<Array<Stop>>& stops, std::vector<Complaint>& complaints);

/// Carriages whose place the deck does not say start on the straight line between their neighbours, and all of them
/// turned along it.
void place_carriages(const Machine& machine, const Array<Array<Stop>>& stops, Model& model);

}  // namespace taut::machine
