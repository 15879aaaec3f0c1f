#include "taut/results/motion/transient_scene.hpp"

#include <gtest/gtest.h>

#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

namespace taut::results::transient_scene_test {

/// A load on a rope from a jib that turns by a signal, and from a tower that stands.
TEST(TransientScene, WhatIsOnABodyWithAGivenMotionMoves) {
  machine::Model m;
  m.bodies.push_back(taut_test::body("jib", {0, 0, 40}, 0, ""));
  m.bodies.push_back(taut_test::body("load", {30, 0, 15}, 2000, "xyz"));
  m.bodies[0].driven.push_back({.along = {0, 0, 0}, .about = {0, 0, 1}, .signal = taut_test::smooth_move(0, 1, 0, 15)});
  m.reevings.push_back(taut_test::reeve(
      "hoist", {taut_test::anchor_on("trolley", 0, {30, 0, 0}), taut_test::anchor_on("load", 1)}, 24.99, 10, 15e6));
  m.reevings.push_back(
      taut_test::reeve("tag", {taut_test::anchor("tower", {0, 0, 15}), taut_test::anchor_on("load", 1)}, 30.1, 1, 1e6));
  const auto r = taut_test::run_to_end(m, taut_test::lasting(0.1, 1e-3));
  for (const HeldPart& part : held_parts(m, r.frames.front(), r.frames.front()))
    EXPECT_EQ(part.moves, part.name != "tower") << part.name;
}

}  // namespace taut::results::transient_scene_test
