#pragma once
// Where tests find the files of the source tree (examples, data) and the program that was built with them.

#include <filesystem>

namespace taut_test {
std::filesystem::path source_dir();
std::filesystem::path program();
}  // namespace taut_test
