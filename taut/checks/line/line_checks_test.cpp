#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "test/support/guyed_decks.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::line_checks_test {

using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::line_over_tree;
using taut_test::run_text;
using taut_test::value_of;

TEST(LineChecks, TailTreeAndAnchor) {
  const std::string checks =
      "  lines: {skyline: {tail_tree: tree, break_angles: true, end_masts: [tree], spar_rating: 350 kN}}\n";
  const Result r = run_text(line_over_tree(checks));
  const double angle = std::atan2(25, 30);
  EXPECT_NEAR(check_of(r, "skyline.tail_angle").value, angle, 0.01);
  EXPECT_NEAR(check_of(r, "skyline.tail_angle").limit, 50 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.anchor_off_line").value, 0, 1e-6);
  EXPECT_FALSE(check_of(r, "skyline.spar_rating").passes);
  EXPECT_NEAR(check_of(r, "skyline.tree.break_angle").limit, std::numbers::pi / 3, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.jack.break_angle").limit, std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.jack.break_angle").value, std::atan(10.0 / 150) + std::atan(5.0 / 150), 0.05);
  // 4.5 m off the line in 30 m: 8.53 degrees
  const Result off = run_text(line_over_tree(checks, "[330 m, 4.5 m, 10 m]"));
  EXPECT_NEAR(check_of(off, "skyline.anchor_off_line").value, std::atan2(4.5, 30), 0.003);
  EXPECT_FALSE(check_of(off, "skyline.anchor_off_line").passes);
  const Result other = run_text(line_over_tree(checks, "[330 m, -4.5 m, 10 m]"));
  EXPECT_NEAR(check_of(other, "skyline.anchor_off_line").value, check_of(off, "skyline.anchor_off_line").value, 1e-9);
}

TEST(LineChecks, LimiterTakesTheRopesPlace) {
  const Result r = run_text(line_over_tree("  lines: {skyline: {spar_rating: 350 kN, limiter: 200 kN}}\n"));
  EXPECT_TRUE(check_of(r, "skyline.limiter").passes);
  EXPECT_NEAR(check_of(r, "skyline.limiter").limit, 350e3, 1e-9);
  // what lets go below the tension of a state is no part of it
  const Check& lets_go = check_of(r, "skyline.limiter_tension");
  EXPECT_TRUE(lets_go.passes);
  EXPECT_NEAR(lets_go.value, value_of(r, "skyline.T_max"), 1e-6);
  EXPECT_FALSE(check_of(run_text(line_over_tree("  lines: {skyline: {spar_rating: 350 kN, limiter: 20 kN}}\n")),
                        "skyline.limiter_tension")
                   .passes);
}

// With one support both sides end at an anchor: the steeper one is the tail's, whichever end the path begins at.
TEST(LineChecks, OneSupportHasTheSteeperSideAsItsTail) {
  for (const std::string path :
       {"{anchor: stump}, {over: tail}, {anchor: head}", "{anchor: head}, {over: tail}, {anchor: stump}"}) {
    const Result r = run_text(R"(taut: 1
machine:
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 400 kN}}
  points: {head: [0 m, 0 m, 12 m], stump: [205 m, 0 m, 0 m]}
  supports: {tail: {at: [200 m, 0 m, 12 m], friction: 0.1}}
  reevings: [{rope: sky, path: [)" +
                              path + R"(], tension_at_start: 80 kN}]
checks: {lines: {sky: {tail_tree: tail}}}
)");
    EXPECT_NEAR(check_of(r, "sky.tail_angle").value, std::atan2(12, 5), 0.02) << path;
  }
}

// A sheave that does not move may stand low, but then the line is low there.
TEST(LineChecks, TheClearanceAtRoundsInTheLine) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 400 kN}}
  points: {a: [0 m, 0 m, 25 m], b: [300 m, 0 m, 25 m]}
  terrain: {x: [0 m, 300 m], z: [0 m, 0 m]}
  sheaves: {low: {at: [100 m, 0 m, 3 m], diameter: 800 mm, efficiency: 0.98}}
  supports: {top: {at: [200 m, 0 m, 25 m], diameter: 800 mm, friction: 0.1}}
  reevings: [{rope: sky, path: [{anchor: a}, {over: low}, {over: top}, {anchor: b}], tension_at_start: 100 kN}]
