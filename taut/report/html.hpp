#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

/// The report: one self-contained HTML file (style, fonts, drawings and plots inside; nothing is loaded), printable on
/// A4. A pure function of the result: same result, same bytes. Every text of the deck is escaped. It is complete
/// whatever the status: an infeasible result shows the calculation up to where it ended, a bad deck its mistakes.
std::string to_html(const Result& r);

}  // namespace taut::report
