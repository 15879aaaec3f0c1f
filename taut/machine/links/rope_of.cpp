#include "taut/machine/links/rope_of.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/base/array.hpp"
#include "taut/catalogue/rope_words.hpp"

namespace taut::machine {
namespace {

RopeData rope_of(const description::Rope& given, const std::optional<double>& temperature,
                 std::vector<Complaint>& complaints) {
  RopeData rope;
  rope.name = given.name;
  const std::string path = fmt::format("ropes.{}", given.name);
  std::optional<catalogue::RopeStiffness> of_area;
  if (given.rope) {
    const auto row = catalogue::find_rope_in_words(*given.rope);
    if (!row) {
      complaints.push_back({path + ".rope", catalogue::to_text(row.error())});
      return rope;
    }
    rope.mass = row->mass_per_length;
    rope.breaking_force = row->breaking_force;
    rope.diameter = row->diameter;
    of_area = catalogue::stiffness_of(*row);
  } else if (!given.mass) {
    complaints.push_back({path, "says neither a 'rope' of the catalogue nor its 'mass' per metre"});
  }
  if (!given.stiffness && !of_area) {
    complaints.push_back({path, given.rope ? "lacks its 'stiffness', EA: no modulus is known for its construction"
                                           : "lacks its 'stiffness', EA (metallic area times modulus; .inf for an "
                                             "inextensible rope)"});
  }
  rope.mass = given.mass.value_or(rope.mass);
  rope.stiffness = given.stiffness.value_or(of_area ? of_area->EA : 0);
  rope.breaking_force = given.breaking_force.value_or(rope.breaking_force);
  rope.diameter = given.diameter.value_or(rope.diameter);
  if (given.damping_ratio && given.damping_time) {
    complaints.push_back({path + ".damping_time", "is given beside 'damping_ratio'; give one of the two"});
  }
  rope.damping_ratio = given.damping_ratio.value_or(0);
  rope.damping_time = given.damping_time.value_or(0);
  if (temperature && given.reference_temperature) {
    rope.thermal_strain = given.expansion * (*temperature - *given.reference_temperature);
  }
  return rope;
}

}  // namespace

std::optional<catalogue::RopeStiffness> catalogue_stiffness(const description::Rope& rope) {
  if (rope.stiffness || !rope.rope) return std::nullopt;
  const auto row = catalogue::find_rope_in_words(*rope.rope);
  return row ? catalogue::stiffness_of(*row) : std::nullopt;
}

Array<RopeData> ropes_of(const Machine& machine, std::vector<Complaint>& complaints) {
  Array<RopeData> all;
  all.reserve(machine.ropes.size());
  for (const auto& given : machine.ropes) all.push_back(rope_of(given, machine.temperature, complaints));
  return all;
}

}  // namespace taut::machine
