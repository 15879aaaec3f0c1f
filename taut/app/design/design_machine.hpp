#pragma once
#include <functional>
#include <memory>

#include "taut/app/machine_deck.hpp"
#include "taut/design/design.hpp"
#include "taut/io/deck/node.hpp"

/// `design:` of a machine's deck.
namespace taut::app {

/// The candidates of a machine's design, or what is wrong with it. `input`: the deck's map.
design::DesignSpace machine_space(const io::Node& input, const MachineDeck& deck, Diagnostics& mistakes);

/// The deck with a design in it: figures of the ropes, sections, unknowns, and the ropes' rows for the checks.
MachineDeck with_design(const MachineDeck& deck, const design::DesignSpace& space, const design::DesignPlace& place,
                        const design::DesignCase* load_case = nullptr);

/// What a design needs of the calculation of machines.
struct DeckDoors {
  /// `states`: of the machine with other numbers, from which the equilibria begin (empty: as alone); then its own,
  /// where it has an answer.
  std::function<Result(const MachineDeck& deck, RunDepth depth, const std::function<bool(const Progress&)>& progress,
                       States& states)>
      run;
  /// Adds the picture of a deck without an answer.
  std::function<void(const MachineDeck& deck, Result& r)> picture;
};

design::DesignTask machine_task(std::shared_ptr<const MachineDeck> deck, design::DesignSpace space, DeckDoors doors,
                                std::function<bool(const Progress&)> progress);

}  // namespace taut::app
