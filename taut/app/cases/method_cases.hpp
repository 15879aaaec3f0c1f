#pragma once
#include "taut/app/cases/case_model.hpp"
#include "taut/app/cases/case_values.hpp"
#include "taut/app/method_deck.hpp"

namespace taut::app {

/// A method's deck as a function of numbers of its `input`. Outputs: values of its result by name, and
/// `checks.NAME`, the value of a check.
MadeCases method_cases(const MethodDeck& deck, const CaseQuestion& question,
                       const DeckParameters<MethodDeck>& parameters);

}  // namespace taut::app
