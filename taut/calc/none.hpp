#pragma once
#include <limits>

namespace taut {

/// In a table or a curve: nothing to say here. Written as null in JSON and left empty in reports.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace taut
