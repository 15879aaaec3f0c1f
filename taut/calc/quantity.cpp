#include "taut/calc/quantity.hpp"

#include <stdexcept>

namespace taut {

void no_such_quantity(std::string_view name) {
  throw std::logic_error("no quantity '" + std::string(name) + "' is described");
}

}  // namespace taut
