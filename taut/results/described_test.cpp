#include "taut/results/described.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "taut/checks/described.hpp"
#include "test/paths.hpp"

namespace taut::results {
namespace {

TEST(Described, EveryColumnHasWordsAndItsOwnName) {
  const auto tables = table_words();
  ASSERT_GT(tables.size(), 20U);
  std::set<std::string> names;
  for (const TableWords& t : tables) {
    EXPECT_TRUE(names.insert(t.name).second) << t.name;
    EXPECT_FALSE(t.rows.empty()) << t.name;
    std::set<std::string> columns;
    for (const QuantityWords& c : t.columns) {
      EXPECT_TRUE(columns.insert(c.name).second) << t.name << ": " << c.name;
      EXPECT_FALSE(c.words.empty()) << t.name << ": " << c.name;
    }
  }
}

TEST(Described, EveryValueHasWordsAPlaceAndAPageThatIsThere) {
  std::set<std::string> names;
  for (const auto* kinds : {&value_kinds(), &checks::value_kinds()}) {
    for (const ValueKind& v : *kinds) {
      EXPECT_TRUE(names.insert(v.about.name).second) << v.about.name;
      EXPECT_FALSE(v.about.words.empty()) << v.about.name;
      EXPECT_FALSE(v.of.empty()) << v.about.name;
      EXPECT_TRUE(std::filesystem::exists(taut_test::source_dir() / "docs" / v.page)) << v.page;
    }
  }
  EXPECT_TRUE(names.contains("payload_min"));
}

}  // namespace
}  // namespace taut::results
