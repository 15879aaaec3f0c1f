#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/analysis/machines_test.hpp"
#include "taut/analysis/transient.hpp"

/// Points on faces: stiction, sliding, bouncing, edges, turning faces.
namespace taut_test::transient_face_test {
namespace {

using taut::Matrix3;
using taut::analysis::Start;
using taut::analysis::transient;
using taut::analysis::TransientOptions;
using taut::analysis::TransientResult;

constexpr double g = 9.81;

TransientOptions lasting(double duration, double tolerance) {
  TransientOptions options;
  options.duration = duration;
  options.output_step = duration / 100;
  options.tolerance = tolerance;
  options.most_steps = 300000;
  options.start = Start::assembled;
  return options;
}

model::FaceContact pad(const std::string& name, int body, const Vector3& at, int face) {
  model::FaceContact c;
  c.name = name;
  c.body = body;
  c.at = at;
  c.face = face;
  c.stiffness = 1e8;
  c.damping = 1e5;
  c.tangential_stiffness = 5e7;
  c.tangential_damping = 5e4;
  c.static_friction = 0.155;
  c.kinetic_friction = 0.15;
  c.stribeck_speed = 0.01;
  return c;
}

/// A block of 860 kg, 1.2 m long, on a ground face of this slope; the whole turned about z. Four pads in space.
model::Model block(double slope, double about_z) {
  model::Model m;
  m.gravity = g;
  const Matrix3 R =
      (Eigen::AngleAxisd(about_z, Vector3::UnitZ()) * Eigen::AngleAxisd(slope, Vector3::UnitY())).toRotationMatrix();
  model::Body b = body("block", origin, 860, "xyzXYZ");
  b.orientation = R;
  b.centre = {0, 0, 0.3};
  b.inertia = {60, 120, 150};
  m.bodies = {b};
  model::Face face;
  face.name = "slope";
  face.from = R * Vector3(-1, 0, 0);
  face.to = R * Vector3(100, 0, 0);
  face.normal = R * Vector3(0, 0, 1);
  m.faces = {face};
  for (const double x : {-0.6, 0.6}) {
    for (const double y : {-0.4, 0.4}) m.contacts.push_back(pad("pad", 0, {x, y, 0}, 0));
  }
  return m;
}

TEST(TransientFace, SticksBelowTheFrictionAngle) {
  const double slope = std::atan(0.15);  // below atan(0.155), where sliding would go on for ever
  for (const double turned : {0.0, 0.7}) {
    TransientOptions options = lasting(10, 1e-6);
    const TransientResult r = transient(block(slope, turned), options);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const auto& settled = r.frames[10];
    const auto& last = r.frames.back();
    EXPECT_LT((last.bodies[0].position - settled.bodies[0].position).norm(), 1e-6);
    double N = 0, F = 0;
    for (const auto& face : last.faces) {
      EXPECT_TRUE(face.sticks);
      N += face.N;
      F += face.F;
    }
    EXPECT_NEAR(N, 860 * g * std::cos(slope), 0.01);
    EXPECT_NEAR(F, -860 * g * std::sin(slope), 0.01);
    EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover);
    EXPECT_LT(r.steps, 5000);
  }
}

TEST(TransientFace, SlidesAboveTheFrictionAngle) {
  const double slope = std::atan(0.16);
  for (const double turned : {0.0, 0.7}) {
    const TransientResult r = transient(block(slope, turned), lasting(4, 1e-6));
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const auto& last = r.frames.back();
    const double a = g * (std::sin(slope) - 0.15 * std::cos(slope));
    EXPECT_NEAR(last.bodies[0].acceleration.norm(), a, 1e-3 * a);
    for (const auto& face : last.faces) EXPECT_NEAR(face.F, -0.15 * face.N, 1e-3);
    EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover) << r.steps;
  }
}

}  // namespace
}  // namespace taut_test::transient_face_test
