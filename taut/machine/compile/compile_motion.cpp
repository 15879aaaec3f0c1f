#include "taut/machine/compile/compile_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/machine/links/measures.hpp"
#include "taut/machine/links/motion_links.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/machine/links/signals_of.hpp"

namespace taut::machine {
namespace {

void add_inertia(const description::Body& given, Body& body, const std::string& path, Complaints& complaints) {
  const auto& J = given.inertia;
  if (J.empty()) return;
  if (J.size() != 1 && J.size() != 3) {
    complaints.push_back({path, fmt::format("one value or Ixx, Iyy, Izz are expected, not {}", J.size())});
    return;
  }
  body.inertia = J.size() == 1 ? Vector3::Constant(J[0]) : Vector3(J[0], J[1], J[2]);
  // of any body: the largest is at most the sum of the other two
  const double largest = body.inertia.maxCoeff();
  if (largest > (body.inertia.sum() - largest) * (1 + 1e-9)) {
    complaints.push_back({path, "no body has one moment of inertia larger than the sum of the other two"});
  }
}

void add_driven(const description::Body& given, Body& body, const Array<Signal>& signals, const std::string& path,
                Complaints& complaints) {
  const description::BodyMotion& motion = *given.motion;
  struct Way {
    const char* key;
    const std::optional<std::string>* text;
    Vector3 axis;
    bool turns;
  };
  const std::array<Way, 6> ways = {{{.key = "x", .text = &motion.x, .axis = Vector3::UnitX(), .turns = false},
                                    {.key = "y", .text = &motion.y, .axis = Vector3::UnitY(), .turns = false},
                                    {.key = "z", .text = &motion.z, .axis = Vector3::UnitZ(), .turns = false},
                                    {.key = "rx", .text = &motion.rx, .axis = Vector3::UnitX(), .turns = true},
                                    {.key = "ry", .text = &motion.ry, .axis = Vector3::UnitY(), .turns = true},
                                    {.key = "rz", .text = &motion.rz, .axis = Vector3::UnitZ(), .turns = true}}};
  int rotations = 0;
  for (const Way& way : ways) {
    if (!*way.text) continue;
    const std::string at_key = fmt::format("{}.{}", path, way.key);
    if (std::find(given.free.begin(), given.free.end(), way.key) != given.free.end()) {
      complaints.push_back({at_key, "is 'free' too; a body is either driven that way or free"});
    }
    auto signal = signal_or_constant(**way.text, way.turns ? si::rad : si::m, signals, at_key, complaints);
    if (!signal) continue;
    rotations += way.turns ? 1 : 0;
    const double start = at(*signal, 0).value;
    if (way.turns) {
      body.orientation = Eigen::AngleAxisd(start, way.axis).toRotationMatrix();
      body.driven.push_back({Vector3::Zero(), way.axis, std::move(*signal)});
    } else {
      body.position += start * way.axis;
      body.driven.push_back({way.axis, Vector3::Zero(), std::move(*signal)});
    }
  }
  const bool turns_freely =
      std::any_of(given.free.begin(), given.free.end(), [](const auto& w) { return w[0] == 'r'; });
  if (rotations > 1 || (rotations == 1 && turns_freely)) {
    complaints.push_back({path, "one driven rotation alone; two, or one beside a free one, depend on their order"});
  }
  if (given.guide && rotations < static_cast<int>(body.driven.size())) {
    complaints.push_back({path, "a body on a guide is not driven along x, y or z"});
  }
}

Drive drive_of(const description::Drum& given, const Array<Signal>& signals, Complaints& complaints) {
  if (!given.drive) return {};
  const std::string path = fmt::format("drums.{}.drive", given.name);
  const description::Drive& d = *given.drive;
  Drive drive;
  if (auto found = drive_of(d.speed, d.torque, d.pull, signals, path, complaints)) {
    drive = std::move(*found);
  } else if (d.brake != description::Brake::unsaid) {
    drive.kind = DriveKind::free;  // once its brake is open
  }
  drive.brake = d.brake == description::Brake::set;
  if (drive.kind == DriveKind::pull && !(at(drive.signal, 0).value > 0)) {
    complaints.push_back({path + ".pull", "must be above 0 N at the start"});
  }
  return drive;
}

void add_faces(const Machine& machine, Model& model, Complaints& complaints) {
  constexpr double rounded = 1e-3;  // of a normal with three digits
  for (const auto& given : machine.faces) {
    const std::string path = fmt::format("faces.{}", given.name);
    Face face;
    face.name = given.name;
    face.from = vector_of(given.from);
    face.to = vector_of(given.to);
    if (given.body) face.body = named(model.bodies, *given.body, "body", path + ".body", complaints).value_or(ground);
    const Vector3 along = (face.to - face.from).normalized(), normal = vector_of(given.normal).normalized();
    const double askew = normal.dot(along);
    const Vector3 across = normal - askew * along;
    if (along.norm() == 0) {
      complaints.push_back({path + ".to", "is the same place as 'from'"});
    } else if (normal.norm() == 0) {
      complaints.push_back({path + ".normal", "the direction is zero"});
    } else if (std::abs(askew) > rounded) {
      const Vector3 fits = across.norm() > rounded ? across.normalized() : along.unitOrthogonal();
      complaints.push_back(
          {path + ".normal", fmt::format("is not square to the line from 'from' to 'to'; [{:.4g}, {:.4g}, {:.4g}] is",
                                         fits.x(), fits.y(), fits.z())});
    } else {
      face.normal = across.normalized();
    }
    model.faces.push_back(std::move(face));
  }
}

void add_contacts(const Machine& machine, const Links& links, Model& model, Complaints& complaints) {
  for (std::size_t i = 0; i < machine.contacts.size(); ++i) {
    const auto& given = machine.contacts[i];
    const std::string path = fmt::format("contacts[{}]", i);
    FaceContact contact;
    contact.name = given.name.value_or(given.point);
    if (index_of(model.contacts, contact.name)) {
      complaints.push_back(
          {path, fmt::format("another contact is called '{}' too; give this one a 'name'", contact.name)});
    }
    const auto face = named(model.faces, given.face, "face", path + ".face", complaints);
    contact.face = face.value_or(0);
    const Target* t = links.find(given.point, {Thing::point, Thing::body}, path + ".point", complaints);
    if (t != nullptr) {
      contact.body = t->place.body;
      contact.at = t->place.at;
    }
    if (t != nullptr && face && model.faces[*face].body == contact.body) {
      complaints.push_back({path, fmt::format("'{}' and '{}' are on the same body", given.point, given.face)});
    }
    contact.stiffness = given.stiffness;
    contact.damping = given.damping;
    contact.tangential_stiffness = given.tangential_stiffness.value_or(given.stiffness / 2);
    contact.tangential_damping = given.tangential_damping.value_or(given.damping / 2);
    contact.clearance = given.clearance;
    contact.static_friction = given.static_friction;
    contact.kinetic_friction = given.kinetic_friction.value_or(given.static_friction);
    contact.stribeck_speed = given.stribeck_speed.value_or(contact.stribeck_speed);
    if (contact.kinetic_friction > contact.static_friction) {
      complaints.push_back({path + ".kinetic_friction", "must not be larger than the static friction"});
    }
    model.contacts.push_back(std::move(contact));
  }
}

/// A cylinder that is never anything but locked or free needs nothing that moves it.
void check_drive_of(const description::Actuator& given, const Machine& machine, const std::string& path,
                    Complaints& complaints) {
  const int count = (given.force ? 1 : 0) + (given.law ? 1 : 0) + (given.speed ? 1 : 0);
  if (count > 1) complaints.push_back({path, "give one of force, law, speed, not several"});
  if (count > 0) return;
  const auto moves = [](ActuatorMode mode) { return mode == ActuatorMode::extend || mode == ActuatorMode::retract; };
  if (moves(given.mode)) {
    complaints.push_back({path, "needs one of force, law, speed, unless its 'mode' is lock or free"});
    return;
  }
  for (std::size_t i = 0; i < machine.events.size(); ++i) {
    const description::Event& event = machine.events[i];
    if (event.actuator != given.name || (event.mode != "extend" && event.mode != "retract")) continue;
    complaints.push_back(
        {path, fmt::format("needs one of force, law, speed: 'events[{}]' sets its mode to {}", i, *event.mode)});
    return;
  }
}

void add_actuators(const Machine& machine, const Links& links, Model& model, Complaints& complaints) {
  for (const auto& given : machine.actuators) {
    const std::string path = fmt::format("actuators.{}", given.name);
    Actuator a;
    a.name = given.name;
    const auto place = [&](const std::string& name, const char* key, int& body, Vector3& at) {
      const Target* t = links.find(name, {Thing::point, Thing::body, Thing::sheave}, path + key, complaints);
      if (t == nullptr) return;
      body = t->place.body;
      at = t->place.at;
    };
    place(given.from, ".from", a.from_body, a.from);
    place(given.to, ".to", a.to_body, a.to);
    if (given.from == given.to) complaints.push_back({path + ".to", "is the same place as 'from'"});
    const auto take = [&](const std::string& text, ActuatorKind kind, const Unit& unit, const char* key) {
      a.kind = kind;
      if (auto signal = signal_or_constant(text, unit, model.signals, path + key, complaints)) a.signal = *signal;
    };
    check_drive_of(given, machine, path, complaints);
    if (!given.speed && !given.law) take(given.force.value_or("0 N"), ActuatorKind::force, si::N, ".force");
    if (given.speed) take(*given.speed, ActuatorKind::speed, si::m_per_s, ".speed");
    if (given.law) {
      take(given.law->reference, ActuatorKind::law, si::m_per_s, ".law.reference");
      a.F0 = given.law->F0;
      a.gain = given.law->gain;
    }
    a.mode = given.mode;
    a.lock_stiffness = given.lock_stiffness.value_or(0);
    a.lock_damping = given.lock_damping.value_or(0);
    a.force_limit = given.force_limit.value_or(a.force_limit);
    model.actuators.push_back(std::move(a));
  }
}

/// A reeving by its name or by its number from 1; guys by name.
std::optional<int> reeving_of(const std::string& text, const Model& model, const std::string& path,
                              Complaints& complaints) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || index_of(model.reevings, text)) {
    return named(model.reevings, text, "reeving", path, complaints);
  }
  if (number >= 1 && number <= static_cast<int>(model.reevings.size())) return number - 1;
  complaints.push_back({path, fmt::format("the reevings have the numbers 1 to {}", model.reevings.size())});
  return std::nullopt;
}

