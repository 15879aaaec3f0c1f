#include "taut/rope/exact_end.hpp"

#include <cmath>

namespace taut::rope {

using math::TwoDoubles;

ExactEnd exact_end(const CatenaryRope& rope, const CatenaryForce& f) {
  const TwoDoubles H_squared = math::exact_product(f.H, f.H);
  const TwoDoubles half = math::exact_product(rope.weight, rope.length / 2);
  Ends<TwoDoubles> e;
  e.V0 = normalized(f.V - half);
  e.V1 = normalized(f.V + half);
  e.T0 = sqrt(H_squared + e.V0 * e.V0);
  e.T1 = sqrt(H_squared + e.V1 * e.V1);
  e.sum = e.T0 + e.T1;
  if (e.sum.high == 0) return {};
  const TwoDoubles compliance =
      std::isinf(rope.stiffness) ? TwoDoubles{} : TwoDoubles{.high = rope.length} / rope.stiffness;
  const TwoDoubles by_mean = 2 * rope.length / e.sum;
  ExactEnd end;
  end.z = f.V * (compliance + by_mean);
  if (f.H == 0) return end;
  // a taut rope by atanh, where the logarithm is of a number near 1
  const TwoDoubles u = rope.weight / 2 * by_mean;
  const TwoDoubles I = u.high <= math::most_of_atanh_ratio
                           ? by_mean * atanh_ratio(u)
                           : log((e.sum + 2 * half) / gap_of(e, H_squared)) / rope.weight;
  end.x = f.H * (compliance + I);
  return end;
}

}  // namespace taut::rope
