#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

struct TerminalOptions {
  bool colour = false;  ///< ANSI colours for the verdict and the checks
  int width = 100;      ///< columns; words wrap, numbers never do
};

/// The short answer for a terminal: warnings, checks, published against corrected, values in display units,
/// in aligned columns. Plain text; control characters of the deck never reach the terminal. Ends with a line break.
std::string to_terminal(const Result& r, const TerminalOptions& options = {});

}  // namespace taut::report
