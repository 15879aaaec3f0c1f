#include "taut/catalogue/rope_words.hpp"

#include <gtest/gtest.h>

namespace taut::catalogue::rope_words_test {

TEST(RopeWords, AnyOrder) {
  for (const char* text : {"EN 12385-4|6x36-IWRC|16|1960", "6x36-IWRC 16 mm 1960 MPa", "16mm 6x36 IWRC 1960MPa",
                           "1960 N/mm2 EN 12385-4 6x36 IWRC 16 mm"}) {
    const auto rope = find_rope_in_words(text);
    ASSERT_TRUE(rope.has_value()) << text << ": " << to_text(rope.error());
    EXPECT_EQ(rope->id, "EN 12385-4|6x36-IWRC|16|1960") << text;
  }
}

TEST(RopeWords, ItsOwnWordsNameTheRope) {
  EXPECT_EQ(words_of_rope(*find_rope("EN 12385-4|6x36-IWRC|16|1960")), "EN 12385-4 6x36-IWRC 16 mm 1960 MPa");
  int tried = 0;
  for (const RopeRow& row : ropes()) {
    if (row.construction.find('(') != std::string::npos || row.construction.find('x') == std::string::npos) continue;
    const auto found = find_rope_in_words(words_of_rope(row));
    ASSERT_TRUE(found.has_value()) << words_of_rope(row) << ": " << found.error().message;
    EXPECT_EQ(found->id, row.id);
    ++tried;
  }
  EXPECT_GT(tried, 50);
}

TEST(RopeWords, TakesTheWordsApart) {
  const RopeDescription d = describe_rope("EN 12385-4 6x36 FC 20 mm 1770 MPa");
  EXPECT_EQ(d.standard, "EN 12385-4");
  EXPECT_EQ(d.construction, "6x36");
  EXPECT_EQ(d.core, "FC");
  EXPECT_DOUBLE_EQ(d.diameter, 0.020);
  EXPECT_DOUBLE_EQ(d.grade.value(), 1770e6);
}

TEST(RopeWords, SaysWhatIsMissing) {
  EXPECT_FALSE(find_rope_in_words("6x36 IWRC").has_value());
  EXPECT_FALSE(find_rope_in_words("16 mm").has_value());
  const auto rope = find_rope_in_words("6x36-IWRC 16.5 mm 1960 MPa");
  ASSERT_FALSE(rope.has_value());
  EXPECT_FALSE(rope.error().message.empty());
}

}  // namespace taut::catalogue::rope_words_test
