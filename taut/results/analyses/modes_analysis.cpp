#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "taut/calc/answers.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/results/motion/straight_ropes.hpp"
#include "taut/results/motion/transient_scene.hpp"
#include "taut/solve/modes.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/study/states.hpp"
#include "taut/study/transient.hpp"

namespace taut::results {
namespace {

constexpr std::size_t most_modes_drawn = 6;

/// "" for the first set, "_released".
std::string mode_set_ending(const solve::ModeSet& set) {
  return set.sheaves == solve::Sheaves::stuck ? "" : "_released";
}

void add_modes_table(const study::ModesRun& run, Result& r) {
  std::vector<study::ModeRow> rows;
  for (const solve::ModeSet& set : run.result.sets) {
    for (std::size_t i = 0; i < set.modes.size(); ++i) rows.push_back({run, set, i});
  }
  r.tables.push_back(make_table("modes" + run.ending,
                                "Vibrations: frequencies and damping, ropes stuck on sheaves with a loss and released",
                                study::mode_quantities(), rows));
}

void add_mode_shapes(const study::ModesRun& run, Result& r) {
  std::vector<study::ModeShapeRow> rows;
  for (const solve::ModeSet& set : run.result.sets) {
    for (std::size_t i = 0; i < set.modes.size(); ++i) {
      for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
        if (!run.model.bodies[b].free.empty())
          rows.push_back({{.run = run, .set = set, .mode = i}, static_cast<int>(b)});
      }
    }
  }
  if (rows.empty()) return;
  r.tables.push_back(make_table("mode_shapes" + run.ending,
                                "Shapes: shifts of the bodies' origins and turns (rad per metre of the largest shift)",
                                as_details(study::mode_shape_quantities()), rows));
}

void add_mode_values(const study::ModesRun& run, Result& r) {
  for (const solve::ModeSet& set : run.result.sets) {
    for (std::size_t i = 0; i < set.modes.size(); ++i) {
      const solve::Mode& mode = set.modes[i];
      const std::string end = fmt::format("{}{}{}", i + 1, mode_set_ending(set), run.ending);
      const std::string words =
          run.result.sets.size() == 1 ? "" : fmt::format(", sheaves {}", study::sheaves_words(run, set));
      r.values.push_back(make_value(named(value_kinds(), "frequency_N"), end, "", mode.frequency,
                                    fmt::format("undamped frequency of mode {}{}", i + 1, words)));
      if (mode.kind == solve::ModeKind::free) continue;
      r.values.push_back(make_value(named(value_kinds(), "damping_N"), end, "", mode.damping,
                                    fmt::format("damping of mode {} as a share of the critical one{}", i + 1, words)));
    }
  }
}

/// The side from which most is seen: the broadest of xz and yz, and xy where the machine lies flat.
std::array<int, 2> mode_view(const solve::TransientFrame& rest, const solve::TransientFrame& moved) {
  Vector3 low = Vector3::Constant(HUGE_VAL), high = -low, shift = Vector3::Zero();
  for (std::size_t i = 0; i < rest.branches.size(); ++i) {
    for (const Vector3& p : {rest.branches[i].start, rest.branches[i].end}) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    shift += (moved.branches[i].start - rest.branches[i].start).cwiseAbs() +
             (moved.branches[i].end - rest.branches[i].end).cwiseAbs();
  }
  for (std::size_t i = 0; i < rest.inside.size(); ++i) {
    for (std::size_t k = 0; k < rest.inside[i].size(); ++k) {
      shift += (moved.inside[i][k] - rest.inside[i][k]).cwiseAbs();
    }
  }
  const Vector3 size = high - low;
  const bool sideways = shift.y() > 2 * shift.x() && shift.y() > 2 * shift.z();
  if (sideways && size.x() > size.z()) return {0, 1};
  return {sideways || size.y() > size.x() ? 1 : 0, 2};
}

/// The ropes of a state, and lines from each body to what sits on it. `point`: as the drawing sees a place.
template <class Seen>
void add_ropes_and_bodies(const machine::Model& model, const solve::TransientFrame& frame, Role role, const Seen& point,
                          Drawing& d) {
  for (const RopePart& part : rope_parts(model, frame)) {
    Polyline line;
    line.role = role;
    for (const Vector3& p : part.points) line.points.push_back(point(p));
    if (line.points.size() > 1) d.shapes.emplace_back(std::move(line));
  }
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body == machine::ground || node.at.at.norm() == 0) continue;
      const auto& body = frame.bodies[node.at.body];
      d.shapes.emplace_back(
          Polyline{{point(body.position), point(body.position + body.orientation * node.at.at)}, role, false, false});
    }
  }
}

