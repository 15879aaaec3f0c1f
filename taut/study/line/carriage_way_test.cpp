#include "taut/study/line/carriage_way.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "test/support/machines.hpp"

namespace taut::study::carriage_way_test {

/// Places in the order of the way; those on a support as -1.
std::vector<double> places(const machine::Model& model, const Way& way) {
  std::vector<double> all;
  for (const WayPart& part : parts_of(model, way)) {
    if (part.support != nullptr) {
      all.push_back(-1);
      continue;
    }
    const LoadPathOptions over = path_over(way, part);
    all.push_back(over.from);
    if (part.last > part.first) all.push_back(over.to);
  }
  return all;
}

Way way(double from, double to, int steps) { return {.carriage = 0, .from = from, .to = to, .steps = steps}; }

/// The carriage of that line with two rollers 2 m apart.
machine::Model long_carriage() {
  machine::Model m = taut_test::with_carriage(false);
  machine::Reeving& rope = m.reevings[0];
  machine::Carriage& car = m.carriages[0];
  const machine::Node roller = rope.nodes[car.node];
  rope.nodes.insert(rope.nodes.begin() + car.node + 1, roller);
  rope.nodes[car.node].at.at.x() = -1;
  rope.nodes[car.node + 1].at.at.x() = 1;
  car.rollers = 2;
  return m;
}

TEST(CarriageWay, HasPlacesBesideEachSupportBetweenItsSteps) {
  const machine::Model m = taut_test::with_carriage(false);
  const double jack = m.reevings[0].nodes[1].at.at.x(), radius = m.reevings[0].nodes[1].radius;
  const double before = jack - radius - 1, behind = jack + radius + 1;
  EXPECT_EQ(places(m, way(jack - 10, jack + 10, 1)), (std::vector<double>{jack - 10, before, behind, jack + 10}));
  EXPECT_EQ(places(m, way(jack + 10, jack - 10, 1)), (std::vector<double>{jack + 10, behind, before, jack - 10}));
  EXPECT_EQ(places(m, way(jack - 10, jack + 10, 2)), (std::vector<double>{jack - 10, before, -1, behind, jack + 10}))
      << "one step is on it";
  EXPECT_EQ(places(m, way(jack, jack + 10, 1)), (std::vector<double>{-1, behind, jack + 10})) << "the first step too";
  EXPECT_EQ(places(m, way(jack - 0.5, jack + 0.5, 1)), (std::vector<double>{jack - 0.5, jack + 0.5}))
      << "the steps are nearer";
  EXPECT_EQ(places(m, way(0, 20, 1)), (std::vector<double>{-1, 20})) << "an end of the rope is not passed";
  EXPECT_EQ(places(m, way(jack + 5, jack + 10, 1)), (std::vector<double>{jack + 5, jack + 10}));
}

/// Two sheaves 1 m apart, anchors 0.5 m behind them: 0.1 m and 0.05 m beside the rounds of 20 mm.
TEST(CarriageWay, OnAShortSpanATenthOfItIsBeside) {
  machine::Model m;
  m.bodies.push_back(taut_test::body("car", {0.5, 0, 0.7}, 1, "xyz"));
  const auto jack = [](double x) { return taut_test::sheave("jack", {x, 0, 0.8}, 0.02, 1); };
  m.reevings.push_back(
      taut_test::reeve("sky",
                       {taut_test::anchor("a", {-0.5, 0, 0}), jack(0), taut_test::over("car", Vector3::Zero(), 0),
                        jack(1), taut_test::anchor("b", {1.5, 0, 0})},
                       3, 0.02, 1e5));
  m.carriages.push_back({"car", 0, 0, 2, {}});
  const std::vector<double> all = places(m, way(-0.25, 0.5, 1));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_NEAR(all[1], -0.07, 1e-12);
  EXPECT_NEAR(all[2], 0.12, 1e-12);
  EXPECT_EQ(places(m, way(0.1, 0.9, 16)), (std::vector<double>{0.1, 0.9})) << "all in one span";
  EXPECT_EQ(left_out_words(m, way(0.1, 0.9, 16), Display{}), std::nullopt) << "the nearest ones are its ends";
  // 0.025 to 0.1 and 0.9 to 0.975 lie within 0.11 m of the sheaves
  const auto words = left_out_words(m, way(0, 1, 40), Display{});
  ASSERT_TRUE(words);
  EXPECT_EQ(left_out_words(m, way(0, 1, 10), Display{}), std::nullopt) << "the places beside stand for 0.1 m and 0.9 m";
  EXPECT_EQ(words->substr(0, words->find(" are")), "8 of 41 places") << *words;
}

TEST(CarriageWay, ACarriageIsOnASupportUntilItsRollersAreClear) {
  const machine::Model m = long_carriage();
  const double jack = m.reevings[0].nodes[1].at.at.x(), reach = m.reevings[0].nodes[1].radius + 1;
  EXPECT_NE(support_at(m, 0, jack - reach + 1e-3, Vector3::UnitX()), nullptr);
  EXPECT_EQ(support_at(m, 0, jack - reach - 1e-3, Vector3::UnitX()), nullptr);
  const std::vector<double> all = places(m, way(jack - 10, jack + 10, 1));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_NEAR(all[1], jack - reach - 0.01, 1e-12);
  EXPECT_NEAR(all[2], jack + reach + 0.01, 1e-12);
}

}  // namespace taut::study::carriage_way_test
