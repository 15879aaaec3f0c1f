#include <fmt/format.h>

#include <algorithm>

#include "taut/base/number.hpp"
#include "taut/base/stretches.hpp"
#include "taut/calc/answers.hpp"
#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/units/display.hpp"

namespace taut::results {
namespace {

const Quantities<solve::BodyRow>& swept_body() {
  static const auto all = picked(solve::body_quantities(), {"x", "y", "z"});
  return all;
}

const Quantities<solve::RopeRow>& swept_rope() {
  static const auto all =
      joined(solve::rope_end_tensions(), picked(solve::rope_quantities(), {"T_max", "unstretched"}));
  return all;
}

/// Of the parameter, in its unit.
Quantities<solve::SweepPoint> swept_value(const Unit& unit) {
  return {{"value", "", unit, "of the parameter, in its own unit", &solve::SweepPoint::value}};
}

bool is_shown(const machine::Body& body) { return !body.free.empty() && !body.beam; }

/// Columns of a point: places of free bodies, and of each rope its tensions and its length.
std::vector<Column> columns_of(const study::SweepRun& run, const machine::Model& m) {
  std::vector<Column> columns;
  add_columns(columns, swept_value(run.unit));
  for (const machine::Body& body : m.bodies) {
    if (is_shown(body)) add_columns(columns, swept_body(), body.name + ".");
  }
  for (const machine::Reeving& r : m.reevings) add_columns(columns, swept_rope(), r.name + ".");
  return columns;
}

std::vector<Cell> row_of(const solve::SweepPoint& point) {
  std::vector<Cell> row;
  add_cells(row, swept_value(si::one), point);
  for (int b = 0; b < static_cast<int>(point.model.bodies.size()); ++b) {
    if (is_shown(point.model.bodies[b]))
      add_cells(row, swept_body(), {.model = point.model, .at = point.at, .body = b});
  }
  for (int i = 0; i < static_cast<int>(point.model.reevings.size()); ++i) {
    add_cells(row, swept_rope(), {.model = point.model, .at = point.at, .reeving = i});
  }
  return row;
}

std::string end_words(const study::SweepRun& run, const solve::Sweep& s) {
  const std::string value = Display().quantity(s.value, run.unit);
  switch (s.end) {
    case solve::SweepEnd::reached:
      return {};
    case solve::SweepEnd::interrupted:
      return fmt::format("was interrupted behind {} = {}", run.parameter, value);
    case solve::SweepEnd::no_machine:
      return fmt::format("ends at {} = {}: beyond, there is no such machine: {}", run.parameter, value,
                         s.outcome.message);
    case solve::SweepEnd::turning_point:
      return fmt::format(
          "ends at {} = {}, a turning point: the equilibrium turns back there and beyond the machine has none, or "
          "jumps "
          "to another: {}",
          run.parameter, value, s.outcome.message);
    case solve::SweepEnd::no_equilibrium:
      return fmt::format("ends at {} = {}: beyond, there is no equilibrium: {}", run.parameter, value,
                         s.outcome.message);
  }
  return {};
}

void add_plots(const study::SweepRun& run, const machine::Model& m, const solve::Sweep& s, Result& r) {
  const auto plot = [&](const std::string& name, const std::string& title, const Axis& y) {
    Plot p;
    p.name = name + run.ending;
    p.title = fmt::format("{} over {}", title, run.parameter);
    p.x = {.label = run.parameter, .unit = run.unit};
    p.y = y;
    return p;
  };
  const auto curve = [&](const std::string& label, auto&& of) {
    Curve c;
    c.label = label;
    for (const auto& point : s.points) {
      c.x.push_back(point.value);
      c.y.push_back(of(point));
    }
    return c;
  };
  Plot tensions = plot("sweep_tensions", "Largest tension of each rope", {.label = "tension", .unit = si::N});
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    tensions.curves.push_back(curve(m.reevings[i].name, [&](const auto& p) { return p.at.ropes[i].T_max; }));
  }
  if (s.end != solve::SweepEnd::reached) {
    tensions.marks.push_back({s.value, tensions.curves.front().y.back(), "ends", false});
  }
  r.figures.emplace_back(std::move(tensions));
  Plot heights =
      plot("sweep_heights", "Heights of the bodies that are free to move", {.label = "height", .unit = si::m});
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].free.empty() || m.bodies[b].beam) continue;
    heights.curves.push_back(curve(m.bodies[b].name, [&](const auto& p) { return p.at.state.bodies[b].position.z(); }));
  }
  if (!heights.curves.empty()) r.figures.emplace_back(std::move(heights));
}

