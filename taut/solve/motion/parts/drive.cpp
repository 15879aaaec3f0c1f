#include <algorithm>

#include "taut/solve/motion/parts/values.hpp"

namespace taut::solve::dynamics {

double working_radius(const Mechanism& /*m*/, const Contact& contact, const Values& v) {
  const bool leaves = contact.out >= 0;
  return v.lines[leaves ? contact.out : contact.in].radius[leaves ? 0 : 1];
}

namespace {

/// The brake in which a drum may turn; none: no brake is set, or it holds anything.
const machine::Brake* slipping_brake(const Mechanism& m, const Spin& spin, const Values& v) {
  if (spin.drum < 0 || !v.drive(spin).brake) return nullptr;
  const auto& brake = m.model->drums[spin.drum].brake;
  return brake ? &*brake : nullptr;
}

}  // namespace

double brake_torque(const Mechanism& m, const Spin& spin, const Values& v, double t) {
  const machine::Brake* brake = slipping_brake(m, spin, v);
  return brake == nullptr ? 0 : machine::torque_of(*brake, t - v.drive(spin).brake_since);
}

double friction_of_spin(const Mechanism& m, const Spin& spin, const Values& before, const Values& now) {
  double moment = brake_torque(m, spin, before, now.when);
  for (const auto& one : spin.contacts) moment += bearing_slope(m, m.contacts[one.first], before, now).capacity;
  return moment;
}

std::optional<Turning> prescribed(const Mechanism& m, const Spin& spin, const Values& v, double t) {
  if (spin.drum < 0 && spin.motor < 0) return std::nullopt;
  const machine::Drive& drive = v.drive(spin);
  if (slipping_brake(m, spin, v) != nullptr) return std::nullopt;  // setting it cuts the drive
  if (drive.brake || drive.kind == machine::DriveKind::held) return Turning{};
  // gives its tension to the rope, whatever the drum asks beside it: the rope goes by, and the drum does not count
  if (drive.kind == machine::DriveKind::pull && spin.drum >= 0) return Turning{};
  if (drive.kind != machine::DriveKind::speed) return std::nullopt;
  const machine::SignalValue speed = machine::at(drive.signal, t);
  const double radius = working_radius(m, m.contacts[spin.contacts.front().first], v);
  return Turning{speed.value / radius, speed.rate / radius};
}

double drive_torque(const Mechanism& /*m*/, const Spin& spin, const Values& v, double t) {
  if (spin.drum < 0 && spin.motor < 0) return 0;
  const machine::Drive& drive = v.drive(spin);
  if (drive.brake || drive.kind != machine::DriveKind::torque) return 0;
  return machine::at(drive.signal, t).value;
}

namespace {

/// What is left of a rope that breaks somewhere.
double left_of(const Mechanism& m, int reeving, const Values& v) {
  const auto [first, lines] = m.first_line[reeving];
  double left = 1;
  for (int i = first; i < first + lines; ++i) left = std::min(left, v.lines[i].gone);
  return left;
}

}  // namespace

std::optional<double> given_tension(const Mechanism& m, const Contact& contact, const Values& v, double t,
                                    const Values& rope) {
  if (contact.drum < 0) return std::nullopt;
  const Spin& spin = m.spins[contact.spin];
  const machine::Drive& drive = v.drive(spin);
  if (drive.brake || drive.kind == machine::DriveKind::held || drive.kind == machine::DriveKind::speed)
    return std::nullopt;
  const bool pulls = drive.kind == machine::DriveKind::pull;
  if (!pulls && spin.inertia > 0) return std::nullopt;
  // against the free end of a broken rope there is nothing to pull
  const double left = left_of(m, contact.reeving, rope);
  if (pulls) return left * machine::at(drive.signal, t).value;
  return left * drive_torque(m, spin, v, t) / (working_radius(m, contact, v) * contact.copies);
}

}  // namespace taut::solve::dynamics
