#include "taut/study/installation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "test/support/machines.hpp"

namespace installation_test {

namespace solve = taut::solve;

using namespace taut_test;
using namespace taut::study;
using Kind = solve::Condition::Kind;

/// A level inextensible catenary by its parameter a = H/w.
struct Catenary {
  double a, span;
  double length() const { return 2 * a * std::sinh(span / 2 / a); }
  double sag() const { return a * (std::cosh(span / 2 / a) - 1); }
};

Catenary of_length(double length, double span) {
  double low = span / 50, high = 1e6;
  for (int i = 0; i < 300; ++i) {
    const double a = (low + high) / 2;
    (Catenary{.a = a, .span = span}.length() > length ? low : high) = a;
  }
  return {.a = low, .span = span};
}

TEST(Installation, FollowsTheTemperatureAsTheClosedCatenary) {
  // L grows by a dT, its weight stays: w/(1 + a dT) per metre, so the end tension is W/2 sqrt(1 + (2a/L)^2)
  const double inf = std::numeric_limits<double>::infinity();
  machine::Model m;
  m.reevings.push_back(reeve("r", {anchor("a", {0, 0, 0}), anchor("b", {150, 0, 0})}, 151, 12, inf));
  for (const double dT : {-35.0, 0.0, 25.0}) {
    m.reevings[0].thermal_strain = 1.2e-5 * dT;
    const Installation i =
        installation(empty_line(m, 0), {.kind = Kind::length, .reeving = 0, .value = 151, .span = 0});
    ASSERT_TRUE(i.outcome.ok()) << i.outcome.message;
    const double warm = 151 * (1 + 1.2e-5 * dT);
    const Catenary c = of_length(warm, 150);
    const double w = 12 / (1 + 1.2e-5 * dT);
    EXPECT_NEAR(i.H / (w * c.a), 1, 1e-7);
    EXPECT_NEAR(i.T_start / std::hypot(w * c.a, w * warm / 2), 1, 1e-7);
    EXPECT_NEAR(i.T_end / i.T_start, 1, 1e-9);
    EXPECT_NEAR(i.sag[0], c.sag(), 1e-7);
    EXPECT_NEAR(i.unstretched, 151, 1e-9);
    EXPECT_NEAR(i.cut, warm, 1e-9);
    EXPECT_NEAR(i.stretched, warm, 1e-9);
    // the same tension given finds the length again
    const Installation back =
        installation(empty_line(m, 0), {.kind = Kind::tension_at_end, .reeving = 0, .value = i.T_end, .span = 0});
    EXPECT_NEAR(back.unstretched, 151, 1e-6);
    const Installation by_sag =
        installation(empty_line(m, 0), {.kind = Kind::sag_of_span, .reeving = 0, .value = i.sag[0], .span = 0});
    EXPECT_NEAR(by_sag.unstretched, 151, 1e-7);
  }
}

TEST(Installation, AnEmptyLineIsTheLineThatNeverHadACarriage) {
  const machine::Model m = with_carriage(true, 0.1, 2000);
  const EmptyLine line = empty_line(m, 0);
  ASSERT_TRUE(line.outcome.ok());
  EXPECT_EQ(line.removed, (std::vector<std::string>{"car", "mainline"}));
  ASSERT_EQ(line.model.reevings.size(), 1U);
  const Installation i = installation(line, {.kind = Kind::length, .reeving = 0, .value = 318, .span = 0});
  ASSERT_TRUE(i.outcome.ok()) << i.outcome.message;
  const solve::EquilibriumResult e = solve::equilibrium(three_spans(318, 0.1));
  EXPECT_NEAR(i.T_start, e.branches.front().T_from, 1e-5);
  EXPECT_NEAR(i.T_end, e.branches.back().T_to, 1e-5);
  EXPECT_EQ(i.sag.size(), 3U);
  // a mainline alone takes nothing away, and the skyline stays
  EXPECT_EQ(empty_line(m, 1).model.reevings.size(), 2U);
}

TEST(Installation, EndsSwappedIsTheSame) {
  machine::Model m = three_spans(315, 0.1);
  const Installation there =
      installation(empty_line(m, 0), {.kind = Kind::tension_at_start, .reeving = 0, .value = 30e3, .span = 0});
  std::reverse(m.reevings[0].nodes.begin(), m.reevings[0].nodes.end());
  const Installation back =
      installation(empty_line(m, 0), {.kind = Kind::tension_at_end, .reeving = 0, .value = 30e3, .span = 0});
  ASSERT_TRUE(there.outcome.ok());
  ASSERT_TRUE(back.outcome.ok()) << back.outcome.message;
  EXPECT_NEAR(there.unstretched, back.unstretched, 1e-8);
  EXPECT_NEAR(there.T_end, back.T_start, 1e-5);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(there.sag[k], back.sag[2 - k], 1e-8);
}

TEST(Installation, LengthsAddUp) {
  const machine::Model m = tackle(4, 1, 2000, 5);
  const solve::EquilibriumResult e = solve::equilibrium(m);
  ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
  const RopeLengths l = lengths_of(m, e, 0);
  EXPECT_NEAR(l.unstretched, m.reevings[0].value, 1e-9);
  EXPECT_NEAR(l.stretched, l.free + l.on_sheaves, 1e-12);
  // the lead comes in level, four sheaves, the last three by half turns
  EXPECT_GT(l.on_sheaves, 3 * M_PI * 0.25);
  EXPECT_LT(l.on_sheaves, 4 * M_PI * 0.25);
  EXPECT_GT(l.stretched, l.unstretched);
  EXPECT_NEAR(l.stretched / l.unstretched - 1, e.ropes[0].T_max / 1e7, 1e-4);
}

TEST(Installation, ARopeThatEndsOnItsCarriageIsNeverEmpty) {
  machine::Model m = with_carriage(true, 0.1, 2000);
  m.reevings[0].nodes.back() = anchor_on("car", 0);
  EXPECT_EQ(empty_line(m, 0).outcome.status, taut::Status::infeasible);
}

/// The tension is measured at one end; beyond a saddle friction leaves it between T e^-fa and T e^fa.
TEST(Installation, FrictionLeavesABandBeyondASaddle) {
  machine::Model m;
  m.reevings.push_back(
      reeve("r", {anchor("a", {0, 0, 0}), saddle("top", {20, 0, 20}, 0.25), anchor("b", {40, 0, 0})}, 57, 0, 10e6));
  const Installation i =
      installation(empty_line(m, 0), {.kind = Kind::tension_at_start, .reeving = 0, .value = 40e3, .span = 0});
  ASSERT_TRUE(i.outcome.ok()) << i.outcome.message;
  EXPECT_NEAR(i.T_end / 40e3, 1, 1e-9) << "the length is that without loss";
  const double most = std::exp(0.25 * M_PI / 2);
  EXPECT_NEAR(i.at.result.branches[1].T_to_max / (40e3 * most), 1, 1e-7);
  EXPECT_NEAR(i.at.result.branches[1].T_to_min * most / 40e3, 1, 1e-7);
  EXPECT_NEAR(i.at.result.ropes[0].T_max / (40e3 * most), 1, 1e-7);
}

}  // namespace installation_test
