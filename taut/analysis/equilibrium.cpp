#include "taut/analysis/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "taut/analysis/beam_tables.hpp"
#include "taut/analysis/far_loop.hpp"
#include "taut/analysis/first_state.hpp"
#include "taut/analysis/hanging.hpp"
#include "taut/analysis/lift.hpp"
#include "taut/analysis/newton.hpp"
#include "taut/analysis/past_stop.hpp"
#include "taut/analysis/reasons.hpp"
#include "taut/analysis/roll.hpp"
#include "taut/analysis/running.hpp"
#include "taut/analysis/stability.hpp"
#include "taut/analysis/tables.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"
#include "taut/model/without_rope.hpp"

namespace taut::analysis {
namespace {

using Flow = std::vector<std::vector<int>>;

constexpr int relaxing_steps = 400;
constexpr int parts_of_losses = 16;
constexpr double drawn_taut = 0.999;
constexpr int most_changes = 40;  ///< of what touches what

/// Whether motion changes tensions: by losses, or by the weight of rope that runs round.
bool differs_in_motion(const model::Model& model) {
  for (const model::Reeving& rope : model.reevings) {
    if (rope.mass * rope.speed > 0) return true;
    for (const model::Node& node : rope.nodes) {
      if (node.kind == model::NodeKind::contact && node.law.efficiency < 1 && node.law.friction > 0) return true;
    }
  }
  return false;
}

Configuration configuration_of(const Layout& layout, const model::State& state) {
  Configuration c;
  c.bodies = state.bodies;
  c.open_loads.assign(layout.ropes.size(), 0);
  for (const Layout::Link& link : layout.links) c.links.push_back(state.branches[at(link.reeving)][at(link.from)]);
  for (const Layout::Piece& p : layout.pieces) c.pieces.push_back(state.beams.at(at(p.beam)).at(at(p.piece)));
  return c;
}

void keep(const Layout& layout, const Configuration& c, model::State& state) {
  state.bodies = c.bodies;
  for (std::size_t k = 0; k < layout.links.size(); ++k) {
    state.branches[at(layout.links[k].reeving)][at(layout.links[k].from)] = c.links[k];
  }
  for (std::size_t k = 0; k < layout.pieces.size(); ++k) {
    state.beams.at(at(layout.pieces[k].beam)).at(at(layout.pieces[k].piece)) = c.pieces[k];
  }
}

/// Gives a branch a little less than its straight length. False where it does not stretch.
bool draw_taut(const System& system, const model::State& state, int link_index, Configuration& c) {
  const Layout::Link& link = system.layout.links[at(link_index)];
  const model::Reeving& rope = system.model.reevings[at(link.reeving)];
  if (std::isinf(rope.stiffness)) return false;
  c.links[at(link_index)] = {};
  c.links[at(link_index)].length =
      drawn_taut * model::straight_length(state, rope.nodes[at(link.from)], rope.nodes[at(link.to)]);
  return true;
}

/// The configuration of `state`, with every branch that has no shape there (a loose loop on a sheave) drawn taut.
Configuration usable_start(const System& system, const model::State& state) {
  Configuration c = configuration_of(system.layout, state);
  Evaluation e;
  for (std::size_t tries = 0; tries <= c.links.size(); ++tries) {
    const auto no = evaluate(system, c, e);
    if (!no) break;
    if (!draw_taut(system, state, no->link, c)) break;
  }
  return c;
}

/// The same with every branch drawn taut that can be.
Configuration taut_start(const System& system, const model::State& state) {
  Configuration c = configuration_of(system.layout, state);
  for (int k = 0; k < static_cast<int>(c.links.size()); ++k) draw_taut(system, state, k, c);
  return c;
}

/// A machine solved with what touches now.
struct Solved {
  Outcome outcome;
  Layout layout;
  Configuration c;
  Evaluation e;
  int steps = 0;
};

/// Whether an answer is one to stay in, and its carriages hang as carriages do.
Stability stays(const System& system, const Configuration& c, const Evaluation& e) {
  Stability found = stability(system, c, e);
  if (found.outcome.ok()) found.outcome = no_far_loop(system, c, e);
  if (found.outcome.ok()) found.outcome = hanging(system, c, e).outcome;
  return found;
}

/// An answer of which nothing else is wrong than that a carriage lifts off stands: its rollers' state tells.
void accept_lifted(const System& system, Solved& s) {
  if (stability(system, s.c, s.e).outcome.ok() && hanging(system, s.c, s.e).lifted) s.outcome = {};
}

/// Newton from where the machine comes to rest when let go in `start`: quick, careful, from taut ropes, very careful.
/// Where none of them leads to a stable equilibrium: an unstable one (s.outcome says so), else the end of the quick
/// fall, which tells best where things go.
Iteration come_to_rest(const System& system, const model::State& state, const Configuration& start,
                       const EquilibriumOptions& options, Solved& s) {
  constexpr double any = std::numeric_limits<double>::infinity();
  Iteration it, told;
  std::optional<Solved> ends;
  struct Way {
    double growth, ropes;
    bool from_taut;
  };
  for (const Way& way : {Way{any, 0.01, false}, {30, 0.01, false}, {any, 1, false}, {any, 1, true}, {3, 1, false}}) {
    s.c = way.from_taut ? taut_start(system, state) : start;
    it = relax(system, s.c, s.e, relaxing_steps, way.growth, way.ropes);
    s.steps += it.steps;
    if (it.converged) {
      it = newton(system, s.c, s.e, options.tolerance, options.iterations);
      s.steps += it.steps;
    }
    s.outcome = it.converged ? stays(system, s.c, s.e).outcome : Outcome();
    if (it.converged && s.outcome.ok()) return it;
    if (ends && (told.converged || !it.converged)) continue;
    ends = s;
    told = it;
  }
  ends->steps = s.steps;
  s = *std::move(ends);
  return told;
}

/// From `start`, with every means but a change of the losses. An answer that is no stable one is given only where there
/// is no other, and said in s.outcome.
Iteration find(const System& system, const model::State& state, const EquilibriumOptions& options, Solved& s) {
  Configuration start = configuration_of(s.layout, state);
  s.c = start;
  Iteration it = newton(system, s.c, s.e, options.tolerance, options.iterations);
  if (it.stopped && it.steps == 0) {
    s.c = start = usable_start(system, state);
    it = newton(system, s.c, s.e, options.tolerance, options.iterations);
  }
  s.steps += it.steps;
  const Iteration first = it;
  std::optional<Solved> unstable;
  if (it.converged) {
    const Stability found = stays(system, s.c, s.e);
    s.outcome = found.outcome;
    if (s.outcome.ok()) return it;
    unstable = s;
    if (found.rope) {
      // which way a rope runs off is a matter of chance
      const std::vector<rope::CatenaryForce> no_change(s.c.links.size());
      move(system, unstable->c, {found.push, no_change}, 1, start);
    }
  }
  it = come_to_rest(system, state, start, options, s);
  if (it.converged && s.outcome.ok()) return it;
  if (unstable) {
    unstable->steps = s.steps;
    s = *std::move(unstable);
    accept_lifted(system, s);
    return first;
  }
  it.singular = first.singular;  // a drag hides it
  if (it.converged) accept_lifted(system, s);
  return it;
}

/// From the lossless answer, the losses brought on by parts. False where a part has no answer.
bool bring_on_losses(System system, const model::State& state, const EquilibriumOptions& options, Solved& s) {
  system.losses = 0;
  if (!find(system, state, options, s).converged) return false;
  for (int part = 1; part <= parts_of_losses; ++part) {
    system.losses = static_cast<double>(part) / parts_of_losses;
    const Iteration it = newton(system, s.c, s.e, options.tolerance, options.iterations);
    s.steps += it.steps;
    if (!it.converged) return false;
  }
  s.outcome = {};
  return true;
}

Solved solve(const model::Model& model, const model::State& state, const EquilibriumOptions& options, const Flow& flow);

/// For ropes that do not stretch: the state of ropes that stretch less and less. Empty where there is none.
std::optional<model::State> stiffened(model::Model model, model::State state, const EquilibriumOptions& options,
                                      const Flow& flow) {
  std::vector<std::size_t> rigid;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    if (std::isinf(model.reevings[r].stiffness)) rigid.push_back(r);
  }
  if (rigid.empty()) return std::nullopt;
  const double force = layout(model, state, options.prescribed, flow).heaviest;
  for (const double ratio : {1e3, 1e5, 1e7, 1e9}) {
    for (const std::size_t r : rigid) model.reevings[r].stiffness = ratio * force;
    const Solved s = solve(model, state, options, flow);
    if (!s.outcome.ok()) return std::nullopt;
    keep(s.layout, s.c, state);
  }
  return state;
}

Solved solve(const model::Model& model, const model::State& state, const EquilibriumOptions& options,
             const Flow& flow) {
  Solved s;
  s.layout = layout(model, state, options.prescribed, flow);
  const System system{model, s.layout, options.prescribed ? options.prescribed->x : 0};
  const Iteration it = find(system, state, options, s);
  if (it.converged) return s;
  Solved other = s;
  if (const auto near = stiffened(model, state, options, flow)) {
    if (find(system, *near, options, other).converged) return other;
  }
  const bool flows = std::any_of(s.layout.turns.begin(), s.layout.turns.end(), [](const auto& t) { return t.flow; });
  if (flows && bring_on_losses(system, state, options, other)) return other;
  s.outcome = reason(system, s.c, s.e, it);
  return s;
}

/// Solved with what touches found out.
Solved solve_touching(const model::Model& model, model::State& state, const EquilibriumOptions& options,
                      const Flow& flow) {
  int steps = 0;
  Flow let_go;  // how often each node has
  for (const model::Reeving& rope : model.reevings) let_go.emplace_back(rope.nodes.size(), 0);
  for (int change = 0; change < most_changes; ++change) {
    Solved s = solve(model, state, options, flow);
    s.steps = steps += s.steps;
    if (!s.outcome.ok()) return s;
    keep(s.layout, s.c, state);
    if (!change_touch({model, s.layout, 0}, s.c, s.e, state, let_go)) return s;
  }
  Solved s;
  s.outcome = not_converged("the ropes lift off their supports and come back without end");
  return s;
}

/// A carriage that nothing holds, and that was not found between its neighbours: from where it rolls to rest, or the
/// reason.
void roll(const model::Model& model, const EquilibriumOptions& options, const Flow& flow, model::State& state,
          Solved& s) {
  if (options.prescribed) return;
  const std::string away = s.outcome.ok() ? rolled_away(model, state) : std::string();
  if (s.outcome.ok() && away.empty()) return;
  if (const auto rest = roll_to_rest(model, options)) {
    if (!rest->state) {
      s.outcome = infeasible(rest->reason);
      return;
    }
    model::State near = *rest->state;
    Solved rolled = solve_touching(model, near, options, flow);
    if (rolled.outcome.ok() && rolled_away(model, near).empty()) {
      s = std::move(rolled);
      state = std::move(near);
      return;
    }
  }
  if (!away.empty()) s.outcome = infeasible(away);
}

/// Why a carriage prescribed by its mainline has no answer there, found out by a hold along the track in the mainline's
/// place: a carriage lies past a stop of its rope, or the mainline would have to push. Empty for other reasons.
std::string without_mainline(const model::Model& model, const EquilibriumOptions& options, const Flow& flow) {
  if (!options.prescribed) return {};
  const model::Carriage carriage = model.carriages.at(at(options.prescribed->carriage));
  if (carriage.mainline < 0 || carriage.grip_reeving >= 0) return {};
  const model::Reeving& mainline = model.reevings[at(carriage.mainline)];
  auto rest = model::without_rope(model, carriage.mainline);
  if (!rest) return {};
  model::Model& without = *rest;
  Flow flow_without = flow;
  flow_without.erase(flow_without.begin() + carriage.mainline);
  without.carriages[at(options.prescribed->carriage)].haulback = -1;
  const model::State start = model::initial_state(without);
  const Solved s = solve(without, start, options, flow_without);
  if (!s.outcome.ok() || s.layout.hold < 0) return {};
  const System system{without, s.layout, 0};
  if (std::string past = past_stop(system, s.c); !past.empty()) return past;
  const Vector3 hold = s.c.hold * track(system, s.e);
  const Vector3 place = s.c.bodies[at(carriage.body)].position;
  const bool ends_there = mainline.nodes.back().at.body == carriage.body;
  const std::size_t beside = ends_there ? mainline.nodes.size() - 2 : 1;
  const Vector3 pull = model::in_ground({s.c.bodies, {}, {}}, mainline.nodes[beside].at) - place;
  if (hold.dot(pull) > 0) return {};
  return fmt::format(
      "'{}' at x = {:.6g} m has to be pulled away from its mainline '{}' with {:.6g} N; a mainline can't push: choose "
      "another x, or pull from the other side",
      carriage.name, options.prescribed->x, mainline.name, hold.norm());
}

/// The tensions of both directions of motion beside the answer at rest.
void add_band(const model::Model& model, const EquilibriumOptions& options, EquilibriumResult& result) {
  const model::Model held = with_loads_held(model);
  for (const Motion motion : {Motion::in, Motion::out}) {
    EquilibriumOptions moving = options;
    moving.motion = motion;
    const EquilibriumResult other = equilibrium(held, moving, result.state);
    if (!other.outcome.ok() || other.spans.size() != result.spans.size()) {
      result.band = false;
      continue;
    }
    const auto widen = [](double& low, double& high, double T) {
      low = std::min(low, T);
      high = std::max(high, T);
    };
    for (std::size_t k = 0; k < result.spans.size(); ++k) {
      SpanResult& span = result.spans[k];
      widen(span.T_from_min, span.T_from_max, other.spans[k].T_from);
      widen(span.T_to_min, span.T_to_max, other.spans[k].T_to);
    }
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
      ContactResult& contact = result.contacts[k];
      widen(contact.T_in_min, contact.T_in_max, other.contacts[k].T_in);
      widen(contact.T_out_min, contact.T_out_max, other.contacts[k].T_out);
    }
    for (std::size_t r = 0; r < result.ropes.size(); ++r) {
      RopeResult& rope = result.ropes[r];
      if (other.ropes[r].T_max <= rope.T_max) continue;
      const double unstretched = rope.unstretched;
      rope = other.ropes[r];
      rope.unstretched = unstretched;
    }
  }
}