/// The values that were asked for beyond the one where the sweep ends.
void note_values_lost(const study::SweepRun& run, const solve::Sweep& s, Result& r) {
  if (s.end == solve::SweepEnd::reached || s.end == solve::SweepEnd::interrupted) return;
  std::vector<std::string> lost;
  Stretches all;
  for (int i = 0; i <= run.steps; ++i) {
    const double value = step_between(run.from, run.to, i, run.steps);
    if ((value - s.value) * (run.to - run.from) <= 0) continue;
    lost.push_back(fmt::format("{} = {}", run.parameter, Display().quantity(value, run.unit)));
    all.take(s.outcome.message, lost.back(), {});
  }
  if (lost.empty()) return;
  r.missing.push_back({.analysis = fmt::format("sweep{}, {}", run.ending, run.words),
                       .missing = static_cast<int>(lost.size()),
                       .places = run.steps + 1,
                       .first = lost.front(),
                       .reason = s.outcome.message,
                       .all = all.places()});
}

/// How far the parameter goes, and the largest tension of each rope on the way.
void add_swept(const study::SweepRun& run, const solve::Sweep& s, const std::string& end, const Display& display,
               Result& r) {
  const auto shown = [&](double value) { return display.brief(value, run.unit); };
  std::vector<std::string> parts = {
      end.empty() ? fmt::format("{} from {} to {}", run.parameter, shown(s.points.front().value), shown(s.value))
                  : end};
  const machine::Model& m = s.points.front().model;
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    const auto most = std::max_element(s.points.begin(), s.points.end(), [&](const auto& a, const auto& b) {
      return a.at.ropes[i].T_max < b.at.ropes[i].T_max;
    });
    parts.push_back(fmt::format("{} up to {} at {}", m.reevings[i].name, display.brief(most->at.ropes[i].T_max, si::N),
                                shown(most->value)));
  }
  add_answer_line(r, "Sweep", parts);
}

void add_results(MachineRun& machine, const study::SweepRun& run, const solve::Sweep& s, Result& r) {
  if (s.points.empty() && s.end == solve::SweepEnd::interrupted) return;
  if (s.points.empty()) {
    study::note_failure(r, s.outcome,
                        fmt::format("sweep, {} = {}", run.parameter, Display().quantity(run.from, run.unit)));
    return;
  }
  const machine::Model& m = s.points.front().model;
  Table t{.name = "sweep" + run.ending,
          .title = fmt::format("Equilibrium over {}, {}", run.parameter, run.words),
          .columns = {},
          .rows = {}};
  t.columns = columns_of(run, m);
  for (const auto& point : s.points) {
    std::vector<Cell> row = row_of(point);
    row.resize(t.columns.size(), none);
    t.rows.push_back(std::move(row));
  }
  r.tables.push_back(std::move(t));
  const std::string words = end_words(run, s);
  r.values.push_back(make_value(named(value_kinds(), "sweep_end"), "", run.ending, s.value,
                                words.empty() ? fmt::format("last value of {}", run.parameter) : words));
  r.values.back().unit = run.unit;
  if (!words.empty()) r.warnings.push_back(fmt::format("the sweep {}", words));
  add_swept(run, s, words, machine.display, r);
  if (machine.checked->judged) note_values_lost(run, s, r);
  if (s.points.size() > 1) add_plots(run, m, s, r);
  const auto words_at = [&](double value) {
    return fmt::format("sweep, {} = {}, {}", run.parameter, Display().quantity(value, run.unit), run.words);
  };
  for (const auto& point : s.points) {
    const std::string at = words_at(point.value);
    if (!run.judged_apart) {
      machine.checked->take(point.model, point.at, at, checks::analysis_name(run.ending, "sweep"));
      continue;
    }
    machine.checked->take_values(point.model, point.at, at);
    // what is judged apart has no payload beside it
    if (machine.checked->judged) machine.checked->payloads.take(point.model, point.at, at);
  }
  if (run.judged_apart && machine.checked->judged) machine.judged_apart.push_back(run);
  const solve::SweepPoint& hardest = *std::max_element(
      s.points.begin(), s.points.end(),
      [](const auto& a, const auto& b) { return strain_of(a.model, a.at) < strain_of(b.model, b.at); });
  machine.others.push_back({.words = words_at(hardest.value),
                            .model = hardest.model,
                            .result = hardest.at,
                            .explores = true,
                            .judged = machine.checked->judged});
}

}  // namespace

std::vector<QuantityWords> sweep_words() {
  std::vector<QuantityWords> all = words_of(swept_value(si::one));
  for (const auto& q : swept_body()) all.push_back({"BODY." + q.about.name, "", q.about.unit, q.about.words});
  for (const auto& q : swept_rope()) all.push_back({"ROPE." + q.about.name, "", q.about.unit, q.about.words});
  return all;
}

void add_answer(const study::SweepRun& asked, MachineRun& machine, Result& r) {
  study::SweepRun run = asked;
  study::Watch watch(machine.progress, "sweep" + run.ending, run.steps + 1);
  study::solve(machine.model, run, watch);
  add_results(machine, run, run.answer, r);
  watch.note(r);
}

}  // namespace taut::results
