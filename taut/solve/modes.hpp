#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/motion/transient.hpp"

namespace taut::solve {

/// Options of small vibrations about the state in which a motion would begin.
struct ModesOptions {
  Start start = Start::settled;
  int most = 10;             ///< number of modes, lowest first; those that grow are found beside them
  double damping_ratio = 0;  ///< of ropes without a damping of their own
  Branches branches = Branches::straight;
  bool rope_mass = true;  ///< false: ropes have neither weight nor inertia
};

/// Contacts during the vibration. stuck: no loss is overcome; saddles, and light sheaves or bearings with a loss, hold
/// the rope, and points stick on faces. released: all of them give way; the rope runs freely and turns sheaves with
/// inertia.
enum class Sheaves { stuck, released };

/// Kind of a mode with the eigenvalue lambda. A mode that does not oscillate has two real eigenvalues, reported
/// separately.
enum class ModeKind {
  swings,
  creeps,   ///< overdamped: it returns without oscillation
  free,     ///< no restoring force
  unstable  ///< grows
};

struct Mode {
  ModeKind kind = ModeKind::swings;
  double frequency = 0;  ///< |lambda|/(2 pi), Hz: the undamped frequency
  double damped = 0;     ///< damped frequency, Hz
  double damping = 0;    ///< damping ratio, -Re lambda/|lambda|
  struct Motion {
    Vector3 shift = Vector3::Zero();  ///< of the body's origin
    Vector3 turn = Vector3::Zero();   ///< rad per unit of the largest shift
  };
  Array<Motion> bodies;  ///< [body]; scaled so that the largest displacement, nodes of ropes included, is 1 m, or,
                         ///< where nothing is displaced, the largest rotation 1 rad
  std::optional<int> largest;  ///< body with the most kinetic energy; empty: the ropes have more
  TransientFrame shape;        ///< the machine displaced by 1/12 of its size, for drawings; its forces have no meaning
};

struct ModeSet {
  Sheaves sheaves = Sheaves::stuck;
  Array<Mode> modes;
  std::vector<std::string> held;  ///< names of the contacts that differ between stuck and released
};

struct ModesResult {
  Outcome outcome;
  Array<ModeSet> sets;  ///< stuck, and released where it differs
  TransientFrame rest;
  Array<double> damping_time;  ///< by reeving: beta, s
};

/// Largest number of degrees of freedom of bodies and nodes of ropes.
inline constexpr int most_mode_freedoms = 400;

/// Frequencies, damping ratios and shapes. Mass, damping and stiffness are found from the tangent matrices of the
/// transient analysis for steps of three sizes. Driven bodies, and drums and sheaves of given speed, stand still; slack
/// branches stay slack. docs/theory/vibrations.md.
ModesResult modes(const machine::Model& model, const ModesOptions& options = {});

/// The state about which `modes` finds them; empty where the machine does not come to rest.
std::optional<TransientFrame> rest_of_modes(const machine::Model& model, const ModesOptions& options = {});

}  // namespace taut::solve
