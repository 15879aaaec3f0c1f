#include "taut/results/described.hpp"

#include <gtest/gtest.h>

#include <set>

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

TEST(Described, AValueHasThePartBeforeItsName) {
  for (const QuantityWords& v : value_words()) EXPECT_NE(v.name.find('.'), std::string::npos) << v.name;
}

}  // namespace
}  // namespace taut::results
