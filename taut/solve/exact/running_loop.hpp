#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "taut/calc/outcome.hpp"
#include "taut/solve/exact/loop_span.hpp"

/// Exact statics of a closed loop of two ropes (a running skyline): a traction rope from the head support A to a
/// carriage, a return rope from the carriage to the tail support B, over the sheave there and back to A. The carriage
/// is clamped to the lower branch, and its roller runs on the upper one at the end of a massless, hinged link. Every
/// span is an elastic catenary; weight per unstretched metre. x from A to B, z up; m, N, rad.
namespace taut::solve {

/// How the roller presses on the upper branch: across it without friction, so that the tension is the same on both
/// sides and the link leans with the force; or straight up and down, the link upright, so that the tension jumps.
enum class RollerLaw { free, vertical };

struct LoopRope {
  double weight = 0;                                           ///< N/m, >= 0
  double stiffness = std::numeric_limits<double>::infinity();  ///< EA, N
};

/// A second section of the carriage toward B, which carries the gathering force in place of the first.
struct SecondSection {
  double distance = 0;              ///< m, > 0
  bool along_rope = false;          ///< the distance is the unstretched rope between the sections, else horizontal
  bool sag_is_of_second = false;    ///< the given sag belongs to the second section
  bool place_is_of_second = false;  ///< and so does the given place
};

struct RunningLoop {
  double span = 0;                  ///< horizontal, m
  double rise = 0;                  ///< of B over A, m
  double branch_distance = 0;       ///< of the upper branch from the lower one, and of the roller from the clamp, m
  bool offset_is_vertical = false;  ///< the upper supports stand straight above the lower ones, else across the chord
  LoopRope traction_rope, return_rope;
  double efficiency = 1;          ///< T(upper branch at B)/T(lower branch at B); above 1 when the rope runs out
  double pull_x = 0, pull_z = 0;  ///< gathering force, toward B and up, N
  double carriage_weight = 0;     ///< N
  RollerLaw roller = RollerLaw::free;
  std::optional<SecondSection> second = std::nullopt;
};

/// Where the carriage is: horizontal distance from A and vertical depth below the line from A to B, m.
struct LoopPlace {
  double x = 0;
  double sag = 0;
};

struct LoopNode {
  double x = 0, z = 0;
};

struct LoopState {
  LoopSpan lower_A;                ///< A to the carriage
  LoopSpan between;                ///< first to second section, if there is one
  LoopSpan lower_B;                ///< carriage to B
  LoopSpan upper_A;                ///< A to the roller
  LoopSpan upper_B;                ///< roller to B
  LoopNode first, second, roller;  ///< clamp; second section (else as first); roller
  double R_x = 0, R_z = 0;         ///< force of the roller on the carriage: what the upper branch carries of it, N
  double lean = 0;                 ///< of the link, its top toward A when positive
  double traction_length = 0;      ///< unstretched, m
  double return_length = 0;
  double upper_sag = 0;  ///< of the roller below the line between the upper supports, m
  double delta_sag = 0;  ///< of the second section below the line from the first to the lower support at B, m
  double residual = 0;   ///< largest unbalanced force at a node, N
  double closure = 0;    ///< largest misfit of a span's end, m
  int iterations = 0;

  double loop_length() const { return traction_length + return_length; }
  double roller_force() const;
};

/// The equilibrium at a place: damped Newton with exact derivatives, on the logarithms of the horizontal tensions and
/// on the places of the nodes. It starts from `near`, a state of a similar case, or from the straight-rope solution;
/// when that fails and there is no `near`, it follows the equilibrium from a small sag. Infeasible, with the reason:
/// the roller would have to pull the rope down, a rope goes slack; `state` then is the last one reached. Preconditions:
/// 0 < place.x < span, place.sag > 0, the sections within the span, efficiency > 0.
Outcome solve_loop(const RunningLoop& loop, const LoopPlace& place, LoopState& state, const LoopState* near = nullptr);

/// What is given in place of the sag.
enum class LoopGiven {
  tension_at_A,        ///< of the traction rope, N
  length,              ///< unstretched, of the whole loop, m
  tension_at_carriage  ///< of the return rope, lower branch, N
};

/// A sag found, and the state there.
struct LoopSag {
  double sag = 0;
  double second = std::numeric_limits<double>::quiet_NaN();  ///< the next deeper sag that gives the same, if any
  LoopState state;
};

/// The smallest sag at which the loop has what is given, searched from a ten-thousandth of the span to twice the span
/// or to where the case ends (lift-off, slack rope). Infeasible: no sag has it; the message gives the possible range.
Outcome find_loop_sag(const RunningLoop& loop, double x, LoopGiven given, double value, LoopSag& found);

}  // namespace taut::solve
