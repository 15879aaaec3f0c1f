#pragma once
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/solve/exact/belt_drive.hpp"
#include "taut/units/display.hpp"

/// The exact column of `friction_drive`: the tensions that the take-up really lets the loop have.
namespace taut::app {

struct FrictionDriveExact {
  double take_up_exact = friction_drive::not_computed;        ///< N, on the idler while the rope runs
  double T_1_exact = friction_drive::not_computed;            ///< N
  double T_2_exact = friction_drive::not_computed;            ///< N
  double sigma_tight_exact = friction_drive::not_computed;    ///< Pa, of T_1_exact; of a rope with a known area
  double cutting_force_exact = friction_drive::not_computed;  ///< N, that the drive passes on
  double slip_arc_exact = friction_drive::not_computed;       ///< rad
  double arc_used_exact = friction_drive::not_computed;       ///< slip arc over working arc
  double creep_exact = friction_drive::not_computed;          ///< relative
  double creep_speed_exact = friction_drive::not_computed;    ///< m/s
  double slips_exact = friction_drive::not_computed;          ///< 1: slips, 0: holds
  double closure_exact = friction_drive::not_computed;        ///< of the rope's length, screw only

  static const Description& describe();
};

/// The engine's drive for a deck whose method is computed: `out` of the same input.
solve::BeltDrive belt_drive(const friction_drive::Input& in, const friction_drive::Output& out);

/// The method with the exact values, comparisons and, with a take-up in the deck, the check of its grip. A take-up that
/// leaves the rope without tension makes the result infeasible.
Result run_friction_drive(const friction_drive::Input& in, const Display& display = Display());

}  // namespace taut::app
