#include "taut/calc/value_kind.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace taut::value_kind_test {

TEST(ValueKind, TheWordInCapitalsBecomesTheName) {
  EXPECT_EQ(name_with("ROPE.T_max", "skyline"), "skyline.T_max");
  EXPECT_EQ(name_with("frequency_N", "2"), "frequency_2");
  EXPECT_EQ(name_with("OBSERVED_min", "car.z"), "car.z_min");
  EXPECT_EQ(name_with("T_max", "skyline"), "T_max");
  EXPECT_EQ(name_with("", "skyline"), "");
}

TEST(ValueKind, AValueFollowsFromIt) {
  const std::vector<ValueKind> kinds = {
      {.about = {.name = "ROPE.safety_factor",
                 .symbol = "ROPE.S",
                 .unit = si::one,
                 .words = "breaking force over the largest tension"},
       .of = "every rope",
       .page = "theory/rope-checks.md"},
      {.about = {.name = "ROPE.length", .symbol = "", .unit = si::m, .words = "length", .detail = true},
       .of = "every rope",
       .page = ""}};
  const Value factor = make_value(named(kinds, "ROPE.safety_factor"), "skyline", "_2", 3.5, "at rest");
  EXPECT_EQ(factor.name, "skyline.safety_factor_2");
  EXPECT_EQ(factor.symbol, "skyline.S");
  EXPECT_EQ(factor.label, "at rest");
  EXPECT_EQ(factor.value, 3.5);
  EXPECT_FALSE(factor.detail);
  const Value length = make_value(named(kinds, "ROPE.length"), "skyline", "_2", 12, "");
  EXPECT_EQ(length.symbol, "skyline.length_2");
  EXPECT_EQ(length.unit.symbol, "m");
  EXPECT_TRUE(length.detail);
  EXPECT_THROW(named(kinds, "ROPE.lenght"), std::logic_error);
}

}  // namespace taut::value_kind_test
