#include "taut/machine/links/beam_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"
#include "taut/machine/links/links.hpp"

namespace taut::machine {
namespace {

using description::BeamEnd;

constexpr std::string_view top_ending = ".top";
constexpr double at_an_end = 5e-4;  ///< of the length, as the least piece of a beam

std::string path_of(const std::string& beam, const char* key) { return fmt::format("beams.{}.{}", beam, key); }

/// Fills what does not depend on places.
StraightBeam straight(const Machine& machine, const description::Beam& given, std::vector<Complaint>& complaints) {
  StraightBeam b;
  b.name = given.name;
  b.section = section_of(given, machine.gravity, complaints);
  if (machine.temperature) {
    b.thermal_strain = given.expansion * (*machine.temperature - *reference_of(machine, given));
  }
  b.order = given.order == description::Order::first ? structure::BeamOrder::first : structure::BeamOrder::second;
  b.base = given.base == description::BeamBase::hinge ? BeamHold::hinged : BeamHold::clamped;
  b.elements = given.elements;
  if (given.imperfection) {
    b.bow = given.imperfection->bow.value_or(0);
    b.sway = given.imperfection->sway.value_or(0);
  }
  return b;
}

double size_across(const Vector3& v, const Vector3& way) {
  const Vector3 d = way.normalized();
  return (v - d * d.dot(v)).norm();
}

}  // namespace

std::optional<double> reference_of(const Machine& machine, const description::Beam& beam) {
  return beam.reference_temperature ? beam.reference_temperature : machine.temperature;
}

BeamPlans::BeamPlans(const Machine& machine, int first_body, std::vector<Complaint>& complaints) : machine_(machine) {
  for (const auto& given : machine.beams) {
    Plan& plan = plans_.emplace_back();
    plan.beam = straight(machine, given, complaints);
    const auto twin = [&](const auto& all) {
      return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == given.name; });
    };
    if (twin(machine.bodies) || twin(machine.carriages))
      complaints.push_back({fmt::format("beams.{}", given.name), "there is a body or carriage of this name already"});
  }
  // a beam on another one waits until that one is placed
  bool goes_on = true;
  Array<std::size_t> order;
  while (goes_on) {
    goes_on = false;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      if (plans_[i].placed || !locate(machine, i, complaints)) continue;
      plans_[i].placed = goes_on = true;
      order.push_back(i);
    }
  }
  for (const Plan& plan : plans_) {
    if (plan.placed) continue;
    complaints.push_back({path_of(plan.beam.name, "from"), "beams stand on each other in a ring"});
  }
  add_stations(machine);
  for (const std::size_t i : order) {
    Plan& plan = plans_[i];
    if (!plan.valid) continue;
    plan.beam.stations = cuts_of(plan.beam, plan.way.norm());
    plan.first_body = first_body;
    first_body += static_cast<int>(plan.beam.stations.size()) + (plan.beam.top == BeamTop::free ? 1 : 0);
    plan.beam.from = place_of(plan.from);
    plan.beam.to =
        plan.beam.top == BeamTop::free ? Place{.body = ground, .at = plan.start + plan.way} : place_of(plan.to);
    built_.push_back(plan.beam);
  }
}

std::optional<int> BeamPlans::find(const std::string& name) const {
  const auto at = std::find_if(plans_.begin(), plans_.end(), [&](const Plan& p) { return p.beam.name == name; });
  return at == plans_.end() ? std::nullopt : std::optional(static_cast<int>(at - plans_.begin()));
}

BeamPlans::Spot BeamPlans::spot_on(const std::string& body, const Vector3& at) const {
  const bool top = body.size() > top_ending.size() && body.ends_with(top_ending);
  const auto beam = find(top ? body.substr(0, body.size() - top_ending.size()) : body);
  return {.body = ground, .beam = beam, .top = top && beam, .at = at};
}

std::optional<BeamPlans::Spot> BeamPlans::spot_of(const std::string& name) const {
  const auto body_of = [&](const std::string& body, const Vector3& at) -> std::optional<Spot> {
    for (std::size_t i = 0; i < machine_.bodies.size(); ++i) {
      if (machine_.bodies[i].name == body) return Spot{.body = static_cast<int>(i), .beam = {}, .top = false, .at = at};
    }
    Spot spot = spot_on(body, at);
    if (!spot.beam) return std::nullopt;
    return spot;
  };
  for (const auto& point : machine_.points) {
    if (point.name != name) continue;
    return point.body ? body_of(*point.body, vector_of(point.at))
                      : Spot{.body = ground, .beam = {}, .top = false, .at = vector_of(point.at)};
  }
  return body_of(name, Vector3::Zero());
}

std::optional<Vector3> BeamPlans::ground_of(const Spot& spot) const {
  if (!spot.beam) {
    if (spot.body == ground) return spot.at;
    return Vector3(vector_of(machine_.bodies[static_cast<std::size_t>(spot.body)].at) + spot.at);
  }
  const Plan& plan = plans_[*spot.beam];
  if (!plan.placed) return std::nullopt;
  return Vector3(plan.start + spot.at + (spot.top ? plan.way : Vector3(Vector3::Zero())));
}

