#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Points on faces: stiction, sliding, bouncing, edges, turning faces.
namespace taut_test::transient_face_test {
namespace {

using taut::Matrix3;
using taut::solve::Start;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double g = 9.81;

machine::FaceContact pad(const std::string& name, int body, const Vector3& at, int face) {
  machine::FaceContact c;
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
machine::Model block(double slope, double about_z) {
  machine::Model m;
  m.gravity = g;
  const Matrix3 R =
      (Eigen::AngleAxisd(about_z, Vector3::UnitZ()) * Eigen::AngleAxisd(slope, Vector3::UnitY())).toRotationMatrix();
  machine::Body b = body("block", origin, 860, "xyzXYZ");
  b.orientation = R;
  b.centre = {0, 0, 0.3};
  b.inertia = {60, 120, 150};
  m.bodies = {b};
  machine::Face face;
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
    TransientOptions options = lasting(10, 1e-6, 100);
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
    const TransientResult r = transient(block(slope, turned), lasting(4, 1e-6, 100));
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const auto& last = r.frames.back();
    const double a = g * (std::sin(slope) - 0.15 * std::cos(slope));
    EXPECT_NEAR(last.bodies[0].acceleration.norm(), a, 1e-3 * a);
    for (const auto& face : last.faces) EXPECT_NEAR(face.F, -0.15 * face.N, 1e-3);
    EXPECT_LT(std::abs(last.energy.residual), 1e-4 * last.energy.turnover) << r.steps;
  }
}

/// A point mass on a ground face that is level from x = -1 m to `end`.
machine::Model mass_on_floor(double mass, double end) {
  machine::Model m;
  m.gravity = g;
  m.bodies = {body("mass", origin, mass, "xyz")};
  machine::Face face;
  face.name = "floor";
  face.from = {-1, 0, 0};
  face.to = {end, 0, 0};
  m.faces = {face};
  m.contacts = {pad("foot", 0, origin, 0)};
  return m;
}

/// A belt slides 2 m under a mass on a soft, strongly damped contact, fast and to rest within 1 s: the friction is mu N
/// against the sliding all the while, whatever its damper, and takes mu N times the way; the bristle keeps next to
/// nothing.
TEST(TransientFace, TheDamperOfAContactThatSlidesGivesWayWithIt) {
  machine::Model m = mass_on_floor(100, 10);
  m.bodies[0] = body("mass", origin, 100, "z");
  machine::Body belt = body("belt", origin, 0, "");
  belt.driven = {{Vector3::UnitX(), origin, smooth_move(0, 2, 0, 1)}};
  m.bodies.push_back(belt);
  m.faces[0].body = 1;
  m.faces[0].from = {-5, 0, 0};
  machine::FaceContact& law = m.contacts[0];
  law.stiffness = 2e6, law.damping = 1e5;
  law.tangential_stiffness = 1e6, law.tangential_damping = 5e4;
  law.static_friction = law.kinetic_friction = 0.3;
  m.bodies[0].position.z() = -100 * g / law.stiffness;
  const TransientResult r = run_to_end(m, lasting(1.2, 1e-6, 240));
  const double limit = 0.3 * 100 * g;
  for (const auto& frame : r.frames) {
    if (frame.faces[0].speed < -0.02) {
      EXPECT_NEAR(frame.faces[0].F, limit, 1e-3 * limit) << frame.t;
    }
  }
  EXPECT_TRUE(r.frames.back().faces[0].sticks);
  const double kept = limit * limit / 1e6 / 2, pressed = std::pow(100 * g, 2) / 2e6 / 2;
  EXPECT_NEAR(r.frames.back().energy.contacts, limit * 2, 2 * kept);
  EXPECT_LT(r.frames[120].energy.elastic, pressed + 2 * kept);
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-5 * r.frames.back().energy.turnover);
}

/// m x'' = -m g - k x - c x', x <= 0, from the touch at speed v down: the largest speed up, and the peak.
struct Bounce {
  double up = 0, peak = 0;
};
Bounce bounce(double mass, double k, double c, double v) {
  double x = 0, u = -v, peak = 0, fastest = 0;
  const auto force = [&](double at, double speed) { return std::max(0.0, -k * at - c * speed); };
  const double h = 1e-7;
  while (x <= 0) {
    const auto a = [&](double at, double speed) { return force(at, speed) / mass - g; };
    const double k1 = a(x, u), k2 = a(x + h / 2 * u, u + h / 2 * k1),
                 k3 = a(x + h / 2 * (u + h / 2 * k1), u + h / 2 * k2);
    const double k4 = a(x + h * (u + h / 2 * k2), u + h * k3);
    const double mean = h * u + h * h / 6 * (k1 + k2 + k3);
    u += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    x += mean;
    peak = std::max(peak, force(x, u));
    fastest = std::max(fastest, u);
  }
  return {fastest, peak};
}

TEST(TransientFace, BouncesAsTheSpringAndItsDamperDo) {
  for (const double damping : {0.0, 2e3}) {
    machine::Model m = mass_on_floor(100, 1);
    m.bodies[0].position.z() = 0.2;
    m.contacts[0].stiffness = 1e6;
    m.contacts[0].damping = damping;
    m.observed = {{"N", machine::Observed::contact_N, taut::si::N, 0, {}, origin},
                  {"v", machine::Observed::vz, taut::si::m_per_s, 0, {}, origin}};
    const double v = std::sqrt(2 * g * 0.2);
    const Bounce one = bounce(100, 1e6, damping, v);
    const TransientResult r = transient(m, lasting(0.35, 1e-7, 100));
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.extremes[0].max, one.peak, 2e-3 * one.peak);
    EXPECT_NEAR(r.extremes[1].max, one.up, 2e-3 * one.up);
    ASSERT_EQ(r.events.size(), 2U);
    EXPECT_EQ(r.events[0].what, "contact");
    EXPECT_NEAR(r.events[0].t, v / g, 1e-5);
    EXPECT_NEAR(r.events[0].values.at(0).second, v, 1e-3 * v);
    EXPECT_EQ(r.events[1].what, "apart");
    EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-3 * r.frames.back().energy.turnover);
    if (damping == 0) {
      EXPECT_NEAR(one.up, std::sqrt(v * v + 100 * g * g / 1e6), 1e-4);
    }
  }
}

