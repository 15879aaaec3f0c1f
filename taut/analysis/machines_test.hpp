#pragma once
#include <string>
#include <utility>
#include <vector>

#include "taut/model/model.hpp"

/// Machines built by code, for the tests of the analyses.
namespace taut_test {

using taut::Vector3;
namespace model = taut::model;

inline model::Node anchor(const std::string& name, const Vector3& at) {
  model::Node node;
  node.name = name;
  node.at.at = at;
  return node;
}

inline model::Node anchor_on(const std::string& name, int body, const Vector3& at = Vector3::Zero()) {
  model::Node node = anchor(name, at);
  node.at.body = body;
  return node;
}

/// A point over which the rope runs without loss.
inline model::Node over(const std::string& name, const Vector3& at, int body = model::ground) {
  model::Node node = anchor_on(name, body, at);
  node.kind = model::NodeKind::contact;
  return node;
}

inline model::Node saddle(const std::string& name, const Vector3& at, double friction) {
  model::Node node = over(name, at);
  node.law = {friction, friction > 0 ? 0.0 : 1.0};
  node.support = Vector3::UnitZ();
  return node;
}

/// A sheave with its axis along y.
inline model::Node sheave(const std::string& name, const Vector3& at, double radius, int side, double efficiency = 1,
                          int body = model::ground) {
  model::Node node = over(name, at, body);
  node.radius = radius;
  node.side = side;
  node.law.efficiency = efficiency;
  return node;
}

inline model::Reeving reeve(const std::string& name, std::vector<model::Node> nodes, double length, double weight,
                            double stiffness) {
  model::Reeving r;
  r.name = name;
  r.nodes = std::move(nodes);
  r.value = length;
  r.weight = weight;
  r.stiffness = stiffness;
  return r;
}

inline model::Body body(const std::string& name, const Vector3& at, double mass, const std::string& free) {
  model::Body b;
  b.name = name;
  b.position = at;
  b.mass = mass;
  for (const char axis : free) {
    model::Freedom way;
    const int i = axis - (axis >= 'x' ? 'x' : 'X');
    (axis >= 'x' ? way.along : way.about)[i] = 1;  // X Y Z: rotations
    b.free.push_back(way);
  }
  return b;
}

}  // namespace taut_test
