#include "taut/checks/rope/rope_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/checks/rope/rope_rules.hpp"
#include "taut/checks/rope/rope_uses.hpp"
#include "taut/rope/rope_check.hpp"
#include "taut/study/analyses.hpp"

namespace taut::checks {
namespace {

std::size_t number_of_ropes(const machine::Machine& machine) { return machine.reevings.size() + machine.guys.size(); }

/// As of a candidate of a design, or as the deck has it.
catalogue::RopeRow row_with_request(const CheckedDeck& deck, const std::string& rope, const RopeCheckRequest& request) {
  catalogue::RopeRow row = row_in(deck, rope);
  if (!deck.chosen.contains(rope)) return with_request(std::move(row), request);
  std::vector<std::string> denied;  // add_rope_checks tells of these
  return candidate_with_request(std::move(row), request, {}, denied);
}

}  // namespace

std::string reeving_name_of(const machine::Machine& machine, std::size_t reeving) {
  const std::size_t first_guy = machine.reevings.size();
  return reeving < first_guy ? name_of(machine.reevings[reeving]) : machine.guys[reeving - first_guy].name;
}

std::vector<std::size_t> reevings_named(const std::string& name, const machine::Machine& machine) {
  std::vector<std::size_t> own;
  std::vector<std::size_t> of_rope;
  for (std::size_t i = 0; i < number_of_ropes(machine); ++i) {
    if (reeving_name_of(machine, i) == name) own.push_back(i);
    if (rope_name_of(machine, i) == name) of_rope.push_back(i);
  }
  return own.empty() ? of_rope : own;
}

std::optional<std::size_t> entry_of(const CheckedDeck& deck, std::size_t reeving) {
  if (!deck.checks) return std::nullopt;
  std::optional<std::size_t> of_rope;
  for (std::size_t k = 0; k < deck.checks->ropes.size(); ++k) {
    const std::string& name = deck.checks->ropes[k].name;
    if (name == reeving_name_of(deck.machine, reeving)) return k;
    const std::vector<std::size_t> named = reevings_named(name, deck.machine);
    if (std::find(named.begin(), named.end(), reeving) != named.end()) of_rope = k;
  }
  return of_rope;
}

std::vector<std::size_t> reevings_of_entry(const CheckedDeck& deck, std::size_t entry) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < number_of_ropes(deck.machine); ++i) {
    if (entry_of(deck, i) == entry) all.push_back(i);
  }
  return all;
}

StrengthInUse strength_in_use(const CheckedDeck& deck, std::size_t reeving, std::optional<double> around) {
  StrengthInUse in_use;
  if (const auto entry = entry_of(deck, reeving)) {
    const RopeCheckRequest& request = deck.checks->ropes[*entry];
    const catalogue::RopeRow row = row_with_request(deck, rope_name_of(deck.machine, reeving), request);
    const rope::RopeRules rules = rope_rules(request, deck.asked.ropes.at(*entry), row, around);
    in_use.share = rope::heat_share(rules);
    in_use.unknown = rules.no_strength;
    if (in_use.share < 1) {
      in_use.words = fmt::format(" x {:.3g} ({})", in_use.share, rules.heat_strength->rule);
      rope::add_doubt(rules.heat_strength->trust, rules.heat_strength->rule, in_use.doubts);
    }
  }
  add_doubt_of_rope(deck, reeving, in_use.doubts);
  return in_use;
}

StrengthInUse strength_in_use(const CheckedDeck& deck, std::size_t reeving) {
  return strength_in_use(deck, reeving, study::hottest_of(deck.machine, deck.analyses));
}

void add_doubt_of_rope(const CheckedDeck& deck, std::size_t reeving, std::vector<Doubt>& doubts) {
  const catalogue::RopeRow row = row_in(deck, rope_name_of(deck.machine, reeving));
  if (!(row.breaking_force > 0)) return;
  std::vector<Doubt> own;
  rope::add_doubt_of_rope(row, own);
  for (Doubt& one : own) {
    const bool known =
        std::any_of(doubts.begin(), doubts.end(), [&](const Doubt& other) { return other.source == one.source; });
    if (!known) doubts.push_back(std::move(one));
  }
}

}  // namespace taut::checks
