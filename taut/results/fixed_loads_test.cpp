#include "taut/results/fixed_loads.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::results::fixed_loads_test {

using namespace taut_test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A mast with a guy, and 500 kN sideways at its top.
std::string mast(const char* body) {
  return fmt::format(R"(taut: 1
machine:
  ropes: {{guy: {{mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 200 kN, diameter: 18 mm}}}}
  bodies: {{mast: {}}}
  points:
    top: {{body: mast, at: [0 m, 0 m, 10 m]}}
    stump: [-15 m, 0 m, 0 m]
  guys: {{g1: {{rope: guy, from: top, to: stump, install: {{tension: 20 kN, at: top}}}}}}
  loads: [{{at: top, force: [500 kN, 0 N, 0 N]}}]
analyses: [{{equilibrium: {{}}}}]
checks: {{ropes: {{guy: {{safety_factor: 3}}}}}}
)",
                     body);
}

// The guy keeps its 20 kN, and passes with a factor of 10: the mast without 'free' bears the load by itself.
TEST(FixedLoads, a_load_that_no_rope_feels_is_unsafe) {
  const Result r = run_text(mast("{mass: 500 kg}"));
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes_with_warnings);
  ASSERT_EQ(r.unsafe.size(), 2u);
  EXPECT_NE(r.unsafe[0].find("'mast' cannot move, and bears its load of 500 kN"), std::string::npos) << r.unsafe[0];
  EXPECT_NE(r.unsafe[1].find("guy 'g1' ends at fixed points, 'top' and 'stump'"), std::string::npos) << r.unsafe[1];
}

TEST(FixedLoads, where_the_rope_holds_the_body_it_feels_the_load) {
  const Result r = run_text(mast("{mass: 500 kg, free: [ry]}"));
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_TRUE(r.unsafe.empty());
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_GT(value_of(r, "g1.T_max"), 500e3 / std::cos(std::atan(10. / 15)));
}

// What moves by a signal, and what bears no load, is not told of.
TEST(FixedLoads, driven_bodies_and_bodies_without_load) {
  machine::Model model;
  model.bodies.resize(3);
  model.bodies[0].driven.resize(1);
  model.bodies[1].free.push_back({.along = Vector3::UnitX()});
  model.loads.push_back({{.body = 0, .at = Vector3::Zero()}, {1e3, 0, 0}});
  model.loads.push_back({{.body = 1, .at = Vector3::Zero()}, {1e3, 0, 0}});
  EXPECT_TRUE(fixed_load_warnings(model).empty());
  model.loads.push_back({{.body = 2, .at = Vector3::Zero()}, {0, 0, -1e3}});
  EXPECT_EQ(fixed_load_warnings(model).size(), 1u);
}

/// The warning of a load on a body with these freedoms; the load acts 2 m along x from the origin of the body.
std::vector<LoadAcross> told_of(const std::vector<machine::Freedom>& free, const Vector3& force) {
  machine::Model model;
  model.bodies.resize(1);
  model.bodies[0].name = "b";
  model.bodies[0].free.assign(free.begin(), free.end());
  model.loads.push_back({{.body = 0, .at = {2, 0, 0}}, force});
  return load_across_warnings(model);
}

// A y axis that was meant to be the vertical: the load does no work, and nobody feels it.
TEST(FixedLoads, a_load_across_what_is_free_is_told) {
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  const std::vector<machine::Freedom> plane = {{.along = x}, {.along = z}};
  EXPECT_TRUE(told_of(plane, {3e3, 0, -5e3}).empty());
  EXPECT_TRUE(told_of(plane, {3e3, 20, -5e3}).empty());
  const auto up_is_y = told_of(plane, {0, -49e3, 0});
  ASSERT_EQ(up_is_y.size(), 1U);
  EXPECT_TRUE(up_is_y[0].unsafe);
  EXPECT_THAT(up_is_y[0].text, HasSubstr("'b' bears its load by itself, [0, -49, 0] kN"));
  const auto part = told_of(plane, {3e3, 1e3, -5e3});
  ASSERT_EQ(part.size(), 1U);
  EXPECT_TRUE(part[0].unsafe);
  EXPECT_THAT(part[0].text, HasSubstr("a part of its load by itself, [0, 1, 0] kN"));
  // rails bear what presses on them
  const auto slope = told_of({{.along = (x + z).normalized()}}, {0, 0, -5e3});
  ASSERT_EQ(slope.size(), 1U);
  EXPECT_FALSE(slope[0].unsafe);
  EXPECT_TRUE(told_of({{.along = x}}, {0, 0, -5e3})[0].unsafe);
}

// Also along the arm: as soon as the body has turned it does work.
TEST(FixedLoads, a_load_on_what_turns_is_borne_along_its_axis_alone) {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  EXPECT_TRUE(told_of({{.about = y}}, {3e3, 0, -5e3}).empty());
  EXPECT_TRUE(told_of({{.about = y}}, {3e3, 0, 0}).empty());
  EXPECT_EQ(told_of({{.about = y}}, {0, 3e3, 0}).size(), 1U);
  EXPECT_EQ(told_of({{.about = x}}, {0, 0, -5e3}).size(), 1U);  // it is on the axis
  EXPECT_TRUE(told_of({{.about = x}, {.about = y}, {.about = z}}, {3e3, 4e3, -5e3}).empty());
  EXPECT_TRUE(told_of({{.along = y}, {.about = y}}, {3e3, 4e3, -5e3}).empty());
}

