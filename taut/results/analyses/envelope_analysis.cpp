#include <fmt/format.h>

#include <iterator>

#include "taut/calc/answers.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/carriage_way.hpp"

namespace taut::results {
namespace {

/// Those extremes whose quantity has this unit. `about`: the analysis is about them.
Table envelope_table(const study::EnvelopeRun& run, const std::string& kind, const Unit& unit, bool about) {
  std::vector<study::EnvelopeExtreme> rows;
  std::copy_if(run.extremes.begin(), run.extremes.end(), std::back_inserter(rows),
               [&](const auto& e) { return e.unit.symbol == unit.symbol; });
  return make_table(fmt::format("envelope{}{}", kind, run.ending), "Least and largest over all states, and where",
                    about ? study::envelope_quantities(unit) : as_details(study::envelope_quantities(unit)), rows);
}

void add_tensions(const study::EnvelopeRun& run, const Display& display, Result& r) {
  std::vector<std::string> parts;
  for (const study::EnvelopeExtreme& e : run.extremes) {
    if (e.what != "tension") continue;
    const auto add = [&](const char* name, double value) {
      const ValueKind& kind = named(value_kinds(), name);
      r.values.push_back(make_value(kind, e.name, run.ending, value,
                                    fmt::format("{} of {} over the envelope", kind.about.words, e.name)));
    };
    add("ROPE.T_min_envelope", e.least);
    add("ROPE.T_max_envelope", e.most);
    parts.push_back(fmt::format("{} {} to {}", e.name, display.brief(e.least, si::N), display.brief(e.most, si::N)));
  }
  if (!parts.empty()) parts.push_back(fmt::format("over {} states", run.states));
  add_answer_line(r, "Envelope", parts);
}

}  // namespace

void add_answer(const study::EnvelopeRun& asked, MachineRun& machine, Result& r) {
  study::EnvelopeRun run = asked;
  run.display = machine.display;
  study::Watch watch(machine.progress, "envelope" + run.ending, states_of(run), machine.display);
  study::solve(machine.model, run, watch,
               [&](const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words) {
                 machine.checked->take(model, state, words, checks::analysis_name(run.ending, "envelope"));
               });
  for (const std::string& sentence : run.contrary) {
    machine.checked->judged ? warn_unsafe(r, sentence) : r.warnings.push_back(sentence);
  }
  watch.note(r);
  run.missing.note(r, "envelope" + run.ending, machine.checked->judged);
  if (const auto words = run.carriage ? study::left_out_words(machine.model, run.way, machine.display) : std::nullopt) {
    r.warnings.push_back(fmt::format("envelope{}: {}", run.ending, *words));
  }
  if (run.on_support) r.warnings.emplace_back("envelope: positions on a support are left out");
  if (run.extremes.empty()) return;
  r.tables.push_back(envelope_table(run, "", si::N, true));
  r.tables.push_back(envelope_table(run, "_lengths", si::m, false));
  r.tables.push_back(envelope_table(run, "_angles", si::rad, false));
  if (r.tables.back().rows.empty()) r.tables.pop_back();
  const ValueKind& states = named(value_kinds(), "envelope_states");
  r.values.push_back(make_value(states, "", run.ending, static_cast<double>(run.states), states.about.words));
  add_tensions(run, machine.display, r);
  for (study::WorstState& one : run.worst) {
    machine.others.push_back({.words = std::move(one.words),
                              .model = std::move(one.model),
                              .result = std::move(one.result),
                              .judged = machine.checked->judged});
  }
}

}  // namespace taut::results
