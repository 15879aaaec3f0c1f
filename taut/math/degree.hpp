#pragma once
#include <numbers>

namespace taut {

inline constexpr double degree = std::numbers::pi / 180;  ///< in radians

}  // namespace taut
