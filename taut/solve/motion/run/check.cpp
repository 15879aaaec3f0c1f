#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/parts/couple.hpp"

namespace taut::solve::dynamics {
namespace {

/// Whether a drive turns it by a torque, or lets it go, now or by an event to come.
bool turned_by_torque(const machine::Model& model, const DynamicState& start, const Spin& spin, const Values& v) {
  using machine::DriveKind;
  const machine::Drive& drive = v.drive(spin);
  const bool let_go = drive.kind != DriveKind::speed && drive.kind != DriveKind::pull;
  if (let_go && drive.kind != DriveKind::held && !drive.brake) return true;
  for (std::size_t i = 0; i < model.events.size(); ++i) {
    const machine::Event& event = model.events[i];
    if (i < start.happened.size() && start.happened[i] != 0) continue;
    if (event.of_motor != (spin.drum < 0) || event.index != (spin.drum < 0 ? spin.motor : spin.drum)) continue;
    if (event.kind == machine::EventKind::drive && event.drive.kind == DriveKind::torque) return true;
    if (event.kind == machine::EventKind::brake && !event.brake_set && let_go) return true;
  }
  return false;
}

/// What turns without inertia follows from the one rope on it, and from nothing where several share its torque.
Outcome check_turning(const Mechanism& m, const DynamicState& start, const Values& v) {
  for (const Spin& spin : m.spins) {
    const bool shared = spin.drum >= 0 && spin.contacts.size() > 1;
    if (spin.inertia > 0 || (spin.motor < 0 && !shared)) continue;
    if (!turned_by_torque(*m.model, start, spin, v)) continue;
    if (shared) {
      return infeasible(fmt::format(
          "several ropes lie on the drum '{}': how they share its torque follows from its turning; give it an "
          "'inertia'",
          m.model->drums[spin.drum].name));
    }
    return infeasible(fmt::format("the sheave with the motor '{}' needs an 'inertia' when a torque drives it",
                                  m.model->motors[spin.motor].name));
  }
  return {};
}

}  // namespace

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
  if (Outcome turning = check_turning(m, start, v); !turning.ok()) return turning;
  for (const machine::Reeving& rope : model.reevings) {
    if (!std::isinf(rope.stiffness)) continue;
    return infeasible(fmt::format("the rope '{}' does not stretch; in motion it needs its 'stiffness'", rope.name));
  }
  return {};
}

}  // namespace taut::solve::dynamics
