#include "taut/machine/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/base/suggest.hpp"
#include "taut/calc/field_check.hpp"
#include "taut/machine/compile/carriages.hpp"
#include "taut/machine/compile/compile_motion.hpp"
#include "taut/machine/compile/dragged.hpp"
#include "taut/machine/compile/drives.hpp"
#include "taut/machine/compile/drums.hpp"
#include "taut/machine/compile/given.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/machine/compile/over_ground.hpp"
#include "taut/machine/compile/path.hpp"
#include "taut/machine/compile/room.hpp"
#include "taut/machine/compile/rope_loads.hpp"
#include "taut/machine/compile/terrain.hpp"
#include "taut/machine/description/names.hpp"
#include "taut/machine/links/body_on.hpp"
#include "taut/machine/links/links.hpp"
#include "taut/machine/links/motion_links.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/machine/links/signals_of.hpp"
#include "taut/machine/rounds.hpp"
#include "taut/math/fixed_angles.hpp"

namespace taut::machine {
namespace {

Vector3 axis_of(const std::string& letter) {
  return letter == "x" ? Vector3::UnitX() : letter == "y" ? Vector3::UnitY() : Vector3::UnitZ();
}

template <class Named>
std::string hint_for(const Array<Named>& all, const std::string& name) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Named& one : all) names.push_back(one.name);
  const std::string hint = did_you_mean(name, names);
  return hint.empty() && !names.empty() && names.size() <= 12 ? fmt::format("; there is {}", fmt::join(names, ", "))
                                                              : hint;
}

class Compiler {
 public:
  Compiler(const Machine& machine, ModelFor use)
      : machine_(machine), use_(use), links_(machine, complaints_), ropes_(ropes_of(machine, complaints_)) {}

  tl::expected<Model, std::vector<Complaint>> run() {
    model_.gravity = machine_.gravity;
    model_.places = links_.places();
    model_.signals = signals_of(machine_, complaints_);
    add_bodies();
    add_body_motion(machine_, model_, complaints_);
    place_bodies_on_others(machine_, model_, complaints_);
    add_drives(machine_, model_, complaints_);
    for (const auto& given : machine_.carriages) model_.bodies.push_back(body_of(given));
    if (complaints_.empty()) {
      for (const StraightBeam& beam : links_.beams().in_order()) add_beam(model_, beam);
      warm_beams(model_);
    }
    check_axes();
    check_saddles();
    check_holds(machine_, complaints_);
    for (std::size_t i = 0; i < machine_.reevings.size(); ++i) add_reeving(machine_.reevings[i], i);
    for (const auto& guy : machine_.guys) add_guy(guy);
    check_names();
    check_held();
    for (std::size_t i = 0; i < machine_.carriages.size(); ++i)
      model_.carriages.push_back(carriage_of(machine_, i, model_.reevings, stops_, complaints_));
    if (complaints_.empty()) place_carriages(machine_, stops_, model_);
    check_drums(machine_, use_, complaints_);
    check_rope_loads(machine_, complaints_);
    if (complaints_.empty()) finish_nodes();
    check_guided_loads();
    if (complaints_.empty()) finish_drives(machine_, ropes_, model_);
    if (complaints_.empty()) add_rope_loads(machine_, model_, complaints_);
    if (complaints_.empty()) add_motion(machine_, links_, use_, model_, complaints_);
    add_loads();
    add_take_ups();
    if (complaints_.empty()) add_put_ups();
    if (machine_.terrain) machine::add_terrain(*machine_.terrain, links_, model_, complaints_);
    if (model_.reevings.empty() && machine_.beams.empty())
      complain("", "the machine has no rope: say 'reevings' or 'guys'");
    if (!complaints_.empty()) return tl::unexpected(complaints_);
    return std::move(model_);
  }

 private:
  void complain(std::string path, std::string message) { complaints_.push_back({std::move(path), std::move(message)}); }

  void add_bodies() {
    for (const auto& given : machine_.bodies) {
      const std::string path = fmt::format("bodies.{}", given.name);
      Body body;
      body.name = given.name;
      body.position = vector_of(given.at);
      body.mass = given.mass;
      body.centre = vector_of(given.centre);
      if (given.turned && given.motion) complain(path + ".turned", "a body with a 'motion' stands as that begins");
      if (given.turned) body.orientation = by_fixed_angles({given.turned->rx, given.turned->ry, given.turned->rz});
      add_freedoms(given, path, body);
      model_.bodies.push_back(std::move(body));
    }
  }

