#pragma once
#include <string_view>

namespace taut {

/// Version of the library and program, and of the format of result.json. A program that reads one `result_format` does
/// not read another.
inline constexpr std::string_view version = "0.1.0";
inline constexpr int result_format = 2;

}  // namespace taut
