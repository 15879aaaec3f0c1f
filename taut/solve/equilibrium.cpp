#include "taut/solve/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/machine/without_rope.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/configuration.hpp"
#include "taut/solve/band.hpp"
#include "taut/solve/beam_tables.hpp"
#include "taut/solve/drives.hpp"
#include "taut/solve/rest/far_loop.hpp"
#include "taut/solve/rest/fed_rope.hpp"
#include "taut/solve/rest/first_state.hpp"
#include "taut/solve/rest/from_middle.hpp"
#include "taut/solve/rest/hanging.hpp"
#include "taut/solve/rest/lift.hpp"
#include "taut/solve/rest/newton.hpp"
#include "taut/solve/rest/past_stop.hpp"
#include "taut/solve/rest/reasons.hpp"
#include "taut/solve/rest/roll.hpp"
#include "taut/solve/rest/sides.hpp"
#include "taut/solve/running.hpp"
#include "taut/solve/stability.hpp"
#include "taut/solve/stiff_ropes.hpp"
#include "taut/solve/tables.hpp"

namespace taut::solve {
namespace {
using Flow = Array<Array<int>>;
constexpr int relaxing_steps = 400;  ///< of one fall; the tests take up to 397
constexpr double same_place = 1e-6;  ///< of the machine's length: two answers are one
constexpr int parts_of_losses = 16;
constexpr int most_changes = 40;        ///< of what touches what
constexpr double no_force = 1e-9;       ///< of the weight of a carriage and its load: holds nothing
constexpr double lightest = 1.0 / 256;  ///< share of the weight of a fed rope that its search begins with
constexpr double least_weight_step = 1e-3;
constexpr int most_pull_doublings = 5;
constexpr double pull_precision = 1e-4;
constexpr int coarser_beams = 3;  ///< steps of a beam for one of a fall: their error is below where a fall ends

/// A machine solved with what touches now.
struct Solved {
  Outcome outcome;
  mechanics::Layout layout;
  mechanics::Configuration c;
  mechanics::Evaluation e;
  int steps = 0;
  bool beam = false;  ///< the outcome is that a beam does not stay, without telling which
};

mechanics::System system_of(const machine::Model& model, const mechanics::Layout& layout,
                            const EquilibriumOptions& options) {
  return {.model = model,
          .layout = layout,
          .coordinate = options.prescribed ? options.prescribed->x : 0,
          .losses = 1,
          .lengths_kept = options.lengths_kept};
}

/// Whether an answer is one to stay in, and its carriages hang as carriages do.
Stability stays(const mechanics::System& system, const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  Stability found = stability(system, c, e);
  if (found.outcome.ok()) found.outcome = no_far_loop(system, c, e);
  if (found.outcome.ok()) found.outcome = hanging(system, c, e).outcome;
  return found;
}

/// Says in `s` whether its answer is one to stay in.
Stability judge(const mechanics::System& system, Solved& s) {
  Stability found = stays(system, s.c, s.e);
  s.outcome = found.outcome;
  s.beam = found.beam;
  return found;
}

/// An answer of which nothing else is wrong than that a carriage lifts off stands: its rollers' state tells.
void accept_lifted(const mechanics::System& system, Solved& s) {
  if (s.beam) return;
  if (stability(system, s.c, s.e).outcome.ok() && hanging(system, s.c, s.e).lifted) s.outcome = {};
}

/// Whether two answers are one.
bool same_answer(const mechanics::System& system, const Solved& a, const Solved& b) {
  const double most = same_place * system.layout.length;
  for (std::size_t i = 0; i < a.c.bodies.size(); ++i) {
    if (!((a.c.bodies[i].position - b.c.bodies[i].position).norm() <= most)) return false;
  }
  for (std::size_t k = 0; k < a.c.branches.size(); ++k) {
    if (!(std::abs(a.c.branches[k].length - b.c.branches[k].length) <= most)) return false;
  }
  return true;
}

/// The machine with its beams in fewer steps, for a fall: Newton from where it ends takes all of them.
machine::Model with_coarse_beams(machine::Model model) {
  for (machine::Beam& beam : model.beams) {
    for (machine::BeamPiece& piece : beam.pieces)
      piece.rod.steps = (piece.rod.steps + coarser_beams - 1) / coarser_beams;
  }
  return model;
}

/// Newton from where the machine comes to rest when let go in `start`: quick, careful, from taut ropes, very careful.
/// Where none of them leads to a stable equilibrium: an unstable one (s.outcome says so), else the end of the quick
/// fall, which tells best where things go. `unstable`: the answer of Newton alone. A beam that buckles there does not
/// bend in a fall, which is one of bodies and ropes: where the fall leads back to that answer, the other ways do too.
Iteration come_to_rest(const mechanics::System& system, const machine::State& state,
                       const mechanics::Configuration& start, const EquilibriumOptions& options,
                       const std::optional<Solved>& unstable, Solved& s) {
  constexpr double any = std::numeric_limits<double>::infinity();
  Iteration it, reported;
  std::optional<Solved> ends;
  std::optional<machine::Model> coarse;
  if (!system.layout.pieces.empty()) coarse = with_coarse_beams(system.model);
  const mechanics::System falling{.model = coarse ? *coarse : system.model,
                                  .layout = system.layout,
                                  .coordinate = system.coordinate,
                                  .losses = system.losses,
                                  .lengths_kept = system.lengths_kept};
  struct Way {
    double growth, ropes;
    bool from_taut;
  };
  for (const Way& way : {Way{.growth = any, .ropes = 0.01, .from_taut = false},
                         {.growth = 30, .ropes = 0.01, .from_taut = false},
                         {.growth = any, .ropes = 1, .from_taut = false},
                         {.growth = any, .ropes = 1, .from_taut = true},
                         {.growth = 3, .ropes = 1, .from_taut = false}}) {
    s.c = way.from_taut ? mechanics::taut_start(system, state) : start;
    it = relax(falling, s.c, s.e, relaxing_steps, way.growth, way.ropes);
    s.steps += it.steps;
    if (it.converged) {
      it = newton(system, s.c, s.e, options.tolerance, options.iterations);
      s.steps += it.steps;
    }
    s.outcome = {};
    if (it.converged) judge(system, s);
    if (it.converged && s.outcome.ok()) return it;
    const bool buckles = it.converged && unstable && !system.layout.pieces.empty();
    if (buckles && same_answer(system, s, *unstable)) return it;
    if (ends && (reported.converged || !it.converged)) continue;
    ends = s;
    reported = it;
  }
  ends->steps = s.steps;
  s = *std::move(ends);
  return reported;
}

/// A search for the taut root of a given tension begins on its side.
void leave_deep_loops(const mechanics::System& system, mechanics::Configuration& c) {
  const Array<FedEnd> fed = fed_ends(system);
  if (fed.empty()) return;
  mechanics::Configuration now = c;
  mechanics::Evaluation e;
  if (!mechanics::evaluate(system, now, e) && deep_link(system, fed, now, e)) draw_fed_taut(system, fed, c);
}

/// From `start`, with every means but a change of the losses. An answer that is no stable one is given only where there
/// is no other, and said in s.outcome.
Iteration find(const mechanics::System& system, const machine::State& state, const EquilibriumOptions& options,
               Solved& s) {
  mechanics::Configuration start = mechanics::configuration_of(s.layout, state);
  leave_deep_loops(system, start);
  s.c = start;
  Iteration it = newton(system, s.c, s.e, options.tolerance, options.iterations);
  if (it.stopped && it.steps == 0) {
    s.c = start = mechanics::usable_start(system, state);
    it = newton(system, s.c, s.e, options.tolerance, options.iterations);
  }
  s.steps += it.steps;
  const Iteration first = it;
  std::optional<Solved> unstable;
  if (it.converged) {
    const Stability found = judge(system, s);
    if (s.outcome.ok()) return it;
    unstable = s;
    if (found.rope) {
      // which way a rope runs off is a matter of chance
      const Array<rope::CatenaryForce> no_change(s.c.branches.size());
      mechanics::move(system, unstable->c, {.step = found.push, .force = no_change}, 1, start);
    }
  }
  it = come_to_rest(system, state, start, options, unstable, s);
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
bool bring_on_losses(mechanics::System system, const machine::State& state, const EquilibriumOptions& options,
                     Solved& s) {
  system.losses = 0;
  if (!find(system, state, options, s).converged) return false;
  for (int part = 1; part <= parts_of_losses; ++part) {
    system.losses = static_cast<double>(part) / parts_of_losses;
    const Iteration it = newton(system, s.c, s.e, options.tolerance, options.iterations);
    s.steps += it.steps;
    if (!it.converged) return false;
  }
  s.outcome = {};
  if (fed_ends(system).empty()) return true;
  judge(system, s);
  if (!s.outcome.ok()) accept_lifted(system, s);
  return s.outcome.ok();
}

/// From fed ropes that weigh next to nothing, and so have one root alone, to their weight by parts. False where the
/// equilibrium ends on the way.
bool bring_on_weight(const machine::Model& model, const machine::State& state, const EquilibriumOptions& options,
                     Solved& s) {
  machine::Model light = model;
  bool weighs_at_all = false;
  const auto weigh = [&](double share) {
    for (const FedEnd& end : fed_ends({.model = model, .layout = s.layout, .coordinate = 0})) {
      const double weight = model.reevings[end.rope].weight;
      light.reevings[end.rope].weight = share * weight;
      weighs_at_all = weighs_at_all || weight > 0;
    }
  };
  weigh(lightest);
  if (!weighs_at_all) return false;
  const mechanics::System system = system_of(light, s.layout, options);
  if (!find(system, state, options, s).converged || !s.outcome.ok()) return false;
  for (double weighs = lightest, step = lightest; weighs < 1;) {
    weigh(std::min(1.0, weighs + step));
    Solved next = s;
    const Iteration it = newton(system, next.c, next.e, options.tolerance, options.iterations);
    s.steps += it.steps;
    if (!it.converged || !stays(system, next.c, next.e).outcome.ok()) {
      step /= 4;
      if (step < least_weight_step * weighs) return false;
      continue;
    }
    s.c = std::move(next.c);
    s.e = std::move(next.e);
    weighs += step;
    step *= 2;
  }
  return true;
}

/// The least tension of a fed rope, N, between one that has an answer and the given one, which has none; 0 where none
/// was found, or not sought: at each place of a load path, of a rope with two tensions or with that of another.
double least_pull(const machine::Model& model, const machine::State& state, const EquilibriumOptions& options,
                  const Solved& failed, int reeving) {
  machine::Model pulled = model;
  machine::Reeving& rope = pulled.reevings[reeving];
  if (options.prescribed || rope.also || rope.given == machine::Given::equal) return 0;
  double low = rope.value, high = low;
  Solved s = failed;
  const mechanics::System system = system_of(pulled, s.layout, options);
  const auto holds = [&](const Solved& found) { return stays(system, found.c, found.e).outcome.ok(); };
  for (int doubling = 0; doubling < most_pull_doublings; ++doubling) {
    rope.value = high = 2 * high;
    if (find(system, state, options, s).converged && s.outcome.ok()) break;
    low = high;
    if (doubling + 1 == most_pull_doublings) return 0;
  }
  while (high - low > pull_precision * high) {
    rope.value = (low + high) / 2;
    Solved next = s;
    const bool found = newton(system, next.c, next.e, options.tolerance, options.iterations).converged && holds(next);
    (found ? high : low) = rope.value;
    if (found) s = std::move(next);
  }
  return high;
}

Solved solve_by_lengths(const machine::Model& model, const machine::State& state, const EquilibriumOptions& options,
                        const Flow& flow) {
  Solved s;
  s.layout = mechanics::layout(model, state, options.prescribed, flow);
  const mechanics::System system = system_of(model, s.layout, options);
  const Iteration it = find(system, state, options, s);
  // where a tension is given there may be a stable answer beside one that is not
  const bool fed = !fed_ends(system).empty();
  if (it.converged && s.outcome.ok()) return s;
  if (it.converged && s.beam && options.beam_factors) {
    Array<BeamResult> beams = beam_results(system, s.c);
    s.outcome = check_beams(system, s.c, beams);
  }
  if (it.converged && !fed) return s;
  Solved other = s;
  const bool flows = std::any_of(s.layout.turns.begin(), s.layout.turns.end(), [](const auto& t) { return t.flow; });
  if (flows && bring_on_losses(system, state, options, other)) return other;
  if (fed && bring_on_weight(model, state, options, other)) return other;
  if (it.converged) return s;
  s.outcome = reason(system, s.c, s.e, it);
  if (const auto heavy = too_heavy(system, s.e, it)) {
    s.outcome = too_heavy_outcome(system, *heavy, least_pull(model, state, options, s, *heavy));
  }
  return s;
}

/// The answer beside `near` with the forces of stiff ropes as unknowns.
Solved with_forces_from(const machine::Model& model, const Solved& near, double softest,
                        const EquilibriumOptions& options) {
  const double coordinate = options.prescribed ? options.prescribed->x : 0;
  StiffAnswer s =
      with_stiff_ropes(model, {.outcome = near.outcome, .layout = near.layout, .c = near.c, .e = near.e, .steps = 0},
                       coordinate, softest, options);
  return {.outcome = s.outcome,
          .layout = std::move(s.layout),
          .c = std::move(s.c),
          .e = std::move(s.e),
          .steps = near.steps + s.steps};
}

/// Of ropes that hardly stretch: by way of softer ones, which also show whether it is an answer to stay in.
Solved solve_stiff(const machine::Model& model, const machine::State& state, double force,
                   const EquilibriumOptions& options, const Flow& flow) {
  Solved first;
  for (const Array<double>& ratios : {Array<double>{1e4, 1e6}, {1e2, 1e3, 1e4, 1e5, 1e6}}) {
    machine::Model before = model;
    machine::State near = state;
    Solved soft, stiff;
    for (const double ratio : ratios) {
      const machine::Model softer = softened(model, ratio * force);
      near = with_stiffness(std::move(near), before, softer);
      soft = solve_by_lengths(softer, near, options, flow);
      if (!soft.outcome.ok()) break;
      stiff = with_forces_from(model, soft, ratio * force, options);
      if (stiff.outcome.ok()) return stiff;
      mechanics::keep(soft.layout, soft.c, near);
      before = softer;
    }
    const bool found = soft.outcome.ok();
    if (found || first.outcome.ok()) first = found ? std::move(stiff) : std::move(soft);
    if (found) break;
  }
  return first;
}

Solved solve(const machine::Model& model, const machine::State& state, const EquilibriumOptions& options,
             const Flow& flow) {
  const double force = force_scale(model, mechanics::layout(model, state, options.prescribed, flow));
  if (has_stiff_ropes(model, force)) return solve_stiff(model, state, force, options, flow);
  Solved s = solve_by_lengths(model, state, options, flow);
  if (!s.outcome.ok() || !is_rough({.model = model, .layout = s.layout, .coordinate = 0}, s.e)) return s;
  Solved fine = with_forces_from(model, s, std::numeric_limits<double>::infinity(), options);
  return fine.outcome.ok() ? fine : s;
}

/// Solved with what touches found out.
Solved solve_touching(const machine::Model& model, machine::State& state, const EquilibriumOptions& options,
                      const Flow& flow) {
  int steps = 0;
  Flow let_go;  // how often each node has
  for (const machine::Reeving& rope : model.reevings) let_go.emplace_back(rope.nodes.size(), 0);
  for (int change = 0; change < most_changes; ++change) {
    Solved s = solve(model, state, options, flow);
    s.steps = steps += s.steps;
    if (!s.outcome.ok()) return s;
    mechanics::keep(s.layout, s.c, state);
    if (!change_touch({.model = model, .layout = s.layout, .coordinate = 0}, s.c, s.e, state, let_go)) return s;
  }
  Solved s;
  s.outcome = not_converged("the ropes lift off their supports and come back without end");
  return s;
}

/// A carriage that nothing holds, and that was not found between its neighbours: from where it rolls to rest, or the
/// reason.
void roll(const machine::Model& model, const EquilibriumOptions& options, const Flow& flow, machine::State& state,
          Solved& s) {
  if (options.prescribed) return;
  const std::string away = s.outcome.ok() ? rolled_away(model, state) : std::string();
  if (s.outcome.ok() && away.empty()) return;
  if (const auto rest = roll_to_rest(model, options)) {
    if (!rest->state) {
      s.outcome = infeasible(rest->reason);
      return;
    }
    machine::State near = *rest->state;
    Solved rolled = solve_touching(model, near, options, flow);
    if (rolled.outcome.ok() && rolled_away(model, near).empty()) {
      s = std::move(rolled);
      state = std::move(near);
      return;
    }
  }
  if (!away.empty()) s.outcome = infeasible(away);
}

/// A carriage prescribed by its mainline, with a hold along the track in the mainline's place: why it has no answer
/// there (it lies past a stop of its rope, or the mainline would have to push), or where its taut answer is sought.
struct WithoutMainline {
  std::string why;                          ///< empty for other reasons
  std::optional<machine::State> near = {};  ///< the machine with its mainline straight under the force of the hold
  bool no_force = false;                    ///< that force is none
};

WithoutMainline without_mainline(const machine::Model& model, const EquilibriumOptions& options, const Flow& flow) {
  if (!options.prescribed) return {};
  const machine::Carriage carriage = model.carriages.at(as_size(options.prescribed->carriage));
  if (!carriage.mainline || carriage.grip) return {};
  const int index = *carriage.mainline;
  const machine::Reeving& mainline = model.reevings[index];
  auto rest = machine::without_rope(model, index);
  if (!rest) return {};
  machine::Model& without = *rest;
  Flow flow_without = flow;
  flow_without.erase(flow_without.begin() + index);
  without.carriages[options.prescribed->carriage].haulback.reset();
  const machine::State start = machine::initial_state(without);
  const Solved s = solve(without, start, options, flow_without);
  if (!s.outcome.ok() || !s.layout.hold) return {};
  const mechanics::System system{.model = without, .layout = s.layout, .coordinate = 0};
  if (std::string past = past_stop(system, s.c); !past.empty()) return {.why = past};
  machine::State held = start;
  mechanics::keep(s.layout, s.c, held);
  const Vector3 hold = s.c.hold * track(system, s.e);
  const Vector3 place = s.c.bodies[carriage.body].position;
  const bool ends_there = mainline.nodes.back().at.body == carriage.body;
  const std::size_t beside = ends_there ? mainline.nodes.size() - 2 : 1;
  const Vector3 pull =
      machine::in_ground({.bodies = s.c.bodies, .branches = {}, .touched = {}}, mainline.nodes[beside].at) - place;
  if (hold.norm() <= no_force * machine::weight_on(model, carriage.body)) {
    if (mainline.weight > 0) {
      return {.why = fmt::format(
                  "'{}' stands by itself at x = {} m, and the weight of its mainline '{}' pulls it away from "
                  "there: choose another x",
                  carriage.name, place_number(machine::told_x(model, *options.prescribed)), mainline.name)};
    }
    return {.why = {}, .near = machine::with_rope(std::move(held), mainline, index, 0), .no_force = true};
  }
  if (hold.dot(pull) > 0) {
    const double tension = hold.squaredNorm() * pull.norm() / hold.dot(pull) / mainline.copies;
    return {.why = {}, .near = machine::with_rope(std::move(held), mainline, index, tension)};
  }
  return {.why = fmt::format("'{}' at x = {} m has to be pulled away from its mainline '{}' with {:.6g} N; a mainline "
                             "can't push: choose another x, or pull from the other side",
                             carriage.name, place_number(machine::told_x(model, *options.prescribed)), mainline.name,
                             hold.norm())};
}

/// Whether a mainline hangs deep: see deep_mainline_link.
bool hangs_deep(const machine::Model& model, const Solved& s) {
  return s.outcome.ok() &&
         deep_mainline_link({.model = model, .layout = s.layout, .coordinate = 0}, s.c, s.e).has_value();
}

/// A machine without an answer, or with a mainline that hangs deep: the taut answer by way of the machine without its
/// mainline where there is one, else the reason why there is none.
void pull_mainline_taut(const machine::Model& model, const EquilibriumOptions& options, const Flow& flow,
                        machine::State& at, Solved& s) {
  const bool deep = hangs_deep(model, s);
  if (s.outcome.ok() && !deep) return;
  const std::string past =
      deep ? ""
           : section_past_stop(
                 {.model = model, .layout = s.layout, .coordinate = options.prescribed ? options.prescribed->x : 0});
  const WithoutMainline found = past.empty() ? without_mainline(model, options, flow) : WithoutMainline{.why = past};
  if (found.near) {
    EquilibriumOptions near = options;
    if (found.no_force) near.tolerance = std::max(options.tolerance, no_force);
    machine::State state = *found.near;
    Solved taut = solve_touching(model, state, near, flow);
    if (taut.outcome.ok() && !(deep && hangs_deep(model, taut))) {
      s = std::move(taut);
      at = std::move(state);
    }
  }
  if (!found.why.empty()) s.outcome = taut::infeasible(found.why);
}

/// A carriage that is put at a height on a rope that hangs as a deep loop elsewhere: from the taut first state, else it
/// has no answer.
void leave_deep_rope(const machine::Model& model, const EquilibriumOptions& options, const Flow& flow,
                     machine::State& at, Solved& s) {
  if (!options.prescribed || !options.prescribed->z) return;
  const machine::Carriage& carriage = model.carriages[options.prescribed->carriage];
  const auto deep = [&](const Solved& one) {
    return deep_link_at_height(system_of(model, one.layout, options), carriage, one.c, one.e);
  };
  const auto loop = s.outcome.ok() ? deep(s) : std::nullopt;
  if (!loop) return;
  machine::State state = first_state(model, options);
  Solved taut = solve_touching(model, state, options, flow);
  if (taut.outcome.ok() && !deep(taut)) {
    s = std::move(taut);
    at = std::move(state);
    return;
  }
  const mechanics::Layout::Branch& branch = s.layout.branches[*loop];
  const machine::Reeving& rope = model.reevings[branch.reeving];
  s.outcome = taut::infeasible(
      fmt::format("no taut rope was found that holds '{}' at that height, only one with a deep loop of '{}' between "
                  "'{}' and '{}': choose another z",
                  carriage.name, rope.name, rope.nodes[branch.from].name, rope.nodes[branch.to].name));
}

/// The machine with its ropes' flow known; no rope's running counts.
EquilibriumResult standing(const machine::Model& model, const EquilibriumOptions& options, const Flow& flow,
                           const std::optional<machine::State>& start) {
  EquilibriumResult result;
  result.state = start ? *start : first_state(model, options);
  Solved s = solve_touching(model, result.state, options, flow);
  roll(model, options, flow, result.state, s);
  pull_mainline_taut(model, options, flow, result.state, s);
  leave_deep_rope(model, options, flow, result.state, s);
  result.outcome = s.outcome;
  result.closure.iterations = s.steps;
  if (!result.outcome.ok()) return result;
  const mechanics::System system = system_of(model, s.layout, options);
  if (const std::string past = past_stop(system, s.c); !past.empty()) {
    result.outcome = taut::infeasible(past);
    return result;
  }
  if (const std::string misplaced = machine::misplaced_guide(model, s.c.bodies); !misplaced.empty()) {
    result.outcome = taut::infeasible(misplaced);
    return result;
  }
  fill_tables(system, s.c, s.e, result.state, result);
  if (options.beam_factors) result.outcome = check_beams(system, s.c, result.beams);
  if (result.outcome.ok() && !options.held) result.outcome = stands_by_itself(model, options, result);
  return result;
}

bool is_of_size(const Array<Array<int>>& flow, const Array<machine::Reeving>& reevings) {
  return std::equal(flow.begin(), flow.end(), reevings.begin(), reevings.end(),
                    [](const auto& own, const machine::Reeving& rope) { return own.size() == rope.nodes.size(); });
}

/// What a caller promises of the arguments: beyond these sizes memory would be read that is not theirs.
void expect_arguments(const machine::Model& model, const EquilibriumOptions& options,
                      const std::optional<machine::State>& start) {
  expects(!start || machine::is_of(model, *start), "a start is a state of this model");
  expects(options.flow.empty() || is_of_size(options.flow, model.reevings), "the flow is given at every node");
  if (!options.prescribed) return;
  const int carriage = options.prescribed->carriage;
  expects(carriage >= 0 && as_size(carriage) < model.carriages.size(), "a prescribed carriage is one of the model");
  expects(std::isfinite(options.prescribed->x), "a prescribed carriage stands somewhere");
}

}  // namespace

Outcome stands_by_itself(const machine::Model& model, const EquilibriumOptions& options,
                         const EquilibriumResult& result) {
  if (!options.prescribed) return {};
  const machine::Carriage& carriage = model.carriages.at(as_size(options.prescribed->carriage));
  double largest = 0;
  for (const RopeResult& rope : result.ropes) largest = std::max(largest, rope.T_max);
  const double none = std::max(no_force * machine::weight_on(model, carriage.body), options.tolerance * largest);
  if (result.hold.norm() <= none) return {};
  return infeasible(
      fmt::format("'{}' stays at x = {} m only by a force of {:.4g} kN along its track, and nothing gives it: give the "
                  "carriage a mainline, clamp it, choose another x, or say 'held: true' where something else holds it",
                  carriage.name, place_number(machine::told_x(model, *options.prescribed)), result.hold.norm() / 1e3));
}

EquilibriumResult equilibrium(const machine::Model& model, const EquilibriumOptions& options,
                              const std::optional<machine::State>& start) {
  expect_arguments(model, options, start);
  if (auto found = found_from_middle(model, options, start)) return *std::move(found);
  EquilibriumResult result;
  if (const auto open = options.lengths_kept ? std::nullopt : not_ready(model)) {
    result.outcome = taut::infeasible(*open);
    return result;
  }
  const RopesRun run = ropes_run(model, options, start);
  bool runs = false;
  for (std::size_t r = 0; r < run.flow.size(); ++r) runs = runs || centrifugal(model.reevings[r], run.flow[r]) > 0;
  const auto solve_on = [&](const machine::Model& on, const std::optional<machine::State>& near) {
    return standing(on, options, run.flow, near);
  };
  if (runs) {
    const auto moving = running(model, run.flow);
    if (!moving) {
      result.outcome = taut::infeasible(moving.error());
      return result;
    }
    result = on_inner_sides(*moving, start, solve_on);
    if (result.outcome.ok()) add_centrifugal(model, run.flow, result);
  } else {
    result = on_inner_sides(model, start, solve_on);
  }
  result.flow = run.flow;
  if (result.outcome.ok()) add_band(model, options, run.creep, result);
  return result;
}

}  // namespace taut::solve
