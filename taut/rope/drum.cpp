#include "taut/rope/drum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

void check(const DrumLayers& d) {
  expects(d.core_diameter > 0 && d.rope_diameter > 0, "a drum has a core and a rope");
  expects(d.pitch >= 0 && d.layer_height >= 0 && d.flange_diameter >= 0, "a drum's measures are not negative");
  expects(d.width >= d.rope_diameter, "a drum is wide enough for one turn");
}

constexpr double same_measure = 1e-12;  ///< relative: what fits exactly does so in floating point, in any unit

double pitch_of(const DrumLayers& d) { return d.pitch > 0 ? d.pitch : d.rope_diameter; }
double height_of(const DrumLayers& d) { return d.layer_height > 0 ? d.layer_height : d.rope_diameter; }

}  // namespace

int turns_per_layer(const DrumLayers& drum) {
  check(drum);
  // the first turn takes a rope's diameter, each further one a pitch
  return 1 + static_cast<int>(std::floor((drum.width * (1 + same_measure) - drum.rope_diameter) / pitch_of(drum)));
}

int layers_within_flanges(const DrumLayers& drum) {
  check(drum);
  if (drum.flange_diameter == 0) return std::numeric_limits<int>::max();
  const double room = (drum.flange_diameter - drum.core_diameter) / 2 - drum.rope_diameter;
  if (room < -same_measure * drum.core_diameter) return 0;
  return 1 + static_cast<int>(std::floor((room + same_measure * drum.core_diameter) / height_of(drum)));
}

double layer_radius(const DrumLayers& drum, int layer) {
  check(drum);
  expects(layer >= 1, "the first layer is layer 1");
  return (drum.core_diameter + drum.rope_diameter) / 2 + (layer - 1) * height_of(drum);
}

double turn_length(const DrumLayers& drum, int layer) {
  return std::hypot(two_pi * layer_radius(drum, layer), pitch_of(drum));
}

double layer_length(const DrumLayers& drum, int layer) { return turns_per_layer(drum) * turn_length(drum, layer); }

double drum_capacity(const DrumLayers& drum, int layers) {
  expects(layers >= 0, "a number of layers is not negative");
  double sum = 0;
  for (int k = 1; k <= layers; ++k) sum += layer_length(drum, k);
  return sum;
}

OnDrum on_drum(const DrumLayers& drum, double length) {
  check(drum);
  expects(length >= 0 && std::isfinite(length), "a length on a drum is not negative");
  OnDrum on;
  while (length > layer_length(drum, on.layer)) length -= layer_length(drum, on.layer++);
  on.turns = length / turn_length(drum, on.layer);
  on.radius = layer_radius(drum, on.layer);
  on.angle = two_pi * ((on.layer - 1) * static_cast<double>(turns_per_layer(drum)) + on.turns);
  return on;
}

double length_on_drum(const DrumLayers& drum, double angle) {
  expects(angle >= 0 && std::isfinite(angle), "a drum's angle counts from empty");
  const double turns = angle / two_pi, per_layer = turns_per_layer(drum);
  const int full = static_cast<int>(std::floor(turns / per_layer));
  return drum_capacity(drum, full) + (turns - full * per_layer) * turn_length(drum, full + 1);
}

double pull_at_layer(const DrumLayers& drum, int layer, double torque) { return torque / layer_radius(drum, layer); }

double torque_at_layer(const DrumLayers& drum, int layer, double pull) { return pull * layer_radius(drum, layer); }

}  // namespace taut::rope
