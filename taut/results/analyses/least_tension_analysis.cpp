#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "taut/checks/checked_parts.hpp"
#include "taut/machine/compile.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/study/least_tension.hpp"

namespace taut::results {
namespace {

struct LeastTensionRun {
  std::string ending;
  std::string words;
  std::vector<int> chosen;
  double tension = 0;
  Array<std::string> cases;  ///< their names; the first: as put up
  std::vector<machine::Model> models;
  std::size_t guys_from = 0;  ///< reevings from there on are guys
};

/// The machine with the loads of a case besides its own; complaints at the case.
std::optional<machine::Model> model_of_case(const machine::Machine& machine, const study::LoadCaseRequest& request,
                                            const std::string& path, std::vector<Complaint>& complaints) {
  machine::Machine loaded = machine;
  loaded.loads.insert(loaded.loads.end(), request.loads.begin(), request.loads.end());
  auto model = machine::compile(loaded);
  if (model) return std::move(*model);
  for (Complaint& c : model.error()) {
    for (std::size_t i = 0; i < request.loads.size(); ++i) {
      const std::string its = fmt::format("loads[{}]", machine.loads.size() + i);
      if (!c.path.starts_with(its)) continue;
      complaints.push_back({fmt::format("{}.loads[{}]{}", path, i, c.path.substr(its.size())), c.message});
    }
  }
  return std::nullopt;
}

/// Guys and lines have been put up; they keep those lengths where they are not chosen.
void keep_lengths(const LeastTensionRun& run, const machine::Model& installed, machine::Model& model) {
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    if (i < run.guys_from && !model.reevings[i].put_up) continue;
    model.reevings[i].given = installed.reevings[i].given;
    model.reevings[i].value = installed.reevings[i].value;
  }
}

Table least_tension_table(const LeastTensionRun& run, const study::LeastTensionResult& result) {
  Table t;
  t.name = "least_tension" + run.ending;
  t.title = fmt::format("Lengths for which each of these ropes keeps its least tension; least tensions by case ({})",
                        run.words);
  t.columns = {
      {"rope", si::one}, {"unstretched", si::m}, {"taken_out", si::m}, {"T_least", si::N}, {"governed_by", si::one}};
  for (const std::string& name : run.cases) t.columns.push_back({"T_min, " + name, si::N});
  for (const study::LeastTension& one : result.ropes) {
    std::vector<Cell> row = {result.models.front().reevings[one.reeving].name, one.unstretched, one.taken_out,
                             one.T_least, run.cases[one.governing]};
    for (const double T : one.T_min) row.emplace_back(T);
    t.rows.push_back(std::move(row));
  }
  return t;
}

void add_least_tension(const LeastTensionRun& run, const study::LeastTensionResult& result, MachineRun& machine,
                       Result& r) {
  r.tables.push_back(least_tension_table(run, result));
  for (const study::LeastTension& one : result.ropes) {
    const std::string& name = result.models.front().reevings[one.reeving].name;
    const auto add = [&](const char* what, double value, const Unit& unit, const char* words) {
      const std::string full = fmt::format("{}.pretension_{}{}", name, what, run.ending);
      r.values.push_back({full, value, unit, full, fmt::format("{} of {} ({})", words, name, run.words), {}});
    };
    add("length", one.unstretched, si::m, "unstretched length");
    add("taken_out", one.taken_out, si::m, "rope taken out");
    add("T", one.T_min.front(), si::N, "least tension as put up");
    add("T_least", one.T_least, si::N, "least tension over all cases");
  }
  for (std::size_t c = 0; c < result.at.size(); ++c) {
    machine.checked->take(result.models[c], result.at[c], fmt::format("{}, {}", run.words, run.cases[c]), "pretension");
    machine.others.push_back({fmt::format("{}, {}", run.words, run.cases[c]), result.models[c], result.at[c], false});
  }
}

}  // namespace

Analysis prepare_least_tension(const study::PretensionRequest& request, const std::string& path,
                               const std::string& ending, Preparation& p) {
  const auto run = std::make_shared<LeastTensionRun>();
  run->ending = ending;
  run->words = request.name ? fmt::format("pretension, {}", *request.name) : "pretension";
  run->tension = request.least->tension;
  run->guys_from = p.machine.reevings.size();
  const std::string here = path + ".least";
  if (request.least->ropes.empty()) p.complaints.push_back({here + ".ropes", "names no rope"});
  for (std::size_t i = 0; i < request.least->ropes.size(); ++i) {
    const std::string its = fmt::format("{}.ropes[{}]", here, i);
    const int rope = reeving_of(p, request.least->ropes[i], its);
    if (rope >= 0 && p.model.reevings[rope].closed) {
      p.complaints.push_back({its, "an endless rope is tightened by its 'take_up'"});
    }
    if (std::find(run->chosen.begin(), run->chosen.end(), rope) != run->chosen.end()) {
      p.complaints.push_back({its, "is named twice"});
    }
    run->chosen.push_back(rope);
  }
  if (!p.model.contacts.empty() || !p.model.actuators.empty()) {
    p.complaints.push_back(
        {here, "is computed at rest, without contacts and actuators: pull the ropes in turn ('pull')"});
  }
  run->cases.emplace_back("as put up");
  run->models.push_back(p.model);
  for (std::size_t c = 0; c < request.least->cases.size(); ++c) {
    const study::LoadCaseRequest& one = request.least->cases[c];
    const std::string its = fmt::format("{}.cases[{}]", here, c);
    if (one.loads.empty()) p.complaints.push_back({its, "has no loads"});
    if (std::find(run->cases.begin(), run->cases.end(), one.name) != run->cases.end()) {
      p.complaints.push_back({its + ".name", "another case has that name"});
    }
    run->cases.push_back(one.name);
    if (auto model = model_of_case(p.machine, one, its, p.complaints)) run->models.push_back(std::move(*model));
  }
  return [run](MachineRun& machine, Result& r) {
    if (r.interrupted) return;
    std::vector<machine::Model> cases = run->models;
    cases.front() = machine.model;
    for (machine::Model& model : cases) keep_lengths(*run, machine.model, model);
    int round = 0;
    const auto go_on = [&] {
      return !machine.progress || machine.progress({run->words, 0, fmt::format("round {}", ++round)});
    };
    const auto result = study::least_tension(cases, run->chosen, run->tension, go_on);
    note_failure(r, result.outcome, run->words);
    if (result.interrupted) {
      r.interrupted = true;
      r.status = Status::not_converged;
      r.message = fmt::format("{}: interrupted", run->words);
    }
    if (result.outcome.ok() && !result.interrupted) add_least_tension(*run, result, machine, r);
  };
}

}  // namespace taut::results
