#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/motion/transient.hpp"

namespace taut::solve {

/// Small vibrations of the machine about the state where its motion would begin.
struct ModesOptions {
  Start start = Start::settled;
  int most = 10;             ///< so many modes, lowest first
  double damping_ratio = 0;  ///< of ropes that give none
  Branches branches = Branches::straight;
  bool rope_mass = true;  ///< false: ropes have neither weight nor inertia
};

/// Rope on its sheaves. stuck: no loss is overcome; a light sheave with a loss, a saddle, a bearing with a loss hold
/// the rope, points on faces stick. released: all of them give way; the rope runs freely, over sheaves with inertia
/// with them.
enum class Sheaves { stuck, released };

/// frequency: |lambda|/2 pi; a mode that does not swing has two real lambdas, each reported by itself.
enum class ModeKind {
  swings,
  creeps,   ///< damped so strongly that it only comes back
  free,     ///< nothing brings it back
  unstable  ///< grows
};

struct Mode {
  ModeKind kind = ModeKind::swings;
  double frequency = 0;  ///< undamped, Hz; of one that creeps |lambda|/2 pi
  double damped = 0;     ///< with its damping, Hz
  double damping = 0;    ///< share of the critical one, -Re lambda/|lambda|
  struct Motion {
    Vector3 shift = Vector3::Zero();  ///< of the body's origin
    Vector3 turn = Vector3::Zero();   ///< rad per unit of the largest shift
  };
  Array<Motion> bodies;  ///< by body of the model; the largest shift (also of a rope's node) is 1 m, or where
                         ///< nothing shifts the largest turn 1 rad
  int largest = -1;      ///< body with most of the kinetic energy; -1: the ropes have more
  TransientFrame shape;  ///< the machine displaced by a twelfth of its size: for drawings, forces mean nothing
};

struct ModeSet {
  Sheaves sheaves = Sheaves::stuck;
  Array<Mode> modes;
  std::vector<std::string> held;  ///< sheaves and bearings that make the difference
};

struct ModesResult {
  Outcome outcome;
  Array<ModeSet> sets;  ///< stuck, and released where that differs
  TransientFrame rest;
  Array<double> damping_time;  ///< by reeving: beta, s
};

/// Freedoms of bodies and of ropes' nodes, at most.
inline constexpr int most_mode_freedoms = 400;

/// Frequencies, damping and shapes, from the residual of the transient analysis and its exact derivatives: its tangent
/// for steps of three sizes gives mass, damping and stiffness. Driven bodies, drums and sheaves by speed stand still;
/// what is slack stays slack. docs/theory/vibrations.md.
ModesResult modes(const machine::Model& model, const ModesOptions& options = {});

}  // namespace taut::solve
