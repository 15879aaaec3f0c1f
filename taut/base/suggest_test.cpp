#include "taut/base/suggest.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace taut::suggest_test {

TEST(Suggest, CountsEdits) {
  EXPECT_EQ(edit_distance("diamter", "diameter"), 1);
  EXPECT_EQ(edit_distance("lenght", "length"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Suggest, FindsTheKeyThatWasMeant) {
  EXPECT_EQ(nearest("diamter", {"length", "diameter", "mass"}), "diameter");
  EXPECT_EQ(nearest("Span", {"span"}), "span");
  EXPECT_EQ(nearest("colour", {"length", "diameter"}), "");
  EXPECT_EQ(nearest("x", {"y"}), "");
}

RC_GTEST_PROP(Suggest, DistanceIsSymmetricAndZeroOnlyForEqualWords, (const std::string& a, const std::string& b)) {
  RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
  RC_ASSERT((edit_distance(a, b) == 0) == (a == b));
}

}  // namespace taut::suggest_test
