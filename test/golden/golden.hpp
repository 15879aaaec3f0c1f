#pragma once
// Reports against stored files. A stored file is rewritten with TAUT_WRITE_GOLDEN=1 in the environment; look at the
// difference before committing it.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "test/paths.hpp"

namespace taut_test {

/// What changes from build to build or place to place, made the same: taut's version, the hash and the folder of the
/// deck.
inline std::string normalised(const std::string& report) {
  std::string text = std::regex_replace(report, std::regex(R"(taut \d+\.\d+\.\d+)"), "taut VERSION");
  text = std::regex_replace(text, std::regex(R"((sha256:)?\b[0-9a-f]{16,64}\b)"), "HASH");
  return std::regex_replace(text, std::regex(R"(deck (\S*/))"), "deck ");
}

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// The stored text of test/golden/files/NAME, or, when asked to write, the new one itself after storing it.
inline std::string golden(const std::string& name, const std::string& now) {
  const std::filesystem::path file = source_dir() / "test" / "golden" / "files" / name;
  const char* write = std::getenv("TAUT_WRITE_GOLDEN");
  if (write != nullptr && std::string(write) == "1") {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << now;
  }
  return read_text(file);
}

}  // namespace taut_test
