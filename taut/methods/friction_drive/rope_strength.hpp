#pragma once
#include <optional>

#include "taut/catalogue/rope.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"

namespace taut::friction_drive {

/// The rule for D/d that fits the rope: its maker's advice for that construction, else the one for mainline blocks.
std::optional<catalogue::RuleRow> diameter_rule(const catalogue::RopeRow& rope);

/// The rope as the catalogue has it, if one is named. Takes inputs without complaints.
std::optional<catalogue::RopeRow> rope_of(const Input& in);

/// Safety factor, D/d and their checks and warnings, into `out` and `r`.
void check_rope(const Input& in, const catalogue::RopeRow& rope, const Display& display, Output& out, Result& r);

/// Where the take-up of the deck pulls the tight branch with more, `tension` (N): the check that the rope does not
/// break and the safety factor of `r` are those of that tension.
void take_tension(const catalogue::RopeRow& rope, double tension, Result& r);

}  // namespace taut::friction_drive
