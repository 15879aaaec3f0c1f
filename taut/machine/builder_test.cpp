#include "taut/machine/builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace taut::machine::builder_test {

Builder skyline() {
  Builder b;
  b.point("tail", {0, 0, 4}).point("tower", {360, 0, 124});
  b.rope("skyline", "EN 12385-4|6x36-IWRC|20|1960");
  b.saddle("jack", {200, 0, 70}, 0.1, 0.4);
  b.carriage("car", 350, "skyline").load("car", 1500);
  b.reeve("skyline", {anchor("tail"), through("car"), over("jack"), anchor("tower")}, length(384));
  return b;
}

TEST(Builder, MakesTheModelThatItsNamesMean) {
  const auto model = skyline().model();
  ASSERT_TRUE(model.has_value()) << model.error().front().message;
  ASSERT_EQ(model->reevings.size(), 1U);
  const Reeving& rope = model->reevings[0];
  EXPECT_EQ(rope.value, 384);
  ASSERT_EQ(rope.nodes.size(), 4U);
  EXPECT_EQ(rope.nodes[2].law.friction, 0.1);
  EXPECT_GT(rope.breaking_force, 200e3);
  EXPECT_EQ(reeving_named(*model, "skyline"), 0);
  EXPECT_EQ(carriage_named(*model, "car"), 0);
  EXPECT_EQ(body_named(*model, "car"), model->carriages[0].body);
  EXPECT_EQ(reeving_named(*model, "mainline"), std::nullopt);
}

TEST(Builder, TellsMistakesAtTheirPlaces) {
  Builder b = skyline();
  b.description().reevings[0].path[2].over = "jakc";
  const auto model = b.model();
  ASSERT_FALSE(model.has_value());
  EXPECT_TRUE(std::any_of(model.error().begin(), model.error().end(),
                          [](const Complaint& c) {
                            return c.path == "reevings[0].path[2].over" && c.message.find("jack") != std::string::npos;
                          }))
      << model.error().front().path << ": " << model.error().front().message;
}

TEST(Builder, FallsAreBranchesBetweenTheBlocks) {
  Builder b;
  b.rope("hoist", RopeFigures{.mass = 0.9, .stiffness = 10e6, .breaking_force = 150e3, .diameter = 0.016})
      .body("hook", {0, 0, 4}, 200);
  b.sheave("head", {0, 0, 10}, 0.4, 0.97).sheave("block", {0, 0, 0}, 0.4, 0.97, "hook").drum("winch", {-6, 0, 1}, 0.4);
  b.point("pin", {0.2, 0, 10}).load("hook", 6000);
  b.reeve("hoist", {on_drum("winch"), falls(4, "head", "block"), anchor("pin")}, length(40));
  b.drive("winch", "0.2 m/s");
  const auto model = b.model();
  ASSERT_TRUE(model.has_value()) << model.error().front().path << ": " << model.error().front().message;
  EXPECT_EQ(model->reevings[0].nodes.size(), 6U);  // drum, head, block, head, block, pin
  EXPECT_EQ(model->drums.size(), 1U);
}

}  // namespace taut::machine::builder_test
