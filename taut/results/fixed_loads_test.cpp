#include "taut/results/fixed_loads.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::results::fixed_loads_test {

using namespace taut_test;

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
  ASSERT_EQ(r.unsafe.size(), 1u);
  EXPECT_NE(r.unsafe[0].find("'mast' cannot move, and bears its load of 500 kN"), std::string::npos) << r.unsafe[0];
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
