#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/machine/compile.hpp"
#include "taut/machine/compile/carriage_span.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/put_up.hpp"
#include "taut/solve/continuation.hpp"
#include "taut/study/carriage_way.hpp"
#include "taut/study/parameter.hpp"
#include "taut/study/temperature.hpp"
#include "taut/study/watch.hpp"
#include "taut/units/display.hpp"
#include "taut/units/parse.hpp"

namespace taut::results {
namespace {

using solve::SweepEnd;

struct SweepRun {
  std::string ending;
  std::string words;
  std::string parameter;
  Unit unit;
  std::vector<study::MotionRequest> motion;
  std::optional<machine::Prescribed> prescribed;
  double from = 0, to = 0;
  int steps = 1;
  bool held = false;
  const machine::Machine* machine = nullptr;
};

/// Guys put up once keep their lengths while loads, ropes' lengths and the temperature change; where the machine is
/// built otherwise they are put up anew. Lines that are put up (`install:`) are so at every value, as in a deck with
/// that value; while the temperature changes they keep their lengths.
bool changes_the_building(const std::string& parameter) {
  const std::string below = parameter.starts_with("machine.") ? parameter.substr(8) : parameter;
  for (const char* kind : {"points", "sheaves", "supports", "guys", "ropes", "gravity"}) {
    if (below.starts_with(kind)) return true;
  }
  return false;
}

std::string below_machine(const std::string& parameter) {
  return parameter.starts_with("machine.") ? parameter.substr(8) : parameter;
}

tl::expected<machine::Model, Outcome> model_at(const SweepRun& run, const machine::Model& installed, double value) {
  if (below_machine(run.parameter) == "temperature") {
    machine::Model warm = installed;
    study::set_temperature(warm, *run.machine, value);
    return warm;
  }
  machine::Machine machine = *run.machine;
  const auto parameter = study::find_parameter(machine::Machine::describe(), &machine, run.parameter);
  if (!parameter) return tl::unexpected(infeasible(parameter.error()));
  if (!parameter->field->range.contains(value) && !(parameter->unit.is_angle && !parameter->field->unit.is_angle)) {
    return tl::unexpected(infeasible(fmt::format("'{}' must be {}", run.parameter, range_text(*parameter->field))));
  }
  parameter->set(value);
  auto model = machine::compile(machine);
  if (!model) return tl::unexpected(infeasible(model.error().front().message));
  const std::size_t guys = machine.reevings.size();
  if (changes_the_building(run.parameter)) {
    const Outcome outcome = install_guys(machine, *model);
    if (!outcome.ok()) return tl::unexpected(outcome);
  } else {
    for (std::size_t i = guys; i < model->reevings.size(); ++i) {
      model->reevings[i].given = installed.reevings[i].given;
      model->reevings[i].value = installed.reevings[i].value;
    }
  }
  std::vector<study::PutUpLine> lines;
  if (const Outcome outcome = put_up_lines(*model, lines); !outcome.ok()) return tl::unexpected(outcome);
  if (run.prescribed)
    *model = machine::with_carriage_at(*model, run.prescribed->carriage, run.prescribed->x, run.prescribed->along);
  return *model;
}

/// Columns of a point: places of free bodies, and of each rope its tensions and its length.
std::vector<Column> columns_of(const machine::Model& m) {
  std::vector<Column> columns;
  for (const machine::Body& body : m.bodies) {
    if (body.free.empty() || body.beam >= 0) continue;
    for (const char* axis : {"x", "y", "z"}) columns.push_back({fmt::format("{}.{}", body.name, axis), si::m});
  }
  for (const machine::Reeving& r : m.reevings) {
    columns.push_back({fmt::format("{}.T_start", r.name), si::N});
    columns.push_back({fmt::format("{}.T_end", r.name), si::N});
    columns.push_back({fmt::format("{}.T_max", r.name), si::N});
    columns.push_back({fmt::format("{}.unstretched", r.name), si::m});
  }
  return columns;
}

std::vector<Cell> row_of(const solve::SweepPoint& point) {
  std::vector<Cell> row;
  for (std::size_t b = 0; b < point.model.bodies.size(); ++b) {
    if (point.model.bodies[b].free.empty() || point.model.bodies[b].beam >= 0) continue;
    const Vector3& p = point.at.state.bodies[b].position;
    row.insert(row.end(), {p.x(), p.y(), p.z()});
  }
  for (int i = 0; i < static_cast<int>(point.model.reevings.size()); ++i) {
    const auto own = [&](const auto& s) { return s.reeving == i; };
    const auto first = std::find_if(point.at.spans.begin(), point.at.spans.end(), own);
    const auto last = std::find_if(point.at.spans.rbegin(), point.at.spans.rend(), own);
    const auto& rope = point.at.ropes[i];
    row.insert(row.end(), {first->T_from, last->T_to, rope.T_max, rope.unstretched});
  }
  return row;
}

std::string end_words(const SweepRun& run, const solve::Sweep& s) {
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

void add_plots(const SweepRun& run, const machine::Model& m, const solve::Sweep& s, Result& r) {
  const auto plot = [&](const std::string& name, const std::string& title, const Axis& y) {
    Plot p;
    p.name = name + run.ending;
    p.title = fmt::format("{} over {}", title, run.parameter);
    p.x = {run.parameter, run.unit};
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
  Plot tensions = plot("sweep_tensions", "Largest tension of each rope", {"tension", si::N});
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    tensions.curves.push_back(curve(m.reevings[i].name, [&](const auto& p) { return p.at.ropes[i].T_max; }));
  }
  if (s.end != solve::SweepEnd::reached) {
    tensions.marks.push_back({s.value, tensions.curves.front().y.back(), "ends", false});
  }
  r.figures.emplace_back(std::move(tensions));
  Plot heights = plot("sweep_heights", "Heights of the bodies that are free to move", {"height", si::m});
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].free.empty() || m.bodies[b].beam >= 0) continue;
    heights.curves.push_back(curve(m.bodies[b].name, [&](const auto& p) { return p.at.state.bodies[b].position.z(); }));
  }
  if (!heights.curves.empty()) r.figures.emplace_back(std::move(heights));
}

