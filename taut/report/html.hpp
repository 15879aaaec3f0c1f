#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::report {

enum class Paper { a4, a3 };

struct HtmlOptions {
  bool appendix = false;  ///< unfolded, and printed
  Paper paper = Paper::a4;
};

/// The report: one self-contained HTML file (style, fonts, drawings and plots inside; nothing is loaded). Page 1 is
/// what an engineer signs, see page_one.hpp; the sections follow, see sections.hpp. On screen it has a list of
/// contents, folds and, where the reader wants it, a dark ground; in print it has pages of `paper`, by default without
/// the appendix. A pure function of the result: same result, same bytes. Every text of the deck is escaped. It is
/// complete whatever the status: an infeasible result shows the calculation up to where it ended, a bad deck its
/// mistakes.
std::string to_html(const Result& r, const HtmlOptions& options = {});

}  // namespace taut::report
