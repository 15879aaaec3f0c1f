#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/parts/couple.hpp"

namespace taut::solve::dynamics {

Outcome check(const Mechanism& m, const DynamicState& start, const Values& v) {
  const machine::Model& model = *m.model;
  if (!model.beams.empty()) {
    return infeasible(fmt::format(
        "the beam '{}' bends in statics only: for a motion put a body in its place (fixed, or hinged by 'free: [ry]' "
        "with its inertia and held by its guys), and fix ropes to points on that body",
        model.beams.front().name));
  }
  for (const Body& body : m.bodies) {
    if (body.count == 0) continue;
    const std::string name = body.model >= 0 ? model.bodies[body.model].name : "a node of a rope";
    bool turns_freely = false;
    for (int f = 0; f < body.count; ++f) {
      const Vector3& about = body.about[as_size(f)];
      const Matrix3 turned = body.model >= 0 ? start.bodies[body.model].orientation : Matrix3(Matrix3::Identity());
      const Vector3 lever = about.cross(turned * body.centre);
      const Matrix3 inertia = turned * body.inertia * turned.transpose();
      if (about != Vector3::Zero() && !(about.dot(inertia * about) + body.mass * lever.squaredNorm() > 0))
        turns_freely = true;
    }
    const bool shifts = std::any_of(body.along.begin(), body.along.begin() + body.count,
                                    [](const Vector3& a) { return a != Vector3::Zero(); });
    if ((shifts && !(body.mass > 0)) || turns_freely) {
      return infeasible(fmt::format("'{}' may move but has no {}; give it one", name,
                                    turns_freely ? "inertia about its axis" : "mass"));
    }
  }
  if (Outcome couples = check_couples(m, v); !couples.ok()) return couples;
  for (const Spin& spin : m.spins) {
    if (spin.motor < 0 || spin.inertia > 0) continue;
    const machine::Drive& drive = v.drive(spin);
    if (drive.kind == machine::DriveKind::held || drive.kind == machine::DriveKind::speed || drive.brake) continue;
    return infeasible(fmt::format("the sheave with the motor '{}' needs an 'inertia' when a torque drives it",
                                  model.motors[spin.motor].name));
  }
  for (const machine::Reeving& rope : model.reevings) {
    if (!std::isinf(rope.stiffness)) continue;
    return infeasible(fmt::format("the rope '{}' does not stretch; in motion it needs its 'stiffness'", rope.name));
  }
  return {};
}

}  // namespace taut::solve::dynamics
