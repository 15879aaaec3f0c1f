#pragma once
#include <string>
#include <string_view>

#include "taut/calc/result.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Rows of a series that a page shows; the rest is in the CSV file.
inline constexpr std::size_t most_rows = 60;

/// Columns of a table that stand side by side on a page.
inline constexpr std::size_t most_columns = 12;

/// <td> around HTML, with a class: num (right-aligned), u (unit), src (small), ...
std::string cell(std::string_view inside, std::string_view kind = {});

/// A table of results in display units, a unit under each column's name. Of a series beyond `most_rows` the middle is
/// left out, and that is said with the name of the CSV file; a list, whose rows each begin with words of their own, is
/// there whole, and beyond that length with headings: what rows beside each other have before a colon. A table of more
/// than `most_columns`, or wider than a page, comes in parts, each with the columns in front that say what a row is
/// about. One without rows is not shown, nor are columns in which nothing stands.
std::string table_html(const Table& t, const Display& display);

}  // namespace taut::report
