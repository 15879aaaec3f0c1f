#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "taut/machine/compile/carriages.hpp"
#include "taut/machine/model.hpp"

/// Machines built by code, for the tests of the analyses.
namespace taut_test {

using taut::Vector3;
namespace machine = taut::machine;

inline const Vector3 origin{0, 0, 0};

inline machine::Node anchor_on(const std::string& name, int body, const Vector3& at = origin) {
  machine::Node node;
  node.name = name;
  node.at = {.body = body, .at = at};
  return node;
}

inline machine::Node anchor(const std::string& name, const Vector3& at) { return anchor_on(name, machine::ground, at); }

/// A point over which the rope runs without loss.
inline machine::Node over(const std::string& name, const Vector3& at, int body = machine::ground) {
  machine::Node node = anchor_on(name, body, at);
  node.kind = machine::NodeKind::contact;
  return node;
}

inline machine::Node saddle(const std::string& name, const Vector3& at, double friction) {
  machine::Node node = over(name, at);
  node.law = {.friction = friction, .efficiency = friction > 0 ? 0.0 : 1.0};
  node.support = Vector3::UnitZ();
  return node;
}

/// A sheave with its axis along y.
inline machine::Node sheave(const std::string& name, const Vector3& at, double radius, int side, double efficiency = 1,
                            int body = machine::ground) {
  machine::Node node = over(name, at, body);
  node.radius = radius;
  node.side = side;
  node.law.efficiency = efficiency;
  return node;
}

inline machine::Reeving reeve(const std::string& name, std::vector<machine::Node> nodes, double length, double weight,
                              double stiffness) {
  machine::Reeving r;
  r.name = name;
  r.nodes = std::move(nodes);
  r.value = length;
  r.weight = weight;
  r.stiffness = stiffness;
  return r;
}

inline machine::Body body(const std::string& name, const Vector3& at, double mass, const std::string& free) {
  machine::Body b;
  b.name = name;
  b.position = at;
  b.mass = mass;
  for (const char axis : free) {
    machine::Freedom way;
    const int i = axis - (axis >= 'x' ? 'x' : 'X');
    (axis >= 'x' ? way.along : way.about)[i] = 1;  // X Y Z: rotations
    b.free.push_back(way);
  }
  return b;
}

/// A skyline over two saddles, uphill; `length` 316 m is slack, 313 m taut.
inline machine::Model three_spans(double length, double friction) {
  machine::Model m;
  m.reevings.push_back(reeve("skyline",
                             {anchor("tail", {0, 0, 10}), saddle("s1", {90, 0, 40}, friction),
                              saddle("s2", {200, 5, 70}, friction), anchor("head", {300, 0, 80})},
                             length, 20, 26e6));
  return m;
}

/// The same with a carriage in the middle span, held by a mainline from the head (true) or by nothing but its track.
inline machine::Model with_carriage(bool mainline, double friction = 0.1, double mass = 2000) {
  machine::Model m = three_spans(318, friction);
  m.bodies.push_back(body("car", {145, 2, 45}, mass, "xyz"));
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 2, over("car", Vector3::Zero(), 0));
  m.carriages.push_back({"car", 0, 0, 2, mainline ? std::optional(1) : std::nullopt});
  if (mainline)
    m.reevings.push_back(reeve("mainline", {anchor("winch", {300, 0, 82}), anchor_on("car", 0)}, 158, 5, 5e6));
  return m;
}

/// A single span with a carriage of `rollers`, its mass and load at its origin below them.
inline machine::Model rollers(int count, double wheelbase, double height, double mass, double rise = 30) {
  machine::Model m;
  machine::Body car = body("car", {60, 0, 10}, mass, "xyz");
  if (count > 1 || height > 0) car.free.push_back({Vector3::Zero(), Vector3::UnitY()});
  machine::turn_along(car, {150, 0, rise}, count);
  m.bodies.push_back(car);
  std::vector<machine::Node> nodes{anchor("head", {0, 0, 20})};
  for (int i = 0; i < count; ++i) {
    const double forward = count > 1 ? wheelbase * (i / (count - 1.0) - 0.5) : 0;
    nodes.push_back(over("car", {forward, 0, height}, 0));
    nodes.back().support = -Vector3::UnitZ();
  }
  nodes.push_back(anchor("tail", {150, 0, 20 + rise}));
  m.reevings.push_back(reeve("skyline", nodes, 160 + rise * rise / 300, 18, 26e6));
  m.carriages.push_back({"car", 0, 0, 1, {}, count});
  return m;
}

/// A block of `mass` on vertical falls of a rope from a winch beside them.
inline machine::Model tackle(int falls, double efficiency, double mass, double weight = 0) {
  machine::Model m;
  const double radius = 0.25;
  m.bodies.push_back(body("block", {0, 0, 5}, mass, "xz"));
  std::vector<machine::Node> nodes{anchor("winch", {-10, 0, 0})};
  for (int i = 0; i < falls; ++i) {
    const bool head = i % 2 == 0;
    nodes.push_back(head ? sheave("head", {0, 0, 18}, radius, 1, efficiency)
                         : sheave("block", Vector3::Zero(), radius, 1, efficiency, 0));
  }
  nodes.push_back(falls % 2 == 0 ? anchor("becket", {-radius, 0, 18}) : anchor_on("becket", 0, {radius, 0, 0}));
  m.reevings.push_back(reeve("hoist", nodes, 20.6 + 13 * falls + 0.5, weight, 1e7));
  return m;
}

