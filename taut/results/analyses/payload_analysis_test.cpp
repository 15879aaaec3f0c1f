#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace payload_analysis_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::Table;

std::string payload_of(const std::string& limits, double from, double to, int steps) {
  return skyline_deck(
      fmt::format("  - payload: {{carriage: car, from: {} m, to: {} m, steps: {}, motion: in, "
                  "limits: {{{}}}, most: 30 t}}",
                  from, to, steps, limits));
}

/// The sense of the skyline over its jacks: else it creeps both ways, and the witness would have to read a band.
const std::string told = "machine.reevings[0].haul=to_start";

/// A single state with this load on the carriage: the witness of a payload.
Result state_of(double x, double mass) {
  return run_text(skyline_deck(fmt::format("  - equilibrium: {{carriage: car, x: {:.17g} m, motion: in}}", x)),
                  {fmt::format("machine.loads[0].mass={:.17g} kg", mass), told});
}

struct Case {
  std::string limit, governing;
  double from, to;
  double (*value)(const Result&);  ///< what must not exceed 1
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {.limit = "skyline: {safety_factor: 3.5}",
       .governing = "tension of 'skyline'",
       .from = 140,
       .to = 170,
       .value = [](const Result& r) { return value_of(r, "skyline.T_max") / (280e3 / 3.5); }},
      {.limit = "skyline: {tension: 70 kN}",
       .governing = "tension of 'skyline'",
       .from = 130,
       .to = 170,
       .value = [](const Result& r) { return value_of(r, "skyline.T_max") / 70e3; }},
      {.limit = "winch: {pull: 4 kN}",
       .governing = "pull of 'mainline' at 'winch'",
       .from = 150,
       .to = 225,
       .value = [](const Result& r) { return value_of(r, "mainline.T_start") / 4e3; }},
      {.limit = "clearance: 3 m",
       .governing = "clearance of 'car'",
       .from = 150,
       .to = 190,
       .value = [](const Result& r) { return 1 + (3 - value_of(r, "clearance_min")) / 100; }},
      {.limit = "break_angle: 27 deg",
       .governing = "break angle at 'jack1'",
       .from = 138,
       .to = 148,
       .value =
           [](const Result& r) {
             const Table& t = table_of(r, "sheaves");
             return cell(t, row_of(t, "name", "jack1"), "wrap") / (27 * M_PI / 180);
           }},
  };
  return all;
}

TEST(PayloadAnalysis, TheGoverningLimitIsReachedAndALittleMoreBreaksIt) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.limit);
    const Result r = run_text(payload_of(one.limit, one.from, one.to, 3), {told});
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    const Table& t = table_of(r, "payload");
    ASSERT_EQ(t.rows.size(), 4U);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      const double x = cell(t, i, "x"), mass = cell(t, i, "payload");
      EXPECT_EQ(text_cell(t, i, "governing"), one.governing);
      ASSERT_GT(mass, 100) << "x " << x;
      EXPECT_NEAR(one.value(state_of(x, mass)), 1, 1e-6) << "x " << x;
      EXPECT_GT(one.value(state_of(x, 1.001 * mass)), 1) << "x " << x;
      EXPECT_NEAR(cell(t, i, "skyline.T_max") / value_of(state_of(x, mass), "skyline.T_max"), 1, 1e-7);
    }
  }
}

TEST(PayloadAnalysis, TheLeastOfAllLimitsGoverns) {
  std::string together;
  std::vector<std::vector<double>> alone;
  for (const Case& one : cases()) {
    if (one.limit.find("safety_factor") != std::string::npos) continue;
    together += (together.empty() ? "" : ", ") + one.limit;
    const Result r = run_text(payload_of(one.limit, 140, 200, 6));
    alone.emplace_back();
    for (std::size_t i = 0; i < 7; ++i) alone.back().push_back(cell(table_of(r, "payload"), i, "payload"));
  }
  const Result all = run_text(payload_of(together, 140, 200, 6));
  ASSERT_EQ(all.status, Status::ok) << all.message << to_text(all.errors);
  const Table& t = table_of(all, "payload");
  double least = 1e9, where = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    double expected = 1e9;
    for (const auto& one : alone) expected = std::min(expected, one[i]);
    EXPECT_NEAR(cell(t, i, "payload") / std::max(1.0, expected), expected / std::max(1.0, expected), 1e-6);
    if (expected < least) {
      least = expected;
      where = cell(t, i, "x");
    }
  }
  EXPECT_NEAR(value_of(all, "payload_min"), least, 1e-5 * least);
  EXPECT_EQ(value_of(all, "payload_min_x"), where);
}

