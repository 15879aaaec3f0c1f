#include "taut/machine/compile/over_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/number.hpp"
#include "taut/machine/compile/terrain.hpp"
#include "taut/machine/links/links.hpp"

namespace taut::machine {
namespace {

/// One struct of a description that may stand over the ground.
struct Standing {
  const char* list;
  const char* kind;
  const std::string& name;
  const std::optional<description::OverGround>& given;
  const std::optional<std::string>* body;  ///< to which it may belong; nullptr: always to the ground
  const char* body_key;
};

/// Calls `each(Standing, at)` for every part with a place, in the order of the lists. M: Machine or const Machine.
template <class M, class Each>
void each_place(M& m, const Each& each) {
  for (auto& one : m.points) each(Standing{"points", "point", one.name, one.over_ground, &one.body, "body"}, one.at);
  for (auto& one : m.markers) each(Standing{"markers", "marker", one.name, one.over_ground, &one.body, "body"}, one.at);
  for (auto& one : m.bodies) each(Standing{"bodies", "body", one.name, one.over_ground, &one.on, "on"}, one.at);
  for (auto& one : m.sheaves) each(Standing{"sheaves", "sheave", one.name, one.over_ground, &one.body, "body"}, one.at);
  for (auto& one : m.supports)
    each(Standing{"supports", "support", one.name, one.over_ground, &one.body, "body"}, one.at);
  for (auto& one : m.drums) each(Standing{"drums", "drum", one.name, one.over_ground, &one.body, "body"}, one.at);
  for (auto& one : m.carriages) each(Standing{"carriages", "carriage", one.name, one.over_ground, nullptr, ""}, one.at);
}

/// Height of the polyline at x; none outside.
std::optional<double> height_at(const Array<GroundPoint>& ground, double x) {
  const auto right =
      std::lower_bound(ground.begin(), ground.end(), x, [](const GroundPoint& p, double at) { return p.x < at; });
  if (right == ground.end() || (right == ground.begin() && right->x != x)) return std::nullopt;
  if (right->x == x) return right->z;
  const auto left = right - 1;
  return left->z + (right->z - left->z) * (x - left->x) / (right->x - left->x);
}

/// The terrain and its line; complains of points of `between` that stand over the ground.
Model terrain_of(const Machine& machine, std::vector<Complaint>& complaints) {
  Model model;
  if (!machine.terrain) return model;
  for (std::size_t i = 0; i < machine.terrain->between.size(); ++i) {
    const std::string& name = machine.terrain->between[i];
    const auto point = std::find_if(machine.points.begin(), machine.points.end(),
                                    [&](const description::Point& one) { return one.name == name; });
    if (point == machine.points.end() || !point->over_ground) continue;
    complaints.push_back({fmt::format("terrain.between[{}]", i),
                          fmt::format("'{}' is given by its height over this ground: give the point as [x, y, z], or "
                                      "the line by 'from' and 'along'",
                                      name)});
  }
  std::vector<Complaint> of_names;  // found again where the machine is compiled
  const Links links(machine, of_names);
  add_terrain(*machine.terrain, links, model, complaints);
  return model;
}

class Placer {
 public:
  Placer(const Machine& machine, std::vector<Complaint>& complaints)
      : asked_(machine.terrain.has_value()), complaints_(complaints), ground_(terrain_of(machine, complaints)) {}

  template <class At>
  void place(const Standing& one, At& at) {
    if (!one.given) return;
    const std::string path = fmt::format("{}.{}", one.list, one.name);
    if (one.body != nullptr && *one.body) {
      complaints_.push_back({fmt::format("{}.{}", path, one.body_key),
                             fmt::format("'{}' stands over the ground ('chainage'): leave '{}' away, or give its 'at' "
                                         "as [x, y, z] in the frame of '{}'",
                                         one.name, one.body_key, **one.body)});
      return;
    }
    const description::OverGround& given = *one.given;
    if (!asked_) {
      complaints_.push_back({path + ".at",
                             "a place by 'chainage' and 'over_ground' needs the ground: give the machine a 'terrain', "
                             "or the place as [x, y, z]"});
      return;
    }
    if (ground_.terrain.empty()) return;  // what is wrong with the terrain has been said
    const auto height = height_at(ground_.terrain, given.chainage);
    if (!height) {
      complaints_.push_back(
          {path + ".at.chainage",
           fmt::format("there is no terrain at {} m: it goes from {} m to {} m along its line; survey the "
                       "ground there, or choose a chainage within it",
                       place_number(given.chainage), place_number(ground_.terrain.front().x),
                       place_number(ground_.terrain.back().x))});
      return;
    }
    const Vector3& along = ground_.terrain_along;
    const Vector3 left = up().cross(along);
    const Vector3 xyz = in_plan_of(ground_.terrain_from) +
                        (given.chainage + given.over_ground * std::sin(given.lean)) * along + given.offset * left +
                        (*height + given.over_ground * std::cos(given.lean)) * up();
    at = Triple{xyz.x(), xyz.y(), xyz.z()};
    placed.push_back({.kind = one.kind,
                      .name = one.name,
                      .at = xyz,
                      .ground = *height,
                      .chainage = given.chainage,
                      .offset = given.offset,
                      .over_ground = given.over_ground,
                      .lean = given.lean});
  }

  Array<PlaceOverGround> placed;

 private:
  static Vector3 in_plan_of(const Vector3& v) { return {v.x(), v.y(), 0}; }

  bool asked_;
  std::vector<Complaint>& complaints_;
  Model ground_;
};

}  // namespace

bool has_places_over_ground(const Machine& machine) {
  bool any = false;
  each_place(machine, [&](const Standing& one, const auto&) { any = any || one.given.has_value(); });
  return any;
}

Array<PlaceOverGround> stand_on_ground(Machine& machine, std::vector<Complaint>& complaints) {
  Placer placer(machine, complaints);
  each_place(machine, [&](const Standing& one, auto& at) { placer.place(one, at); });
  return std::move(placer.placed);
}

}  // namespace taut::machine
