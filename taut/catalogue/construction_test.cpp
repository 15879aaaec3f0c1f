#include "taut/catalogue/construction.hpp"

#include <gtest/gtest.h>

namespace taut::catalogue::construction_test {

TEST(Construction, is_taken_apart) {
  const auto simple = parse_construction("6 x 36 WS - IWRC");
  ASSERT_TRUE(simple);
  EXPECT_EQ(simple->strands, 6);
  EXPECT_EQ(simple->wires, 36);
  EXPECT_EQ(simple->lay, "ws");
  EXPECT_EQ(simple->core, "IWRC");

  const auto gost = parse_construction("6x19(1+6+6/6)+1 o.c.");
  ASSERT_TRUE(gost);
  EXPECT_EQ(gost->lay, "w");
  EXPECT_EQ(gost->layers, "1+6+6/6");
  EXPECT_EQ(gost->core, "FC");

  EXPECT_EQ(parse_construction("6x19(1+9+9)+7x7")->core, "IWRC");
  EXPECT_EQ(parse_construction("8xK36WS"), std::nullopt);  // the K stands after the number in our tables
  EXPECT_EQ(parse_construction("8x36KWS")->lay, "kws");
  EXPECT_EQ(parse_construction("compacted"), std::nullopt);
  EXPECT_EQ(parse_construction("6x"), std::nullopt);
  EXPECT_EQ(parse_construction("x36"), std::nullopt);
  EXPECT_EQ(parse_construction("6x36(1+7"), std::nullopt);
  EXPECT_EQ(parse_construction("99999999999999999999x36"), std::nullopt);
  EXPECT_EQ(parse_construction(""), std::nullopt);
}

TEST(Construction, cores) {
  EXPECT_EQ(parse_core("fc"), "FC");
  EXPECT_EQ(parse_core("NFC"), "FC");
  EXPECT_EQ(parse_core("iwrc"), "IWRC");
  EXPECT_EQ(parse_core("WSC"), "WSC");
  EXPECT_FALSE(parse_core("oak"));
}

TEST(Construction, a_class_is_met_by_its_members) {
  for (const char* listed : {"6x36", "6x36WS", "6x36(1+7+7/7+14)"}) {
    EXPECT_TRUE(matches_construction("6x36", listed)) << listed;
    EXPECT_TRUE(matches_construction("6X36 WS", listed)) << listed;
    EXPECT_TRUE(matches_construction("6\u00d736-IWRC", listed)) << listed;
  }
  EXPECT_TRUE(matches_construction("6x19S", "6x19(1+9+9)"));
  EXPECT_TRUE(matches_construction("6x25FW", "6x25(1+6;6+12)+7x7"));
}

TEST(Construction, but_not_by_others) {
  EXPECT_FALSE(matches_construction("6x36", "6x37M"));
  EXPECT_FALSE(matches_construction("6x36", "8x36"));
  EXPECT_FALSE(matches_construction("6x3", "6x36"));
  EXPECT_FALSE(matches_construction("6x19", "6x19M"));  // cross lay: less force from the same diameter
  EXPECT_FALSE(matches_construction("6x19M", "6x19"));
  EXPECT_FALSE(matches_construction("6x36K", "6x36"));
  EXPECT_FALSE(matches_construction("6x19S", "6x19(1+6+6/6)"));  // Warrington
  EXPECT_FALSE(matches_construction("6x19(1+9+9)", "6x19(1+6+6/6)"));
  EXPECT_FALSE(matches_construction("6x36", "compacted"));
  EXPECT_FALSE(matches_construction("", "compacted"));
  EXPECT_TRUE(matches_construction("Compacted", "compacted"));
  EXPECT_TRUE(matches_construction("6x37m", "6x37M"));
}

}  // namespace taut::catalogue::construction_test
