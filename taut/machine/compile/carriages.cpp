#include "taut/machine/compile/carriages.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "taut/base/array.hpp"
#include "taut/machine/links/motion_links.hpp"
#include "taut/machine/rounds.hpp"

namespace taut::machine {
namespace {

using description::Hold;

void complain(std::vector<Complaint>& complaints, std::string path, std::string message) {
  complaints.push_back({std::move(path), std::move(message)});
}

/// Where a rope passes a carriage.
struct Passes {
  int rolls = 0, grips = 0;  ///< how often
  int roller = 0, grip = 0;  ///< nodes: the first roller (or clamp), the grip
};

Passes passes_of(const Array<Stop>& stops, int carriage) {
  Passes passes;
  for (std::size_t n = 0; n < stops.size(); ++n) {
    const Stop& stop = stops[n];
    if (stop.carriage != carriage || stop.roller > 0) continue;
    (stop.grip ? passes.grip : passes.roller) = static_cast<int>(n);
    ++(stop.grip ? passes.grips : passes.rolls);
  }
  return passes;
}

std::string_view how_often(int times) { return times == 0 ? "past it" : "through it more than once"; }

/// Whether a rope is anchored to the body.
bool pulls(const Array<Stop>& stops, int body) {
  return !stops.empty() && (stops.front().node.at.body == body || stops.back().node.at.body == body);
}

/// The line between the neighbours of a carriage on its rope, and its own share of it.
struct Chord {
  Vector3 from, to;
  double share = 0;
};

Chord chord_of(const Model& model, const Array<Stop>& stops, const Carriage& car) {
  const auto node = static_cast<std::size_t>(car.node);
  const std::size_t size = stops.size();
  std::size_t before = node, after = node;
  while (before > 0 && stops[before].carriage) --before;
  // an endless rope comes back to its beginning
  while (after < size && stops[after].carriage) ++after;
  const double middle = static_cast<double>(node - before) + (car.rollers - 1) / 2.0;
  return {.from = in_ground(model, stops[before].node.at),
          .to = in_ground(model, stops[after % size].node.at),
          .share = middle / static_cast<double>(after - before)};
}

}  // namespace

bool pitches(const description::Carriage& carriage) { return carriage.rollers > 1 || carriage.height > 0; }

Body body_of(const description::Carriage& carriage) {
  Body body;
  body.name = carriage.name;
  body.mass = carriage.mass;
  body.inertia.setConstant(carriage.inertia);
  if (carriage.at) body.position = vector_of(*carriage.at);
  for (const Vector3& way : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())})
    body.free.push_back({way, Vector3::Zero()});
  if (pitches(carriage)) body.free.push_back({Vector3::Zero(), Vector3::UnitY()});
  return body;
}

void turn_along(Body& body, const Vector3& chord, int rollers) {
  for (Freedom& way : body.free) {
    if (way.about == Vector3::Zero()) continue;
    const Vector3 level(chord.x(), chord.y(), 0);
    const bool upright = level.norm() <= 1e-9 * chord.norm();
    const Vector3 along = upright ? Vector3(Vector3::UnitX()) : Vector3((rollers > 1 ? chord : level).normalized());
    way.about = upright ? Vector3(Vector3::UnitY()) : Vector3(up().cross(level.normalized()));
    body.orientation.col(0) = along;
    body.orientation.col(1) = way.about;
    body.orientation.col(2) = along.cross(way.about);
  }
}

Array<Stop> stops_of(const description::Carriage& car, int index, const Place& place, bool grips) {
  Stop stop;
  stop.carriage = index;
  stop.grip = grips;
  stop.node.name = car.name;
  stop.node.at = place;
  if (grips || car.hold == Hold::clamped) {
    stop.node.kind = NodeKind::clamp;
    stop.node.length_before = car.length_before.value_or(0);
    return {stop};
  }
  stop.node.kind = NodeKind::contact;
  // a carriage without rolling friction has equal tensions on both sides
  stop.node.law = car.friction > 0 ? ContactLaw{.friction = car.friction, .efficiency = 0} : ContactLaw{};
  stop.node.support = -up();
  Array<Stop> all;
  all.reserve(static_cast<std::size_t>(car.rollers));
  for (int i = 0; i < car.rollers; ++i) {
    stop.roller = i;
    // a rope sags away from rollers between the outer ones of a rigid carriage
    stop.node.may_lift = i > 0 && i + 1 < car.rollers;
    const double forward = car.rollers > 1 ? car.wheelbase.value_or(0) * (i / (car.rollers - 1.0) - 0.5) : 0;
    all.push_back(stop);
    all.back().node.at.at = place.at + Vector3(forward, 0, car.height);
    if (car.rollers > 1) all.back().node.name = fmt::format("{}.roller{}", car.name, i + 1);
  }
  return all;
}

