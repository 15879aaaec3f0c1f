#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "taut/app/design/design_space.hpp"
#include "taut/design/design_checks.hpp"

namespace taut::app {
namespace {

/// The checks of one case, called by it.
void take_checks(const std::string& name, const std::vector<Check>& checks, std::vector<Check>& all) {
  for (Check c : checks) {
    c.name += fmt::format(" [{}]", name);
    all.push_back(std::move(c));
  }
}

/// One load case, and how the design fares in it.
struct CaseRow {
  const std::string& name;
  const design::SizingTrial& trial;
};

const Quantities<CaseRow>& case_quantities() {
  using Row = CaseRow;
  static const Quantities<Row> all = {
      {"case", "", si::one, "the load case", [](const Row& r) { return r.name; }},
      {"governs", "", si::one, "the check that governs it", [](const Row& r) { return r.trial.governs; }},
      {"utilisation", "", si::one, "its utilisation", [](const Row& r) { return r.trial.utilisation; }},
      {"passes", "", si::one, "yes: all checks of the case pass; else no",
       [](const Row& r) { return std::string(r.trial.passes ? "yes" : "no"); }}};
  return all;
}

double severity(const design::SizingTrial& trial) {
  return std::isnan(trial.utilisation) ? HUGE_VAL : trial.utilisation;
}

}  // namespace

TableWords cases_words() {
  return {.name = "design_cases", .rows = "every load case of the design", .columns = words_of(case_quantities())};
}

design::DesignRun run_cases(const std::vector<design::DesignCase>& cases, design::Depth depth, std::size_t& first,
                            const std::function<design::DesignRun(const design::DesignCase*, design::Depth)>& one) {
  if (cases.empty()) return one(nullptr, depth);
  design::DesignRun worst;
  std::optional<double> most;
  std::size_t governs = 0;
  double tension = std::nan("");
  std::vector<Check> checks;
  std::vector<std::string> warnings, unsafe, unjudged, unmade;
  const auto merge = [](const std::vector<std::string>& more, std::vector<std::string>& all) {
    for (const std::string& one : more) {
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    }
  };
  Table table = make_table("design_cases", "Load cases of the design, and what governs each", case_quantities(),
                           std::vector<CaseRow>{});
  table.rows.resize(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t k = (first + i) % cases.size();
    design::DesignRun run = one(&cases[k], depth == design::Depth::report ? design::Depth::checks : depth);
    const design::SizingTrial trial = design::trial_of(run.result);
    add_cells(table.rows[k], case_quantities(), CaseRow{.name = cases[k].name, .trial = trial});
    tension = std::fmax(tension, run.tension);
    take_checks(cases[k].name, run.result.checks, checks);
    merge(run.result.warnings, warnings);
    merge(run.result.unsafe, unsafe);
    merge(run.result.unjudged, unjudged);
    merge(run.result.unmade, unmade);
    const bool over = run.result.interrupted || run.result.status != Status::ok;
    if (over && !run.result.interrupted)
      run.result.message = fmt::format("case {}: {}", cases[k].name, run.result.message);
    if (!most || severity(trial) > *most || over) {
      most = severity(trial);
      worst = std::move(run);
      governs = k;
    }
    if (over || (depth == design::Depth::quick && !trial.passes)) {
      first = k;
      break;
    }
  }
  if (depth == design::Depth::report && worst.result.status == Status::ok) worst = one(&cases[governs], depth);
  worst.tension = tension;
  worst.result.checks = grouped(std::move(checks));
  worst.result.warnings = std::move(warnings);
  worst.result.unsafe = std::move(unsafe);
  worst.result.unjudged = std::move(unjudged);
  worst.result.unmade = std::move(unmade);
  if (depth != design::Depth::report) return worst;
  worst.result.tables.insert(worst.result.tables.begin(), std::move(table));
  worst.result.assumptions.push_back(fmt::format(
      "The checks are those of all load cases; everything else is of the one that governs, {}.", cases[governs].name));
  return worst;
}

}  // namespace taut::app