// The headline tells the least of several payloads. A payload with `judge: false` does not count.
TEST(PayloadAnalysis, TheHeadlineIsTheLeastThatIsJudged) {
  const auto payload = [](const char* name, const char* factor, const char* more) {
    return fmt::format(
        "  - payload: {{name: {}, carriage: car, from: 140 m, to: 170 m, steps: 2, motion: in, limits: "
        "{{skyline: {{safety_factor: {}}}}}{}}}\n",
        name, factor, more);
  };
  const std::string most = payload("over", "1.5", ", judge: false"), some = payload("some", "3", ""),
                    least = payload("least", "3.5", "");
  const Result alone = run_text(skyline_deck(least));
  ASSERT_TRUE(alone.headline.starts_with("carries ")) << alone.headline;
  for (const auto& [first, last] : {std::pair(most, least), std::pair(least, most)}) {
    const Result r = run_text(skyline_deck(fmt::format("{}{}{}", first, some, last)));
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_EQ(r.headline, alone.headline);
    EXPECT_FALSE(has_check(r, "skyline.payload_T_max_over"));
  }
}

TEST(PayloadAnalysis, DirectionOfTheWayAndUnitsDoNotCount) {
  const Result a = run_text(payload_of("skyline: {tension: 70 kN}, clearance: 4 m", 130, 220, 9));
  const Result b = run_text(payload_of("clearance: 400 cm, skyline: {tension: 70000 N}", 220, 130, 9));
  ASSERT_EQ(a.status, Status::ok) << a.message << to_text(a.errors);
  const Table &there = table_of(a, "payload"), &back = table_of(b, "payload");
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(cell(there, i, "payload"), cell(back, 9 - i, "payload"), 1e-5 * cell(there, i, "payload"));
    EXPECT_EQ(text_cell(there, i, "governing"), text_cell(back, 9 - i, "governing"));
  }
}

TEST(PayloadAnalysis, ARuleIsALimitAndACheckWithItsTrust) {
  const Result r = run_text(payload_of("skyline: {rule: safety.skyline.ch}", 140, 180, 4));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto check = std::find_if(r.checks.begin(), r.checks.end(),
                                  [](const taut::Check& c) { return c.name == "skyline.payload_T_max"; });
  ASSERT_NE(check, r.checks.end());
  EXPECT_NEAR(check->limit, 280e3 / 3, 1e-6);
  EXPECT_NEAR(check->utilisation, 1, 1e-9);
  EXPECT_FALSE(check->trust.empty());
  EXPECT_NE(check->rule.find("SEILAPLAN"), std::string::npos);
  // a weaker limit beside the rule breaks it: exit code 4
  EXPECT_EQ(exit_code(run_text(payload_of("skyline: {safety_factor: 2.5, rule: safety.skyline.ch}", 140, 180, 4))), 4);
}

// Supports at the same places, on the ground and on bodies that are held.
TEST(PayloadAnalysis, ASupportOnABodyIsASupport) {
  const auto deck = [](const std::string& jacks, const std::string& bodies) {
    return R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 9 m], B: [330 m, 0 m, 141 m]}
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  supports: {)" +
           jacks + "}\n" + bodies + R"(
  carriages: {car: {mass: 350 kg, rides: sky, hold: clamped}}
  reevings:
    - {rope: sky, path: [{anchor: A}, {over: j1}, {through: car}, {over: j2}, {anchor: B}], install: {tension: 60 kN}}
  loads: [{at: car, mass: 1 t}]
