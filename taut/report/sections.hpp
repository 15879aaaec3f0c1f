#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// One section behind page 1.
struct Section {
  std::string id;
  std::string title;
  std::string html;
  bool numbered = true;
};

/// Everything behind page 1 in the order in which an engineer reads it: mistakes of the deck, warnings in full, inputs,
/// checks, published against corrected against exact, calculation, results, pictures, assumptions, appendix. Sections
/// without content are left out. `shown`: figures of page 1.
std::vector<Section> sections(const Result& r, const std::vector<const Figure*>& shown = {});

/// What was set over the deck: "input.span=200 m; title=x", or "none".
std::string overrides_text(const Result& r);

/// Whether any comparison has an exact value; without one its column is left out.
bool has_exact(const Result& r);
std::string comparison_title(const Result& r);

}  // namespace taut::report
