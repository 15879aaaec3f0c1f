#pragma once
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

namespace taut::io {

/// What the schema has to know of a method.
struct SchemaMethod {
  std::string name;
  std::string title;
  const Description* input = nullptr;
};

/// JSON Schema (draft 7) of a deck, for editors and for checks from outside: `input` follows from `method`, unknown
/// keys are refused, a quantity is a text with a number and a unit of the list, a plain number a number in its range
/// or a percentage. A deck with `include` needs none of the required keys: they may stand in the included one. What a
/// schema can't say (the range of a quantity) stands in the descriptions. Every deck that taut reads without a mistake
/// is valid, except that a number in quotes is not.
/// `machine`: fields of the keys `machine` and `analyses`, which a deck may have instead of `method` and `input`.
std::string deck_schema(const std::vector<SchemaMethod>& methods, const Description* machine = nullptr);

/// Regular expression (ECMA 262) of a quantity of this unit; exposed for tests.
std::string quantity_pattern(const Unit& unit);

}  // namespace taut::io
