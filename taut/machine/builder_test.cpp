#include "taut/machine/builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
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

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A hoist with one rope, before `change`.
std::string told_of(const std::function<void(Builder&)>& change) {
  Builder b;
  b.point("pin", {0.2, 0, 10}).body("hook", {0, 0, 4}, 200).drum("winch", {-6, 0, 1}, 0.4);
  b.sheave("head", {0, 0, 10}, 0.4, 0.97).sheave("block", {0, 0, 0}, 0.4, 0.97, "hook").load("hook", 6000);
  b.rope("hoist", RopeFigures{.mass = 0.9, .stiffness = 10e6, .breaking_force = 150e3, .diameter = 0.016});
  b.reeve("hoist", {on_drum("winch"), over("head"), over("block"), anchor("pin")}, length(40));
  change(b);
  const auto model = b.model();
  return model ? "" : model.error().front().path + ": " + model.error().front().message;
}

// Nothing that a deck is refused for becomes a model, and nothing of it is found only by a solve that throws.
TEST(Builder, RefusesWhatADeckIsRefusedFor) {
  EXPECT_EQ(told_of([](Builder&) {}), "");
  const auto rope = [](const RopeFigures& figures) {
    return told_of([&](Builder& b) {
      b.description().ropes.clear();
      b.rope("hoist", figures);
    });
  };
  EXPECT_EQ(rope({.mass = -1, .stiffness = 1e7, .breaking_force = {}, .diameter = {}}),
            "ropes.hoist.mass: must be at least 0 kg/m and at most 1e9 kg/m, not -1 kg/m");
  EXPECT_EQ(rope({.mass = 1, .stiffness = 0, .breaking_force = {}, .diameter = {}}),
            "ropes.hoist.stiffness: must be above 0 MN, not 0 MN");
  EXPECT_EQ(rope({.mass = 1, .stiffness = nan, .breaking_force = {}, .diameter = {}}),
            "ropes.hoist.stiffness: is not a number");
  EXPECT_EQ(rope({.mass = 1, .stiffness = infinite, .breaking_force = {}, .diameter = {}}), "");
  EXPECT_EQ(rope({.mass = 1, .stiffness = 1e7, .breaking_force = nan, .diameter = {}}),
            "ropes.hoist.breaking_force: is not a number");
  EXPECT_EQ(rope({.mass = 1, .stiffness = 1e7, .breaking_force = -1e5, .diameter = {}}),
            "ropes.hoist.breaking_force: must be above 0 kN, not -100 kN");
  // what only a deck reads would be left out without a word
  EXPECT_EQ(told_of([](Builder& b) {
              b.carriage("car", 100, "hoist");
              b.description().carriages.back().library = "LARIX MOKO-25";
            }),
            "carriages.car.carriage: is taken from the catalogue by a deck alone: give the carriage its own figures");
  EXPECT_EQ(told_of([](Builder& b) { b.description().terrain.emplace().file = "ground.csv"; }),
            "terrain.file: is read by a deck alone: give 'x' and 'z'");
  EXPECT_EQ(told_of([](Builder& b) {
              b.sheave("third", {0, 0, 1}, 0.4, 1.5);
            }),
            "sheaves.third.efficiency: must be above 0 and at most 1, not 1.5");
  EXPECT_EQ(told_of([](Builder& b) {
              b.saddle("jack", {0, 0, 1}, -3);
            }),
            "supports.jack.friction: must be at least 0, not -3");
  EXPECT_EQ(told_of([](Builder& b) { b.drum("other", {0, 0, 1}, nan); }), "drums.other.core_diameter: is not a number");
  EXPECT_EQ(told_of([](Builder& b) { b.description().bodies[0].mass = -1000; }),
            "bodies.hook.mass: must be at least 0 kg and at most 1e9 kg, not -1000 kg");
  EXPECT_EQ(told_of([](Builder& b) { b.description().bodies[0].free = {"q"}; }),
            "bodies.hook.free[0]: 'q' is not a choice; write x, y, z, rx, ry, rz");
  EXPECT_EQ(told_of([](Builder& b) { b.description().reevings[0].length = nan; }),
            "reevings[0].length: is not a number");
  EXPECT_EQ(told_of([](Builder& b) { b.description().reevings[0].length = infinite; }),
            "reevings[0].length: must be finite");
  EXPECT_EQ(told_of([](Builder& b) { b.description().reevings[0].path[1] = falls(2000000000, "head", "block"); }),
            "reevings[0].path[1].parts: must be at least 1 and at most 64, not 2e9");
  EXPECT_EQ(told_of([](Builder& b) { b.load("hook", nan); }), "loads[1].mass: is not a number");
  EXPECT_EQ(told_of([](Builder& b) { b.force("hook", {nan, 0, 0}); }), "loads[1].force: is not a number");
  EXPECT_EQ(told_of([](Builder& b) { b.guy("g", "hoist", "pin", "pin", -5); }),
            "guys.g.install.tension: must be above 0 kN and at most 1e9 kN, not -0.005 kN");
  EXPECT_EQ(told_of([](Builder& b) { b.ground({0, nan}, {0, 1}); }), "terrain.x[1]: is not a number");
}

// The second of one name was dropped without a word.
TEST(Builder, RefusesTwoOfOneName) {
  EXPECT_EQ(told_of([](Builder& b) {
              b.point("pin", {0, 0, 30});
            }),
            "points.pin: another of 'points' is called so too: give this one another name");
  EXPECT_EQ(told_of([](Builder& b) { b.rope("hoist", "EN 12385-4|6x36-IWRC|20|1960"); }),
            "ropes.hoist: another of 'ropes' is called so too: give this one another name");
  EXPECT_EQ(told_of([](Builder& b) {
              b.sheave("head", {0, 0, 1}, 0.4);
            }),
            "sheaves.head: another of 'sheaves' is called so too: give this one another name");
}

}  // namespace taut::machine::builder_test
