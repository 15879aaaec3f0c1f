#include "taut/machine/compile/rope_loads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "taut/machine/compile.hpp"
#include "test/support/complaints.hpp"

namespace rope_loads_test {

using namespace taut;
using namespace taut::machine;
using taut_test::complaints_of;
using testing::HasSubstr;

description::PathElement over(const std::string& name) {
  description::PathElement e;
  e.over = name;
  return e;
}

description::Round sheave(const std::string& name, const Triple& at) {
  description::Round r;
  r.name = name;
  r.at = at;
  r.diameter = 0.5;
  return r;
}

/// A closed rope over three sheaves, the second one with the motor.
Machine saw() {
  Machine m;
  description::Rope rope;
  rope.name = "saw";
  rope.mass = 0.6;
  rope.stiffness = 6e6;
  m.ropes = {rope};
  m.sheaves = {sheave("idler", {9, 0, 0}), sheave("drive", {0, 0, 0}), sheave("top", {4, 0, 2})};
  m.sheaves[1].motor.emplace();
  description::Reeving r;
  r.rope = "saw";
  r.path = {over("idler"), over("drive"), over("top")};
  r.closed = true;
  r.length = 20;
  m.reevings = {r};
  description::RopeLoad load;
  load.rope = "saw";
  load.between = {"idler", "drive"};
  load.tangential = 4e3;
  load.position = 0.25;
  m.rope_loads = {load};
  return m;
}

std::vector<std::string> names(const Reeving& r) {
  std::vector<std::string> all;
  all.reserve(r.nodes.size());
  for (const Node& n : r.nodes) all.push_back(n.name);
  return all;
}

TEST(RopeLoads, StandInTheSpanTheyName) {
  const auto model = compile(saw());
  ASSERT_TRUE(model) << complaints_of(saw());
  const Reeving& r = model->reevings[0];
  // from the drive on
  EXPECT_THAT(names(r), testing::ElementsAre("drive", "top", "idler", "saw.load"));
  EXPECT_EQ(r.nodes[3].load.share, 0.25);
  EXPECT_EQ(r.nodes[3].load.sense, -1);
  EXPECT_TRUE(r.nodes[3].load.by_motion);
  // at a quarter of the straight line from idler to drive, which both sheaves shift to one side
  EXPECT_NEAR(model->bodies[0].position.x(), 6.75, 1e-9);
  EXPECT_NEAR(std::abs(model->bodies[0].position.z()), 0.25, 1e-9);
}

TEST(RopeLoads, TheOtherOrderCountsFromTheOtherSide) {
  Machine m = saw();
  m.rope_loads[0].between = {"drive", "idler"};
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_EQ(model->reevings[0].nodes[3].load.share, 0.75);
}

// Sheaves on a body stand where its turn puts them: the load is where it is with the same sheaves on the ground.
TEST(RopeLoads, StandBesideRoundsOnATurnedBody) {
  const auto place = [](bool turned) {
    Machine m = saw();
    if (turned) {
      description::Body frame;
      frame.name = "frame";
      frame.at = {1, 0, 0};
      frame.turned.emplace();
      frame.turned->ry = M_PI / 2;  // z of the body along x, x of it along -z
      m.bodies = {frame};
      m.sheaves[0].body = "frame";
      m.sheaves[0].at = {0, 0, 8};
    }
    const auto model = compile(m);
    EXPECT_TRUE(model) << complaints_of(m);
    for (const Body& body : model->bodies) {
      if (body.of_rope) return body.position;
    }
    ADD_FAILURE() << "no point of the rope";
    return Vector3(Vector3::Zero());
  };
  EXPECT_LT((place(true) - place(false)).norm(), 1e-12);
  EXPECT_GT(place(false).norm(), 1) << "between two sheaves, not at one";
}

TEST(RopeLoads, OfTwoSheavesTheOrderOfThePathDecides) {
  Machine m = saw();
  m.reevings[0].path.pop_back();
  m.rope_loads.push_back(m.rope_loads[0]);
  m.rope_loads[1].between = {"drive", "idler"};
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_THAT(names(model->reevings[0]), testing::ElementsAre("drive", "saw.load_2", "idler", "saw.load"));
}

TEST(RopeLoads, ARateIsDividedInTheMiddleOfItsParts) {
  Machine m = saw();
  m.rope_loads[0].tangential.reset();
  m.rope_loads[0].position.reset();
  m.rope_loads[0].rate = 500;
  m.rope_loads[0].from = 0.2;
  m.rope_loads[0].to = 0.6;
  m.rope_loads[0].elements = 4;
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  const auto& nodes = model->reevings[0].nodes;
  ASSERT_EQ(nodes.size(), 7U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(nodes[3 + i].load.share, 0.25 + 0.1 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(nodes[3 + i].load.part, 0.1, 1e-12);
    EXPECT_EQ(nodes[3 + i].load.rate, 500);
  }
  m.rope_loads[0].elements.reset();
  EXPECT_EQ(compile(m)->reevings[0].nodes.size(), 3U + 13U) << "32 for a whole span, at most 16";
}

TEST(RopeLoads, SeveralStandInTheOrderOfTheirShares) {
  Machine m = saw();
  description::RopeLoad second = m.rope_loads[0];
  second.position = 0.1;
  second.name = "first";
  m.rope_loads.push_back(second);
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_THAT(names(model->reevings[0]), testing::ElementsAre("drive", "top", "idler", "first", "saw.load"));
}

TEST(RopeLoads, TellsEachMistakeAtItsPlace) {
  const std::vector<std::pair<std::function<void(Machine&)>, std::string>> cases = {
      {[](Machine& m) { m.rope_loads[0].rope = "sow"; }, "rope_loads[0].rope: there is no reeving 'sow'; did you mean"},
      {[](Machine& m) { m.rope_loads[0].between = {"idler"}; }, "rope_loads[0].between: two neighbours"},
      {[](Machine& m) {
         m.rope_loads[0].between = {"idler", "drve"};
       },
       "rope_loads[0].between: the path of 'saw' has no 'drve'; did you mean 'drive'?"},
      {[](Machine& m) { m.rope_loads[0].rate = 3; }, "rope_loads[0]: either 'tangential' or 'rate'"},
      {[](Machine& m) { m.rope_loads[0].to = 0.5; }, "rope_loads[0].to: belongs to a 'rate'"},
      {[](Machine& m) { m.rope_loads[0].tangential.reset(); }, "rope_loads[0]: needs 'tangential' or 'rate'"},
      {[](Machine& m) { m.rope_loads.push_back(m.rope_loads[0]); }, "another load acts at the same place"},
      {[](Machine& m) {
         m.sheaves.push_back(sheave("far", {4, 0, 5}));
         m.reevings[0].path.insert(m.reevings[0].path.begin() + 1, over("far"));
       },
       "rope_loads[0].between: 'idler' and 'drive' on the path of 'saw' are no neighbours on it: 'drive', 'top'"}};
  for (const auto& [change, words] : cases) {
    Machine m = saw();
    change(m);
    EXPECT_THAT(complaints_of(m), HasSubstr(words));
  }
}

TEST(RopeLoads, ATorqueMayFindOneOfThem) {
  Machine m = saw();
  m.rope_loads[0].tangential.reset();
  m.sheaves[1].motor->torque = "800 N m";
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_TRUE(model->reevings[0].nodes[3].load.open);
  EXPECT_NEAR(*model->reevings[0].nodes[0].tension_drop, 800 / 0.25, 1e-9);
}

}  // namespace rope_loads_test
