#include "taut/solve/exact/running_loop.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "taut/math/degree.hpp"
#include "taut/rope/catenary_shape.hpp"

namespace taut::solve::running_loop_test {

constexpr double kgf = 9.80665;

/// S = 3000 kgf at 30 deg from the vertical, 200 m, weights 1 and 1.5 kgf/m, efficiency 0.9, level.
RunningLoop example(double slope = 0, double gamma = 30) {
  RunningLoop loop;
  loop.span = 200;
  loop.rise = 200 * std::tan(slope * degree);
  loop.traction_rope = {.weight = 1.5 * kgf};
  loop.return_rope = {.weight = 1 * kgf};
  loop.efficiency = 0.9;
  loop.pull_x = 3000 * kgf * std::sin(gamma * degree);
  loop.pull_z = -3000 * kgf * std::cos(gamma * degree);
  return loop;
}

LoopState solved(const RunningLoop& loop, const LoopPlace& place) {
  LoopState s;
  const Outcome o = solve_loop(loop, place, s);
  EXPECT_TRUE(o.ok()) << o.message;
  return s;
}

double P_b(const RunningLoop& loop, const LoopState& s) { return s.R_z - loop.rise / loop.span * s.R_x; }

TEST(RunningLoop, TheExampleByCatenaries) {
  const RunningLoop loop = example();
  const LoopState s = solved(loop, {.x = 100, .sag = 10});
  EXPECT_NEAR(P_b(loop, s) / kgf, 1166.17, 0.005);
  EXPECT_NEAR(s.upper_B.T_end / kgf, 6370.0, 0.05);
  EXPECT_NEAR(s.lower_B.T_end / kgf, 7077.8, 0.05);
  EXPECT_NEAR(s.lower_A.T_start / kgf, 8587.9, 0.05);
  EXPECT_NEAR(s.loop_length(), 401.999, 0.0005);
}

std::vector<RunningLoop> assorted() {
  std::vector<RunningLoop> all;
  for (const double slope : {-25.0, 0.0, 25.0}) {
    for (const RollerLaw roller : {RollerLaw::free, RollerLaw::vertical}) {
      for (const double EA : {6e6, std::numeric_limits<double>::infinity()}) {
        RunningLoop loop = example(slope);
        loop.roller = roller;
        loop.branch_distance = 1.5;
        loop.offset_is_vertical = slope > 0;
        loop.carriage_weight = 4000;
        loop.return_rope.stiffness = EA;
        loop.traction_rope.stiffness = 1.5 * EA;
        all.push_back(loop);
        loop.second = SecondSection{.distance = 4,
                                    .along_rope = slope < 0,
                                    .sag_is_of_second = roller == RollerLaw::free,
                                    .place_is_of_second = slope == 0};
        all.push_back(loop);
      }
    }
  }
  return all;
}

TEST(RunningLoop, TheWholeSpanIsInBalance) {
  for (const RunningLoop& loop : assorted()) {
    for (const double x : {30.0, 100.0, 160.0}) {
      const LoopState s = solved(loop, {.x = x, .sag = 12});
      const auto& [a, b, u, w] = std::tie(s.lower_A, s.lower_B, s.upper_A, s.upper_B);
      double weight = loop.carriage_weight - loop.pull_z;
      for (const LoopSpan* r : {&a, &b, &u, &w, &s.between}) weight += r->rope.weight * r->rope.length;
      const double size = a.T_start + b.T_end + u.T_start + w.T_end;
      EXPECT_NEAR(b.force.H + w.force.H + loop.pull_x, a.force.H + u.force.H, 1e-9 * size);
      EXPECT_NEAR(b.V_end + w.V_end - a.V_start - u.V_start, weight, 1e-9 * size);
      EXPECT_LE(s.residual, 1e-9 * size);
      EXPECT_LE(s.closure, 1e-9 * loop.span);
      EXPECT_NEAR(w.T_end, loop.efficiency * b.T_end, 1e-9 * size);
    }
  }
}

TEST(RunningLoop, TheRollersLawHolds) {
  for (const RunningLoop& loop : assorted()) {
    const LoopState s = solved(loop, {.x = 80, .sag = 12});
    const LoopNode link{.x = s.roller.x - s.first.x, .z = s.roller.z - s.first.z};
    EXPECT_NEAR(std::hypot(link.x, link.z), loop.branch_distance, 1e-9);
    if (loop.roller == RollerLaw::vertical) {
      EXPECT_NEAR(s.R_x, 0, 1e-6);
      EXPECT_NEAR(link.x, 0, 1e-9);
    } else {
      EXPECT_NEAR(s.upper_A.T_end, s.upper_B.T_start, 1e-9 * s.upper_A.T_end);
      EXPECT_NEAR(s.R_x * link.z - s.R_z * link.x, 0, 1e-8 * s.roller_force());
    }
  }
}

TEST(RunningLoop, FreeRollerAndStiffRopeTensionChangesByWeightTimesHeight) {
  for (const double slope : {-30.0, 10.0}) {
    for (const double x : {40.0, 150.0}) {
      RunningLoop loop = example(slope);
      loop.branch_distance = 2;
      const LoopState s = solved(loop, {.x = x, .sag = 15});
      EXPECT_NEAR(s.upper_B.T_end - s.upper_A.T_start, loop.return_rope.weight * loop.rise, 1e-8 * s.upper_B.T_end);
    }
  }
}

TEST(RunningLoop, WithoutWeightStraightRopesShareTheLoad) {
  RunningLoop loop = example(12);
  loop.traction_rope.weight = loop.return_rope.weight = 0;
  loop.roller = RollerLaw::vertical;
  const LoopPlace place{.x = 70, .sag = 9};
  const LoopState s = solved(loop, place);
  // Horizontal tensions of the upper branch (one) and of the lower at B: sheave and vertical balance.
  const double m = loop.rise / loop.span;
  const double left = m - place.sag / place.x;
  const double right = m + place.sag / (loop.span - place.x);
  Eigen::Matrix2d M;
  M << 1, -loop.efficiency, right - left, right - left;
  const Eigen::Vector2d H = M.lu().solve(Eigen::Vector2d(0, -loop.pull_z + left * loop.pull_x));
  EXPECT_NEAR(s.upper_B.force.H, H[0], 1e-9 * H[0]);
  EXPECT_NEAR(s.lower_B.force.H, H[1], 1e-9 * H[1]);
  EXPECT_NEAR(s.lower_A.force.H, H[1] + loop.pull_x, 1e-9 * H[1]);
}

TEST(RunningLoop, TwoSectionsBecomeOne) {
  RunningLoop loop = example(-10);
  const LoopState one = solved(loop, {.x = 80, .sag = 10});
  double before = 1e9;
  for (const double d : {1.0, 0.1, 0.01, 0.001}) {
    for (const bool second : {false, true}) {
      loop.second =
          SecondSection{.distance = d, .along_rope = second, .sag_is_of_second = second, .place_is_of_second = second};
      const LoopState two = solved(loop, {.x = 80, .sag = 10});
      const double off = std::abs(P_b(loop, two) / P_b(loop, one) - 1);
      EXPECT_LT(off, 0.05 * d);
      if (second) continue;
      EXPECT_LT(off, before);
      before = off;
    }
  }
}

TEST(RunningLoop, TheSecondSectionStandsWhereItIsAsked) {
  for (const bool along : {false, true}) {
    for (const bool sag : {false, true}) {
      for (const bool place : {false, true}) {
        RunningLoop loop = example(15);
        loop.second =
            SecondSection{.distance = 5, .along_rope = along, .sag_is_of_second = sag, .place_is_of_second = place};
        const LoopState s = solved(loop, {.x = 90, .sag = 14});
        const double m = loop.rise / loop.span;
        const LoopNode& hung = sag ? s.second : s.first;
        EXPECT_NEAR((place ? s.second : s.first).x, 90, 1e-9);
        EXPECT_NEAR(m * hung.x - hung.z, 14, 1e-9);
        EXPECT_NEAR(along ? s.between.rope.length : s.second.x - s.first.x, 5, 1e-9);
        EXPECT_GT(s.delta_sag, 0);
      }
    }
  }
}

/// Gravity and elastic energy of one rope, m g z by Simpson's rule.
double energy(const LoopRope& rope, double length, LoopNode from, LoopNode to) {
  const rope::CatenaryRope r{.length = length, .weight = rope.weight, .stiffness = rope.stiffness};
  const auto s = rope::solve_catenary(r, to.x - from.x, to.z - from.z);
  EXPECT_TRUE(s.has_value());
  constexpr int n = 400;
  double z = 0;
  for (int i = 0; i <= n; ++i) {
    const double part = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    z += part / (3 * n) * (from.z + rope::point_at(r, s->force, length * i / n).z);
  }
  return rope.weight * length * z + rope::elastic_energy(r, s->force);
}

TEST(RunningLoop, WithoutFrictionTheEnergyIsStationary) {
  RunningLoop loop = example(-15);
  loop.efficiency = 1;
  loop.branch_distance = 1.2;
  loop.carriage_weight = 3000;
  loop.traction_rope.stiffness = 2e7;
  loop.return_rope.stiffness = 1.2e7;
  const LoopState s = solved(loop, {.x = 70, .sag = 11});
  // Coordinates: clamp x, z; lean of the link; rope run over the sheave; rope run over the roller.
  const auto total = [&](const std::array<double, 5>& q) {
    const LoopNode L{.x = s.first.x + q[0], .z = s.first.z + q[1]};
    const double lean = s.lean + q[2];
    const LoopNode U{.x = L.x - loop.branch_distance * std::sin(lean),
                     .z = L.z + loop.branch_distance * std::cos(lean)};
    const double chord = std::hypot(loop.span, loop.rise);
    const LoopNode A{.x = -loop.branch_distance * loop.rise / chord, .z = loop.branch_distance * loop.span / chord};
    return energy(loop.traction_rope, s.lower_A.rope.length, {.x = 0, .z = 0}, L) +
           energy(loop.return_rope, s.lower_B.rope.length + q[3], L, {.x = loop.span, .z = loop.rise}) +
           energy(loop.return_rope, s.upper_A.rope.length + q[4], A, U) +
           energy(loop.return_rope, s.upper_B.rope.length - q[3] - q[4], U,
                  {.x = loop.span + A.x, .z = loop.rise + A.z}) +
           loop.carriage_weight * L.z - loop.pull_x * L.x - loop.pull_z * L.z +
           loop.return_rope.weight * q[3] * A.z;  // the sheave's two sides differ in height; its rope has no weight
  };
  for (std::size_t i = 0; i < 5; ++i) {
    std::array<double, 5> up{};
    std::array<double, 5> down{};
    const double h = i == 2 ? 1e-3 : 1e-4;
    up[i] = h;
    down[i] = -h;
    EXPECT_NEAR((total(up) - total(down)) / (2 * h), 0, 2e-5 * s.lower_A.T_start) << i;
  }
}

TEST(RunningLoop, LengthWithElasticity) {
  // The loop of the example; the traction rope is heavier by half, and so stiffer by half.
  for (const auto& [EA, sag] : std::vector<std::pair<double, double>>{
           {std::numeric_limits<double>::infinity(), 10.0}, {1.1e6, 13.6}, {5e5, 16.1}}) {
    RunningLoop loop = example();
    loop.return_rope.stiffness = EA * kgf;
    loop.traction_rope.stiffness = 1.5 * EA * kgf;
    LoopSag found;
    const Outcome o = find_loop_sag(loop, 100, LoopGiven::length, 401.999, found);
    ASSERT_TRUE(o.ok()) << o.message;
    EXPECT_NEAR(found.sag, sag, 0.05);
    EXPECT_NEAR(found.state.loop_length(), 401.999, 1e-9);
    if (EA == 1.1e6) {
      EXPECT_NEAR(found.state.upper_B.T_end / (6370 * kgf), 1 - 0.28, 0.005);
    }
  }
}

TEST(RunningLoop, SagByTensionAndTheSecondRoot) {
  const RunningLoop loop = example();
  LoopSag found;
  ASSERT_TRUE(find_loop_sag(loop, 100, LoopGiven::tension_at_carriage, 3000 * kgf, found).ok());
  EXPECT_NEAR(found.sag, 22.3, 0.05);
  // uphill T_lA has a minimum over the sag: two sags on its sides have the same tension
  RunningLoop up = example(-25, 20);
  up.return_rope.weight *= 8;
  up.traction_rope.weight *= 8;
  LoopSag two;
  double least = 1e99;
  for (double f = 2; f < 100; f *= 1.05) {
    LoopState s;
    if (solve_loop(up, {.x = 60, .sag = f}, s).ok()) least = std::min(least, s.lower_A.T_start);
  }
  const Outcome o = find_loop_sag(up, 60, LoopGiven::tension_at_A, 1.002 * least, two);
  ASSERT_TRUE(o.ok()) << o.message;
  ASSERT_TRUE(std::isfinite(two.second));
  EXPECT_GT(two.second, two.sag);
  for (const double f : {two.sag, two.second}) {
    EXPECT_NEAR(solved(up, {60, f}).lower_A.T_start, 1.002 * least, 1e-7 * least);
  }
  EXPECT_EQ(find_loop_sag(up, 60, LoopGiven::tension_at_A, 0.9 * least, two).status, Status::infeasible);
}

TEST(RunningLoop, LiftOffIsNamed) {
  LoopState s;
  const Outcome o = solve_loop(example(-30, 60), {.x = 100, .sag = 10}, s);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("lifts off"), std::string::npos) << o.message;
  LoopSag found;
  EXPECT_EQ(find_loop_sag(example(), 100, LoopGiven::length, 390, found).status, Status::infeasible);
}

