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
  std::string source_line;       ///< the text of that line; empty when it is not available
  int width = 1;                 ///< how many characters the caret underlines
  bool unreadable_file = false;  ///< the text is right, but it names a file that cannot be read
};

using Diagnostics = std::vector<Diagnostic>;

/// True when there is at least one mistake and every one is a file that cannot be read: exit code 5, not 2.
bool only_unreadable_files(const Diagnostics& all);

/// `deck.yaml:12:15: error: message`, then the line and a caret below the column. Tabs are kept, so that the caret
/// stands below its character; of a very long line only the part around the column is shown.
std::string to_text(const Diagnostic& d);
std::string to_text(const Diagnostics& all);

}  // namespace taut
