#include "taut/app/cases/study/study_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/cases/study/study_chance.hpp"
#include "taut/app/cases/study/study_figures.hpp"
#include "taut/app/cases/study/study_words.hpp"
#include "taut/base/stretches.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut::app {
namespace {

/// The quantiles that the result has.
constexpr std::array<double, 7> quantile_shares = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};
constexpr std::array<double, 2> nine_of_ten = {0.05, 0.95};
constexpr std::size_t most_rows = 1000;  ///< of failed cases in the result; all are in cases.h5
constexpr std::size_t most_reasons = 20;

/// Mean, standard deviation and quantiles of an output.
struct Statistic {
  std::string name;   ///< "mean", "q05"
  std::string words;  ///< "mean", "5 % quantile"
  chance::Estimate estimate;
  bool is_difference = false;  ///< of two values: of temperatures in K
};

std::vector<Statistic> statistics_of(const chance::Sample& sample) {
  std::vector<Statistic> all = {
      {.name = "mean", .words = "mean", .estimate = chance::sample_mean(sample)},
      {.name = "sd", .words = "standard deviation", .estimate = chance::sample_sd(sample), .is_difference = true}};
  const std::vector<chance::Estimate> found = chance::quantiles(sample, quantile_shares);
  for (std::size_t i = 0; i < quantile_shares.size(); ++i) {
    const double percent = 100 * quantile_shares[i];
    const std::string words = quantile_shares[i] == 0.5 ? "median" : fmt::format("{:.0f} % quantile", percent);
    all.push_back({.name = fmt::format("q{:02.0f}", percent), .words = words, .estimate = found[i]});
  }
  return all;
}

/// All numbers of the result in one table for other programs, SI.
class Summary {
 public:
  Summary() {
    table_.name = "summary";
    table_.title = "All estimates with their confidence intervals, SI";
    table_.detail = true;
    for (const char* text : {"of", "what", "unit"}) table_.columns.push_back({.name = text, .unit = si::one});
    for (const char* number : {"value", "low", "high"}) table_.columns.push_back({.name = number, .unit = si::one});
  }
  void add(const std::string& of, const std::string& what, const Unit& unit, const chance::Estimate& e) {
    table_.rows.push_back({of, what, std::string(unit.symbol), e.value, e.interval.low, e.interval.high});
  }
  Table table() && { return std::move(table_); }

 private:
  Table table_;
};

/// One row of the table of an output. A difference of temperatures has not the unit of its column.
void add_row(const Statistic& one, const CaseOutput& output, const Display& display, Table& t) {
  const chance::Estimate& e = one.estimate;
  std::vector<Cell> cells = {one.words};
  for (const double x : {e.value, e.interval.low, e.interval.high}) {
    if (one.is_difference && is_temperature(output.unit)) {
      cells.emplace_back(display.brief(x, difference_of(output.unit)));
    } else {
      cells.emplace_back(x);
    }
  }
  t.rows.push_back(std::move(cells));
}

/// What the quantiles are of, where cases have no answer: ", of the 84 % of cases with an answer".
std::string of_those_with_answer(std::span<const double> values) {
  const auto answered = std::count_if(values.begin(), values.end(), [](double x) { return !std::isnan(x); });
  const auto all = static_cast<std::ptrdiff_t>(values.size());
  if (answered == all) return {};
  return fmt::format(", of the {:.3g} % of cases with an answer",
                     100 * static_cast<double>(answered) / static_cast<double>(all));
}

