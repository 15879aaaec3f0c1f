#include "taut/study/line/carriage_way.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/line/terrain_tops.hpp"

namespace taut::study {
namespace {

/// Where a node stands whatever the load: on the ground, on a body that is held, on a mast but for what it bends.
std::optional<Vector3> stays_at(const machine::Model& model, const machine::Node& node) {
  if (node.at.body == machine::ground) return node.at.at;
  const machine::Body& body = model.bodies[node.at.body];
  if (!body.free.empty() && !body.beam) return std::nullopt;
  return Vector3(body.position + body.orientation * node.at.at);
}

constexpr double beside = 0.01;       ///< m: farther from a support than where a carriage is on it
constexpr double half_carriage = 1;   ///< m: of a carriage that is a point; nearer to a support its length counts
constexpr double of_span = 0.1;       ///< or this share of the span beside it: on a short one no carriage is as long
constexpr double least_reach = 1e-6;  ///< m: of what has no radius

/// Around a support or guide, the coordinates along a way at which a carriage is on it.
struct Zone {
  const machine::Node* node = nullptr;
  double middle = 0, reach = 0;  ///< m
  double clear = 0;              ///< from the middle to where its round, or a carriage with a length, ends, m
  bool end = false;              ///< not passed
  bool point = false;            ///< the carriage is a point: its length is not known
  /// Where the place next to it at either side is, m along the way; of a point steps that are nearer are left out.
  double low = 0, high = 0;

