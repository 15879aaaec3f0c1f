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

void merge(const std::vector<std::string>& more, std::vector<std::string>& all) {
  for (const std::string& one : more) {
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  }
}

enum class CaseFate { passes, fails, no_answer, interrupted };

/// The runs of load cases, put together one after the other.
class CaseRuns {
 public:
  explicit CaseRuns(const std::vector<design::DesignCase>& cases)
      : cases_(cases),
        table_(make_table("design_cases", "Load cases of the design, and what governs each", case_quantities(),
                          std::vector<CaseRow>{})) {
    table_.rows.resize(cases.size());
  }

  CaseFate take(std::size_t k, design::DesignRun run) {
    const design::SizingTrial trial = design::trial_of(run.result);
    add_cells(table_.rows[k], case_quantities(), CaseRow{.name = cases_[k].name, .trial = trial});
    tension_ = std::fmax(tension_, run.tension);
    take_checks(cases_[k].name, run.result.checks, checks_);
    merge(run.result.warnings, warnings_);
    merge(run.result.unsafe, unsafe_);
    merge(run.result.unjudged, unjudged_);
    merge(run.result.unmade, unmade_);
    const CaseFate fate = run.result.interrupted            ? CaseFate::interrupted
                          : run.result.status != Status::ok ? CaseFate::no_answer
                          : trial.passes                    ? CaseFate::passes
                                                            : CaseFate::fails;
    const bool over = note(cases_[k].name, fate, run.result);
    if (!most_ || severity(trial) > *most_ || over) {
      most_ = severity(trial);
      worst_ = std::move(run);
      governs_ = k;
    }
    return fate;
  }

  const design::DesignRun& worst() const { return worst_; }
  std::size_t governs() const { return governs_; }

  /// `worst`: of the case that governs, which has the checks of all then.
  design::DesignRun together(design::DesignRun worst, design::Depth depth) && {
    worst.tension = tension_;
    answers_.others_pass = !fails_ && answers_.with.size() + answers_.without.size() == cases_.size();
    worst.cases = std::move(answers_);
    worst.result.checks = grouped(std::move(checks_));
    worst.result.warnings = std::move(warnings_);
    worst.result.unsafe = std::move(unsafe_);
    worst.result.unjudged = std::move(unjudged_);
    worst.result.unmade = std::move(unmade_);
    if (depth != design::Depth::report) return worst;
    worst.result.tables.insert(worst.result.tables.begin(), std::move(table_));
    worst.result.assumptions.push_back(
        fmt::format("The checks are those of all load cases; everything else is of the one that governs, {}.",
                    cases_[governs_].name));
    return worst;
  }

 private:
  /// Notes whether a case has an answer. True where nothing worse can come.
  bool note(const std::string& name, CaseFate fate, Result& r) {
    fails_ = fails_ || fate == CaseFate::fails;
    if (fate == CaseFate::interrupted) return true;
    if (fate != CaseFate::no_answer) {
      answers_.with.push_back(name);
      return false;
    }
    answers_.without.emplace_back(name, r.message);
    r.message = fmt::format("case {}: {}", name, r.message);
    return answers_.without.size() == 1;
  }

  const std::vector<design::DesignCase>& cases_;
  Table table_;
  design::DesignRun worst_;
  std::optional<double> most_;
  std::size_t governs_ = 0;
  double tension_ = std::nan("");
  std::vector<Check> checks_;
  std::vector<std::string> warnings_, unsafe_, unjudged_, unmade_;
  design::AnswersOfCases answers_;
  bool fails_ = false;
};

}  // namespace

TableWords cases_words() {
  return {.name = "design_cases", .rows = "every load case of the design", .columns = words_of(case_quantities())};
}

design::DesignRun run_cases(const std::vector<design::DesignCase>& cases, design::Depth depth, std::size_t& first,
                            const std::function<design::DesignRun(const design::DesignCase*, design::Depth)>& one) {
  if (cases.empty()) return one(nullptr, depth);
  const bool quick = depth == design::Depth::quick;
  CaseRuns all(cases);
  for (std::size_t i = 0, begin = first; i < cases.size(); ++i) {
    const std::size_t k = (begin + i) % cases.size();
    const CaseFate fate = all.take(k, one(&cases[k], quick ? depth : design::Depth::checks));
    const bool over = fate == CaseFate::no_answer || fate == CaseFate::interrupted;
    if (over || (quick && fate == CaseFate::fails)) first = k;
    // a quick look goes on behind a case without an answer: that may be the only obstacle of the design
    if (fate == CaseFate::interrupted || fate == (quick ? CaseFate::fails : CaseFate::no_answer)) break;
  }
  design::DesignRun worst = all.worst();
  if (depth == design::Depth::report && worst.result.status == Status::ok) worst = one(&cases[all.governs()], depth);
  return std::move(all).together(std::move(worst), depth);
}

}  // namespace taut::app
