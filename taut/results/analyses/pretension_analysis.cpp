#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "taut/calc/answers.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/results/motion/transient_figures.hpp"
#include "taut/results/motion/transient_scene.hpp"
#include "taut/results/motion/transient_tables.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/deck/missing.hpp"

namespace taut::results {
namespace {

/// What the table has besides tensions: measures, and what the deck itself observes.
std::vector<std::size_t> reported_beside(const study::PretensionRun& run, const machine::Model& m,
                                         const std::vector<Column>& reported) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; run.answer.slowly && k < m.observed.size(); ++k) {
    const machine::Observable& o = m.observed[k];
    const bool measure = o.taken != machine::description::Taken::automatic;
    const bool known = std::any_of(reported.begin(), reported.end(), [&](const Column& c) { return c.name == o.name; });
    if ((measure || run.observes) && !known) all.push_back(k);
  }
  return all;
}

Table tensioning_table(const study::PretensionRun& run, const machine::Model& m) {
  std::vector<study::PullRow> rows = {{.step = 0, .pulled = "", .end = run.answer.before}};
  for (std::size_t i = 0; i < run.answer.ends.size(); ++i) {
    const study::Pull& pull = run.pulls[i % run.pulls.size()];
    rows.push_back({static_cast<double>(i + 1), m.reevings[pull.reeving].name, run.answer.ends[i]});
  }
  Table t =
      make_table("tensioning" + run.ending,
                 "Ropes pulled tight in turn: what each pull has taken out of its rope, and all tensions as it ends",
                 study::pull_quantities(), rows);
  for (const machine::Reeving& rope : m.reevings) add_columns(t.columns, solve::rope_end_tensions(), rope.name + ".");
  const std::vector<std::size_t> observed = reported_beside(run, m, t.columns);
  for (const std::size_t k : observed) add_columns(t.columns, {observed_words(m.observed[k].name, m.observed[k].unit)});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const study::PullEnd& end = rows[i].end;
    for (std::size_t k = 0; k < end.T_start.size(); ++k) {
      t.rows[i].emplace_back(end.T_start[k]);
      t.rows[i].emplace_back(end.T_end[k]);
    }
    for (const std::size_t k : observed) t.rows[i].emplace_back(end.observed[k]);
  }
  return t;
}

/// Measures by step, and of each rope what it has at the end: its tensions, its length, what was taken out.
void add_pretension_values(const study::PretensionRun& run, const machine::Model& m, const Display& display,
                           Result& r) {
  const std::string of = run.words;
  for (std::size_t i = 0; run.answer.slowly && i < run.answer.ends.size(); ++i) {
    for (std::size_t k = 0; k < m.observed.size(); ++k) {
      if (m.observed[k].taken == machine::description::Taken::automatic) continue;
      r.values.push_back(make_value(named(value_kinds(), "MEASURE"), fmt::format("{}_{}", m.observed[k].name, i + 1),
                                    run.ending, run.answer.ends[i].observed[k],
                                    fmt::format("{} as pull {} ends ({})", m.observed[k].name, i + 1, of)));
      r.values.back().unit = m.observed[k].unit;
      r.values.back().detail = true;
    }
  }
  std::vector<std::string> parts;
  std::set<int> pulled;
  for (const study::Pull& pull : run.pulls) pulled.insert(pull.reeving);
  const study::PullEnd& last = run.answer.ends.back();
  for (const int i : pulled) {
    const std::string& name = m.reevings[i].name;
    double taken = 0;
    for (std::size_t k = 0; k < run.answer.ends.size(); ++k) {
      if (run.pulls[k % run.pulls.size()].reeving == i) taken = run.answer.ends[k].taken_in_all;
    }
    const auto add = [&](const char* what, double value) {
      const ValueKind& kind = named(value_kinds(), what);
      r.values.push_back(
          make_value(kind, name, run.ending, value, fmt::format("{} of {} ({})", kind.about.words, name, of)));
    };
    add("ROPE.pretension_T_start", last.T_start[i]);
    add("ROPE.pretension_T_end", last.T_end[i]);
    add("ROPE.pretension_length", last.unstretched[i]);
    add("ROPE.pretension_taken_out", taken);
    parts.push_back(fmt::format("{} {} at its start, {} at its end, {} taken out", name,
                                display.brief(last.T_start[i], si::N), display.brief(last.T_end[i], si::N),
                                display.brief(taken, si::m.in("mm"))));
  }
  if (!run.ending.empty() && !parts.empty()) parts.front() = fmt::format("{}: {}", run.ending.substr(1), parts.front());
  add_answer_line(r, "Pretension", parts);
}

