#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/checks/checked_deck.hpp"

/// What `checks: ropes` says of the strength of a rope, for all checks that measure by it. Ropes are known by their
/// place in the model: reevings first, then guys.
namespace taut::checks {

/// The name of a reeving or guy.
std::string reeving_name_of(const machine::Machine& machine, std::size_t reeving);

/// The ropes that a name under `checks: ropes` may mean: the reeving or guy of that name, else all of a rope.
std::vector<std::size_t> reevings_named(const std::string& name, const machine::Machine& machine);

/// The entry of `checks: ropes` by which a rope is judged, in their order: its own, else that of what it is made of.
/// There is one at most.
std::optional<std::size_t> entry_of(const CheckedDeck& deck, std::size_t reeving);

/// The ropes that are judged by that entry.
std::vector<std::size_t> reevings_of_entry(const CheckedDeck& deck, std::size_t entry);

/// What is left of a rope's breaking force in use.
struct StrengthInUse {
  double share = 1;           ///< in its heat; NaN: no strength is known there
  std::string unknown;        ///< why none is; empty: it is
  std::string words;          ///< " x 0.75 (up to 400 degC ...)"; empty: all of it
  std::vector<Doubt> doubts;  ///< the unverified numbers in it: of the heat, and the breaking force itself
};

/// By its entry under `checks: ropes`. `around`: the highest temperature of the machine, K. Without an entry it is all
/// of the cold strength; add_unjudged_heat tells of hot ropes without one.
StrengthInUse strength_in_use(const CheckedDeck& deck, std::size_t reeving, std::optional<double> around);
/// The same with the highest temperature of all analyses.
StrengthInUse strength_in_use(const CheckedDeck& deck, std::size_t reeving);

/// Adds the doubt of a rope's own breaking force, once. None of one that the deck gives.
void add_doubt_of_rope(const CheckedDeck& deck, std::size_t reeving, std::vector<Doubt>& doubts);

}  // namespace taut::checks
