#include "taut/machine/middle.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace taut::machine {
namespace {

/// Calls `f` with every place in the ground frame that equilibrium or motion depends on. What is observed stays as the
/// deck gives it.
template <class Machine, class F>
void for_each_place(Machine& model, const F& f) {
  const auto at = [&](int body, auto& place) {
    if (body == ground) f(place);
  };
  for (auto& body : model.bodies) f(body.position);
  for (auto& load : model.loads) at(load.at.body, load.at.at);
  for (auto& rope : model.reevings) {
    for (auto& node : rope.nodes) at(node.at.body, node.at.at);
    for (auto& guides : rope.guides) {
      for (auto& node : guides.all) at(node.at.body, node.at.at);
    }
  }
  for (auto& beam : model.beams) {
    for (auto& piece : beam.pieces) {
      at(piece.start.body, piece.start.at);
      at(piece.end.body, piece.end.at);
    }
  }
  for (auto& face : model.faces) {
    at(face.body, face.from);
    at(face.body, face.to);
  }
  for (auto& contact : model.contacts) at(contact.body, contact.at);
  for (auto& actuator : model.actuators) {
    at(actuator.from_body, actuator.from);
    at(actuator.to_body, actuator.to);
  }
}

}  // namespace

Vector3 far_middle(const Model& model) {
  Eigen::AlignedBox3d box;
  for_each_place(model, [&](const Vector3& place) { box.extend(place); });
  if (box.isEmpty() || box.center().norm() <= std::max(1.0, box.sizes().norm())) return Vector3::Zero();
  return box.center().array().round();
}

Model counted_from(const Vector3& middle, Model model) {
  model.origin += middle;
  for_each_place(model, [&](Vector3& place) { place -= middle; });
  return model;
}

}  // namespace taut::machine
