#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/rope/rope_check.hpp"

/// The block `checks:` at work. One pair of functions for each kind of part: one that complains of the deck before
/// anything is computed, and keeps what it has found by name, one that adds checks, values and tables to the result. To
/// add a kind: a member of ChecksRequest, the pair in a file of its own, and a line in each of the two functions of
/// checks.cpp.
namespace taut::checks {

/// Complains of what is wrong with a machine's checks, at paths below "checks". What they name is for the deck to keep;
/// `deck.asked` is not looked at.
AskedChecks resolve(const CheckedDeck& deck, const machine::Model& model, std::vector<Complaint>& complaints);

/// Adds the checks that a machine's deck asks for, with the names in `deck.asked`; then all checks of the result stand
/// in groups by part, the worst first, what rests on unverified numbers is refused where the deck says so, and the
/// verdict's scope is known.
void add_checks(const CheckedDeck& deck, const machine::Model& model, const CheckedParts& seen, Result& r);

/// Complains of texts under `confirmed` that name no source, and would be found in the words of most rules.
void complain_of_confirmed(const ChecksRequest& request, std::vector<Complaint>& complaints);

/// The last step of both wings: groups, and the refusal.
void finish_checks(const ChecksRequest& request, Result& r);

// Ropes of a machine: rope_checks.cpp.
std::vector<AskedRules> resolve_ropes(const ChecksRequest& request, const CheckedDeck& deck,
                                      const machine::Model& model, std::vector<Complaint>& complaints);
/// The rope with what the deck says beside the catalogue. Of a candidate of a design that it denies, it tells so.
void put_request(const RopeCheckRequest& request, rope::RopeUse& use, Result& r);
/// All that is to be reported of one rope: checks, and what was left out. `around`: as of `rope_rules`.
void add_checks_of(const RopeCheckRequest& request, const AskedRules& asked, const rope::RopeUse& use, Result& r,
                   std::optional<double> around = std::nullopt);
/// `uses`: by reeving, over all states that are load cases.
void add_rope_checks(const ChecksRequest& request, const CheckedDeck& deck, const machine::Model& model,
                     const std::vector<rope::RopeUse>& uses, Result& r);

}  // namespace taut::checks
