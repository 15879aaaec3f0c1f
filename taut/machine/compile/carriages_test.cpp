#include "taut/machine/compile/carriages.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "taut/machine/compile.hpp"
#include "taut/machine/compile/dragged.hpp"

namespace taut::machine::carriages_test {

using description::Hold;
using description::PathElement;

PathElement anchor(const std::string& name) {
  PathElement e;
  e.anchor = name;
  return e;
}
PathElement over(const std::string& name) {
  PathElement e;
  e.over = name;
  return e;
}
PathElement through(const std::string& name, bool grip = false) {
  PathElement e;
  e.through = name;
  e.grip = grip;
  return e;
}

/// A skyline at 45 degrees in plan, an endless haul rope beside it, a carriage between.
Machine line() {
  Machine m;
  m.points = {{.name = "head", .body = {}, .at = {0, 0, 10}}, {.name = "tail", .body = {}, .at = {100, 100, 30}}};
  for (const char* name : {"skyline", "haul"}) {
    description::Rope rope;
    rope.name = name;
    rope.mass = 2;
    rope.stiffness = 1e7;
    m.ropes.push_back(rope);
  }
  description::Round drive;
  drive.name = "drive";
  drive.at = {0, 0, 8};
  drive.motor = description::Motor{};
  description::Round wheel;
  wheel.name = "wheel";
  wheel.at = {100, 100, 28};
  m.sheaves = {drive, wheel};
  description::Carriage car;
  car.name = "car";
  car.rides = "skyline";
  car.rollers = 2;
  car.wheelbase = 1;
  car.height = 0.5;
  m.carriages = {car};
  description::Reeving skyline;
  skyline.rope = "skyline";
  skyline.path = {anchor("head"), through("car"), anchor("tail")};
  skyline.length = 150;
  description::Reeving haul;
  haul.rope = "haul";
  haul.path = {over("drive"), over("wheel")};
  haul.closed = true;
  haul.length = 300;
  m.reevings = {skyline, haul};
  return m;
}

TEST(Carriages, RollersStandAlongTheLineAndTurnWithIt) {
  const auto m = compile(line());
  ASSERT_TRUE(m) << m.error().front().message;
  const Body& car = m->bodies[0];
  ASSERT_EQ(car.free.size(), 4U);
  const Vector3 chord(100, 100, 20);
  EXPECT_NEAR(car.orientation.col(0).dot(chord.normalized()), 1, 1e-14);
  EXPECT_NEAR(car.free[3].about.dot(chord), 0, 1e-12);
  EXPECT_NEAR(car.free[3].about.z(), 0, 0);
  EXPECT_NEAR(car.orientation.determinant(), 1, 1e-14);
  EXPECT_GT(car.orientation(2, 2), 0.9);
  const auto& nodes = m->reevings[0].nodes;
  ASSERT_EQ(nodes.size(), 4U);
  EXPECT_EQ(nodes[1].name, "car.roller1");
  EXPECT_EQ(nodes[1].at.at, Vector3(-0.5, 0, 0.5));
  EXPECT_EQ(nodes[2].at.at, Vector3(0.5, 0, 0.5));
  EXPECT_EQ(m->carriages[0].rollers, 2);
  // the rollers start on the line
  const Vector3 roller = car.position + car.orientation * Vector3(0, 0, 0.5);
  EXPECT_NEAR((roller - Vector3(50, 50, 20)).norm(), 0, 1e-12);
}

TEST(Carriages, FixedToARunningRope) {
  Machine m = line();
  m.carriages[0].hold = Hold::fixed_to;
  m.carriages[0].fixed_to = "haul";
  m.reevings[1].path = {over("drive"), through("car"), over("wheel")};
  const auto model = compile(m);
  ASSERT_TRUE(model) << model.error().front().message;
  ASSERT_TRUE(model->carriages[0].grip);
  EXPECT_EQ(model->carriages[0].grip->reeving, 1);
  EXPECT_EQ(model->carriages[0].grip->node, 1);
  EXPECT_EQ(model->reevings[1].nodes[1].kind, NodeKind::clamp);
  EXPECT_EQ(model->reevings[0].nodes[1].kind, NodeKind::contact);
  // without a length at its share of the way all round, whichever node the path names first
  const auto& nodes = model->reevings[1].nodes;
  const auto place = [&](std::size_t k) {
    const Place& at = nodes[k].at;
    if (at.body < 0) return at.at;
    const Body& body = model->bodies[static_cast<std::size_t>(at.body)];
    return Vector3(body.position + body.orientation * at.at);
  };
  const double before = (place(1) - place(0)).norm();
  const double round = before + (place(2) - place(1)).norm() + (place(0) - place(2)).norm();
  EXPECT_NEAR(nodes[1].length_before, 300 * before / round, 1e-9);
}

TEST(Carriages, AnEndlessRopeThatPassesTwice) {
  Machine m = line();
  m.carriages[0] = {};
  m.carriages[0].name = "car";
  m.carriages[0].rides = m.carriages[0].fixed_to.emplace("haul");
  m.reevings[1].path = {over("drive"), through("car", true), over("wheel"), through("car")};
  m.reevings.erase(m.reevings.begin());
  const auto model = compile(m);
  ASSERT_TRUE(model) << model.error().front().message;
  EXPECT_EQ(model->carriages[0].node, 3);
  EXPECT_EQ(model->carriages[0].grip.value().node, 1);
  m.reevings[0].path[1].grip = false;
  const auto wrong = compile(m);
  ASSERT_FALSE(wrong);
}

TEST(Carriages, TellsMistakesAtTheirPath) {
  struct Case {
    std::string path;
    void (*spoil)(Machine&);
  };
  const std::vector<Case> cases = {
      {.path = "carriages.car.rollers", .spoil = [](Machine& m) { m.carriages[0].wheelbase.reset(); }},
      {.path = "carriages.car.wheelbase", .spoil = [](Machine& m) { m.carriages[0].rollers = 1; }},
      {.path = "carriages.car.rollers", .spoil = [](Machine& m) { m.carriages[0].hold = Hold::clamped; }},
      {.path = "carriages.car.friction",
       .spoil = [](Machine& m) { m.carriages[0].hold = Hold::clamped, m.carriages[0].friction = 0.1; }},
      {.path = "carriages.car.hold", .spoil = [](Machine& m) { m.carriages[0].hold = Hold::fixed_to; }},
      {.path = "carriages.car.fixed_to", .spoil = [](Machine& m) { m.carriages[0].fixed_to = "haul"; }},
      {.path = "carriages.car.fixed_to", .spoil = [](Machine& m) { m.carriages[0].fixed_to = "hawl"; }},
      {.path = "carriages.car.haulback", .spoil = [](Machine& m) { m.carriages[0].haulback = "haul"; }},
      {.path = "carriages.car.length_before", .spoil = [](Machine& m) { m.carriages[0].length_before = 3; }},
      {.path = "reevings[0].path[1].through", .spoil = [](Machine& m) { m.reevings[0].path[1].grip = true; }},
      {.path = "reevings[1].path[0].grip", .spoil = [](Machine& m) { m.reevings[1].path[0].grip = true; }},
      {.path = "loads[0].dragged.along",
       .spoil =
           [](Machine& m) {
             description::Load load;
             load.at = "car";
             load.mass = 100;
             load.dragged.emplace().along = {0, 0};
             m.loads = {load};
           }},
      {.path = "points.hook.body",
       .spoil =
           [](Machine& m) {
             m.carriages[0].rollers = 1;
             m.carriages[0].wheelbase.reset();
             m.carriages[0].height = 0;
             m.points.push_back({"hook", "car", {0, 0, -1}});
           }},
  };
  for (const Case& one : cases) {
    Machine m = line();
    one.spoil(m);
    const auto model = compile(m);
    ASSERT_FALSE(model) << one.path;
    const bool reported =
        std::any_of(model.error().begin(), model.error().end(), [&](const Complaint& c) { return c.path == one.path; });
    EXPECT_TRUE(reported) << one.path << ", not " << model.error().front().path << ": "
                          << model.error().front().message;
  }
}

TEST(Dragged, BalanceOfTheBarByHand) {
  // forces and moments on the bunch: weight at its centre, ground on its rear end, the carriage on its front end
  for (const double alpha : {-0.5, 0.0, 0.4}) {
    for (const double delta : {0.0, 0.15}) {
      for (const double mu : {0.0, 0.6}) {
        const description::Dragged bunch{
            .ground_angle = alpha, .friction = mu, .share = 0.4, .lift_angle = delta, .along = {3, 4}};
        const double length = 12, weight = 800 * 9.81;
        const Vector3 on_carriage = force_of(bunch, 800, 9.81);
        const Vector3 way(0.6, 0.8, 0);
        const Vector3 t = std::cos(alpha) * way + std::sin(alpha) * up();
        const Vector3 n = std::cos(alpha) * up() - std::sin(alpha) * way;
        const Vector3 bar = length * (std::cos(delta) * t + std::sin(delta) * n);  // rear to front
        const Vector3 ground = on_carriage + weight * up();  // what is left for the ground to bear
        EXPECT_NEAR(ground.dot(t), -mu * ground.dot(n), 1e-9);
        EXPECT_NEAR(ground.dot(up().cross(way)), 0, 1e-9);
        // about the rear end: the ground has no arm
        const Vector3 moment = (0.4 * bar).cross(-weight * up()) + bar.cross(-on_carriage);
        EXPECT_NEAR(moment.norm(), 0, 1e-8);
      }
    }
  }
}

TEST(Dragged, LimitsByHand) {
  const double W = 1000 * 9.81;
  const Vector3 level =
      force_of({.ground_angle = 0, .friction = 0.5, .share = 0.6, .lift_angle = 0, .along = {1, 0}}, 1000, 9.81);
  EXPECT_NEAR(level.z(), -0.6 * W, 1e-9);
  EXPECT_NEAR(level.x(), -0.5 * 0.4 * W, 1e-9);
  EXPECT_NEAR((force_of({0.3, 0.5, 1, 0, {1, 0}}, 1000, 9.81) + W * up()).norm(), 0, 1e-9) << "hangs free";
  // up a slope: the carriage bears the downhill part of the weight and the friction
  const Vector3 steep =
      force_of({.ground_angle = 0.3, .friction = 0.5, .share = 0.6, .lift_angle = 0, .along = {0, 2}}, 1000, 9.81);
  const Vector3 t(0, std::cos(0.3), std::sin(0.3));
  EXPECT_NEAR(steep.dot(t), -W * (std::sin(0.3) + 0.5 * 0.4 * std::cos(0.3)), 1e-9);
  // lifted to the upright it hangs free
  EXPECT_NEAR((force_of({0.8, 0.5, 0.6, M_PI_2 - 0.8, {1, 0}}, 1000, 9.81) + W * up()).norm(), 0, 1e-9);
}

}  // namespace taut::machine::carriages_test