void add_statistics(const Study& study, const StudyData& data, Summary& summary, Result& r) {
  for (std::size_t k = 0; k < study.model.outputs.size(); ++k) {
    const CaseOutput& output = study.model.outputs[k];
    Table t{.name = "quantiles" + name_ending(k, study.model.outputs.size()),
            .title = fmt::format("{}: {}{}", output.name, output.label,
                                 data.failed.empty() ? "" : "; cases without an answer left out"),
            .columns = {{.name = "statistic", .unit = si::one},
                        {.name = "value", .unit = output.unit},
                        {.name = "low", .unit = output.unit},
                        {.name = "high", .unit = output.unit}},
            .rows = {{std::string("the deck as it is"), output.base, std::nan(""), std::nan("")}}};
    for (const Statistic& one : statistics_of(sample_of(study, data, k))) {
      const Unit unit = one.is_difference ? difference_of(output.unit) : output.unit;
      add_row(one, output, study.display, t);
      summary.add(output.name, one.name, unit, one.estimate);
      r.values.push_back({fmt::format("{}.{}", output.name, one.name),
                          one.estimate.value,
                          unit,
                          one.name,
                          fmt::format("{} of {}", one.words, output.name),
                          {},
                          true});
    }
    r.tables.push_back(std::move(t));
    const chance::Sample sample = sample_of(study, data, k);
    const std::vector<chance::Estimate> ends = chance::quantiles(sample, nine_of_ten);
    r.answers.push_back(
        {"Nine of ten",
         fmt::format("{}: {} to {}{}", output.name, study.display.brief(ends[0].value, output.unit),
                     study.display.brief(ends[1].value, output.unit), of_those_with_answer(sample.values))});
  }
}

/// Of a grid: the least and the largest value, and where.
void add_extremes(const Study& study, const StudyData& data, Summary& summary, Result& r) {
  Table t{.name = "extremes",
          .title = "Least and largest values of the grid",
          .columns = {{.name = "value", .unit = si::one},
                      {.name = "least", .unit = si::one},
                      {.name = "least_at", .unit = si::one},
                      {.name = "largest", .unit = si::one},
                      {.name = "largest_at", .unit = si::one}},
          .rows = {}};
  for (std::size_t k = 0; k < data.outputs.size(); ++k) {
    const CaseOutput& output = study.model.outputs[k];
    const std::vector<double>& all = data.outputs[k];
    const auto less = [](double a, double b) { return !std::isnan(a) && (std::isnan(b) || a < b); };
    const auto least = std::min_element(all.begin(), all.end(), less);
    const auto largest = std::min_element(
        all.begin(), all.end(), [](double a, double b) { return !std::isnan(a) && (std::isnan(b) || a > b); });
    if (least == all.end() || std::isnan(*least)) continue;
    const auto place = [&](auto at) {
      return values_in_words(study, study.values_at(static_cast<std::uint64_t>(at - all.begin())));
    };
    t.rows.push_back({output.name, study.display.brief(*least, output.unit), place(least),
                      study.display.brief(*largest, output.unit), place(largest)});
    summary.add(output.name, "least", output.unit, {.value = *least, .interval = {.low = *least, .high = *least}});
    summary.add(output.name, "largest", output.unit,
                {.value = *largest, .interval = {.low = *largest, .high = *largest}});
    r.values.push_back({output.name + ".least", *least, output.unit, "least", "least value of " + output.name, {}});
    r.values.push_back(
        {output.name + ".largest", *largest, output.unit, "largest", "largest value of " + output.name, {}});
  }
  r.tables.push_back(std::move(t));
}

/// Of a grid: every combination has to keep the limits.
void add_grid_limits(const Study& study, const StudyData& data, Result& r) {
  for (const StudyLimit& limit : study.limits) {
    const CaseOutput& output = study.model.outputs[limit.output];
    const bool least = limit.limit.bound == chance::Bound::at_least;
    const Value* worst = r.find_value(output.name + (least ? ".least" : ".largest"));
    if (worst == nullptr) continue;  // no case has an answer
    r.checks.push_back(make_check(worst->name, worst->value, output.unit,
                                  {.sense = least ? Sense::at_least : Sense::at_most,
                                   .limit = limit.limit.value,
                                   .rule = "limit of the deck, over the whole grid",
                                   .trust = "user"}));
  }
  if (study.limits.empty() || data.failed.empty()) return;
  Stretches all;
  for (std::size_t i = 0; i < data.failed.size(); ++i) {
    const FailedCase& one = data.failed[i];
    // cases with an answer end a stretch
    if (i > 0 && one.index > data.failed[i - 1].index + 1) all.take({}, {}, {});
    all.take(one.reason, values_in_words(study, study.values_at(one.index)), {});
  }
  r.missing.push_back({.analysis = "grid",
                       .missing = static_cast<int>(data.failed.size()),
                       .places = static_cast<int>(study.size()),
                       .first = values_in_words(study, study.values_at(data.failed.front().index)),
                       .reason = data.failed.front().reason,
                       .all = all.few_places()});
}