analyses:
  - payload: {carriage: car, from: 10 m, to: 310 m, steps: 10, limits: {sky: {safety_factor: 3}}}
)";
  };
  const std::string round = ", diameter: 400 mm, friction: 0.1";
  const Result ground =
      run_text(deck("j1: {at: [100 m, 0 m, 60 m]" + round + "}, j2: {at: [220 m, 0 m, 108 m]" + round + "}", ""));
  const Result held = run_text(
      deck("j1: {body: m1, at: [10 m, 0 m, 50 m]" + round + "}, j2: {body: m2, at: [20 m, 0 m, 58 m]" + round + "}",
           "  bodies: {m1: {at: [90 m, 0 m, 10 m]}, m2: {at: [200 m, 0 m, 50 m]}}"));
  ASSERT_EQ(held.status, Status::ok) << held.message << to_text(held.errors);
  EXPECT_TRUE(held.missing.empty());
  EXPECT_NEAR(value_of(held, "payload_min") / value_of(ground, "payload_min"), 1, 1e-7);
  const Table &t = table_of(held, "payload"), &u = table_of(ground, "payload");
  ASSERT_EQ(t.rows.size(), u.rows.size());
  for (std::size_t i = 0; i < t.rows.size(); ++i) EXPECT_EQ(text_cell(t, i, "governing"), text_cell(u, i, "governing"));
  EXPECT_EQ(text_cell(t, 4, "governing"), "on 'j1'");
}

TEST(PayloadAnalysis, NothingCanBeCarriedIsAnAnswer) {
  const Result r = run_text(payload_of("clearance: 30 m", 140, 180, 2));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(value_of(r, "payload_min"), 0);
  ASSERT_FALSE(r.warnings.empty());
  EXPECT_NE(r.warnings.back().find("nothing can be carried from x = 140 m to 180 m (3 places)"), std::string::npos)
      << r.warnings.back();
  EXPECT_EQ(exit_code(r), 4) << "a line that carries nothing at some place fails";
}

// Two hills of 16 m, 15 m wide at half height, under a line that is clear of the ground between them.
TEST(PayloadAnalysis, WhatLiesBetweenTwoHillsCarries) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 20 m], b: [200 m, 0 m, 20 m]}
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, at: [100 m, 0 m, 10 m]}}
  reevings: [{rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 201.5 m}]
  terrain: {x: [-10 m, 20 m, 30 m, 40 m, 160 m, 170 m, 180 m, 210 m], z: [0 m, 0 m, 16 m, 0 m, 0 m, 16 m, 0 m, 0 m]}
analyses:
  - payload: {carriage: car, from: 10 m, to: 190 m, steps: 36, limits: {sky: {safety_factor: 3}, clearance: 2 m}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "payload");
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const double x = cell(t, i, "x");
    if (x > 45 && x < 155) {
      EXPECT_GT(cell(t, i, "payload"), 100) << x;
    }
  }
  const std::string& text = r.answers.front().text;
  EXPECT_EQ(text.find("nothing from x = 30 m to 170 m"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '('), 1) << text;
  EXPECT_EQ(text.find("nothing "), 0U) << text;
  EXPECT_NE(text.find("x = 30 m"), std::string::npos) << text;
  EXPECT_NE(text.find(", "), std::string::npos) << text;
  EXPECT_NE(text.find("x = 170 m"), std::string::npos) << text;
}

