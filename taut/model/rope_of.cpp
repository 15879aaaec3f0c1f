#include "taut/model/rope_of.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/catalogue/rope_search.hpp"

namespace taut::model {
namespace {

/// For the message that asks for a stiffness: a common modulus of steel ropes on the metallic area.
constexpr double usual_modulus = 100e9;

RopeData rope_of(const description::Rope& given, const std::optional<double>& temperature,
                 std::vector<Complaint>& complaints) {
  RopeData rope;
  rope.name = given.name;
  const std::string path = fmt::format("ropes.{}", given.name);
  double area = 0;
  if (given.rope) {
    const auto row = catalogue::find_rope(*given.rope);
    if (!row) {
      complaints.push_back({path + ".rope", catalogue::to_text(row.error())});
      return rope;
    }
    rope.mass = row->mass_per_length;
    rope.breaking_force = row->breaking_force;
    rope.diameter = row->diameter;
    area = row->area;
  } else if (!given.mass) {
    complaints.push_back({path, "says neither a 'rope' of the catalogue nor its 'mass' per metre"});
  }
  if (!given.stiffness) {
    const std::string hint = area > 0 ? fmt::format("; its {:.4g} mm^2 with a modulus of 100 GPa make {:.3g} MN",
                                                    area * 1e6, area * usual_modulus / 1e6)
                                      : std::string{};
    complaints.push_back({path, fmt::format("lacks its 'stiffness', EA{}", hint)});
  }
  rope.mass = given.mass.value_or(rope.mass);
  rope.stiffness = given.stiffness.value_or(0);
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

std::vector<RopeData> ropes_of(const Machine& machine, std::vector<Complaint>& complaints) {
  std::vector<RopeData> all;
  all.reserve(machine.ropes.size());
  for (const auto& given : machine.ropes) all.push_back(rope_of(given, machine.temperature, complaints));
  return all;
}

}  // namespace taut::model
