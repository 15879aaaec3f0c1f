#include "taut/report/figure/ruler.hpp"

#include <gtest/gtest.h>

namespace ruler_test {

using namespace taut::report;

TEST(Ruler, HasRoundNumbersInsideItsRange) {
  const Drawn r = ruler_level({.title = "x, m", .from = 3, .to = 97, .from_pixel = 0, .to_pixel = 500}, 100);
  for (const char* shown : {">20<", ">80<", ">x, m<"}) EXPECT_NE(r.svg.find(shown), std::string::npos) << shown;
  EXPECT_EQ(r.svg.find(">0<"), std::string::npos);
  EXPECT_EQ(r.svg.find(">100<"), std::string::npos);
  EXPECT_GT(r.box.right, 500);
}

TEST(Ruler, WithoutRoomThereIsNone) {
  EXPECT_TRUE(ruler_upright({.title = "z, m", .from = 0, .to = 1, .from_pixel = 20, .to_pixel = 0}, 0).svg.empty());
  EXPECT_TRUE(ruler_level({.title = "x, m", .from = 1, .to = 1, .from_pixel = 0, .to_pixel = 400}, 0).svg.empty());
}

TEST(Ruler, NumbersHaveTheDecimalsOfTheirTicks) {
  EXPECT_EQ(tick_text(-0.5, {-0.5, 0, 0.5}), "−0.5");
  EXPECT_EQ(tick_text(0, {-0.5, 0, 0.5}), "0.0");
  EXPECT_EQ(tick_text(20, {0, 20, 40}), "20");
}

}  // namespace ruler_test
