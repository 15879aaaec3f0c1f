#include "taut/app/cases/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "taut/base/on_limit.hpp"
#include "taut/base/suggest.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut::app {
namespace {

constexpr const char* utilisation = ".utilisation";

struct FoundValue {
  std::string name;  ///< in the result: the same for all spellings
  double value = 0;
  Unit unit;
  std::string label;
};

std::optional<FoundValue> find_in_values(const Result& r, const WantedValue& wanted) {
  for (const std::string& name : {wanted.name, wanted.name + wanted.ending}) {
    if (const Value* v = r.find_value(name)) {
      return FoundValue{.name = v->name, .value = v->value, .unit = v->unit, .label = v->label};
    }
  }
  return std::nullopt;
}

std::optional<FoundValue> find_in_checks(const Result& r, const WantedValue& wanted) {
  for (const Check& c : r.checks) {
    if (c.name == wanted.name) return FoundValue{.name = c.name, .value = c.value, .unit = c.unit, .label = c.rule};
    if (c.name + utilisation == wanted.name) {
      return FoundValue{
          .name = wanted.name, .value = c.utilisation, .unit = si::one, .label = "utilisation: " + c.rule};
    }
  }
  return std::nullopt;
}

std::optional<FoundValue> find(const Result& r, const WantedValue& wanted) {
  auto found = wanted.checks_first ? find_in_checks(r, wanted) : find_in_values(r, wanted);
  if (found) return found;
  return wanted.checks_first ? find_in_values(r, wanted) : find_in_checks(r, wanted);
}

std::vector<std::string> names_in(const Result& r) {
  std::vector<std::string> names;
  names.reserve(r.values.size() + r.checks.size());
  for (const Value& v : r.values) names.push_back(v.name);
  for (const Check& c : r.checks) names.push_back(c.name);
  return names;
}

/// "a, b, c and 12 more".
std::string first_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
  const std::string more = names.size() > most ? fmt::format(" and {} more", names.size() - most) : std::string{};
  return fmt::format("{}{}", fmt::join(first, ", "), more);
}

/// A number that changes has one value in a case, so that it may be given once only.
void take(CaseInput input, const CaseName& name, CaseModel& made, NoCases& wrong) {
  const auto same = std::find_if(made.inputs.begin(), made.inputs.end(),
                                 [&](const CaseInput& other) { return other.place == input.place; });
  if (same != made.inputs.end()) {
    wrong.complaints.push_back(
        {name.place, fmt::format("'{}' is the same number of the deck as '{}': give it once", input.path, same->path)});
  }
  made.inputs.push_back(std::move(input));
}

/// The first thing that was asked for and is not judged; empty: all is.
std::string unmade_in(const Result& r) {
  if (!r.unmade.empty()) return r.unmade.front();
  const auto refused = std::find_if(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.refused; });
  return refused == r.checks.end() ? std::string{} : refused->name + " rests on an unverified limit";
}

}  // namespace

void add_input(const FoundParameter& parameter, const CaseName& name, CaseModel& made, NoCases& wrong) {
  if (!parameter) {
    wrong.complaints.push_back({name.place, parameter.error()});
    return;
  }
  if (std::isnan(parameter->value)) {
    wrong.complaints.push_back(
        {name.place, fmt::format("'{}' has no value in the deck that could change: write one there", name.name)});
  }
  take({.path = name.name,
        .unit = parameter->unit,
        .range = parameter->range(),
        .base = parameter->value,
        .place = parameter->place},
       name, made, wrong);
}

void add_input(tl::expected<CaseInput, std::string> parameter, const CaseName& name, CaseModel& made, NoCases& wrong) {
  if (parameter) {
    take(std::move(*parameter), name, made, wrong);
  } else {
    wrong.complaints.push_back({name.place, parameter.error()});
  }
}

bool is_parameter(const std::string& path) { return path.starts_with("parameters."); }

std::string assignment(const CaseInput& input, double value) {
  if (counts_from_zero_celsius(input.unit)) return fmt::format("{}={:.17g} degC", input.path, value - zero_celsius);
  if (is_percentage(input.unit)) return fmt::format("{}={:.17g} %", input.path, 100 * value);
  return fmt::format("{}={:.17g}{}{}", input.path, value, input.unit.needs_text() ? " " : "",
                     input.unit.needs_text() ? input.unit.symbol : "");
}