TEST(PayloadAnalysis, TellsEachMistakeAtItsPlace) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"skylin: {tension: 70 kN}", "limits.skylin: there is no rope and no drum 'skylin'; did you mean 'skyline'?"},
      {"skyline: {pull: 70 kN}", "limits.skyline.pull: is a limit of a drum; a rope has 'tension'"},
      {"winch: {tension: 70 kN}", "limits.winch.tension: is a limit of a rope; a drum has 'pull'"},
      {"skyline: {tension: 70}", "tension: a force needs its unit"},
      {"skyline: {rule: safety.skylin.ch}", "limits.skyline.rule: "},
      {"skyline: {rule: ratio.crane_drum.M1}", "is not a safety factor"},
      {"skyline: {rule: safety.mainline.ch_at}", "give a 'safety_factor' within it"},
      {"skyline: {}", "says no limit"},
      {"clearence: 3 m", "'clearence' is not a field of limits; did you mean 'clearance'?"},
      {"skyline: {tensoin: 3 kN}", "'tensoin' is not a field of skyline; did you mean 'tension'?"},
      {"", "say at least one limit"},
  };
  for (const auto& [limits, expected] : rows) expect_mistake(run_text(payload_of(limits, 140, 180, 2)), expected);
  const std::string good = payload_of("clearance: 3 m", 140, 180, 2);
  expect_mistake(run_text(good, {"analyses[0].payload.carriage=cart"}), "there is no carriage 'cart'");
  expect_mistake(run_text(good, {"machine.ropes.skyline={mass: 1 kg/m, stiffness: 20 MN}",
                                 "analyses[0].payload.limits={skyline: {safety_factor: 3}}"}),
                 "the breaking force of 'skyline' is not known");
}

/// A line with a bend of 25 m in plan over its second jack; `round`: what a jack is besides its place.
Result bent_in_plan(const std::string& round, const std::string& kind = "supports", int limit = 45) {
  return run_text(fmt::format(R"(taut: 1
machine:
  points: {{tail: [0 m, 0 m, 9 m], tower: [330 m, 0 m, 141 m]}}
  ropes: {{sky: {{mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 2790 kN}}}}
  {}:
    jack1: {{at: [100 m, 0 m, 60 m]{}}}
    jack2: {{at: [220 m, 25 m, 108 m]{}}}
  carriages: {{car: {{mass: 350 kg, rides: sky, hold: clamped}}}}
  reevings:
    - {{rope: sky, path: [{{anchor: tail}}, {{over: jack1}}, {{through: car}}, {{over: jack2}}, {{anchor: tower}}], length: 361 m}}
analyses: [payload: {{carriage: car, from: 150 m, to: 170 m, steps: 2, most: 30 t, limits: {{break_angle: {} deg}}}}]
)",
                              kind, round, round, limit));
}

TEST(PayloadAnalysis, ABreakAngleCountsTheBendInPlanOnARoundAsOnAPoint) {
  const Result point = bent_in_plan(""), round = bent_in_plan(", diameter: 20 mm, axis: [0, 1, 0]");
  ASSERT_EQ(point.status, Status::ok) << point.message << to_text(point.errors);
  ASSERT_EQ(round.status, Status::ok) << round.message << to_text(round.errors);
  const double carried = value_of(point, "payload_min");
  EXPECT_GT(carried, 0);
  EXPECT_NEAR(value_of(round, "payload_min"), carried, 0.01 * carried);
}

TEST(PayloadAnalysis, ASheaveThatBendsTheLineBeyondTheLimitIsToldAsUnsafe) {
  const Result r = bent_in_plan(", diameter: 400 mm", "sheaves", 25);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(std::any_of(r.unsafe.begin(), r.unsafe.end(), [](const std::string& one) {
    return one.find("'break_angle' does not count at sheave 'jack2'") != std::string::npos;
  }));
}

TEST(PayloadAnalysis, ARopeThatDoesNotCarryThePayloadIsNotJudged) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {tail: [0 m, 0 m, 9 m], tower: [300 m, 0 m, 120 m]}
  ropes:
    sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 279 kN}
    drop: {mass: 0.3 kg/m, stiffness: 4 MN, breaking_force: 40 kN}
  bodies: {hook: {mass: 50 kg, at: [150 m, 0 m, 50 m], free: [x, z]}}
  carriages: {car: {mass: 400 kg, rides: sky, hold: clamped, at: [150 m, 0 m, 60 m]}}
  reevings:
    - {rope: sky, path: [{anchor: tail}, {through: car}, {anchor: tower}], length: 322 m}
    - {rope: drop, path: [{anchor: car}, {anchor: hook}], length: 8 m}
analyses: [payload: {carriage: car, from: 140 m, to: 160 m, steps: 1, limits: {sky: {safety_factor: 3}, drop: {safety_factor: 3}}}]
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  ASSERT_FALSE(r.unmade.empty());
  EXPECT_NE(r.unmade[0].find("'drop' that hangs 'hook' there does not carry it"), std::string::npos) << r.unmade[0];
}

