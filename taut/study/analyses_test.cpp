#include "taut/study/analyses.hpp"

#include <gtest/gtest.h>

namespace taut::study::analyses_test {

TEST(Analyses, TheHighestTemperatureIsThatOfAllJudgedStates) {
  machine::Machine machine;
  std::vector<AnalysisRequest> all(3);
  all[0].envelope.emplace().temperatures = {253.15, 403.15};
  SweepRequest& sweep = all[1].sweep.emplace();
  sweep.parameter = "machine.temperature";
  sweep.from = "200 degC";
  sweep.to = "-20 degC";
  all[2].installation.emplace().to = 503.15;
  EXPECT_DOUBLE_EQ(hottest_of(machine, all).value(), 503.15);
  EXPECT_DOUBLE_EQ(coldest_of(machine, all).value(), 253.15);
  all[2].installation->judge = false;
  EXPECT_DOUBLE_EQ(hottest_of(machine, all).value(), 473.15);
  sweep.parameter = "loads[0].mass";
  EXPECT_DOUBLE_EQ(hottest_of(machine, all).value(), 403.15);
  machine.temperature = 423.15;
  EXPECT_DOUBLE_EQ(hottest_of(machine, all).value(), 423.15);
  EXPECT_DOUBLE_EQ(hottest_of(machine, {}).value(), 423.15);
  EXPECT_DOUBLE_EQ(coldest_of(machine, {}).value(), 423.15);
  EXPECT_FALSE(coldest_of({}, {}));
  EXPECT_FALSE(hottest_of({}, {}));
}

}  // namespace taut::study::analyses_test
