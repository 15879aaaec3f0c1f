#include "taut/study/deck/temperature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/links/beam_links.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut::study {
namespace {

const machine::description::Rope& rope_named(const machine::Machine& machine, const std::string& name) {
  const auto rope =
      std::find_if(machine.ropes.begin(), machine.ropes.end(), [&](const auto& one) { return one.name == name; });
  expects(rope != machine.ropes.end(), "a compiled machine names its ropes");
  return *rope;
}

std::optional<double> reference_of(const machine::Machine& machine, const machine::description::Rope& rope) {
  return rope.reference_temperature ? rope.reference_temperature : machine.temperature;
}

}  // namespace

void set_temperature(machine::Model& model, const machine::Machine& machine, double temperature) {
  const std::size_t guys = machine.reevings.size();
  expects(model.reevings.size() == guys + machine.guys.size(), "the model of this machine");
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const auto& rope = rope_named(machine, i < guys ? machine.reevings[i].rope : machine.guys[i - guys].rope);
    const auto reference = reference_of(machine, rope);
    if (reference) model.reevings[i].thermal_strain = rope.expansion * (temperature - *reference);
  }
  for (machine::Beam& beam : model.beams) {
    const auto given = std::find_if(machine.beams.begin(), machine.beams.end(),
                                    [&](const auto& one) { return one.name == beam.name; });
    expects(given != machine.beams.end(), "a compiled machine names its beams");
    const auto reference = machine::reference_of(machine, *given);
    if (!reference) continue;
    for (machine::BeamPiece& piece : beam.pieces) {
      piece.rod.thermal_strain = given->expansion * (temperature - *reference);
    }
  }
}

void keep_references(machine::Machine& machine, const std::optional<double>& before) {
  for (auto& beam : machine.beams) {
    if (!beam.reference_temperature) beam.reference_temperature = before;
  }
  for (auto& rope : machine.ropes) {
    if (!rope.reference_temperature) rope.reference_temperature = before;
  }
}

void require_references(const machine::Machine& machine, const std::string& path, std::vector<Complaint>& complaints) {
  for (const auto& rope : machine.ropes) {
    if (reference_of(machine, rope)) continue;
    complaints.push_back(
        {path, fmt::format("the length of rope '{}' holds at no temperature that is reported: give the "
                           "machine a 'temperature' or the rope a 'reference_temperature'",
                           rope.name)});
  }
  for (const auto& beam : machine.beams) {
    if (machine::reference_of(machine, beam)) continue;
    complaints.push_back(
        {path, fmt::format("the length of beam '{}' holds at no temperature that is reported: give the machine a "
                           "'temperature' or the beam a 'reference_temperature'",
                           beam.name)});
  }
}

std::string celsius(double kelvin) {
  const double shown = kelvin - zero_celsius;
  return fmt::format("{:.5g} degC", shown == 0 || std::abs(shown) < 1e-9 ? 0.0 : shown);
}

}  // namespace taut::study
