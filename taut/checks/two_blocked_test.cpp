#include "taut/checks/two_blocked.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "test/support/machines.hpp"

namespace taut::checks::two_blocked_test {

using taut_test::anchor;
using taut_test::sheave;

/// A hook block of 0.3 m radius under a head sheave of 0.2 m, `below` it.
machine::Model hook(double below) {
  machine::Model m;
  m.bodies.push_back(taut_test::body("block", {0, 0, -below}, 100, "xz"));
  m.reevings.push_back(taut_test::reeve("hoist",
                                        {anchor("winch", {-9, 0, -9}), sheave("head", {0, 0, 0}, 0.2, 1),
                                         sheave("hook", {0, 0, 0}, 0.3, -1, 1, 0), anchor("end", {1, 0, 0})},
                                        30, 0, 1e6));
  return m;
}

std::string said(const TwoBlocked& blocks) {
  Result r;
  blocks.add_warnings(r);
  EXPECT_EQ(r.unsafe.size(), r.warnings.size());
  return r.warnings.empty() ? "" : r.warnings.front();
}

std::string at_rest(const machine::Model& m) {
  TwoBlocked blocks;
  blocks.take(m, machine::initial_state(m), {}, "there");
  return said(blocks);
}

TEST(TwoBlocked, BelowBothRadiiTheyRunIntoEachOther) {
  EXPECT_EQ(at_rest(hook(0.51)), "");
  EXPECT_EQ(at_rest(hook(0.4)),
            "there: 'head' and 'hook' run into each other: centres 0.4 m apart, 0.1 m less than both radii");
}

TEST(TwoBlocked, TheWorstStateCounts) {
  const machine::Model m = hook(5);
  machine::State state = machine::initial_state(m);
  TwoBlocked blocks;
  for (const double below : {5.0, 0.45, 0.2, 0.3}) {
    state.bodies[0].position.z() = -below;
    blocks.take(m, state, {}, std::to_string(below));
  }
  EXPECT_NE(said(blocks).find("0.200000: 'head' and 'hook'"), std::string::npos) << said(blocks);
}

TEST(TwoBlocked, CarriagesAndWheelsOfOneBodyDoNotCount) {
  machine::Model carriage = hook(0.1);
  carriage.carriages.push_back({"block", 0, 0, 2, std::nullopt});
  EXPECT_EQ(at_rest(carriage), "");
  machine::Model one = hook(0.1);
  one.reevings[0].nodes[2].at = {.body = machine::ground, .at = {0, 0, -0.1}};
  EXPECT_EQ(at_rest(one), "");
}

/// A weight that hangs on a sheave of 0.2 m radius at its rim, `below` its centre.
machine::Model weight(double below) {
  machine::Model m;
  m.bodies.push_back(taut_test::body("weight", {0.2, 0, -below}, 100, "z"));
  m.reevings.push_back(taut_test::reeve(
      "hoist", {anchor("winch", {-9, 0, -9}), sheave("head", {0, 0, 0}, 0.2, 1), taut_test::anchor_on("eye", 0)}, 30, 0,
      1e6));
  return m;
}

// The free rope is as long as the weight is below; a weight without a round was drawn in until no rope was left.
TEST(TwoBlocked, AWeightIsDrawnIntoItsSheave) {
  EXPECT_EQ(at_rest(weight(0.21)), "");
  EXPECT_EQ(
      at_rest(weight(0.1)),
      "there: 'eye' runs into 'head': the free rope between them is 0.1 m long, less than the radius; 0.2236 m to "
      "its centre");
  machine::Model built = weight(0.1);
  built.bodies[0].free.clear();
  EXPECT_EQ(at_rest(built), "") << "neither of them moves";
  machine::Model beside = weight(0.1);
  beside.reevings[0].nodes[1].at.body = 0;
  beside.reevings[0].nodes[1].at.at = {-0.2, 0, 0.1};
  EXPECT_EQ(at_rest(beside), "") << "parts of one body";
}

// A bollard is a support, whose law is a saddle's: a weight was hauled into it and passed.
TEST(TwoBlocked, ASaddleIsInTheWayOfAllButCarriages) {
  const machine::ContactLaw saddle = {.friction = 0.2, .efficiency = 0};
  machine::Model block = hook(0.4);
  block.reevings[0].nodes[1].law = saddle;
  EXPECT_NE(at_rest(block).find("'head' and 'hook' run into each other"), std::string::npos) << at_rest(block);
  machine::Model m = weight(0.1);
  m.reevings[0].nodes[1].law = saddle;
  EXPECT_NE(at_rest(m).find("'eye' runs into 'head'"), std::string::npos) << at_rest(m);
  m.carriages.push_back({"weight", 0, 0, 2, std::nullopt});
  EXPECT_EQ(at_rest(m), "") << "a carriage passes its supports";
}

TEST(TwoBlocked, ADrumIsInTheWayToo) {
  machine::Model m = hook(0.1);
  m.reevings[0].nodes.erase(m.reevings[0].nodes.begin());
  machine::Node& drum = m.reevings[0].nodes[0];
  drum.kind = machine::NodeKind::anchor;
  EXPECT_EQ(at_rest(m), "");
  drum.drum = 0;
  EXPECT_NE(at_rest(m), "");
}

}  // namespace taut::checks::two_blocked_test
