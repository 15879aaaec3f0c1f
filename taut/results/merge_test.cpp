#include "taut/results/merge.hpp"

#include <gtest/gtest.h>

namespace taut::results::merge_test {

TEST(Merge, WhatTheVerdictIsMadeOfComesAlong) {
  Result to;
  to.values = {{.name = "T_max", .value = 5, .unit = si::N, .symbol = "", .label = "", .source = ""}};
  Result from;
  from.values = {{.name = "T_max", .value = 7, .unit = si::N, .symbol = "", .label = "", .source = ""},
                 {.name = "x", .value = 1, .unit = si::m, .symbol = "", .label = "", .source = ""}};
  from.missing = {{.analysis = "sweep", .missing = 1, .places = 5, .first = "x = 2 m", .reason = "slack"}};
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