  bool has(double x) const { return std::abs(middle - x) <= reach; }
  bool is_too_near(double x) const { return point && !end && !has(x) && low + beside < x && x < high - beside; }
};

/// Sets `low` and `high` of each by the spans beside it.
void set_places_beside(Array<Zone>& zones) {
  for (Zone& zone : zones) {
    double before = half_carriage, behind = half_carriage;
    for (const Zone& other : zones) {
      if (zone.has(other.middle)) continue;
      double& own = other.middle < zone.middle ? before : behind;
      own = std::min(own, of_span * std::abs(other.middle - zone.middle));
    }
    zone.low = zone.middle - zone.clear - (zone.point ? before : beside);
    zone.high = zone.middle + zone.clear + (zone.point ? behind : beside);
  }
}

/// How far the outer rollers are from the middle of a carriage, m.
double half_length(const machine::Model& model, const machine::Carriage& car) {
  double half = 0;
  for (int k = 0; k < car.rollers; ++k)
    half = std::max(half, std::abs(model.reevings[car.reeving].nodes[car.node + k].at.at.x()));
  return half;
}

Array<Zone> zones_of(const machine::Model& model, int carriage, const Vector3& along) {
  const machine::Carriage& car = model.carriages[carriage];
  const double half = half_length(model, car);
  Array<Zone> all;
  for (const machine::Node& node : model.reevings[car.reeving].nodes) {
    const auto place = stays_at(model, node);
    if (!place) continue;
    const bool end = node.kind == machine::NodeKind::anchor;
    all.push_back({.node = &node,
                   .middle = place->dot(along),
                   .reach = std::max(node.radius + half, least_reach),
                   .clear = node.radius + half,
                   .end = end,
                   .point = half == 0});
  }
  for (const machine::PlacedGuide& guide : machine::guides_ahead_of(model, carriage)) {
    all.push_back({.node = guide.node,
                   .middle = guide.place.dot(along),
                   .reach = std::max(guide.node->radius, least_reach),
                   .clear = guide.node->radius + half,
                   .end = false,
                   .point = half == 0});
  }
  set_places_beside(all);
  return all;
}

const machine::Node* zone_at(const Array<Zone>& zones, double x) {
  const auto zone = std::find_if(zones.begin(), zones.end(), [&](const Zone& one) { return one.has(x); });
  return zone == zones.end() ? nullptr : zone->node;
}

/// The places next to the supports between two positions, in the order of the way.
Array<double> places_beside(const Array<Zone>& zones, double from, double to) {
  Array<double> all;
  const auto [low, high] = std::minmax(from, to);
  for (const Zone& zone : zones) {
    if (zone.end) continue;
    for (const double x : {zone.low, zone.high}) {
      if (low < x && x < high && zone_at(zones, x) == nullptr) all.push_back(x);
    }
  }
  std::sort(all.begin(), all.end(), [&](double a, double b) { return to > from ? a < b : a > b; });
  const auto same = [](double a, double b) { return std::abs(a - b) < beside; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// Whether a step is nearer to a support than the place next to it. The ends of the way are asked for.
bool is_left_out(const Array<Zone>& zones, const Way& way, int i) {
  const double x = way.x(i);
  return i > 0 && i < way.steps && zone_at(zones, x) == nullptr &&
         std::any_of(zones.begin(), zones.end(), [&](const Zone& one) { return one.is_too_near(x); });
}

}  // namespace

const machine::Node* support_at(const machine::Model& model, int carriage, double x, const Vector3& along) {
  return zone_at(zones_of(model, carriage, along), x);
}

Array<WayPart> parts_of(const machine::Model& model, const Way& way) {
  const auto at = [&](double x) { return machine::with_carriage_at(model, way.carriage, x, way.along); };
  const auto same_span = [&](const machine::Model& a, const machine::Model& b) {
    return a.carriages[way.carriage].node == b.carriages[way.carriage].node && machine::same_guides(a, b);
  };
  const Array<Zone> zones = zones_of(model, way.carriage, way.along);
  const auto left_out = [&](int i) { return is_left_out(zones, way, i); };
  Array<WayPart> parts;
  for (int i = 0; i <= way.steps; ++i) {
    WayPart part{.model = at(way.x(i)), .first = i, .last = i, .support = zone_at(zones, way.x(i))};
    while (part.support == nullptr && part.last < way.steps && zone_at(zones, way.x(part.last + 1)) == nullptr &&
           !left_out(part.last + 1) && same_span(at(way.x(part.last + 1)), part.model)) {
      ++part.last;
    }
    i = part.last;
    parts.push_back(std::move(part));
    if (i == way.steps) break;
    const int before = i;
    while (left_out(i + 1)) ++i;
    for (const double x : places_beside(zones, way.x(before), way.x(i + 1)))
      parts.push_back({.model = at(x), .first = before, .last = before, .support = nullptr, .beside = x});
  }
  return parts;
}

std::optional<std::string> left_out_words(const machine::Model& model, const Way& way, const Display& display) {
  const Array<Zone> zones = zones_of(model, way.carriage, way.along);
  int places = 0;
  bool lost = false;
  std::set<std::pair<double, bool>> sides;  // of supports: the place next to one stands for one step
  for (int i = 0; i <= way.steps; ++i) {
    if (!is_left_out(zones, way, i)) continue;
    ++places;
    const double x = way.x(i);
    const auto zone = std::find_if(zones.begin(), zones.end(), [&](const Zone& one) { return one.is_too_near(x); });
    lost |= !sides.emplace(zone->middle, x < zone->middle).second;
  }
  if (!lost) return std::nullopt;
  return fmt::format(
      "{} of {} places are left out, as they are nearer to a support or guide than {} and a tenth of the span beside "
      "it, where the length of '{}' counts: give its 'rollers' and 'wheelbase'",
      places, way.steps + 1, display.brief(half_carriage, si::m), model.carriages[way.carriage].name);
}

LoadPathOptions path_over(const Way& way, const WayPart& part) {
  LoadPathOptions options;
  options.carriage = way.carriage;
  options.from = part.beside.value_or(way.x(part.first));
  options.to = part.beside.value_or(way.x(part.last));
  options.along = way.along;
  options.steps = std::max(1, part.last - part.first);
  return options;
}

void look_over_tops(const machine::Model& model, const Way& way, const WayPlace& from, const WayPlace& to,
                    const std::function<WayPlace(machine::Model, double x)>& look) {
  TopsBetween tops(model, from, to);
  while (const auto x = tops.next()) {
    if (support_at(model, way.carriage, *x, way.along) != nullptr) continue;
    tops.take(look(machine::with_carriage_at(model, way.carriage, *x, way.along), *x));
  }
}

Way way_of(std::optional<int> carriage, const std::vector<double>& along, const std::string& path, Names& names) {
  Way way;
  way.carriage = carriage.value_or(0);
  check_hold(names.model, carriage, names.complaints);
  way.along = direction_of(along, path + ".along", names.complaints);
  return way;
}

Vector3 direction_of(const Array<double>& along, const DeckPlace& path, std::vector<Complaint>& complaints) {
  if (along.size() == 2 && std::hypot(along[0], along[1]) > 0) return Vector3(along[0], along[1], 0).normalized();
  complaints.push_back({path.text(), "a horizontal direction [x, y] is expected, not zero"});
  return Vector3::UnitX();
}

void check_hold(const machine::Model& model, std::optional<int> carriage, std::vector<Complaint>& complaints) {
  if (!carriage) return;
  const machine::Carriage& car = model.carriages[*carriage];
  const auto rope = [&](int i) -> const machine::Reeving& { return model.reevings[i]; };
  const auto by_length = [&](std::optional<int> i) { return i && rope(*i).given == machine::Given::length; };
  if (!by_length(car.mainline) || !by_length(car.haulback) || car.grip) return;
  const std::string at = fmt::format("machine.carriages.{}.haulback", car.name);
  if (std::any_of(complaints.begin(), complaints.end(), [&](const auto& c) { return c.path == at; })) return;
  complaints.push_back(
      {at, fmt::format("an analysis puts '{}' somewhere: then give the pull of '{}' or of '{}', not the "
                       "lengths of both",
                       car.name, rope(*car.haulback).name, rope(*car.mainline).name)});
}

}  // namespace taut::study
