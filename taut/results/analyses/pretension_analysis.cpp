#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/motion_checks.hpp"
#include "taut/machine/links/links.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/motion/transient_figures.hpp"
#include "taut/results/motion/transient_scene.hpp"
#include "taut/study/pretension.hpp"
#include "taut/units/parse.hpp"

namespace taut::results {
namespace {

struct PretensionRun {
  std::string ending;
  study::PretensionRequest request;
  std::vector<study::Pull> pulls;  ///< of one round
  bool observes = false;           ///< the deck names what it observes
};

std::string pretension_words(const PretensionRun& run) {
  return run.request.name ? fmt::format("pretension, {}", *run.request.name) : "pretension";
}

/// What a pull waits for, with the way that it is to move.
void resolve_until(const study::PullRequest& request, const std::string& path, Preparation& p, study::Pull& pull) {
  if (!request.until) {
    if (request.moves) p.complaints.push_back({path + ".moves", "belongs to 'until'"});
    return;
  }
  if (!request.moves) {
    p.complaints.push_back({path, "'until' needs 'moves': by how much"});
    return;
  }
  std::vector<Complaint> reported_before;
  const machine::Links links(p.machine, reported_before);
  const auto until = machine::observable(*request.until, p.model, links, path + ".until", p.complaints);
  if (!until) return;
  const auto moves = parse_quantity(*request.moves, until->unit);
  if (!moves) {
    p.complaints.push_back({path + ".moves", moves.error().message});
  } else if (!(*moves > 0)) {
    p.complaints.push_back({path + ".moves", "must be above 0"});
  } else {
    pull.until = until;
    pull.moves = *moves;
  }
}

study::Pull resolved_pull(const study::PullRequest& request, const std::string& path, Preparation& p) {
  study::Pull pull;
  pull.reeving = reeving_of(p, request.rope, path + ".rope");
  pull.at_end = request.end == study::RopeEnd::end;
  pull.force = request.force;
  pull.take_up = request.take_up;
  resolve_until(request, path, p, pull);
  if (pull.reeving < 0) return pull;
  const machine::Reeving& rope = p.model.reevings[pull.reeving];
  if (rope.closed) {
    p.complaints.push_back({path + ".rope", "an endless rope has no end to be pulled at: tighten it by 'take_up'"});
  } else if ((pull.at_end ? rope.nodes.back() : rope.nodes.front()).drum >= 0) {
    p.complaints.push_back({path + ".rope", "is on a drum at that end, which pulls it: name the other end"});
  }
  return pull;
}

/// "extension.T_end", or, of a rope whose tension is the same all along, "guy.T".
std::vector<Column> tension_columns(const machine::Model& m) {
  std::vector<Column> columns;
  for (const machine::Reeving& rope : m.reevings) {
    columns.push_back({rope.name + ".T_start", si::N});
    columns.push_back({rope.name + ".T_end", si::N});
  }
  return columns;
}

void add_pull_tensions(const study::PullEnd& end, std::vector<Cell>& row) {
  for (std::size_t i = 0; i < end.T_start.size(); ++i) {
    row.emplace_back(end.T_start[i]);
    row.emplace_back(end.T_end[i]);
  }
}

/// What the table tells besides tensions: measures, and what the deck itself observes.
std::vector<std::size_t> reported_beside(const PretensionRun& run, const machine::Model& m,
                                         const study::PretensionResult& result, const std::vector<Column>& reported) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; result.slowly && k < m.observed.size(); ++k) {
    const machine::Observable& o = m.observed[k];
    const bool measure = o.taken != machine::description::Taken::automatic;
    const bool known = std::any_of(reported.begin(), reported.end(), [&](const Column& c) { return c.name == o.name; });
    if ((measure || run.observes) && !known) all.push_back(k);
  }
  return all;
}