std::string frequency_words(const solve::Mode& mode) {
  const bool grows = mode.kind == solve::ModeKind::unstable;
  if (mode.frequency > 0) return fmt::format("{:.4g} Hz{}", mode.frequency, grows ? ", growing" : "");
  return grows ? "grows without swinging" : "nothing brings it back";
}

Drawing mode_drawing(const study::ModesRun& run, const solve::ModeSet& set, std::size_t index) {
  const solve::Mode& mode = set.modes[index];
  const auto axes = mode_view(run.result.rest, mode.shape);
  const auto point = [&](const Vector3& p) { return Point{.x = p[axes[0]], .y = p[axes[1]]}; };
  Drawing d;
  d.name = fmt::format("mode{}{}_{}", run.ending, mode_set_ending(set), index + 1);
  d.title = fmt::format("Mode {}: {}{}", index + 1, frequency_words(mode),
                        run.result.sets.size() == 1 ? "" : fmt::format(", sheaves {}", study::sheaves_words(run, set)));
  d.caption = axes[1] == 2 ? "At rest and displaced, not to scale." : "Plan, at rest and displaced, not to scale.";
  d.legend = {{Role::hidden, "at rest"}, {Role::highlight, "displaced"}};
  add_ropes_and_bodies(run.model, run.result.rest, Role::hidden, point, d);
  add_ropes_and_bodies(run.model, mode.shape, Role::highlight, point, d);
  Vector3 low = Vector3::Constant(HUGE_VAL), high = -low;
  for (const auto& b : run.result.rest.branches) {
    low = low.cwiseMin(b.start).cwiseMin(b.end);
    high = high.cwiseMax(b.start).cwiseMax(b.end);
  }
  for (const HeldPart& part : held_parts(run.model, mode.shape, run.result.rest)) {
    const bool seen = part.radius > 0 && std::abs(part.axis[3 - axes[0] - axes[1]]) > 0.5;
    d.shapes.emplace_back(Circle{.center = point(part.at),
                                 .radius = seen ? part.radius : (high - low).norm() / 200,
                                 .role = Role::highlight,
                                 .from = 0,
                                 .to = 0,
                                 .filled = !seen});
    d.shapes.emplace_back(Label{.at = point(part.at), .text = part.name});
  }
  return d;
}

void add_mode_warnings(const study::ModesRun& run, Result& r) {
  for (const solve::ModeSet& set : run.result.sets) {
    for (std::size_t i = 0; i < set.modes.size(); ++i) {
      if (set.modes[i].kind != solve::ModeKind::unstable) continue;
      study::note_failure(r,
                          infeasible(fmt::format("mode {} grows: the state is not one to stay in (sheaves {}); hold or "
                                                 "balance what moves in that mode",
                                                 i + 1, study::sheaves_words(run, set))),
                          run.words);
      return;
    }
  }
  if (run.result.sets.size() < 2) return;
  r.assumptions.push_back(
      fmt::format("Vibrations: stuck means that {} hold the rope by their losses, released that they let it run.",
                  fmt::join(run.result.sets.front().held, ", ")));
}

/// The frequencies, a line for each set.
void add_frequencies(const study::ModesRun& run, Result& r) {
  for (const solve::ModeSet& set : run.result.sets) {
    std::vector<std::string> parts;
    for (const solve::Mode& mode : set.modes) {
      parts.push_back(frequency_words(mode));
    }
    if (parts.empty()) continue;
    if (run.result.sets.size() > 1)
      parts.front() = fmt::format("sheaves {}: {}", study::sheaves_words(run, set), parts.front());
    add_answer_line(r, "Modes", parts);
  }
}

