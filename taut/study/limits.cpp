#include "taut/study/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/solve/drives.hpp"
#include "taut/study/line/bend_onto.hpp"
#include "taut/study/load_path.hpp"

namespace taut::study {
namespace {

/// Heights by the size of what they are measured against, so that one tolerance serves all limits.
double length_margin(double left, double height) { return left / std::max(1.0, std::abs(height)); }

/// The pull of the winch at an end of a rope. Ropes that are wound the other way relieve it; that does not count.
LimitState pull_at(const machine::Model& model, const solve::EquilibriumResult& r,
                   const Array<solve::DrumResult>& drums, const EndLimit& end) {
  const int last = static_cast<int>(model.reevings[end.reeving].nodes.size()) - 1;
  LimitState state{.kind = LimitKind::pull,
                   .reeving = end.reeving,
                   .node = end.at_end ? last : 0,
                   .value = solve::largest_at_end(model, r, end.reeving, end.at_end),
                   .limit = end.pull};
  const auto is_own = [&](const solve::DrumResult& d) { return d.reeving == end.reeving && d.at_end == end.at_end; };
  const auto own = std::find_if(drums.begin(), drums.end(), is_own);
  for (const solve::DrumResult& d : drums) {
    if (own == drums.end() || is_own(d) || d.drum != own->drum || d.sense != own->sense) continue;
    state.value += solve::largest_at_end(model, r, d.reeving, d.at_end);
  }
  state.margin = 1 - state.value / end.pull;
  return state;
}

/// The ropes at the drum of that end, in words.
std::string ropes_at(const machine::Model& model, int reeving, int node) {
  const std::optional<int> drum = model.reevings[reeving].nodes[node].drum;
  std::string all;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    const machine::Reeving& rope = model.reevings[r];
    const bool there = drum && (rope.nodes.front().drum == drum || rope.nodes.back().drum == drum);
    if (!there && static_cast<int>(r) != reeving) continue;
    all += fmt::format("{}'{}'", all.empty() ? "" : ", ", rope.name);
  }
  return all;
}

void add_supports(const machine::Model& model, const PayloadLimits& limits, const solve::EquilibriumResult& r,
                  Array<LimitState>& all) {
  for (const solve::ContactResult& c : r.contacts) {
    const machine::Node& node = model.reevings[c.reeving].nodes[c.node];
    // a carriage bends its rope by carrying; what stands on the ground or on a mast is a support
    const bool holds = node.support == Vector3::Zero();
    if (machine::rides(model, node) || (holds && !machine::is_saddle(node))) continue;
    const auto add = [&](LimitKind kind, double angle, double limit, double margin) {
      all.push_back({kind, c.reeving, c.node, angle, limit, margin});
    };
    if (std::isfinite(limits.break_angle)) {
      const double angle = c.wrap > 0 ? c.turning : c.wrap;
      add(LimitKind::break_angle, angle, limits.break_angle, limits.break_angle - angle);
    }
    if (holds) continue;
    const double onto = bend_onto(model, r, c);
    if (std::isfinite(limits.least_break_angle)) {
      add(LimitKind::least_break_angle, onto, limits.least_break_angle, onto - limits.least_break_angle);
    }
    if (limits.lift_off) add(LimitKind::lift_off, onto, 0, c.state == solve::ContactState::lifted ? -1 : onto);
  }
}

/// What other ropes load on a carriage, in kilograms: what hangs on them, and those that pull it down to what stands.
double hung_load(const machine::Model& model, const machine::Carriage& car, const solve::EquilibriumResult& r) {
  double pull = 0;
  for (const solve::BranchResult& branch : r.branches) {
    const bool down = holds_down(model, car, branch.reeving, branch.from, branch.to);
    if (!down && !hung_on(model, car, branch.reeving, branch.from, branch.to)) continue;
    const machine::Reeving& rope = model.reevings[branch.reeving];
    const bool starts_there = rope.nodes[branch.from].at.body == car.body;
    const Vector3 force = starts_there ? rope::force_on_start(branch.shape) : rope::force_on_end(branch.shape);
    pull += rope.copies * (down ? std::max(0.0, -force.z()) : -force.z());
  }
  return model.gravity > 0 ? pull / model.gravity : 0;
}

/// Of one answer, without its bounds.
Array<LimitState> own_limits(const machine::Model& model, int body, const PayloadLimits& limits,
                             const solve::EquilibriumResult& r, double payload) {
  Array<LimitState> all;
  if (!r.outcome.ok()) {
    all.push_back({.kind = LimitKind::none, .margin = -1, .fails = true});
    return all;
  }
  for (std::size_t k = 0; k < limits.tension.size(); ++k) {
    if (!std::isfinite(limits.tension[k])) continue;
    const double T = r.ropes[k].T_max;
    all.push_back({LimitKind::tension, static_cast<int>(k), {}, T, limits.tension[k], 1 - T / limits.tension[k]});
  }
  const Array<solve::DrumResult> drums = limits.ends.empty() ? Array<solve::DrumResult>() : solve::drums(model, r);
  for (const EndLimit& end : limits.ends) all.push_back(pull_at(model, r, drums, end));
  const Vector3& place = r.state.bodies[body].position;
  const double clearance = place.z() - ground_height(model.terrain, terrain_x(model, place));
  if (std::isfinite(limits.clearance) && std::isfinite(clearance)) {
    all.push_back({LimitKind::clearance,
                   {},
                   {},
                   clearance,
                   limits.clearance,
                   length_margin(clearance - limits.clearance, place.z())});
  }
  for (std::size_t k = 0; k < limits.rope_clearance.size(); ++k) {
    if (!std::isfinite(limits.rope_clearance[k])) continue;
    const double height = rope_clearance(model, r.branches, static_cast<int>(k), limits.rope_between).height;
    if (!std::isfinite(height)) continue;
    all.push_back({LimitKind::rope_clearance,
                   static_cast<int>(k),
                   {},
                   height,
                   limits.rope_clearance[k],
                   length_margin(height - limits.rope_clearance[k], place.z())});
  }
  add_supports(model, limits, r, all);
  if (limits.rated_payload) {
    for (const machine::Carriage& car : model.carriages) {
      if (car.body != body) continue;
      const double load = load_on(model, car) + hung_load(model, car, r) + payload;
      all.push_back({.kind = LimitKind::rated_payload,
                     .value = load,
                     .limit = *limits.rated_payload,
                     .margin = 1 - load / *limits.rated_payload});
    }
  }
  return all;
}

}  // namespace

