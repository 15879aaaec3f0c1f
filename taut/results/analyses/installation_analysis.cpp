#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/calc/answers.hpp"
#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/study/deck/temperature.hpp"

namespace taut::results {
namespace {

using study::InstallationRun;
using Row = study::InstallationAt;

std::string words_of(const Row& row, const InstallationRun& run) {
  return std::isnan(row.temperature)
             ? fmt::format("installation of {}", run.words)
             : fmt::format("installation of {} at {}", run.words, study::celsius(row.temperature));
}

QuantityWords sag_of_span(const std::string& number) {
  return {.name = "sag_" + number, .symbol = "f", .unit = si::m, .words = "sag of span N at its half"};
}

/// "sag_1" and so on, with the span's ends in the title.
Table installation_table(const InstallationRun& run, const study::Installation& any) {
  const machine::Model& m = any.at.model;
  const auto reeving = std::find_if(m.reevings.begin(), m.reevings.end(),
                                    [&](const machine::Reeving& r) { return r.name == run.words; });
  const auto index = static_cast<int>(reeving - m.reevings.begin());
  Table t{.name = "installation" + run.ending, .title = "", .columns = {}, .rows = {}};
  add_columns(t.columns, study::installation_quantities());
  std::string spans;
  int n = 0;
  for (const auto& s : any.at.result.branches) {
    if (s.reeving != index) continue;
    add_columns(t.columns, {sag_of_span(std::to_string(++n))});
    spans +=
        fmt::format("{}{}: {} to {}", n == 1 ? "" : ", ", n, reeving->nodes[s.from].name, reeving->nodes[s.to].name);
  }
  t.title = fmt::format(
      "Installation of {}, empty; lengths: at the reference temperature, as cut at this one, under "
      "load; sags at half of span {}",
      run.words, spans);
  for (const Row& row : run.rows) {
    std::vector<Cell>& cells = t.rows.emplace_back();
    add_cells(cells, study::installation_quantities(), row);
    if (row.at.outcome.ok()) cells.insert(cells.end(), row.at.sag.begin(), row.at.sag.end());
    cells.resize(t.columns.size(), none);
  }
  return t;
}

/// Unstretched rope on the drums at its ends: what the deck has there, and what the line does not need of its length.
/// NaN: the deck does not say.
double on_drums(const machine::Machine& machine, const std::string& rope, double unstretched) {
  const auto reeving = std::find_if(machine.reevings.begin(), machine.reevings.end(),
                                    [&](const auto& one) { return name_of(one) == rope; });
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

/// One rope of the state in which the table's first row is.
struct LengthsRow {
  const InstallationRun& run;
  const machine::Reeving& rope;
  study::RopeLengths lengths;
};

const Quantities<LengthsRow>& lengths_of_ropes() {
  static const Quantities<LengthsRow> all = [] {
    Quantities<LengthsRow> quantities = {
        {"rope", "", si::one, "the rope", [](const LengthsRow& r) { return r.rope.name; }}};
    for (const auto& q : study::length_quantities()) {
      quantities.emplace_back(q.about.name, q.about.symbol, q.about.unit, q.about.words,
                              [of = q.of](const LengthsRow& r) { return of(r.lengths); });
    }
    quantities.emplace_back("copies", "n", si::one, "ropes side by side, each of these lengths",
                            [](const LengthsRow& r) { return static_cast<double>(r.rope.copies); });
    quantities.emplace_back(
        "on_drums", "", si::m, "unstretched rope on its drums, where the deck has a length_on_drum",
        [](const LengthsRow& r) { return on_drums(*r.run.machine, r.rope.name, r.lengths.unstretched); });
    return quantities;
  }();
  return all;
}

/// All ropes of the state in which the table's first row is, by their lengths.
Table lengths_table(const InstallationRun& run, const Row& row) {
  const machine::Model& m = row.at.at.model;
  std::vector<LengthsRow> rows;
  rows.reserve(m.reevings.size());
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    rows.push_back({run, m.reevings[i], study::lengths_of(m, row.at.at.result, static_cast<int>(i))});
  }
  return make_table("lengths" + run.ending,
                    fmt::format("Lengths of all ropes that are up ({}): at the reference temperature, as cut, under "
                                "load, and of that between and on sheaves; unstretched on drums",
                                words_of(row, run)),
                    lengths_of_ropes(), rows);
}

template <class Of>
Plot plot_of(const InstallationRun& run, const std::string& name, std::string title, const Axis& y,
             const std::vector<std::pair<std::string, Of>>& curves) {
  Plot p;
  p.name = name + run.ending;
  p.title = std::move(title);
  p.x = {.label = "temperature", .unit = si::K.in("degC")};
  p.y = y;
  for (const auto& [label, of] : curves) {
    Curve c;
    c.label = label;
    for (const Row& row : run.rows) {
      c.x.push_back(row.temperature);
      c.y.push_back(row.at.outcome.ok() ? of(row.at) : none);
    }
    p.curves.push_back(std::move(c));
  }
  return p;
}

void add_plots(const InstallationRun& run, std::size_t spans, Result& r) {
  using Of = std::function<double(const study::Installation&)>;
  r.figures.emplace_back(plot_of<Of>(run, "installation_tension", fmt::format("Tension of {}, empty", run.words),
                                     {.label = "tension", .unit = si::N},
                                     {{"at its start", [](const auto& i) { return i.T_start; }},
                                      {"at its end", [](const auto& i) { return i.T_end; }}}));
  std::vector<std::pair<std::string, Of>> sags;
  sags.reserve(spans);
  for (std::size_t k = 0; k < spans; ++k) {
    sags.emplace_back(fmt::format("span {}", k + 1), [k](const auto& i) { return i.sag[k]; });
  }
  r.figures.emplace_back(plot_of<Of>(run, "installation_sag",
                                     fmt::format("Sag of {} at half its spans, empty", run.words),
                                     {.label = "sag", .unit = si::m}, sags));
  const auto ok = [](const Row& row) { return row.at.outcome.ok(); };
  const auto first = std::find_if(run.rows.begin(), run.rows.end(), ok);
  const bool same = std::all_of(run.rows.begin(), run.rows.end(), [&](const Row& row) {
    return !ok(row) || std::abs(row.at.unstretched - first->at.unstretched) < 1e-9 * first->at.unstretched;
  });
  if (same) return;
  r.figures.emplace_back(
      plot_of<Of>(run, "installation_length", fmt::format("Length of {} to be installed", run.words),
                  {.label = "length", .unit = si::m},
                  {{"unstretched, at the reference temperature", [](const auto& i) { return i.unstretched; }},
                   {"as cut at this temperature", [](const auto& i) { return i.cut; }}}));
}

/// Tension and length to put the rope up with, at the coldest and the warmest of its temperatures.
void add_base_tension(const InstallationRun& run, const Display& display, Result& r) {
  std::vector<std::string> parts;
  const auto add = [&](const Row& row) {
    const std::string at = std::isnan(row.temperature) ? "" : " at " + study::celsius(row.temperature);
    const std::string name = parts.empty() ? run.words + " " : "";
    parts.push_back(fmt::format("{}{} at its start, {} at its end, cut {}{}", name,
                                display.brief(row.at.T_start, si::N), display.brief(row.at.T_end, si::N),
                                display.brief(row.at.cut, si::m), at));
  };
  std::vector<const Row*> rows;
  for (const Row& row : run.rows) {
    if (row.at.outcome.ok()) rows.push_back(&row);
  }
  const auto [cold, warm] = std::minmax_element(
      rows.begin(), rows.end(), [](const Row* a, const Row* b) { return a->temperature < b->temperature; });
  if (rows.empty()) return;
  add(**cold);
  if (*warm != *cold) add(**warm);
  add_answer_line(r, "Put up", parts);
}

/// Of a length: what a deck may leave out of its figures.
constexpr double same_rope = 1e-4;

/// Whether the rope that is put up is the one that the machine has. A winch may draw in what it wants.
void compare_lengths(const InstallationRun& run, const machine::Reeving& rope, const Display& display, Result& r) {
  const bool on_drum = rope.nodes.front().drum || rope.nodes.back().drum;
  if (!run.given || on_drum || rope.given != machine::Given::length) return;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Row& row : run.rows) {
    if (!row.at.outcome.ok()) continue;
    least = std::min(least, row.at.unstretched);
    most = std::max(most, row.at.unstretched);
  }
  if (most == 0 || (rope.value >= least * (1 - same_rope) && rope.value <= most * (1 + same_rope))) return;
  const AboutPart about(r, {.kind = PartKind::rope, .name = rope.name});
  warn_unsafe(r, fmt::format("installation{}: '{}' is put up with {} (unstretched), but the machine is calculated with "
                             "{} of it: leave out 'given', or give the rope what it is put up with ('install')",
                             run.ending, run.words,
                             most - least <= same_rope * most
                                 ? display.brief(least, si::m)
                                 : fmt::format("{} to {}", display.brief(least, si::m), display.brief(most, si::m)),
                             display.brief(rope.value, si::m)));
}

void add_results(const InstallationRun& run, bool judged, const Display& display, Result& r) {
  study::Missing missing;
  for (const Row& row : run.rows) missing.take(row.at.outcome, words_of(row, run));
  missing.note(r, "installation" + run.ending, judged);
  const auto first = std::find_if(run.rows.begin(), run.rows.end(), [](const Row& row) { return row.at.outcome.ok(); });
  if (first == run.rows.end()) return;
  const auto value = [&](const char* name, double v) {
    const ValueKind& kind = named(value_kinds(), name);
    r.values.push_back(
        make_value(kind, run.words, run.ending, v, fmt::format("{}, {}", kind.about.words, words_of(*first, run))));
  };
  value("ROPE.install_T_start", first->at.T_start);
  value("ROPE.install_T_end", first->at.T_end);
  value("ROPE.install_length", first->at.cut);
  r.tables.push_back(installation_table(run, first->at));
  r.tables.push_back(lengths_table(run, *first));
  if (run.rows.size() > 1) add_plots(run, first->at.sag.size(), r);
  add_base_tension(run, display, r);
}

}  // namespace

std::vector<QuantityWords> installation_words() {
  std::vector<QuantityWords> all = words_of(study::installation_quantities());
  all.push_back(sag_of_span("N"));
  return all;
}

std::vector<QuantityWords> lengths_words() { return words_of(lengths_of_ropes()); }

void add_answer(const InstallationRun& asked, MachineRun& machine, Result& r) {
  InstallationRun run = asked;
  study::solve(machine.model, run);
  compare_lengths(run, machine.model.reevings[run.reeving], machine.display, r);
  add_results(run, machine.checked->judged, machine.display, r);
  const std::string analysis = checks::analysis_name(run.ending, "installation");
  for (const Row& row : run.rows) {
    if (!row.at.outcome.ok()) continue;
    machine.checked->take_empty(row.at.at.model, row.at.at.result, run.words, words_of(row, run), analysis);
  }
}

}  // namespace taut::results
