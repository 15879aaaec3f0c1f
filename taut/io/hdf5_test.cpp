#include "taut/io/hdf5.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "taut/base/long_rows.hpp"

namespace taut::io::hdf5_test {

namespace fs = std::filesystem;

fs::path fresh_file(const char* name) {
  const fs::path path = fs::temp_directory_path() / fmt::format("taut_hdf5_test_{}_{}", ::getpid(), name);
  fs::remove(path);
  return path;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<Table> made() {
  Table t;
  t.name = "time";
  t.title = "Motion, μ = 0.1";
  t.columns = {{.name = "t", .unit = si::s},
               {.name = "hoist[2].T", .unit = si::N},
               {.name = "a/b", .unit = si::one},
               {.name = "state", .unit = si::one}};
  t.rows = {{0.0, 0.1 + 0.2, 1.0, std::string("stick")}, {0.01, std::nan(""), -1e-300, std::string("slip ü")}};
  Table empty;
  empty.name = "empty";
  empty.columns = {{.name = "t", .unit = si::s}};
  return {empty, t};
}

/// Links have no '/': two names that differ by one alone are two columns, each with its own name.
TEST(Hdf5, ColumnsWhoseLinksWouldBeTheSameAreBothWritten) {
  Table t;
  t.name = "time";
  t.columns = {{.name = "a_b", .unit = si::m}, {.name = "a/b", .unit = si::N}};
  t.rows = {{1.0, 2.0}};
  const fs::path path = fresh_file("links.h5");
  const auto written = write_hdf5({t}, path.string());
  ASSERT_TRUE(written) << written.error();
  const auto read = read_hdf5(path.string());
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->front().columns.size(), 2U);
  EXPECT_EQ(read->front().columns[0].name, "a_b");
  EXPECT_EQ(read->front().columns[1].name, "a/b");
  EXPECT_EQ(std::get<double>(read->front().rows[0][1]), 2);
  fs::remove(path);
}

TEST(Hdf5, LongRowsAreWrittenAsOthers) {
  Table t;
  t.name = "time";
  t.columns = {{.name = "t", .unit = si::s}, {.name = "x", .unit = si::m}};
  const auto rows = std::make_shared<LongRows>(2);
  rows->add({0, 1.0 / 3});
  rows->add({0.5, std::nan("")});
  t.long_rows = rows;
  Table same = t;
  same.long_rows = nullptr;
  same.rows = {{0.0, 1.0 / 3}, {0.5, std::nan("")}};
  const fs::path one = fresh_file("long.h5"), other = fresh_file("short.h5");
  ASSERT_TRUE(write_hdf5({t}, one.string()));
  ASSERT_TRUE(write_hdf5({same}, other.string()));
  EXPECT_EQ(bytes_of(one), bytes_of(other));
  fs::remove(one);
  fs::remove(other);
}

TEST(Hdf5, ComesBackBitByBit) {
  const fs::path path = fresh_file("a.h5");
  ASSERT_TRUE(write_hdf5(made(), path.string()));
  const auto back = read_hdf5(path.string());
  ASSERT_TRUE(back) << back.error();
  ASSERT_EQ(back->size(), 2U);
  const Table& t = (*back)[1];
  EXPECT_EQ(t.name, "time");
  EXPECT_EQ(t.title, made()[1].title);
  ASSERT_EQ(t.columns.size(), 4U);
  EXPECT_EQ(t.columns[1].name, "hoist[2].T");
  EXPECT_EQ(t.columns[1].unit.symbol, "N");
  EXPECT_EQ(t.columns[2].name, "a/b") << "its own name, though a path has no room for it";
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_EQ(std::get<double>(t.rows[0][1]), 0.1 + 0.2);
  EXPECT_TRUE(std::isnan(std::get<double>(t.rows[1][1])));
  EXPECT_EQ(std::get<double>(t.rows[1][2]), -1e-300);
  EXPECT_EQ(std::get<std::string>(t.rows[1][3]), "slip ü");
  EXPECT_TRUE((*back)[0].rows.empty());
  fs::remove(path);
}

TEST(Hdf5, TheSameSeriesGiveTheSameBytes) {
  const fs::path a = fresh_file("b.h5"), b = fresh_file("c.h5");
  ASSERT_TRUE(write_hdf5(made(), a.string()));
  ASSERT_TRUE(write_hdf5(made(), b.string()));
  EXPECT_EQ(bytes_of(a), bytes_of(b));
  EXPECT_GT(bytes_of(a).size(), 100U);
  fs::remove(a);
  fs::remove(b);
}

// More texts than HDF5 turns over at once.
TEST(Hdf5, ManyTextsComeBack) {
  Table t;
  t.name = "cases";
  t.columns = {{.name = "reason", .unit = si::one}, {.name = "x", .unit = si::m}};
  constexpr int rows = 5000;
  for (int i = 0; i < rows; ++i) t.rows.push_back({i % 3 == 0 ? std::string{} : fmt::format("reason {}", i), 1.0 * i});
  const fs::path path = fresh_file("many.h5");
  ASSERT_TRUE(write_hdf5({t}, path.string()));
  const auto back = read_hdf5(path.string());
  ASSERT_TRUE(back) << back.error();
  EXPECT_EQ(back->at(0).rows, t.rows);
  fs::remove(path);
}

TEST(Hdf5, SaysWhyNot) {
  EXPECT_FALSE(write_hdf5(made(), "/nowhere/at/all.h5"));
  EXPECT_FALSE(read_hdf5("/nowhere/at/all.h5"));
  const fs::path path = fresh_file("d.h5");
  std::ofstream(path) << "not HDF5";
  EXPECT_FALSE(read_hdf5(path.string()));
  fs::remove(path);
}

}  // namespace taut::io::hdf5_test
