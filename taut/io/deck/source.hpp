#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/io/file_reader.hpp"

namespace taut::io {

/// Decks above this many bytes are refused unread.
inline constexpr std::size_t largest_deck = std::size_t{16} * 1024 * 1024;
/// So many mistakes are reported, and then how to see more.
inline constexpr std::size_t most_mistakes = 100;

/// What the reading of one deck has read besides the deck itself, in that order. Shared by all sources of that reading.
struct Reading {
  std::vector<std::string> texts;
  FileReader read;  ///< of the files that the deck names; empty: read_file
};

/// A text with the name that messages give it. Shared by every value that was read from it.
struct Source {
  std::string name;
  std::string text;
  std::shared_ptr<Reading> reading;  ///< where further files that the text names are noted; may be empty
  /// The text is a file that the deck names. It may be any file of the machine that runs taut, so messages say where it
  /// is wrong and why, and never what it says there.
  bool named_by_deck = false;

  /// Line and column (1-based, in bytes) of a byte of the text.
  Place place(std::size_t offset) const;
  /// The line around that byte without its end; empty when it is longer than 100 000 bytes.
  std::string line(std::size_t offset) const;
};
using SourcePtr = std::shared_ptr<const Source>;

/// Bytes `offset` to `offset + width` of a source.
struct Spot {
  SourcePtr source;
  std::size_t offset = 0;
  std::size_t width = 1;

  Place place() const;
};

/// `message` at that spot, with the source line; the caret ends with the line. In a file that the deck names without
/// the line, and without the words of the message that stand there.
Diagnostic at(const Spot& spot, std::string message);

/// Appends a mistake unless there are most_mistakes already; the last one says that there are more.
void add(Diagnostics& all, Diagnostic d);
void add(Diagnostics& all, const Spot& spot, std::string message);

/// No further mistake would be reported: the reading of a hopeless deck may end.
inline bool enough(const Diagnostics& all) { return all.size() >= most_mistakes; }

/// Finds what no YAML text may hold: more than largest_deck bytes, NUL and other control characters, UTF-16, invalid
/// UTF-8. Stops at the first one.
Diagnostics check_text(const SourcePtr& source);

/// A mistake in a file that the deck names, `text`: without its line, and without the words in quotes that stand there.
Diagnostic without_text(Diagnostic mistake, const std::string& text);

/// `text` in quotes, cut to a readable length, control characters as '?'.
std::string in_quotes(std::string_view text);

}  // namespace taut::io