  void add_freedoms(const description::Body& given, const std::string& path, Body& body) {
    std::size_t rotations = 0;
    for (auto way = given.free.begin(); way != given.free.end(); ++way) {
      if (std::find(given.free.begin(), way, *way) != way) {
        complain(path + ".free", fmt::format("'{}' stands there twice", *way));
        continue;
      }
      const bool turns = way->front() == 'r';
      rotations += turns ? 1 : 0;
      body.free.push_back(turns ? Freedom{.along = Vector3::Zero(), .about = axis_of(way->substr(1))}
                                : Freedom{.along = axis_of(*way), .about = Vector3::Zero()});
    }
    if (rotations == 2) complain(path + ".free", "one rotation or all three; two depend on their order");
    if (!given.guide) return;
    const Vector3 guide = vector_of(*given.guide);
    if (guide.norm() == 0) complain(path + ".guide", "the direction is zero");
    if (rotations < body.free.size()) complain(path + ".guide", "a body on a guide has none of x, y, z in 'free'");
    if (guide.norm() > 0) body.free.push_back({guide.normalized(), Vector3::Zero()});
  }

  void check_held() {
    for (std::size_t i = 0; i < machine_.bodies.size(); ++i) {
      const bool held = std::any_of(stops_.begin(), stops_.end(), [&](const Array<Stop>& stops) {
        return std::any_of(stops.begin(), stops.end(),
                           [&](const Stop& stop) { return stop.node.at.body == static_cast<int>(i); });
      });
      // what lies on faces or hangs on a cylinder needs no rope
      const bool on_beam = links_.beams().hold(static_cast<int>(i));
      const bool otherwise = !machine_.contacts.empty() || !machine_.actuators.empty() || on_beam;
      if (held || otherwise || model_.bodies[i].free.empty()) continue;
      const std::string& name = machine_.bodies[i].name;
      complain(fmt::format("bodies.{}", name),
               !index_of(machine_.points, name)
                   ? "may move, but no rope runs to it"
                   : fmt::format("may move, but no rope runs to it: '{}' in a path is the point of that name", name));
    }
  }

  void check_axes() {
    const auto check = [&](const char* list, const std::string& name, const Triple& axis) {
      if (vector_of(axis).norm() == 0) complain(fmt::format("{}.{}.axis", list, name), "the axis is zero");
    };
    for (const auto& one : machine_.sheaves) check("sheaves", one.name, one.axis.value_or(Triple{0, 1, 0}));
    for (const auto& one : machine_.supports) check("supports", one.name, one.axis.value_or(Triple{0, 1, 0}));
    for (const auto& one : machine_.drums) check("drums", one.name, one.axis);
  }

  /// What belongs to a wheel would do nothing at a round that does not turn.
  void check_saddles() {
    const auto check = [&](const char* list, const description::Round& one, bool usual) {
      if (one.law != description::RoundLaw::saddle && (one.law != description::RoundLaw::usual || !usual)) return;
      const std::string path = fmt::format("{}.{}", list, one.name);
      const char* const words = "belongs to 'law: sheave'; a saddle does not turn: give its 'friction'";
      if (one.efficiency != 1) complain(path + ".efficiency", words);
      if (one.inertia) complain(path + ".inertia", words);
      if (one.drag != 0) complain(path + ".drag", words);
      if (one.motor) complain(path + ".motor", words);
    };
    for (const auto& one : machine_.sheaves) check("sheaves", one, false);
    for (const auto& one : machine_.supports) check("supports", one, true);
  }

  const RopeData* rope(const std::string& name, const std::string& path) {
    if (const auto i = index_of(ropes_, name)) return &ropes_[*i];
    complain(path, fmt::format("there is no rope '{}'{}", name, hint_for(ropes_, name)));
    return nullptr;
  }

  static void set_rope(Reeving& reeving, const RopeData& rope, double gravity) {
    reeving.weight = rope.mass * gravity;
    reeving.mass = rope.mass;
    reeving.stiffness = rope.stiffness;
    reeving.breaking_force = rope.breaking_force;
    reeving.diameter = rope.diameter;
    reeving.thermal_strain = rope.thermal_strain;
    reeving.damping_ratio = rope.damping_ratio;
    reeving.damping_time = rope.damping_time;
  }

