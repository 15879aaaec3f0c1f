#include "taut/machine/compile/over_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace over_ground_test {

using namespace taut;
using namespace taut::machine;
using description::OverGround;

/// A machine with a support and a point over a ground that rises from 10 m at chainage 0 to 40 m at 60 m.
Machine on_slope(const OverGround& support) {
  Machine m;
  m.terrain.emplace();
  m.terrain->x = {0, 60};
  m.terrain->z = {10, 40};
  m.supports.emplace_back().name = "jack";
  m.supports.back().over_ground = support;
  return m;
}

void expect_at(const Triple& at, double x, double y, double z) {
  EXPECT_NEAR(at[0], x, 1e-12);
  EXPECT_NEAR(at[1], y, 1e-12);
  EXPECT_NEAR(at[2], z, 1e-12);
}

TEST(OverGround, ASupportStandsUprightOnASlope) {
  Machine m = on_slope({.chainage = 20, .over_ground = 9});
  std::vector<Complaint> complaints;
  const auto placed = stand_on_ground(m, complaints);
  ASSERT_TRUE(complaints.empty());
  expect_at(m.supports[0].at, 20, 0, 20 + 9);
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_EQ(placed[0].kind, "support");
  EXPECT_EQ(placed[0].name, "jack");
  EXPECT_EQ(placed[0].ground, 20);
}

TEST(OverGround, ItLeansTowardsGrowingChainageAndItsFootStays) {
  // 3-4-5: a support of 10 m leans by atan(3/4)
  Machine m = on_slope({.chainage = 20, .over_ground = 10, .lean = std::atan2(3, 4)});
  std::vector<Complaint> complaints;
  EXPECT_EQ(stand_on_ground(m, complaints)[0].ground, 20);
  expect_at(m.supports[0].at, 26, 0, 28);
  Machine back = on_slope({.chainage = 20, .over_ground = 10, .lean = -std::atan2(3, 4)});
  stand_on_ground(back, complaints);
  expect_at(back.supports[0].at, 14, 0, 28);
}

TEST(OverGround, TheOffsetIsToTheLeftOfTheLine) {
  Machine along_x = on_slope({.chainage = 20, .offset = 2, .over_ground = 0});
  std::vector<Complaint> complaints;
  stand_on_ground(along_x, complaints);
  expect_at(along_x.supports[0].at, 20, 2, 20);
  // seen along (0, 1) the left is -x
  Machine along_y = on_slope({.chainage = 20, .offset = 2, .over_ground = 0});
  along_y.terrain->along = {0, 3};
  along_y.terrain->from = {100, 50};
  stand_on_ground(along_y, complaints);
  expect_at(along_y.supports[0].at, 98, 70, 20);
  ASSERT_TRUE(complaints.empty());
}

TEST(OverGround, OnASurveyedLineBetweenTwoPoints) {
  // direction (0.6, 0.8) from (10, 20); rows off the line, unordered
  Machine m = on_slope({.chainage = 50, .offset = -5, .over_ground = 10, .lean = std::atan2(4, 3)});
  m.points = {{.name = "head", .body = {}, .at = {10, 20, 30}}, {.name = "tail", .body = {}, .at = {70, 100, 60}}};
  m.terrain->between = {"head", "tail"};
  m.terrain->x.clear();
  m.terrain->z.clear();
  for (const auto& [s, off, z] : {std::array{100.0, 1.0, 42.0}, std::array{0.0, -2.0, 2.0}}) {
    m.terrain->x.push_back(10 + 0.6 * s - 0.8 * off);
    m.terrain->y.push_back(20 + 0.8 * s + 0.6 * off);
    m.terrain->z.push_back(z);
  }
  std::vector<Complaint> complaints;
  const auto placed = stand_on_ground(m, complaints);
  ASSERT_TRUE(complaints.empty()) << complaints.front().message;
  EXPECT_NEAR(placed[0].ground, 22, 1e-12);
  // along the line 50 + 8 m, 5 m to the right of it: (0.8, -0.6)
  expect_at(m.supports[0].at, 10 + 0.6 * 58 + 0.8 * 5, 20 + 0.8 * 58 - 0.6 * 5, 22 + 6);
}

TEST(OverGround, EveryKindOfPlaceMayStandSo) {
  Machine m = on_slope({.chainage = 0, .over_ground = 1});
  const OverGround over{.chainage = 60, .over_ground = 2};
  m.points.emplace_back().over_ground = over;
  m.markers.emplace_back().over_ground = over;
  m.bodies.emplace_back().over_ground = over;
  m.sheaves.emplace_back().over_ground = over;
  m.drums.emplace_back().over_ground = over;
  m.carriages.emplace_back().over_ground = over;
  std::vector<Complaint> complaints;
  EXPECT_EQ(stand_on_ground(m, complaints).size(), 7U);
  for (const Triple& at : {m.points[0].at, m.markers[0].at, m.bodies[0].at, m.sheaves[0].at, m.drums[0].at,
                           m.carriages[0].at.value_or(Triple{})}) {
    expect_at(at, 60, 0, 42);
  }
}

TEST(OverGround, WhereThereIsNoGroundItIsAMistake) {
  const auto mistake = [](Machine m) {
    std::vector<Complaint> complaints;
    stand_on_ground(m, complaints);
    EXPECT_EQ(complaints.size(), 1U);
    return complaints.empty() ? Complaint{} : complaints.front();
  };
  for (const double outside : {-0.5, 60.5}) {
    const Complaint c = mistake(on_slope({.chainage = outside, .over_ground = 9}));
    EXPECT_EQ(c.path, "supports.jack.at.chainage");
    EXPECT_NE(c.message.find("from 0 m to 60 m"), std::string::npos) << c.message;
  }
  Machine bare = on_slope({.chainage = 20, .over_ground = 9});
  bare.terrain.reset();
  EXPECT_EQ(mistake(bare).path, "supports.jack.at");
  EXPECT_NE(mistake(bare).message.find("'terrain'"), std::string::npos);
  Machine on_body = on_slope({.chainage = 20, .over_ground = 9});
  on_body.supports[0].body = "frame";
  EXPECT_EQ(mistake(on_body).path, "supports.jack.body");
  // what is wrong with the terrain is reported once, and nothing else
  Machine wrong = on_slope({.chainage = 20, .over_ground = 9});
  wrong.terrain->z.push_back(1);
  EXPECT_EQ(mistake(wrong).path, "terrain.z");
}

TEST(OverGround, APointOfTheLineDoesNotStandOnIt) {
  Machine m = on_slope({.chainage = 20, .over_ground = 9});
  m.points = {{.name = "head", .body = {}, .at = {10, 20, 30}},
              {.name = "tail", .body = {}, .at = {}, .over_ground = OverGround{.chainage = 10, .over_ground = 1}}};
  m.terrain->between = {"head", "tail"};
  std::vector<Complaint> complaints;
  stand_on_ground(m, complaints);
  ASSERT_FALSE(complaints.empty());
  EXPECT_EQ(complaints.front().path, "terrain.between[1]");
}

}  // namespace over_ground_test
