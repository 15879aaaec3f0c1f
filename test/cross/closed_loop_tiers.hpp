#pragma once
#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/closed_loop/position.hpp"

namespace taut::closed_loop::exact_tiers {

/// All tiers with the exact column, for one position.
struct Solved {
  Outcome outcome;
  Output out;
};

inline Solved solved(const Input& in) {
  Solved s;
  Sheet<double> silent;
  Ropes ropes;
  s.outcome = ropes_of(in, ropes, taut::app::loop_engine());
  if (s.outcome.ok()) s.outcome = solve_position(in, setting_of(in, ropes, 0, taut::app::loop_engine()), silent, s.out);
  return s;
}

}  // namespace taut::closed_loop::exact_tiers
