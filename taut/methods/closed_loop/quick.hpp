#pragma once
#include <optional>

#include "taut/methods/closed_loop/case.hpp"

namespace taut::closed_loop {

/// The closed-form tier: parabolic ropes, but the roller presses normal to the mean direction of the upper branch, end
/// tensions are the full sqrt(H^2 + V^2), and the sheave relates the true tensions. Forces in N.
/// H_1..H_4: horizontal tensions of the lower branch left and right of the carriage, of the upper left and right.
template <class T>
struct Quick {
  T m_x{};  ///< slope of the mean rope direction at the carriage, tan(beta); 0 for a vertical roller
  T P_v;    ///< vertical part of the roller force on the upper branch
  T N;      ///< roller force
  T P_b;    ///< its oblique vertical part, to be compared with (1)
  T H_1;
  T H_2;
  T H_3;
  T H_4;
  T T_uA;
  T T_uB;
  T T_lA;
  T T_lB;
  T T_U;    ///< the larger of the two tensions of the upper branch at the carriage
  T T_lLA;  ///< lower branch at the carriage, on A's side
  T T_lLB;  ///< and on B's side
};

/// Horizontal tensions and roller force of one pass; all finite.
struct Pass {
  double m_x = 0;
  double rho = 0;  ///< ratio of the horizontal tensions over the sheave, H_4/H_2
  double P_v = 0;
  double H_1 = 0;
  double H_2 = 0;
  double H_3 = 0;
  double H_4 = 0;
  int passes = 0;
  bool converged = false;
};

/// tan of the mean of the two angles whose tangents are a and b, without arc functions.
template <class T>
T tan_of_mean(const T& a, const T& b) {
  using std::sqrt;
  const T u = sqrt(1.0 + a * a);
  const T v = sqrt(1.0 + b * b);
  return (a * v + b * u) / (u + v);
}

/// Repeats m_x and rho until they stand still to 1e-12. Stops early, not converged, when a rope goes slack on the way.
Pass settle(const Case<double>& c);

/// A settled tier with its tensions; empty when it did not settle, the roller lifts off or a rope is slack.
std::optional<Quick<double>> quick(const Case<double>& c);

/// The closed-form tier as a calculation note. Infeasible: P_v <= 0 (lift-off), a slack rope. `q` keeps what was
/// reached.
template <class T>
Outcome quick_tensions(const Case<T>& c, const Case<double>& plain, Sheet<T>& s, Quick<T>& q);

}  // namespace taut::closed_loop