void add_tensioners(const Machine& machine, Model& model, Complaints& complaints) {
  for (std::size_t i = 0; i < machine.tensioners.size(); ++i) {
    const auto& given = machine.tensioners[i];
    const std::string path = fmt::format("tensioners[{}]", i);
    Tensioner t;
    const auto reeving = reeving_of(given.reeving, model, path + ".reeving", complaints);
    t.reeving = reeving.value_or(0);
    t.at_start = given.end == description::RopeEnd::start;
    auto change = signal_or_constant(given.change, si::m, model.signals, path + ".change", complaints);
    if (change) t.change = std::move(*change);
    if (at(t.change, 0).value != 0) complaints.push_back({path + ".change", "begins at 0 m"});
    if (reeving && model.reevings[*reeving].closed) {
      complaints.push_back({path + ".reeving", "an endless rope has no end to pull at; move its take-up"});
    }
    model.tensioners.push_back(std::move(t));
  }
}

}  // namespace

std::optional<Drive> drive_of(const std::optional<std::string>& speed, const std::optional<std::string>& torque,
                              const std::optional<std::string>& pull, const Array<Signal>& signals,
                              const std::string& path, Complaints& complaints) {
  struct Way {
    const char* key;
    const std::optional<std::string>* text;
    DriveKind kind;
    Unit unit;
  };
  const std::array<Way, 3> ways = {{{.key = "speed", .text = &speed, .kind = DriveKind::speed, .unit = si::m_per_s},
                                    {.key = "torque", .text = &torque, .kind = DriveKind::torque, .unit = si::N_m},
                                    {.key = "pull", .text = &pull, .kind = DriveKind::pull, .unit = si::N}}};
  std::optional<Drive> drive;
  int count = 0;
  for (const Way& way : ways) {
    if (!*way.text) continue;
    ++count;
    // statics does not depend on a speed: a deck without any signals may name the one that its motion will have
    const bool open = signals.empty() && way.kind == DriveKind::speed && !looks_like_quantity(**way.text);
    if (open)
      drive = Drive{
          .kind = way.kind, .signal = {.name = **way.text, .unit = way.unit, .law = std::nan("")}, .brake = false};
    if (open) continue;
    auto signal = signal_or_constant(**way.text, way.unit, signals, fmt::format("{}.{}", path, way.key), complaints);
    if (signal) drive = Drive{.kind = way.kind, .signal = std::move(*signal), .brake = false};
  }
  if (count > 1) complaints.push_back({path, "one of speed, torque and pull drives it"});
  return drive;
}

