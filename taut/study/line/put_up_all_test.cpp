#include "taut/study/line/put_up_all.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "taut/machine/builder.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::study::put_up_all_test {

/// A mast on a hinge, 10 m high, between two guys at 45 deg with 20 kN each, and a force at its top.
std::optional<machine::Model> guyed_mast(double force) {
  machine::Builder b;
  b.rope("guy", machine::RopeFigures{.mass = 0, .stiffness = 20e6, .breaking_force = 60e3, .diameter = {}});
  b.body("mast", {0, 0, 0}, 100, {"ry"}).point("top", {0, 0, 10}).point("w", {-10, 0, 0}).point("e", {10, 0, 0});
  b.description().points[0].body = "mast";
  b.guy("to w", "guy", "top", "w", 20e3).guy("to e", "guy", "top", "e", 20e3);
  b.force("top", {force, 0, 0});
  const auto model = b.model();
  EXPECT_TRUE(model);
  return model ? std::optional(*model) : std::nullopt;
}

// A guy keeps its length: of a force F the two take F/(2 cos 45 deg) each. Before it is put up its
// tension would be the same under any force.
TEST(PutUpAll, GuysOfABuilder) {
  auto model = guyed_mast(20e3);
  ASSERT_TRUE(model);
  const solve::EquilibriumResult before = solve::equilibrium(*model);
  EXPECT_NE(before.outcome.message.find("has not been put up"), std::string::npos) << before.outcome.message;
  ASSERT_TRUE(put_up_all(*model).ok());
  const solve::EquilibriumResult r = solve::equilibrium(*model);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(r.branches[0].T_from, 20e3 + 20e3 / std::sqrt(2.), 100);
  EXPECT_NEAR(r.branches[1].T_from, 20e3 - 20e3 / std::sqrt(2.), 100);
  const std::vector<double> lengths = {model->reevings[0].value, model->reevings[1].value};
  ASSERT_TRUE(put_up_all(*model).ok());
  EXPECT_EQ(model->reevings[0].value, lengths[0]) << "once";
  EXPECT_EQ(model->reevings[1].value, lengths[1]);
}

}  // namespace taut::study::put_up_all_test
