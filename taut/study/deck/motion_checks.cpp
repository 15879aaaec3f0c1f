#include "taut/study/deck/motion_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace taut::study {
namespace {

std::string place_of_body(const machine::Machine& machine, const std::string& name) {
  const bool carriage = std::any_of(machine.carriages.begin(), machine.carriages.end(),
                                    [&](const auto& one) { return one.name == name; });
  return fmt::format("machine.{}.{}", carriage ? "carriages" : "bodies", name);
}

std::string place_of_sheave(const machine::Machine& machine, const std::string& name) {
  const bool sheave =
      std::any_of(machine.sheaves.begin(), machine.sheaves.end(), [&](const auto& one) { return one.name == name; });
  return fmt::format("machine.{}.{}", sheave ? "sheaves" : "supports", name);
}

/// Whether anything on a body has mass: itself, what hangs on it, half of the ropes that it holds.
bool has_mass(const machine::Model& model, int index, bool rope_mass) {
  const machine::Body& body = model.bodies[index];
  if (body.mass > 0 || body.counterweight > 0) return true;
  const bool hangs = std::any_of(model.loads.begin(), model.loads.end(),
                                 [&](const machine::Load& load) { return load.at.body == index && load.mass > 0; });
  return hangs || (rope_mass && std::any_of(model.reevings.begin(), model.reevings.end(), [&](const auto& rope) {
                     return rope.mass > 0 && std::any_of(rope.nodes.begin(), rope.nodes.end(),
                                                         [&](const auto& node) { return node.at.body == index; });
                   }));
}

void check_bodies(const machine::Machine& machine, const machine::Model& model, bool rope_mass,
                  std::vector<Complaint>& complaints) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const machine::Body& body = model.bodies[b];
    const bool shifts =
        std::any_of(body.free.begin(), body.free.end(), [](const auto& f) { return f.along.norm() > 0; });
    const int index = static_cast<int>(b);
    if (!shifts || model.is_on_screw(index) || body.of_rope || has_mass(model, index, rope_mass)) continue;
    complaints.push_back({place_of_body(machine, body.name), "moves freely: a motion needs its 'mass'"});
  }
}

void check_ropes(const machine::Machine& machine, const machine::Model& model, bool rope_mass,
                 std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < machine.reevings.size() && i < model.reevings.size(); ++i) {
    const machine::Reeving& rope = model.reevings[i];
    if (rope.segments > 1 && !(rope_mass && rope.mass > 0)) {
      complaints.push_back({fmt::format("machine.reevings[{}].segments", i),
                            rope_mass ? "the joints of the chain have the rope's mass, and it has none: give its 'mass'"
                                      : "'rope_mass: false' leaves the joints of the chain without mass"});
    }
  }
  for (const auto& given : machine.ropes) {
    if (!given.stiffness || !std::isinf(*given.stiffness)) continue;
    complaints.push_back(
        {fmt::format("machine.ropes.{}.stiffness", given.name), "in motion a rope stretches: give a finite one"});
  }
}

/// Sheaves that a torque turns, from the start or after an event.
void check_motors(const machine::Machine& machine, const machine::Model& model, std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < model.motors.size(); ++i) {
    const bool later = std::any_of(model.events.begin(), model.events.end(), [&](const machine::Event& event) {
      return event.kind == machine::EventKind::drive && event.of_motor && event.index == static_cast<int>(i) &&
             event.drive.kind == machine::DriveKind::torque;
    });
    if (!later && model.motors[i].drive.kind != machine::DriveKind::torque) continue;
    const bool turns = std::any_of(model.reevings.begin(), model.reevings.end(), [&](const machine::Reeving& rope) {
      return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& node) {
        return node.motor == static_cast<int>(i) && node.inertia > 0;
      });
    });
    if (turns) continue;
    complaints.push_back(
        {place_of_sheave(machine, model.motors[i].name), "a torque drives it: a motion needs its 'inertia'"});
  }
}

/// Wheels with several grooves: what couples the ropes over them is their turning.
void check_wheels(const machine::Machine& machine, const machine::Model& model, bool slowly,
                  std::vector<Complaint>& complaints) {
  std::map<int, Array<const machine::Node*>> wheels;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.wheel && !node.motor) wheels[*node.wheel].push_back(&node);
    }
  }
  for (const auto& [wheel, grooves] : wheels) {
    const machine::Node& node = *grooves.front();
    if (grooves.size() < 2 || (node.inertia > 0 && !slowly)) continue;
    complaints.push_back({place_of_sheave(machine, node.name) + ".one_wheel",
                          slowly ? "a quasi-static motion has no inertia that a wheel with several grooves turns by"
                                 : "a motion needs the 'inertia' of a wheel with several grooves"});
  }
}

bool turns_it(const machine::Drive& drive) {
  return drive.kind != machine::DriveKind::held && drive.kind != machine::DriveKind::pull;
}

/// Whether an event that a drum or a driven sheave has yet to meet sees to `what` it is.
template <class What>
bool event_comes(const machine::Model& model, int index, bool of_motor, const What& what) {
  return std::any_of(model.events.begin(), model.events.end(), [&](const machine::Event& event) {
    return event.index == index && event.of_motor == of_motor && what(event);
  });
}

bool turned_later(const machine::Model& model, int index, bool of_motor) {
  return event_comes(model, index, of_motor, [](const machine::Event& event) {
    if (event.kind == machine::EventKind::brake) return !event.brake_set;
    return event.kind == machine::EventKind::drive && turns_it(event.drive);
  });
}