void add_body_motion(const Machine& machine, Model& model, Complaints& complaints) {
  for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
    const auto& given = machine.bodies[i];
    const std::string path = fmt::format("bodies.{}", given.name);
    add_inertia(given, model.bodies[i], path + ".inertia", complaints);
    if (given.motion) add_driven(given, model.bodies[i], model.signals, path + ".motion", complaints);
  }
}

void add_drives(const Machine& machine, Model& model, Complaints& complaints) {
  for (const auto& given : machine.drums) {
    Drum drum;
    drum.name = given.name;
    drum.core_radius = given.core_diameter / 2;
    drum.layer = given.layer.value_or(1);
    drum.inertia = given.inertia;
    drum.drag = given.drag;
    if (given.brake_torque) {
      drum.brake = Brake{.torque = *given.brake_torque, .delay = given.brake_delay, .rise = given.brake_rise};
    }
    drum.drive = drive_of(given, model.signals, complaints);
    model.drums.push_back(std::move(drum));
  }
  for (const auto& [list, rounds] :
       {std::pair{"sheaves", &machine.sheaves}, std::pair{"supports", &machine.supports}}) {
    for (const auto& given : *rounds) {
      if (given.drag > 0 && !(given.inertia.value_or(0) > 0)) {
        complaints.push_back(
            {fmt::format("{}.{}.drag", list, given.name), "needs the 'inertia' of what it holds back"});
      }
      if (!given.motor) continue;
      const std::string path = fmt::format("{}.{}.motor", list, given.name);
      const auto drive = drive_of(given.motor->speed, given.motor->torque, {}, model.signals, path, complaints);
      const Motor motor{.name = given.name, .drive = drive.value_or(Drive{}), .working_arc = given.motor->working_arc};
      if (motor.drive.kind == DriveKind::torque && given.diameter == 0) {
        complaints.push_back({path + ".torque", "a torque needs the sheave's 'diameter'"});
      }
      if (motor.working_arc && !given.friction) {
        complaints.push_back({path + ".working_arc", "needs the 'friction' of the sheave, by which the rope holds"});
      }
      model.motors.push_back(motor);
    }
  }
}

