#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

struct TerminalOptions {
  bool colour = false;  ///< ANSI colours for the verdict and the checks
  int width = 100;      ///< columns; words wrap, numbers never do
  bool all = false;     ///< every check, value, short table and warning; else a summary of at most 40 lines
};

/// The answer for a terminal, in display units and aligned columns: the main answer, warnings, the worst check of each
/// part, published against corrected, the first values; the verdict's sentence is the last line. Plain text; control
/// characters of the deck never reach the terminal. Ends with a line break.
std::string to_terminal(const Result& r, const TerminalOptions& options = {});

}  // namespace taut::report
