#include "taut/machine/rounds.hpp"

namespace taut::machine {
namespace {

rope::Round round_of(const Node& node, const Vector3& centre, const Matrix3& turned) {
  return node.radius == 0 ? rope::point(centre) : rope::sheave(centre, turned * node.axis, node.radius, node.side);
}

}  // namespace

Matrix3 turned(const Model& model, int body) {
  return body == ground ? Matrix3(Matrix3::Identity()) : model.bodies[body].orientation;
}

Vector3 in_ground(const Model& model, const Place& place) {
  if (place.body == ground) return place.at;
  const Body& body = model.bodies[place.body];
  return body.position + body.orientation * place.at;
}

rope::Round round_at(const Model& model, const Node& node) {
  return round_of(node, in_ground(model, node.at), turned(model, node.at.body));
}

rope::Round round_at(const State& state, const Node& node) {
  const bool moves = node.at.body != ground;
  const Matrix3 turned = moves ? state.bodies[node.at.body].orientation : Matrix3(Matrix3::Identity());
  return round_of(node, in_ground(state, node.at), turned);
}

}  // namespace taut::machine
