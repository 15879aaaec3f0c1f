#include "taut/base/long_rows.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

#include <cmath>
#include <string>

namespace taut_test::long_rows_test {
namespace {

using taut::LongRows;

/// More rows than are kept in memory, each of three numbers.
constexpr std::size_t many = 300'000;

LongRows filled(std::size_t rows) {
  LongRows all(3);
  for (std::size_t i = 0; i < rows; ++i) {
    const auto x = static_cast<double>(i);
    all.add({x, std::sqrt(x), -x});
  }
  return all;
}

void expect_all_there(const LongRows& all, std::size_t rows) {
  ASSERT_EQ(all.size(), rows);
  std::size_t i = 0;
  bool same = true;
  all.each([&](const double* row) {
    const auto x = static_cast<double>(i++);
    same = same && row[0] == x && row[1] == std::sqrt(x) && row[2] == -x;
  });
  EXPECT_TRUE(same);
  EXPECT_EQ(i, rows);
  const std::vector<double> roots = all.column(1);
  ASSERT_EQ(roots.size(), rows);
  EXPECT_EQ(roots.back(), std::sqrt(static_cast<double>(rows - 1)));
}

TEST(LongRows, AreReadAsTheyWereAdded) {
  expect_all_there(filled(10), 10);
  LongRows all = filled(many);
  expect_all_there(all, many);
  expect_all_there(all, many);  // once more, and on
  all.add({static_cast<double>(many), std::sqrt(static_cast<double>(many)), -static_cast<double>(many)});
  expect_all_there(all, many + 1);
}

TEST(LongRows, StayInMemoryWhereNoFileCanBeMade) {
  const char* const given = getenv("TMPDIR");
  const std::string before = given == nullptr ? "" : given;
  setenv("TMPDIR", "/no/such/folder", 1);
  expect_all_there(filled(many), many);
  given == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1);
}

TEST(LongRows, RefuseRowsOfAnotherWidth) { EXPECT_ANY_THROW(filled(2).add({1, 2})); }

}  // namespace
}  // namespace taut_test::long_rows_test