void add_outputs(const Result& r, const std::vector<WantedValue>& wanted, CaseModel& made, NoCases& wrong) {
  if (const Outcome outcome = study::outcome_of_case(r); !outcome.ok()) {
    wrong.outcome = {.status = outcome.status, .message = "the deck as it is has no answer: " + outcome.message};
    return;
  }
  const std::vector<std::string> names = names_in(r);
  std::map<std::string, std::size_t> asked;  // outputs by the name of their value
  for (const WantedValue& one : wanted) {
    const auto found = find(r, one);
    if (!found) {
      const std::string hint = did_you_mean(one.name, names);
      const std::string list = hint.empty() ? "; it has " + first_names(names) : hint;
      wrong.complaints.push_back({one.place, fmt::format("there is no value '{}' in its result{}", one.name, list)});
      continue;
    }
    const auto [same, is_new] = asked.try_emplace(found->name, one.output);
    if (!is_new) {
      wrong.complaints.push_back(
          {one.place, fmt::format("'{}' is the same value as '{}': give it once", made.outputs[one.output].name,
                                  made.outputs[same->second].name)});
    }
    CaseOutput& output = made.outputs[one.output];
    output.unit = found->unit;
    output.label = found->label;
    output.base = found->value;
  }
}

namespace {

/// Why a value of a part has no number, where the result tells.
std::string why_none(const Result& r, const std::string& name) {
  const std::string part = name.substr(0, name.rfind('.')) + ": ";
  const auto told =
      std::find_if(r.unmade.begin(), r.unmade.end(), [&](const auto& words) { return words.starts_with(part); });
  return fmt::format("the result has no '{}'{}", name, told == r.unmade.end() ? "" : "; " + *told);
}

}  // namespace

Outcome take_values(const Result& r, const std::vector<WantedValue>& wanted, std::vector<double>& outputs) {
  if (Outcome outcome = study::outcome_of_case(r); !outcome.ok()) return outcome;
  for (const WantedValue& one : wanted) {
    const auto found = find(r, one);
    if (!found || std::isnan(found->value)) return infeasible(why_none(r, one.name));
    outputs[one.output] = found->value;
  }
  return {};
}

std::map<std::string, double> strengths_of(const Result& r) {
  std::map<std::string, double> strengths;
  for (const Check& c : r.checks) {
    for (const std::string_view kind : {breaking_check, yield_check}) {
      if (!c.limits && c.name.ends_with(kind)) strengths[c.name.substr(0, c.name.size() - kind.size())] = c.limit;
    }
    if (!c.limits && c.name.ends_with(breaking_of_method)) strengths[c.part] = c.limit;
  }
  return strengths;
}

void keep_least(const std::map<std::string, double>& more, std::map<std::string, double>& all) {
  for (const auto& [part, strength] : more) {
    const auto [at, is_new] = all.try_emplace(part, strength);
    if (!is_new) at->second = std::min(at->second, strength);
  }
}

void add_weaker(const Result& r, const std::map<std::string, double>& known, std::map<std::string, double>& weaker) {
  std::map<std::string, double> own = strengths_of(r);
  std::erase_if(own, [&](const auto& one) {
    const auto base = known.find(one.first);
    return base != known.end() && one.second >= base->second - rounding_on(base->second);
  });
  keep_least(own, weaker);
}

std::vector<CaseFlaw> flaws_of(const Result& r, const Display& display) {
  std::vector<CaseFlaw> flaws;
  for (const Check& c : r.checks) {
    if (c.passes || c.refused) continue;
    flaws.push_back({.kind = CaseFlaw::Kind::fails,
                     .check = c.name,
                     .words = against_limit(c, display),
                     .fact = !c.limits,
                     .sense = c.sense});
  }
  if (std::string words = unmade_in(r); !words.empty()) {
    flaws.push_back({.kind = CaseFlaw::Kind::unmade, .check = {}, .words = std::move(words)});
  }
  if (std::vector<std::string> unsafe = unsafe_of(r); !unsafe.empty()) {
    flaws.push_back({.kind = CaseFlaw::Kind::unsafe, .check = {}, .words = std::move(unsafe.front())});
  }
  return flaws;
}

SaidOfDeck said_of_deck(const Result& r) { return {.unjudged = r.unjudged, .choices = r.choices}; }

void add_other(const Result& r, const SaidOfDeck& deck,
               const std::function<std::string(const std::string& part)>& check_of, std::vector<CaseFlaw>& flaws) {
  for (const std::string& part : r.unjudged) {
    if (std::find(deck.unjudged.begin(), deck.unjudged.end(), part) != deck.unjudged.end()) continue;
    flaws.push_back({.kind = CaseFlaw::Kind::unlimited, .check = check_of(part)});
  }
  std::vector<std::string> others;
  for (const auto& [part, choice] : r.choices) {
    const auto known = deck.choices.find(part);
    if (known == deck.choices.end() || known->second == choice) continue;
    others.push_back(fmt::format("{} {} in place of {}", part, choice, known->second));
  }
  if (others.empty()) return;
  flaws.push_back({.kind = CaseFlaw::Kind::chooses, .words = fmt::format("{}", fmt::join(others, ", "))});
}

}  // namespace taut::app
