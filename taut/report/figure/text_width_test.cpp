#include "taut/report/figure/text_width.hpp"

#include <gtest/gtest.h>

namespace text_width_test {

using namespace taut::report;

TEST(TextWidth, IsThatOfHelveticaAndALittleMore) {
  EXPECT_NEAR(text_width("00", 10), 1.08 * 2 * 5.56, 1e-9);
  EXPECT_GT(text_width("mm", 10), 3 * text_width("ii", 10));
  EXPECT_EQ(text_width("", 10), 0);
}

TEST(TextWidth, LettersOutsideTheTableAreWide) {
  EXPECT_GT(text_width("Щ", 10), text_width("w", 10));
  EXPECT_GT(text_width("索", 10), text_width("m", 10));
  EXPECT_GT(text_width("\xd0", 10), 0) << "half a letter";
}

TEST(TextWidth, SubscriptsAreNarrower) {
  const double whole = text_width(Runs{{.text = "max", .style = Run::Style::plain}}, 10);
  EXPECT_LT(text_width(Runs{{.text = "max", .style = Run::Style::subscript}}, 10), whole);
}

}  // namespace text_width_test
