#pragma once
#include <string>
#include <string_view>

#include "taut/calc/result.hpp"

namespace taut::report {

/// How the answer is meant at a glance.
enum class Mood { good, bad, neutral };

struct Verdict {
  Mood mood = Mood::neutral;
  std::string headline;  ///< "Passes all 4 checks", "Fails 1 of 4 checks", "Not feasible", ...
  std::string detail;    ///< which check, or the message; may be empty
};

/// One line that says whether to build it: which check fails or governs, why there is no answer, and how many limits
/// are unverified.
Verdict verdict(const Result& r);

/// True when the limit's trust says that nobody has checked it against its source.
bool is_unverified(std::string_view trust);

/// "0.87"; three significant digits, "< 0.001" for next to nothing.
std::string utilisation_text(double utilisation);

/// "passes" or "fails".
std::string_view outcome_text(const Check& c);

}  // namespace taut::report
