#pragma once
#include "taut/math/two_doubles.hpp"
#include "taut/rope/catenary.hpp"

namespace taut::rope {

/// What the formulas of a catenary are made of: V and T at its ends. T: double or TwoDoubles.
template <class T>
struct Ends {
  T V0, V1, T0, T1, sum;  ///< sum = T0 + T1
};

/// T0 + T1 - w L, as a sum of positive terms: T + V loses its digits for V < 0, where it is H^2/(T - V).
template <class T>
T gap_of(const Ends<T>& e, const T& H_squared) {
  const T rise = static_cast<double>(e.V0) >= 0 ? e.T0 + e.V0 : H_squared / (e.T0 - e.V0);
  const T fall = static_cast<double>(e.V1) <= 0 ? e.T1 - e.V1 : H_squared / (e.T1 + e.V1);
  return rise + fall;
}

/// x and z of end_position, each relative to itself to 1e-21. For the last steps to a force: a rounding error of the
/// chord c of a taut rope is multiplied by EA/T in its tension.
struct ExactEnd {
  math::TwoDoubles x, z;
};
ExactEnd exact_end(const CatenaryRope& rope, const CatenaryForce& force);

}  // namespace taut::rope