/// The values that were asked for beyond the one where the sweep ends.
void note_values_lost(const SweepRun& run, const solve::Sweep& s, Result& r) {
  if (s.end == solve::SweepEnd::reached || s.end == solve::SweepEnd::interrupted) return;
  int lost = 0;
  double first = run.to;
  for (int i = run.steps; i >= 0; --i) {
    const double value = run.from + (run.to - run.from) * i / run.steps;
    if ((value - s.value) * (run.to - run.from) <= 0) break;
    first = value;
    ++lost;
  }
  if (lost == 0) return;
  r.missing.push_back({fmt::format("sweep{}, {}", run.ending, run.words), lost, run.steps + 1,
                       fmt::format("{} = {}", run.parameter, Display().quantity(first, run.unit)), s.outcome.message});
}

void add_results(MachineRun& machine, const SweepRun& run, const solve::Sweep& s, Result& r) {
  if (s.points.empty() && s.end == solve::SweepEnd::interrupted) return;
  if (s.points.empty()) {
    note_failure(r, s.outcome, fmt::format("sweep, {} = {}", run.parameter, Display().quantity(run.from, run.unit)));
    return;
  }
  const machine::Model& m = s.points.front().model;
  Table t{"sweep" + run.ending, fmt::format("Equilibrium over {}, {}", run.parameter, run.words), {}, {}};
  t.columns = columns_of(m);
  t.columns.insert(t.columns.begin(), {"value", run.unit});
  for (const auto& point : s.points) {
    std::vector<Cell> row = row_of(point);
    row.insert(row.begin(), point.value);
    row.resize(t.columns.size(), none);
    t.rows.push_back(std::move(row));
  }
  r.tables.push_back(std::move(t));
  const std::string words = end_words(run, s);
  r.values.push_back({"sweep_end" + run.ending,
                      s.value,
                      run.unit,
                      "end",
                      words.empty() ? fmt::format("last value of {}", run.parameter) : words,
                      {}});
  if (!words.empty()) r.warnings.push_back(fmt::format("the sweep {}", words));
  if (machine.checked->judged) note_values_lost(run, s, r);
  if (s.points.size() > 1) add_plots(run, m, s, r);
  for (const auto& point : s.points) {
    const std::string at =
        fmt::format("sweep, {} = {}, {}", run.parameter, Display().quantity(point.value, run.unit), run.words);
    machine.checked->take(point.model, point.at, at, checks::analysis_name(run.ending, "sweep"));
  }
  const solve::SweepPoint& first = s.points.front();
  machine.others.push_back(
      {fmt::format("{} = {}, {}", run.parameter, Display().quantity(first.value, run.unit), run.words), first.model,
       first.at, true});
}

