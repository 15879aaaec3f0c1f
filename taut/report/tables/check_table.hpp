#pragma once
#include <string>

#include "taut/calc/result.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// All checks, one line each, grouped by part as they come, with the number of their rule; below the table each rule
/// once, with the trust in its limit, over the full width. Empty without checks.
std::string checks_html(const Result& r);

/// The summary for page 1: the worst check of each part, worst first, at most ten.
std::string worst_checks_html(const Result& r);

/// "42.8 kN" and "≤ 63 kN", for print.
std::string value_text(const Check& c, const Display& display);
std::string limit_text(const Check& c, const Display& display);

}  // namespace taut::report
