#pragma once
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/checks/anchor/support_checks_deck.hpp"
#include "taut/checks/guy/guy_checks_deck.hpp"
#include "taut/checks/mast/mast_checks_deck.hpp"
#include "taut/checks/rope/rope_checks_deck.hpp"
#include "taut/checks/yarder/yarder_checks_deck.hpp"

namespace taut::checks {

/// The block `checks:` of a deck: which parts are checked by which rules. A kind of parts is a member here, with its
/// fields and its checks in files of its own (checks.hpp).
struct ChecksRequest {
  std::vector<RopeCheckRequest> ropes;
  std::vector<MastCheckRequest> masts;
  std::vector<GuyCheckRequest> guys;
  std::vector<AnchorCheckRequest> anchors;
  std::vector<LineCheckRequest> lines;
  std::vector<SupportCheckRequest> supports;
  std::vector<YarderCheckRequest> yarders;
  std::vector<std::string> confirmed;  ///< rules that the user has compared with their sources
  std::vector<std::string> exempt;     ///< parts that the verdict does not speak of
  bool refuse_unverified = false;      ///< a check on an unverified limit does not pass
  static const Description& describe();
};

}  // namespace taut::checks
