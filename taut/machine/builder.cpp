#include "taut/machine/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/compile.hpp"

namespace taut::machine {
namespace {

template <class All>
std::optional<int> index_named(const All& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? std::nullopt : std::optional<int>(static_cast<int>(found - all.begin()));
}

}  // namespace

description::PathElement anchor(const std::string& name) {
  description::PathElement stop;
  stop.anchor = name;
  return stop;
}

description::PathElement over(const std::string& name, description::Side side) {
  description::PathElement stop;
  stop.over = name;
  stop.side = side;
  return stop;
}

description::PathElement through(const std::string& carriage) {
  description::PathElement stop;
  stop.through = carriage;
  return stop;
}

description::PathElement on_drum(const std::string& name, description::Side side) {
  description::PathElement stop;
  stop.drum = name;
  stop.side = side;
  return stop;
}

description::PathElement falls(int count, const std::string& first, const std::string& second) {
  description::PathElement stop = over(first);
  stop.parts = count;
  stop.between = {first, second};
  return stop;
}

Known length(double metres) {
  return {.length = metres, .tension_at_start = std::nullopt, .tension_at_end = std::nullopt};
}
Known tension_at_start(double newtons) {
  return {.length = std::nullopt, .tension_at_start = newtons, .tension_at_end = std::nullopt};
}
Known tension_at_end(double newtons) {
  return {.length = std::nullopt, .tension_at_start = std::nullopt, .tension_at_end = newtons};
}

Builder& Builder::point(const std::string& name, const Triple& at) {
  machine_.points.push_back({name, std::nullopt, at});
  return *this;
}

Builder& Builder::rope(const std::string& name, const std::string& catalogue_id) {
  description::Rope& rope = machine_.ropes.emplace_back();
  rope.name = name;
  rope.rope = catalogue_id;
  return *this;
}

Builder& Builder::rope(const std::string& name, const RopeFigures& figures) {
  description::Rope& rope = machine_.ropes.emplace_back();
  rope.name = name;
  rope.mass = figures.mass;
  rope.stiffness = figures.stiffness;
  rope.breaking_force = figures.breaking_force;
  rope.diameter = figures.diameter;
  return *this;
}

Builder& Builder::body(const std::string& name, const Triple& at, double mass, const std::vector<std::string>& free) {
  description::Body& body = machine_.bodies.emplace_back();
  body.name = name;
  body.mass = mass;
  body.at = at;
  body.free = free;
  return *this;
}

Builder& Builder::sheave(const std::string& name, const Triple& at, double diameter, double efficiency,
                         const std::optional<std::string>& body) {
  description::Round& sheave = machine_.sheaves.emplace_back();
  sheave.name = name;
  sheave.body = body;
  sheave.at = at;
  sheave.diameter = diameter;
  sheave.efficiency = efficiency;
  return *this;
}

Builder& Builder::saddle(const std::string& name, const Triple& at, double friction, double diameter) {
  description::Round& saddle = machine_.supports.emplace_back();
  saddle.name = name;
  saddle.at = at;
  saddle.diameter = diameter;
  saddle.friction = friction;
  return *this;
}

Builder& Builder::drum(const std::string& name, const Triple& at, double core_diameter) {
  description::Drum& drum = machine_.drums.emplace_back();
  drum.name = name;
  drum.at = at;
  drum.core_diameter = core_diameter;
  return *this;
}

Builder& Builder::carriage(const std::string& name, double mass, const std::string& rides,
                           const std::optional<std::string>& mainline) {
  description::Carriage& carriage = machine_.carriages.emplace_back();
  carriage.name = name;
  carriage.mass = mass;
  carriage.rides = rides;
  carriage.mainline = mainline;
  return *this;
}

Builder& Builder::reeve(const std::string& rope, Array<description::PathElement> path, const Known& known) {
  description::Reeving& reeving = machine_.reevings.emplace_back();
  reeving.rope = rope;
  reeving.path = std::move(path);
  reeving.length = known.length;
  reeving.tension_at_start = known.tension_at_start;
  reeving.tension_at_end = known.tension_at_end;
  return *this;
}

Builder& Builder::load(const std::string& at, double mass) {
  description::Load& load = machine_.loads.emplace_back();
  load.at = at;
  load.mass = mass;
  return *this;
}

Builder& Builder::force(const std::string& at, const Triple& force) {
  description::Load& load = machine_.loads.emplace_back();
  load.at = at;
  load.force = force;
  return *this;
}

Builder& Builder::guy(const std::string& name, const std::string& rope, const std::string& from, const std::string& to,
                      double tension) {
  description::Guy& guy = machine_.guys.emplace_back();
  guy.name = name;
  guy.rope = rope;
  guy.from = from;
  guy.to = to;
  guy.install = description::Install{.tension = tension, .at = description::InstallAt::top};
  return *this;
}

Builder& Builder::drive(const std::string& drum, const std::string& speed) {
  const auto found = index_named(machine_.drums, drum);
  expects(found.has_value(), "a drum is driven that is there");
  description::Drive drive;
  drive.speed = speed;
  machine_.drums[static_cast<std::size_t>(*found)].drive = drive;
  return *this;
}

Builder& Builder::ground(Array<double> x, Array<double> z) {
  description::Terrain terrain;
  terrain.x = std::move(x);
  terrain.z = std::move(z);
  machine_.terrain = std::move(terrain);
  return *this;
}

tl::expected<Model, std::vector<Complaint>> Builder::model() const {
  std::vector<Complaint> complaints;
  for (const description::Carriage& car : machine_.carriages) {
    if (car.library && car.from_library.empty()) {
      complaints.push_back({fmt::format("carriages.{}.carriage", car.name),
                            "is taken from the catalogue by a deck alone: give the carriage its own figures"});
    }
  }
  if (machine_.terrain && machine_.terrain->file && machine_.terrain->x.empty())
    complaints.push_back({"terrain.file", "is read by a deck alone: give 'x' and 'z'"});
  if (!complaints.empty()) return tl::unexpected(std::move(complaints));
  return compile(machine_);
}

std::optional<int> reeving_named(const Model& model, const std::string& name) {
  return index_named(model.reevings, name);
}
std::optional<int> body_named(const Model& model, const std::string& name) { return index_named(model.bodies, name); }
std::optional<int> carriage_named(const Model& model, const std::string& name) {
  return index_named(model.carriages, name);
}

}  // namespace taut::machine
