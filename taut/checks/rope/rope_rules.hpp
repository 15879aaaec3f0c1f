#pragma once
#include <string>
#include <vector>

#include "taut/catalogue/rope.hpp"
#include "taut/checks/rope/rope_checks_deck.hpp"
#include "taut/rope/rope_check.hpp"

namespace taut::checks {

/// The rope with what the deck says beside the catalogue: construction, core, grade, area.
catalogue::RopeRow with_request(catalogue::RopeRow rope, const RopeCheckRequest& request);

/// The limits that a deck asks for, from the tables of rules, for this rope. Of a rule that is a range the safe end
/// counts. Complaints at paths below `path`.
rope::RopeRules rope_rules(const RopeCheckRequest& request, const catalogue::RopeRow& rope, const std::string& path,
                           std::vector<Complaint>& complaints);

}  // namespace taut::checks
