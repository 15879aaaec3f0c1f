#pragma once
#include <array>

#include "taut/mechanics/system.hpp"

namespace taut::mechanics {

/// A branch of a rope that hardly stretches. Its tension is a small difference of its chord and its length, times EA:
/// places rounded to their last digit leave EA times 1e-16 of it. So its force is an unknown of the machine, and that
/// it closes is an equation: of a rope with weight the force in the middle and the place of its end, of one without its
/// tension and the row l/L - 1 - T/EA = 0. A rope that does not stretch is the row without T/EA.

/// How many unknowns, and rows, the force of a branch of this rope has.
int force_count(const machine::Reeving& rope);

/// The branch at its force; fills what is open of its rows, m. Empty where its rounds leave no line.
std::optional<Branch> stiff_branch(const System& system, int index, const Configuration& c, Eigen::VectorXd& residual);

/// One branch of a configuration, solved.
struct BranchAt {
  const System& system;
  const Configuration& c;
  int index;  ///< in Layout::branches
  const Branch& branch;
};

/// The derivatives of such a branch by what moves its ends and its length, as `rates` gives them of others.
BranchRates stiff_rates(const BranchAt& at);

/// How the way from centre to centre follows each column of a branch.
using BranchWays = std::array<Vector3, BranchColumns::most>;

/// Adds its forces to the branch's columns, and the derivatives of its own rows by all of them. The columns before
/// them are those of its bodies and its length.
void add_stiff_columns(const BranchAt& at, const BranchWays& ends, BranchColumns& columns, Entries& J);

/// The layout with the forces of all branches of ropes stiffer than `limit` (N) among its unknowns. A slack rope
/// without weight and stiffer than `slack_stiffness` (N) shares its slack among its branches as one of this EA.
Layout with_forces(Layout layout, const machine::Model& model, double limit, double slack_stiffness);

/// The configuration for it, with the forces that an evaluation by lengths found.
Configuration with_forces(const System& system, Configuration c, const Evaluation& e);

}  // namespace taut::mechanics
