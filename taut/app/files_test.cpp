#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "taut/app/job.hpp"
#include "test/support/scratch_folder.hpp"

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
  const taut_test::ScratchFolder scratch;
  const auto folder = scratch.path() / "new" / "deep";
  const auto written = write_files(sample(), folder.string());
  ASSERT_TRUE(written.has_value()) << written.error().message;
  for (const char* name : {"result.json", "report.html", "report.md", "positions.csv", "size.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) EXPECT_NE(entry.path().extension(), ".part");
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Files, CsvHasTheUnitsOfTheReportOrSi) {
  const taut_test::ScratchFolder scratch;
  const auto& folder = scratch.path();
  Result r = sample();
  r.display = {{"length", "cm"}};
  r.comparisons.push_back({.quantity = "pull",
                           .symbol = "P",
                           .unit = si::N,
                           .printed = 1500,
                           .corrected = 2000,
                           .exact = std::nan(""),
                           .build_by = "corrected",
                           .printed_unsafe = false});
  r.series.push_back({.name = "time", .title = "", .columns = {{.name = "x", .unit = si::m}}, .rows = {{0.5}}});
  ASSERT_TRUE(write_files(r, folder.string()).has_value());
  EXPECT_EQ(text_of(folder / "positions.csv"), "x [cm]\r\n100\r\n200\r\n");
  EXPECT_EQ(text_of(folder / "size.csv"), "x [cm],D [cm]\r\n0,100\r\n100,200\r\n");
  EXPECT_NE(text_of(folder / "comparison.csv").find("pull,P,kN,1.5,2,,corrected"), std::string::npos);
  EXPECT_EQ(text_of(folder / "time.csv"), "x [m]\r\n0.5\r\n") << "series are SI always";
  ASSERT_TRUE(write_files(r, folder.string(), {.units = FileUnits::si}).has_value());
  EXPECT_EQ(text_of(folder / "positions.csv"), "x [m]\r\n1\r\n2\r\n");
  EXPECT_EQ(text_of(folder / "size.csv"), "x [m],D [m]\r\n0,1\r\n1,2\r\n");
  EXPECT_NE(text_of(folder / "comparison.csv").find("pull,P,N,1500,2000,,corrected"), std::string::npos);
}

// A table and a plot of the same name had one file, and the plot's numbers were the last to be written.
TEST(Files, APlotDoesNotOverwriteATable) {
  const taut_test::ScratchFolder scratch;
  Result r = sample();
  r.tables.front().name = "size";
  const auto written = write_files(r, scratch.path().string(), {.units = FileUnits::si});
  ASSERT_TRUE(written.has_value()) << written.error().message;
  EXPECT_EQ(text_of(scratch.path() / "size.csv"), "x [m]\r\n1\r\n2\r\n");
  EXPECT_EQ(text_of(scratch.path() / "size_plot.csv"), "x [m],D [m]\r\n0,1\r\n1,2\r\n");
  EXPECT_NE(text_of(scratch.path() / "report.md").find("(data: size_plot.csv)"), std::string::npos);
}

/// The whole folder was lost, after the verdict was said.
TEST(Files, ANameThatNoFileCanHaveLosesNothing) {
  const taut_test::ScratchFolder scratch;
  const auto folder = scratch.path() / "here";
  Result r = sample();
  r.tables.front().name = "discard_main/left";
  std::get<Plot>(r.figures.front()).name = "../size";
  const auto written = write_files(r, folder.string());
  ASSERT_TRUE(written.has_value()) << written.error().message;
  for (const char* name : {"result.json", "report.html", "discard_main_left.csv", "_._size.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(text_of(folder / "report.html").find("../size"), std::string::npos);
  EXPECT_NE(text_of(folder / "result.json").find("\"discard_main_left\""), std::string::npos);
}

TEST(Files, SaysWhyItCannotWrite) {
  const taut_test::ScratchFolder scratch;
  const auto file = scratch.path() / "a_file";
  std::ofstream(file) << "x";
  const auto written = write_files(sample(), (file / "sub").string());
  ASSERT_FALSE(written.has_value());
  EXPECT_NE(written.error().message.find("a_file"), std::string::npos);
}

}  // namespace taut::app::files_test
