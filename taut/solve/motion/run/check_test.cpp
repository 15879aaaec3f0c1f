#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"

/// What can't move is told by its name, and what it lacks.
namespace taut_test::transient_check_test {
namespace {

machine::Model load_on_a_sheave() {
  machine::Model m;
  m.gravity = 9.81;
  m.bodies.push_back(body("load", {2, 0, -10}, 100, "xzY"));
  m.bodies[0].inertia = {1, 1, 1};
  m.reevings.push_back(
      reeve("rope", {anchor("end", {-5, 0, 0}), sheave("wheel", origin, 0.2, 1), anchor_on("load", 0)}, 15, 0, 1e6));
  return m;
}

TEST(TransientCheck, WhatCantMoveIsToldWithWhatItLacks) {
  struct Case {
    std::function<void(machine::Model&)> spoil;
    const char *name, *lacks;
  };
  const auto by_a_torque = [](machine::Model& m) {
    m.motors.resize(1);
    m.motors[0].name = "engine";
    m.motors[0].drive.kind = machine::DriveKind::torque;
    m.reevings[0].nodes[1].kind = machine::NodeKind::drive;
    m.reevings[0].nodes[1].motor = 0;
    m.reevings[0].nodes[1].law.friction = 0.3;
  };
  const auto by_a_later_torque = [&](machine::Model& m) {
    by_a_torque(m);
    m.motors[0].drive.kind = machine::DriveKind::held;
    machine::Event event;
    event.kind = machine::EventKind::drive;
    event.of_motor = true;
    event.at = 0.005;
    event.drive.kind = machine::DriveKind::torque;
    m.events = {event};
  };
  const std::vector<Case> cases = {
      {[](machine::Model& m) { m.bodies[0].mass = 0; }, "'load'", "mass"},
      {[](machine::Model& m) { m.bodies[0].inertia.setZero(); }, "'load'", "inertia about its axis"},
      {[](machine::Model& m) { m.reevings[0].stiffness = std::numeric_limits<double>::infinity(); }, "'rope'",
       "'stiffness'"},
      {by_a_torque, "'engine'", "'inertia'"},
      {by_a_later_torque, "'engine'", "'inertia'"},
  };
  taut::solve::TransientOptions options;
  options.duration = 0.01;
  options.start = taut::solve::Start::assembled;
  EXPECT_TRUE(transient(load_on_a_sheave(), options).outcome.ok());
  for (const Case& one : cases) {
    machine::Model m = load_on_a_sheave();
    one.spoil(m);
    const auto r = transient(m, options);
    EXPECT_EQ(r.outcome.status, taut::Status::infeasible) << one.lacks;
    EXPECT_NE(r.outcome.message.find(one.name), std::string::npos) << r.outcome.message;
    EXPECT_NE(r.outcome.message.find(one.lacks), std::string::npos) << r.outcome.message;
    EXPECT_TRUE(r.frames.empty());
  }
}

}  // namespace
}  // namespace taut_test::transient_check_test