checks: {lines: {sky: {clearance: true}}}
)");
  EXPECT_NEAR(check_of(r, "sky.clearance").value, 2.61, 0.02);
  EXPECT_FALSE(check_of(r, "sky.clearance").passes);
}

// The empty line is the one that is put up: its bends are those of an installation.
TEST(LineChecks, TheEmptyLine) {
  const std::string checks = "checks: {lines: {skyline: {break_angles: true}}}\n";
  const std::string load = "  - load_path: {carriage: car, from: 130 m, to: 220 m, steps: 3, motion: in}\n";
  const std::string empty = "  - installation: {reeving: skyline, given: {tension: 60 kN, at: end}}\n";
  const Result loaded = run_text(taut_test::skyline_deck(load) + checks);
  const Result both = run_text(taut_test::skyline_deck(load + empty) + checks);
  const Result bare = run_text(R"(taut: 1
machine:
  points: {stump: [0 m, 0 m, 4 m], tower: [360 m, 0 m, 124 m]}
  ropes: {skyline: {mass: 1.6 kg/m, stiffness: 20 MN}}
  supports:
    jack1: {at: [110 m, 0 m, 33 m], diameter: 400 mm, friction: 0.1}
    jack2: {at: [240 m, 0 m, 78 m], friction: 0.1}
  reevings: [{rope: skyline, path: [{anchor: stump}, {over: jack1}, {over: jack2}, {anchor: tower}], tension_at_end: 60 kN}]
)" + checks);
  for (const char* jack : {"jack1", "jack2"}) {
    const std::string least = fmt::format("skyline.{}.least_break_angle", jack);
    EXPECT_NEAR(check_of(both, least).value, std::min(check_of(loaded, least).value, check_of(bare, least).value), 1e-6)
        << jack;
    EXPECT_NEAR(check_of(both, fmt::format("skyline.{}.break_angle", jack)).value,
                check_of(loaded, fmt::format("skyline.{}.break_angle", jack)).value, 1e-9);
  }
  EXPECT_NE(check_of(both, "skyline.jack2.least_break_angle").rule.find("installation of skyline"), std::string::npos);
}

// The sag of 100 m at 50 kN and 1 kg/m is 0.245 m: over a hill of 12 m the rope of 20 m is 7.755 m above the ground.
TEST(LineChecks, ClearanceOverTheGround) {
  const auto deck = [](const std::string& rest) {
    return std::string(R"(taut: 1
machine:
  ropes: {skyline: {mass: 1 kg/m, stiffness: 30 MN}}
  points: {left: [0 m, 0 m, 20 m], right: [100 m, 0 m, 20 m]}
  reevings: [{rope: skyline, path: [{anchor: left}, {anchor: right}], tension_at_start: 50 kN}]
  terrain: {x: [0 m, 50 m, 100 m], z: [0 m, 12 m, 0 m]}
checks: {lines: {skyline: )") +
           rest + "}}\n";
  };
  const Result r = run_text(deck("{clearance: true}"));
  EXPECT_NEAR(check_of(r, "skyline.clearance").value, 8 - 9.80665 * 1e4 / (8 * 50e3), 2e-3);
  EXPECT_EQ(check_of(r, "skyline.clearance").limit, 7);
  EXPECT_TRUE(check_of(r, "skyline.clearance").passes);
  EXPECT_FALSE(check_of(run_text(deck("{least_clearance: 8 m}")), "skyline.clearance").passes);
  expect_mistake(run_text(line_over_tree("  lines: {skyline: {clearance: true}}\n")), "'terrain'");
}

// A terrain along y: the hill is 50 m along it, at x = 0 of the ground.
TEST(LineChecks, APlaceIsNamedByItsDistanceAlongTheTerrain) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {skyline: {mass: 1 kg/m, stiffness: 30 MN, breaking_force: 300 kN}}
  points: {left: [0 m, 0 m, 20 m], right: [0 m, 100 m, 20 m]}
  reevings: [{rope: skyline, path: [{anchor: left}, {anchor: right}], tension_at_start: 50 kN}]
  terrain: {x: [0 m, 50 m, 100 m], z: [0 m, 12 m, 0 m], from: [0 m, 0 m], along: [0, 1]}
checks: {lines: {skyline: {clearance: true}}}
)");
  EXPECT_THAT(check_of(r, "skyline.clearance").where + check_of(r, "skyline.clearance").rule,
              testing::HasSubstr("at chainage 50 m"));
}

