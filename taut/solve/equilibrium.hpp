#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/prescribed.hpp"
#include "taut/machine/state.hpp"
#include "taut/rope/span.hpp"
#include "taut/solve/beam_result.hpp"

namespace taut::solve {

/// How the ropes run over their contacts, which sets the direction of every loss. hoist and in mean the same: each rope
/// flows by its `haul`; lower and out the other way. at_rest: no loss, and beside it the band between the two.
enum class Motion { at_rest, hoist, lower, in, out };

struct EquilibriumOptions {
  Motion motion = Motion::at_rest;
  /// Flow through single contacts, [reeving][node], +1 along the path, -1 against it, 0 none; empty: by `motion`.
  Array<Array<int>> flow;
  bool band = true;  ///< at rest: also solve both directions
  /// Given tensions are those that ropes are put up with: the machine has to stay with the lengths found, not with the
  /// tensions held.
  bool lengths_kept = false;
  std::optional<machine::Prescribed> prescribed;
  /// Whether a force along its track may hold a prescribed carriage that no rope holds. False: there is no equilibrium
  /// where one is needed, but for 1e-9 of the carriage's weight and load.
  bool held = true;
  /// Of every residual: forces by the largest force (not below 4e-15 EA, what rounding leaves), lengths by the longest
  /// span.
  double tolerance = 1e-10;
  int iterations = 60;  ///< of one Newton solve
};

/// One branch. Tensions at its ends and the components there: H along the horizontal of the branch, V upwards (positive
/// where the rope rises along its path), N. Of a running rope (Reeving::speed) T contains the centrifugal tension, H
/// and V, what its ends feel, do not.
struct SpanResult {
  int reeving = 0, from = 0, to = 0;  ///< nodes
  double T_from = 0, T_to = 0, H = 0, V_from = 0, V_to = 0;
  double chord = 0, unstretched = 0, stretched = 0, sag = 0;  ///< m; unstretched: at the reference temperature, the
                                                              ///< free rope of this branch alone
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();     ///< where the free rope begins and ends, m
  bool slack = false;                                         ///< a rope without weight that carries nothing
  rope::Span shape;                                           ///< for points between the ends
  double T_from_min = 0, T_from_max = 0, T_to_min = 0, T_to_max = 0;  ///< the band at rest; else the tension itself
};

/// What a rope does at a node between its ends.
enum class ContactState {
  turning,   ///< a sheave (or carriage) over which the rope runs
  slipping,  ///< a saddle over which the rope runs, or a sheave on which it slips
  stuck,     ///< at rest, held by friction
  held,      ///< a clamp or a drive
  pulled,    ///< the rope pulls the support the wrong way: it would lift off
  lifted     ///< the rope has lifted off
};

struct ContactResult {
  int reeving = 0, node = 0;
  double T_in = 0, T_out = 0;       ///< N, by the order of the path
  double wrap = 0;                  ///< angle between the rope directions, rad
  Vector3 force = Vector3::Zero();  ///< of the rope (one copy) on it, N
  ContactState state = ContactState::turning;
  double T_in_min = 0, T_in_max = 0, T_out_min = 0, T_out_max = 0;  ///< the band at rest; else the tension itself
};

/// A force along the free rope.
struct RopeLoadResult {
  int reeving = 0, node = 0;
  Vector3 at = Vector3::Zero();     ///< where on the rope, m
  Vector3 force = Vector3::Zero();  ///< on the rope (one copy), N
  double along_path = 0;            ///< the same with its sign by the order of the path, N
  double T_in = 0, T_out = 0;       ///< N, by the order of the path
};

/// A rope as a whole.
struct RopeResult {
  double unstretched = 0;    ///< at the reference temperature, of one copy, from end to end of its path: that of its
                             ///< spans and what lies on rounds, not what is on drums, m
  double T_max = 0;          ///< the band's largest included, N
  int span = 0;              ///< where it is: index in `spans`,
  bool at_end = false;       ///< at that branch's end or start
  double safety_factor = 0;  ///< breaking force / T_max; 0: breaking force not known
};

/// How well the answer closes: worst over the machine.
struct Closure {
  double rope = 0;     ///< ends of spans and lengths of ropes, m
  double force = 0;    ///< balance of every freedom (moments: by the machine's size) and the law of every contact, N
  double balance = 0;  ///< weights, loads, forces on fixed bodies and anchors together, N
  int iterations = 0;  ///< Newton steps, all stages
};

/// `outcome` not ok: the message says what to change, and nothing else here is a result.
struct EquilibriumResult {
  Outcome outcome;
  machine::State state;
  Array<SpanResult> spans;           ///< by reeving, along its path
  Array<ContactResult> contacts;     ///< by reeving, along its path; nodes between the ends
  Array<RopeLoadResult> rope_loads;  ///< by reeving, along its path
  Array<RopeResult> ropes;           ///< by reeving
  /// By body: force on the body by what holds it where it is not free, N; in free directions about 0.
  Array<Vector3> reactions;
  Array<BeamResult> beams;         ///< as in the model
  Vector3 hold = Vector3::Zero();  ///< force that keeps a prescribed carriage without mainline in place, N
  Closure closure;
  bool band = false;       ///< whether the tensions' bands hold both directions of motion
  Array<Array<int>> flow;  ///< through every node, [reeving][node], for which the tensions hold
};

/// The equilibrium of the machine, from `start` (default: initial_state) on. Damped Newton with exact derivatives over
/// the freedoms of the bodies and the unstretched length of every branch; where it fails from the start given, load and
/// rope weight are stepped. Ropes with a speed run where the motion makes them flow: their tensions contain the
/// centrifugal one, m v^2, which no support feels. At rest the loads that go by the motion act as if the ropes hauled
/// in, also in the band. docs/theory/equilibrium.md, docs/theory/drives.md.
EquilibriumResult equilibrium(const machine::Model& model, const EquilibriumOptions& options = {},
                              const std::optional<machine::State>& start = std::nullopt);

/// Not ok where a prescribed carriage stays in its place only by the result's `hold`, as of EquilibriumOptions::held.
Outcome stands_by_itself(const machine::Model& model, const EquilibriumOptions& options,
                         const EquilibriumResult& result);

/// The machine with each rope's length frozen as it is in `result`: guys installed by tension, then loaded.
machine::Model installed(const machine::Model& model, const EquilibriumResult& result);

}  // namespace taut::solve
