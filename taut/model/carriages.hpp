#pragma once
#include <string>
#include <vector>

#include "taut/model/machine.hpp"
#include "taut/model/model.hpp"
#include "taut/model/path.hpp"

namespace taut::model {

/// Whether a carriage turns about the horizontal axis across its rope: with rollers apart, or above its origin.
bool pitches(const description::Carriage& carriage);

/// The carriage as a body that may move in space, and pitch where it does.
Body body_of(const description::Carriage& carriage);

/// Turns a body that pitches so that its x points along `chord` and its y lies level; its axis of pitch is y. A chord
/// straight up counts as along x.
void turn_along(Body& body, const Vector3& chord);

/// Its nodes on a rope that passes it: one for each roller, from its rear (x < 0) to its front, or the clamp. `place`:
/// of its origin.
std::vector<Stop> stops_of(const description::Carriage& carriage, int index, const Place& place, bool grips);

/// Complains of fields that do not go together.
void check(const description::Carriage& carriage, const std::string& path, std::vector<Complaint>& complaints);

/// The compiled carriage; complains of ropes that do not pass it as it says. `stops`: by reeving.
Carriage carriage_of(const Machine& machine, std::size_t index, const std::vector<Reeving>& reevings,
                     const std::vector<std::vector<Stop>>& stops, std::vector<Complaint>& complaints);

/// Carriages whose place the deck does not say start on the straight line between their neighbours, and all of them
/// turned along it.
void place_carriages(const Machine& machine, const std::vector<std::vector<Stop>>& stops, Model& model);

}  // namespace taut::model
