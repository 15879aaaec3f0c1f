#include "taut/machine/compile/terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace terrain_test {

using namespace taut;
using namespace taut::machine;

struct Built {
  Model model;
  std::vector<Complaint> complaints;
};

Built build(const description::Terrain& given) {
  Machine machine;
  machine.bodies = {
      {.name = "cart", .mass = 10, .at = {}, .centre = {}, .free = {"x"}, .guide = {}, .inertia = {}, .motion = {}}};
  machine.points = {{.name = "head", .body = {}, .at = {10, 20, 30}},
                    {.name = "tail", .body = {}, .at = {70, 100, 60}},
                    {.name = "over", .body = {}, .at = {10, 20, 0}},
                    {.name = "eye", .body = "cart", .at = {0, 0, 0}}};
  Built built;
  const Links links(machine, built.complaints);
  add_terrain(given, links, built.model, built.complaints);
  return built;
}

/// A survey along the line from (10, 20) to (70, 100), direction (0.6, 0.8), each row so far along and off it.
description::Terrain survey(const std::vector<Vector3>& rows) {
  description::Terrain t;
  for (const Vector3& row : rows) {
    t.x.push_back(10 + 0.6 * row.x() - 0.8 * row.y());
    t.y.push_back(20 + 0.8 * row.x() + 0.6 * row.y());
    t.z.push_back(row.z());
  }
  return t;
}

void expect_ground(const Model& model, const std::vector<GroundPoint>& expected) {
  ASSERT_EQ(model.terrain.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(model.terrain[i].x, expected[i].x, 1e-12) << i;
    EXPECT_EQ(model.terrain[i].z, expected[i].z) << i;
  }
}

TEST(TerrainLine, OfASurveyRunsBetweenTwoPointsOrFirstAndLastRow) {
  description::Terrain t = survey({{-5, 1, 3}, {40, -2, 8}, {15, 6, 4}, {110, 1, 9}});
  t.between = {"head", "tail"};
  Built b = build(t);
  ASSERT_TRUE(b.complaints.empty()) << b.complaints.front().message;
  expect_ground(b.model, {{.x = -5, .z = 3}, {.x = 15, .z = 4}, {.x = 40, .z = 8}, {.x = 110, .z = 9}});
  EXPECT_NEAR(terrain_x(b.model, {70, 100, 5}), 100, 1e-12);
  EXPECT_EQ(b.model.terrain_off_line.rows, 1);
  EXPECT_EQ(b.model.terrain_off_line.farthest, 3);
  EXPECT_NEAR(b.model.terrain_off_line.distance, 6, 1e-12);
  EXPECT_NEAR(b.model.terrain_off_line.chainage, 15, 1e-12);
  // seen from the other end
  t.between = {"tail", "head"};
  b = build(t);
  expect_ground(b.model, {{.x = -10, .z = 9}, {.x = 60, .z = 8}, {.x = 85, .z = 4}, {.x = 105, .z = 3}});
  // first and last row are on a parallel, 1 m beside
  t.between.clear();
  t.corridor = 2.5;
  b = build(t);
  expect_ground(b.model, {{.x = 0, .z = 3}, {.x = 20, .z = 4}, {.x = 45, .z = 8}, {.x = 115, .z = 9}});
  EXPECT_EQ(b.model.terrain_off_line.rows, 2);
  EXPECT_NEAR(b.model.terrain_off_line.distance, 5, 1e-12);
  t.corridor = 5.5;
  EXPECT_EQ(build(t).model.terrain_off_line.rows, 0);
  // the line by its beginning and direction
  t.from = {10, 20};
  t.along = {6, 8};
  expect_ground(build(t).model, {{.x = -5, .z = 3}, {.x = 15, .z = 4}, {.x = 40, .z = 8}, {.x = 110, .z = 9}});
}

TEST(TerrainLine, OfAProfileBeginsAtTheFirstOfTwoPoints) {
  description::Terrain t;
  t.x = {-10, 50, 120};
  t.z = {1, 2, 3};
  t.between = {"head", "tail"};
  const Built b = build(t);
  ASSERT_TRUE(b.complaints.empty());
  expect_ground(b.model, {{.x = -10, .z = 1}, {.x = 50, .z = 2}, {.x = 120, .z = 3}});
  EXPECT_NEAR(terrain_x(b.model, {40, 60, 0}), 50, 1e-12);
  EXPECT_EQ(b.model.terrain_off_line.rows, 0);
}

TEST(TerrainLine, RefusesWhatIsNoLine) {
  const auto message = [](const description::Terrain& t) {
    const Built b = build(t);
    return b.complaints.empty() ? std::string{} : b.complaints.front().path + ": " + b.complaints.front().message;
  };
  const auto expect = [&](const description::Terrain& t, const std::string& words) {
    EXPECT_NE(message(t).find(words), std::string::npos) << message(t);
  };
  const description::Terrain good = survey({{0, 0, 1}, {50, 0, 2}, {90, 0, 3}});
  description::Terrain t = good;
  t.between = {"head", "over"};
  expect(t, "terrain.between: the line has no length in plan");
  t.between = {"head", "eye"};
  expect(t, "terrain.between: 'eye' is on a body");
  t.between = {"head", "tial"};
  expect(t, "did you mean 'tail'");
  t.between = {"head"};
  expect(t, "terrain.between: the names of two points");
  t.between = {"head", "tail"};
  t.from = {0, 0};
  expect(t, "terrain.between: gives the line already");
  t = good;
  t.y.pop_back();
  expect(t, "terrain.y: 2 values of y for 3 of x");
  expect(survey({{0, 0, 1}, {50, 0, 2}, {50, 9, 7}, {90, 0, 3}}), "rows 2 and 3 of the survey lie at one place");
  expect(survey({{0, 0, 1}, {50, 0, 2}, {0, 0, 1}}), "the line has no length in plan");
}

}  // namespace terrain_test
