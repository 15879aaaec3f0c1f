#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

/// The calculation line by line as HTML: headings, what is given, each formula in MathML, the same with its numbers
/// (SI), the result with its unit, equation number and source at the right. Empty when there are no steps.
/// Beyond about 220 kB the rest is left out, and that is said.
std::string steps_html(const Result& r);

/// A Step's source without the equation number that stands beside it anyway.
std::string source_without_number(const Step& s);

}  // namespace taut::report