/// In motion the rope may come nearer to the ground than at rest: it is let out by 50 mm, and comes to rest again.
TEST(LineChecks, ClearanceInMotion) {
  const auto clearance = [](double length, const std::string& analyses) {
    const Result r = run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{skyline: {{mass: 1 kg/m, stiffness: 30 MN, breaking_force: 300 kN, damping_ratio: 0.3}}}}
  points: {{left: [0 m, 0 m, 20 m], right: [100 m, 0 m, 20 m]}}
  signals: {{out: {{ramp: {{to: 50 mm, start: 0.1 s, duration: 2 s, smooth: true}}}}}}
  reevings: [{{rope: skyline, path: [{{anchor: left}}, {{anchor: right}}], length: {} m}}]
  tensioners: [{{reeving: skyline, end: start, change: out}}]
  terrain: {{x: [-1 m, 50 m, 101 m], z: [0 m, 12 m, 0 m]}}
checks: {{lines: {{skyline: {{clearance: true}}}}, ropes: {{skyline: {{safety_factor: 3}}}}}}
analyses: [{}]
)",
                                          length, analyses));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return check_of(r, "skyline.clearance").value;
  };
  const std::string rest = "{equilibrium: {motion: at_rest}}";
  const auto motion = [](const char* branches) {
    return fmt::format("{{transient: {{duration: 3 s, output_step: 3 s, tolerance: 1e-4, branches: {}}}}}", branches);
  };
  const double before = clearance(99.9, rest), after = clearance(99.95, rest);
  EXPECT_GT(before, after + 0.2);
  EXPECT_NEAR(clearance(99.9, motion("catenary")), after, 0.01);
  EXPECT_NEAR(clearance(99.9, rest + ", " + motion("catenary")), after, 0.01);
  // a straight branch has less tension than with its sag, 11.4 for 12.0 kN: it may hang deeper than by its length
  const double straight = clearance(99.9, motion("straight"));
  EXPECT_LT(straight, after);
  EXPECT_NEAR(straight, after, 0.2);
}

// What the deck breaks hangs and whips as it likes afterwards.
TEST(LineChecks, ALineIsJudgedUpToItsBreak) {
  const auto line = [](const std::string& events) {
    return run_text(R"(taut: 1
machine:
  ropes: {sk: {mass: 1.6 kg/m, stiffness: 25 MN, breaking_force: 330 kN, damping_ratio: 0.3}}
  points: {yard: [0 m, 0 m, 1 m], tail: [160 m, 0 m, 0 m]}
  supports:
    head: {at: [10 m, 0 m, 14 m], diameter: 300 mm, friction: 0.1}
    jack: {at: [90 m, 0 m, 12 m], diameter: 300 mm, friction: 0.1}
  carriages: {car: {mass: 300 kg, rides: sk, hold: rolling, at: [50 m, 0 m, 8 m]}}
  loads: [{at: car, force: [0 kN, 0 kN, -10 kN]}]
  terrain: {x: [0 m, 160 m], z: [0 m, 0 m]}
  reevings: [{rope: sk, path: [{anchor: yard}, {over: head}, {through: car}, {over: jack}, {anchor: tail}], length: 169.5 m}]
)" + events + R"(analyses: [{transient: {duration: 4 s, output_step: 0.01 s, tolerance: 1e-4}}]
checks: {lines: {sk: {break_angles: true, least_clearance: 1 m}}, ropes: {sk: {dynamic_safety_factor: 2}}}
)");
  };
  const Result whole = line(""), broken = line("  events: [{at: 1 s, break: \"sk[4]\"}]\n");
  for (const char* name : {"sk.clearance", "sk.jack.least_break_angle", "sk.jack.break_angle", "sk.head.break_angle"}) {
    EXPECT_NEAR(check_of(broken, name).value, check_of(whole, name).value, 1e-3 + 0.01 * check_of(whole, name).value)
        << name;
  }
}

