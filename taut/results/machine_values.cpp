#include <fmt/format.h>

#include <algorithm>

#include "taut/machine/compile/guides.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/put_up.hpp"
#include "taut/solve/quantities.hpp"

namespace taut::results {
namespace {

bool wanted(const MachineRun& run, std::string_view name) { return !run.wants || run.wants(name); }

void add_places(const MachineRun& run, Result& r) {
  const auto first = std::find_if(run.equilibria.begin(), run.equilibria.end(),
                                  [](const study::EquilibriumRun& one) { return one.result.outcome.ok(); });
  if (first == run.equilibria.end()) return;
  for (std::size_t i = 0; i < run.model.bodies.size(); ++i) {
    const machine::Body& body = run.model.bodies[i];
    if ((body.free.empty() && !run.model.is_on_screw(static_cast<int>(i))) || body.of_rope || !is_listed(body) ||
        !wanted(run, body.name))
      continue;
    const solve::BodyRow row{.model = first->model, .at = first->result, .body = static_cast<int>(i)};
    for (const char* axis : {"x", "y", "z"}) {
      r.values.push_back(make_value(named(solve::body_quantities(), axis), row, body.name, "", first->words));
    }
  }
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const solve::RopeRow row{.model = first->model, .at = first->result, .reeving = static_cast<int>(i)};
    const std::string& name = run.model.reevings[i].name;
    if (!wanted(run, name + ".unstretched")) continue;
    r.values.push_back(make_value(named(solve::rope_quantities(), "unstretched"), row, name, "", first->words));
  }
}

/// Tensions at both ends of each rope, of every equilibrium.
void add_ends(const MachineRun& run, Result& r) {
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
      const machine::Reeving& rope = one.model.reevings[i];
      if (!wanted(run, rope.name)) continue;
      const solve::RopeRow row{.model = one.model, .at = one.result, .reeving = static_cast<int>(i)};
      for (const auto& q : solve::rope_end_tensions()) {
        if (!wanted(run, rope.name + "." + q.about.name)) continue;
        Value value = make_value(q, row, rope.name, one.ending, one.words);
        value.detail = true;
        if (!run.wants) {  // else numbers are wanted, by the thousand
          const int end = q.about.name == "T_start" ? solve::first_branch(one.result, row.reeving).from
                                                    : solve::last_branch(one.result, row.reeving).to;
          value.label = fmt::format("tension of {} at {} ({})", rope.name, rope.nodes[end].name, one.words);
          value.heading = heading_of(run, one);
        }
        r.values.push_back(std::move(value));
      }
    }
  }
}

}  // namespace

void add_values(const MachineRun& run, Result& r) {
  if (answers_of(run).empty()) return;
  add_places(run, r);
  add_ends(run, r);
  add_drive_values(run, r);
}

std::vector<std::string> assumptions_of(const machine::Machine& m, const Display& display) {
  std::vector<std::string> all = {
      "Ropes are elastic catenaries between tangent points, without bending stiffness; weight per unstretched length; "
      "the "
      "rope's weight on a sheave counts as length, not as load.",
      "Statics: losses act against the motion that the analysis names; at rest without loss, with the band between "
      "both "
      "directions where friction decides."};
  for (const auto& car : m.carriages) {
    std::string held =
        car.mainline ? fmt::format("held by {}", *car.mainline) : "held along its track where a place is prescribed";
    all.push_back(
        car.hold == machine::description::Hold::clamped
            ? fmt::format("Carriage {}: clamped to {}; tensions before and behind it differ.", car.name, car.rides)
            : fmt::format("Carriage {}: rolls on {} with {} tensions on both sides, {}; a point, its rollers' "
                          "radius and distance not counted.",
                          car.name, car.rides, car.friction > 0 ? "friction between the" : "equal", held));
  }
  for (const auto* rounds : {&m.sheaves, &m.supports}) {
    for (const auto& one : *rounds) {
      if (const auto car = machine::ahead_of(m, one)) {
        all.push_back(fmt::format(
            "Guide {}: in the path of its rope only ahead of {}; the rope's length is that along the path as it is "
            "then.",
            one.name, m.carriages[static_cast<std::size_t>(*car)].name));
      }
    }
  }
  for (const auto& drum : m.drums) {
    const bool thin = std::any_of(m.reevings.begin(), m.reevings.end(), [&](const auto& r) {
      const bool on = std::any_of(r.path.begin(), r.path.end(), [&](const auto& e) { return e.drum == drum.name; });
      const auto rope =
          std::find_if(m.ropes.begin(), m.ropes.end(), [&](const auto& one) { return one.name == r.rope; });
      return on && rope != m.ropes.end() && !rope->diameter && !rope->rope;
    });
    if (thin)
      all.push_back(
          fmt::format("Drum {}: its rope's diameter is not known; the rope lies on the core's radius.", drum.name));
  }
  const auto runs = [](const auto& one) { return one.motor && one.motor->speed; };
  if (std::any_of(m.sheaves.begin(), m.sheaves.end(), runs)) {
    all.emplace_back(
        "A rope with a speed carries the centrifugal tension m v^2 where the motion makes it run; supports, contact "
        "laws "
        "and its shape know the tension less that. At rest it stands.");
  }
  if (!m.rope_loads.empty()) {
    all.emplace_back(
        "Forces along a rope act at a share of the unstretched rope of their span; a rate is divided into equal point "
        "forces, each in the middle of its part.");
  }
  if (!m.guys.empty()) {
    all.emplace_back(
        "Guys are put up on the unloaded machine with its bodies held where they are given; then their "
        "lengths are kept.");
  }
  for (std::string& text : tension_assumptions(m, display)) all.push_back(std::move(text));
  for (std::string& text : beam_assumptions(m)) all.push_back(std::move(text));
  return all;
}

}  // namespace taut::results
