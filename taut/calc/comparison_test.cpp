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

TEST(Comparison, InTheUnitsOfPrint) {
  const std::vector<Comparison> all = {{.quantity = "pull",
                                        .symbol = "P",
                                        .unit = si::N,
                                        .printed = 300,
                                        .corrected = 138864.558,
                                        .exact = std::nan(""),
                                        .build_by = "corrected",
                                        .printed_unsafe = false},
                                       {.quantity = "share",
                                        .symbol = "s",
                                        .unit = si::one,
                                        .printed = 0.1,
                                        .corrected = 0.2,
                                        .exact = 0.3,
                                        .build_by = "any",
                                        .printed_unsafe = false}};
  const Table t = comparison_table(all, Display());
  EXPECT_EQ(std::get<std::string>(t.rows[0][2]), "kN");
  EXPECT_EQ(std::get<double>(t.rows[0][3]), 0.3);
  EXPECT_EQ(std::get<double>(t.rows[0][4]), 138.864558);
  EXPECT_TRUE(std::isnan(std::get<double>(t.rows[0][5])));
  EXPECT_EQ(std::get<std::string>(t.rows[1][2]), "1");
  EXPECT_EQ(std::get<double>(t.rows[1][3]), 0.1);
}

}  // namespace
}  // namespace taut