void add_modes(const study::ModesRun& run, MachineRun& machine, Result& r) {
  study::note_failure(r, run.result.outcome, run.words);
  if (!run.result.outcome.ok()) return;
  add_modes_table(run, r);
  add_mode_shapes(run, r);
  add_mode_values(run, r);
  for (const solve::ModeSet& set : run.result.sets) {
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < set.modes.size() && drawn < most_modes_drawn; ++i) {
      if (set.modes[i].shape.branches.empty()) continue;
      Drawing drawing = mode_drawing(run, set, i);
      machine.key_figure.offer(Pictured::modes, drawing.name);
      r.figures.emplace_back(std::move(drawing));
      ++drawn;
    }
  }
  add_mode_warnings(run, r);
  add_frequencies(run, r);
}

/// Whether the statics of a machine has all that holds it at rest, and nothing that only comes later.
bool is_static(const machine::Model& m) {
  const auto comes_later = [](const machine::Node& node) { return node.load.signal.has_value(); };
  return m.contacts.empty() && m.actuators.empty() && m.motors.empty() &&
         std::none_of(m.loads.begin(), m.loads.end(), [](const machine::Load& l) { return l.over_time.has_value(); }) &&
         std::none_of(m.reevings.begin(), m.reevings.end(), [&](const machine::Reeving& rope) {
           return std::any_of(rope.nodes.begin(), rope.nodes.end(), comes_later);
         });
}

/// What vibrates may have straight ropes, and has no loss. At rest ropes sag and friction may hold more, which is
/// judged too: both by statics, where that has all of the machine; else the sag alone.
void judge_rest(const study::ModesRun& run, MachineRun& machine, Result& r) {
  const std::string words = checks::analysis_words(run.ending, "modes");
  const std::string analysis = checks::analysis_name(run.ending, "modes");
  checks::CheckedParts& checked = *machine.checked;
  checked.take_rest(run.model, run.result.rest, run.options.rope_mass, words, analysis);
  const bool settled = run.options.start == solve::Start::settled, by_statics = settled && is_static(machine.model);
  const bool asks = checked.judged && checked.deck->checks;
  if (by_statics) {
    study::EquilibriumRun rest;
    study::solve(machine.model, rest);
    if (rest.result.outcome.ok()) {
      checked.take(rest.model, rest.result, words, analysis);
    } else {
      r.missing.push_back({words, 1, 1, "at rest", rest.result.outcome.message});
    }
  } else if (asks && machine.equilibria.empty() && !run.result.sets.front().held.empty()) {
    r.unmade.push_back(fmt::format("{}: what {} may hold by friction at rest is not judged: add an 'equilibrium'",
                                   words, fmt::join(run.result.sets.front().held, ", ")));
  }
  const bool loaded = any_kept_straight(run.model);
  if (!run.options.rope_mass || (run.options.branches == solve::Branches::catenary && !loaded)) return;
  solve::ModesOptions sagging = run.options;
  sagging.branches = solve::Branches::catenary;
  const auto hangs = solve::rest_of_modes(run.model, sagging);
  if (hangs) checked.take_rest(run.model, *hangs, true, words, analysis);
  const auto known = with_sag(run.model, hangs, run.options.start);
  for (std::string& one : sag_warnings(run.words, run.model, run.result.rest, known, {}, checked.deck->display)) {
    if (asks && (!hangs || loaded) && !by_statics) r.unmade.push_back(one);
    r.warnings.push_back(std::move(one));
  }
}

}  // namespace

void add_answer(const study::ModesRun& asked, MachineRun& machine, Result& r) {
  if (r.interrupted) return;
  study::ModesRun run = asked;
  study::solve(machine.model, run);
  if (run.result.outcome.ok()) judge_rest(run, machine, r);
  add_modes(run, machine, r);
}

}  // namespace taut::results