Plot tensioning_plot(const study::PretensionRun& run, const machine::Model& m) {
  Plot p;
  p.name = "tensioning_over_pulls" + run.ending;
  p.title = fmt::format("Tensions as each pull ends ({})", run.words);
  p.x = {.label = "pull", .unit = si::one};
  p.y = {.label = "tension", .unit = si::N};
  std::set<std::pair<int, bool>> ends;
  for (const study::Pull& pull : run.pulls) ends.insert({pull.reeving, pull.at_end});
  for (const auto& [rope, at_end] : ends) {
    Curve c;
    c.label = fmt::format("{} at its {}", m.reevings[rope].name, at_end ? "end" : "start");
    const auto add = [&c, of = rope, last = at_end](double step, const study::PullEnd& end) {
      c.x.push_back(step);
      c.y.push_back(last ? end.T_end[of] : end.T_start[of]);
    };
    add(0, run.answer.before);
    for (std::size_t i = 0; i < run.answer.ends.size(); ++i) add(static_cast<double>(i + 1), run.answer.ends[i]);
    p.curves.push_back(std::move(c));
  }
  return p;
}

/// A machine that is pulled slowly: before any pull and as each ends, the last one drawn.
void add_pretension_scene(const study::PretensionRun& run, MachineRun& machine, Result& r) {
  study::TransientRun slow;
  slow.ending = "_pretension" + run.ending;
  slow.model = machine.model;
  slow.result.frames = run.answer.frames;
  Drawing drawing = drawing_at(slow, run.answer.frames.size() - 1,
                               fmt::format("As pull {} ends ({})", run.answer.ends.size(), run.words));
  machine.key_figure.offer(Pictured::machine, drawing.name);
  r.figures.emplace_back(std::move(drawing));
  r.scenes.push_back(scene_of(slow));
}

std::string how_words(const study::PretensionRun& run) {
  if (!run.answer.slowly)
    return "an equilibrium at rest as each pull ends: without loss, the band of friction in checks";
  const bool settled = run.options.start == solve::Start::settled;
  return fmt::format("slowly, with all friction carried on from pull to pull; starts {}; events and drives stand still",
                     settled ? "settled: at rest in equilibrium, ropes without loss, contacts holding what they can"
                             : "assembled: as described, friction holding what it can");
}

}  // namespace

std::vector<QuantityWords> tensioning_words() {
  std::vector<QuantityWords> all = words_of(study::pull_quantities());
  for (QuantityWords& one : prefixed("ROPE.", words_of(solve::rope_end_tensions()))) all.push_back(std::move(one));
  all.push_back(observed_words("OBSERVED", si::one));
  return all;
}

void add_answer(const study::PretensionRun& asked, MachineRun& machine, Result& r) {
  if (r.interrupted) return;
  study::PretensionRun run = asked;
  const std::string analysis = checks::analysis_name(run.ending, "pretension");
  const auto go_on = [&](std::size_t i, std::size_t count) {
    return !machine.progress || machine.progress({.what = run.words,
                                                  .done = static_cast<double>(i) / static_cast<double>(count),
                                                  .words = fmt::format("pull {} of {}", i + 1, count)});
  };
  if (machine.checked->judged) machine.checked->judge.begin_pieces();
  study::solve(machine.model, run, go_on, [&](const machine::Model& model, const solve::TransientResult& motion) {
    for (const solve::TransientFrame& frame : motion.frames)
      machine.checked->take_moment(model, motion, frame, run.words, analysis, true);
    machine.checked->take(model, motion, run.words, {.slowly = true, .complete = true});
  });
  if (machine.checked->judged) machine.checked->judge.end_pieces(run.words);
  const study::PretensionResult& result = run.answer;
  if (result.interrupted) {
    r.interrupted = true;
    r.status = Status::not_converged;
    r.message = fmt::format("{}: interrupted after pull {}", run.words, result.ends.size());
  }
  study::note_failure(r, result.outcome, run.words);
  if (result.ends.empty()) return;
  r.tables.push_back(tensioning_table(run, machine.model));
  add_pretension_values(run, machine.model, machine.display, r);
  r.figures.emplace_back(tensioning_plot(run, machine.model));
  r.assumptions.push_back(fmt::format("{}: {}.", run.words, how_words(run)));
  if (result.slowly) add_pretension_scene(run, machine, r);
  for (const study::PullEnd& end : result.ends) {
    if (end.at) machine.checked->take(result.model, *end.at, run.words, analysis);
  }
  const study::PullEnd& last = result.ends.back();
  machine.checked->take_pretension(last.T_start, last.T_end, fmt::format("as pulled ({})", run.words));
  if (last.at) machine.others.push_back({run.words, result.model, *last.at, false});
}

}  // namespace taut::results
