#include "taut/machine/compile/drives.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "taut/base/array.hpp"
#include "taut/machine/compile/drums.hpp"

namespace taut::machine {
namespace {

/// The largest speed of a signal, m/s: a rope that runs up is calculated as it runs. Empty where nobody says it: a
/// formula has no largest value without the duration of a motion.
std::optional<double> speed_of(const Drive& drive) {
  if (drive.kind != DriveKind::speed) return std::nullopt;
  if (const auto* sine = std::get_if<Sine>(&drive.signal.law)) return std::abs(sine->mean) + std::abs(sine->amplitude);
  const auto range = range_of(drive.signal);
  return range ? std::optional(std::max(std::abs(range->least), std::abs(range->most))) : std::nullopt;
}

void add_motor(Node& node, Reeving& reeving, const Motor& motor) {
  if (motor.drive.kind == DriveKind::torque && node.radius > 0) {
    node.tension_drop = at(motor.drive.signal, 0).value / (node.radius * reeving.copies);
  }
  if (const auto speed = speed_of(motor.drive); speed && node.kind == NodeKind::drive) reeving.speed = *speed;
}

void add_drum(const EndOnDrum& end, Reeving& reeving, Drum& drum) {
  drum.layer = layer_of(end);
  const auto speed = speed_of(drum.drive);
  if (speed && reeving.speed == 0) reeving.speed = *speed;
}

}  // namespace

void finish_drives(const Machine& machine, const Array<RopeData>& ropes, Model& model) {
  for (std::size_t i = 0; i < model.drums.size(); ++i) {
    const description::Drum& given = machine.drums[i];
    Drum& drum = model.drums[i];
    drum.automatic_layers = given.layers.has_value();
    drum.width = given.face_width.value_or(0);
    drum.length_on_drum = given.length_on_drum;
    drum.wound_at = given.wound_at;
    drum.pitch = given.pitch.value_or(0);
    drum.layer_height = given.layer_height.value_or(0);
    drum.flange_diameter = given.flange_diameter.value_or(0);
  }
  for (std::size_t r = 0; r < machine.reevings.size(); ++r) {
    Reeving& reeving = model.reevings[r];
    const RopeData& rope = ropes[*index_of(ropes, machine.reevings[r].rope)];
    reeving.mass = rope.mass;
    reeving.diameter = rope.diameter;
    for (Node& node : reeving.nodes) {
      if (node.kind != NodeKind::drive && node.kind != NodeKind::contact) continue;
      for (const Motor& motor : model.motors) {
        if (motor.name == node.name) add_motor(node, reeving, motor);
      }
    }
    for (const Node& node : reeving.nodes) {
      if (!node.drum) continue;
      const auto d = static_cast<std::size_t>(*node.drum);
      add_drum({.machine = machine, .ropes = ropes, .drum = machine.drums[d], .rope = rope}, reeving, model.drums[d]);
    }
  }
}

}  // namespace taut::machine
