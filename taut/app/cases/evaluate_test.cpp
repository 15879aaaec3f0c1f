#include "taut/app/cases/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/base/expects.hpp"

namespace taut::app::evaluate_test {

using testing::ElementsAre;
using testing::SizeIs;

/// x and y to their sum and product; none where x is negative.
CaseModel sum_and_product() {
  CaseModel model;
  model.inputs.resize(2);
  model.outputs.resize(2);
  model.answer = [](std::span<const double> v) -> CaseAnswer {
    if (v[0] < 0) return {.outputs = {0, 0}, .outcome = infeasible("x is negative")};
    return {.outputs = {v[0] + v[1], v[0] * v[1]}, .outcome = {}};
  };
  return model;
}

TEST(Evaluate, RowsAreAnsweredEachByItself) {
  const std::vector<double> values = {1, 2, -1, 5, 3, 4};
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<double> outputs(6);
    const Evaluated done = evaluate(sum_and_product(), values, outputs, {.threads = threads});
    EXPECT_FALSE(done.interrupted);
    ASSERT_THAT(done.without, SizeIs(1));
    EXPECT_EQ(done.without[0].row, 1U);
    EXPECT_EQ(done.without[0].reason, "x is negative");
    EXPECT_TRUE(std::isnan(outputs[2]) && std::isnan(outputs[3]));
    EXPECT_THAT((std::vector{outputs[0], outputs[1], outputs[4], outputs[5]}), ElementsAre(3, 2, 7, 12));
  }
}

TEST(Evaluate, EndsWhereItIsToldTo) {
  const std::vector<double> values(2000, 1.0);
  std::vector<double> outputs(2000);
  const auto stop = [](std::size_t done) { return done < 10; };
  const Evaluated done = evaluate(sum_and_product(), values, outputs, {.threads = 1, .go_on = stop});
  EXPECT_TRUE(done.interrupted);
  EXPECT_EQ(std::count_if(outputs.begin(), outputs.end(), [](double x) { return !std::isnan(x); }), 20);
}

TEST(Evaluate, RefusesSizesThatDoNotFit) {
  std::vector<double> outputs(2);
  EXPECT_THROW(evaluate(sum_and_product(), std::vector<double>(3), outputs), ContractViolation);
  EXPECT_THROW(evaluate(sum_and_product(), std::vector<double>(4), outputs), ContractViolation);
}

TEST(Evaluate, NoRowsAreNoWork) { EXPECT_FALSE(evaluate(sum_and_product(), {}, {}).interrupted); }

}  // namespace taut::app::evaluate_test
