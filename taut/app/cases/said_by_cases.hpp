#pragma once
#include <set>
#include <string>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/machine_deck.hpp"

namespace taut::app {

/// What the cases say of a deck of a machine as it is.
struct SaidByCases {
  std::vector<std::string> unjudged = {};      ///< parts
  std::set<std::string> checks = {}, failing;  ///< by name: all, and those that fail

  /// `r`: what the cases run, of the deck as it is.
  void hear(const Result& r);
};

/// What a run of the whole deck as it is says beside that. `only`: the analysis that is judged, as outputs name it;
/// empty: several.
Unasked beside_cases(const MachineDeck& deck, const SaidByCases& cases, const std::string& only);

/// The check of the strength of a part: "skyline.T_max"; of a beam "mast.stress_max".
std::string check_of_strength(const MachineDeck& deck, const std::string& part);

/// Puts those into others that are not there yet.
void add_new(const std::vector<std::string>& more, std::vector<std::string>& all);

}  // namespace taut::app