  void add_reeving(const description::Reeving& given, std::size_t i) {
    const std::string path = fmt::format("reevings[{}]", i);
    Reeving reeving;
    reeving.name = name_of(given);
    if (reeving.name.find_first_not_of(" \t") == std::string::npos) complain(path + ".name", "is empty");
    reeving.copies = given.copies;
    reeving.closed = given.closed;
    reeving.segments = given.segments;
    const RopeData* data = rope(given.rope, path + ".rope");
    if (data != nullptr) set_rope(reeving, *data, machine_.gravity);
    rope_of_reeving_.push_back(data == nullptr ? RopeData{} : *data);
    const DescribedReeving described{.given = given, .rope = rope_of_reeving_.back(), .ropes = ropes_, .path = path};
    set_given(machine_, model_, described, reeving, complaints_);
    stops_.push_back(stops_of(machine_, links_, described, complaints_));
    model_.reevings.push_back(std::move(reeving));
  }

  void add_guy(const description::Guy& given) {
    const std::string path = fmt::format("guys.{}", given.name);
    const std::initializer_list<Thing> ends = {Thing::point, Thing::body, Thing::carriage, Thing::sheave};
    Reeving reeving;
    reeving.name = given.name;
    if (const RopeData* data = rope(given.rope, path + ".rope")) set_rope(reeving, *data, machine_.gravity);
    if (given.install) {
      const bool top = given.install->at == description::InstallAt::top;
      reeving.given = top ? Given::tension_at_start : Given::tension_at_end;
      reeving.value = given.install->tension;
      reeving.is_to_install = true;
    } else {
      reeving.value = given.length.value_or(0);
    }
    Array<Stop> stops;
    for (const auto& [key, name] : {std::pair{"from", given.from}, std::pair{"to", given.to}}) {
      const Target* t = links_.find(name, ends, fmt::format("{}.{}", path, key), complaints_);
      if (t == nullptr) continue;
      Stop stop;
      stop.node.name = name;
      stop.node.at = t->place;
      stops.push_back(std::move(stop));
    }
    stops_.push_back(std::move(stops));
    model_.reevings.push_back(std::move(reeving));
  }

  void check_names() {
    for (std::size_t i = 0; i < model_.reevings.size(); ++i) {
      if (index_of(model_.reevings, model_.reevings[i].name) == static_cast<int>(i)) continue;
      const bool is_guy = i >= machine_.reevings.size();
      complain(is_guy ? fmt::format("guys.{}", model_.reevings[i].name) : fmt::format("reevings[{}]", i),
               fmt::format("another rope is called '{}' too; give this one a{}", model_.reevings[i].name,
                           is_guy ? "nother name" : " 'name'"));
    }
    for (const description::Beam& beam : machine_.beams) {
      if (index_of(model_.reevings, beam.name)) complain(fmt::format("beams.{}", beam.name), "a rope is called so too");
    }
  }

  void finish_nodes() {
    for (std::size_t r = 0; r < stops_.size(); ++r) {
      Array<Stop>& stops = stops_[r];
      Array<Vector3> places;
      places.reserve(stops.size());
      for (const Stop& stop : stops) places.push_back(in_ground(model_, stop.node.at));
      const bool is_guy = r >= machine_.reevings.size();
      const bool closed = model_.reevings[r].closed;
      const DeckPlace list(is_guy ? "guys" : "reevings");
      const DeckPlace rope = is_guy ? DeckPlace(list, model_.reevings[r].name) : DeckPlace(list, r);
      const DeckPlace path = is_guy ? rope : DeckPlace(rope, "path");
      if (!check_apart(stops, places, closed, path, complaints_) || !complaints_.empty()) continue;
      set_axes(stops, places, closed);
      for (Stop& stop : stops) stop.axis = turned(model_, stop.node.at.body) * stop.node.axis;
      set_sides(stops, places, closed);
      model_.reevings[r].guides = guides_of(
          stops, places,
          {.first = static_cast<int>(machine_.bodies.size()), .count = static_cast<int>(machine_.carriages.size())},
          complaints_);
      check_room(model_, stops, closed, path, complaints_);
      set_clamps(stops, places, model_.reevings[r]);
      model_.reevings[r].nodes.reserve(stops.size());
      for (Stop& stop : stops) model_.reevings[r].nodes.push_back(std::move(stop.node));
      if (r < machine_.reevings.size() && machine_.reevings[r].install) set_straight(places, model_.reevings[r]);
    }
  }