Table tensioning_table(const PretensionRun& run, const machine::Model& m, const study::PretensionResult& result) {
  Table t;
  t.name = "tensioning" + run.ending;
  t.title = "Ropes pulled tight in turn: what each pull has taken out of its rope, and all tensions as it ends";
  t.columns = {{"step", si::one}, {"pulled", si::one}, {"taken_out", si::m}, {"taken_out_in_all", si::m}};
  for (const Column& column : tension_columns(m)) t.columns.push_back(column);
  const std::vector<std::size_t> observed = reported_beside(run, m, result, t.columns);
  for (const std::size_t k : observed) t.columns.push_back({m.observed[k].name, m.observed[k].unit});
  const auto add = [&](double step, const std::string& name, const study::PullEnd& end) {
    std::vector<Cell> row = {step, name, end.taken, end.taken_in_all};
    add_pull_tensions(end, row);
    for (const std::size_t k : observed) row.emplace_back(end.observed[k]);
    t.rows.push_back(std::move(row));
  };
  add(0, "", result.before);
  for (std::size_t i = 0; i < result.ends.size(); ++i) {
    const study::Pull& pull = run.pulls[i % run.pulls.size()];
    add(static_cast<double>(i + 1), m.reevings[pull.reeving].name, result.ends[i]);
  }
  return t;
}

void add_pretension_value(Result& r, const std::string& name, double value, const Unit& unit, std::string words) {
  r.values.push_back({name, value, unit, name, std::move(words), {}});
}

/// Measures by step, and of each rope what it has at the end: its tensions, its length, what was taken out.
void add_pretension_values(const PretensionRun& run, const machine::Model& m, const study::PretensionResult& result,
                           Result& r) {
  const std::string of = pretension_words(run);
  for (std::size_t i = 0; result.slowly && i < result.ends.size(); ++i) {
    for (std::size_t k = 0; k < m.observed.size(); ++k) {
      if (m.observed[k].taken == machine::description::Taken::automatic) continue;
      add_pretension_value(r, fmt::format("{}_{}{}", m.observed[k].name, i + 1, run.ending), result.ends[i].observed[k],
                           m.observed[k].unit, fmt::format("{} as pull {} ends ({})", m.observed[k].name, i + 1, of));
    }
  }
  std::set<int> pulled;
  for (const study::Pull& pull : run.pulls) pulled.insert(pull.reeving);
  const study::PullEnd& last = result.ends.back();
  for (const int i : pulled) {
    const std::string& name = m.reevings[i].name;
    double taken = 0;
    for (std::size_t k = 0; k < result.ends.size(); ++k) {
      if (run.pulls[k % run.pulls.size()].reeving == i) taken = result.ends[k].taken_in_all;
    }
    const auto add = [&](const char* what, double value, const Unit& unit, const char* words) {
      add_pretension_value(r, fmt::format("{}.pretension_{}{}", name, what, run.ending), value, unit,
                           fmt::format("{} of {} ({})", words, name, of));
    };
    add("T_start", last.T_start[i], si::N, "tension at the start");
    add("T_end", last.T_end[i], si::N, "tension at the end");
    add("length", last.unstretched[i], si::m, "unstretched length");
    add("taken_out", taken, si::m, "rope taken out");
  }
}

Plot tensioning_plot(const PretensionRun& run, const machine::Model& m, const study::PretensionResult& result) {
  Plot p;
  p.name = "tensioning_over_pulls" + run.ending;
  p.title = fmt::format("Tensions as each pull ends ({})", pretension_words(run));
  p.x = {"pull", si::one};
  p.y = {"tension", si::N};
  std::set<std::pair<int, bool>> ends;
  for (const study::Pull& pull : run.pulls) ends.insert({pull.reeving, pull.at_end});
  for (const auto& [rope, at_end] : ends) {
    Curve c;
    c.label = fmt::format("{} at its {}", m.reevings[rope].name, at_end ? "end" : "start");
    const auto add = [&](double step, const study::PullEnd& end) {
      c.x.push_back(step);
      c.y.push_back(at_end ? end.T_end[rope] : end.T_start[rope]);
    };
    add(0, result.before);
    for (std::size_t i = 0; i < result.ends.size(); ++i) add(static_cast<double>(i + 1), result.ends[i]);
    p.curves.push_back(std::move(c));
  }
  return p;
}

