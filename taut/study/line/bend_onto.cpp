#include "taut/study/line/bend_onto.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace taut::study {
namespace {

/// Of a direction above the plane across `upwards`, rad.
double steepness(const Vector3& direction, const Vector3& upwards) {
  return std::atan2(direction.dot(upwards), direction.cross(upwards).norm());
}

}  // namespace

double bend_onto(const machine::Node& node, double wrap, const Vector3& in, const Vector3& out) {
  const bool given = node.support != Vector3::Zero(), upright_axis = std::abs(node.axis.z()) > M_SQRT1_2;
  if (node.radius > 0 || (!given && upright_axis)) return wrap;
  const Vector3 upwards = given ? node.support : up();
  return steepness(in, upwards) - steepness(out, upwards);
}

double bend_onto(const machine::Model& model, const solve::EquilibriumResult& state,
                 const solve::ContactResult& contact) {
  Vector3 in = Vector3::Zero(), out = Vector3::Zero();
  for (const solve::BranchResult& b : state.branches) {
    if (b.reeving != contact.reeving) continue;
    const Vector3 chord = b.end - b.start;
    if (b.to == contact.node) in = b.slack ? chord : -rope::force_on_end(b.shape);
    if (b.from == contact.node) out = b.slack ? chord : rope::force_on_start(b.shape);
  }
  return bend_onto(model.reevings[contact.reeving].nodes[contact.node], contact.wrap, in, out);
}

}  // namespace taut::study