void check(const description::Carriage& car, const std::string& path, std::vector<Complaint>& complaints) {
  const bool clamped = car.hold == Hold::clamped;
  if (car.length_before && !clamped && !car.fixed_to)
    complain(complaints, path + ".length_before", "belongs to a carriage with 'hold: clamped' or 'fixed_to'");
  if (car.hold == Hold::fixed_to && !car.fixed_to)
    complain(complaints, path + ".hold", "needs 'fixed_to', the reeving that carries the carriage along");
  if (clamped && car.friction > 0)
    complain(complaints, path + ".friction", "is of a carriage that rolls; a clamped one does not");
  if (clamped && car.fixed_to) complain(complaints, path + ".fixed_to", "the carriage is clamped to its own rope");
  if (clamped && pitches(car))
    complain(complaints, path + (car.rollers > 1 ? ".rollers" : ".height"),
             "a clamped carriage is a point on its rope");
  if (car.rollers > 1 && !car.wheelbase) complain(complaints, path + ".rollers", "several rollers need a 'wheelbase'");
  const auto& ropes = car.rope_diameters;
  if (!ropes.empty() && (ropes.size() != 2 || ropes[0] > ropes[1]))
    complain(complaints, path + ".rope_diameters", "are the least and the largest, in this order: [16 mm, 22 mm]");
  if (car.rollers == 1 && car.wheelbase) complain(complaints, path + ".wheelbase", "needs 'rollers: 2' or more");
}

void check_rides(const description::Carriage& given, const std::string& path, const Passes& passes,
                 std::vector<Complaint>& complaints) {
  if (passes.rolls == 1) return;
  complain(complaints, path,
           fmt::format("the path of the rope it rides on goes {}: write '{{through: {}}}' in it once",
                       how_often(passes.rolls), given.name));
}

/// The rope to which a carriage is fixed, and whether it also rides on it.
struct Gripped {
  const std::string& rope;
  bool rides;
};

void check_grips(const description::Carriage& given, const std::string& path, const Passes& passes, const Gripped& on,
                 std::vector<Complaint>& complaints) {
  if (passes.grips == 1) return;
  complain(complaints, path + ".fixed_to",
           fmt::format("the path of '{}' goes {}: write '{{through: {}{}}}' in it once", on.rope,
                       how_often(passes.grips), given.name, on.rides ? ", grip: true" : ""));
}

Carriage carriage_of(const Machine& machine, std::size_t index, const Array<Reeving>& reevings,
                     const Array<Array<Stop>>& stops, std::vector<Complaint>& complaints) {
  const description::Carriage& given = machine.carriages[index];
  const std::string path = fmt::format("carriages.{}", given.name);
  const auto reeving = [&](const std::string& name, const char* key) {
    return named(reevings, name, "reeving", path + key, complaints);
  };
  Carriage car;
  car.name = given.name;
  car.body = static_cast<int>(machine.bodies.size() + index);
  car.rollers = given.rollers;
  car.mass = given.mass;
  car.rated_payload = given.rated_payload;
  const auto own = reeving(given.rides, ".rides");
  car.reeving = own.value_or(0);
  const auto fixed_to = given.fixed_to ? reeving(*given.fixed_to, ".fixed_to") : std::nullopt;
  if (fixed_to) car.grip = Grip{.reeving = *fixed_to};
  if (given.mainline) car.mainline = reeving(*given.mainline, ".mainline");
  if (given.haulback) car.haulback = reeving(*given.haulback, ".haulback");
  check(given, path, complaints);
  for (std::size_t r = 0; r < stops.size(); ++r) {
    const Passes passes = passes_of(stops[r], static_cast<int>(index));
    const bool rides = own == static_cast<int>(r), grips = car.grip && car.grip->reeving == static_cast<int>(r);
    if (rides) car.node = passes.roller;
    if (grips) car.grip->node = passes.grip;
    if (!rides && !grips && own && passes.rolls + passes.grips > 0) {
      complain(complaints, path,
               fmt::format("rides on '{}', but the path of '{}' goes through it", given.rides, reevings[r].name));
    }
    if (rides) check_rides(given, path, passes, complaints);
    if (grips) check_grips(given, path, passes, {.rope = reevings[r].name, .rides = rides}, complaints);
  }
  const auto check_end = [&](std::optional<int> rope, const char* key) {
    if (!rope || pulls(stops[*rope], car.body)) return;
    complain(complaints, path + key,
             fmt::format("the path of '{}' does not end at '{}'", reevings[*rope].name, given.name));
  };
  check_end(car.mainline, ".mainline");
  check_end(car.haulback, ".haulback");
  if (car.haulback && car.haulback == car.mainline)
    complain(complaints, path + ".haulback", "is its mainline already; name the rope that pulls the other way");
  return car;
}

void place_carriages(const Machine& machine, const Array<Array<Stop>>& stops, Model& model) {
  // twice: a carriage may hang between others
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < machine.carriages.size(); ++i) {
      const Carriage& car = model.carriages[i];
      const Chord chord = chord_of(model, stops[car.reeving], car);
      Body& body = model.bodies[car.body];
      turn_along(body, chord.to - chord.from, car.rollers);
      if (machine.carriages[i].at) continue;
      body.position = chord.from + chord.share * (chord.to - chord.from);
      if (pitches(machine.carriages[i])) body.position -= machine.carriages[i].height * body.orientation.col(2);
    }
  }
}

}  // namespace taut::machine