TEST(LineChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(line_over_tree("  lines: {skyline: {tail_tree: jock}}\n")), "did you mean 'jack'");
  expect_mistake(run_text(line_over_tree("  lines: {skylin: {}}\n")), "did you mean 'skyline'");
  expect_mistake(run_text(line_over_tree("  lines: {skyline: {limiter: 200 kN}}\n")), "needs 'spar_rating'");
  for (const char* without : {"hold_down: true", "end_masts: [jack]"}) {
    expect_mistake(run_text(line_over_tree(fmt::format("  lines: {{skyline: {{{}}}}}\n", without))),
                   "need 'break_angles: true'");
  }
}

// The supports of a line are what no carriage is, whatever their names.
TEST(LineChecks, ASupportMayBeNamedLikeACarriage) {
  for (const char* name : {"jack1", "car_jack"}) {
    std::string deck = taut_test::skyline_deck("  - equilibrium: {motion: at_rest}\n") +
                       "checks: {lines: {skyline: {break_angles: true}}}\n";
    for (std::size_t at = deck.find("jack1"); at != std::string::npos; at = deck.find("jack1", at + 8))
      deck.replace(at, 5, name);
    const Result r = run_text(deck);
    EXPECT_TRUE(taut_test::has_check(r, fmt::format("skyline.{}.break_angle", name))) << r.message << to_text(r.errors);
  }
}

// A rope that a saddle holds down bends by less than nothing, also where a strap holds it.
TEST(LineChecks, AnUpliftFailsTheLeastBend) {
  for (const std::string jack : {"diameter: 400 mm", "diameter: 400 mm, uplift: hold", "diameter: 0 mm, uplift: hold",
                                 "law: sheave, diameter: 400 mm"}) {
    const Result r = run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 0.5 kg/m, stiffness: 2 MN}}
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  supports: {jack: {at: [50 m, 0 m, 16 m], )" +
                              jack + R"(}}
  reevings: [{rope: line, path: [{anchor: a}, {over: jack}, {anchor: b}], tension_at_start: 20 kN}]
checks: {lines: {line: {break_angles: true, hold_down: true}}}
)");
    const Check& c = check_of(r, "line.jack.least_break_angle");
    EXPECT_FALSE(c.passes) << jack;
    EXPECT_NEAR(c.value, -2 * std::atan(4.0 / 50), 0.025) << jack << ": more or less by the radius";
  }
}

// A sheave that the deck puts above its rope presses it down on purpose.
TEST(LineChecks, ASheaveOnAGivenSideMayPressTheRopeDown) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 0.5 kg/m, stiffness: 2 MN}}
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  sheaves: {low: {at: [50 m, 0 m, 16 m], diameter: 400 mm}}
  reevings: [{rope: line, path: [{anchor: a}, {over: low, side: left}, {anchor: b}], tension_at_start: 20 kN}]
checks: {lines: {line: {break_angles: true}}}
)");
  EXPECT_NEAR(check_of(r, "line.low.least_break_angle").value, 2 * std::atan(4.0 / 50), 0.025);
}

/// A jack 36 m beside the line: about the level axis of its round the rope bends by 4.6 deg, in space by 40.
TEST(LineChecks, ABendInPlanCountsToo) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 400 kN, diameter: 20 mm}}
  points: {a: [0 m, 0 m, 10 m], b: [200 m, 0 m, 10 m]}
  supports: {jack: {at: [100 m, 36 m, 12.2 m], diameter: 600 mm, friction: 0.1}}
  reevings: [{rope: sky, path: [{anchor: a}, {over: jack}, {anchor: b}], install: {tension: 60 kN}}]
checks:
  ropes: {sky: {safety_factor: 3}}
  lines: {sky: {break_angles: true}}
)");
  const Check& bend = check_of(r, "sky.jack.break_angle");
  EXPECT_NEAR(bend.value, 2 * std::atan2(std::hypot(36.0, 2.2), 100), 2 * std::numbers::pi / 180);
  EXPECT_FALSE(bend.passes);
}

