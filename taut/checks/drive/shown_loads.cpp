#include "taut/checks/drive/shown_loads.hpp"

#include <algorithm>

namespace taut::checks {
namespace {

constexpr double same_pull = 1e-6;  ///< relative: of two answers of one machine

}  // namespace

MachineLoads machine_loads(const machine::Model& model) {
  MachineLoads all;
  all.reserve(model.bodies.size() + 3 * model.loads.size());
  for (const machine::Body& body : model.bodies) all.push_back(body.mass);
  for (const machine::Load& load : model.loads) all.insert(all.end(), load.force.begin(), load.force.end());
  return all;
}

void ShownLoads::show(const std::string& part, const MachineLoads& loads, double borne) {
  Shown& own = shown_[part];
  own.loads.insert(loads);
  own.most = std::max(own.most, borne);
}

void ShownLoads::leave_out(const std::string& part, const MachineLoads& loads, const BorneAtRest& borne,
                           const std::string& words) {
  first_.try_emplace(part, words);
  const auto [at, is_new] =
      left_out_[part].try_emplace(loads, LeftOut{.borne = borne, .by_least = words, .by_most = words});
  if (is_new) return;
  LeftOut& one = at->second;
  if (borne.least > one.borne.least) {
    one.borne.least = borne.least;
    one.by_least = words;
  }
  if (borne.most > one.borne.most) {
    one.borne.most = borne.most;
    one.by_most = words;
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
    double most = known->second.most;
    for (const auto& [loads, one] : all) {
      const bool same = known->second.loads.contains(loads);
      const double asks = same ? one.borne.least : one.borne.most;
      if (asks <= (1 + same_pull) * most) continue;
      most = asks;
      parts[part] = {.words = same ? one.by_least : one.by_most};
    }
  }
  return parts;
}

}  // namespace taut::checks
