// Carriages that nothing holds: where they come to rest, and where they run to.
#include "taut/solve/rest/roll.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"

namespace roll_test {

using namespace taut_test;
using namespace taut::solve;

constexpr double g = 9.80665;

/// A free carriage on a span of this rise.
machine::Model free_carriage(double rise, double length, double mass) {
  machine::Model m;
  m.bodies.push_back(body("car", {50, 0, 10}, mass, "xyz"));
  m.reevings.push_back(reeve(
      "skyline", {anchor("head", {0, 0, 0}), over("car", origin, 0), anchor("tail", {100, 0, rise})}, length, 15, 2e7));
  m.carriages.push_back({"car", 0, 0, 1, {}});
  return m;
}

TEST(FreeRolling, StandsWhereTheBisectorIsUpright) {
  for (const double rise : {0.0, 10.0, 25.0, -25.0}) {
    for (const double excess : {1.02, 1.1, 1.3}) {
      const machine::Model m = free_carriage(rise, excess * std::hypot(100, rise), 2000);
      const EquilibriumResult r = equilibrium(m);
      if (!r.outcome.ok()) {
        // only where the rope has no lowest point within the span
        EXPECT_NE(r.outcome.message.find("runs to the end at"), std::string::npos) << r.outcome.message;
        EXPECT_LT(excess, 1.1);
        continue;
      }
      EXPECT_NEAR(r.branches[0].H / r.branches[1].H, 1, 1e-6);
      EXPECT_NEAR(-r.branches[0].V_to / r.branches[1].V_from, 1, 1e-6);
      EXPECT_NEAR(r.branches[1].V_from - r.branches[0].V_to, 2000 * g, 1e-3);
    }
  }
}

TEST(FreeRolling, WhereItCannotStandTheReasonNamesItAndTheEnd) {
  const EquilibriumResult up = equilibrium(free_carriage(60, 116.3, 50));
  ASSERT_FALSE(up.outcome.ok());
  EXPECT_EQ(up.outcome.status, taut::Status::infeasible);
  EXPECT_NE(up.outcome.message.find("'car'"), std::string::npos) << up.outcome.message;
  EXPECT_NE(up.outcome.message.find("runs to the end at 'head'"), std::string::npos) << up.outcome.message;
  const EquilibriumResult down = equilibrium(free_carriage(-60, 116.3, 50));
  ASSERT_FALSE(down.outcome.ok());
  EXPECT_NE(down.outcome.message.find("runs to the end at 'tail'"), std::string::npos) << down.outcome.message;
}

}  // namespace roll_test
