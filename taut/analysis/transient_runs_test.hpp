#pragma once
#include <gtest/gtest.h>

#include "taut/analysis/transient.hpp"

/// Motions that have to end well, for the tests of motion.
namespace taut_test {

inline taut::analysis::TransientResult run_to_end(const taut::model::Model& m,
                                                  const taut::analysis::TransientOptions& options) {
  taut::analysis::TransientResult r = taut::analysis::transient(m, options);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  if (r.frames.empty()) r.frames.emplace_back();
  return r;
}

/// From one value to another without a jump of rate or acceleration.
inline taut::model::Signal smooth_move(double from, double to, double start, double over) {
  taut::model::Signal s;
  s.law = taut::model::Moves{from, {{start, to, over, true}}};
  return s;
}

}  // namespace taut_test
