#include "taut/checks/yarder/carriage_checks.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::carriage_checks_test {

using namespace taut_test;

/// A skyline of 200 m with a carriage that is clamped in the middle. `car`: more keys of it; `parts`: of the machine.
std::string skyline(const std::string& car, const std::string& parts,
                    const std::string& diameter = "diameter: 30 mm,") {
  return fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 40 m], b: [200 m, 0 m, 40 m]}}
  ropes:
    sky: {{{} mass: 4 kg/m, stiffness: 50 MN, breaking_force: 900 kN}}
    drop: {{mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 400 kN}}
  carriages: {{car: {{mass: 300 kg, rides: sky, hold: clamped, length_before: 101 m, at: [100 m, 0 m, 30 m], {}}}}}
{}
checks: {{ropes: {{sky: {{safety_factor: 2, elastic_limit: 0.9}}}}}}
)",
                     diameter, car, parts);
}
constexpr const char* alone =
    "  reevings: [{rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 202 m}]\n";
/// 5 t on a rope of 10 m below the carriage.
std::string with_log(const char* path) {
  return fmt::format(R"(  reevings:
    - {{rope: sky, path: [{{anchor: a}}, {{through: car}}, {{anchor: b}}], length: 202 m}}
    - {{rope: drop, path: {}, length: 10 m}}
  bodies: {{log: {{mass: 5 t, at: [100 m, 0 m, 20 m], free: [x, y, z]}}}}
analyses: [{{equilibrium: {{}}}}]
)",
                     path);
}

// 5 t and 5 kg of rope at the carriage, whichever end of its path the rope has there.
TEST(CarriageChecks, WhatHangsOnAnotherRopeCounts) {
  for (const char* path : {"[{anchor: car}, {anchor: log}]", "[{anchor: log}, {anchor: car}]"}) {
    const Result r = run_text(skyline("rated_payload: 2 t", with_log(path)));
    ASSERT_EQ(r.status, Status::ok) << r.message;
    EXPECT_NEAR(check_of(r, "car.payload").value, 5005, 1e-3);
    EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  }
}

// The rope on which it rides and its mainline draw it along, also where they run to a body that can move: a shackle.
TEST(CarriageChecks, APieceOfItsOwnRopesIsNoLoad) {
  const auto load = [](const char* path, const char* more) {
    const Result r = run_text(fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 40 m], b: [200 m, 0 m, 40 m]}}
  ropes:
    sky: {{mass: 4 kg/m, stiffness: 50 MN, breaking_force: 900 kN}}
    main: {{mass: 1 kg/m, stiffness: 10 MN, breaking_force: 400 kN}}
  drums: {{winch: {{at: [0 m, 0 m, 39 m]}}}}
  carriages: {{car: {{mass: 300 kg, rides: sky, mainline: line, at: [100 m, 0 m, 30 m], rated_payload: 1200 kg}}}}
  loads: [{{at: car, mass: 1300 kg}}]
  reevings:
    - {{rope: sky, path: [{{anchor: a}}, {{through: car}}, {{anchor: b}}], length: 202 m}}
    - {{rope: main, name: line, path: [{}, {{anchor: car}}], length: {}}}
{}
analyses: [{{equilibrium: {{}}}}]
checks: {{ropes: {{sky: {{safety_factor: 2}}}}}}
)",
                                          path, *more == 0 ? "80 m" : "40 m", more));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return check_of(r, "car.payload").value;
  };
  EXPECT_NEAR(load("{drum: winch}", ""), 1300, 1e-6);
  EXPECT_NEAR(load("{anchor: shackle}",
                   "    - {rope: main, name: first, path: [{drum: winch}, {anchor: shackle}], length: 40 m}\n"
                   "  bodies: {shackle: {mass: 0 kg, at: [50 m, 0 m, 37 m], free: [x, y, z]}}"),
              1300, 1e-6);
}

// A rope that pulls the carriage down to a stump loads it as a load does; a mainline draws it along its line.
TEST(CarriageChecks, ARopeThatPullsItDownCounts) {
  const auto held_down = [](bool mainline) {
    std::string deck =
        skyline(mainline ? "rated_payload: 1300 kg, mainline: down" : "rated_payload: 1300 kg", R"(  reevings:
    - {rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 202 m}
    - {rope: drop, name: down, path: [{anchor: stump}, {anchor: car}], tension_at_end: 20 kN}
analyses: [{equilibrium: {}}]
)");
    const std::string points = "points: {";
    deck.insert(deck.find(points) + points.size(), "stump: [100 m, 0 m, 0 m], ");
    return run_text(deck);
  };
  const Result r = held_down(false);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(check_of(r, "car.payload").value, 20e3 / 9.80665, 1);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  const Result along = held_down(true);
  ASSERT_EQ(along.status, Status::ok) << along.message << to_text(along.errors);
  EXPECT_NEAR(check_of(along, "car.payload").value, 0, 1e-6);
}

