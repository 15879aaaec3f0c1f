#include "taut/analysis/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/analysis/clearance.hpp"
#include "taut/analysis/load_path.hpp"
#include "taut/analysis/machines_test.hpp"
#include "taut/analysis/payload.hpp"

namespace limits_test {

using namespace taut_test;
using namespace taut::analysis;

TEST(Clearance, OfARopeIsThatOfAFineGrid) {
  model::Model m = with_carriage(true, 0.1, 1500);
  m.terrain = {{-10, 2}, {40, 21}, {70, 20}, {120, 36}, {160, 30}, {230, 55}, {310, 60}};
  EquilibriumOptions options;
  options.prescribed = Prescribed{0, 150};
  const EquilibriumResult e = equilibrium(m, options);
  ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
  for (const auto& [from, to] : {std::pair{0.0, 300.0}, {60.0, 110.0}, {280.0, 100.0}, {210.0, 215.0}}) {
    double least = 1e9;
    for (const SpanResult& s : e.spans) {
      if (s.reeving != 0) continue;
      for (int i = 0; i <= 20000; ++i) {
        const Vector3 p = s.start + taut::rope::point_at(s.shape, s.shape.rope.length * (i / 20000.0));
        if (p.x() < std::min(from, to) || p.x() > std::max(from, to)) continue;
        least = std::min(least, p.z() - ground_height(m.terrain, p.x()));
      }
    }
    const Lowest low = rope_clearance(m.terrain, e.spans, 0, from, to);
    EXPECT_LE(low.clearance, least + 1e-9);
    EXPECT_NEAR(low.clearance, least, 2e-3) << from << " to " << to;
    EXPECT_GE(low.x, std::min(from, to) - 1e-9);
    EXPECT_LE(low.x, std::max(from, to) + 1e-9);
  }
  EXPECT_TRUE(std::isinf(rope_clearance({}, e.spans, 0, 0, 300).clearance));
}

TEST(Limits, EachIsReachedByItsPayload) {
  model::Model m = with_carriage(true, 0.1, 200);
  m.terrain = {{0, 0}, {300, 60}};
  EquilibriumOptions options;
  options.prescribed = Prescribed{0, 150};
  options.motion = Motion::in;
  PayloadLimits pull;
  pull.ends = {{1, false, 3e3}};
  PayloadLimits rope;
  rope.rope_clearance = {2.5, -std::numeric_limits<double>::infinity()};
  rope.rope_from = 100;
  rope.rope_to = 190;
  PayloadLimits angle;
  angle.break_angle = 0.9;
  for (const auto& [limits, kind] :
       {std::pair{pull, LimitKind::pull}, {rope, LimitKind::rope_clearance}, {angle, LimitKind::break_angle}}) {
    const Payload p = payload(m, 0, limits, options);
    ASSERT_TRUE(p.outcome.ok()) << p.outcome.message;
    ASSERT_EQ(p.limit.kind, kind) << p.governing;
    EXPECT_GT(p.mass, 10);
    EXPECT_NEAR(p.limit.value / p.limit.limit, 1, 1e-7) << p.governing;
    model::Model loaded = m;
    for (const double share : {0.999, 1.001}) {
      loaded.bodies[0].mass = 200 + share * p.mass;
      const auto all = limits_at(loaded, 0, limits, equilibrium(loaded, options));
      const bool broken = std::any_of(all.begin(), all.end(), [](const LimitState& s) { return s.margin < 0; });
      EXPECT_EQ(broken, share > 1) << p.governing << " " << share;
    }
  }
}

TEST(Limits, LiftOffEndsThePayload) {
  // a support low between two high ones: the load beside it draws the rope out of it
  model::Model m;
  m.reevings.push_back(reeve("skyline",
                             {anchor("a", {0, 0, 10}), saddle("low", {100, 0, 1}, 0), anchor("b", {200, 0, 10})}, 201.6,
                             15, 500e6));
  m.bodies.push_back(body("car", {60, 0, 3}, 10, "xyz"));
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 1, over("car", origin, 0));
  m.carriages.push_back({"car", 0, 0, 1, -1});
  EquilibriumOptions options;
  options.prescribed = Prescribed{0, 60};
  PayloadLimits limits;
  limits.lift_off = true;
  limits.most = 20e3;
  const Payload p = payload(m, 0, limits, options);
  ASSERT_TRUE(p.outcome.ok()) << p.outcome.message;
  ASSERT_EQ(p.limit.kind, LimitKind::lift_off) << p.governing;
  EXPECT_EQ(p.governing, "lift-off from 'low'");
  m.bodies[0].mass = 10 + 0.999 * p.mass;
  EXPECT_LT(equilibrium(m, options).contacts[1].force.z(), 0) << "still presses on it";
  m.bodies[0].mass = 10 + 1.001 * p.mass;
  EXPECT_EQ(equilibrium(m, options).contacts[1].state, ContactState::pulled);
}

}  // namespace limits_test
