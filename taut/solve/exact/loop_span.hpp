#pragma once
#include <optional>

#include "taut/rope/catenary.hpp"

namespace taut::solve {

/// A rope between two points whose horizontal tension is given: its unstretched length and its vertical forces follow.
/// Forces N, lengths m; V is upwards, positive where the rope rises toward its end.
struct LoopSpan {
  rope::CatenaryRope rope;
  rope::CatenaryForce force;  ///< in the middle of the rope
  double V_start = 0, V_end = 0;
  double T_start = 0, T_end = 0;
  double closure = 0;  ///< distance of the rope's computed end from the given one
};

/// How V_start, V_end and the unstretched length change with the horizontal tension and with the end's place.
struct LoopSpanRates {
  double V_start_H = 0, V_start_x = 0, V_start_z = 0;
  double V_end_H = 0, V_end_x = 0, V_end_z = 0;
  double L_H = 0, L_x = 0, L_z = 0;
};

/// The span from its start to an end `x` > 0 beside and `z` above it, with the horizontal tension `H` > 0, weight per
/// unstretched metre >= 0 and stiffness EA > 0 (infinite: does not stretch). Inextensible: closed form; elastic: Newton
/// from there. Empty when no rope of positive length has that tension (EA too small), or when the rope is so slack that
/// its ends leave the range of numbers.
std::optional<LoopSpan> span_at_tension(double weight, double stiffness, double H, double x, double z);

/// Exact derivatives of a solved span.
LoopSpanRates rates_of(const LoopSpan& span);

}  // namespace taut::solve
