#pragma once
#include <string>
#include <string_view>

#include "taut/calc/verdict.hpp"

namespace taut::report {

/// How the verdict is meant at a glance: green, amber, red, grey.
enum class Mood { good, warning, bad, neutral };

/// The verdict as a person reads it.
struct Banner {
  Mood mood = Mood::neutral;
  std::string icon;      ///< one character beside the colour
  std::string headline;  ///< "Passes, with warnings", "The deck has 2 mistakes"
  std::string detail;    ///< the verdict's sentence
  std::string scope;     ///< what it leaves out, in words; may be empty
};

/// The verdict of a result; of a deck with mistakes their number.
Banner banner(const Result& r);

/// "0.87"; three significant digits, "< 0.001" for next to nothing.
std::string utilisation_text(double utilisation);

/// "passes", "fails" or "refused".
std::string_view outcome_text(const Check& c);

}  // namespace taut::report
