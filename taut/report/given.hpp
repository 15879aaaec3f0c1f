#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// What the calculation starts from: symbol, words, value, key in the deck, default or given. Lists of records
/// ("cases[0].falls", "cases[1].falls", ...) become a table each, one row per record.
std::string given_html(const Result& r);

/// The lists of records among `given` with two records or more, as tables named by their key ("cases").
std::vector<Table> record_tables(const std::vector<Given>& given);

/// True when a `record_tables` table of the same list shows this one.
bool is_in_table(const Given& g, const std::vector<Table>& tables);

}  // namespace taut::report
