#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "taut/calc/result.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Columns of a table that stand side by side on a page.
inline constexpr std::size_t most_columns = 11;

/// How much of a table is shown.
struct TableLimits {
  std::size_t rows = std::numeric_limits<std::size_t>::max();
  std::size_t parts = std::numeric_limits<std::size_t>::max();  ///< groups of columns that fit beside each other
};

/// <td> around HTML, with a class: num (right-aligned), u (unit), src (small), ...
std::string cell(std::string_view inside, std::string_view kind = {});

/// A link to the CSV file of a table or plot, which stands in the folder of the report.
std::string csv_link(std::string_view name);

/// A table of results in display units, a unit under each column's name. Of a longer one those rows are shown that
/// matter (thinning.hpp); a line below it says how many and names the CSV file. A list of more than 40 rows has
/// headings: what rows beside each other have before a colon. A table of more than `most_columns`, or wider than a
/// page, comes in parts, each with the columns in front that say what a row is about. One without rows is not shown,
/// nor are columns in which nothing stands.
std::string table_html(const Table& t, const Display& display, const TableLimits& limits = {});

/// What it takes in print, about, mm.
double printed_height(const Table& t, const TableLimits& limits);

}  // namespace taut::report