bool by_torque_later(const machine::Model& model, int drum) {
  return event_comes(model, drum, false, [](const machine::Event& event) {
    return event.kind == machine::EventKind::drive && event.drive.kind == machine::DriveKind::torque;
  });
}

bool is_point(const machine::Model& model, std::optional<int> machine::Node::*of, int index) {
  return std::any_of(model.reevings.begin(), model.reevings.end(), [&](const machine::Reeving& rope) {
    return std::any_of(rope.nodes.begin(), rope.nodes.end(),
                       [&](const machine::Node& node) { return node.*of == index && node.radius == 0; });
  });
}

/// Drums that turn, from the start or after an event, and have no core. A rope of some thickness is wound all the same,
/// at a radius of half of it: that is no lever of a torque, nor does an inertia turn by it.
void check_cores(const machine::Machine& machine, const machine::Model& model, std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < model.drums.size(); ++i) {
    const machine::Drum& drum = model.drums[i];
    if (drum.core_radius > 0) continue;
    const int index = static_cast<int>(i);
    const bool turns = turns_it(drum.drive) || turned_later(model, index, false);
    const std::string place = "machine.drums." + drum.name;
    if (by_torque_later(model, index)) {
      complaints.push_back({place, "an event gives it a torque: a motion needs its 'core_diameter'"});
    } else if (turns && drum.inertia > 0) {
      complaints.push_back({place, "turns with its 'inertia': a motion needs its 'core_diameter'"});
    } else if (turns && is_point(model, &machine::Node::drum, index)) {
      complaints.push_back({place, "turns: a motion needs its 'core_diameter'"});
    }
  }
  for (const auto& what : machine.observe) {
    for (const machine::Drum& drum : model.drums) {
      if (drum.core_radius > 0 || what != drum.name + ".torque") continue;
      complaints.push_back({"machine.drums." + drum.name, fmt::format("'{}' needs its 'core_diameter'", what)});
    }
  }
}

/// Sheaves that turn, by a motor or with their inertia, and are points.
void check_radii(const machine::Machine& machine, const machine::Model& model, std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < model.motors.size(); ++i) {
    const machine::Motor& motor = model.motors[i];
    const int index = static_cast<int>(i);
    if (!is_point(model, &machine::Node::motor, index)) continue;
    if (!turns_it(motor.drive) && !turned_later(model, index, true)) continue;
    complaints.push_back({place_of_sheave(machine, motor.name), "is driven: a motion needs its 'diameter'"});
  }
  std::set<std::string> told;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      const bool turns = node.kind == machine::NodeKind::contact || node.kind == machine::NodeKind::drive;
      if (!turns || node.motor || node.radius > 0 || node.inertia == 0 || !told.insert(node.name).second) continue;
      complaints.push_back({place_of_sheave(machine, node.name) + ".inertia",
                            "turns by its rope at its rim, and the sheave is a point: a motion needs its 'diameter'"});
    }
  }
}

}  // namespace

void check_inertia(const machine::Machine& machine, const machine::Model& model, std::vector<Complaint>& complaints) {
  for (const auto& beam : machine.beams) {
    complaints.push_back({fmt::format("machine.beams.{}", beam.name),
                          "bends in statics only: for a motion put a body in its place (fixed, or hinged by 'free: "
                          "[ry]' with its inertia and held by its guys), and fix ropes to points on that body"});
  }
  if (!machine.beams.empty()) return;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const machine::Body& body = model.bodies[b];
    const bool shifts =
        std::any_of(body.free.begin(), body.free.end(), [](const auto& f) { return f.along.norm() > 0; });
    // a mass beside the axis has inertia about it; of a body that shifts too the axis goes through its centre
    const auto about_axis = [&](const Vector3& about) {
      double inertia = body.mass * about.cross(body.centre).squaredNorm() + about.dot(body.inertia.cwiseProduct(about));
      for (const machine::Load& load : model.loads) {
        if (load.at.body != static_cast<int>(b)) continue;
        inertia +=
            load.mass * about.cross(load.at.at - (shifts ? body.centre : Vector3(Vector3::Zero()))).squaredNorm();
      }
      return inertia;
    };
    const bool lacks = std::any_of(body.free.begin(), body.free.end(),
                                   [&](const auto& f) { return f.about.norm() > 0 && about_axis(f.about) <= 0; });
    if (!lacks) continue;
    complaints.push_back({place_of_body(machine, body.name), "turns freely: a motion needs its 'inertia'"});
  }
}

void check_guides(const machine::Machine& machine, std::vector<Complaint>& complaints) {
  for (const auto* list : {&machine.sheaves, &machine.supports}) {
    for (const auto& round : *list) {
      if (!round.holds) continue;
      complaints.push_back(
          {place_of_sheave(machine, round.name) + ".holds",
           fmt::format("a motion can't take '{}' out of the path as the carriage passes it: give the motion a deck of "
                       "one span, with the guides that hold there and without 'holds'",
                       round.name)});
    }
  }
}

void check_masses(const machine::Machine& machine, const machine::Model& model, const Moves& moves,
                  std::vector<Complaint>& complaints) {
  const bool rope_mass = moves.rope_mass;
  if (machine.beams.empty()) check_bodies(machine, model, rope_mass, complaints);
  check_ropes(machine, model, rope_mass, complaints);
  check_motors(machine, model, complaints);
  check_wheels(machine, model, moves.slowly, complaints);
  check_cores(machine, model, complaints);
  check_radii(machine, model, complaints);
}

}  // namespace taut::study
