#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/math/entries.hpp"
#include "taut/mechanics/arc_length.hpp"
#include "taut/mechanics/bend.hpp"
#include "taut/mechanics/branch.hpp"
#include "taut/mechanics/layout.hpp"

namespace taut::mechanics {

/// The unknowns' values.
struct Configuration {
  Array<machine::Pose> bodies;
  Array<machine::BranchState> branches;    ///< by Layout::branches
  double hold = 0;                         ///< N along the track
  Array<machine::PieceState> pieces = {};  ///< by Layout::pieces
  Array<double> open_loads = {};           ///< by reeving, N, of those that have one
  /// By Layout::branches, of those whose force is an unknown: in the middle, of a rope without weight its tension as x,
  /// N.
  Array<Vector3> forces = {};
};

/// Everything that follows from a configuration, and how far it is from equilibrium.
struct Evaluation {
  Array<Branch> branches;    ///< by Layout::branches
  Array<Bend> bends;         ///< by Layout::turns
  Eigen::VectorXd residual;  ///< N, N m, m
  double largest_force = 0;  ///< N, a scale
};

/// Which branch has no solution, and why.
struct NoBranch {
  int branch = 0;
  rope::NoCatenary why = rope::NoCatenary::not_converged;
};

/// The equations of equilibrium of a laid-out machine.
struct System {
  const machine::Model& model;
  const Layout& layout;
  double coordinate = 0;      ///< what the carriage's x is prescribed to be, m
  double losses = 1;          ///< share of every contact's loss (its logarithm) that counts
  bool lengths_kept = false;  ///< as in EquilibriumOptions
};

/// Fills `e`; a branch without solution stops it.
std::optional<NoBranch> evaluate(const System& system, Configuration& c, Evaluation& e);

/// How one branch follows the unknowns that move it: the freedoms of the bodies at its ends, its length, and its force
/// where that is one.
struct BranchColumns {
  static constexpr int most = 16;
  int count = 0;
  std::array<int, most> unknown{};
  std::array<double, most> length;  ///< free length, m/m
  std::array<Vector3, most> pull_from, pull_to, leaves, arrives;
  std::array<Vector3, most> arm_from, arm_to;  ///< tangent point seen from its body's origin
  int from_body = machine::ground, to_body = machine::ground;
};

/// d(residual)/d(unknowns), exact, by way of the branches' columns. Rotations: by a small turn about the freedom's
/// axis.
void jacobian(const System& system, const Configuration& c, const Evaluation& e, Entries& J,
              Array<BranchColumns>& columns);

/// A step of the unknowns, and what it does to the force of each branch in its plane to first order: a start for the
/// next evaluation.
struct Change {
  Eigen::VectorXd step;
  Array<rope::CatenaryForce> force;
};
Change change_of(const System& system, const Configuration& c, const Evaluation& e, const Array<BranchColumns>& columns,
                 const Eigen::VectorXd& step);

/// `c` moved by `part` of the change.
void move(const System& system, const Configuration& c, const Change& change, double part, Configuration& moved);

/// The worst of each kind.
struct Misfit {
  double force = 0;   ///< balances (moments over the machine's length), contact laws, given tensions, N
  double length = 0;  ///< given lengths and coordinates, m
  double span = 0;    ///< ends of spans before their last step, m
};
Misfit misfit(const System& system, const Evaluation& e);

/// The node of a rope's path at which it turns.
const machine::Node& node_of(const System& system, const Layout::Turn& turn);

/// Of the motor's pull at a driven sheave, by the tensions beside it: 1 and -1, and what its bearing takes of both.
struct DropRates {
  double by_in = 1, by_out = -1;
};
DropRates drop_rates(const System& system, const Layout::Turn& turn);

/// A branch's rope as it is: warmer, shorter.
rope::CatenaryRope rope_of(const machine::Reeving& reeving, double length);

/// The end of a branch in the ground frame.
BranchEnd end_at(const machine::Node& node, const Array<machine::Pose>& bodies);

/// Length of the arc at a turn, unstretched, with its derivatives.
ArcLength arc(const System& system, const Evaluation& e, int turn);

/// Unit vector along the track of the carriage that is held: between the rope's directions before its first roller and
/// behind its last one.
Vector3 track(const System& system, const Evaluation& e);

/// Where it is held: between its first and last roller, m.
Vector3 hold_place(const System& system, const Configuration& c);

}  // namespace taut::mechanics