/// "a, b, c and 2 more".
std::string first_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + most, ", "), names.size() - most);
}

/// Before the sentence of the verdict, behind what stands there.
void put_before(const std::string& words, Result& r) { r.preface += (r.preface.empty() ? "" : "; ") + words; }

/// A run of the deck judges analyses that the cases leave out: it may fail where the study passes.
void add_not_run(const Study& study, Result& r) {
  const std::vector<std::string>& all = study.model.not_run;
  if (all.empty()) return;
  put_before(fmt::format("no case calculates {}", fmt::join(all, ", ")), r);
}

void add_failed(const Study& study, const StudyData& data, Result& r) {
  if (data.failed.empty()) return;
  const double share = static_cast<double>(data.failed.size()) / static_cast<double>(study.size());
  put_before(fmt::format("{} of {} cases have no answer ({:.3g} %)", data.failed.size(), study.size(), 100 * share), r);
  std::map<std::string, std::size_t> reasons;
  for (const FailedCase& one : data.failed) ++reasons[one.reason];
  std::vector<std::pair<std::string, std::size_t>> sorted(reasons.begin(), reasons.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  Table counted{.name = "reasons",
                .title = "Why cases have no answer",
                .columns = {{.name = "cases", .unit = si::one}, {.name = "reason", .unit = si::one}},
                .rows = {}};
  for (const auto& [reason, count] : sorted) {
    if (counted.rows.size() == most_reasons) break;
    counted.rows.push_back({static_cast<double>(count), reason});
  }
  Table each{
      .name = "failed",
      .title = fmt::format("Cases without an answer{}", data.failed.size() > most_rows ? ", the first ones" : ""),
      .columns = {{.name = "case", .unit = si::one},
                  {.name = "numbers", .unit = si::one},
                  {.name = "reason", .unit = si::one}},
      .rows = {},
      .long_rows = nullptr,
      .detail = true};
  for (const FailedCase& one : data.failed) {
    if (each.rows.size() == most_rows) break;
    each.rows.push_back(
        {static_cast<double>(one.index), values_in_words(study, study.values_at(one.index)), one.reason});
  }
  r.tables.push_back(std::move(counted));
  r.tables.push_back(std::move(each));
}

/// A value, and the side of it on which a limit is.
struct LimitedValue {
  std::string name;
  chance::Bound bound = chance::Bound::at_most;
};

/// What a limit has to be about to speak of a check that fails: the value checked, or the same under another name, on
/// the side of the check. A pull of 10 kN at least says nothing of a rope that has too much.
std::vector<LimitedValue> limits_like(const CaseFlaw& flaw) {
  using chance::Bound;
  using ByKind = std::map<std::string, std::vector<LimitedValue>>;
  static const ByKind other_names = {{"T_max", {{.name = "safety_factor", .bound = Bound::at_least}}},
                                     {"safety_factor", {{.name = "T_max", .bound = Bound::at_most}}},
                                     {"ground", {{.name = "clearance", .bound = Bound::at_least}}}};
  static const ByKind of_all_parts = {{"T_max", {{.name = "T_max", .bound = Bound::at_most}}},
                                      {"ground",
                                       {{.name = "clearance_min", .bound = Bound::at_least},
                                        {.name = "rope_clearance_min", .bound = Bound::at_least}}}};
  std::vector<LimitedValue> values = {
      {.name = flaw.check, .bound = flaw.sense == Sense::at_least ? Bound::at_least : Bound::at_most}};
  const std::size_t dot = flaw.check.rfind('.');
  if (dot != std::string::npos) {
    const std::string part = flaw.check.substr(0, dot), kind = flaw.check.substr(dot + 1);
    if (const auto found = other_names.find(kind); found != other_names.end()) {
      for (const auto& [name, bound] : found->second) values.push_back({fmt::format("{}.{}", part, name), bound});
    }
    if (const auto found = of_all_parts.find(kind); found != of_all_parts.end()) {
      values.insert(values.end(), found->second.begin(), found->second.end());
    }
  }
  for (std::size_t i = 0, names = values.size(); i < names; ++i) {
    values.push_back({values[i].name + ".utilisation", Bound::at_most});
  }
  return values;
}

/// Whether an output is that value of all states that a flaw is about. Those of `checks` are of all analyses, those of
/// a method have none.
bool covers(const std::string& output, const std::string& value, const std::string& analysis) {
  return output == value || output == "checks." + value || (!analysis.empty() && output == analysis + "." + value);
}

/// Whether a limit of the study is about the value of a check, in states of that analysis.
bool speaks_of(const Study& study, const StudyLimit& limit, const std::vector<LimitedValue>& like,
               const std::string& analysis) {
  return std::any_of(like.begin(), like.end(), [&](const LimitedValue& value) {
    return value.bound == limit.limit.bound && covers(study.model.outputs[limit.output].name, value.name, analysis);
  });
}

using Strengths = std::map<std::string, double>;

/// Whether a limit that is about the strength of a part ends at its breaking force or yield, or before: beyond, it lets
/// everything pass that breaks nothing. One of anything else does. `strengths`: the least of all cases; one that is not
/// known has to be believed.
bool ends_at_strength(const Study& study, const StudyLimit& limit, const std::string& part,
                      const Strengths& strengths) {
  constexpr std::string_view share = ".utilisation";
  std::string_view name = study.model.outputs[limit.output].name;
  const double value = limit.limit.value;
  const bool is_share = name.ends_with(share);
  if (is_share) name.remove_suffix(share.size());
  if (name.ends_with(".safety_factor")) return is_share || value >= 1;
  if (name != "T_max" && !name.ends_with(breaking_check) && !name.ends_with(yield_check)) return true;
  if (is_share) return value <= 1;
  const auto strength = strengths.find(part);
  return strength == strengths.end() || value <= strength->second;
}

/// "skyline" of "skyline.T_max".
std::string part_of(const std::string& check) { return check.substr(0, check.rfind('.')); }

/// The least strengths of the deck as it is and of all cases.
Strengths least_strengths(Strengths of_deck, const StudyData& data) {
  keep_least(data.weaker, of_deck);
  return of_deck;
}

/// Whether a limit of the study counts that failure. It takes the place of a limit of the deck on the same value; what
/// no limit can allow it has to count as beyond itself.
bool counted(const Study& study, const StudyData& data, const FlawedCase& one, const Strengths& strengths) {
  const std::vector<LimitedValue> like = limits_like(one.flaw);
  return std::any_of(study.limits.begin(), study.limits.end(), [&](const StudyLimit& limit) {
    if (!speaks_of(study, limit, like, one.flaw.analysis)) return false;
    if (one.flaw.fact) return chance::margin(limit.limit, data.outputs[limit.output][one.index]) < 0;
    return ends_at_strength(study, limit, part_of(one.flaw.check), strengths);
  });
}

/// Whether what can't be judged matters to the study: a value alone does where a limit is about it.
bool matters(const Study& study, const CaseFlaw& flaw) {
  if (flaw.kind != CaseFlaw::Kind::unmade || flaw.check.empty()) return true;
  const std::string output = fmt::format("{}.{}", flaw.analysis, flaw.check);
  return std::any_of(study.limits.begin(), study.limits.end(),
                     [&](const StudyLimit& limit) { return study.model.outputs[limit.output].name == output; });
}

/// Cases with the same flaw.
struct SameFlaw {
  const FlawedCase* first = nullptr;
  std::uint64_t last = 0;  ///< the number of the last of them
  std::size_t cases = 0;
};

/// What is said against the cases and no limit counts: failures by their check, all that is unmade, all that is unsafe.
std::vector<SameFlaw> open_flaws(const Study& study, const StudyData& data) {
  std::map<std::pair<CaseFlaw::Kind, std::string>, std::size_t> known;
  std::vector<SameFlaw> all;
  const Strengths strengths = least_strengths(study.model.strengths, data);
  for (const FlawedCase& one : data.flawed) {
    if (one.flaw.kind == CaseFlaw::Kind::unlimited) continue;  // add_unlimited_in_cases
    if (one.flaw.kind == CaseFlaw::Kind::fails && counted(study, data, one, strengths)) continue;
    if (!matters(study, one.flaw)) continue;
    const auto [at, is_new] = known.try_emplace({one.flaw.kind, one.flaw.check}, all.size());
    if (is_new) all.push_back({.first = &one});
    SameFlaw& same = all[at->second];
    // each of its analyses may say it of a case
    if (is_new || one.index != same.last) ++same.cases;
    same.last = one.index;
  }
  return all;
}

/// A study with chance does not judge a failure of which it was not told how probable it may be; in a grid no case may
/// fail.
void add_flaws(const Study& study, const StudyData& data, Result& r) {
  const std::vector<SameFlaw> open = open_flaws(study, data);
  if (open.empty()) return;
  Table t{.name = "flaws",
          .title = "What is said against cases and no limit of the study counts",
          .columns = {{.name = "cases", .unit = si::one},
                      {.name = "are", .unit = si::one},
                      {.name = "first", .unit = si::one},
                      {.name = "why", .unit = si::one}},
          .rows = {}};
  std::vector<std::string> failures, unmade;
  for (const SameFlaw& one : open) {
    const CaseFlaw& flaw = one.first->flaw;
    const std::string count = fmt::format("{} of {} cases", one.cases, study.size());
    const std::string first = fmt::format("the first is case {}: {}", one.first->index, flaw.words);
    std::string what = "unsafe";
    if (flaw.kind == CaseFlaw::Kind::unsafe) {
      warn_unsafe(r, fmt::format("{} are unsafe, {}", count, first));
    } else if (flaw.kind == CaseFlaw::Kind::chooses) {
      what = "another choice";
      warn_unsafe(r, fmt::format("{} choose otherwise than the deck as it is, {}: nothing is said of its own choice "
                                 "there. Give what is built",
                                 count, first));
    } else if (flaw.kind == CaseFlaw::Kind::unmade) {
      what = "not judged";
      unmade.push_back(fmt::format("{} are not judged, {}", count, first));
    } else if (study.points) {
      what = "beyond " + flaw.check;
      failures.push_back(fmt::format("{} fail {}, which no 'limit' of the study counts, {}", count, flaw.check, first));
    } else {
      what = "beyond " + flaw.check;
      r.checks.push_back(make_check("cases that fail " + flaw.check, static_cast<double>(one.cases), si::one,
                                    {.sense = Sense::at_most, .limit = 0, .rule = first, .trust = "derived"}));
      r.checks.back().limits = false;
    }
    t.rows.push_back(
        {static_cast<double>(one.cases), what, values_in_words(study, study.values_at(one.first->index)), flaw.words});
  }
  // a failure is worse than an answer that needs more samples
  r.unmade.insert(r.unmade.begin(), failures.begin(), failures.end());
  r.unmade.insert(r.unmade.end(), unmade.begin(), unmade.end());
  r.tables.push_back(std::move(t));
}

/// Whether a part has a limit of its strength, and why one that it has does not count.
struct StrengthLimit {
  bool there = false;
  std::string why_not = {};
};

/// The limit in the states of an analysis; of none: of each limit's own. `least`: of `of_deck` and all cases.
StrengthLimit strength_limit(const Study& study, const UnaskedPart& part, const Strengths& of_deck,
                             const Strengths& least, const std::optional<std::string>& analysis) {
  const std::vector<LimitedValue> like =
      limits_like({.kind = CaseFlaw::Kind::fails, .check = part.name + (part.is_beam ? yield_check : breaking_check)});
  StrengthLimit found;
  for (const StudyLimit& limit : study.limits) {
    const std::string& output = study.model.outputs[limit.output].name;
    if (!speaks_of(study, limit, like, analysis.value_or(output.substr(0, output.find('.'))))) continue;
    if (ends_at_strength(study, limit, part.name, least)) return {.there = true};
    found.why_not = fmt::format("the limit of {} is beyond breaking or yield{}", output,
                                ends_at_strength(study, limit, part.name, of_deck) ? " of some cases" : "");
  }
  return found;
}

/// What is said of a part that needs a limit of its strength and has none, of a check or of the study; empty: it has. A
/// limit is about the states of its own analysis: each that loads the part needs one.
std::string unasked_words(const Study& study, const UnaskedPart& part, const Strengths& of_deck,
                          const Strengths& least) {
  std::vector<std::optional<std::string>> analyses = {std::nullopt};
  if (const auto loaded = study.model.loaded_in.find(part.name); loaded != study.model.loaded_in.end()) {
    analyses.assign(loaded->second.begin(), loaded->second.end());
  }
  std::vector<std::string> without;
  std::string why;
  for (const auto& analysis : analyses) {
    const StrengthLimit limit = strength_limit(study, part, of_deck, least, analysis);
    if (!limit.there) without.push_back(analysis.value_or(""));
    if (why.empty()) why = limit.why_not;
  }
  if (without.empty()) return {};
  if (why.empty()) why = without.size() < analyses.size() ? fmt::format("in {}", fmt::join(without, ", ")) : part.why;
  return why.empty() ? part.name : fmt::format("{} ({})", part.name, why);
}

/// Whether a limit of the study takes the place of a check: it is about the same value, in states of that analysis.
bool is_taken(const Study& study, const CaseFlaw& check, const Strengths& strengths) {
  const std::vector<LimitedValue> like = limits_like(check);
  return std::any_of(study.limits.begin(), study.limits.end(), [&](const StudyLimit& limit) {
    return speaks_of(study, limit, like, check.analysis) &&
           ends_at_strength(study, limit, part_of(check.check), strengths);
  });
}

/// Parts that need a limit of their strength in some cases and not in the deck as it is: a rope that a heavier load
/// tightens.
void add_unlimited_in_cases(const Study& study, const StudyData& data, const Strengths& least, Result& r) {
  std::map<std::pair<std::string, std::string>, SameFlaw> parts;  // by check and analysis
  for (const FlawedCase& one : data.flawed) {
    if (one.flaw.kind != CaseFlaw::Kind::unlimited || is_taken(study, one.flaw, least)) continue;
    SameFlaw& same = parts[{one.flaw.check, one.flaw.analysis}];
    if (same.first == nullptr) same.first = &one;
    ++same.cases;
  }
  for (const auto& [name, one] : parts) {
    r.unjudged.push_back(fmt::format("{} (in {} of {} cases, the first is case {}: {})", part_of(name.first), one.cases,
                                     study.size(), one.first->index,
                                     values_in_words(study, study.values_at(one.first->index))));
  }
}

/// What the deck as it is fails in a check that no case makes, and no limit of the study takes its place.
void add_failures_of_deck(const Study& study, const Unasked& unasked, const Strengths& strengths, Result& r) {
  for (const CaseFlaw& flaw : unasked.fails) {
    if (is_taken(study, flaw, strengths)) continue;
    r.unmade.push_back(
        fmt::format("the deck as it is fails {}, which no case makes and no 'limit' of the study is about: {}",
                    flaw.check, flaw.words));
  }
}

/// What would pass is looked at once more: a part that needs a limit has to have one, of the cases or of the study, and
/// what the deck as it is fails in a check that no case makes does not pass unseen.
void add_unasked(const Study& study, const StudyData& data, Result& r) {
  const auto verdict = verdict_of(r);
  const bool passes =
      verdict && (verdict->kind == VerdictKind::passes || verdict->kind == VerdictKind::passes_with_warnings);
  if (!passes) return;
  const Unasked unasked = study.model.unasked ? study.model.unasked() : Unasked{};
  const Strengths least = least_strengths(unasked.strengths, data);
  for (const UnaskedPart& part : unasked.parts) {
    if (std::string words = unasked_words(study, part, unasked.strengths, least); !words.empty()) {
      r.unjudged.push_back(std::move(words));
    }
  }
  add_unlimited_in_cases(study, data, least, r);
  add_failures_of_deck(study, unasked, least, r);
  std::vector<std::string> unmade;
  for (const Check& check : unasked.unmade) {
    const CaseFlaw like{
        .kind = CaseFlaw::Kind::fails, .check = check.name, .sense = check.sense, .analysis = unasked.analysis};
    if (check.limits && !is_taken(study, like, least)) unmade.push_back(check.name);
  }
  if (!unmade.empty()) put_before(fmt::format("no case makes the deck's {}", first_of(unmade)), r);
}

/// A study without a limit of its own is not judged, whatever its cases are. Said is whether they pass the checks of
/// the deck, where they make them all, and what the deck as it is fails in those that no case makes.
void add_unlimited(const Study& study, const StudyData& data, Result& r) {
  if (!study.limits.empty() || !r.checks.empty() || !r.unjudged.empty()) return;
  const bool fails = std::any_of(data.flawed.begin(), data.flawed.end(), [](const FlawedCase& one) {
    return one.flaw.kind == CaseFlaw::Kind::fails || one.flaw.kind == CaseFlaw::Kind::unmade;
  });
  if (fails || !data.failed.empty()) return;
  const Unasked unasked = study.model.unasked ? study.model.unasked() : Unasked{};
  std::vector<std::string> unmade;
  unmade.reserve(unasked.unmade.size());
  for (const Check& check : unasked.unmade) unmade.push_back(check.name);
  r.unjudged.push_back(
      unmade.empty()
          ? fmt::format("what the study asks for; none of the {} cases fails a check of the deck", study.size())
          : fmt::format("what the study asks for; no case makes the deck's {}", first_of(unmade)));
  add_failures_of_deck(study, unasked, unasked.strengths, r);
}

void add_given(const Study& study, Result& r) {
  Table t{.name = "inputs",
          .title = "What varies",
          .columns = {{.name = "input", .unit = si::one},
                      {.name = "law", .unit = si::one},
                      {.name = "in the deck", .unit = si::one}},
          .rows = {}};
  for (std::size_t i = 0; i < study.model.inputs.size(); ++i) {
    const CaseInput& input = study.model.inputs[i];
    t.rows.push_back({input.path, law_in_words(study, i), study.display.brief(input.base, input.unit)});
  }
  r.tables.push_back(std::move(t));
  const StudyRequest& request = study.request;
  static const std::map<StudyPoints, const char*> words = {{StudyPoints::random, "independent random numbers"},
                                                           {StudyPoints::latin, "Latin hypercubes"},
                                                           {StudyPoints::sobol, "scrambled Sobol points"},
                                                           {StudyPoints::grid, "a grid"}};
  std::string cases = fmt::format("{} cases on {}", study.size(), words.at(request.points));
  if (study.points) cases += fmt::format(", {} of them the sample, seed {}", study.sample.count, request.seed);
  r.assumptions.push_back(cases);
  if (study.points) {
    r.assumptions.push_back(
        fmt::format("intervals hold the true value with a confidence of {:.3g} %", 100 * request.confidence));
  }
  for (const CorrelateRequest& one : request.correlate) {
    r.assumptions.push_back(
        fmt::format("{} and {}: their Gaussian scores have the correlation {}", one.pair[0], one.pair[1], one.pair[2]));
  }
}

}  // namespace

Result study_result(const Study& study, const StudyData& data, const StudyOptions& options) {
  Result r;
  r.title = study.title.empty() ? "Study" : study.title;
  r.method = study.method;
  r.method_title = "Study of many cases";
  r.project = study.project;
  r.display = study.display.units();
  r.deck_name = study.deck_name;
  r.deck_hash = study.hash;
  r.overrides = study.overrides;
  r.exempt = study.model.exempt;
  r.left_out = study.model.left_out;
  add_given(study, r);
  Summary summary;
  if (study.points) {
    add_statistics(study, data, summary, r);
  } else {
    add_extremes(study, data, summary, r);
    add_grid_limits(study, data, r);
  }
  ChanceSummary rest;
  if (study.points) add_chance(study, data, options, rest, r);
  for (const ChanceSummary::Line& line : rest.lines) summary.add(line.of, line.what, line.unit, line.estimate);
  add_failed(study, data, r);
  add_not_run(study, r);
  add_flaws(study, data, r);
  add_unasked(study, data, r);
  add_unlimited(study, data, r);
  r.tables.push_back(std::move(summary).table());
  r.series.push_back(data.rows);
  add_study_figures(study, data, rest, r);
  return r;
}

}  // namespace taut::app
