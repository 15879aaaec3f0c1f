#include "taut/base/expects.hpp"

#include <fmt/format.h>

namespace taut {

void expects(bool condition, std::string_view what, const char* file, int line) {
  if (condition) return;
  throw ContractViolation(fmt::format("{}:{}: {}", file, line, what));
}

}  // namespace taut
