#include "taut/checks/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "taut/checks/checks.hpp"
#include "taut/checks/rope/rope_rules.hpp"
#include "taut/study/analyses.hpp"
#include "taut/study/deck/temperature.hpp"

namespace taut::checks {
namespace {

bool is_judged(const Result& r, const std::string& part) {
  return std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return judges(c, part); });
}

std::set<std::string> weakened_ropes(const CheckedDeck& deck, const machine::Model& model) {
  std::set<std::string> names;
  if (!deck.checks) return names;
  for (const RopeCheckRequest& one : deck.checks->ropes) {
    for (const std::size_t i : reevings_named(one.name, deck, model)) names.insert(model.reevings[i].name);
  }
  return names;
}

void leave_open(std::string words, Result& r) {
  r.warnings.push_back(words);
  r.unmade.push_back(std::move(words));
}

}  // namespace

void add_unjudged_heat(const CheckedDeck& deck, const machine::Model& model, Result& r) {
  const std::optional<double> hottest = study::hottest_of(deck.machine, deck.analyses);
  if (!hottest || !weakens(*hottest)) return;
  const std::string hot = study::celsius(*hottest);
  const std::set<std::string> weakened = weakened_ropes(deck, model);
  for (const machine::Reeving& rope : model.reevings) {
    if (weakened.contains(rope.name) || !is_judged(r, rope.name)) continue;
    leave_open(
        fmt::format("{}: how much weaker it is at {} is not checked: name it under 'checks: ropes'", rope.name, hot),
        r);
  }
  for (const machine::Beam& beam : model.beams) {
    if (!is_judged(r, beam.name)) continue;
    leave_open(fmt::format("{}: its steel is weaker and softer at {}; that is not checked", beam.name, hot), r);
  }
}

}  // namespace taut::checks
