#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/compile.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/machine/model.hpp"
#include "taut/rope/drum.hpp"

namespace taut::machine {

/// Complains of drums whose keys do not fit together, by the description alone.
void check_drums(const Machine& machine, ModelFor use, std::vector<Complaint>& complaints);

/// The drum with a rope of this diameter on it; width 0 where nothing can be said of layers: the deck does not say it,
/// or nobody knows the rope's diameter.
rope::DrumLayers measures_of(const Drum& drum, double rope_diameter);

/// What the end of a rope takes up on its drum, m^3: copies x length x d^2. All ropes of a drum lie over one another:
/// one of them reaches the layer of a rope alone whose length is the room of all over its d^2. `length` of one copy, as
/// wound, m; below 0 nothing lies there.
double room_of(double length, double diameter, int copies);

/// A rope and the drum at an end of its path. `ropes`: all of the machine.
struct EndOnDrum {
  const Machine& machine;
  const Array<RopeData>& ropes;
  const description::Drum& drum;
  const RopeData& rope;
};

/// The layer that the rope leaves: as given, or by all ropes on the drum, whose turns are longer by the tension at
/// which they were wound. 1 where nothing says it.
int layer_of(const EndOnDrum& end);

/// Radius of the rope's centre in that layer, m: D/2 + d/2 + (k - 1) h.
double radius_of(const EndOnDrum& end);

/// The tension of the rope by the drum's torque at the start, N: over the radius and the copies; empty where it has
/// none that pulls.
std::optional<double> pull_of_torque(const EndOnDrum& end, const Drive& drive, int copies);

}  // namespace taut::machine