/// A rope without weight from a over a support to b; `support`: its place and diameter.
Result over_support(const std::string& a, const std::string& b, const std::string& support) {
  return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: .inf, breaking_force: 600 kN, diameter: 24 mm}}}}
  points: {{a: {}, b: {}}}
  supports: {{s1: {{{}, friction: 0}}}}
  reevings: [{{name: r, rope: r, path: [{{anchor: a}}, {{over: s1}}, {{anchor: b}}], tension_at_start: 100 kN}}]
analyses: [{{equilibrium: {{}}}}]
checks:
  ropes: {{r: {{safety_factor: 3}}}}
  lines: {{r: {{break_angles: true}}}}
)",
                              a, b, support));
}

/// A bend in plan does not hold the rope on a point. By hand, without mass: 14.04 deg in plan, and upright only
/// atan(0.2/50) + atan(0.2/sqrt(60^2 + 15^2)) = 0.2292 + 0.1853 deg. A thin round there bends it as little about its
/// level axis, which lies across the line in plan.
TEST(LineChecks, ABendInPlanDoesNotHoldTheRopeOnASupport) {
  const auto run_over = [](const std::string& diameter) {
    return over_support("[-50 m, 0 m, 9.8 m]", "[60 m, 15 m, 9.8 m]", "at: [0 m, 0 m, 10 m], diameter: " + diameter);
  };
  constexpr double degree = std::numbers::pi / 180;
  const double upright = std::atan(0.2 / 50) + std::atan(0.2 / std::hypot(60, 15));
  const Result point = run_over("0 mm");
  EXPECT_NEAR(check_of(point, "r.s1.least_break_angle").value, upright, 1e-6 * upright);
  EXPECT_FALSE(check_of(point, "r.s1.least_break_angle").passes);
  EXPECT_NEAR(check_of(point, "r.s1.break_angle").value, 14.04 * degree, 0.01 * degree) << "all of it may be too much";
  EXPECT_NEAR(check_of(run_over("1 mm"), "r.s1.least_break_angle").value, upright, 0.02 * degree);
}

/// On a slope, in one upright plane, it is all of the bend: atan(40/50) - atan(30/50).
TEST(LineChecks, TheLeastBendOnASlopeIsAllOfIt) {
  const Result r = over_support("[-30 m, -40 m, -40 m]", "[30 m, 40 m, 30 m]", "at: [0 m, 0 m, 0 m], diameter: 0 mm");
  EXPECT_NEAR(check_of(r, "r.s1.least_break_angle").value, std::atan(0.8) - std::atan(0.6), 1e-9);
  EXPECT_NEAR(check_of(r, "r.s1.break_angle").value, std::atan(0.8) - std::atan(0.6), 1e-9);
}

/// The rule of the least bend is one for the empty line, which the loaded one does not show.
TEST(LineChecks, TheLeastBendNeedsTheEmptyLine) {
  const std::string deck = R"(taut: 1
machine:
  temperature: 15 degC
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  points: {stump: [0 m, 0 m, 4 m], tower: [360 m, 0 m, 124 m]}
  supports:
    jack1: {at: [110 m, 0 m, 33 m], diameter: 600 mm, friction: 0.1}
    jack2: {at: [240 m, 0 m, 78 m], diameter: 600 mm, friction: 0.1}
  carriages: {car: {mass: 350 kg, rides: sky}}
  reevings: [{rope: sky, path: [{anchor: stump}, {over: jack1}, {through: car}, {over: jack2}, {anchor: tower}], length: 379.0721 m}]
  loads: [{at: car, mass: 1.5 t}]
analyses: [{load_path: {carriage: car, from: 130 m, to: 150 m, steps: 2, held: true}}]
checks:
  ropes: {sky: {safety_factor: 3}}
  lines: {sky: {break_angles: true, hold_down: true}}
)";
  const auto told = testing::Contains(testing::HasSubstr("its least bends are not checked"));
  EXPECT_THAT(run_text(deck).unmade, told);
  std::string put_up = deck;
  put_up.replace(put_up.find("length: 379.0721 m"), 18, "install: {tension: 40 kN, at: start}");
  const Result both = run_text(put_up);
  EXPECT_FALSE(check_of(both, "sky.jack1.least_break_angle").passes);
  EXPECT_THAT(both.unmade, testing::Not(told));
}

