#include <fmt/format.h>

#include "taut/calc/answers.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/study/deck/missing.hpp"

namespace taut::results {
namespace {

QuantityWords least_in_case(const std::string& name) {
  return {.name = "T_min, " + name, .symbol = "", .unit = si::N, .words = "its least tension in that case"};
}

Table least_tension_table(const study::LeastTensionRun& run) {
  std::vector<study::LeastTensionRow> rows;
  for (const study::LeastTension& one : run.answer.ropes) rows.push_back({run, one});
  Table t = make_table(
      "least_tension" + run.ending,
      fmt::format("Lengths for which each of these ropes keeps its least tension; least tensions by case ({})",
                  run.words),
      study::least_tension_quantities(), rows);
  for (const std::string& name : run.cases) add_columns(t.columns, {least_in_case(name)});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const double T : rows[i].rope.T_min) t.rows[i].emplace_back(T);
  }
  return t;
}

void add_least_tension(const study::LeastTensionRun& run, MachineRun& machine, Result& r) {
  const study::LeastTensionResult& result = run.answer;
  r.tables.push_back(least_tension_table(run));
  std::vector<std::string> parts;
  for (const study::LeastTension& one : result.ropes) {
    const std::string& name = result.models.front().reevings[one.reeving].name;
    const auto add = [&](const char* what, double value) {
      const ValueKind& kind = named(value_kinds(), what);
      r.values.push_back(
          make_value(kind, name, run.ending, value, fmt::format("{} of {} ({})", kind.about.words, name, run.words)));
    };
    add("ROPE.pretension_length", one.unstretched);
    add("ROPE.pretension_taken_out", one.taken_out);
    add("ROPE.pretension_T", one.T_min.front());
    add("ROPE.pretension_T_least", one.T_least);
    parts.push_back(fmt::format(
        "{} {} unstretched, {} as put up, never below {}", name, machine.display.brief(one.unstretched, si::m),
        machine.display.brief(one.T_min.front(), si::N), machine.display.brief(one.T_least, si::N)));
  }
  add_answer_line(r, "Lengths", parts);
  const study::PullEnd put_up = study::end_of(result.models.front(), result.at.front());
  machine.checked->take_pretension(put_up.T_start, put_up.T_end, fmt::format("as tightened ({})", run.words));
  for (std::size_t c = 0; c < result.at.size(); ++c) {
    machine.checked->take(result.models[c], result.at[c], fmt::format("{}, {}", run.words, run.cases[c]), "pretension");
    machine.others.push_back({fmt::format("{}, {}", run.words, run.cases[c]), result.models[c], result.at[c], false});
  }
}

}  // namespace

std::vector<QuantityWords> least_tension_words() {
  std::vector<QuantityWords> all = words_of(study::least_tension_quantities());
  all.push_back(least_in_case("CASE"));
  return all;
}

void add_answer(const study::LeastTensionRun& asked, MachineRun& machine, Result& r) {
  if (r.interrupted) return;
  study::LeastTensionRun run = asked;
  int round = 0;
  study::solve(machine.model, run, [&] {
    return !machine.progress ||
           machine.progress({.what = run.words, .done = 0, .words = fmt::format("round {}", ++round)});
  });
  study::note_failure(r, run.answer.outcome, run.words);
  if (run.answer.interrupted) {
    r.interrupted = true;
    r.status = Status::not_converged;
    r.message = fmt::format("{}: interrupted", run.words);
  }
  if (run.answer.outcome.ok() && !run.answer.interrupted) add_least_tension(run, machine, r);
}

}  // namespace taut::results