/// A boom on a hinge, held by a luffing rope; its hoist rope runs from a drum over a skew sheave at the tip to a hook.
inline machine::Model boom() {
  machine::Model m;
  machine::Body b = body("boom", {0, 0, 0}, 1000, "Y");
  b.orientation << std::cos(0.8), 0, -std::sin(0.8), 0, 1, 0, std::sin(0.8), 0, std::cos(0.8);
  b.centre = {5, 0, 0};
  m.bodies.push_back(b);
  m.bodies.push_back(body("hook", {7, 0, 2}, 500, "xyz"));
  m.reevings.push_back(reeve("luffing", {anchor("gantry", {-5, 0.5, 6}), anchor_on("tip", 0, {10, 0, 0})}, 14, 8, 5e6));
  machine::Node tip = sheave("tip", {10, 0.1, 0.2}, 0.3, 1, 0.95, 0);
  tip.axis = Vector3(0.1, 1, 0.05).normalized();
  machine::Node drum = anchor("winch", {-1, 0, 0});
  drum.radius = 0.2;
  m.reevings.push_back(reeve("hoist", {drum, tip, anchor_on("hook", 1)}, 17, 8, 5e6));
  return m;
}

/// The end of a rope on a new drum of the machine, which is held as long as nothing drives it.
inline machine::Node add_drum(machine::Model& m, const std::string& name, const Vector3& at, double radius,
                              int side = 1) {
  machine::Node node = anchor(name, at);
  node.radius = radius;
  node.side = side;
  node.drum = static_cast<int>(m.drums.size());
  machine::Drum drum;
  drum.name = name;
  drum.core_radius = radius;
  m.drums.push_back(drum);
  return node;
}

/// A floor along x through the origin, and the sole of a body on it.
inline machine::FaceContact& add_floor(machine::Model& m, int body, double half_length, double stiffness,
                                       double friction) {
  machine::Face floor;
  floor.name = "floor";
  floor.from = {-half_length, 0, 0};
  floor.to = {half_length, 0, 0};
  m.faces.push_back(floor);
  machine::FaceContact sole;
  sole.name = "sole";
  sole.body = body;
  sole.face = static_cast<int>(m.faces.size()) - 1;
  sole.stiffness = sole.tangential_stiffness = stiffness;
  sole.static_friction = sole.kinetic_friction = friction;
  return m.contacts.emplace_back(sole);
}

/// The same machine turned about the vertical through the origin, then shifted.
inline machine::Model turned(machine::Model m, double angle, const Vector3& by) {
  const taut::Matrix3 turn = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
  const auto place = [&](machine::Place& p) {
    if (p.body == machine::ground) p.at = turn * p.at + by;
  };
  for (machine::Body& b : m.bodies) {
    b.position = turn * b.position + by;
    b.orientation = turn * b.orientation;
    for (machine::Freedom& way : b.free) way = {.along = turn * way.along, .about = turn * way.about};
  }
  for (machine::Reeving& r : m.reevings) {
    for (machine::Node& n : r.nodes) {
      place(n.at);
      if (n.at.body == machine::ground) n.axis = turn * n.axis;
    }
  }
  for (machine::Load& l : m.loads) l.force = turn * l.force;
  m.terrain_from = turn * m.terrain_from + by;
  m.terrain_along = turn * m.terrain_along;
  return m;
}

/// A skyline downhill over a sheave below it, with a carriage first guessed at a height.
inline machine::Model downhill(double z, int side, double diameter = 1) {
  machine::Model m;
  m.bodies.push_back(body("car", {61.8, 0, z}, 234, "xyz"));
  std::vector<machine::Node> nodes{
      anchor("A", {0, 0, 10}), over("car", origin, 0), sheave("S1", {106.7, 0, -7.15}, diameter / 2, side, 0.92),
      sheave("S2", {197.8, 0, -12.33}, diameter / 2, 1, 0.98), anchor("B", {412, 0, -119.5})};
  nodes[1].support = -Vector3::UnitZ();
  nodes[2].side_open = nodes[3].side_open = true;
  m.reevings.push_back(reeve("sky", nodes, 440.3, 0.362 * taut::standard_gravity, 3.1e6));
  m.carriages.push_back({"car", 0, 0, 1, {}});
  return m;
}

/// A skyline of given tension over a support, with a carriage that is put at a place, or rolls.
inline machine::Model fed_skyline(double z, double efficiency) {
  machine::Model m;
  m.bodies.push_back(body("car", {60, 0, z}, 900, "xyz"));
  std::vector<machine::Node> nodes{anchor("A", {0, 0, 10}), over("car", origin, 0), over("S", {140, 0, 70}),
                                   anchor("B", {400, 0, 150})};
  nodes[1].support = -Vector3::UnitZ();
  nodes[2].law.efficiency = efficiency;
  m.reevings.push_back(reeve("sky", nodes, 0, 8.5, 11.4e6));
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 15e3;
  m.carriages.push_back({"car", 0, 0, 1, {}});
  return m;
}

/// The machine in a frame turned, mirrored or scaled: `M` orthogonal times a scale; forces kept.
inline machine::Model transformed(machine::Model m, const taut::Matrix3& M) {
  const double mirror = M.determinant() < 0 ? -1 : 1, scale = std::cbrt(std::abs(M.determinant()));
  const taut::Matrix3 turn = M / scale;
  for (machine::Body& b : m.bodies) {
    b.position = M * b.position;
    b.centre = M * b.centre;
    for (machine::Freedom& way : b.free) way = {.along = turn * way.along, .about = mirror * (turn * way.about)};
  }
  for (machine::Load& load : m.loads)
    load = {.at = {.body = load.at.body, .at = M * load.at.at}, .force = turn * load.force};
  for (machine::Reeving& r : m.reevings) {
    r.value *= scale;
    r.weight /= scale;
    for (machine::Node& n : r.nodes) {
      n.at.at = M * n.at.at;
      n.radius *= scale;
      n.axis = mirror * (turn * n.axis);
    }
  }
  return m;
}

}  // namespace taut_test
