#include "taut/app/explain/described.hpp"

#include <gtest/gtest.h>

#include <set>

namespace taut::app {
namespace {

TEST(DescribedTables, EveryColumnHasWordsAndItsOwnName) {
  const auto groups = table_groups();
  ASSERT_EQ(groups.size(), 8U) << "checks, design, methods, each of four methods, compare";
  for (const TableGroup& group : groups) {
    ASSERT_FALSE(group.tables.empty()) << group.title;
    std::set<std::string> names;
    for (const TableWords& t : group.tables) {
      EXPECT_TRUE(names.insert(t.name).second) << t.name;
      EXPECT_FALSE(t.rows.empty()) << t.name;
      std::set<std::string> columns;
      for (const QuantityWords& c : t.columns) {
        EXPECT_TRUE(columns.insert(c.name).second) << t.name << ": " << c.name;
        EXPECT_FALSE(c.words.empty()) << t.name << ": " << c.name;
      }
    }
  }
}

}  // namespace
}  // namespace taut::app