/// A hook of 3 t on two falls, 9 m below its head; `body`: what is said of it.
std::string hook(const char* body) {
  return fmt::format(R"(taut: 1
machine:
  ropes: {{hoist: {{mass: 1 kg/m, stiffness: 10 MN, breaking_force: 100 kN, diameter: 14 mm}}}}
  bodies: {{hook: {{mass: 3 t, at: [0 m, 0 m, 1 m]{}}}}}
  points: {{left: [-0.2 m, 0 m, 10 m], right: [0.2 m, 0 m, 10 m]}}
  sheaves: {{block: {{body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm}}}}
  reevings: [{{name: hoist, rope: hoist, path: [{{anchor: left}}, {{over: block}}, {{anchor: right}}], length: 18.65 m}}]
analyses: [{{equilibrium: {{}}}}]
checks: {{ropes: {{hoist: {{safety_factor: 3}}}}}}
)",
                     body);
}

// Its rope carries nothing, and passes.
TEST(FixedLoads, a_hook_that_is_not_free_is_unsafe) {
  const Result r = run_text(hook(""));
  ASSERT_EQ(r.unsafe.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_NE(r.unsafe[0].find("'hook' cannot move, and hangs on ropes that do not feel its mass of 3000 kg"),
            std::string::npos)
      << r.unsafe[0];
  const Result free = run_text(hook(", free: [z]"));
  EXPECT_TRUE(free.unsafe.empty()) << free.message << to_text(free.errors);
  EXPECT_NEAR(value_of(free, "hoist.T_max"), 3000 * 9.80665 / 2, 200);
}

// A winch stands below its tower: its rope leads up, and it hangs on nothing.
TEST(FixedLoads, a_winch_below_its_rope_does_not_hang) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 100 kN, diameter: 14 mm}}
  bodies:
    yarder: {mass: 5 t, at: [0 m, 0 m, 0 m]}
    hook: {mass: 1 t, at: [2 m, 0 m, 3 m], free: [x, z]}
  drums: {winch: {body: yarder, at: [0 m, 0 m, 1 m], core_diameter: 300 mm}}
  sheaves: {head: {at: [1 m, 0 m, 12 m], diameter: 400 mm}}
  reevings: [{name: hoist, rope: hoist, path: [{drum: winch}, {over: head}, {anchor: hook}], length: 20 m}]
analyses: [{equilibrium: {}}]
checks: {ropes: {hoist: {safety_factor: 3}}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(r.unsafe.empty()) << r.unsafe[0];
}

// A point 'head' of the ground at the mast's top holds the guy in the air.
TEST(FixedLoads, a_rope_at_the_ground_beside_the_top_of_a_mast_is_unsafe) {
  const auto mast = [](const char* from) {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{guy: {{mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 200 kN, diameter: 18 mm}}}}
  points: {{foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 12 m], west: [-12 m, 0 m, 0 m], east: [12 m, 0 m, 0 m], near: [0.5 m, 0 m, 0.2 m]}}
  beams: {{mast: {{from: foot, to: head, section: CHS 168.3x6.3, steel: S355}}}}
  guys:
    g1: {{rope: guy, from: {0}, to: west, install: {{tension: 20 kN, at: anchor}}}}
    g2: {{rope: guy, from: mast.top, to: east, install: {{tension: 20 kN, at: anchor}}}}
    g3: {{rope: guy, from: foot, to: near, length: 0.55 m}}
analyses: [{{equilibrium: {{}}}}]
checks: {{guys: {{guy: {{safety_factor: 3, may_go_slack: true}}}}, masts: {{mast: {{load_factor: 1.5}}}}}}
)",
                                from));
  };
  const Result beside = mast("head");
  ASSERT_EQ(beside.status, Status::ok) << beside.message << to_text(beside.errors);
  EXPECT_THAT(beside.unsafe,
              Contains(HasSubstr("'head' holds 'g1' as a fixed point of the ground, where 'mast' stands")));
  const Result right = mast("mast.top");
  ASSERT_EQ(right.status, Status::ok) << right.message << to_text(right.errors);
  EXPECT_THAT(right.unsafe, ElementsAre(HasSubstr("guy 'g3' ends at fixed points, 'foot' and 'near'")));
}

// What an analysis puts on such a body is a mistake.
TEST(FixedLoads, analyses_that_load_a_body_that_cannot_move) {
  const auto mistakes = [](const std::string& analysis, const std::string& free = "") {
    return to_text(run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: 20 MN, breaking_force: 100 kN}}}}
  points: {{a: [0 m, 0 m, 20 m], b: [0 m, 0 m, 0 m]}}
  bodies: {{hook: {{mass: 10 kg, at: [0 m, 0 m, 10 m]{}}}}}
  reevings: [{{name: up, rope: r, path: [{{anchor: a}}, {{anchor: hook}}], length: 10 m}},
             {{name: down, rope: r, path: [{{anchor: hook}}, {{anchor: b}}], length: 9.99 m}}]
  loads: [{{at: hook, mass: 0 t}}]
analyses: [{}]
)",
                                        free, analysis))
                       .errors);
  };
  const char* const all[] = {
      "{envelope: {load_at: hook, loads: [8 t]}}",
      "{sweep: {parameter: loads.hook.mass, from: 0 t, to: 8 t, steps: 1}}",
      "{pretension: {least: {tension: 2 kN, ropes: [down], cases: [{name: full, loads: [{at: hook, mass: 5 t}]}]}}}"};
  for (const char* const analysis : all) {
    EXPECT_NE(mistakes(analysis).find("'hook' cannot move: no rope feels a load on it"), std::string::npos) << analysis;
    EXPECT_EQ(mistakes(analysis, ", free: [z]").find("cannot move"), std::string::npos) << analysis;
  }
}

}  // namespace taut::results::fixed_loads_test
