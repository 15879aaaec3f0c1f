#include "taut/design/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/answers.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/design/design_checks.hpp"
#include "taut/design/design_search.hpp"
#include "taut/design/design_tables.hpp"
#include "taut/units/display.hpp"
#include "taut/units/parse.hpp"

namespace taut::design {
namespace {

/// "60 kN" for each unknown; without `digits` as brief as results are.
std::vector<std::string> values_as_text(const DesignSpace& space, const std::vector<double>& values,
                                        const Display& display, std::optional<int> digits = {}) {
  std::vector<std::string> all;
  all.reserve(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Unit& unit = space.unknowns[k].unit;
    if (!digits) {
      all.push_back(display.brief(values[k], unit));
      continue;
    }
    const std::string number = short_number(display.from_si(values[k], unit), *digits), shown = display.unit(unit);
    all.push_back(shown.empty() ? number : fmt::format("{} {}", number, shown));
  }
  return all;
}

/// "pull = 60 kN" of each unknown.
std::string values_in_words(const DesignSpace& space, const std::vector<std::string>& texts) {
  std::string all;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    all += fmt::format("{}{} = {}", k == 0 ? "" : ", ", space.unknowns[k].name, texts[k]);
  }
  return all;
}

/// Whether a deck with these values in place of the found ones passes too; so it does with those that no deck can say.
bool passes_with(const DesignTask& task, const DesignPlace& found, const std::vector<std::string>& texts) {
  DesignPlace place = found;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const auto value = parse_quantity(texts[k], task.space.unknowns[k].unit);
    if (value) place.values[k] = *value;
  }
  return place.values == found.values || trial_of(task.run(place, Depth::checks, {}).result, task.list_of).passes;
}

/// The values that are found, as brief as a deck with them passes: the limit that holds them is near on one side.
std::vector<std::string> values_to_build(const DesignTask& task, const DesignPlace& best) {
  constexpr int most_digits = 15;  // of a double that all decimals of that length survive
  std::vector<std::string> texts = values_as_text(task.space, best.values, task.display);
  for (int digits = 5; digits <= most_digits && !passes_with(task, best, texts); ++digits) {
    texts = values_as_text(task.space, best.values, task.display, digits);
  }
  return texts;
}

std::string place_in_words(const DesignSpace& space, const DesignPlace& place, const Display& display) {
  const std::string choice = names_of(space, place.choice);
  const std::string values = values_in_words(space, values_as_text(space, place.values, display));
  return choice + (choice.empty() || values.empty() ? "" : " with ") + values;
}

/// "; load case beyond has no answer for any choice: ..."; empty: each has one for some choice.
std::string unanswered_in_words(const DesignFound& found) {
  std::string words;
  for (const auto& [name, why] : found.unanswered) {
    words += fmt::format("; load case {} has no answer for any choice: {}", name, why);
  }
  return words;
}

/// What no trial has been spent on, and what that means.
std::string aside_in_words(std::size_t aside, const char* of) {
  return fmt::format(
      "{} {}choices were set aside without a trial, because a part of each failed by far with other choices: that none "
      "of them passes is likely, not proven; narrow the candidates down to have all tried",
      aside, of);
}

Result no_design(const DesignTask& task, const DesignFound& found) {
  Result r;
  r.method_title = task.method_title;
  r.given = task.given;
  r.status = Status::infeasible;
  std::string why = "no choice passes all checks";
  for (const DesignPoint& point : found.points) {
    if (point.answer.outcome.status != Status::not_converged || point.answer.ended) continue;
    r.status = Status::not_converged;
    why = point.answer.outcome.message;
  }
  if (found.ended) {
    r.interrupted = true;
    r.status = Status::not_converged;
    why = fmt::format("interrupted after {:.0f} trials, before any choice passed", found.trials);
  }
  std::size_t aside = 0;
  for (const DesignPoint& point : found.points) aside += point.answer.aside.size();
  if (aside > 0) r.warnings.push_back("design: " + aside_in_words(aside, ""));
  if (aside > 0 && !found.ended) why += fmt::format(" of those tried ({} were set aside, see the warning)", aside);
  r.message = "design: " + why + unanswered_in_words(found);
  const DesignPlace nearest =
      found.all_but_unanswered.value_or(DesignPlace{.choice = found.nearest.choice, .values = found.nearest_values});
  const std::string place = place_in_words(task.space, nearest, task.display);
  const design::SizingTrial& last = found.nearest.trial;
  if (found.all_but_unanswered) {
    r.message += fmt::format("; nothing else stands against {}", place);
    add_answer_line(r, nearest_label, {place, "passes all cases that have an answer"});
  } else if (!last.governs.empty() && (found.unanswered.empty() || std::isfinite(last.utilisation))) {
    const std::string use =
        std::isfinite(last.utilisation) ? fmt::format(" (utilisation {:.3g})", last.utilisation) : std::string{};
    r.message += fmt::format("; the nearest, {}, fails by {}{}", place, last.governs, use);
    add_answer_line(r, nearest_label, {place, fmt::format("fails by {}{}", last.governs, use)});
  }
  if (task.picture) {
    const bool tried = !nearest.choice.empty() || !nearest.values.empty();
    task.picture(tried ? nearest : first_place(task.space), r);
  }
  if (!found.points.empty()) add_runner_ups(task, found.points.front().answer, {}, r);
  if (found.points.size() > 1) add_trade_off(task, found.points, r);
  return r;
}

