#pragma once

namespace taut::rope {

/// A drum that takes its rope in layers. All SI. Layer k (from 1) lies at the radius core/2 + (k - 1/2) d: the rope's
/// own diameter per layer, as on a smooth drum and the safe side for the pull; a rope that beds into the layer below
/// needs a smaller `layer_height`.
struct DrumLayers {
  double core_diameter = 0;    ///< m, > 0
  double rope_diameter = 0;    ///< m, > 0
  double width = 0;            ///< between the flanges, m
  double pitch = 0;            ///< from turn to turn, m; 0: the rope's diameter
  double layer_height = 0;     ///< m; 0: the rope's diameter
  double flange_diameter = 0;  ///< m; 0: not limited
};

/// Whole turns in one layer.
int turns_per_layer(const DrumLayers& drum);

/// Layers whose rope stays within the flanges; a large number where they do not limit it.
int layers_within_flanges(const DrumLayers& drum);

/// Radius of the rope's centre in layer k >= 1, m.
double layer_radius(const DrumLayers& drum, int layer);

/// Rope in one full turn of layer k: a helix, sqrt((2 pi R)^2 + pitch^2), m.
double turn_length(const DrumLayers& drum, int layer);

/// Rope in layer k when it is full, m.
double layer_length(const DrumLayers& drum, int layer);

/// Rope in the layers 1 to `layers` when they are full, m.
double drum_capacity(const DrumLayers& drum, int layers);

/// What lies on a drum with `length` of rope on it, wound without tension loss: the layer that is being wound, its
/// turns, the working radius, and the angle that the drum has turned since it was empty.
struct OnDrum {
  int layer = 1;
  double turns = 0;   ///< in this layer
  double radius = 0;  ///< m
  double angle = 0;   ///< rad
};
OnDrum on_drum(const DrumLayers& drum, double length);

/// Rope on the drum after it has turned by `angle` >= 0 from empty, m: the inverse.
double length_on_drum(const DrumLayers& drum, double angle);

/// Pull at layer k for a torque on the drum, N: M/R_k. And the torque for a pull, N m.
double pull_at_layer(const DrumLayers& drum, int layer, double torque);
double torque_at_layer(const DrumLayers& drum, int layer, double pull);

}  // namespace taut::rope