/// False where it has to wait for another beam. Mistakes leave it invalid.
bool BeamPlans::locate(const Machine& machine, std::size_t i, std::vector<Complaint>& complaints) {
  const description::Beam& given = machine.beams[i];
  Plan& plan = plans_[i];
  const auto from = spot_of(given.from), to = spot_of(given.to);
  const auto missing = [&](const char* key, const std::string& name) {
    std::vector<std::string> names;
    names.reserve(machine.points.size() + machine.bodies.size());
    for (const auto& point : machine.points) names.push_back(point.name);
    for (const auto& body : machine.bodies) names.push_back(body.name);
    complaints.push_back({path_of(given.name, key), fmt::format("there is no point, body or beam's top '{}'{}", name,
                                                                did_you_mean(name, names))});
  };
  if (!from) missing("from", given.from);
  if (!to) missing("to", given.to);
  if (!from || !to) return true;
  const auto own = static_cast<int>(i);
  if (from->beam == own || to->beam == own) {
    complaints.push_back({path_of(given.name, from->beam == own ? "from" : "to"), "is a place on the beam itself"});
    return true;
  }
  const auto start = ground_of(*from), end = ground_of(*to);
  if (!start || !end) return false;
  plan.from = *from;
  plan.to = *to;
  plan.start = *start;
  plan.way = *end - *start;
  if (plan.way.norm() == 0) {
    complaints.push_back({path_of(given.name, "to"), "is the same place as 'from'"});
    return true;
  }
  const bool on_ground = to->body == ground && !to->beam;
  plan.beam.top = given.top == BeamEnd::clamped || (given.top == BeamEnd::usual && !on_ground) ? BeamTop::clamped
                  : given.top == BeamEnd::hinge                                                ? BeamTop::hinged
                                                                                               : BeamTop::free;
  if (given.top == BeamEnd::free && !on_ground) {
    complaints.push_back({path_of(given.name, "top"),
                          fmt::format("'{}' belongs to a body; a free top begins at a point of the ground", given.to)});
  }
  set_imperfection(given, plan, complaints);
  plan.valid = true;
  return true;
}

void BeamPlans::set_imperfection(const description::Beam& given, Plan& plan, std::vector<Complaint>& complaints) const {
  const Vector3 direction = plan.way.normalized();
  const bool upright = std::abs(direction.z()) > 0.7;
  plan.beam.strong = given.strong ? vector_of(*given.strong) : upright ? Vector3::UnitX() : Vector3::UnitZ();
  const auto lies_along = [&](const Vector3& v) { return !(size_across(v, plan.way) > 1e-6 * v.norm()); };
  if (given.strong && lies_along(plan.beam.strong))
    complaints.push_back({path_of(given.name, "strong"), "has no part across the beam"});
  plan.beam.sense = plan.beam.strong;
  if (!given.imperfection) return;
  if (given.imperfection->towards) {
    plan.beam.sense = vector_of(*given.imperfection->towards);
    if (lies_along(plan.beam.sense))
      complaints.push_back({path_of(given.name, "imperfection.towards"), "has no part across the beam"});
  }
  if (given.imperfection->sway && plan.beam.top != BeamTop::free) {
    complaints.push_back({path_of(given.name, "imperfection.sway"), "belongs to a beam with a free top"});
  }
}

void BeamPlans::add_stations(const Machine& machine) {
  const auto add = [&](const auto& all) {
    for (const auto& one : all) {
      if (one.body) add_station(*one.body, vector_of(one.at));
    }
  };
  add(machine.points);
  add(machine.markers);
  add(machine.sheaves);
  add(machine.supports);
  add(machine.drums);
}

void BeamPlans::add_station(const std::string& body, const Vector3& at) {
  const Spot spot = spot_on(body, at);
  if (!spot.beam || spot.top) return;
  Plan& plan = plans_[*spot.beam];
  if (plan.valid) plan.beam.stations.push_back(at.dot(plan.way) / plan.way.squaredNorm());
}

bool BeamPlans::knows(const std::string& body) const { return spot_on(body, Vector3::Zero()).beam.has_value(); }

Place BeamPlans::place(const std::string& body, const Vector3& at) const { return place_of(spot_on(body, at)); }

Place BeamPlans::place_of(const Spot& spot) const {
  if (!spot.beam) return {.body = spot.body, .at = spot.at};
  const Plan& plan = plans_[*spot.beam];
  if (!plan.valid) return {};
  const Vector3 at = spot.top ? Vector3(plan.way + spot.at) : spot.at;
  const double share = spot.top ? 1 : at.dot(plan.way) / plan.way.squaredNorm();
  if (share <= at_an_end) {
    Place base = place_of(plan.from);
    base.at += at;
    return base;
  }
  const auto cuts = static_cast<int>(plan.beam.stations.size());
  if (share >= 1 - at_an_end) {
    if (plan.beam.top == BeamTop::free) return {.body = plan.first_body + cuts, .at = at - plan.way};
    Place end = place_of(plan.to);
    end.at += at - plan.way;
    return end;
  }
  const auto nearest = std::min_element(plan.beam.stations.begin(), plan.beam.stations.end(),
                                        [&](double a, double b) { return std::abs(a - share) < std::abs(b - share); });
  return {.body = plan.first_body + static_cast<int>(nearest - plan.beam.stations.begin()),
          .at = at - *nearest * plan.way};
}

bool BeamPlans::hold(int body) const {
  return std::any_of(built_.begin(), built_.end(),
                     [&](const StraightBeam& beam) { return beam.from.body == body || beam.to.body == body; });
}

Array<std::pair<std::string, int>> BeamPlans::tops() const {
  Array<std::pair<std::string, int>> all;
  for (const Plan& plan : plans_) {
    if (!plan.valid || plan.beam.top != BeamTop::free) continue;
    all.emplace_back(plan.beam.name + std::string(top_ending),
                     plan.first_body + static_cast<int>(plan.beam.stations.size()));
  }
  return all;
}

}  // namespace taut::machine
