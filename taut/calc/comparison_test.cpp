#include "taut/calc/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut {
namespace {

TEST(Comparison, BecomesALineOfATable) {
  const Table t = comparison_table({{"take-up", "P_M", si::N, 1, 2, std::nan(""), "corrected", true}});
  ASSERT_EQ(t.rows.size(), 1U);
  EXPECT_EQ(t.rows[0].size(), t.columns.size());
  EXPECT_EQ(std::get<std::string>(t.rows[0][2]), "N");
}

}  // namespace
}  // namespace taut