/// A model of a skyline on a bench: 1 m between two saddles.
std::string on_bench(const std::string& loads, const std::string& analyses, double safety_factor) {
  return fmt::format(R"(taut: 1
machine:
  points: {{a: [-0.5 m, 0 m, 0 m], b: [1.5 m, 0 m, 0 m]}}
  ropes: {{sky: {{mass: 0.02 kg/m, stiffness: 100 kN, breaking_force: 1.5 kN}}}}
  supports:
    s1: {{at: [0 m, 0 m, 0.8 m], diameter: 40 mm, friction: 0.1}}
    s2: {{at: [1 m, 0 m, 0.8 m], diameter: 40 mm, friction: 0.1}}
  carriages: {{car: {{mass: 0.2 kg, rides: sky, hold: clamped}}}}
  reevings:
    - {{rope: sky, path: [{{anchor: a}}, {{over: s1}}, {{through: car}}, {{over: s2}}, {{anchor: b}}], install: {{tension: 80 N}}}}
{}analyses: [{}]
checks: {{ropes: {{sky: {{safety_factor: {}}}}}}}
)",
                     loads, analyses, safety_factor);
}

TEST(PayloadAnalysis, AShortSpanIsLookedAtInItsMiddleToo) {
  const Result r = run_text(on_bench("",
                                     "payload: {carriage: car, from: 0.1 m, to: 0.9 m, steps: 16, limits: {sky: "
                                     "{safety_factor: 5}}}",
                                     1));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(table_of(r, "payload").rows.size(), 17U) << "none is nearer than a tenth of the span beside the saddles";
  const auto with = [](double mass, const std::string& analysis, double safety_factor) {
    return run_text(on_bench(fmt::format("  loads: [{{at: car, mass: {:.12g} kg}}]\n", mass), analysis, safety_factor));
  };
  const double payload = value_of(r, "payload_min");
  const std::string middle = "equilibrium: {carriage: car, x: 0.5 m}";
  EXPECT_TRUE(check_of(with(0.999 * payload, middle, 5), "sky.safety_factor").passes);
  EXPECT_FALSE(check_of(with(8.741, middle, 5), "sky.safety_factor").passes) << "what the ends of the way alone carry";
  const Result path = with(8.741, "load_path: {carriage: car, from: 0.1 m, to: 0.9 m, steps: 16}", 3.7);
  EXPECT_EQ(table_of(path, "load_path").rows.size(), 17U);
  EXPECT_NEAR(check_of(path, "sky.safety_factor").value, check_of(with(8.741, middle, 3.7), "sky.safety_factor").value,
              1e-6);
  // 0.065 m and 0.095 m from the saddles
  const Result near = with(1, "load_path: {carriage: car, from: 0.035 m, to: 0.965 m, steps: 31}", 1);
  EXPECT_TRUE(std::any_of(near.warnings.begin(), near.warnings.end(), [](const std::string& one) {
    return one.find("load path, at rest: 4 of 32 places are left out") == 0;
  }));
}

/// A rolling carriage with a mainline to x = 0 on a rope over a jack of friction 0.15, near the jack. `turned`: the
/// path of the rope written from its other end; nothing else differs.
std::string beside_jack(bool turned, double main_mass, const std::string& analyses) {
  return fmt::format(R"(taut: 1
machine:
  points:
    tower: [0 m, 0 m, 60 m]
    winch: [0 m, 0 m, 58 m]
    tail: [300 m, 0 m, 10 m]
  ropes:
    sky: {{mass: 2 kg/m, stiffness: 20 MN, breaking_force: 350 kN}}
    main: {{mass: {} kg/m, stiffness: 5 MN, breaking_force: 90 kN}}
  supports: {{j: {{at: [160 m, 0 m, 45 m], diameter: 300 mm, friction: 0.15}}}}
  carriages: {{car: {{mass: 400 kg, rides: sky, hold: rolling, mainline: main}}}}
  reevings:
    - {{rope: sky, path: {}}}
    - {{rope: main, path: [{{anchor: winch}}, {{anchor: car}}], length: 100 m}}
  loads: [{{name: logs, at: car, mass: 500 kg}}]
analyses:
  - {}
)",
                     main_mass,
                     turned ? "[{anchor: tail}, {through: car}, {over: j}, {anchor: tower}], install: {tension: 50 kN, "
                              "at: end}"
                            : "[{anchor: tower}, {over: j}, {through: car}, {anchor: tail}], install: {tension: 50 kN, "
                              "at: start}",
                     analyses);
}