Array<LimitState> limits_at(const machine::Model& model, int body, const PayloadLimits& limits,
                            const solve::EquilibriumResult& r, double payload) {
  Array<LimitState> all = own_limits(model, body, limits, r, payload);
  for (const solve::EquilibriumResult& bound : r.bounds) {
    for (const LimitState& held : own_limits(model, body, limits, bound, payload)) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const LimitState& one) {
        return one.kind == held.kind && one.reeving == held.reeving && one.node == held.node;
      });
      if (same == all.end()) {
        all.push_back(held);
      } else if (held.margin < same->margin) {
        *same = held;
      }
    }
  }
  return all;
}

namespace {

/// Whether a rope draws a carriage along its line, or is the line.
bool draws_along(const machine::Carriage& carriage, int reeving) {
  const bool fixed = carriage.grip && carriage.grip->reeving == reeving;
  return reeving == carriage.reeving || carriage.mainline == reeving || carriage.haulback == reeving || fixed;
}

}  // namespace

std::optional<int> hung_on(const machine::Model& model, const machine::Carriage& carriage, int reeving, int from,
                           int to) {
  const Array<machine::Node>& nodes = model.reevings[reeving].nodes;
  // a mainline may run on over a sheave of the carriage, to a hook
  const int last_node = static_cast<int>(nodes.size()) - 1;
  const auto is_end = [&](int node) { return (node == 0 || node == last_node) && !nodes[node].drum; };
  const bool runs_on = carriage.mainline == reeving && reeving != carriage.reeving;
  const bool to_hook =
      runs_on && (is_end(from) != is_end(to)) && nodes[is_end(from) ? to : from].at.body == carriage.body;
  if (draws_along(carriage, reeving) && !to_hook) return std::nullopt;
  const int first = nodes[from].at.body, last = nodes[to].at.body;
  if (first == last || (first != carriage.body && last != carriage.body)) return std::nullopt;
  const int other = first == carriage.body ? last : first;
  if (other == machine::ground) return std::nullopt;
  const machine::Body& body = model.bodies[other];
  const bool is_carriage = std::any_of(model.carriages.begin(), model.carriages.end(),
                                       [&](const machine::Carriage& one) { return one.body == other; });
  if (is_carriage || body.of_rope || body.beam || body.free.empty()) return std::nullopt;
  return other;
}

bool holds_down(const machine::Model& model, const machine::Carriage& carriage, int reeving, int from, int to) {
  if (draws_along(carriage, reeving)) return false;
  const Array<machine::Node>& nodes = model.reevings[reeving].nodes;
  const int first = nodes[from].at.body, last = nodes[to].at.body;
  if (first == last || (first != carriage.body && last != carriage.body)) return false;
  const int other = first == carriage.body ? last : first;
  return other == machine::ground || model.bodies[other].beam || model.bodies[other].free.empty();
}

double load_on(const machine::Model& model, const machine::Carriage& carriage, std::optional<double> t) {
  double load = model.bodies[carriage.body].mass - carriage.mass;
  for (const machine::Load& one : model.loads) {
    if (one.at.body != carriage.body || !(model.gravity > 0)) continue;
    const bool changes = t && one.over_time;
    const Vector3 force = changes ? Vector3(at(*one.over_time, *t).value * one.force.normalized()) : one.force;
    load -= force.z() / model.gravity;
  }
  return load;
}

std::string limit_words(const machine::Model& model, int body, const LimitState& l) {
  if (l.fails) return "no equilibrium with more";
  const auto rope = [&] { return model.reevings[*l.reeving].name; };
  const auto node = [&] { return model.reevings[*l.reeving].nodes[*l.node].name; };
  switch (l.kind) {
    case LimitKind::none:
      return "no limit";
    case LimitKind::tension:
      return fmt::format("tension of '{}'", rope());
    case LimitKind::pull:
      return fmt::format("pull of {} at '{}'", ropes_at(model, *l.reeving, *l.node), node());
    case LimitKind::clearance:
      return fmt::format("clearance of '{}'", model.bodies[body].name);
    case LimitKind::rope_clearance:
      return fmt::format("clearance of rope '{}'", rope());
    case LimitKind::break_angle:
      return fmt::format("break angle at '{}'", node());
    case LimitKind::least_break_angle:
      return fmt::format("least break angle at '{}'", node());
    case LimitKind::lift_off:
      return fmt::format("lift-off from '{}'", node());
    case LimitKind::rated_payload:
      return fmt::format("rated payload of '{}'", model.bodies[body].name);
  }
  return {};
}

}  // namespace taut::study
