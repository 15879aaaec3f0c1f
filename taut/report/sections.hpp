#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// One section of the page: empty html when the result has nothing for it.
struct Section {
  std::string id;
  std::string title;
  std::string html;
};

/// Everything between the verdict and the footer, in the order in which an engineer reads it: mistakes of the deck,
/// warnings, drawings, published against corrected against exact, results, checks, given, calculation, plots, tables,
/// assumptions. Sections without content are left out.
std::vector<Section> sections(const Result& r);

/// What was set over the deck: "input.span=200 m; title=x", or "none".
std::string overrides_text(const Result& r);

/// Whether any comparison has an exact value; without one its column is left out.
bool has_exact(const Result& r);
std::string comparison_title(const Result& r);

}  // namespace taut::report