/// A machine that is pulled slowly: before any pull and as each ends, the last one drawn.
void add_pretension_scene(const PretensionRun& run, const machine::Model& m, const study::PretensionResult& result,
                          Result& r) {
  TransientRun slow;
  slow.ending = "_pretension" + run.ending;
  slow.model = m;
  slow.result.frames = result.frames;
  r.figures.emplace_back(drawing_at(slow, result.frames.size() - 1,
                                    fmt::format("As pull {} ends ({})", result.ends.size(), pretension_words(run))));
  r.scenes.push_back(scene_of(slow));
}

std::string how_words(const PretensionRun& run, const study::PretensionResult& result) {
  if (!result.slowly) return "an equilibrium at rest without loss as each pull ends";
  const bool settled = run.request.start == study::PretensionRequest::Start::settled;
  return fmt::format("slowly, with all friction carried on from pull to pull; starts {}; events and drives stand still",
                     settled ? "settled: at rest in equilibrium, ropes without loss, contacts holding what they can"
                             : "assembled: as described, friction holding what it can");
}

}  // namespace

Analysis prepare_pretension(const study::PretensionRequest& request, const std::string& path, Preparation& p) {
  PretensionRun run;
  run.ending = ending_of(p, "pretension", request.name, path);
  run.request = request;
  if (request.least) return prepare_least_tension(request, path, run.ending, p);
  run.observes = !p.machine.observe.empty();
  for (std::size_t i = 0; i < request.pull.size(); ++i) {
    run.pulls.push_back(resolved_pull(request.pull[i], fmt::format("{}.pull[{}]", path, i), p));
  }
  if (request.pull.empty()) p.complaints.push_back({path + ".pull", "names no rope"});
  if (study::pulled_slowly(p.model, run.pulls)) {
    if (!p.machine.beams.empty()) {
      p.complaints.push_back({path, "a machine with beams is pulled without contacts, cylinders and 'until'"});
    } else {
      checks::check_inertia(p.machine, p.model, p.complaints);
      checks::check_masses(p.machine, p.model, true, p.complaints);
    }
  }
  return [run](MachineRun& machine, Result& r) {
    if (r.interrupted) return;
    std::vector<study::Pull> pulls;
    for (int i = 0; i < run.request.rounds; ++i) pulls.insert(pulls.end(), run.pulls.begin(), run.pulls.end());
    study::PretensionOptions options;
    options.longest = run.request.longest;
    options.tolerance = run.request.tolerance;
    const bool settled = run.request.start == study::PretensionRequest::Start::settled;
    options.start = settled ? solve::Start::settled : solve::Start::assembled;
    options.progress = [&](std::size_t i) {
      return !machine.progress ||
             machine.progress({pretension_words(run), static_cast<double>(i) / static_cast<double>(pulls.size()),
                               fmt::format("pull {} of {}", i + 1, pulls.size())});
    };
    const study::PretensionResult result = study::pretension(machine.model, pulls, options);
    if (result.interrupted) {
      r.interrupted = true;
      r.status = Status::not_converged;
      r.message = fmt::format("{}: interrupted after pull {}", pretension_words(run), result.ends.size());
    }
    note_failure(r, result.outcome, pretension_words(run));
    if (result.ends.empty()) return;
    r.tables.push_back(tensioning_table(run, machine.model, result));
    add_pretension_values(run, machine.model, result, r);
    r.figures.emplace_back(tensioning_plot(run, machine.model, result));
    r.assumptions.push_back(fmt::format("{}: {}.", pretension_words(run), how_words(run, result)));
    if (result.slowly) add_pretension_scene(run, machine.model, result, r);
    for (const study::PullEnd& end : result.ends) {
      if (end.at)
        machine.checked->take(result.model, *end.at, pretension_words(run),
                              checks::analysis_name(run.ending, "pretension"));
    }
    const study::PullEnd& last = result.ends.back();
    if (last.at) machine.others.push_back({pretension_words(run), result.model, *last.at, false});
  };
}

}  // namespace taut::results
