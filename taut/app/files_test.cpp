#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "taut/app/job.hpp"

namespace taut::app::files_test {

Result sample() {
  Result r;
  r.title = "sample";
  r.values.push_back({"N", 1, si::N, "N", "axial force", "(4)"});
  r.tables.push_back({"positions", "Positions", {{.name = "x", .unit = si::m}}, {{1.0}, {2.0}}});
  r.figures.emplace_back(Plot{.name = "size",
                              .title = "Size",
                              .caption = "",
                              .x = {.label = "x", .unit = si::m},
                              .y = {.label = "D", .unit = si::m},
                              .curves = {{.label = "D", .x = {0, 1}, .y = {1, 2}}},
                              .marks = {}});
  return r;
}

TEST(Files, WritesResultReportAndTables) {
  const auto folder = std::filesystem::temp_directory_path() / "taut_files_test" / "deep";
  std::filesystem::remove_all(folder.parent_path());
  const auto written = write_files(sample(), folder.string());
  ASSERT_TRUE(written.has_value()) << written.error().message;
  for (const char* name : {"result.json", "report.html", "report.md", "positions.csv", "size.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) EXPECT_NE(entry.path().extension(), ".part");
  std::filesystem::remove_all(folder.parent_path());
}

TEST(Files, SaysWhyItCannotWrite) {
  const auto file = std::filesystem::temp_directory_path() / "taut_files_test_file";
  std::ofstream(file) << "x";
  const auto written = write_files(sample(), (file / "sub").string());
  ASSERT_FALSE(written.has_value());
  EXPECT_NE(written.error().message.find("taut_files_test_file"), std::string::npos);
  std::filesystem::remove(file);
}

}  // namespace taut::app::files_test
