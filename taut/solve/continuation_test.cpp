#include "taut/solve/continuation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machines.hpp"

namespace continuation_test {

using namespace taut_test;
using namespace taut::solve;

/// An arm on a hinge at the origin, its weight at its tip, which a stay holds from (0, 0, 5).
machine::Model arm(double mass) {
  machine::Model m;
  machine::Body b = body("arm", {0, 0, 0}, mass, "Y");
  b.centre = {4, 0, 0};
  b.orientation << std::cos(0.1), 0, -std::sin(0.1), 0, 1, 0, std::sin(0.1), 0, std::cos(0.1);  // a little upwards
  m.bodies.push_back(b);
  m.reevings.push_back(reeve("stay", {anchor("top", {0, 0, 5}), anchor_on("tip", 0, {4, 0, 0})}, 6.0, 0, 500e3));
  return m;
}

/// The moment about the hinge by hand, as a function of the angle below the horizontal.
double moment(double mass, double q) {
  const double x = 4 * std::cos(q), z = -4 * std::sin(q);
  const double l = std::hypot(x, 5 - z);
  const double T = std::max(0.0, 500e3 * (l / 6.0 - 1));
  const double lift = T * (5 - z) / l, pull = T * x / l;  // on the tip: upwards, towards the hinge's axis
  return lift * x + pull * z - mass * 9.80665 * x;
}

double angle_of(const EquilibriumResult& r) {
  const taut::Matrix3& o = r.state.bodies[0].orientation;
  return std::atan2(-o(2, 0), o(0, 0));
}

TEST(Continuation, FollowsTheArmToWhatTheMomentSays) {
  const auto at = [](double mass) -> tl::expected<machine::Model, taut::Outcome> { return arm(mass); };
  SweepOptions options;
  options.from = 100;
  options.to = 1500;
  options.steps = 14;
  const Sweep s = sweep(at, options);
  ASSERT_EQ(s.end, SweepEnd::reached) << s.outcome.message;
  ASSERT_EQ(s.points.size(), 15U);
  EXPECT_EQ(s.value, 1500);
  for (const SweepPoint& p : s.points) {
    const double q = angle_of(p.at);
    EXPECT_NEAR(moment(p.value, q) / (p.value * 9.80665 * 4), 0, 1e-8) << p.value;
  }
  std::swap(options.from, options.to);
  const Sweep back = sweep(at, options);
  ASSERT_EQ(back.points.size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_NEAR(angle_of(back.points[14 - i].at), angle_of(s.points[i].at), 1e-9);
}

TEST(Continuation, FindsTheTurningPointOfAnOverhungLoad) {
  // a mast upright on a hinge under a load on its top, held by a stay: above some load the stay's lever gives up
  const auto upright = [](double force) -> tl::expected<machine::Model, taut::Outcome> {
    machine::Model m;
    machine::Body b = body("mast", {0, 0, 0}, 0, "Y");
    b.orientation << std::cos(0.05), 0, std::sin(0.05), 0, 1, 0, -std::sin(0.05), 0, std::cos(0.05);
    m.bodies.push_back(b);
    m.reevings.push_back(reeve("stay", {anchor("back", {-3, 0, 0}), anchor_on("tip", 0, {0, 0, 4})}, 5.0, 0, 200e3));
    m.loads.push_back({{.body = 0, .at = {0, 0, 4}}, {0, 0, -force}});
    m.loads.push_back({{.body = 0, .at = {0, 0, 4}}, {500, 0, 0}});
    return m;
  };
  // by hand: moment of the load about the hinge against that of the stay, largest force over the lean q
  const auto force_at = [](double q) {
    const double x = 4 * std::sin(q), z = 4 * std::cos(q);
    const double l = std::hypot(x + 3, z);
    const double T = 200e3 * (l / 5 - 1);
    const double arm = 3 * z / l;  // of the stay about the hinge
    return (T * arm - 500 * z) / x;
  };
  double most = 0;
  for (double q = 1e-3; q < 1.5; q += 1e-5) most = std::max(most, force_at(q));
  SweepOptions options;
  options.from = 0.05 * most;
  options.to = 2 * most;
  options.steps = 39;
  const Sweep s = sweep(upright, options);
  EXPECT_EQ(s.end, SweepEnd::turning_point) << s.outcome.message << " at " << s.value;
  EXPECT_NEAR(s.value / most, 1, 1e-6);
  EXPECT_FALSE(s.outcome.ok());
  EXPECT_EQ(s.points.back().value, s.value);
}

TEST(Continuation, EndsWhereARopeGetsTooShort) {
  const auto at = [](double length) -> tl::expected<machine::Model, taut::Outcome> {
    machine::Model m;
    m.reevings.push_back(reeve("r", {anchor("a", {0, 0, 0}), anchor("b", {30, 0, 40})}, length, 10,
                               std::numeric_limits<double>::infinity()));
    return m;
  };
  SweepOptions options;
  options.from = 55.03;
  options.to = 45;
  options.steps = 20;
  const Sweep s = sweep(at, options);
  EXPECT_EQ(s.end, SweepEnd::no_equilibrium);
  EXPECT_NEAR(s.value, 50, 1e-6);
  EXPECT_GT(s.value, 50 - 1e-7);
  EXPECT_NE(s.outcome.message.find("does not reach"), std::string::npos) << s.outcome.message;
}

TEST(Continuation, EndsWhereThereIsNoMachine) {
  const auto at = [](double mass) -> tl::expected<machine::Model, taut::Outcome> {
    if (mass < 0) return tl::unexpected(taut::infeasible("no mass is below nothing"));
    return arm(mass + 500);
  };
  SweepOptions options;
  options.from = 1000;
  options.to = -1000;
  options.steps = 10;
  const Sweep s = sweep(at, options);
  EXPECT_EQ(s.end, SweepEnd::no_machine);
  EXPECT_NEAR(s.value, 0, 1e-4);
  EXPECT_EQ(s.outcome.message, "no mass is below nothing");
}

}  // namespace continuation_test
