#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/app/job.hpp"
#include "taut/calc/field.hpp"
#include "taut/calc/quantity.hpp"

namespace taut::app {

/// One number of a published set beside what a deck gives.
struct ComparedValue {
  std::string what;                      ///< in words: "row 4: extending at 52 deg, S1"
  std::string deck;                      ///< beside the file of the set
  std::string value;                     ///< name of a result value
  std::optional<std::string> published;  ///< with its unit
  std::optional<std::string> tolerance;  ///< "2 %" of it, or a quantity; without it only shown
  std::optional<std::string> reference;  ///< of another calculation with the same data
  std::optional<std::string> reference_tolerance;
  std::vector<std::string> set;  ///< values put over the deck's
  std::optional<std::string> note;
  static const Description& describe();
};

/// What `taut compare` reads: a file `compare.part.yaml` in a folder of decks.
struct ComparedSet {
  std::string source;
  std::vector<ComparedValue> values;
  std::vector<std::string> errata;  ///< of the source, in words
  static const Description& describe();
};

/// Runs every deck of a set once (and once more for each different `set`) and puts published value, reference and
/// result beside each other: table `compared`, a check for each demanded tolerance, a plot of the deviations, the
/// source's errata. A deck that gives no such value counts as a failed check. Mistakes of the set or of a deck: status
/// bad_deck with their places.
Result compare(const Job& job);

/// The table `compared` as described.
TableWords compared_words();

/// The set at a path: a file, or a folder with compare.part.yaml.
tl::expected<Job, FileError> read_set(const std::string& path);

}  // namespace taut::app