  /// The free branches of a rope with guides change as the carriage passes them.
  void check_guided_loads() {
    for (std::size_t i = 0; i < machine_.rope_loads.size(); ++i) {
      const auto rope = index_of(model_.reevings, machine_.rope_loads[i].rope);
      if (!rope || model_.reevings[*rope].guides.empty()) continue;
      complain(fmt::format("rope_loads[{}].rope", i),
               fmt::format("'{}' has guides with 'holds', which change its spans: no force acts along it",
                           machine_.rope_loads[i].rope));
    }
  }

  static void set_straight(const Array<Vector3>& places, Reeving& reeving) {
    reeving.value = 0;
    for (std::size_t k = 1; k < places.size(); ++k) reeving.value += (places[k] - places[k - 1]).norm();
  }

  /// Clamps without a length stand at their share of the way, of an endless rope all the way round.
  static void set_clamps(Array<Stop>& stops, const Array<Vector3>& places, const Reeving& reeving) {
    double total = 0;
    Array<double> way = {0};
    for (std::size_t k = 1; k < places.size(); ++k) way.push_back(total += (places[k] - places[k - 1]).norm());
    if (reeving.closed && places.size() > 1) total += (places.front() - places.back()).norm();
    const double length = reeving.given == Given::length ? reeving.value : total;
    for (std::size_t k = 0; k < stops.size(); ++k) {
      Node& node = stops[k].node;
      if (node.kind == NodeKind::clamp && node.length_before == 0) node.length_before = length * way[k] / total;
    }
  }

  void add_loads() {
    for (std::size_t i = 0; i < machine_.loads.size(); ++i) {
      const description::Load& given = machine_.loads[i];
      check_name(given, i);
      const std::string path = fmt::format("loads[{}].at", i);
      const Target* t = links_.find(given.at, {Thing::body, Thing::carriage, Thing::point, Thing::sheave, Thing::drum},
                                    path, complaints_);
      if (t == nullptr) continue;
      if (t->place.body == ground) {
        complain(path, fmt::format("'{}' is fixed to the ground: a load there moves nothing; name a body", given.at));
        continue;
      }
      const double mass = given.mass.value_or(0);
      Vector3 force = given.force ? vector_of(*given.force) : Vector3(-mass * machine_.gravity * up());
      if (given.dragged) {
        const auto& along = given.dragged->along;
        const bool level = along.size() == 2 && std::hypot(along[0], along[1]) > 0;
        const std::string key = fmt::format("loads[{}].dragged", i);
        if (!level) complain(key + ".along", "a horizontal direction [x, y] is expected, not zero");
        if (given.force) complain(key, "belongs to a load with a 'mass'");
        if (level && !given.force) force = force_of(*given.dragged, mass, machine_.gravity);
      }
      const bool hangs = !given.force && !given.dragged;  // a bunch that drags acts by its force alone
      model_.loads.push_back({t->place, force, hangs ? mass : 0});
      if (given.signal) add_signal(given, fmt::format("loads[{}].signal", i), model_.loads.back());
    }
  }

  void add_signal(const description::Load& given, const std::string& path, Load& load) {
    if (!given.force || load.force == Vector3::Zero()) {
      complain(path, "needs a 'force' beside it that is not zero, for its direction and for what is at rest");
      return;
    }
    load.over_time = signal_or_constant(*given.signal, si::N, model_.signals, path, complaints_);
  }

  /// A load's name is its own: paths and `with` find it by that.
  void check_name(const description::Load& load, std::size_t i) {
    if (!load.name) return;
    const auto earlier = machine_.loads.begin() + static_cast<std::ptrdiff_t>(i);
    const bool twice =
        std::any_of(machine_.loads.begin(), earlier, [&](const auto& one) { return one.name == load.name; });
    const bool other = index_of(machine_.bodies, *load.name) || index_of(machine_.carriages, *load.name);
    if (!twice && !other) return;
    complain(fmt::format("loads[{}].name", i),
             fmt::format("another {} is called '{}'", twice ? "load" : "body or carriage", *load.name));
  }