/// Whether the carriage with so much on it rests at a place with its rope drawn over the jack in one direction: along a
/// path written from the tower, 1, or against it.
bool stands(double x, double mass, int sense, double main_mass) {
  const Result r =
      run_text(beside_jack(false, main_mass,
                           fmt::format("equilibrium: {{carriage: car, x: {:.17g} m, motion: {{sky: {}}}}}", x, sense)),
               {fmt::format("machine.loads[0].mass={:.17g} kg", mass)});
  return r.status == Status::ok;
}

/// Beside the jack the carriage runs to the winch of its mainline with more load, which no rope holds; how much that is
/// depends on which way the rope lies over the jack. Friction may act either way, so the lesser one counts.
TEST(PayloadAnalysis, FrictionOfEitherDirectionHasToHoldTheCarriage) {
  constexpr double hung = 500;  // kg
  for (const double main_mass : {0.0, 0.5}) {
    SCOPED_TRACE(main_mass);
    const std::string asked =
        "payload: {carriage: car, from: 139.25 m, to: 140.25 m, steps: 1, motion: in, limits: {sky: {safety_factor: "
        "3}}}";
    const Result one = run_text(beside_jack(false, main_mass, asked));
    const Result other = run_text(beside_jack(true, main_mass, asked));
    ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
    ASSERT_EQ(other.status, Status::ok) << other.message << to_text(other.errors);
    const Table &a = table_of(one, "payload"), &b = table_of(other, "payload");
    ASSERT_EQ(a.rows.size(), 2U);
    ASSERT_EQ(b.rows.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const double x = cell(a, i, "x"), mass = cell(a, i, "payload");
      EXPECT_NEAR(cell(b, i, "payload") / mass, 1, 1e-6) << x;
      EXPECT_EQ(text_cell(a, i, "governing"), "no equilibrium with more");
      if (i == 0) continue;  // one place is witness enough
      for (const int sense : {1, -1}) EXPECT_TRUE(stands(x, hung + 0.999 * mass, sense, main_mass)) << x;
      EXPECT_FALSE(stands(x, hung + 1.001 * mass, 1, main_mass)) << x;
      EXPECT_TRUE(stands(x, hung + 1.1 * mass, -1, main_mass)) << x;
    }
  }
}

/// A weightless mainline pulls to its winch alone. Without it the rope pushes the carriage along the track, by F: the
/// payload is where F turns towards the winch, in the direction of friction in which it does so first.
TEST(PayloadAnalysis, IsWhereTheMainlineWouldHaveToPush) {
  constexpr double x = 140.25;
  const Result r = run_text(beside_jack(
      true, 0,
      "payload: {carriage: car, from: 140.25 m, to: 140.25 m, motion: in, limits: {sky: {safety_factor: 3}}}"));
  const double mass = value_of(r, "payload_min");
  const auto push = [&](double load, int sense) {
    std::string deck = beside_jack(
        false, 0, fmt::format("equilibrium: {{carriage: car, x: {} m, held: true, motion: {{sky: {}}}}}", x, sense));
    const auto cut = [&](const std::string& text) {
      const auto at = deck.find(text);
      ASSERT_NE(at, std::string::npos) << text;
      deck.erase(at, text.size());
    };
    cut(", mainline: main");
    cut("    - {rope: main, path: [{anchor: winch}, {anchor: car}], length: 100 m}\n");
    const Result held = run_text(deck, {fmt::format("machine.loads[0].mass={:.17g} kg", load)});
    const Table& t = table_of(held, "sheaves");
    return cell(t, row_of(t, "name", "car"), "Fx");
  };
  const double T = value_of(r, "sky.T_max");
  EXPECT_NEAR(push(500 + mass, 1) / T, 0, 1e-8);
  EXPECT_GT(push(500 + mass, -1) / T, 1e-4);
}

