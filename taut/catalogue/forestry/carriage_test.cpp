#include "taut/catalogue/forestry/carriage.hpp"

#include <gtest/gtest.h>

namespace taut::catalogue::carriage_test {

constexpr const char* head = "name,kind,mass_kg,payload_kg,rope_least_mm,rope_most_mm,rollers,wheelbase_m,trust\n";

TEST(Carriages, BuiltInRowsAreSound) {
  ASSERT_FALSE(carriages().empty());
  for (const CarriageRow& row : carriages()) {
    EXPECT_GT(row.payload, row.mass) << row.name;
    EXPECT_FALSE(row.trust_text.empty()) << row.name;
  }
  const auto moko = find_carriage("larix moko-25");
  ASSERT_TRUE(moko.has_value());
  EXPECT_EQ(moko->mass, 560);
  EXPECT_EQ(moko->payload, 2500);
  EXPECT_EQ(moko->trust, Trust::verified);
  EXPECT_FALSE(moko->rope_least.has_value());
}

// By hand: 35 kN over 9.81 m/s2 are 3568 kg; less 3000 kg of load.
TEST(Carriages, APlanningValueIsTheGrossLoadLessThePayload) {
  EXPECT_NEAR(find_carriage("SEILAPLAN 3 t")->mass, 35e3 / 9.81 - 3000, 0.5);
}

TEST(Carriages, OwnRows) {
  const auto own = read_carriages(std::string(head) + "mine,x,400,2000,16,20,2,0.9,verified\n", "mine.csv");
  ASSERT_TRUE(own.has_value()) << to_text(own.error());
  const auto row = find_carriage("MINE", *own);
  ASSERT_TRUE(row.has_value());
  EXPECT_EQ(row->rollers, 2);
  EXPECT_DOUBLE_EQ(*row->wheelbase, 0.9);
  EXPECT_DOUBLE_EQ(*row->rope_most, 0.02);
  const auto missed = find_carriage("mina", *own);
  ASSERT_FALSE(missed.has_value());
  EXPECT_NE(to_text(missed.error()).find("'mine'"), std::string::npos);
}

TEST(Carriages, MistakesHaveTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "no rows"},
      {"a,x,4,2000,,,,,verified\n", "c.csv:2:5: error: 4 kg is no mass"},
      {"a,x,400,2,,,,,verified\n", "c.csv:2:9: error: 2 kg is no mass"},
      {"a,x,400,,,,,,verified\n", "'payload_kg' is empty"},
      {"a,x,400,2000,20,16,,,verified\n", "is above rope_most_mm"},
      {"a,x,400,2000,20,,,,verified\n", "c.csv:2:17: error: rope_least_mm and rope_most_mm stand together"},
      {"a,x,400,2000,,20,,,verified\n", "c.csv:2:14: error: rope_least_mm and rope_most_mm stand together"},
      {"a,x,400,2000,,,1.5,,verified\n", "not a number of rollers"},
      {"a,x,400,2000,,,,1,verified\n", "needs at least two 'rollers'"},
      {"a,x,400,2000,,,,,sure\n", "not verified, derived or unverified"},
      {"a,x,400,2000,,,,,verified\na,x,400,2000,,,,,verified\n", "already in line 2"}};
  for (const auto& [text, expected] : rows) {
    const auto read = read_carriages(head + text, "c.csv");
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_NE(to_text(read.error()).find(expected), std::string::npos) << to_text(read.error());
  }
}

}  // namespace taut::catalogue::carriage_test
