#include "taut/calc/quantity.hpp"

#include <stdexcept>
#include <utility>

namespace taut {

std::vector<QuantityWords> prefixed(const std::string& prefix, std::vector<QuantityWords> all) {
  for (QuantityWords& one : all) one.name = prefix + one.name;
  return all;
}

std::vector<QuantityWords> as_details(std::vector<QuantityWords> words) {
  for (QuantityWords& one : words) one.detail = true;
  return words;
}

void add_columns(std::vector<Column>& columns, const std::vector<QuantityWords>& words) {
  for (const QuantityWords& one : words) columns.push_back({.name = one.name, .unit = one.unit, .detail = one.detail});
}

void no_such_quantity(std::string_view name) {
  throw std::logic_error("no quantity '" + std::string(name) + "' is described");
}

}  // namespace taut
