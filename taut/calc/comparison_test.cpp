#include "taut/calc/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut {
namespace {

TEST(Comparison, BecomesALineOfATable) {
  const Table t = comparison_table({{.quantity = "take-up",
                                     .symbol = "P_M",
                                     .unit = si::N,
                                     .printed = 1,
                                     .corrected = 2,
                                     .exact = std::nan(""),
                                     .build_by = "corrected",
                                     .printed_unsafe = true}});
  ASSERT_EQ(t.rows.size(), 1U);
  EXPECT_EQ(t.rows[0].size(), t.columns.size());
  EXPECT_EQ(std::get<std::string>(t.rows[0][2]), "N");
}

}  // namespace
}  // namespace taut
