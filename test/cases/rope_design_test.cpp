#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "taut/app/job.hpp"
#include "taut/rope/strength.hpp"
#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

/// Worked numbers of rope choice from outside, against the examples of examples/design.
namespace rope_design_test {

using namespace taut;
using taut_test::check_of;
using taut_test::value_of;

Result example(const std::string& name) {
  const auto job = taut::app::read_job((taut_test::source_dir() / "examples/design" / name).string());
  EXPECT_TRUE(job.has_value());
  return taut::app::run(*job);
}

// Lead line of n parts, S = Q K^n (K - 1)/(K^n - 1), and d_min = sqrt(Z_p S/(K' R_r)) (ISO 4308-1, rope dealers' public
// pages; K' = 0.356 for 6x36 with a steel core): 25.35 t on 8 parts with K = 1/0.98 are 34.0 kN and 13.96 mm.
TEST(RopeDesign, crane_hoist_by_iso_4308) {
  const double K = 1 / 0.98;
  const double K8 = std::pow(K, 8);
  const double S = 25350 * 9.80665 * K8 * (K - 1) / (K8 - 1);
  EXPECT_NEAR(S, 34.0e3, 50);
  EXPECT_NEAR(rope::least_diameter(4.0, S, 0.356, 1960e6), 13.96e-3, 1e-5);
  const Result r = example("crane_hoist.yaml");
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "hoist.T_max"), S, 0.01 * S);  // the rope's own weight is not in the formula
  const double needed = rope::least_diameter(4.0, value_of(r, "hoist.T_max"), 0.356, 1960e6);
  const Table* t = r.find_table("design");
  ASSERT_NE(t, nullptr);
  const double chosen = std::get<double>(t->rows.at(0).at(2));
  EXPECT_GE(chosen, needed);
  EXPECT_LT(chosen, needed + 2e-3);
  EXPECT_EQ(check_of(r, "hoist.safety_factor").limit, 4.0);
}

// Swiss practice: a third of the breaking force with the load at the worst place; the next lighter rope would not do.
TEST(RopeDesign, swiss_skyline) {
  const Result r = example("swiss_skyline.yaml");
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const Check& factor = check_of(r, "skyline.safety_factor");
  EXPECT_EQ(factor.limit, 3.0);
  EXPECT_GE(factor.value, 3.0);
  EXPECT_EQ(factor.trust, "verified");
  const Table* t = r.find_table("design_runner_ups");
  ASSERT_NE(t, nullptr);
  EXPECT_EQ(std::get<std::string>(t->rows.front().at(2)), "fails");
}

}  // namespace rope_design_test
