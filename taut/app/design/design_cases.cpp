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

Table cases_table() {
  return {.name = "design_cases",
          .title = "Load cases of the design, and what governs each",
          .columns = {{.name = "case", .unit = si::one},
                      {.name = "governs", .unit = si::one},
                      {.name = "utilisation", .unit = si::one},
                      {.name = "passes", .unit = si::one}},
          .rows = {}};
}

double severity(const design::SizingTrial& trial) {
  return std::isnan(trial.utilisation) ? HUGE_VAL : trial.utilisation;
}

}  // namespace

design::DesignRun run_cases(const std::vector<design::DesignCase>& cases, design::Depth depth, std::size_t& first,
                            const std::function<design::DesignRun(const design::DesignCase*, design::Depth)>& one) {
  if (cases.empty()) return one(nullptr, depth);
  design::DesignRun worst;
  std::optional<double> most;
  std::size_t governs = 0;
  double tension = std::nan("");
  std::vector<Check> checks;
  std::vector<std::string> warnings;
  Table table = cases_table();
  table.rows.resize(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t k = (first + i) % cases.size();
    design::DesignRun run = one(&cases[k], depth == design::Depth::report ? design::Depth::checks : depth);
    const design::SizingTrial trial = design::trial_of(run.result);
    table.rows[k] = {cases[k].name, trial.governs, trial.utilisation, std::string(trial.passes ? "yes" : "no")};
    tension = std::fmax(tension, run.tension);
    take_checks(cases[k].name, run.result.checks, checks);
    for (const std::string& warning : run.result.warnings) {
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
    }
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
  if (depth != design::Depth::report) return worst;
  worst.result.tables.insert(worst.result.tables.begin(), std::move(table));
  worst.result.assumptions.push_back(fmt::format(
      "The checks are those of all load cases; everything else is of the one that governs, {}.", cases[governs].name));
  return worst;
}

}  // namespace taut::app
