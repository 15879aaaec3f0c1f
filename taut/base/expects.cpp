#include "taut/base/expects.hpp"

#include <fmt/format.h>

namespace taut {

void expects(bool condition, std::string_view what, std::source_location where) {
  if (condition) return;
  throw ContractViolation(fmt::format("{}:{}: {}", where.file_name(), where.line(), what));
}

}  // namespace taut
