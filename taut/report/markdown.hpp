#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

/// The report as Markdown: the same sections in the same order, formulas as code, figures by title and data file.
/// For notes, reviews and version control; a pure function of the result.
std::string to_markdown(const Result& r);

}  // namespace taut::report
