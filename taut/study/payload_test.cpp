#include "taut/study/payload.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "taut/base/expects.hpp"
#include "test/support/machines.hpp"

namespace payload_test {

namespace solve = taut::solve;

using namespace taut_test;
using namespace taut::study;
using taut::Status;

constexpr double none = std::numeric_limits<double>::infinity();

TEST(Payload, OfATackleIsItsFallsTimesTheRope) {
  const machine::Model m = tackle(4, 1, 500);
  PayloadLimits limits;
  limits.tension = {10e3};
  const Payload p = payload(m, 0, limits);
  ASSERT_TRUE(p.outcome.ok()) << p.outcome.message;
  EXPECT_NEAR(p.mass, 40e3 / m.gravity - 500, 1e-5);
  EXPECT_EQ(p.governing, "tension of 'hoist'");
  EXPECT_LE(p.at.ropes[0].T_max, 10e3);
}

/// The lowest place of the carriage that friction may hold it in.
double lowest(const solve::EquilibriumResult& at) {
  double z = at.state.bodies[0].position.z();
  for (const solve::EquilibriumResult& bound : at.bounds) z = std::min(z, bound.state.bodies[0].position.z());
  return z;
}

TEST(Payload, TheFirstLimitReachedGoverns) {
  machine::Model m = with_carriage(true, 0.1, 200);
  m.terrain = {{.x = 0, .z = 0}, {.x = 300, .z = 60}};
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  PayloadLimits limits;
  limits.tension = {40e3, none};
  const Payload by_rope = payload(m, 0, limits, options);
  ASSERT_TRUE(by_rope.outcome.ok()) << by_rope.outcome.message;
  EXPECT_EQ(by_rope.reeving, 0);
  EXPECT_NEAR(by_rope.at.ropes[0].T_max / 40e3, 1, 1e-8);
  const double z = lowest(by_rope.at);
  limits.clearance = z - 30 + 0.5;  // half a metre more than it leaves
  const Payload by_ground = payload(m, 0, limits, options);
  ASSERT_TRUE(by_ground.outcome.ok());
  EXPECT_EQ(by_ground.governing, "clearance of 'car'");
  EXPECT_LT(by_ground.mass, by_rope.mass);
  EXPECT_NEAR(lowest(by_ground.at), z + 0.5, 1e-6);
  limits.clearance = z - 30 - 0.5;
  EXPECT_NEAR(payload(m, 0, limits, options).mass / by_rope.mass, 1, 1e-9);
  limits.tension = {none, 2e3};
  EXPECT_EQ(payload(m, 0, limits, options).governing, "tension of 'mainline'");
}

// The search ends at once at a payload that reaches its limit to the last digit; the next one tried is twice as large,
// and there another limit is farther exceeded.
TEST(Payload, ALimitReachedToTheLastDigitGoverns) {
  machine::Model m = with_carriage(true, 0.1, 200);
  m.terrain = {{.x = 0, .z = 0}, {.x = 300, .z = 60}};
  solve::EquilibriumOptions options;
  options.prescribed = machine::Prescribed{.carriage = 0, .x = 150};
  const double mass = 500, some = 1e4;
  PayloadLimits limits;
  limits.tension = {1e9, none};
  limits.most = mass;
  const Payload reference = payload(m, 0, limits, options, std::nullopt, some);
  ASSERT_TRUE(reference.outcome.ok()) << reference.outcome.message;
  ASSERT_EQ(reference.mass, mass);
  limits.clearance = lowest(reference.at) - 30;
  limits.tension = {1.2 * reference.at.ropes[0].T_max, none};
  limits.most = 10 * mass;
  const Payload p = payload(m, 0, limits, options, std::nullopt, mass / 1.3);
  EXPECT_NEAR(p.mass, mass, 1e-6 * mass);
  EXPECT_EQ(p.governing, "clearance of 'car'");
  EXPECT_EQ(p.limit.kind, LimitKind::clearance);
  EXPECT_FALSE(p.reeving);
}

TEST(Payload, SaysWhenNothingCanBeCarried) {
  const machine::Model m = tackle(4, 1, 5000);
  PayloadLimits limits;
  limits.tension = {10e3};
  const Payload p = payload(m, 0, limits);
  EXPECT_EQ(p.outcome.status, Status::infeasible);
  EXPECT_EQ(p.mass, 0);
  EXPECT_NE(p.outcome.message.find("tension of 'hoist'"), std::string::npos) << p.outcome.message;
}

TEST(Payload, WithoutLimitsTheLargestAskedFor) {
  PayloadLimits limits;
  limits.most = 8000;
  const Payload p = payload(tackle(4, 1, 500), 0, limits);
  EXPECT_EQ(p.mass, 8000);
  EXPECT_EQ(p.governing, "no limit below 8000 kg");
}

TEST(Payload, AlongTheLine) {
  const machine::Model m = with_carriage(false, 0.1, 200);
  LoadPathOptions path;
  path.from = 100;
  path.to = 190;
  path.steps = 6;
  PayloadLimits limits;
  limits.tension = {40e3};
  for (const PayloadPoint& p : payload_path(m, limits, path)) {
    ASSERT_TRUE(p.payload.outcome.ok()) << p.payload.outcome.message;
    solve::EquilibriumOptions options;
    options.prescribed = machine::Prescribed{.carriage = 0, .x = p.x};
    EXPECT_NEAR(p.payload.mass / payload(m, 0, limits, options).mass, 1, 1e-7);
    EXPECT_NEAR(p.payload.at.ropes[0].T_max / 40e3, 1, 1e-8);
  }
}

// A limit that no tension reaches carried 100 t.
TEST(Payload, RefusesLimitsThatLimitNothing) {
  const machine::Model m = tackle(4, 1, 500);
  PayloadLimits limits;
  for (const double tension : {-10e3, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    limits.tension = {tension};
    EXPECT_THROW(payload(m, 0, limits), taut::ContractViolation);
  }
  limits.tension = {10e3, 10e3};
  EXPECT_THROW(payload(m, 0, limits), taut::ContractViolation);
  limits.tension = {10e3};
  limits.ends = {{.reeving = 1, .at_end = false, .pull = 1e3}};
  EXPECT_THROW(payload(m, 0, limits), taut::ContractViolation);
  limits.ends = {{.reeving = 0, .at_end = false, .pull = -1e3}};
  EXPECT_THROW(payload(m, 0, limits), taut::ContractViolation);
  limits.ends.clear();
  EXPECT_THROW(payload(m, 0, limits, {}, std::nullopt, -1), taut::ContractViolation);
  EXPECT_TRUE(payload(m, 0, limits).outcome.ok());
}

TEST(PayloadPath, RefusesACarriageThatIsNotThere) {
  const machine::Model m = with_carriage(true, 0.1, 200);
  LoadPathOptions options;
  options.from = 50;
  options.to = 60;
  for (const int carriage : {-1, 7}) {
    options.carriage = carriage;
    EXPECT_THROW(payload_path(m, {}, options), taut::ContractViolation);
    EXPECT_THROW(load_path(m, options), taut::ContractViolation);
  }
}

}  // namespace payload_test
