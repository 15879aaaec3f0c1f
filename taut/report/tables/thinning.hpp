#pragma once
#include <cstddef>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// The rows of a table by which a reader judges it, in their order: the first and the last, those with the least and
/// the largest number of each column; up to `most` of them also those before and behind which a text changes
/// ("governs", the limit that decides), and evenly spaced ones between. All rows when they are no more than that.
/// `most` is at least 2.
std::vector<std::size_t> rows_that_matter(const Table& t, std::size_t most);

/// Whether each row begins with words of its own: a list, not a series.
bool is_list(const Table& t);

}  // namespace taut::report
