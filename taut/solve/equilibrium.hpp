#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/prescribed.hpp"
#include "taut/machine/state.hpp"
#include "taut/rope/span.hpp"
#include "taut/solve/beam_result.hpp"

namespace taut::solve {

/// Direction in which the ropes run over their contacts; it sets the direction of every loss. hoist and in mean the
/// same: each rope flows as machine::hauling_in says, others as these draw them along (docs/theory/senses.md); lower
/// and out are the opposite. at_rest: the equilibrium without losses and, with `band`, the band of each tension over
/// all directions.
enum class Motion { at_rest, hoist, lower, in, out };

struct EquilibriumOptions {
  Motion motion = Motion::at_rest;
  /// Flow at single contacts, [reeving][node]: +1 along the path, -1 against it, 0 none. Empty: by `motion`.
  Array<Array<int>> flow;
  /// Contacts over which a rope creeps, [reeving][node]: its flow when it is drawn to its carriage, else 0. The band
  /// has both directions. Empty: none where `flow` is given, else by `motion`. The same for a rope of which nothing
  /// says which way it runs.
  Array<Array<int>> creep;
  bool creep_without_loss = false;  ///< the answer has no loss where a rope creeps
  /// Also solve both directions of what is at rest, for the bands of the tensions: of all ropes at rest, of those that
  /// creep in motion.
  bool band = true;
  /// Given tensions are those of the installation: the solution has to be stable with the lengths found held constant,
  /// not with the tensions held constant.
  bool lengths_kept = false;
  /// Whether the load factors of the beams are found (BeamResult::critical_factor) and a beam that buckles is told by
  /// name. A search does without.
  bool beam_factors = true;
  std::optional<machine::Prescribed> prescribed;
  /// Whether a force along the track may hold a prescribed carriage that no rope holds. When false there is no
  /// equilibrium where such a force is needed; below 1e-9 of the weight and load of the carriage it counts as zero.
  bool held = true;
  /// Tolerance of every residual. Forces: relative to the largest force (at least to 4e-15 EA, the level of rounding).
  /// Lengths: relative to the longest span.
  double tolerance = 1e-10;
  int iterations = 60;  ///< of one Newton solve
};

/// Results of one branch: tensions at its ends and their components, N. H: along the horizontal direction of the
/// branch. V: upwards, positive where the rope rises along its path. T of a running rope (Reeving::speed) contains the
/// centrifugal tension; H and V do not, because its supports do not feel it.
struct BranchResult {
  int reeving = 0, from = 0, to = 0;  ///< nodes
  double T_from = 0, T_to = 0, H = 0, V_from = 0, V_to = 0;
  /// Lengths, m. unstretched: of the free rope of this branch, at the reference temperature.
  double chord = 0, unstretched = 0, stretched = 0, sag = 0;
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();             ///< ends of the free rope, m
  bool slack = false;                                                 ///< a weightless rope that carries no force
  rope::Span shape;                                                   ///< shape between the ends
  double T_from_min = 0, T_from_max = 0, T_to_min = 0, T_to_max = 0;  ///< the band at rest; else the tension itself
};

/// State of a rope at a node between its ends.
enum class ContactState {
  turning,   ///< a sheave (or carriage) over which the rope runs
  slipping,  ///< a saddle over which the rope runs, or a sheave on which it slips
  stuck,     ///< at rest, held by friction
  held,      ///< a clamp or a drive
  pulled,    ///< the rope pulls the support in the direction in which it would lift off
  lifted     ///< the rope has lifted off
};

struct ContactResult {
  int reeving = 0, node = 0;
  double T_in = 0, T_out = 0;       ///< N, by the order of the path
  double wrap = 0;                  ///< about the axis of a round, else between the rope's directions, rad
  double turning = 0;               ///< all of its bend, out of the plane of a round too; of a drive the wrap, rad
  double unstretched = 0;           ///< rope on its arc, at the reference temperature, m
  Vector3 force = Vector3::Zero();  ///< of one copy of the rope on the support, N
  ContactState state = ContactState::turning;
  double T_in_min = 0, T_in_max = 0, T_out_min = 0, T_out_max = 0;  ///< the band at rest; else the tension itself
};

/// Result of a force along the free rope.
struct RopeLoadResult {
  int reeving = 0, node = 0;
  Vector3 at = Vector3::Zero();     ///< its place, m
  Vector3 force = Vector3::Zero();  ///< on one copy of the rope, N
  double along_path = 0;            ///< its component along the path, N
  double T_in = 0, T_out = 0;       ///< N, by the order of the path
};

/// Results of a whole rope.
struct RopeResult {
  double unstretched = 0;  ///< at the reference temperature, of one copy, from end to end of its path, m: branches and
                           ///< arcs on rounds, without the rope on drums
  double T_max = 0;        ///< the largest tension; at rest the largest of the band, N
  int branch = 0;          ///< index of the branch with T_max in `branches`
  bool at_end = false;     ///< T_max is at the end of that branch, else at its start
  double safety_factor = 0;  ///< breaking force / T_max; 0: breaking force not known
};

/// Accuracy of the answer: the largest residuals in the machine.
struct Closure {
  double rope = 0;     ///< ends of spans and lengths of ropes, m
  double force = 0;    ///< balance of every degree of freedom (moments: divided by the size of the machine) and law of
                       ///< every contact, N
  double balance = 0;  ///< sum of all weights, loads and forces at fixed bodies and anchors, N
  int iterations = 0;  ///< Newton steps, all stages
};

/// When `outcome` is not ok its message says what to change, and the other members are not a result.
struct EquilibriumResult {
  Outcome outcome;
  machine::State state;
  Array<BranchResult> branches;      ///< by reeving, along its path
  Array<ContactResult> contacts;     ///< by reeving, along its path; nodes between the ends
  Array<RopeLoadResult> rope_loads;  ///< by reeving, along its path
  Array<RopeResult> ropes;           ///< by reeving
  /// [body]: force by which the body is held in directions that are not free, N; about 0 in free directions.
  Array<Vector3> reactions;
  Array<BeamResult> beams;         ///< as in the model
  Vector3 hold = Vector3::Zero();  ///< force that holds a prescribed carriage without mainline, N
  Closure closure;
  bool band = false;  ///< whether the bands of the tensions contain both directions of motion
  /// The answers that bound the band, whole: what friction at rest may load a support, a body or a beam with. They
  /// have no bounds of their own.
  std::vector<EquilibriumResult> bounds;
  std::string indifferent;  ///< see solve::indifferent: bodies of which the place found is one of many
  std::string unbounded;    ///< what the band that was asked for leaves out, and why; empty: nothing
  /// Why it has no equilibrium in a direction that friction may act in, of the band that was asked for; empty: it has
  /// one in all of them. The answer is one of several directions, of which the order of a path may choose: where this
  /// is not empty, nothing says that the machine stays where the answer has it.
  std::string unheld;
  Array<Array<int>> flow;  ///< flow at every node, [reeving][node], for which the tensions hold
};

/// The equilibrium of the machine, starting from `start` (default: initial_state). Damped Newton iteration with exact
/// derivatives over the degrees of freedom of the bodies and the unstretched length of every branch. Where it fails
/// from that start, loads and rope weights are increased in steps. Ropes with a speed flow as the motion says; their
/// tensions contain the centrifugal tension m v^2, which no support feels. At rest, loads that depend on the motion act
/// as if the ropes hauled in, in the band too. Returns infeasible or not_converged with a message in `outcome`. Throws
/// ContractViolation when `start` is no state of this model, `options.flow` is neither empty nor given at every node,
/// or the prescribed carriage is none of the model or stands at no finite x.
/// docs/theory/equilibrium.md, docs/theory/drives.md.
EquilibriumResult equilibrium(const machine::Model& model, const EquilibriumOptions& options = {},
                              const std::optional<machine::State>& start = std::nullopt);

/// Infeasible where a prescribed carriage is held only by the force `hold`, see EquilibriumOptions::held.
Outcome stands_by_itself(const machine::Model& model, const EquilibriumOptions& options,
                         const EquilibriumResult& result);

}  // namespace taut::solve
