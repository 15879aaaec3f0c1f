#include "taut/app/swept_verdict.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace taut::app::swept_verdict_test {

Result with(const std::string& warning, bool unsafe, double factor) {
  Result r;
  unsafe ? warn_unsafe(r, warning) : r.warnings.push_back(warning);
  r.checks.push_back(make_check("sky.safety_factor", factor, si::one,
                                {.sense = Sense::at_least, .limit = 3, .rule = "a rule", .trust = "user"}));
  return r;
}

TEST(SweptVerdict, KeepsAllChecksWithTheirStateAndEachWarningOnce) {
  SweptVerdict verdict;
  verdict.take(with("strained by 1.9 %", false, 4), "d = 20 mm");
  verdict.take(with("strained by 1.95 %", false, 2), "d = 18 mm");
  verdict.take(with("strained by 2.1 %", true, 1), "d = 16 mm");
  Result none;
  none.status = Status::infeasible;
  none.message = "no room";
  verdict.take(none, "d = 1 mm");
  Result r;
  std::move(verdict).put_into(r);
  ASSERT_EQ(r.checks.size(), 3U);
  EXPECT_EQ(r.checks[2].where, "d = 16 mm");
  EXPECT_FALSE(r.checks[2].passes);
  ASSERT_EQ(r.warnings.size(), 2U);  // a plain one does not hide the unsafe one of the same words
  EXPECT_EQ(r.warnings[0], "d = 20 mm: strained by 1.9 %");
  ASSERT_EQ(r.unsafe.size(), 1U);
  EXPECT_EQ(r.unsafe[0], "d = 16 mm: strained by 2.1 %");
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_EQ(r.unmade[0], "d = 1 mm: its checks have no answer: no room");
}

}  // namespace taut::app::swept_verdict_test
