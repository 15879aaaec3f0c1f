#include "taut/catalogue/forestry/yarder.hpp"

#include <gtest/gtest.h>

namespace taut::catalogue::yarder_test {

constexpr const char* head =
    "yarder,drum,capacity_m,at_diameter_mm,core_mm,flange_mm,face_mm,pull_kN,hold_kN,tower_height_m,trust\n";

TEST(Yarders, BuiltInRowsAreSound) {
  ASSERT_FALSE(yarders().empty());
  for (const YarderRow& row : yarders()) {
    EXPECT_NE(row.drum_of("skyline"), nullptr) << row.name;
    EXPECT_NE(row.drum_of("mainline"), nullptr) << row.name;
    EXPECT_EQ(row.drum_of("winch"), nullptr);
    EXPECT_TRUE(row.tower_height.has_value()) << row.name;
    for (const YarderDrum& drum : row.drums) EXPECT_FALSE(drum.trust_text.empty()) << row.name;
  }
}

TEST(Yarders, OwnRows) {
  const auto own = read_yarders(std::string(head) +
                                    "mine,skyline,,,400,1000,600,90,,11,verified\n"
                                    "mine,mainline,650,11,,,,35,40,,derived\nother,mainline,1,8,,,,2,,,verified\n",
                                "mine.csv");
  ASSERT_TRUE(own.has_value()) << to_text(own.error());
  ASSERT_EQ(own->size(), 2U);
  const auto row = find_yarder("Mine", *own);
  ASSERT_TRUE(row.has_value());
  ASSERT_EQ(row->drums.size(), 2U);
  EXPECT_DOUBLE_EQ(*row->tower_height, 11);
  EXPECT_DOUBLE_EQ(*row->drum_of("skyline")->face, 0.6);
  EXPECT_DOUBLE_EQ(row->drum_of("mainline")->pull, 35e3);
  EXPECT_DOUBLE_EQ(*row->drum_of("mainline")->at_diameter, 0.011);
  EXPECT_NE(to_text(find_yarder("minf", *own).error()).find("'mine'"), std::string::npos);
}

TEST(Yarders, MistakesHaveTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "no rows"},
      {"a,skyline,,,,,,90,,,verified\n", "y.csv:2:3: error: a drum needs capacity_m"},
      {"a,skyline,600,,,,,90,,,verified\n", "stand together"},
      {"a,skyline,,,400,1000,,90,,,verified\n", "core_mm, flange_mm and face_mm stand together"},
      {"a,skyline,,,400,300,600,90,,,verified\n", "must be above core_mm"},
      {"a,skyline,150,22,300,1000,900,90,,,verified\n", "y.csv:2:11: error: a drum has a capacity, or core_mm"},
      {"a,skyline,60000,18,,,,90,,,verified\n", "60000 m are no rope"},
      {"a,skyline,600,0.018,,,,90,,,verified\n", "no diameter of a rope"},
      {"a,skyline,600,18,,,,90000,,,verified\n", "no pull of a yarder"},
      {"a,skyline,600,18,,,,90,80,,verified\n", "holds at least the pull"},
      {"a,skyline,600,18,,,,90,,,verified\na,skyline,600,18,,,,90,,,verified\n", "has a drum 'skyline' already"},
      {"a,skyline,600,18,,,,90,,,verified\nb,skyline,600,18,,,,90,,,verified\na,mainline,600,18,,,,90,,,verified\n",
       "must stand together"}};
  for (const auto& [text, expected] : rows) {
    const auto read = read_yarders(head + text, "y.csv");
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_NE(to_text(read.error()).find(expected), std::string::npos) << to_text(read.error());
  }
}

}  // namespace taut::catalogue::yarder_test
