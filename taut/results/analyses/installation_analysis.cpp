#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/missing.hpp"
#include "taut/study/installation.hpp"
#include "taut/study/temperature.hpp"

namespace taut::results {
namespace {

using Kind = solve::Condition::Kind;

struct InstallationRun {
  std::string ending;
  std::string words;
  int reeving = 0;
  std::vector<double> temperatures;  ///< K; empty: the machine's, whatever it is
  std::optional<study::InstallationGivenRequest> given;
  const machine::Machine* machine = nullptr;
};

/// One row of the table.
struct Row {
  double temperature = none;
  study::Installation at;
};

/// The free span with the longest chord: sags refer to it when the deck names none.
int longest_span(const study::EmptyLine& line) {
  const machine::State state = machine::initial_state(line.model);
  const auto& nodes = line.model.reevings[line.reeving].nodes;
  int longest = 0;
  double most = -1;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const double chord = (machine::in_ground(state, nodes[k + 1].at) - machine::in_ground(state, nodes[k].at)).norm();
    if (chord <= most) continue;
    most = chord;
    longest = static_cast<int>(k);
  }
  return longest;
}

/// What the machine itself has given of the rope.
solve::Condition own_condition(const machine::Reeving& rope) {
  switch (rope.given) {
    case machine::Given::tension_at_start:
      return {Kind::tension_at_start, 0, rope.value, 0};
    case machine::Given::tension_at_end:
      return {Kind::tension_at_end, 0, rope.value, 0};
    case machine::Given::length:
    case machine::Given::torque:
      break;
  }
  return {Kind::length, 0, rope.value, 0};
}

solve::Condition condition_of(const InstallationRun& run, const study::EmptyLine& line) {
  if (!run.given) return own_condition(line.model.reevings[line.reeving]);
  const study::InstallationGivenRequest& g = *run.given;
  if (g.tension) return {g.at == study::RopeEnd::end ? Kind::tension_at_end : Kind::tension_at_start, 0, *g.tension, 0};
  if (g.length) return {Kind::length, 0, *g.length, 0};
  return {Kind::sag_of_span, 0, *g.sag, g.span ? *g.span - 1 : longest_span(line)};
}

std::vector<Row> solve(const machine::Model& model, const InstallationRun& run) {
  const auto line_at = [&](double temperature) {
    machine::Model warm = model;
    if (!std::isnan(temperature)) study::set_temperature(warm, *run.machine, temperature);
    return study::empty_line(warm, run.reeving);
  };
  std::vector<double> temperatures = run.temperatures;
  if (temperatures.empty()) temperatures.push_back(run.machine->temperature.value_or(none));
  study::EmptyLine first = line_at(temperatures.front());
  std::vector<Row> rows;
  if (!first.outcome.ok()) {
    rows.emplace_back().at.outcome = first.outcome;
    return rows;
  }
  solve::Condition condition = condition_of(run, first);
  std::optional<machine::State> near;
  if (run.given && run.given->temperature) {
    const auto there = study::installation(line_at(*run.given->temperature), condition);
    if (!there.outcome.ok()) {
      rows.emplace_back(Row{*run.given->temperature, there});
      return rows;
    }
    condition = {Kind::length, 0, there.unstretched, 0};
    near = there.at.result.state;
  }
  for (const double temperature : temperatures) {
    Row& row = rows.emplace_back();
    row.temperature = temperature;
    row.at = study::installation(line_at(temperature), condition, near);
    if (row.at.outcome.ok()) near = row.at.at.result.state;
  }
  return rows;
}

std::string words_of(const Row& row, const InstallationRun& run) {
  return std::isnan(row.temperature)
             ? fmt::format("installation of {}", run.words)
             : fmt::format("installation of {} at {}", run.words, study::celsius(row.temperature));
}

/// "sag_1" and so on, with the span's ends in the title.
Table table_of(const InstallationRun& run, const std::vector<Row>& rows, const study::Installation& any) {
  const auto& result = any.at.result;
  const auto reeving = std::find_if(any.at.model.reevings.begin(), any.at.model.reevings.end(),
                                    [&](const machine::Reeving& r) { return r.name == run.words; });
  const auto index = static_cast<int>(reeving - any.at.model.reevings.begin());
  Table t{"installation" + run.ending, "", {}, {}};
  t.columns = {{"temperature", si::K.in("degC")},
               {"T_start", si::N},
               {"T_end", si::N},
               {"H", si::N},
               {"unstretched", si::m},
               {"installed", si::m},
               {"stretched", si::m}};
  std::string spans;
  int n = 0;
  for (const auto& s : result.spans) {
    if (s.reeving != index) continue;
    t.columns.push_back({fmt::format("sag_{}", ++n), si::m});
    spans +=
        fmt::format("{}{}: {} to {}", n == 1 ? "" : ", ", n, reeving->nodes[s.from].name, reeving->nodes[s.to].name);
  }
  t.title = fmt::format(
      "Installation of {}, empty; lengths: at the reference temperature, as cut at this one, under "
      "load; sags at half of span {}",
      run.words, spans);
  for (const Row& row : rows) {
    std::vector<Cell> cells = {row.temperature};
    if (row.at.outcome.ok()) {
      cells.insert(cells.end(),
                   {row.at.T_start, row.at.T_end, row.at.H, row.at.unstretched, row.at.cut, row.at.stretched});
      for (const double sag : row.at.sag) cells.emplace_back(sag);
    }
    cells.resize(t.columns.size(), none);
    t.rows.push_back(std::move(cells));
  }
  return t;
}

/// Unstretched rope on the drums at its ends: what the deck has there, and what the line does not need of its length.
/// NaN: the deck does not say.
double on_drums(const machine::Machine& machine, const std::string& rope, double unstretched) {
  const auto reeving = std::find_if(machine.reevings.begin(), machine.reevings.end(),
                                    [&](const auto& one) { return one.name.value_or(one.rope) == rope; });
  if (reeving == machine.reevings.end()) return none;
  double content = none;
  for (const auto* end : {&reeving->path.front(), &reeving->path.back()}) {
    const auto drum = std::find_if(machine.drums.begin(), machine.drums.end(),
                                   [&](const auto& one) { return end->drum && one.name == *end->drum; });
    if (drum == machine.drums.end() || !drum->length_on_drum) continue;
    content = (std::isnan(content) ? 0 : content) + *drum->length_on_drum;
  }
  return reeving->length ? content + *reeving->length - unstretched : none;
}

/// All ropes of the state in which the table's first row is, by their lengths.
Table lengths_table(const InstallationRun& run, const Row& row) {
  Table t{"lengths" + run.ending,
          fmt::format("Lengths of all ropes that are up ({}): at the reference temperature, as cut, under load, and of "
                      "that between and on sheaves; unstretched on drums",
                      words_of(row, run)),
          {{"rope", si::one},
           {"unstretched", si::m},
           {"installed", si::m},
           {"stretched", si::m},
           {"free", si::m},
           {"on_sheaves", si::m},
           {"copies", si::one},
           {"on_drums", si::m}},
          {}};
  const machine::Model& m = row.at.at.model;
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    const auto l = study::lengths_of(m, row.at.at.result, static_cast<int>(i));
    t.rows.push_back({m.reevings[i].name, l.unstretched, l.cut, l.stretched, l.free, l.on_sheaves,
                      static_cast<double>(m.reevings[i].copies),
                      on_drums(*run.machine, m.reevings[i].name, l.unstretched)});
  }
  return t;
}

