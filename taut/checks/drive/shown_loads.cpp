#include "taut/checks/drive/shown_loads.hpp"

#include <algorithm>
#include <utility>

namespace taut::checks {
namespace {

constexpr double same_pull = 1e-6;  ///< relative: of two answers of one machine
constexpr double same_spot = 0.01;  ///< of the machine: by so much its ropes stretch, and let its bodies sink

/// The loads alone.
std::vector<double> loads_of_machine(const machine::Model& model) {
  std::vector<double> all;
  for (const machine::Body& body : model.bodies) all.push_back(body.mass);
  for (const machine::Load& load : model.loads) all.insert(all.end(), load.force.begin(), load.force.end());
  for (const machine::Reeving& rope : model.reevings) {
    if (rope.given != machine::Given::length) all.push_back(rope.value);
    for (const machine::Node& node : rope.nodes) {
      if (node.kind == machine::NodeKind::load) all.insert(all.end(), {node.load.force, node.load.rate});
    }
  }
  return all;
}

bool is_same(const Situation& one, const Situation& other) {
  if (one.loads != other.loads) return false;
  if (one.places.empty() || other.places.empty()) return true;
  const double most = same_spot * std::max(one.extent, other.extent);
  return std::equal(one.places.begin(), one.places.end(), other.places.begin(), other.places.end(),
                    [&](const Vector3& a, const Vector3& b) { return (a - b).norm() <= most; });
}

}  // namespace

Situation situation_of(const machine::Model& model, Array<Vector3> places) {
  Situation made{.loads = loads_of_machine(model), .places = std::move(places), .extent = 0};
  Array<Vector3> all = made.places;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body == machine::ground) all.push_back(node.at.at);
    }
  }
  for (const Vector3& one : all) made.extent = std::max(made.extent, (one - all.front()).norm());
  return made;
}

Situation situation_of(const machine::Model& model) {
  Situation made{.loads = loads_of_machine(model), .places = {}, .extent = 0};
  // what changes in a motion is none of the loads at rest
  for (const machine::Load& load : model.loads) {
    if (load.over_time) made.loads.push_back(0);
  }
  return made;
}

void ShownLoads::show(const std::string& part, const Situation& situation, double borne) {
  Shown& own = shown_[part];
  own.most = std::max(own.most, borne);
  const bool known = std::any_of(own.situations.begin(), own.situations.end(),
                                 [&](const Situation& one) { return is_same(one, situation); });
  if (!known) own.situations.push_back(situation);
}

void ShownLoads::leave_out(const std::string& part, const Situation& situation, const BorneAtRest& borne, double holds,
                           const std::string& words) {
  first_.try_emplace(part, words);
  std::vector<LeftOut>& all = left_out_[part];
  const auto at = std::find_if(all.begin(), all.end(), [&](const LeftOut& one) {
    return one.holds == holds && one.situation.places.empty() == situation.places.empty() &&
           is_same(one.situation, situation);
  });
  if (at == all.end()) {
    all.push_back({.situation = situation, .borne = borne, .holds = holds, .words = words});
    return;
  }
  at->borne.least = std::max(at->borne.least, borne.least);
  if (borne.most > at->borne.most) {
    at->borne.most = borne.most;
    at->words = words;
  }
}

std::map<std::string, ShownLoads::Missing> ShownLoads::missing() const {
  std::map<std::string, Missing> parts;
  for (const auto& [part, all] : left_out_) {
    const auto known = shown_.find(part);
    if (known == shown_.end()) {
      parts.emplace(part, Missing{.words = first_.at(part), .by_less = false});
      continue;
    }
    const std::vector<Situation>& shown = known->second.situations;
    double most = known->second.most;
    for (const LeftOut& one : all) {
      const bool same = std::any_of(shown.begin(), shown.end(),
                                    [&](const Situation& other) { return is_same(one.situation, other); });
      const bool as_shown = same && one.borne.least <= (1 + same_pull) * known->second.most;
      if (as_shown || one.borne.most <= (1 + same_pull) * most || one.borne.most <= one.holds) continue;
      most = one.borne.most;
      parts[part] = {.words = one.words};
    }
  }
  return parts;
}

}  // namespace taut::checks
