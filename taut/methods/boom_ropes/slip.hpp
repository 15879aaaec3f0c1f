#pragma once
#include <string>

#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes {

/// Luffing angle (rad) at which section 3 starts to slide in by its own weight when the extension rope is gone and the
/// pads do not jam: S_k + W sin(beta) = f_0 W cos(beta), with S_k = G_n zeta/K and W = G_3 + G_n; (5) with F = 0.
/// Negative: it slides in even below the horizontal. NaN when no angle can hold it.
double free_slip_angle(double section_weight, double suspended_weight, double friction, double tackle_efficiency,
                       int falls);

struct SlipAngle {
  double angle = unset;       ///< rad; NaN with a reason when section 3 slides at no angle up to 90 deg
  bool holds = false;         ///< at every angle: an answer, where the other reasons tell that there is none
  double free_angle = unset;  ///< the same without jamming
  bool jamming = false;       ///< pads carry on opposite sides at that angle
  std::string reason;
};

/// The same with the pad forces of the sliding model (jamming included): S_k + W sin(beta) = f_0 (|N_f| + |N_r|), at
/// the boom length of `slip` with its overlap changed by the jerk. The lowest angle in [-90, 90 deg] at which it holds;
/// below 0 section 3 slides in even where the boom points down.
SlipAngle slip_angle(const Input& in, const Sliding& sliding, const Slip& slip);

}  // namespace taut::boom_ropes
