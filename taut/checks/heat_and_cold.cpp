#include "taut/checks/heat_and_cold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "taut/checks/checks.hpp"
#include "taut/checks/parts.hpp"
#include "taut/checks/rope/rope_rules.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/study/analyses.hpp"
#include "taut/study/deck/temperature.hpp"

namespace taut::checks {
namespace {

bool is_judged(const Result& r, const std::string& part) {
  return std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return judges(c, part); });
}

/// Masts that the checks describe, beside the beams of the machine.
std::vector<std::string> masts_of_their_own(const CheckedDeck& deck, const machine::Model& model) {
  std::vector<std::string> names;
  if (!deck.checks) return names;
  for (const MastCheckRequest& one : deck.checks->masts) {
    const bool of_beams =
        !one.beams.empty() || std::any_of(model.beams.begin(), model.beams.end(),
                                          [&](const machine::Beam& beam) { return beam.name == one.name; });
    if (!of_beams) names.push_back(one.name);
  }
  return names;
}

std::string soft_steel(const std::string& part, const std::string& hot) {
  return fmt::format("{}: its steel is weaker and softer at {}; that is not checked", part, hot);
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
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const machine::Reeving& rope = model.reevings[i];
    if (entry_of(deck, i) || !is_judged(r, rope.name)) continue;
    const AboutPart about(r, {.kind = PartKind::rope, .name = rope.name});
    leave_open(
        fmt::format("{}: how much weaker it is at {} is not checked: name it under 'checks: ropes'", rope.name, hot),
        r);
  }
  for (const machine::Beam& beam : model.beams) {
    if (!is_judged(r, beam.name)) continue;
    const AboutPart about(r, {.kind = PartKind::beam, .name = beam.name});
    leave_open(soft_steel(beam.name, hot), r);
  }
  for (const std::string& mast : masts_of_their_own(deck, model)) {
    const AboutPart about(r, part_of_mast(model, mast));
    leave_open(soft_steel(mast, hot), r);
  }
}

void warn_of_cold(const CheckedDeck& deck, Result& r) {
  constexpr double coldest_in_use = 273.15 - 40;
  std::optional<double> coldest = study::coldest_of(deck.machine, deck.analyses);
  if (deck.checks) {
    for (const RopeCheckRequest& one : deck.checks->ropes) {
      if (one.temperature) coldest = std::min(*one.temperature, coldest.value_or(*one.temperature));
    }
  }
  if (!coldest || *coldest >= coldest_in_use || r.checks.empty()) return;
  warn_unsafe(r, fmt::format("at {}: ropes, lubricants and steels may be brittle; below -40 degC their makers must "
                             "allow it (EN 12385-3, EN 1993-1-10)",
                             study::celsius(*coldest)));
}

}  // namespace taut::checks
