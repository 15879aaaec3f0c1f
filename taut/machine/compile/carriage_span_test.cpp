#include "taut/machine/compile/carriage_span.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::machine::carriage_span_test {

Node node(const std::string& name, NodeKind kind, double x, double z, int body = ground) {
  Node n;
  n.name = name;
  n.kind = kind;
  n.at = {.body = body, .at = body == ground ? Vector3(x, 0, z) : Vector3(0, 0, 0)};
  return n;
}

/// head, jack1, car, jack2, tail at 0, 100, -, 200, 300.
Model line(NodeKind hold, bool backwards) {
  Model m;
  Body body;
  body.name = "car";
  m.bodies = {body};
  Reeving r;
  r.nodes = {node("head", NodeKind::anchor, 0, 0), node("jack1", NodeKind::contact, 100, 0), node("car", hold, 0, 0, 0),
             node("jack2", NodeKind::contact, 200, 0), node("tail", NodeKind::anchor, 300, 0)};
  if (backwards) std::reverse(r.nodes.begin(), r.nodes.end());
  r.value = 330;
  m.reevings = {r};
  m.carriages = {{.name = "car", .body = 0, .reeving = 0, .node = 2, .mainline = {}}};
  return m;
}

std::string order(const Model& m) {
  std::string names;
  for (const Node& n : m.reevings[0].nodes) names += n.name + " ";
  return names;
}

TEST(CarriageSpan, TheCarriagePassesTheSupports) {
  for (const NodeKind hold : {NodeKind::contact, NodeKind::clamp}) {
    const Model m = line(hold, false);
    EXPECT_EQ(order(with_carriage_at(m, 0, 50)), "head car jack1 jack2 tail ");
    EXPECT_EQ(order(with_carriage_at(m, 0, 150)), "head jack1 car jack2 tail ");
    EXPECT_EQ(order(with_carriage_at(m, 0, 250)), "head jack1 jack2 car tail ");
    EXPECT_EQ(order(with_carriage_at(m, 0, 350)), order(m)) << "nowhere on the line";
    const Model first = with_carriage_at(m, 0, 50);
    EXPECT_EQ(first.carriages[0].node, 1);
    EXPECT_EQ(first.bodies[0].position, Vector3(50, 0, 0));
    if (hold == NodeKind::clamp) {
      EXPECT_NEAR(first.reevings[0].nodes[1].length_before, 55, 1e-12);
    }
    EXPECT_EQ(order(with_carriage_at(first, 0, 250)), "head jack1 jack2 car tail ");
    EXPECT_EQ(order(with_carriage_at(line(hold, true), 0, 50)), "tail jack2 jack1 car head ");
  }
}

TEST(CarriageSpan, TheGripAndAllRollersPassTheSupportsToo) {
  Model m = line(NodeKind::contact, false);
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 3, node("car", NodeKind::contact, 0, 0, 0));
  m.carriages[0].rollers = 2;
  Reeving haul;
  haul.nodes = {node("drive", NodeKind::drive, 0, 0), node("guide", NodeKind::contact, 100, 0),
                node("car", NodeKind::clamp, 0, 0, 0), node("wheel", NodeKind::contact, 300, 0)};
  haul.closed = true;
  haul.value = 620;
  m.reevings.push_back(haul);
  m.carriages[0].grip = Grip{.reeving = 1, .node = 2};
  const Model moved = with_carriage_at(m, 0, 50);
  EXPECT_EQ(order(moved), "head car car jack1 jack2 tail ");
  EXPECT_EQ(moved.carriages[0].node, 1);
  EXPECT_EQ(moved.carriages[0].grip.value().node, 1);
  EXPECT_EQ(moved.reevings[1].nodes[1].name, "car");
  EXPECT_NEAR(moved.reevings[1].nodes[1].length_before, 620 * 50.0 / 600, 1e-9);
  const Model back = with_carriage_at(moved, 0, 150);
  EXPECT_EQ(order(back), "head jack1 car car jack2 tail ");
  EXPECT_EQ(back.carriages[0].grip.value().node, 2);
}

TEST(CarriageSpan, AlongAnyDirection) {
  Model m = line(NodeKind::contact, false);
  const double c = std::cos(2.1), s = std::sin(2.1);
  for (Node& n : m.reevings[0].nodes) {
    if (n.at.body == ground) n.at.at = Vector3(c * n.at.at.x(), s * n.at.at.x(), 0);
  }
  const Model moved = with_carriage_at(m, 0, 250, Vector3(c, s, 0));
  EXPECT_EQ(order(moved), "head jack1 jack2 car tail ");
  EXPECT_NEAR((moved.bodies[0].position - 250 * Vector3(c, s, 0)).norm(), 0, 1e-10);
}

TEST(CarriageSpan, OfTwoSpansAboveEachOtherTheNearerOneInThePath) {
  Model m = line(NodeKind::contact, false);
  // the rope turns at the tail and comes back below
  m.reevings[0].nodes[4].kind = NodeKind::contact;
  m.reevings[0].nodes.push_back(node("back", NodeKind::anchor, 0, -10));
  EXPECT_EQ(order(with_carriage_at(m, 0, 250)), "head jack1 jack2 car tail back ");
  EXPECT_EQ(order(with_carriage_at(m, 0, 150)), "head jack1 car jack2 tail back ");
}

}  // namespace taut::machine::carriage_span_test