// The rating is one of loads at rest: the log falls into its rope, and the rope pulls with more than its weight.
TEST(CarriageChecks, InAMotionALoadThatBouncesCountsWithItsWeight) {
  std::string deck = skyline("rated_payload: 6 t", with_log("[{anchor: car}, {anchor: log}]"));
  const std::string rest = "equilibrium: {}";
  deck.replace(deck.find(rest), rest.size(), "transient: {duration: 2 s, tolerance: 1e-3, start: assembled}");
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_GT(value_of(r, "drop.T_max"), 1.1 * 5000 * 9.80665);
  EXPECT_NEAR(check_of(r, "car.payload").value, 5000, 1e-6);
}

// In a motion too: all that hangs below counts, and a force that grows.
TEST(CarriageChecks, InAMotionAllThatHangsCounts) {
  const auto run = [](const std::string& parts) {
    return run_text(
        skyline("rated_payload: 6 t",
                R"(  signals: {stuck: {ramp: {from: 0.1 kN, to: 20 kN, start: 0.1 s, duration: 1 s, smooth: true}}}
)" + parts + "analyses: [{transient: {duration: 3 s, output_step: 50 ms, tolerance: 1e-3}}]\n"));
  };
  const std::string path = "{rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 202 m}";
  const Result two = run("  reevings: [" + path + R"(,
      {name: d1, rope: drop, path: [{anchor: car}, {anchor: hook}], length: 6 m},
      {name: d2, rope: drop, path: [{anchor: hook}, {anchor: log}], length: 3 m}]
  bodies:
    hook: {mass: 50 kg, at: [100 m, 0 m, 24 m], free: [x, y, z]}
    log: {mass: 2 t, at: [100 m, 0 m, 21 m], free: [x, y, z]}
)");
  ASSERT_EQ(two.status, Status::ok) << two.message << to_text(two.errors);
  EXPECT_NEAR(check_of(two, "car.payload").value, 2050, 10);
  const Result grows =
      run("  reevings: [" + path + R"(, {name: d1, rope: drop, path: [{anchor: car}, {anchor: log}], length: 9 m}]
  bodies: {log: {mass: 500 kg, at: [100 m, 0 m, 21 m], free: [x, y, z]}}
  loads: [{at: log, force: [0 kN, 0 kN, -0.1 kN], signal: stuck}]
)");
  ASSERT_EQ(grows.status, Status::ok) << grows.message << to_text(grows.errors);
  EXPECT_NEAR(check_of(grows, "car.payload").value, 500 + 20e3 / 9.80665, 10);
}

// A tag line that is slack pulls nothing: the load that falls into its rope counts with its weight.
TEST(CarriageChecks, ASlackTagLineMakesNoLoad) {
  std::string text = skyline("rated_payload: 6 t", with_log("[{anchor: car}, {anchor: log}]"));
  const std::string rest = "equilibrium: {}", log = "length: 10 m}\n";
  text.replace(text.find(rest), rest.size(), "transient: {duration: 2 s, tolerance: 1e-3, start: assembled}");
  text.insert(text.find(log) + log.size(),
              "    - {name: tag, rope: drop, path: [{anchor: log}, {anchor: b}], length: 150 m}\n");
  const Result r = run_text(text);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_GT(value_of(r, "drop.T_max"), 1.1 * 5000 * 9.80665);
  EXPECT_NEAR(check_of(r, "car.payload").value, 5000, 40) << "and half of the rope that lies there";
}

// A payload keeps the rating with what hangs there already.
TEST(CarriageChecks, APayloadLeavesRoomForWhatHangs) {
  std::string deck = skyline("rated_payload: 6 t", with_log("[{anchor: car}, {anchor: log}]"));
  const std::string rest = "equilibrium: {}";
  deck.replace(deck.find(rest), rest.size(), "payload: {carriage: car, from: 100 m, to: 100 m, limits: {}}");
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "payload_min"), 6000 - 5005, 1);
}

TEST(CarriageChecks, ARopeWithoutADiameterIsNotJudged) {
  const std::string fits = "rope_diameters: [24 mm, 36 mm]";
  EXPECT_EQ(verdict_of(run_text(skyline(fits, alone)))->kind, VerdictKind::passes);
  const Result r = run_text(skyline(fits, alone, ""));
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_THAT(r.unmade, testing::Contains(testing::HasSubstr("the diameter of 'sky' is not known")));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged);
}

}  // namespace taut::checks::carriage_checks_test