TEST(RunningLoop, AStartNearbyChangesNothing) {
  RunningLoop loop = example(8);
  loop.return_rope.stiffness = 9e6;
  const LoopState near = solved(loop, {.x = 60, .sag = 8});
  const LoopState cold = solved(loop, {.x = 90, .sag = 11});
  LoopState warm;
  ASSERT_TRUE(solve_loop(loop, {90, 11}, warm, &near).ok());
  EXPECT_NEAR(warm.lower_A.T_start, cold.lower_A.T_start, 1e-11 * cold.lower_A.T_start);
}

TEST(RunningLoop, ASecondSectionPulledUnderTheFirstIsNamed) {
  RunningLoop loop;
  loop.span = 121;
  loop.rise = -8;
  loop.branch_distance = 1;
  loop.traction_rope = loop.return_rope = {.weight = 12, .stiffness = std::numeric_limits<double>::infinity()};
  loop.carriage_weight = 2700;
  loop.pull_x = -9300;
  loop.pull_z = -5300;
  loop.second = SecondSection{.distance = 2};
  LoopState state;
  EXPECT_TRUE(solve_loop(loop, {61, 10}, state).ok());
  const Outcome deep = solve_loop(loop, {.x = 61, .sag = 60}, state);
  EXPECT_EQ(deep.status, Status::infeasible);
  EXPECT_NE(deep.message.find("between the sections stands upright"), std::string::npos) << deep.message;
}

}  // namespace taut::solve::running_loop_test
