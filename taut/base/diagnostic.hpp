#pragma once
#include <string>
#include <vector>

namespace taut {

/// A place in a text: 1-based line and column, 0 when there is none.
struct Place {
  int line = 0;
  int column = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// One mistake in the user's file, with its place and what to do about it.
struct Diagnostic {
  std::string file;
  Place place;
  std::string message;
  std::string source_line;       ///< the text of that line, empty when it is not at hand
  int width = 1;                 ///< how many characters the caret underlines
  bool unreadable_file = false;  ///< what is wrong is not the text, but that a file which it names can't be read
};

using Diagnostics = std::vector<Diagnostic>;

/// There is a mistake, and each is a file that can't be read: trouble with files, not with the deck.
bool only_unreadable_files(const Diagnostics& all);

/// `deck.yaml:12:15: error: message`, then the line and a caret under the column.
/// Tabs are kept under the line so that the caret stands right; a very long line is shown only around the column.
std::string to_text(const Diagnostic& d);
std::string to_text(const Diagnostics& all);

}  // namespace taut
