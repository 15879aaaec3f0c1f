#pragma once
#include <functional>
#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/app/cases/case_model.hpp"
#include "taut/calc/result.hpp"
#include "taut/study/deck/parameter.hpp"
#include "taut/units/display.hpp"

/// What cases of machines and of methods share: numbers put into a deck, and values taken from its result.
namespace taut::app {

/// One output: which value of a result it is.
struct WantedValue {
  std::size_t output = 0;
  std::string name;    ///< of the value or check
  std::string ending;  ///< of the analysis, which the value's name may have too
  std::string place;   ///< in the deck
  /// Whether a check of that name comes before a value of that name. The value `skyline.safety_factor` is of the
  /// tension at rest, the check of the tension that it has to hold.
  bool checks_first = false;
};

/// Numbers of a deck's `parameters`, "parameters.travel": they stand in its expressions, so that it is read again for
/// other values.
template <class Deck>
struct DeckParameters {
  /// Describes one, or says why it can't change.
  std::function<tl::expected<CaseInput, std::string>(const std::string& path)> describe;
  /// The deck with these over its own, as `--set` has them: "parameters.travel=3 m".
  std::function<tl::expected<Deck, Outcome>(const std::vector<std::string>& set)> read;
};

bool is_parameter(const std::string& path);

/// "parameters.travel=3 m", with every digit.
std::string assignment(const CaseInput& input, double value);

using FoundParameter = tl::expected<study::Parameter, std::string>;

/// The deck with these numbers, one for each input. `find`: a number of a deck by its path.
template <class Deck>
tl::expected<Deck, Outcome> deck_with(const Deck& base, const std::vector<CaseInput>& inputs,
                                      const DeckParameters<Deck>& parameters,
                                      FoundParameter (*find)(Deck& deck, const std::string& path),
                                      std::span<const double> values) {
  std::vector<std::string> set;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_parameter(inputs[i].path)) set.push_back(assignment(inputs[i], values[i]));
  }
  tl::expected<Deck, Outcome> deck = set.empty() ? base : parameters.read(set);
  for (std::size_t i = 0; i < values.size() && deck; ++i) {
    const std::string& path = inputs[i].path;
    if (is_parameter(path)) continue;
    const FoundParameter number = find(*deck, path);
    Outcome outcome = number ? study::put(*number, values[i]) : infeasible(number.error());
    if (!outcome.ok()) return tl::unexpected(std::move(outcome));
  }
  return deck;
}

/// Describes a number of the deck that changes, or complains of it: also where it is one of those before, in another
/// spelling of its path.
void add_input(const FoundParameter& parameter, const CaseName& name, CaseModel& made, NoCases& wrong);

/// The same of one of its parameters.
void add_input(tl::expected<CaseInput, std::string> parameter, const CaseName& name, CaseModel& made, NoCases& wrong);

/// Describes the outputs by the result of the deck as it is, or complains of those that it does not have, and of a
/// value that is one of those before, in another spelling of its name.
void add_outputs(const Result& r, const std::vector<WantedValue>& wanted, CaseModel& made, NoCases& wrong);

/// The values of a result, each at its output. Not ok where the result has no answer, or one of them has no number.
Outcome take_values(const Result& r, const std::vector<WantedValue>& wanted, std::vector<double>& outputs);

/// How the checks against breaking, of a rope or guy, and against yield, of a beam, are called behind their part.
inline constexpr const char* breaking_check = ".T_max";
inline constexpr const char* yield_check = ".stress_max";
/// The check of a rope against breaking in a method: "return rope does not break".
inline constexpr const char* breaking_of_method = " does not break";

/// Breaking forces and yields by part, as these checks of a result have them.
std::map<std::string, double> strengths_of(const Result& r);

/// Puts strengths into others, the least of each.
void keep_least(const std::map<std::string, double>& more, std::map<std::string, double>& all);

/// The same with those of a result that are below `known`, or not in it.
void add_weaker(const Result& r, const std::map<std::string, double>& known, std::map<std::string, double>& weaker);

/// What keeps a result from passing (verdict.hpp), but for parts without a limit: a study has limits of its own, and
/// tells of parts that have neither (CaseModel::unasked). With the words in these units.
std::vector<CaseFlaw> flaws_of(const Result& r, const Display& display);

/// What the deck as it is says of parts and choices.
struct SaidOfDeck {
  std::vector<std::string> unjudged = {};           ///< parts without a limit
  std::map<std::string, std::string> choices = {};  ///< as of a Result
};
SaidOfDeck said_of_deck(const Result& r);

/// How a case differs from that: parts without a limit that the deck as it is does not have, and choices. `check_of`:
/// the check of the strength of a part.
void add_other(const Result& r, const SaidOfDeck& deck,
               const std::function<std::string(const std::string& part)>& check_of, std::vector<CaseFlaw>& flaws);

}  // namespace taut::app
