#pragma once
#include <functional>
#include <vector>

#include "taut/app/machine_deck.hpp"
#include "taut/calc/result.hpp"
#include "taut/io/node.hpp"

namespace taut::app {

/// A rope that is free, with its candidates in the order of what is sought.
struct RopeCandidates {
  std::string name;    ///< of the machine's rope
  double modulus = 0;  ///< Pa
  double length = 1;   ///< straight length of all that is reeved of it, all copies, m: weighs the costs
  std::vector<catalogue::RopeRow> rows;
  std::vector<double> costs;  ///< ascending
};

/// What a design searches through.
struct DesignSpace {
  std::vector<RopeCandidates> ropes;
};

/// The candidates of a deck's design, or what is wrong with it: mistakes of the catalogue's file and of the block
/// `design`, each at its place.
DesignSpace design_space(const io::Node& input, const MachineDeck& deck, Diagnostics& mistakes);

/// The deck with one choice of each list: figures of the rope in its machine, and its row for the checks.
MachineDeck with_choice(const MachineDeck& deck, const DesignSpace& space, const std::vector<std::size_t>& choice);

/// Runs a deck: with everything that a report shows, or for its checks alone.
using RunDeck = std::function<Result(const MachineDeck& deck, bool checks_only)>;

/// The least choice that passes all checks, as a whole result: tables `design`, `design_runner_ups`, `design_active`.
/// Each choice is solved with its own weight and stiffness; nothing is assumed of how they act. Infeasible: none
/// passes.
Result run_design(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run);

}  // namespace taut::app