template <class Of>
Plot plot_of(const InstallationRun& run, const std::vector<Row>& rows, const std::string& name, std::string title,
             const Axis& y, const std::vector<std::pair<std::string, Of>>& curves) {
  Plot p;
  p.name = name + run.ending;
  p.title = std::move(title);
  p.x = {"temperature", si::K.in("degC")};
  p.y = y;
  for (const auto& [label, of] : curves) {
    Curve c;
    c.label = label;
    for (const Row& row : rows) {
      c.x.push_back(row.temperature);
      c.y.push_back(row.at.outcome.ok() ? of(row.at) : none);
    }
    p.curves.push_back(std::move(c));
  }
  return p;
}

void add_plots(const InstallationRun& run, const std::vector<Row>& rows, std::size_t spans, Result& r) {
  using Of = std::function<double(const study::Installation&)>;
  r.figures.emplace_back(plot_of<Of>(run, rows, "installation_tension", fmt::format("Tension of {}, empty", run.words),
                                     {"tension", si::N},
                                     {{"at its start", [](const auto& i) { return i.T_start; }},
                                      {"at its end", [](const auto& i) { return i.T_end; }}}));
  std::vector<std::pair<std::string, Of>> sags;
  sags.reserve(spans);
  for (std::size_t k = 0; k < spans; ++k) {
    sags.emplace_back(fmt::format("span {}", k + 1), [k](const auto& i) { return i.sag[k]; });
  }
  r.figures.emplace_back(plot_of<Of>(run, rows, "installation_sag",
                                     fmt::format("Sag of {} at half its spans, empty", run.words), {"sag", si::m},
                                     sags));
  const auto ok = [](const Row& row) { return row.at.outcome.ok(); };
  const auto first = std::find_if(rows.begin(), rows.end(), ok);
  const bool same = std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    return !ok(row) || std::abs(row.at.unstretched - first->at.unstretched) < 1e-9 * first->at.unstretched;
  });
  if (same) return;
  r.figures.emplace_back(plot_of<Of>(
      run, rows, "installation_length", fmt::format("Length of {} to be installed", run.words), {"length", si::m},
      {{"unstretched, at the reference temperature", [](const auto& i) { return i.unstretched; }},
       {"as cut at this temperature", [](const auto& i) { return i.cut; }}}));
}