/// Whether what is sought is the same at the other end of the range of an unknown: the reserve alone led there. Where
/// there is a choice too, the unknown may let a cheaper one pass.
bool costs_the_same(const DesignTask& task, const std::vector<double>& values, std::size_t unknown) {
  if (is_measured(task.request.seek) || !task.space.ropes.empty() || !task.space.sections.empty()) return false;
  const UnknownValues& one = task.space.unknowns[unknown];
  std::vector<double> other = values;
  other[unknown] = one.high - other[unknown] < other[unknown] - one.low ? one.low : one.high;
  return task.lengths(other) == task.lengths(values);
}

/// What a reader should know of where the answer lies.
void add_warnings(const DesignTask& task, const DesignFound& found, Result& r) {
  for (std::size_t k = 0; k < found.best.values.size(); ++k) {
    const UnknownValues& one = task.space.unknowns[k];
    const double value = found.best.values[k];
    const double from_end = std::min(value - one.low, one.high - value);
    // as near as the search goes
    if (!(from_end <= finest_share * (one.high - one.low))) continue;
    r.warnings.push_back(fmt::format("design: {} is at an end of its range, {}: {}", one.name,
                                     task.display.quantity(value, one.unit),
                                     costs_the_same(task, found.best.values, k)
                                         ? "what is sought does not change with it, so it has the most reserve here"
                                         : "beyond it there may be a better design"));
  }
  for (const std::string& name : task.request.disregard) {
    Result without = r;
    disregard({name}, without);
    if (without.checks.size() == r.checks.size()) {
      r.warnings.push_back(fmt::format("design: there is no check '{}' to disregard", name));
    }
  }
  if (const std::size_t aside = found.best.answer.aside.size(); aside > 0)
    r.warnings.push_back("design: " + aside_in_words(aside, is_measured(task.request.seek) ? "" : "cheaper "));
  if (r.checks.empty()) r.warnings.emplace_back("design: no check holds the choice; the deck asks for none");
}

/// Marks the inputs that the choice has changed. What a load case has set is not chosen.
void mark_chosen(const DesignTask& task, const DesignPlace& best, std::vector<Given>& given) {
  if (!task.given_with) return;
  const auto same = [](const Given& a, const Given& b) { return a.numbers == b.numbers && a.text == b.text; };
  for (const Given& one : task.given_with(best)) {
    const auto of_key = [&](const Given& g) { return g.key == one.key; };
    const auto before = std::find_if(task.given.begin(), task.given.end(), of_key);
    if (before != task.given.end() && same(*before, one)) continue;
    const auto used = std::find_if(given.begin(), given.end(), of_key);
    if (used != given.end()) used->chosen = true;
  }
}

/// What was chosen, where the calculation itself does not say it: ropes, sections, values.
void add_chosen(const DesignTask& task, const DesignPlace& best, bool ended, Result& r) {
  const bool said =
      std::any_of(r.answers.begin(), r.answers.end(), [](const Answer& a) { return a.label == build_label; });
  const std::size_t ropes = task.space.ropes.size();
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < ropes && !said; ++k) {
    const RopeCandidates& one = task.space.ropes[k];
    parts.push_back(fmt::format("{} {}", one.name, catalogue::words_of_rope(one.rows[best.choice[k]])));
  }
  for (std::size_t k = 0; k < task.space.sections.size(); ++k) {
    const SectionCandidates& one = task.space.sections[k];
    const catalogue::SectionRow& row = one.rows[best.choice[ropes + k]];
    const bool named = std::any_of(r.answers.begin(), r.answers.end(), [&](const Answer& a) {
      return a.label == build_label && a.text.find(row.name) != std::string::npos;
    });
    if (!named) parts.push_back(fmt::format("{} {} ({})", one.name, row.name, row.standard));
  }
  const std::string values = values_in_words(
      task.space, ended ? values_as_text(task.space, best.values, task.display) : values_to_build(task, best));
  if (!values.empty()) parts.push_back(values);
  add_answer_line(r, build_label, parts);
}

void add_choices(const DesignTask& task, const DesignPlace& best, Result& r) {
  const std::size_t ropes = task.space.ropes.size();
  for (std::size_t k = 0; k < ropes; ++k) {
    r.choices[task.space.ropes[k].name] = task.space.ropes[k].rows[best.choice[k]].id;
  }
  for (std::size_t k = 0; k < task.space.sections.size(); ++k) {
    const SectionCandidates& one = task.space.sections[k];
    r.choices[one.name] = one.rows[best.choice[ropes + k]].name;
  }
  for (std::size_t k = 0; k < task.space.unknowns.size(); ++k) {
    r.choices[task.space.unknowns[k].parameter] = fmt::format("{:.6g}", best.values[k]);
  }
}

}  // namespace

Result run_design(const DesignTask& task) {
  const DesignFound found = search_design(task);
  if (!found.feasible) return no_design(task, found);
  // not asked whether to go on: it is short beside the search, and all that an interrupted one leaves
  const DesignPlace best{.choice = found.best.answer.best.choice, .values = found.best.values};
  Result r = task.run(best, Depth::report, {}).result;
  add_design(task, found, r);
  mark_chosen(task, best, r.given);
  add_chosen(task, best, found.ended, r);
  add_choices(task, best, r);
  add_warnings(task, found, r);
  if (found.ended) {
    r.interrupted = true;
    r.status = Status::not_converged;
    r.message =
        fmt::format("design: interrupted after {:.0f} trials; this is the best design up to there", found.trials);
  }
  return r;
}

}  // namespace taut::design
