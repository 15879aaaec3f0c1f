#pragma once
#include <functional>
#include <vector>

#include "taut/app/machine_deck.hpp"
#include "taut/calc/result.hpp"
#include "taut/catalogue/section.hpp"
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

/// A beam whose section is free, in the order of what is sought.
struct SectionCandidates {
  std::string name;  ///< of the machine's beam
  std::vector<catalogue::SectionRow> rows;
  std::vector<double> costs;  ///< ascending
};

/// A number that is free, and where it is tried.
struct UnknownValues {
  std::string name;
  std::string parameter;  ///< its path below the machine
  Unit unit;
  std::vector<double> values;  ///< SI
};

/// What a design searches through.
struct DesignSpace {
  std::vector<RopeCandidates> ropes;
  std::vector<SectionCandidates> sections;  ///< their choices behind those of the ropes
  std::vector<UnknownValues> unknowns;
};

/// The candidates of a deck's design, or what is wrong with it: mistakes of the catalogue's file and of the block
/// `design`, each at its place.
DesignSpace design_space(const io::Node& input, const MachineDeck& deck, Diagnostics& mistakes);

/// The candidates of one beam; empty with complaints. `steel` thicknesses it is not made in are left out.
SectionCandidates candidates_of_beam(const DesignSectionRequest& request, const MachineDeck& deck,
                                     std::vector<Complaint>& complaints);

/// Fills the costs of sections: mass, by the lengths of the beams, or outer heights.
void weigh_sections(const MachineDeck& first, DesignSpace& space);

/// Every list's costs: ropes, then sections.
std::vector<std::vector<double>> costs_of(const DesignSpace& space);

/// The deck with one choice of each list: figures of the rope in its machine, and its row for the checks.
MachineDeck with_choice(const MachineDeck& deck, const DesignSpace& space, const std::vector<std::size_t>& choice);

/// The deck with these values of its unknowns.
MachineDeck with_values(const MachineDeck& deck, const DesignSpace& space, const std::vector<double>& values);

/// Runs a deck: with everything that a report shows, or for its checks alone.
using RunDeck = std::function<Result(const MachineDeck& deck, bool checks_only)>;

/// The least choice that passes all checks, as a whole result (design_tables.hpp): at every place of the grid of
/// unknowns the ropes of least cost, of these the least; among equal ones that with the most reserve. Each choice is
/// solved with its own weight and stiffness; nothing is assumed of how they act. Infeasible: none passes.
Result run_design(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run);

}  // namespace taut::app
