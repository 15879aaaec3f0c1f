#pragma once
#include <functional>

#include "taut/app/design/design_space.hpp"
#include "taut/app/method_deck.hpp"

/// `design:` beside the `input:` of a published method.
namespace taut::app {

/// The candidates of a method's design, or what is wrong with it. `block`: the map with the key `design`.
design::DesignSpace method_space(const io::Node& block, const MethodDeck& deck, Diagnostics& mistakes);

/// The deck with a choice put in, and with a load case.
MethodDeck with_design(MethodDeck deck, const design::DesignSpace& space, const design::DesignPlace& place,
                       const design::DesignCase* load_case = nullptr);

design::DesignTask method_task(MethodDeck deck, design::DesignSpace space,
                               std::function<bool(const Progress&)> progress);

}  // namespace taut::app