void resolve_values(const study::SweepRequest& request, const std::string& path, Preparation& p, SweepRun& run) {
  machine::Machine machine = p.machine;
  const auto parameter = study::find_parameter(machine::Machine::describe(), &machine, request.parameter);
  if (!parameter) {
    p.complaints.push_back({path + ".parameter", parameter.error()});
    return;
  }
  run.unit = parameter->unit;
  if (std::isnan(parameter->value) && below_machine(request.parameter) != "temperature") {
    p.complaints.push_back({path + ".parameter", fmt::format("'{}' has no value in the deck that could change: write "
                                                             "one there",
                                                             request.parameter)});
  }
  const auto read = [&](const std::string& text, const char* key, double& value) {
    const auto number = parse_quantity(text, parameter->unit);
    if (!number) {
      p.complaints.push_back({fmt::format("{}.{}", path, key), number.error().message});
    } else {
      value = *number;
      const bool own = parameter->unit.is_angle == parameter->field->unit.is_angle;
      if (own && !parameter->field->range.contains(value)) {
        p.complaints.push_back(
            {fmt::format("{}.{}", path, key), fmt::format("must be {}, not {}", range_text(*parameter->field), text)});
      }
    }
  };
  read(request.from, "from", run.from);
  read(request.to, "to", run.to);
  if (run.from == run.to) p.complaints.push_back({path + ".to", "is the same value as 'from'"});
  if (below_machine(request.parameter) == "temperature") {
    study::require_references(p.machine, path + ".parameter", p.complaints);
  }
}

}  // namespace

Analysis prepare_sweep(const study::SweepRequest& request, const std::string& path, Preparation& p) {
  const auto run = std::make_shared<SweepRun>();
  run->ending = ending_of(p, "sweep", request.name, path);
  run->words = words_of(request.motion);
  run->parameter = request.parameter;
  run->motion = request.motion;
  run->steps = request.steps;
  run->held = request.held;
  run->machine = &p.machine;
  study::options_of(request.motion, p.model, path + ".motion", p.complaints);
  resolve_values(request, path, p, *run);
  run->prescribed = prescribed_of(request.carriage, request.x, request.along, path, p);
  return [run](MachineRun& machine, Result& r) {
    std::vector<Complaint> reported_before;
    machine::Model base = machine.model;
    if (run->prescribed)
      base = machine::with_carriage_at(base, run->prescribed->carriage, run->prescribed->x, run->prescribed->along);
    solve::SweepOptions options;
    options.from = run->from;
    options.to = run->to;
    options.steps = run->steps;
    options.equilibrium = study::options_of(run->motion, base, {}, reported_before);
    options.equilibrium.prescribed = run->prescribed;
    options.equilibrium.held = run->held;
    const auto at = [&](double value) { return model_at(*run, base, value); };
    study::Watch watch(machine.progress, "sweep" + run->ending, run->steps + 1);
    options.go_on = [&](double value) {
      return watch.go_on(fmt::format("{} = {}", run->parameter, Display().quantity(value, run->unit)));
    };
    add_results(machine, *run, solve::sweep(at, options), r);
    watch.note(r);
  };
}

}  // namespace taut::results
