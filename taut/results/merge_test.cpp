#include "taut/results/merge.hpp"

#include <gtest/gtest.h>

namespace taut::results::merge_test {

TEST(Merge, WhatTheVerdictIsMadeOfComesAlong) {
  Result to;
  to.values = {{"T_max", 5, si::N, "", "", ""}};
  Result from;
  from.values = {{"T_max", 7, si::N, "", "", ""}, {"x", 1, si::m, "", "", ""}};
  from.missing = {{"sweep", 1, 5, "x = 2 m", "slack"}};
  from.unmade = {"a"};
  from.preface = "The deck breaks a rope at 1 s";
  warn_unsafe(from, "slack");
  append(from, to);
  ASSERT_EQ(to.values.size(), 2U);
  EXPECT_EQ(to.find_value("T_max")->value, 7) << "the larger one stays";
  EXPECT_EQ(to.missing.size(), 1U);
  EXPECT_EQ(to.unmade.size(), 1U);
  EXPECT_EQ(to.unsafe.size(), 1U);
  EXPECT_EQ(to.warnings.size(), 1U);
  EXPECT_EQ(to.preface, "The deck breaks a rope at 1 s");
}

}  // namespace taut::results::merge_test