void add_motion(const Machine& machine, const Links& links, ModelFor use, Model& model, Complaints& complaints) {
  for (const auto& marker : machine.markers) {
    if (!index_of(machine.points, marker.name)) continue;
    complaints.push_back({fmt::format("markers.{}", marker.name), "there is a point of this name already"});
  }
  for (Reeving& rope : model.reevings) {
    for (Node& node : rope.nodes) {
      if (node.kind == NodeKind::contact || node.kind == NodeKind::drive)
        node.motor = index_of(model.motors, node.name);
    }
  }
  add_faces(machine, model, complaints);
  add_contacts(machine, links, model, complaints);
  add_actuators(machine, links, model, complaints);
  add_tensioners(machine, model, complaints);
  add_measures(machine, model, complaints);
  for (std::size_t i = 0; i < machine.observe.size(); ++i) {
    const auto here = machine.observe.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(machine.observe.begin(), here, *here) != here) {
      complaints.push_back({fmt::format("observe[{}]", i), fmt::format("'{}' stands here a second time", *here)});
      continue;
    }
    const std::string path = fmt::format("observe[{}]", i);
    const auto found = observable(machine.observe[i], model, path, complaints);
    if (!found) continue;
    if (found->name == time_name) complaints.push_back({path, time_name_taken});
    model.observed.push_back(*found);
  }
  if (machine.observe.empty() && use == ModelFor::motion) model.observed = usual_observables(model);
  observe_measures(model);
  for (std::size_t i = 0; i < machine.events.size(); ++i) {
    model.events.push_back(event_of(machine.events[i], model, fmt::format("events[{}]", i), complaints));
  }
}

}  // namespace taut::machine
