#pragma once
// Where tests find the files of the source tree (examples, data) and the program that was built with them.

#include <filesystem>

namespace taut_test {
std::filesystem::path source_dir();
std::filesystem::path program();

/// Whether the sanitizers watch, ten times slower: long series take fewer cases then.
#ifdef TAUT_WATCHED
inline constexpr bool watched = true;
#else
inline constexpr bool watched = false;
#endif
}  // namespace taut_test
