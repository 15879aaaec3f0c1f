#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/rope.hpp"
#include "taut/checks/rope/rope_checks_deck.hpp"
#include "taut/rope/rope_check.hpp"

namespace taut::checks {

/// The rope with what the deck says beside the catalogue: construction and core; breaking force, diameter, grade and
/// area where it has none.
catalogue::RopeRow with_request(catalogue::RopeRow rope, const RopeCheckRequest& request);

/// Complains of a value of `checks:` beside another one of the rope (0: it has none), which would hide that.
void complain_of_second(const std::optional<double>& given, double known, const std::string& path,
                        std::vector<Complaint>& complaints);
/// The same of all values of a rope's check.
void complain_of_values(const RopeCheckRequest& request, catalogue::RopeRow rope, const std::string& path,
                        std::vector<Complaint>& complaints);

/// Complains of what the deck gives of a rope that a design chooses, and no candidate could have.
void complain_of_candidates(const RopeCheckRequest& request, const std::string& path,
                            std::vector<Complaint>& complaints);
/// A candidate of a design, which is judged by its own row: what the deck says beside it fills its gaps. `denied`: what
/// the deck says otherwise, below `path`.
catalogue::RopeRow candidate_with_request(catalogue::RopeRow rope, RopeCheckRequest request, const std::string& path,
                                          std::vector<std::string>& denied);

/// What a deck asks of a rope, with all its names found: good for any rope that a design may put in its place.
struct AskedRules {
  rope::RopeRules of_any_rope;      ///< without the limits that depend on the rope
  std::vector<std::string> fields;  ///< of use: "safety.crane_running.M4"
  std::string termination;          ///< by its name in the tables; empty: none, or none of theirs
  std::string unknown_termination;  ///< one that the tables do not have, with an efficiency of the deck
};

/// Complaints of names that the tables do not have, at paths below `path`.
AskedRules asked_rules(const RopeCheckRequest& request, const std::string& path, std::vector<Complaint>& complaints);

/// Whether a rope at this temperature, K, may be weaker than the cold one: a fibre core is not allowed there any more.
bool weakens(double temperature);

/// The limits that a deck asks for, from the tables of rules, for this rope. Of a rule that is a range the safe end
/// counts. `around`: the highest temperature of the machine, K, which a rope has of which none is said, where it is
/// hotter than the tables' first one, 100 degC.
rope::RopeRules rope_rules(const RopeCheckRequest& request, const AskedRules& asked, const catalogue::RopeRow& rope,
                           std::optional<double> around = std::nullopt);

/// A limit that the deck asks for by name, and the tables do not have for this rope.
struct MissingLimit {
  const char* key;    ///< of the deck
  std::string words;  ///< why, and what to give instead
};
std::vector<MissingLimit> missing_limits(const RopeCheckRequest& request, const AskedRules& asked,
                                         const catalogue::RopeRow& rope, const rope::RopeRules& rules,
                                         const Display& display = {});

/// Complaints of them, for the rope of the deck.
void complain_of_limits(const RopeCheckRequest& request, const AskedRules& asked, const catalogue::RopeRow& rope,
                        const std::string& path, std::vector<Complaint>& complaints);

}  // namespace taut::checks