/// A line with mass that is let out by 12 m: straight it has no sag where it is slack.
TEST(LineChecks, AClearanceOfALineThatAMotionLetsGoSlackIsNotJudged) {
  const auto line = [](const std::string& more) {
    return run_text(R"(taut: 1
machine:
  signals: {out: {ramp: {to: 12 m, start: 0.1 s, duration: 3 s, smooth: true}}}
  terrain: {x: [-10 m, 110 m], z: [0 m, 0 m]}
  points: {head: [0 m, 0 m, 20 m], tail: [100 m, 0 m, 20 m]}
  ropes: {main: {mass: 1 kg/m, stiffness: 9.8 MN, breaking_force: 150 kN, damping_ratio: 0.05, diameter: 14 mm}}
  bodies: {block: {mass: 50 kg, at: [99 m, 0 m, 20 m], free: [x, z]}}
  reevings:
    - {name: main, rope: main, path: [{anchor: head}, {anchor: tail}], length: 99.6 m, may_slack: true)" +
                    more + R"(}
    - {name: tie, rope: main, path: [{anchor: block}, {anchor: tail}], length: 1 m, may_slack: true}
  tensioners: [{reeving: main, end: start, change: out}]
analyses: [{transient: {duration: 4 s, output_step: 50 ms}}]
checks: {exempt: [tie], ropes: {main: {safety_factor: 3}}, lines: {main: {clearance: true}}}
)");
  };
  EXPECT_THAT(line("").unmade, testing::Contains(testing::HasSubstr("its clearance is not judged where it is slack")));
  const Result hangs = line(", segments: 10");
  ASSERT_EQ(hangs.status, Status::ok) << hangs.message << to_text(hangs.errors);
  EXPECT_THAT(hangs.unmade, testing::Not(testing::Contains(testing::HasSubstr("where it is slack"))));
  EXPECT_FALSE(check_of(hangs, "main.clearance").passes);
}

// A counterweight keeps H = 5 kN and lets out what the rope hangs through: 10 N/m sag by 2 kN 200 m/(8 5 kN) = 10 m of
// 12 m. The rope that the straight branch has would hang 6.7 m deep, and passed 5 m.
TEST(LineChecks, AMotionsRopeThatIsLetOutHangsInItsTension) {
  const auto deck = [](const std::string& analysis) {
    return run_text(R"(taut: 1
machine:
  points: {far: [200 m, 0 m, 12 m]}
  terrain: {x: [-20 m, 210 m], z: [0 m, 0 m]}
  ropes: {r: {mass: 1.0197162 kg/m, stiffness: 20 MN, breaking_force: 500 kN, damping_ratio: 0.1}}
  bodies: {cw: {mass: 509.858 kg, at: [-0.2 m, 0 m, 5 m], free: [z]}}
  sheaves: {head: {at: [0 m, 0 m, 12 m], diameter: 400 mm}}
  reevings: [{rope: r, path: [{anchor: cw}, {over: head}, {anchor: far}], length: 207 m}]
checks: {ropes: {r: {safety_factor: 3}}, lines: {r: {least_clearance: 5 m}}}
analyses: [)" + analysis +
                    "]\n");
  };
  const Result moves = deck("{transient: {duration: 0.2 s, tolerance: 1e-4}}");
  const Result rests = deck("{equilibrium: {}}");
  EXPECT_NEAR(check_of(rests, "r.clearance").value, 2, 0.1);
  EXPECT_THAT(moves.unmade, testing::ElementsAre(testing::HasSubstr("and 2.014 m in its tension")));
  const Result hangs = deck("{transient: {duration: 0.2 s, tolerance: 1e-4, branches: catenary}}");
  EXPECT_NEAR(check_of(hangs, "r.clearance").value, check_of(rests, "r.clearance").value, 0.1);
}

