#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "taut_test/embedded/bytes.hpp"
#include "taut_test/embedded/table.hpp"
#include "test/paths.hpp"

namespace embed_test {

std::string content(std::string_view path) {
  std::ifstream in(taut_test::source_dir() / path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Embed, KeepsEveryByte) {
  ASSERT_GT(taut_test::embedded::bytes.size(), 256U);
  EXPECT_EQ(taut_test::embedded::bytes, content("test/house/bytes.bin"));
}

TEST(Embed, TableIsKeyedByFileNameInTheOrderGiven) {
  ASSERT_EQ(taut_test::embedded::table.size(), 2U);
  EXPECT_EQ(taut_test::embedded::table[0].first, "LICENSE");
  EXPECT_EQ(taut_test::embedded::table[0].second, content("LICENSE"));
  EXPECT_EQ(taut_test::embedded::table[1].first, "bytes.bin");
  EXPECT_EQ(taut_test::embedded::table[1].second, content("test/house/bytes.bin"));
}

}  // namespace embed_test
