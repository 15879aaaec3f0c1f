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

/// Rows of a table that a page shows; the rest is in the CSV file.
inline constexpr std::size_t most_rows = 60;

}  // namespace taut::report