/// From 139.8 m to 140.9 m 750 kg stand with the rope drawn one way over the jack, but not with the rope drawn the
/// other way, as the payloads show. The answer is one of the two. Either way these states are not judged, and the
/// warning names all of them.
TEST(PayloadAnalysis, AStateThatOneDirectionOfFrictionDoesNotHoldIsNotJudged) {
  const auto path = [](bool turned) {
    return run_text(beside_jack(turned, 0.5,
                                "load_path: {carriage: car, from: 139.5 m, to: 141.5 m, steps: 4, motion: in}\n"
                                "checks: {ropes: {sky: {safety_factor: 3}, main: {safety_factor: 3}}}"),
                    {"machine.loads[0].mass=750 kg"});
  };
  const Result one = path(false), other = path(true);
  ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
  ASSERT_EQ(other.status, Status::ok) << other.message << to_text(other.errors);
  for (const Result* r : {&one, &other}) {
    EXPECT_EQ(taut::verdict_of(*r)->kind, taut::VerdictKind::not_judged);
    EXPECT_EQ(taut::verdict_of(*r)->verdict_class, "unmade");
  }
  ASSERT_EQ(one.unmade.size(), 1U);
  EXPECT_EQ(one.unmade[0].find("load path, in, x = 140 m to x = 140.5 m (2 states): friction may act in a direction"),
            0U)
      << one.unmade[0];
  ASSERT_EQ(other.missing.size(), 1U);
  EXPECT_EQ(other.missing[0].missing, 4);
  EXPECT_EQ(other.missing[0].first, "x = 140 m");
}

/// Over a point that is a corner in plan too: the limit counts the bend that presses the rope on it, and the table
/// shows that. A nearly level rope with T on both sides that presses with F is bent by 2 asin(F/(2 T)) there.
TEST(PayloadAnalysis, ABendInPlanDoesNotKeepTheRopeInItsSaddle) {
  const auto run_over = [](const std::string& diameter, const std::string& limit) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 2 kg/m, stiffness: .inf, breaking_force: 600 kN, diameter: 24 mm}}
  points: {a: [-50 m, 8.75 m, 8 m], b: [200 m, 0 m, 15 m]}
  supports: {s1: {at: [0 m, 0 m, 10 m], friction: 0, diameter: )" +
                    diameter + R"(}}
  carriages: {c: {mass: 50 kg, rides: r}}
  reevings:
    - {name: r, rope: r, path: [{anchor: a}, {over: s1}, {through: c}, {anchor: b}], tension_at_end: 150 kN}
analyses:
  - payload: {carriage: c, from: 100 m, to: 150 m, steps: 2, held: true,
              limits: {least_break_angle: )" +
                    limit + R"(, r: {tension: 200 kN}}}
checks: {ropes: {r: {safety_factor: 3}}}
)");
  };
  for (const char* diameter : {"0 mm", "200 mm"}) {
    SCOPED_TRACE(diameter);
    const Result r = run_over(diameter, "3 deg");
    EXPECT_EQ(verdict_of(r)->kind, taut::VerdictKind::fails) << verdict_of(r)->reason << to_text(r.errors);
    const Table& t = table_of(r, "payload");
    ASSERT_EQ(t.rows.size(), 3U);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      EXPECT_EQ(text_cell(t, i, "governing"), "least break angle at 's1'");
      const double F = -cell(t, i, "r.s1.Fz"), T = cell(t, i, "r.s1.T_in");
      const double angle = cell(t, i, "r.s1.least_break_angle");
      EXPECT_NEAR(angle, 2 * std::asin(F / (2 * T)), 0.01 * angle);
      EXPECT_LT(angle, 3 * M_PI / 180);
      EXPECT_GT(cell(t, i, "r.s1.wrap"), 9 * M_PI / 180) << "the friction's angle, all of the bend";
    }
  }
}

}  // namespace payload_analysis_test
