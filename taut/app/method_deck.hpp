#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "taut/app/cases/study_deck.hpp"
#include "taut/app/methods.hpp"
#include "taut/calc/progress.hpp"
#include "taut/checks/asked_checks.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/design/design.hpp"
#include "taut/io/deck/node.hpp"
#include "taut/study/deck/parameter.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// The blocks of a deck beside its input.
struct MethodBlocks {
  std::optional<checks::ChecksRequest> checks;
  std::optional<design::DesignRequest> design;
  std::optional<StudyRequest> study;
  std::optional<CalibrateRequest> calibrate;
  static const Description& describe();
};

/// A deck of a method as read, or as a design has changed it. A value: a copy is another deck.
struct MethodDeck {
  const MethodEntry* method = nullptr;
  MethodInput input;
  MethodBlocks blocks = {};
  checks::AskedChecks asked = {};                         ///< what its checks name, as resolve() has found it
  std::map<std::string, catalogue::RopeRow> chosen = {};  ///< ropes that a design has put in
  Display display = Display();                            ///< units for the sentences of a result

  /// Its ropes; with a result also with the tensions in it.
  std::vector<rope::RopeUse> ropes(const Result* r) const;

  /// A number of the input, by its path with or without "input.".
  tl::expected<study::Parameter, std::string> parameter(const std::string& path);

  /// The method and the checks of the deck.
  Result calculate() const;

  /// What its checks name. Notes what is wrong with input and checks at their places; `others`: the map with the
  /// blocks.
  checks::AskedChecks resolve(const io::Node& node, const io::Node* others, Diagnostics& mistakes) const;
};

/// What a calculation needs besides its input.
struct MethodSurroundings {
  std::function<bool(const Progress&)> progress;  ///< as in a Job
  Display display;
};

/// Reads `node`, the deck's input (and of the map `others` the blocks) and notes every mistake; empty where there is
/// one. A deck with a free choice is one.
std::optional<MethodDeck> read_method(const MethodEntry& method, const io::Node& node, const io::Node* others,
                                      const Display& display, Diagnostics& mistakes);

/// Reads `node`, the deck's input (and of the map `others` the blocks `checks` and `design`, where the deck has any)
/// and notes every mistake; without mistakes returns the calculation, ready to be called; else an empty one.
std::function<Result()> prepare_method(const MethodEntry& method, const io::Node& node, const io::Node* others,
                                       const MethodSurroundings& around, Diagnostics& mistakes);

}  // namespace taut::app