/// The machine with its ropes' flow known; no rope's running counts.
EquilibriumResult standing(const model::Model& model, const EquilibriumOptions& options, const Flow& flow,
                           const std::optional<model::State>& start) {
  EquilibriumResult result;
  result.state = start ? *start : first_state(model, options);
  Solved s = solve_touching(model, result.state, options, flow);
  roll(model, options, flow, result.state, s);
  result.outcome = s.outcome;
  result.closure.iterations = s.steps;
  if (!s.outcome.ok()) {
    std::string why = section_past_stop({model, s.layout, options.prescribed ? options.prescribed->x : 0});
    if (why.empty()) why = without_mainline(model, options, flow);
    if (!why.empty()) result.outcome = taut::infeasible(why);
    return result;
  }
  const System system{model, s.layout, options.prescribed ? options.prescribed->x : 0};
  if (const std::string past = past_stop(system, s.c); !past.empty()) {
    result.outcome = taut::infeasible(past);
    return result;
  }
  fill_tables(system, s.c, s.e, result.state, result);
  result.outcome = check_beams(system, s.c, result.beams);
  return result;
}

}  // namespace

EquilibriumResult equilibrium(const model::Model& model, const EquilibriumOptions& options,
                              const std::optional<model::State>& start) {
  const Flow flow = flow_of(model, options);
  bool runs = false;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) runs = runs || centrifugal(model.reevings[r], flow[r]) > 0;
  EquilibriumResult result;
  if (runs) {
    const auto moving = running(model, flow);
    if (!moving) {
      result.outcome = taut::infeasible(moving.error());
      return result;
    }
    result = standing(*moving, options, flow, start);
    if (result.outcome.ok()) add_centrifugal(model, flow, result);
  } else {
    result = standing(model, options, flow, start);
  }
  const bool band = options.band && options.motion == Motion::at_rest && options.flow.empty();
  if (result.outcome.ok() && band && differs_in_motion(model)) {
    result.band = true;
    add_band(model, options, result);
  }
  return result;
}

model::Model installed(const model::Model& model, const EquilibriumResult& result) {
  expects(result.outcome.ok() && result.ropes.size() == model.reevings.size(), "a result of this machine");
  model::Model frozen = model;
  for (std::size_t r = 0; r < frozen.reevings.size(); ++r) {
    frozen.reevings[r].given = model::Given::length;
    frozen.reevings[r].value = result.ropes[r].unstretched;
  }
  return frozen;
}

}  // namespace taut::analysis