void add_results(const InstallationRun& run, const std::vector<Row>& rows, bool judged, Result& r) {
  Missing missing;
  for (const Row& row : rows) missing.take(row.at.outcome, words_of(row, run));
  missing.note(r, "installation" + run.ending, judged);
  const auto first = std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.at.outcome.ok(); });
  if (first == rows.end()) return;
  const auto value = [&](const char* name, double v, const Unit& unit, const char* words) {
    r.values.push_back({fmt::format("{}.{}{}", run.words, name, run.ending),
                        v,
                        unit,
                        fmt::format("{}.{}", run.words, name),
                        fmt::format("{}, {}", words, words_of(*first, run)),
                        {}});
  };
  value("install_T_start", first->at.T_start, si::N, "tension at its start");
  value("install_T_end", first->at.T_end, si::N, "tension at its end");
  value("install_length", first->at.cut, si::m, "length as cut");
  r.tables.push_back(table_of(run, rows, first->at));
  r.tables.push_back(lengths_table(run, *first));
  if (rows.size() > 1) add_plots(run, rows, first->at.sag.size(), r);
}

void resolve_temperatures(const study::InstallationRequest& request, const std::string& path, Preparation& p,
                          InstallationRun& run) {
  run.temperatures = request.temperatures;
  if (request.from.has_value() != request.to.has_value() || (request.steps && !request.from)) {
    p.complaints.push_back({path, "'from' and 'to' belong together, with or without 'steps'"});
  } else if (request.from && !request.temperatures.empty()) {
    p.complaints.push_back({path + ".from", "give either 'temperatures' or 'from' and 'to'"});
  } else if (request.from) {
    const int steps = request.steps.value_or(10);
    for (int i = 0; i <= steps; ++i) {
      run.temperatures.push_back(*request.from + (*request.to - *request.from) * i / steps);
    }
  }
  const std::string key = request.from ? ".from" : ".temperatures";
  if (!run.temperatures.empty()) study::require_references(p.machine, path + key, p.complaints);
  if (request.given && request.given->temperature) {
    study::require_references(p.machine, path + ".given.temperature", p.complaints);
  }
}

}  // namespace

Analysis prepare_installation(const study::InstallationRequest& request, const std::string& path, Preparation& p) {
  const auto run = std::make_shared<InstallationRun>();
  run->ending = ending_of(p, "installation", request.name, path);
  run->words = request.reeving;
  run->reeving = reeving_of(p, request.reeving, path + ".reeving");
  run->given = request.given;
  run->machine = &p.machine;
  resolve_temperatures(request, path, p, *run);
  if (run->reeving < 0) return {};
  const study::EmptyLine line = study::empty_line(p.model, run->reeving);
  if (!line.outcome.ok()) p.complaints.push_back({path + ".reeving", line.outcome.message});
  if (p.model.reevings[run->reeving].closed && request.given && !request.given->length) {
    p.complaints.push_back({path + ".given", "an endless rope is given by its 'length'"});
  }
  if (p.model.reevings[run->reeving].given == machine::Given::torque && !request.given) {
    p.complaints.push_back({path, "the rope is given by a torque: say what is given when it is put up"});
  }
  if (request.given && request.given->span) {
    const auto spans = line.model.reevings[line.reeving].nodes.size() - 1;
    if (!request.given->sag) p.complaints.push_back({path + ".given.span", "belongs to a 'sag'"});
    if (line.outcome.ok() && static_cast<std::size_t>(*request.given->span) > spans) {
      p.complaints.push_back({path + ".given.span", fmt::format("the empty rope has {} free spans", spans)});
    }
  }
  return [run](MachineRun& machine, Result& r) {
    const std::vector<Row> rows = solve(machine.model, *run);
    add_results(*run, rows, machine.checked->judged, r);
    for (const Row& row : rows) {
      if (!row.at.outcome.ok()) continue;
      machine.checked->take_empty(row.at.at.model, row.at.at.result, run->words, words_of(row, *run));
    }
  };
}

}  // namespace taut::results
