#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"

namespace taut::solve {

/// What a driven sheave does, docs/theory/drives.md. Forces of all copies together where a torque or a power is
/// reported; tensions of one.
struct DriveResult {
  int reeving = 0, node = 0;
  double T_in = 0, T_out = 0;  ///< N, by the order of the path, centrifugal tension contained
  double centrifugal = 0;      ///< c = m v^2, N
  double bearing = 0;          ///< what its bearing takes of the motor's pull while the rope runs, N, >= 0
  double torque = 0;           ///< R (T_in - T_out) and what the bearing takes, N m, positive along the path
  double wrap = 0;             ///< rad
  double arc = 0;              ///< of it, what can pull, rad
  double ratio = 1;            ///< (T_1 - c)/(T_2 - c); infinite where T_2 <= c
  double limit = 0;            ///< exp(mu arc); infinite without friction given
  double slip_arc = 0;         ///< ln(ratio)/mu, rad; 0 without friction given
  double rest_arc = 0;         ///< arc - slip_arc, rad
  double creep = 0;            ///< (T_1 - T_2)/EA
  std::optional<double>
      speed;  ///< of the rope where it arrives, m/s, positive along the path; empty: at rest or unknown
  /// Of an endless rope that runs, W: power = loads + losses + carriages + creep. Other ropes: the power alone.
  double power = 0;
  std::optional<double> power_loads, power_losses, power_carriages, power_creep;
};

/// Why the pull of a driven sheave is not determined at rest or in steady running; empty: it is. Several motors on one
/// rope need a given torque each, but for one; a wheel with several grooves has one torque for all of them.
std::optional<std::string> undetermined_drive(const machine::Model& model);

/// Why a machine has no equilibrium before any is sought: a guy has not been put up, or a drive's pull is open.
std::optional<std::string> not_ready(const machine::Model& model);

/// Of every motor of the model.
Array<DriveResult> drives(const machine::Model& model, const EquilibriumResult& result);

/// The same at a moment of a motion where its rope presses on it: tensions and grip; no torque, no power.
Array<DriveResult> drives(const machine::Model& model, const TransientFrame& frame);

/// What lies on a drum, and what it pulls.
struct DrumResult {
  int drum = 0;         ///< index in the model
  int reeving = 0;      ///< whose end is on it
  bool at_end = false;  ///< of its path, else its start
  int sense = 1;        ///< in which it is wound: 1 as the first rope of the drum, -1 the other way
  double pull = 0;      ///< tension of one copy where the rope leaves it, N
  int layer = 1;
  std::optional<int> filled;              ///< the layer that all ropes of the drum reach, whatever `layer` is
  double radius = 0;                      ///< m
  double torque = 0;                      ///< of all copies, N m
  std::optional<double> length;           ///< on the drum, unstretched, m; negative: the rope does not reach
  std::optional<double> wraps;            ///< of one copy, all layers together
  std::optional<double> capacity;         ///< within the flanges, unstretched at that tension, m
  std::optional<double> pull_last_layer;  ///< what the same torque pulls in the last layer within the flanges, N
  std::optional<double> speed;            ///< of the rope, taking in, m/s
};

/// Of every end of a rope on a drum. The length on a drum is as given with the described length of its reeving (else
/// with the given length in `model`); where an answer has another free length, the rest is on the drum.
Array<DrumResult> drums(const machine::Model& model, const EquilibriumResult& result);

/// The largest tension at an end of a rope, the band of friction at rest counted, of all its copies, N.
double largest_at_end(const machine::Model& model, const EquilibriumResult& result, int reeving, bool at_end);

/// What lies on the drums at the ends of a rope with its given length, unstretched, m: 0 without drums, none where the
/// `length_on_drum` of one is not given.
std::optional<double> length_on_drums(const machine::Model& model, int reeving);

/// The whole rope: free and on its drums, unstretched, m. None where what lies on a drum is not known.
std::optional<double> whole_length(const machine::Model& model, const EquilibriumResult& result, int reeving);

/// The same at a moment of a motion: what its rope and its drive do there. Of drums whose content is not given, the
/// length is what the motion has wound, and left out.
Array<DrumResult> drums(const machine::Model& model, const TransientFrame& frame);

}  // namespace taut::solve
