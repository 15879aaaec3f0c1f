#include "taut/solve/running.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/array.hpp"
#include "taut/machine/senses.hpp"

namespace taut::solve {

int sign_of(Motion motion) {
  if (motion == Motion::at_rest) return 0;
  return motion == Motion::hoist || motion == Motion::in ? 1 : -1;
}

Array<Array<int>> flow_of(const machine::Model& model, const EquilibriumOptions& options) {
  Array<Array<int>> flow = options.flow;
  if (flow.empty()) {
    const machine::Senses in = machine::hauling_in(model, options.prescribed);
    flow = in.flow;
    for (std::size_t r = 0; r < flow.size(); ++r) {
      const int sense = in.follows[r] && !options.each_to_its_winch ? -1 : 1;
      for (int& node : flow[r]) node *= sense * sign_of(options.motion);
    }
  }
  if (!options.creep_without_loss) return flow;
  const Array<Array<int>> creep = creep_of(model, options);
  for (std::size_t r = 0; r < creep.size(); ++r) {
    for (std::size_t n = 0; n < creep[r].size(); ++n) {
      if (creep[r][n] != 0) flow[r][n] = 0;
    }
  }
  return flow;
}

Array<Array<int>> creep_of(const machine::Model& model, const EquilibriumOptions& options) {
  if (!options.creep.empty() || !options.flow.empty() || options.motion == Motion::at_rest) return options.creep;
  return machine::hauling_in(model, options.prescribed).creep;
}

double centrifugal(const machine::Reeving& rope, const Array<int>& flow) {
  const bool runs = std::any_of(flow.begin(), flow.end(), [](int f) { return f != 0; });
  return runs ? rope.mass * rope.speed * rope.speed : 0;
}

tl::expected<machine::Model, std::string> running(const machine::Model& model, const Array<Array<int>>& flow) {
  machine::Model moving = model;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    machine::Reeving& rope = moving.reevings[r];
    const double c = centrifugal(rope, flow[r]);
    if (c == 0) continue;
    rope.thermal_strain = (1 + rope.thermal_strain) * (1 + c / rope.stiffness) - 1;
    rope.stiffness += c;
    bool above = true;
    const auto lower = [&](machine::Given given, double& value) {
      if (given != machine::Given::tension_at_start && given != machine::Given::tension_at_end) return;
      value -= c;
      above = above && value > 0;
    };
    lower(rope.given, rope.value);
    if (rope.also) lower(rope.also->first, rope.also->second);
    if (above) continue;
    return tl::unexpected(fmt::format(
        "rope '{}' lifts off: its given tension is not above the centrifugal tension of {:.4g} N at {:.4g} m/s; pull "
        "harder or run slower",
        rope.name, c, rope.speed));
  }
  return moving;
}

void add_centrifugal(const machine::Model& model, const Array<Array<int>>& flow, EquilibriumResult& result) {
  Array<double> c;
  c.reserve(model.reevings.size());
  for (std::size_t r = 0; r < model.reevings.size(); ++r) c.push_back(centrifugal(model.reevings[r], flow[r]));
  for (BranchResult& branch : result.branches) {
    if (branch.slack) continue;
    for (double* T :
         {&branch.T_from, &branch.T_to, &branch.T_from_min, &branch.T_from_max, &branch.T_to_min, &branch.T_to_max}) {
      *T += c[branch.reeving];
    }
  }
  for (ContactResult& one : result.contacts) {
    if (one.state == ContactState::lifted) continue;
    for (double* T : {&one.T_in, &one.T_out, &one.T_in_min, &one.T_in_max, &one.T_out_min, &one.T_out_max}) {
      *T += c[one.reeving];
    }
  }
  for (RopeLoadResult& one : result.rope_loads) {
    one.T_in += c[one.reeving];
    one.T_out += c[one.reeving];
  }
  for (std::size_t r = 0; r < result.ropes.size(); ++r) {
    RopeResult& rope = result.ropes[r];
    if (rope.T_max <= 0 || c[r] == 0) continue;
    rope.T_max += c[r];
    if (model.reevings[r].breaking_force > 0) rope.safety_factor = model.reevings[r].breaking_force / rope.T_max;
  }
}

machine::Model with_loads_held(machine::Model model) {
  for (machine::Reeving& rope : model.reevings) {
    for (machine::Node& node : rope.nodes) {
      if (node.kind != machine::NodeKind::load || !node.load.by_motion) continue;
      node.load.by_motion = false;
      node.load.sense *= rope.haul;
    }
  }
  return model;
}

}  // namespace taut::solve
