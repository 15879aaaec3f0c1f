#pragma once
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/calc/result.hpp"
#include "taut/study/deck/parameter.hpp"

/// What cases of machines and of methods share: numbers put into a deck, and values taken from its result.
namespace taut::app {

/// One output: which value of a result it is.
struct WantedValue {
  std::size_t output = 0;
  std::string name;    ///< of the value or check
  std::string ending;  ///< of the analysis, which the value's name may have too
  std::string place;   ///< in the deck
};

using FoundParameter = tl::expected<study::Parameter, std::string>;

/// Describes a number of the deck that changes, or complains of it.
void add_input(const FoundParameter& parameter, const CaseName& name, CaseModel& made, NoCases& wrong);

/// Describes the outputs by the result of the deck as it is, or complains of those that it does not have.
void add_outputs(const Result& r, const std::vector<WantedValue>& wanted, CaseModel& made, NoCases& wrong);

/// Puts a number where the parameter is; infeasible outside what its field allows.
Outcome put_number(const FoundParameter& parameter, const std::string& path, double value);

/// The values of a result, each at its output. Not ok where the result has no answer, or one of them has no number.
Outcome take_values(const Result& r, const std::vector<WantedValue>& wanted, std::vector<double>& outputs);

}  // namespace taut::app
