#pragma once
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <variant>

#include "taut/app/cases/case_model.hpp"
#include "taut/app/cases/study_deck.hpp"
#include "taut/app/job.hpp"
#include "taut/app/method_deck.hpp"
#include "taut/app/prepare_machine.hpp"
#include "taut/io/deck/deck.hpp"

namespace taut::app {

/// The map of a deck with the blocks `study` and `calibrate`.
const io::Node& blocks_of(const io::Deck& deck);

/// A deck that was read without a mistake, to be asked for cases.
struct ReadCases {
  io::Deck deck;
  std::variant<ReadMachine, MethodDeck> of;
  std::optional<StudyRequest> study;
  std::optional<CalibrateRequest> calibrate;
  Job job;           ///< that it was read from
  std::string hash;  ///< of the deck, all that it names, and what was set over it

  /// As blocks_of; paths of complaints begin there.
  const io::Node& blocks() const { return blocks_of(deck); }
  /// Without outputs nothing is calculated: the inputs alone are looked up.
  MadeCases cases(const CaseQuestion& question) const;
  /// The same text for all spellings of a number's path; the path itself where it leads to none.
  std::string place_of(const std::string& path) const;
};

/// The result that tells mistakes of a deck.
Result bad_deck(Diagnostics mistakes);

/// The result that tells why a question has no cases: mistakes at their places in the blocks, or no answer.
Result refusal(const NoCases& why, const io::Node& blocks);

/// Reads the deck of a job; else the result that tells its mistakes.
tl::expected<ReadCases, Result> read_cases(const Job& job);

}  // namespace taut::app
