#pragma once
#include <string_view>

#include "taut/calc/quantity.hpp"
#include "taut/solve/drives.hpp"
#include "taut/solve/equilibrium.hpp"

/// The results of a machine at rest, each described once. docs/guide/reference.md lists them.
namespace taut::solve {

/// One part of an equilibrium, with the model and the state that it belongs to.
template <class Part>
struct PartOf {
  const machine::Model& model;
  const EquilibriumResult& at;
  const Part& part;
};
template <class Part>
PartOf(const machine::Model&, const EquilibriumResult&, const Part&) -> PartOf<Part>;

using BranchRow = PartOf<BranchResult>;
using ContactRow = PartOf<ContactResult>;
using RopeLoadRow = PartOf<RopeLoadResult>;
using DriveRow = PartOf<DriveResult>;
using DrumRow = PartOf<DrumResult>;
using BeamRow = PartOf<BeamResult>;

/// One end of a branch on the node that holds it: `last`, where the branch ends.
struct RopeEndRow {
  const machine::Model& model;
  const BranchResult& branch;
  bool last = false;
};
/// A rope as a whole; `reeving`: its index.
struct RopeRow {
  const machine::Model& model;
  const EquilibriumResult& at;
  int reeving = 0;
};
struct BodyRow {
  const machine::Model& model;
  const EquilibriumResult& at;
  int body = 0;
};
/// One point along a beam's axis.
struct BeamPointRow {
  const machine::Model& model;
  const BeamResult& beam;
  const BeamPoint& point;
};

const Quantities<BranchRow>& branch_quantities();
const Quantities<BranchRow>& branch_band_quantities();  ///< where EquilibriumResult::band
const Quantities<ContactRow>& contact_quantities();
const Quantities<ContactRow>& contact_band_quantities();  ///< where EquilibriumResult::band
const Quantities<RopeLoadRow>& rope_load_quantities();
const Quantities<RopeEndRow>& rope_end_quantities();
const Quantities<RopeRow>& rope_quantities();
const Quantities<RopeRow>& rope_end_tensions();  ///< of its first and its last branch
const Quantities<BodyRow>& body_quantities();
const Quantities<DriveRow>& drive_quantities();
const Quantities<DrumRow>& drum_quantities();
const Quantities<BeamPointRow>& beam_point_quantities();
const Quantities<BeamRow>& beam_quantities();
const Quantities<Closure>& closure_quantities();

/// The first and the last branch of a rope.
const BranchResult& first_branch(const EquilibriumResult& at, int reeving);
const BranchResult& last_branch(const EquilibriumResult& at, int reeving);

/// Force of a branch's rope (one copy) on what holds its start and its end, N.
Vector3 pull_on_start(const BranchResult& branch);
Vector3 pull_on_end(const BranchResult& branch);

/// "turning", "slipping", "stuck", "held", "pulled", "lifted".
std::string_view to_text(ContactState state);

}  // namespace taut::solve
