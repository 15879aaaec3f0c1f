#pragma once
#include <vector>

#include "taut/checks/rope/rope_rules.hpp"

namespace taut::checks {

/// What a deck's checks name, found once when the deck is read. A design that changes ropes does not change it.
struct AskedChecks {
  std::vector<AskedRules> ropes;  ///< by ChecksRequest::ropes
};

}  // namespace taut::checks
