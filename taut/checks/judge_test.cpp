#include "taut/checks/judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// What makes a state unsafe, or fails without being asked.
namespace taut::checks::judge_test {

using taut_test::check_of;
using taut_test::has_check;
using taut_test::run_text;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// A carriage of 2 t on a line over flat ground, held up by a strap that is cut at 1 s.
std::string strap_is_cut(const std::string& ground) {
  return R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 10 m], tail: [200 m, 0 m, 10 m], hang: [100 m, 0 m, 20 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 1000 kN, damping_ratio: 0.05}
    strap: {mass: 0.1 kg/m, stiffness: 1 MN, breaking_force: 50 kN, damping_ratio: 0.05}
  carriages: {car: {mass: 2 t, rides: skyline, hold: clamped, length_before: 100.5 m, at: [100 m, 0 m, 5 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 201 m}
    - {rope: strap, path: [{anchor: hang}, {anchor: car}], length: 11.9 m}
  terrain: {x: [0 m, 200 m], z: [)" +
         ground + ", " + ground + R"(]}
  events: [{at: 1 s, break: strap}]
checks: {ropes: {skyline: {dynamic_safety_factor: 2}, strap: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 4 s, output_step: 50 ms, tolerance: 1e-3}}]
)";
}

// It falls to 10.2 m below the ground of 2 m: to -8.2 m.
TEST(Judge, AfterABreakTheOtherRopesAreJudgedOn) {
  const Result into = run_text(strap_is_cut("2 m"));
  EXPECT_EQ(verdict_of(into)->kind, VerdictKind::fails) << verdict_of(into)->reason;
  EXPECT_THAT(verdict_of(into)->reason, HasSubstr("The deck breaks strap at 1 s; car.ground"));
  EXPECT_LT(check_of(into, "car.ground").value, -10);
  const Result above = run_text(strap_is_cut("-9 m"));
  EXPECT_EQ(verdict_of(above)->kind, VerdictKind::passes) << verdict_of(above)->reason;
  EXPECT_FALSE(has_check(above, "strap.ground"));
}

// The carriage of a rope that is cut itself falls: its height says nothing. Another one in that place counts.
TEST(Judge, WhatTheDeckBreaksIsJudgedUpToItsBreak) {
  std::string deck = strap_is_cut("-5 m");
  deck.replace(deck.find("break: strap"), 12, "break: skyline");
  deck.replace(deck.find("length: 11.9 m"), 14, "length: 40 m, may_slack: true");
  deck.replace(deck.find("  events:"), 9, "  observe: [car.z]\n  events:");
  const Result r = run_text(deck);
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  ASSERT_NE(r.find_value("car.z_min"), nullptr) << r.message;
  EXPECT_LT(r.find_value("car.z_min")->value, -6);
  EXPECT_FALSE(has_check(r, "car.ground"));
  EXPECT_FALSE(has_check(r, "skyline.ground"));
}

// What a motion has broken is whole in the states at rest behind it.
TEST(Judge, ABreakIsOfItsMotionAlone) {
  const auto beside = [](const std::string& analyses) {
    return run_text(R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 10 m], tail: [200 m, 0 m, 40 m], far: [230 m, 0 m, 44 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 900 kN, damping_ratio: 0.05}
    main: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.05}
  carriages: {car: {mass: 800 kg, rides: skyline, mainline: main, at: [190 m, 0 m, 36 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 210 m}
    - {rope: main, path: [{anchor: far}, {anchor: car}], length: 40 m}
  events: [{at: 0.1 s, break: skyline}]
checks: {ropes: {skyline: {safety_factor: 2}, main: {safety_factor: 2}}}
analyses:
)" + analyses + "  - sweep: {parameter: 'machine.reevings[1].length', from: 38 m, to: 25 m, steps: 4}\n");
  };
  const std::string motion = "  - transient: {duration: 0.3 s, output_step: 0.1 s, tolerance: 1e-2}\n";
  for (const std::string& analyses : {std::string(), motion}) {
    const Result r = beside(analyses);
    EXPECT_THAT(r.unsafe, Contains(HasSubstr("sweep"))) << r.message << to_text(r.errors);
    EXPECT_THAT(r.unsafe, Contains(HasSubstr("carriage car stands at x = 20")));
  }
}

TEST(Judge, ACarriageBesideItsSpanIsToldInMotion) {
  const auto hauled = [](const std::string& speed) {
    return run_text(R"(taut: 1
machine:
  signals: {in: {ramp: {to: )" +
                    speed + R"(, start: 0 s, duration: 1 s, smooth: true}}}
  points: {head: [0 m, 0 m, 10 m], tail: [200 m, 0 m, 40 m]}
  ropes:
    skyline: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 900 kN, damping_ratio: 0.05}
    main: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.05}
  drums: {winch: {at: [230 m, 0 m, 44 m], core_diameter: 400 mm, drive: {speed: in}}}
  carriages: {car: {mass: 800 kg, rides: skyline, mainline: main, at: [190 m, 0 m, 36 m]}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 210 m}
    - {rope: main, path: [{drum: winch}, {anchor: car}], length: 40 m, may_slack: true}
checks: {ropes: {skyline: {dynamic_safety_factor: 2}, main: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 6 s, output_step: 0.5 s, tolerance: 1e-3}}]
)");
  };
  EXPECT_THAT(hauled("0.5 m/s").unsafe, IsEmpty());
  EXPECT_THAT(hauled("3 m/s").unsafe, Contains(HasSubstr("carriage car stands at x = 200.")));
}

