#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "test/support/machines.hpp"
#include "test/support/transient_slopes.hpp"

/// The rows of straight machines: their derivatives against differences, the inertia of a body against the change of
/// its momentum.
namespace taut::solve::dynamics::transient_assemble_test {

using namespace taut_test;

constexpr Grip every[] = {Grip::stuck, Grip::forward, Grip::backward, Grip::equal};

/// The boom with inertia, a hook that turns, and a motor's worth of inertia in its skew sheave.
machine::Model heavy_boom() {
  machine::Model m = boom();
  m.bodies[0].inertia = {40, 9000, 9000};
  m.bodies[1].free = body("", origin, 0, "xyzXYZ").free;
  m.bodies[1].inertia = {30, 45, 60};
  m.bodies[1].centre = {0.1, -0.05, -0.4};
  m.bodies[1].orientation = Eigen::AngleAxisd(0.3, Vector3::UnitX());
  m.reevings[1].nodes[2].at.at = {0.05, 0.1, 0.5};
  m.reevings[1].nodes[1].inertia = 1.5;
  m.reevings[1].nodes[1].law.friction = 0.3;
  m.loads.push_back({{1, {0.3, 0.2, -0.8}}, {120, -60, -300}});
  return m;
}

/// Without dampers in motion, with them at rest: by how much they change with the rate of strain itself, the damping
/// times that rate of all, is left out of the tangent.
double worst_of_both(machine::Model m, Grip grip, int turns = 0, double speed = 0.1) {
  const double undamped = worst_slope(m, {.grip = grip, .turns = turns, .speed = speed});
  for (auto& rope : m.reevings) rope.damping_time = 0.01;
  return std::max(undamped, worst_slope(m, {.grip = grip, .turns = turns, .still = true}));
}

TEST(TransientAssemble, SlopesOfStraightMachinesAgreeWithDifferences) {
  for (const Grip grip : every) {
    EXPECT_LT(worst_of_both(with_carriage(true, 0.1), grip), 1e-7) << static_cast<int>(grip);
    EXPECT_LT(worst_of_both(tackle(5, 0.95, 2000, 8), grip), 1e-7) << static_cast<int>(grip);
    EXPECT_LT(worst_of_both(rollers(2, 0.8, 0.5, 1500), grip), 1e-7) << static_cast<int>(grip);
  }
}

TEST(TransientAssemble, SlopesOfTurningBodiesAgreeWithDifferences) {
  for (const Grip grip : every) {
    for (const int turns : {0, 1, -1}) {
      for (const double speed : {0.1, 1.5}) {  // the faster, the more gyroscopic
        EXPECT_LT(worst_of_both(heavy_boom(), grip, turns, speed), 1e-7)
            << static_cast<int>(grip) << turns << " " << speed;
      }
    }
  }
}

TEST(TransientAssemble, SlopesOfChainsAgreeWithDifferences) {
  machine::Model m = with_carriage(false, 0.1);
  m.reevings[0].segments = 3;
  EXPECT_LT(worst_of_both(m, Grip::forward), 1e-7);
}

/// A body that spins about no axis of its own: what its inertia asks of each virtual velocity is the rate of its linear
/// and angular momentum, by differences over a short time of its motion, less the power of its weight and its load.
TEST(TransientAssemble, InertiaIsTheRateOfMomentum) {
  machine::Model m;
  m.bodies.push_back(body("block", {1, 2, 3}, 80, "xyzXYZ"));
  machine::Body& block = m.bodies[0];
  block.inertia = {5, 11, 8};
  block.centre = {0.3, -0.2, 0.5};
  block.orientation = Eigen::AngleAxisd(0.8, Vector3(1, 1, -2).normalized());
  m.loads.push_back({{0, {0.4, 0.1, -0.3}}, {50, -70, 20}});
  TransientOptions options;
  Built built = build(m, assembled(m), options);
  ASSERT_TRUE(built.outcome.ok()) << built.outcome.message;
  Values& now = built.values;
  Motion3& is = now.bodies[0];
  is.v = {0.7, -1.1, 0.4};
  is.w = {2.5, -1.8, 3.1};
  const Vector3 a(1.2, 0.3, -0.9), b(-4, 2, 1.5);
  for (std::size_t i = 0; i < 6; ++i) now.rate[i] = i < 3 ? a[static_cast<int>(i)] : b[static_cast<int>(i) - 3];
  const auto momentum = [&](double t) {
    const Matrix3 R = Eigen::AngleAxisd(is.w.norm() * t, is.w.normalized()) * is.R;
    const Vector3 w = is.w + t * b, c = R * block.centre;
    const Vector3 linear = block.mass * (is.v + t * a + w.cross(c));
    return std::pair(linear, Vector3(R * block.inertia.asDiagonal() * R.transpose() * w));
  };
  const double h = 1e-5;
  const auto [P, L] = momentum(h);
  const auto [P_0, L_0] = momentum(-h);
  const Vector3 force = (P - P_0) / (2 * h), moment = (L - L_0) / (2 * h), c = is.R * block.centre;
  const Vector3 weight(0, 0, -block.mass * m.gravity), load = m.loads[0].force;
  for (int i = 0; i < 6; ++i) {
    const Vector3 along = i < 3 ? Vector3(Vector3::Unit(i)) : Vector3(Vector3::Zero());
    const Vector3 about = i < 3 ? Vector3(Vector3::Zero()) : Vector3(Vector3::Unit(i - 3));
    const double dead = weight.dot(along + about.cross(c)) + load.dot(along + about.cross(is.R * m.loads[0].at.at));
    const double asked = force.dot(along + about.cross(c)) + moment.dot(about) - dead;
    EXPECT_NEAR(inertia_power(built.mechanism, 0, now, along, about), asked, 1e-6) << i;
  }
  EXPECT_EQ(dead_load(built.mechanism, 0), load);
}

}  // namespace taut::solve::dynamics::transient_assemble_test