/// 200 m of 1.6 kg/m. By its length a rope that no weight draws after hangs as it was put up. A drum that begins to
/// pull, and a weight on a track at its end, draw it to their pull: its sag is w l^2/(8 T).
TEST(LineChecks, WhatDrawsARopeInAMotionSaysHowDeepItHangs) {
  const auto line = [](const std::string& machine, const std::string& least, const std::string& duration) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm, damping_ratio: 0.3}}
  terrain: {x: [-10 m, 210 m], z: [0 m, 0 m]}
)" + machine + R"(
checks: {ropes: {r: {safety_factor: 3}}, lines: {r: {least_clearance: )" +
                    least + "}}}\nanalyses: [{transient: {duration: " + duration + "}}]\n");
  };
  const std::string drum = R"(
  signals: {none: {constant: 0 m/s}}
  points: {a: [0 m, 0 m, 10 m]}
  drums: {w: {at: [200 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 20 kg m^2, drive: {speed: none}}}
  reevings: [{rope: r, path: [{anchor: a}, {drum: w}], tension_at_start: 60 kN}]
  events: [{at: 1 s, drive: w, pull: 20 kN}])";
  // 15.7 200^2/(8 20 000) = 3.92 m below the rims
  EXPECT_THAT(line(drum, "6.5 m", "2 s").unmade, testing::ElementsAre(testing::HasSubstr("and 6.17")));
  EXPECT_NEAR(check_of(line(drum, "6 m", "2 s"), "r.clearance").value, 6.18, 0.02);
  const std::string car = R"(
  bodies: {car: {mass: 2 t, at: [0 m, 0 m, 10 m], free: [x]}}
  drums: {w: {at: [200 m, 0 m, 10 m], core_diameter: 400 mm}}
  reevings: [{rope: r, path: [{anchor: car}, {drum: w}], length: 199.9 m}]
  loads: [{name: slope, at: car, force: [-5 kN, 0 kN, 0 kN]}])";
  EXPECT_THAT(line(car, "3 m", "2 s").unmade, testing::ElementsAre(testing::HasSubstr("in its tension")));
}

/// A small force along it parts a rope in two branches, which do not hang by themselves: 60 kN let 200 m sag by 1.31 m.
TEST(LineChecks, ARopeWithAForceAlongItHangsFromRoundToRound) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 10 m], b: [200 m, 0 m, 10 m]}
  ropes: {r: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], tension_at_start: 60 kN}]
  rope_loads: [{name: cut, rope: r, between: [a, b], tangential: 0.1 kN, position: 0.5}]
  terrain: {x: [0 m, 200 m], z: [0 m, 0 m]}
checks: {ropes: {r: {safety_factor: 3}}, lines: {r: {least_clearance: 9.2 m}}}
analyses: [{transient: {duration: 0.5 s}}]
)");
  EXPECT_NEAR(check_of(r, "r.clearance").value, 10 - 1.31, 0.06);
  EXPECT_FALSE(check_of(r, "r.clearance").passes);
}

/// The carriage stands between the tail tree that is named and the anchor.
TEST(LineChecks, ATailTreeThatIsNoneIsNotJudged) {
  const std::string deck = R"(taut: 1
machine:
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  points: {stump: [-8 m, 4 m, 1 m], far: [200 m, 0 m, 25 m]}
  supports: {tail: {at: [0 m, 0 m, 14 m], diameter: 700 mm, friction: 0.1}, jack: {at: [120 m, 0 m, 14 m], diameter: 700 mm, friction: 0.1}}
  carriages: {car: {mass: 300 kg, rides: sky}}
  reevings: [{rope: sky, path: [{anchor: stump}, {over: tail}, {over: jack}, {through: car}, {anchor: far}], length: 217 m}]
  loads: [{at: car, mass: 0.8 t}]
analyses: [{equilibrium: {carriage: car, x: 160 m, held: true}}]
checks: {ropes: {sky: {safety_factor: 2.5}}, lines: {sky: {tail_tree: jack, tail_angle: 5 deg}}}
)";
  const auto told = testing::Contains(testing::HasSubstr("the angles of its tail tree are not checked"));
  EXPECT_THAT(run_text(deck).unmade, told);
  const Result tail = run_text(deck, {"checks.lines.sky.tail_tree=tail"});
  EXPECT_FALSE(check_of(tail, "sky.tail_angle").passes);
  EXPECT_THAT(tail.unmade, testing::Not(told));
}

}  // namespace taut::checks::line_checks_test