/// A rope over a saddle, whose far end rises so that the rope comes off the saddle.
std::string raised(const std::string& uplift, const std::string& rise) {
  return R"(taut: 1
machine:
  signals: {up: {ramp: {to: )" +
         rise + R"(, start: 0.5 s, duration: 3 s, smooth: true}}}
  points: {head: [0 m, 0 m, 20 m], top: {body: lift, at: [0 m, 0 m, 0 m]}}
  ropes: {line: {mass: 0.5 kg/m, stiffness: 2 MN, breaking_force: 330 kN, damping_ratio: 0.05}}
  bodies: {lift: {at: [100 m, 0 m, 17 m], motion: {z: up}}}
  supports: {jack: {at: [50 m, 0 m, 21 m], diameter: 400 mm, friction: 0.1)" +
         uplift + R"(}}
  reevings: [{rope: line, path: [{anchor: head}, {over: jack}, {anchor: top}], length: 99.9 m}]
checks: {ropes: {line: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 5 s, output_step: 0.5 s, tolerance: 1e-3}}]
)";
}

TEST(Judge, ARopeThatLeavesItsSaddleInMotionIsUnsafe) {
  EXPECT_THAT(run_text(raised("", "3 m")).unsafe, IsEmpty());
  EXPECT_THAT(run_text(raised("", "8 m")).unsafe, ElementsAre(HasSubstr("the rope pulls 'jack' upwards")));
  EXPECT_THAT(run_text(raised(", uplift: lift", "8 m")).unsafe,
              ElementsAre(HasSubstr("the rope pulls 'jack' upwards")));
}

// The pull grows until the end, at 5 s.
TEST(Judge, TheWorstUpliftOfAMotionIsTold) {
  const Result once = run_text(raised("", "8 m")), longer = run_text(raised("", "10 m"));
  const auto pull = [](const Result& r) {
    const std::string& text = r.unsafe.at(0);
    return std::stod(text.substr(text.find("upwards with ") + 13));
  };
  EXPECT_THAT(once.unsafe, ElementsAre(Not(HasSubstr("t = 2"))));
  EXPECT_GT(pull(longer), 1.5 * pull(once));
}

// A winch lowers 2 t onto a second rope, which hangs loose at rest: it needs a limit as one that is tight.
TEST(Judge, ARopeThatIsSlackAtRestNeedsALimitWhereAMotionLoadsIt) {
  const auto lowered = [](const std::string& to, const std::string& limit) {
    return run_text(R"(taut: 1
machine:
  signals: {lowering: {ramp: {to: -0.5 m/s, start: 0.5 s, duration: 0.5 s, smooth: true}}}
  points: {above: [0 m, 0 m, 10 m]}
  ropes:
    hoist: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 200 kN, damping_ratio: 0.05}
    catch: {mass: 0 kg/m, stiffness: 5 MN, damping_ratio: 0.05, breaking_force: 200 kN}
  bodies: {load: {mass: 2 t, at: [0 m, 0 m, 4 m], free: [x, z]}}
  drums: {winch: {at: [0.1 m, 0 m, 10 m], core_diameter: 200 mm, drive: {speed: lowering}}}
  reevings:
    - {rope: hoist, path: [{drum: winch}, {anchor: load}], length: 6 m, may_slack: true}
    - {rope: catch, path: [{anchor: above}, {anchor: load}], length: 7 m, may_slack: true}
analyses: [{equilibrium: {}}, {transient: {output_step: 20 ms, tolerance: 1e-4, duration: )" +
                    to + "}}]\nchecks: {ropes: {hoist: {safety_factor: 4, dynamic_safety_factor: 3}" + limit + "}}\n");
  };
  const Result loaded = lowered("6 s", "");
  ASSERT_EQ(loaded.status, Status::ok) << loaded.message << to_text(loaded.errors);
  EXPECT_EQ(verdict_of(loaded)->kind, VerdictKind::not_judged) << verdict_of(loaded)->reason;
  EXPECT_THAT(loaded.unjudged, ElementsAre("catch"));
  EXPECT_THAT(lowered("6 s", ", catch: {safety_factor: 4, dynamic_safety_factor: 3}").unjudged, IsEmpty());
  EXPECT_THAT(lowered("2 s", "").unjudged, IsEmpty()) << "slack until 2.75 s";
}

/// A crane of 2 t on two feet that are 2 m apart, with a load at its side.
std::string crane(const std::string& load) {
  return R"(taut: 1
machine:
  signals: {up: {ramp: {to: 0.2 m/s, duration: 0.5 s, smooth: true}}}
  points: {left: {body: crane, at: [-1 m, 0 m, -1 m]},
    right: {body: crane, at: [1 m, 0 m, -1 m]}}
  ropes: {line: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 200 kN, damping_ratio: 0.1}}
  bodies:
    crane: {mass: 2 t, inertia: 2000 kg m^2, at: [0 m, 0 m, 1 m], free: [x, z, ry]}
    hook: {mass: )" +
         load + R"(, at: [2.2 m, 0 m, 1 m], free: [x, z]}
  drums: {winch: {body: crane, at: [2 m, 0 m, 3 m], core_diameter: 400 mm, drive: {speed: up}}}
  faces: {ground: {from: [-20 m, 0 m, 0 m], to: [20 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts:
    - {point: left, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.5}
    - {point: right, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.5}
  reevings: [{rope: line, path: [{drum: winch, side: right}, {anchor: hook}], length: 3 m, may_slack: true}]
checks: {ropes: {line: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 2.5 s, start: settled, tolerance: 1e-3}}]
)";
}

// It tips where load * (2.2 - 1) m > 2 t * 1 m: from 1.67 t on.
TEST(Judge, ACraneThatTipsInMotionIsUnsafe) {
  const Result stands = run_text(crane("1 t"));
  EXPECT_THAT(stands.unsafe, IsEmpty()) << stands.message << to_text(stands.errors);
  const Result tips = run_text(crane("2.5 t"));
  EXPECT_THAT(tips.unsafe, Contains(HasSubstr("'crane' lifts 'left' off the ground"))) << tips.message;
  EXPECT_THAT(tips.unsafe, Contains(HasSubstr("'crane' has tipped over")));
}

/// A mast on a hinge, held by one guy; a gust towards it.
Result hinged_mast(const std::string& gust, const std::string& more = "") {
  return run_text(R"(taut: 1
machine:
  signals: {gust: {sequence: [{at: 1 s, to: )" +
                  gust + R"(, over: 0.5 s, smooth: true}, {at: 4 s, to: 0 kN, over: 0.5 s, smooth: true}]}}
  points: {g: [10 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 400 kN, damping_ratio: 0.1}}
  bodies: {mast: {mass: 500 kg, at: [0 m, 0 m, 0 m], turned: {ry: -2 deg}, centre: [0 m, 0 m, 5 m], inertia: 4000 kg m^2, free: [ry]}}
  markers: {head: {body: mast, at: [0 m, 0 m, 10 m]}}
  reevings: [{name: guy, rope: r, path: [{anchor: g}, {anchor: head}], length: 14.38 m, may_slack: true}]
  loads: [{at: head, force: [1 N, 0 kN, 0 kN], signal: gust}]
checks: {ropes: {r: {safety_factor: 3, dynamic_safety_factor: 2}}}
analyses: [{transient: {duration: 8 s, output_step: 20 ms, tolerance: 1e-3)" +
                  more + "}}]\n");
}

// Its weight leans it back into its guy: 4.9 kN times 5 m times sin 2 deg are 0.86 kN m, 86 N at its head.
TEST(Judge, AMastThatFallsInAMotionIsUnsafe) {
  const Result stands = hinged_mast("50 N");
  ASSERT_EQ(stands.status, Status::ok) << stands.message << to_text(stands.errors);
  EXPECT_THAT(stands.unsafe, IsEmpty());
  const Result falls = hinged_mast("300 N");
  ASSERT_EQ(falls.status, Status::ok) << falls.message << to_text(falls.errors);
  EXPECT_THAT(falls.unsafe, Contains(HasSubstr("'mast' has tipped over")));
  EXPECT_NE(verdict_of(falls)->kind, VerdictKind::passes) << verdict_of(falls)->reason;
}

// A load hangs at a lug 3 m above its origin; its centre of mass is 1 m below that.
TEST(Judge, ABodyBelowTheGroundIsAWarning) {
  const auto hung = [](const std::string& ground, const std::string& free) {
    return run_text(R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 10 m], lug: {body: load, at: [0 m, 0 m, 3 m]}}
  ropes: {drop: {mass: 0.1 kg/m, stiffness: 26 MN, breaking_force: 1000 kN}}
  bodies: {load: {mass: 1 t, at: [0 m, 0 m, 2 m], centre: [0 m, 0 m, -1 m], free: [)" +
                    free + R"(]}}
  reevings: [{rope: drop, path: [{anchor: head}, {anchor: lug}], length: 5 m}]
  terrain: {x: [-10 m, 10 m], z: [)" +
                    ground + ", " + ground + R"(]}
checks: {ropes: {drop: {safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{equilibrium: {}}]
)");
  };
  const Result in = hung("2.5 m", "x, y, z");
  EXPECT_EQ(verdict_of(in)->kind, VerdictKind::passes_with_warnings) << verdict_of(in)->reason;
  EXPECT_THAT(in.unsafe, Contains(HasSubstr("the centre of mass of 'load' is 1.502 m below the ground"))) << in.message;
  EXPECT_THAT(hung("1.05 m", "x, y, z").unsafe, IsEmpty()) << "a terrain is not surveyed better";
  EXPECT_THAT(hung("5.5 m", "x, y, z").unsafe, Contains(HasSubstr("of 'load' is 4.502 m below the ground")));
}

// Paid out by 1.5 m, its centre of mass comes to 0.5 m below the ground, 1 m below its rope. What a break throws about
// does not count.
TEST(Judge, ABodyThatAMotionLowersIntoTheGroundIsAWarning) {
  const auto lowered = [](const std::string& events) {
    return run_text(R"(taut: 1
machine:
  signals: {out: {table: {t: [0 s, 1 s, 3 s, 4 s], value: [0 m/s, -0.5 m/s, -0.5 m/s, 0 m/s]}}}
  ropes: {drop: {mass: 0.1 kg/m, stiffness: 2 MN, breaking_force: 1000 kN, damping_ratio: 0.1}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, drive: {speed: out}}}
  bodies: {load: {mass: 1 t, at: [0 m, 0 m, 4 m], centre: [0 m, 0 m, -1 m], free: [x, y, z]}}
  reevings: [{rope: drop, path: [{drum: winch}, {anchor: load}], length: 6 m}]
  terrain: {x: [-10 m, 10 m], z: [2 m, 2 m]}
)" + events + R"(checks: {ropes: {drop: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 5 s, output_step: 50 ms, tolerance: 1e-3}}]
)");
  };
  const Result in = lowered("");
  ASSERT_EQ(in.status, Status::ok) << in.message << to_text(in.errors);
  EXPECT_THAT(in.unsafe, Contains(HasSubstr("the centre of mass of 'load' is 0.53"))) << in.message;
  EXPECT_THAT(lowered("  events: [{at: 1.5 s, break: drop}]\n").unsafe, Not(Contains(HasSubstr("below the ground"))));
}

// The face of a slab that nothing moves is ground too.
TEST(Judge, ACraneOnASlabTipsAsOnTheGround) {
  std::string deck = crane("2.5 t");
  deck.replace(deck.find("  bodies:\n"), 10, "  bodies:\n    slab: {at: [0 m, 0 m, 0 m]}\n");
  deck.replace(deck.find("faces: {ground: {"), 17, "faces: {ground: {body: slab, ");
  const Result tips = run_text(deck);
  ASSERT_EQ(tips.status, Status::ok) << tips.message << to_text(tips.errors);
  EXPECT_THAT(tips.unsafe, Contains(HasSubstr("'crane' lifts 'left' off the ground")));
  EXPECT_THAT(tips.unsafe, Contains(HasSubstr("'crane' has tipped over")));
}

// A table that a signal turns by 70 deg takes a block along, unless it tips over: by its centre of mass 0.5 m above
// feet 0.6 m apart from 31 deg on.
TEST(Judge, WhatASignalTurnsHasNotFallen) {
  const auto tilted = [](const std::string& height) {
    return run_text(R"(taut: 1
machine:
  signals: {up: {ramp: {to: 70 deg, start: 0 s, duration: 2 s, smooth: true}}}
  points: {above: [0 m, 0 m, 5 m], low: {body: block, at: [-0.3 m, 0 m, 0 m]}, high: {body: block, at: [0.3 m, 0 m, 0 m]}}
  ropes: {line: {mass: 0 kg/m, stiffness: 10 kN, breaking_force: 200 kN, damping_ratio: 0.1}}
  bodies:
    plate: {at: [0 m, 0 m, 0 m], motion: {ry: up}}
    block: {mass: 100 kg, inertia: 4 kg m^2, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, )" +
                    height + R"(], free: [x, z, ry]}
  faces: {table: {body: plate, from: [-2 m, 0 m, 0 m], to: [2 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts:
    - {point: low, face: table, stiffness: 5 MN/m, damping: 20 kN s/m, static_friction: 5}
    - {point: high, face: table, stiffness: 5 MN/m, damping: 20 kN s/m, static_friction: 5}
  reevings: [{rope: line, path: [{anchor: above}, {anchor: block}], length: 4.99 m, may_slack: true}]
  observe: [block.ry, block.x, plate.ry]
checks: {ropes: {line: {dynamic_safety_factor: 2}}, confirmed: [elastic_limit]}
analyses: [{transient: {duration: 3 s, output_step: 50 ms, tolerance: 1e-3, start: assembled}}]
)");
  };
  const Result along = tilted("0.05 m");
  ASSERT_EQ(along.status, Status::ok) << along.message << to_text(along.errors);
  EXPECT_THAT(along.unsafe, IsEmpty());
  EXPECT_THAT(tilted("0.5 m").unsafe, Contains(HasSubstr("'block' has tipped over")));
}

// As it is put together its feet only touch the ground; they stand an instant later.
TEST(Judge, ACraneThatBeginsAssembledTipsToo) {
  std::string deck = crane("1.8 t");
  deck.replace(deck.find("start: settled"), 14, "start: assembled");
  const Result tips = run_text(deck);
  ASSERT_EQ(tips.status, Status::ok) << tips.message << to_text(tips.errors);
  EXPECT_THAT(tips.unsafe, Contains(HasSubstr("'crane' lifts 'left' off the ground"))) << to_text(tips.errors);
}

TEST(Judge, AMotionThatStopsWhereItBeginsShowsNothing) {
  std::string deck = crane("1 t");
  deck.replace(deck.find("  contacts:"), 11, "  events: [{when: \"hook.z < 100 m\", stop: true}]\n  contacts:");
  const Result stops = run_text(deck);
  ASSERT_EQ(stops.status, Status::ok) << stops.message << to_text(stops.errors);
  EXPECT_THAT(stops.unsafe, Contains(HasSubstr("ends it at t = 0 s, where it begins: it shows nothing")));
  deck.replace(deck.find("< 100 m"), 7, "> 1.1 m");
  EXPECT_THAT(run_text(deck).unsafe, IsEmpty());
}

// 20 kN on a carriage for 1 t, by a signal: the 5 kN beside it are of statics.
TEST(Judge, ACarriageBearsWhatTheSignalOfItsLoadSays) {
  const Result r = run_text(R"(taut: 1
machine:
  signals: {f: {ramp: {to: 20 kN, duration: 2 s, smooth: true}}}
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 26 MN, breaking_force: 330 kN, diameter: 20 mm, damping_ratio: 0.1}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, length_before: 50 m, at: [50 m, 0 m, 15 m],
    rated_payload: 1 t}}
  reevings: [{rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 101 m}]
  loads: [{at: car, force: [0 kN, 0 kN, -5 kN], signal: f}]
checks: {ropes: {sky: {dynamic_safety_factor: 2}}}
analyses: [{transient: {duration: 3 s, tolerance: 1e-3}}]
)");
  EXPECT_NEAR(check_of(r, "car.payload").value, 20e3 / 9.80665, 1e-6);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails) << r.message;
}

// For 80 ms four times the load, between two output steps: the rope does not see the top of it.
TEST(Judge, ACarriageBearsTheTopOfAPulse) {
  const Result r = run_text(R"(taut: 1
machine:
  signals: {p: {table: {t: [5.005 s, 5.045 s, 5.085 s], value: [10 kN, 40 kN, 10 kN]}}}
  points: {a: [0 m, 0 m, 30 m], b: [100 m, 0 m, 30 m]}
  ropes: {sk: {mass: 0 kg/m, stiffness: 26 MN, breaking_force: 900 kN, damping_ratio: 0.3}}
  carriages: {car: {mass: 300 kg, rides: sk, hold: clamped, length_before: 52 m, at: [50 m, 0 m, 18 m],
    rated_payload: 1500 kg}}
  reevings: [{rope: sk, path: [{anchor: a}, {through: car}, {anchor: b}], length: 104 m}]
  loads: [{at: car, force: [0 kN, 0 kN, -10 kN], signal: p}]
checks: {ropes: {sk: {dynamic_safety_factor: 2}}}
analyses: [{transient: {duration: 100 s, output_step: 0.1 s, tolerance: 1e-4}}]
)");
  EXPECT_NEAR(check_of(r, "car.payload").value, 40e3 / 9.80665, 1);
}

// A rope that a guard holds down may press on it.
TEST(Judge, AnUpliftThatIsHeldIsNoNews) { EXPECT_THAT(run_text(raised(", uplift: hold", "8 m")).unsafe, IsEmpty()); }

// A clearance, a life or the limit of something of the same name does not judge the rope's strength: 95 of 100 kN.
TEST(Judge, ALimitOfSomethingElseDoesNotJudgeARope) {
  const auto judged = [](const std::string& checks) {
    return verdict_of(run_text(R"(taut: 1
machine:
  ropes: {r: {rope: "EN 12385-4|6x36-IWRC|16|1770", stiffness: 12 MN}}
  points: {sky: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  terrain: {x: [0 m, 100 m], z: [0 m, 0 m]}
  reevings: [{name: sky, rope: r, path: [{anchor: sky}, {anchor: b}], tension_at_start: 95 kN}]
checks: )" + checks + "\n"));
  };
  for (const std::string side : {"{lines: {sky: {clearance: true}}}", "{anchors: {sky: {strength: 400 kN}}}"}) {
    const auto v = judged(side);
    ASSERT_TRUE(v) << side;
    EXPECT_EQ(v->kind, VerdictKind::not_judged) << side << v->reason;
    EXPECT_EQ(v->reason, "no limit is given for sky.") << side;
  }
  EXPECT_EQ(
      judged("{ropes: {sky: {safety_factor: 1.2}}, lines: {sky: {clearance: true}}, confirmed: [elastic_limit]}")->kind,
      VerdictKind::passes);
  EXPECT_EQ(judged("{ropes: {sky: {safety_factor: 3}}, lines: {sky: {clearance: true}}}")->kind, VerdictKind::fails);
}

/// A load whose winch takes in with a jerk, at rest before it.
std::string jerked(const std::string& analyses) {
  return R"(taut: 1
machine:
  signals: {haul: {ramp: {to: 2 m/s, start: 0.2 s, duration: 0.05 s, smooth: true}}}
  ropes: {hoist: {diameter: 14 mm, mass: 0.8 kg/m, stiffness: 9.8 MN, breaking_force: 30 kN, damping_ratio: 0.02}}
  bodies: {hook: {mass: 1.5 t, at: [0 m, 0 m, 1 m], free: [z]}}
  drums: {winch: {at: [0.2 m, 0 m, 12 m], core_diameter: 400 mm, drive: {speed: haul}}}
  reevings: [{rope: hoist, path: [{drum: winch}, {anchor: hook}], length: 11 m}]
checks: {ropes: {hoist: {safety_factor: 2}}, confirmed: [elastic_limit]}
analyses:
)" + analyses;
}

constexpr const char* at_rest = "  - equilibrium: {motion: at_rest}\n";
const std::string jerk = "  - transient: {duration: 0.6 s, output_step: 10 ms, name: jerk";

// One name, one number: the largest of all states that are judged, and the check of that number.
TEST(Judge, ThePeakOfAMotionIsTheLargestTension) {
  const Result r = run_text(jerked(at_rest + jerk + "}\n"));
  const taut::Value* T = r.find_value("hoist.T_max");
  ASSERT_NE(T, nullptr) << r.message << to_text(r.errors);
  EXPECT_GT(T->value, 30e3);
  EXPECT_THAT(T->label, HasSubstr("jerk, t = "));
  EXPECT_EQ(r.find_value("T_max")->value, T->value);
  EXPECT_EQ(std::count_if(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name == "hoist.T_max"; }), 1);
  EXPECT_EQ(check_of(r, "hoist.T_max").value, T->value);
  EXPECT_FALSE(check_of(r, "hoist.T_max").passes);
  EXPECT_FALSE(has_check(r, "hoist.T_max_jerk"));
  // 1.5 t and half of 11 m of rope in a motion, all of it at rest
  EXPECT_NEAR(30e3 / r.find_value("hoist.safety_factor")->value, 1.509e3 * 9.80665, 30);
}

TEST(Judge, AMotionThatIsNotJudgedHasNoPeak) {
  const Result rest = run_text(jerked(at_rest)), r = run_text(jerked(at_rest + jerk + ", judge: false}\n"));
  ASSERT_NE(r.find_value("hoist.T_max"), nullptr) << r.message << to_text(r.errors);
  EXPECT_EQ(r.find_value("hoist.T_max")->value, rest.find_value("hoist.T_max")->value);
  EXPECT_EQ(r.find_value("T_max")->value, rest.find_value("T_max")->value);
  EXPECT_EQ(r.checks.size(), rest.checks.size());
  EXPECT_EQ(verdict_of(r)->kind, verdict_of(rest)->kind) << verdict_of(r)->reason;
  EXPECT_GT(r.find_value("hoist.dynamic_factor_jerk")->value, 2) << "the motion itself is there";
}

// The winch takes in until the end: no one knows how far the tension would go.
TEST(Judge, AMotionThatEndsWhileATensionGrowsIsUnsafe) {
  const auto pulled = [](const std::string& duration) {
    return run_text(R"(taut: 1
machine:
  signals: {haul: {sequence: [{at: 0.1 s, to: 0.05 m/s, over: 0.1 s}, {at: 1 s, to: 0 m/s, over: 0.1 s}]}}
  points: {stump: [10 m, 0 m, 0 m]}
  ropes: {line: {diameter: 14 mm, mass: 0 kg/m, stiffness: 1 MN, breaking_force: 100 kN, damping_ratio: 0.05}}
  drums: {winch: {at: [0 m, 0 m, 0 m], core_diameter: 400 mm, drive: {speed: haul}}}
  reevings: [{rope: line, path: [{drum: winch}, {anchor: stump}], length: 10 m}]
checks: {ropes: {line: {dynamic_safety_factor: 3}}, confirmed: [elastic_limit]}
analyses: [transient: {duration: )" +
                    duration + ", output_step: 10 ms, tolerance: 1e-3}]\n");
  };
  EXPECT_THAT(pulled("0.8 s").unsafe, ElementsAre(HasSubstr("the tension of line is largest where the motion ends")));
  EXPECT_THAT(pulled("3 s").unsafe, IsEmpty());
}

/// A pulse of 40 kN at 1.5 s is larger than what a load that grows by 200 kN/s has brought when the motion ends; it
/// breaks the rope later. Neither does a swing hide a growth.
TEST(Judge, AnEarlierPeakHidesNoTensionThatGrows) {
  const auto ends = [](const std::string& load, const std::string& duration) {
    return run_text(R"(taut: 1
machine:
  signals: {p: {table: )" +
                    load + R"(}}
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.05}}
  bodies: {b: {mass: 500 kg, at: [0 m, 0 m, 5 m], free: [z]}}
  loads: [{at: b, force: [0 kN, 0 kN, 1 N], signal: p}]
  reevings: [{rope: r, path: [{anchor: top}, {anchor: b}], length: 5 m}]
analyses: [{transient: {output_step: 10 ms, tolerance: 1e-3, duration: )" +
                    duration + "}}]\nchecks: {ropes: {r: {dynamic_safety_factor: 2.5}}, confirmed: [elastic_limit]}\n");
  };
  const std::string pulse = "{t: [0 s, 1 s, 1.5 s, 2 s, 5 s, 6 s], value: [0 kN, 0 kN, -40 kN, 0 kN, 0 kN, -200 kN]}";
  const auto told = ElementsAre(HasSubstr("the tension of r still grows where the motion ends"));
  EXPECT_THAT(ends(pulse, "5.19 s").unsafe, told);
  EXPECT_THAT(ends(pulse, "4.5 s").unsafe, IsEmpty()) << "nothing goes on";
  const std::string slow = "{t: [0 s, 1 s, 401 s], value: [0 kN, 0 kN, -200 kN]}";
  EXPECT_THAT(ends(slow, "20 s").unsafe, told) << "by 0.5 kN/s";
}

// What no state shows is named: a rope without mass has no shape where it is slack.
TEST(Judge, NamesWhatIsNotPartOfTheVerdict) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 10 m], b: [50 m, 0 m, 12 m], c: [60 m, 0 m, 12 m], d: [70 m, 0 m, 12 m]}
  ropes: {loose: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}, sky: {mass: 1 kg/m, stiffness: 20 MN}}
  reevings:
    - {rope: loose, path: [{anchor: a}, {anchor: b}], length: 80 m, may_slack: true}
    - {rope: sky, path: [{anchor: c}, {anchor: d}], length: 10.1 m}
  terrain: {x: [0 m, 100 m], z: [0 m, 0 m]}
checks: {lines: {loose: {least_clearance: 2 m}}}
)");
  EXPECT_THAT(r.beside, Contains("the ground below loose where it is slack or nearly so"))
      << r.message << to_text(r.errors);
  EXPECT_THAT(r.unmade, ElementsAre(HasSubstr("loose: its clearance is not judged where it is slack")));
  const Result deck = run_text(R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 9 m], eye: {body: box, at: [0 m, 0 m, 1 m]}}
  markers: {foot: {body: box, at: [0 m, 0 m, 0 m]}}
  faces: {floor: {from: [-1 m, 0 m, 0 m], to: [1 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts: [{point: foot, face: floor, stiffness: 1 MN/m, damping: 1 kN s/m}]
  ropes: {line: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 100 kN, damping_ratio: 0.1}}
  bodies: {box: {mass: 100 kg, at: [0 m, 0 m, 0.1 m], free: [z]}}
  reevings: [{rope: line, path: [{anchor: top}, {anchor: eye}], length: 7.9 m}]
analyses: [transient: {duration: 0.1 s}]
)");
  EXPECT_THAT(deck.beside, Contains(HasSubstr("contacts foot"))) << deck.message << to_text(deck.errors);
}

// The ground is known up to 140 m only.
TEST(Judge, WhereTheTerrainEndsTheAnswerPassesWithWarningsAtBest) {
  const auto with = [](const std::string& ends, const std::string& from, const std::string& begins = "-10 m") {
    return run_text(R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 20 m], B: [200 m, 0 m, 20 m]}
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped}}
  reevings: [{rope: sky, path: [{anchor: A}, {through: car}, {anchor: B}], length: 203 m}]
  terrain: {x: [)" + begins +
                    ", " + ends + "], z: [0 m, 1 m]}\nanalyses:\n  - load_path: {carriage: car, from: " + from +
                    ", to: 190 m, steps: 4}\nchecks: {ropes: {sky: {safety_factor: 3}}}\n");
  };
  const Result beyond = with("140 m", "150 m");
  EXPECT_EQ(verdict_of(beyond)->kind, VerdictKind::passes_with_warnings) << verdict_of(beyond)->reason;
  EXPECT_THAT(beyond.unsafe, Contains(HasSubstr("car stands up to 50 m behind the last place of the terrain:")));
  EXPECT_THAT(beyond.unsafe, Contains(HasSubstr("sky: its clearance is not judged on 60 m")));
  const Result near = with("195 m", "150 m");
  EXPECT_THAT(near.unsafe, IsEmpty()) << "5 m from the anchor the rope may be in the ground";
  EXPECT_THAT(with("210 m", "150 m").unsafe, IsEmpty());
  EXPECT_THAT(with("140 m", "10 m", "30 m").unsafe,
              Contains(HasSubstr("car stands up to 20 m before the first place and up to 50 m behind the last place of "
                                 "the terrain:")));
}

// The stump stands 18 m beside the line, 5 m below the ground there; a guy along the line is in the ground.
TEST(Judge, AGuyBesideTheLineIsNotOverItsGround) {
  const auto with = [](const std::string& stump) {
    return run_text(R"(taut: 1
machine:
  terrain: {x: [-30 m, 30 m], z: [0 m, 0 m]}
  ropes: {guy: {mass: 1 kg/m, stiffness: 20 MN, breaking_force: 270 kN}}
  points: {head: [0 m, 0 m, 14 m], stump: )" +
                    stump + R"(}
  guys: {g: {rope: guy, from: head, to: stump, install: {tension: 30 kN}}}
checks: {guys: {g: {safety_factor: 3, check_pretension: false}}}
)");
  };
  const Result beside = with("[0 m, 18 m, -5 m]");
  EXPECT_EQ(verdict_of(beside)->kind, VerdictKind::passes_with_warnings) << "both ends stand fast";
  EXPECT_THAT(beside.unsafe, SizeIs(1));
  EXPECT_THAT(beside.beside, Contains(HasSubstr("the ground below g, off the line of the terrain")));
  EXPECT_EQ(beside.find_value("rope_clearance_min"), nullptr);
  EXPECT_EQ(verdict_of(with("[18 m, 0 m, -5 m]"))->kind, VerdictKind::fails);
}

// A haul rope whose end stands 6 m beside the line hangs into the ground on the line: its lowest place counts.
TEST(Judge, ARopeThatIsInTheGroundOnTheLineFailsWhereverItEnds) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 20 m], B: [200 m, 6 m, 20 m]}
  ropes: {haul: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  reevings: [{rope: haul, path: [{anchor: A}, {anchor: B}], length: 203 m}]
  terrain: {x: [-10 m, 210 m], z: [8 m, 8 m]}
checks: {ropes: {haul: {safety_factor: 3}}}
)");
  EXPECT_LT(check_of(r, "haul.ground").value, -2);
  EXPECT_THAT(r.beside, Contains(HasSubstr("the ground below haul, off the line of the terrain")));
}

// It hangs 8 m below the ground where that ends, and nowhere else over it.
TEST(Judge, ARopeInTheGroundWhereTheTerrainEndsFails) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 20 m], B: [200 m, 0 m, 20 m]}
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  reevings: [{rope: sky, path: [{anchor: A}, {anchor: B}], length: 203 m}]
  terrain: {x: [-10 m, 100 m], z: [0 m, 13 m]}
checks: {ropes: {sky: {safety_factor: 3}}}
)");
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails) << verdict_of(r)->reason;
  // a level catenary: L = 2 a sinh(100/a) is 203 m (but for 0.06 m of stretch), its sag a (cosh(100/a) - 1) 15.2 m
  EXPECT_NEAR(check_of(r, "sky.ground").value, 20 - 15.22 - 13, 0.02);
}

}  // namespace taut::checks::judge_test
