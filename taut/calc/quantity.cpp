#include "taut/calc/quantity.hpp"

#include <stdexcept>
#include <utility>

namespace taut {

std::vector<QuantityWords> prefixed(const std::string& prefix, std::vector<QuantityWords> all) {
  for (QuantityWords& one : all) one.name = prefix + one.name;
  return all;
}

void no_such_quantity(std::string_view name) {
  throw std::logic_error("no quantity '" + std::string(name) + "' is described");
}

}  // namespace taut
