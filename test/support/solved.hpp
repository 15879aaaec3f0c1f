#pragma once
#include <gtest/gtest.h>

#include "taut/calc/outcome.hpp"

namespace taut_test {

/// What a method gives for an input that it must be able to solve.
template <class Output, class Input>
Output solved_as(const Input& in) {
  Output out;
  const taut::Outcome outcome = solve(in, out);
  EXPECT_TRUE(outcome.ok()) << outcome.message;
  return out;
}

}  // namespace taut_test