TEST(TransientFace, FallsOverTheEdge) {
  machine::Model m = mass_on_floor(100, 1);
  m.contacts[0].static_friction = m.contacts[0].kinetic_friction = 0;
  m.bodies[0].position.z() = -100 * g / 1e8;  // at rest on it
  taut::solve::DynamicState start;
  start.bodies.push_back({m.bodies[0].position, Matrix3::Identity(), {2, 0, 0}, origin});
  TransientOptions options = lasting(0.8, 1e-6, 100);
  options.from = start;
  const TransientResult r = transient(m, options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.frames.back().bodies[0].position.x(), 1.6, 1e-5);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), -g / 2 * 0.09, 2e-3);  // 0.3 s beyond it
  EXPECT_FALSE(r.frames.back().faces[0].closed);
}

/// The same block on a plate that tilts: it slides where the plate reaches its angle, and not before.
TEST(TransientFace, SlidesOnATiltingPlate) {
  machine::Model m = block(0, 0);
  machine::Body plate = body("plate", {0, 0, 0}, 0, "");
  taut::machine::Signal tilt;
  tilt.unit = taut::si::rad;
  tilt.law = taut::machine::Moves{0, {{0, 0.2, 20, machine::Change::smooth}}};
  plate.driven = {{origin, Vector3::UnitY(), tilt}};
  m.bodies.push_back(plate);
  m.faces[0].body = 1;
  for (auto& c : m.contacts) c.kinetic_friction = c.static_friction = 0.15;
  const TransientResult r = transient(m, lasting(20, 1e-5, 100));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  // one pad after the other lets go; when the last one does, the block slides
  double angle = 0;
  for (const auto& frame : r.frames) {
    const bool slides = std::none_of(frame.faces.begin(), frame.faces.end(), [](const auto& f) { return f.sticks; });
    if (frame.t > 1 && slides && angle == 0) angle = taut::machine::at(tilt, frame.t).value;
  }
  EXPECT_GT(angle, std::atan(0.15) - 1e-3);
  EXPECT_LT(angle, std::atan(0.15) + 6e-3);  // an output step later
  EXPECT_GT(r.frames.back().bodies[0].position.norm(), 1);
  EXPECT_LT(std::abs(r.frames.back().energy.residual), 1e-3 * r.frames.back().energy.turnover);
}

/// Friction holds where it is described: the start is an equilibrium, and nothing moves from there.
TEST(TransientFace, SettlesWhereItSticks) {
  const double slope = 0.12;
  TransientOptions options = lasting(1, 1e-6, 100);
  options.start = Start::settled;
  const TransientResult r = transient(block(slope, 0.4), options);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const auto &first = r.frames.front(), &last = r.frames.back();
  double N = 0, F = 0;
  for (const auto& face : first.faces) {
    EXPECT_TRUE(face.sticks);
    N += face.N;
    F += face.F;
  }
  EXPECT_NEAR(N, 860 * g * std::cos(slope), 1e-2);
  EXPECT_NEAR(F, -860 * g * std::sin(slope), 1e-2);
  EXPECT_LT((last.bodies[0].position - first.bodies[0].position).norm(), 1e-9);
}

/// A run in two parts is the run in one: the state keeps the strain of what sticks.
TEST(TransientFace, GoesOnFromAState) {
  const machine::Model m = block(0.12, 0.4);
  const TransientResult whole = transient(m, lasting(2, 1e-6, 100)), half = transient(m, lasting(1, 1e-6, 100));
  TransientOptions options = lasting(1, 1e-6, 100);
  options.from = half.state;
  const TransientResult rest = transient(m, options);
  ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
  EXPECT_LT((rest.frames.back().bodies[0].position - whole.frames.back().bodies[0].position).norm(), 1e-6);
  EXPECT_LT((rest.frames.back().bodies[0].position - half.frames.back().bodies[0].position).norm(), 1e-6);
}

}  // namespace
}  // namespace taut_test::transient_face_test