  void add_put_ups() {
    for (std::size_t i = 0; i < machine_.reevings.size(); ++i) {
      const auto& given = machine_.reevings[i].install;
      if (!given) continue;
      PutUp& put_up = model_.reevings[i].put_up.emplace();
      put_up.tension = given->tension;
      put_up.at_end = given->at == description::BaseTensionAt::end;
      const std::string path = fmt::format("reevings[{}].install.with", i);
      Array<int> loads;
      for (const std::string& name : given->with) {
        const auto load = std::find_if(machine_.loads.begin(), machine_.loads.end(),
                                       [&](const auto& one) { return one.name == name; });
        if (load != machine_.loads.end()) {
          put_up.loads.push_back(static_cast<int>(load - machine_.loads.begin()));
        } else if (const Target* t = links_.find(name, {Thing::body, Thing::carriage}, path, complaints_)) {
          put_up.bodies.push_back(t->place.body);
        }
      }
      for (const int load : put_up.loads) {
        const int body = model_.loads[load].at.body;
        if (std::find(put_up.bodies.begin(), put_up.bodies.end(), body) != put_up.bodies.end()) continue;
        complain(path, fmt::format("the load '{}' hangs on '{}': name that too",
                                   *machine_.loads[static_cast<std::size_t>(load)].name, model_.bodies[body].name));
      }
    }
  }

  void add_take_ups() {
    for (std::size_t i = 0; i < machine_.take_up.size(); ++i) {
      const description::TakeUp& given = machine_.take_up[i];
      const std::string path = fmt::format("take_up[{}]", i);
      const Target* t = links_.find(given.body, {Thing::body, Thing::carriage}, path + ".body", complaints_);
      const Vector3 along = vector_of(given.along);
      if (along.norm() == 0) complain(path + ".along", "the direction is zero");
      if (t == nullptr || along.norm() == 0) continue;
      if (given.weight && given.keeps != description::ScrewKeeps::unsaid) {
        complain(path + ".keeps", "belongs to a screw: a weight keeps its force");
        continue;
      }
      const double pull = given.screw.value_or(given.weight.value_or(0) * machine_.gravity);
      model_.loads.push_back({t->place, pull * along.normalized(), 0});
      model_.loads.back().tightens = true;
      if (t->place.body == ground) continue;
      Body& body = model_.bodies[t->place.body];
      if (given.keeps == description::ScrewKeeps::place) add_screw(body, t->place.body, path + ".screw");
      if (!given.weight || body.free.size() != 1) continue;
      const double share = along.normalized().dot(body.free.front().along);
      body.counterweight += *given.weight * share * share;
    }
  }

  void add_screw(const Body& body, int index, const std::string& path) {
    if (body.free.empty()) complain(path, fmt::format("'{}' can't move: a screw is set where its body may", body.name));
    if (body.free.size() > 1) {
      complain(path, fmt::format("a screw sets a body with one way to move, '{}' has {}: give it a 'guide'", body.name,
                                 body.free.size()));
    }
    model_.screws.push_back({.body = index, .load = static_cast<int>(model_.loads.size()) - 1});
  }

  const Machine& machine_;
  ModelFor use_;
  std::vector<Complaint> complaints_;
  Links links_;
  Array<RopeData> ropes_;
  Array<RopeData> rope_of_reeving_;
  Array<Array<Stop>> stops_;
  Model model_;
};

}  // namespace

tl::expected<Model, std::vector<Complaint>> compile(const Machine& machine, ModelFor use) {
  // What a deck was refused for as it was read counts for machines made and changed in programs as well; what is made
  // of such values would be a second mistake.
  if (std::vector<Complaint> broken = broken_fields(Machine::describe(), &machine); !broken.empty()) {
    for (Complaint& one : unknown_names(machine)) broken.push_back(std::move(one));
    return tl::unexpected(broken);
  }
  if (!has_places_over_ground(machine)) return Compiler(machine, use).run();
  Machine placed = machine;
  std::vector<Complaint> complaints;
  Array<PlaceOverGround> over_ground = stand_on_ground(placed, complaints);
  if (!complaints.empty()) {
    for (Complaint& one : unknown_names(machine)) complaints.push_back(std::move(one));
    return tl::unexpected(complaints);
  }
  auto model = Compiler(placed, use).run();
  if (model) model->over_ground = std::move(over_ground);
  return model;
}

}  // namespace taut::machine
