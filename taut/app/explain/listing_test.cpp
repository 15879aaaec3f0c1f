#include "taut/app/explain/listing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace taut::app::listing_test {

TEST(Listing, AlignsNumbersRightAndWordsLeft) {
  EXPECT_EQ(aligned({{"id", "d"}, {"ab", "1.5"}, {"c", "100"}}), "id  d\nab  1.5\nc   100\n");
}

TEST(Listing, FiltersRopes) {
  ListFilter f;
  f.construction = "6x36";
  f.min_breaking_force = "150 kN";
  f.max_diameter = "20 mm";
  const auto text = list_text("ropes", f);
  ASSERT_TRUE(text.has_value());
  EXPECT_NE(text->find("EN 12385-4|6x36-IWRC|16|1960"), std::string::npos);
  EXPECT_EQ(text->find("|6x19"), std::string::npos);
  EXPECT_EQ(text->find("6x36-IWRC|8|"), std::string::npos);
}

TEST(Listing, KnowsAllLists) {
  for (const char* what : {"methods", "ropes", "sections", "steels", "rules", "units"}) {
    const auto text = list_text(what, {});
    ASSERT_TRUE(text.has_value()) << what;
    EXPECT_GT(std::count(text->begin(), text->end(), '\n'), 4) << what;
  }
}

TEST(Listing, SaysWhichFilterIsWrong) {
  ListFilter f;
  f.grade = "1960";
  EXPECT_NE(list_text("ropes", f).error().find("--grade '1960'"), std::string::npos);
  f = {};
  f.shape = "triangle";
  EXPECT_FALSE(list_text("sections", f).has_value());
  f = {};
  f.forming = "lukewarm";
  EXPECT_FALSE(list_text("sections", f).has_value());
  EXPECT_NE(list_text("rope", {}).error().find("did you mean 'ropes'"), std::string::npos);
}

/// A list that does not look at a filter would show all its rows as if they matched.
TEST(Listing, AFilterOfAnotherListIsRefused) {
  ListFilter f;
  f.name = "2688";
  f.shape = "CHS";
  const auto refused = list_text("ropes", f);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().find("--shape is for sections"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().find("--name is for methods, machines"), std::string::npos) << refused.error();
  EXPECT_NE(refused.error().find("ropes take --construction, --core"), std::string::npos) << refused.error();
  f = {};
  f.verified_only = true;
  EXPECT_FALSE(list_text("units", f).has_value());
  EXPECT_TRUE(list_text("carriages", f).has_value());
  EXPECT_NE(list_text("rope", f).error().find("there is no list of 'rope'"), std::string::npos);
}

TEST(Listing, VerifiedOnlyIsFewer) {
  ListFilter f;
  const auto all = list_text("ropes", f)->size();
  f.verified_only = true;
  EXPECT_LT(list_text("ropes", f)->size(), all);
}

}  // namespace taut::app::listing_test
