#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/calc/result.hpp"
#include "taut/calc/value_kind.hpp"

namespace taut::checks {

/// The tables that `checks:` of a machine or a method adds, made of the same quantities as the tables themselves.
std::vector<TableWords> table_words();

/// The values that the verdict and the checks answer with by name: those of every judged state, of `checks:` of a
/// machine and of a method.
const std::vector<ValueKind>& value_kinds();

/// A check as the report names it, NAME.key, and what it compares.
struct CheckWords {
  std::string key;    ///< "drum_ratio"
  std::string of;     ///< what NAME is: "rope"
  std::string words;  ///< "D/d of the drum ..."
};

/// The checks of `checks:` that have no other name in a deck or among the values. docs/guide/checks.md has them all.
const std::vector<CheckWords>& check_words();

/// Of a value of the verdict's states, or that `checks:` of a machine adds, whether the least or the largest of several
/// states is the worst one; empty: another value.
std::optional<Sense> worst_side(const std::string& name);

/// The columns by whose largest number a table with one row a part takes the worst of several states; empty: another
/// table.
std::vector<std::string> worst_columns(const std::string& table);
/// The columns whose largest number such a row has, of whichever state.
std::vector<std::string> largest_columns(const std::string& table);

}  // namespace taut::checks
