#include "taut/app/cases/said_by_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/prepare_machine.hpp"

namespace taut::app {
namespace {

bool is_beam(const MachineDeck& deck, const std::string& part) {
  const auto& beams = deck.machine.beams;
  return std::any_of(beams.begin(), beams.end(), [&](const auto& beam) { return beam.name == part; });
}

}  // namespace

std::string check_of_strength(const MachineDeck& deck, const std::string& part) {
  return part + (is_beam(deck, part) ? yield_check : breaking_check);
}

void add_new(const std::vector<std::string>& more, std::vector<std::string>& all) {
  for (const std::string& one : more) {
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  }
}

void SaidByCases::hear(const Result& r) {
  add_new(r.unjudged, unjudged);
  for (const Check& c : r.checks) {
    checks.insert(c.name);
    if (!c.passes) failing.insert(c.name);
  }
}

Unasked beside_cases(const MachineDeck& deck, const SaidByCases& cases, const std::string& only) {
  const Result whole = run_machine(deck, RunDepth::checks);
  Unasked found{.analysis = only, .strengths = strengths_of(whole)};
  std::vector<std::string> parts = whole.unjudged;
  add_new(cases.unjudged, parts);
  for (const std::string& part : parts) {
    const auto check =
        std::find_if(whole.checks.begin(), whole.checks.end(), [&](const Check& c) { return judges(c, part); });
    UnaskedPart& one = found.parts.emplace_back(UnaskedPart{.name = part, .is_beam = is_beam(deck, part)});
    if (check == whole.checks.end()) continue;
    one.why = fmt::format("no case makes the deck's {}", check->name);
    if (deck.checks) one.why += fmt::format(": name an output checks.{}", check->name);
  }
  for (const Check& c : whole.checks) {
    if (!cases.checks.contains(c.name)) found.unmade.push_back(c);
  }
  for (CaseFlaw& flaw : flaws_of(whole, deck.display)) {
    if (flaw.kind != CaseFlaw::Kind::fails || cases.failing.contains(flaw.check)) continue;
    flaw.analysis = only;
    found.fails.push_back(std::move(flaw));
  }
  return found;
}

}  // namespace taut::app
