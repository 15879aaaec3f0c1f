#include "taut/methods/closed_loop/paper_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/cases/closed_loop_example.hpp"

namespace taut::closed_loop::paper_choice_test {

using taut_test::kgf;
using taut_test::kgf_per_mm2;
using taut_test::mm2;

Input sized() {
  Input in = taut_test::example();
  in.safety_factor = 3.5;
  in.wire_strength = 140 * kgf_per_mm2;
  in.weight_per_area = 0.01 * kgf / mm2;
  return in;
}

// The paper's example: 165.7 mm^2 by (8) for 3.5 have 3.12 only.
TEST(PaperChoice, of_the_example) {
  const Result r = run(sized());
  ASSERT_NE(r.find_value("safety_factor_return_paper"), nullptr);
  EXPECT_NEAR(r.find_value("safety_factor_return_paper")->value, 3.12, 0.00312);
  EXPECT_THAT(r.warnings, testing::Contains(testing::AllOf(testing::HasSubstr("(8) is unsafe for the return rope"),
                                                           testing::HasSubstr("have 3.12"))));
}

// A loop without loss behind the sheave is as tight in its upper branch: nothing to warn of there.
TEST(PaperChoice, nothing_without_areas) {
  Input in = sized();
  in.safety_factor.reset();
  const Result r = run(in);
  EXPECT_EQ(r.find_value("safety_factor_return_paper"), nullptr);
}

}  // namespace taut::closed_loop::paper_choice_test
