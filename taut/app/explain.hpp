#pragma once
#include <string>
#include <vector>

#include "taut/calc/method.hpp"
#include "taut/calc/result.hpp"

namespace taut::app {

/// `taut explain METHOD`: source, scope, limits, the equations as the program computes them (taken from a run of the
/// example deck, so that this text can't drift from the code), the deck's keys with units, ranges and defaults, the
/// result's names, the errata of the published text.
std::string explain_text(const Method& about, const Description& input, const Description& output,
                         const Result& example);

/// The keys and names alone, as a Markdown section of the reference guide.
std::string reference_markdown(const Method& about, const Description& input, const Description& output);

/// "above 0 m", "0 to 0.5", "-60 to 85 deg": the range of a field in the unit of print; empty without limits.
std::string range_text(const Field& f);

}  // namespace taut::app
