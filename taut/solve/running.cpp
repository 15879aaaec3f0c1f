#include "taut/solve/running.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/machine/senses.hpp"
#include "taut/solve/rest/hauled.hpp"

namespace taut::solve {
namespace {

/// Unstretched rope between two nodes of its path, m, without the arcs at them.
double between(const EquilibriumResult& e, int reeving, int first, int last) {
  double length = 0;
  for (const auto& s : e.branches) {
    if (s.reeving == reeving && s.from >= first && s.from < last) length += s.unstretched;
  }
  for (const auto& c : e.contacts) {
    if (c.reeving == reeving && c.node > first && c.node < last) length += c.unstretched;
  }
  return length;
}

/// Where a rope comes onto a round, or leaves it: its place from the centre and the way of its path, both in the frame
/// of the round's body.
struct Tangent {
  Vector3 arm, along;
  double tension = 0;
};

std::optional<Tangent> tangent_of(const EquilibriumResult& e, int reeving, int node, const machine::Node& round,
                                  bool leaves) {
  for (const BranchResult& s : e.branches) {
    if (s.reeving != reeving || (leaves ? s.from : s.to) != node) continue;
    Tangent t{.arm = leaves ? s.start : s.end, .along = s.end - s.start, .tension = leaves ? s.T_from : s.T_to};
    if (round.at.body != machine::ground) {
      const machine::Pose& body = e.state.bodies[round.at.body];
      t.arm = body.orientation.transpose() * (t.arm - body.position);
      t.along = body.orientation.transpose() * t.along;
    }
    t.arm -= round.at.at;
    return t;
  }
  return std::nullopt;
}

/// By how much the place moves along the path at which a rope comes onto a round, or leaves it: the arc between, m of
/// unstretched rope.
double moved(const std::optional<Tangent>& before, const std::optional<Tangent>& now, const machine::Reeving& rope,
             double radius) {
  if (!before || !now || radius == 0) return 0;
  const Vector3 way = now->arm - before->arm;
  const double arc = 2 * radius * std::asin(std::min(1.0, way.norm() / (2 * radius)));
  return std::copysign(arc, way.dot(before->along + now->along)) / (1 + now->tension / rope.stiffness);
}

}  // namespace

int sign_of(Motion motion) {
  if (motion == Motion::at_rest) return 0;
  return motion == Motion::hoist || motion == Motion::in ? 1 : -1;
}

Array<Array<int>> flow_of(const machine::Model& model, const EquilibriumOptions& options) {
  if (!options.flow.empty()) return options.flow;
  const machine::Senses in = machine::hauling_in(model, options.prescribed);
  Array<Array<int>> flow = in.flow;
  for (std::size_t r = 0; r < flow.size(); ++r) {
    for (int& node : flow[r]) node *= (in.follows[r] ? -1 : 1) * sign_of(options.motion);
  }
  return flow;
}

RopesRun ropes_run(const machine::Model& model, const EquilibriumOptions& options,
                   const std::optional<machine::State>& start) {
  RopesRun run{.flow = flow_of(model, options), .creep = options.creep};
  const bool by_word = options.flow.empty() && options.motion != Motion::at_rest;
  if (by_word && run.creep.empty()) run.creep = machine::hauling_in(model, options.prescribed).creep;
  if (options.creep_without_loss) {
    for (std::size_t r = 0; r < run.creep.size(); ++r) {
      for (std::size_t n = 0; n < run.creep[r].size(); ++n) {
        if (run.creep[r][n] != 0) run.flow[r][n] = 0;
      }
    }
  }
  if (by_word) set_by_winches(model, options, start, run);
  return run;
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

double passed(const machine::Model& model, const EquilibriumResult& before, const EquilibriumResult& now, int reeving,
              int node, int still) {
  const machine::Reeving& rope = model.reevings[reeving];
  const machine::Node& round = rope.nodes[node];
  const bool leaves = node < still;
  const auto at = [&](const EquilibriumResult& e) { return tangent_of(e, reeving, node, round, leaves); };
  const auto grown = [&](int first, int last) {
    return between(now, reeving, first, last) - between(before, reeving, first, last);
  };
  const double end = moved(at(before), at(now), rope, round.radius);
  return leaves ? grown(node, still) + end : end - grown(still, node);
}

}  // namespace taut::solve
