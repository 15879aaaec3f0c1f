#pragma once
#include <string_view>

namespace taut {

/// Version of the library and program, and of the result's shape. A change of `result_format` breaks readers.
inline constexpr std::string_view version = "0.1.0";
inline constexpr int result_format = 2;

}  // namespace taut
