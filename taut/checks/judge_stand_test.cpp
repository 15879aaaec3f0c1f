#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "test/support/machine_decks.hpp"

/// Machines that stand on the ground by their weight and by friction.
namespace taut::judge_stand_test {

using taut_test::run_text;

/// A yarder of 8 t with its feet 4 m apart, whose winch holds a log that pulls it.
std::string yarder(double pull, double height = 0.5) {
  return fmt::format(R"(taut: 1
machine:
  signals: {{pull: {{ramp: {{from: 1 kN, to: {0} kN, start: 0.1 s, duration: 0.3 s, smooth: true}}}}}}
  points: {{f1: {{body: yarder, at: [-2 m, 0 m, -1 m]}}, f2: {{body: yarder, at: [2 m, 0 m, -1 m]}}}}
  ropes: {{r: {{mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 300 kN, damping_ratio: 0.1}}}}
  bodies:
    yarder: {{mass: 8 t, inertia: [8000 kg m^2, 8000 kg m^2, 8000 kg m^2], at: [0 m, 0 m, 1 m], free: [x, z, ry]}}
    log: {{mass: 500 kg, at: [60 m, 0 m, {1} m], free: [x]}}
  drums: {{winch: {{body: yarder, at: [0 m, 0 m, {2} m], core_diameter: 400 mm}}}}
  faces: {{ground: {{from: [-20 m, 0 m, 0 m], to: [50 m, 0 m, 0 m], normal: [0, 0, 1]}}}}
  contacts:
    - {{point: f1, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.4}}
    - {{point: f2, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.4}}
  loads: [{{at: log, force: [1 kN, 0 kN, 0 kN], signal: pull}}]
  reevings: [{{rope: r, path: [{{drum: winch, side: left}}, {{anchor: log}}], length: 60 m}}]
analyses: [{{transient: {{duration: 3 s, output_step: 20 ms}}}}]
checks: {{ropes: {{r: {{safety_factor: 2.5}}}}}}
)",
                     pull, height, height - 1);
}

// friction holds 0.4 x 8 t x g = 31.4 kN
TEST(JudgeStand, WhatIsDraggedOffItsFeetIsUnsafe) {
  const Result held = run_text(yarder(30));
  ASSERT_EQ(held.status, Status::ok) << held.message << to_text(held.errors);
  EXPECT_TRUE(held.unsafe.empty()) << held.unsafe.front();
  const Result dragged = run_text(yarder(36));
  ASSERT_EQ(dragged.unsafe.size(), 1U) << dragged.message << to_text(dragged.errors);
  EXPECT_NE(dragged.unsafe[0].find("'yarder' is dragged"), std::string::npos) << dragged.unsafe[0];
}

// A block that is a rope's anchor: 30 kN at 1.8 m against 5 t x g x 0.6 m = 29.4 kN m.
TEST(JudgeStand, AnAnchorBlockThatTipsIsUnsafe) {
  const auto block = [](const std::string& anchors) {
    return run_text(R"(taut: 1
machine:
  signals: {pull: {ramp: {from: 1 kN, to: 30 kN, start: 0.1 s, duration: 0.5 s, smooth: true}}}
  points:
    f1: {body: block, at: [-0.6 m, 0 m, -1 m]}
    f2: {body: block, at: [0.6 m, 0 m, -1 m]}
    eye: {body: block, at: [0 m, 0 m, 0.8 m]}
  ropes: {r: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 300 kN, damping_ratio: 0.1}}
  bodies:
    block: {mass: 5 t, inertia: [3000 kg m^2, 3000 kg m^2, 3000 kg m^2], at: [0 m, 0 m, 1 m], free: [x, z, ry]}
    log: {mass: 500 kg, at: [60 m, 0 m, 1.8 m], free: [x]}
  faces: {ground: {from: [-20 m, 0 m, 0 m], to: [50 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts:
    - {point: f1, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.8}
    - {point: f2, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.8}
  loads: [{at: log, force: [1 kN, 0 kN, 0 kN], signal: pull}]
  reevings: [{rope: r, path: [{anchor: eye}, {anchor: log}], length: 60 m}]
analyses: [{transient: {duration: 1.2 s, output_step: 20 ms}}]
checks: {ropes: {r: {safety_factor: 2.5}})" +
                    anchors + "}\n");
  };
  const Result r = block(", anchors: {eye: {strength: 100 kN}}");
  ASSERT_FALSE(r.unsafe.empty()) << r.message << to_text(r.errors);
  EXPECT_NE(r.unsafe[0].find("'block' lifts 'f1'"), std::string::npos) << r.unsafe[0];
  // what no check calls an anchor may be a load that is dragged
  EXPECT_TRUE(block("").unsafe.empty());
}

// It hangs over the ground and has never stood there; its rope goes slack in the first interval of the output.
TEST(JudgeStand, WhatHasNeverStoodLiftsNoFoot) {
  const auto block = [](double z) {
    return run_text(fmt::format(R"(taut: 1
machine:
  points: {{f1: {{body: block, at: [-1 m, 0 m, -1 m]}}, f2: {{body: block, at: [1 m, 0 m, -1 m]}}, top: [0.2 m, 0 m, 20 m], side: [-0.2 m, 0 m, 20 m]}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 10 MN, breaking_force: 300 kN, damping_ratio: 0.1}}}}
  bodies: {{block: {{mass: 2 t, inertia: [800 kg m^2, 800 kg m^2, 800 kg m^2], at: [0 m, 0 m, {} m], free: [z]}}}}
  sheaves: {{wheel: {{body: block, at: [0 m, 0 m, 1 m], diameter: 400 mm}}}}
  faces: {{ground: {{from: [-20 m, 0 m, 0 m], to: [50 m, 0 m, 0 m], normal: [0, 0, 1]}}}}
  contacts:
    - {{point: f1, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.4}}
    - {{point: f2, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.4}}
  reevings: [{{rope: r, path: [{{anchor: side}}, {{over: wheel}}, {{anchor: top}}], length: 28.6 m}}]
analyses: [{{transient: {{duration: 1 s, output_step: 0.5 s}}}}]
checks: {{ropes: {{r: {{safety_factor: 2.5}}}}}}
)",
                                z));
  };
  const Result r = block(4.5);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(r.unsafe.empty()) << r.unsafe.front();
}

// A blow of 80 ms at its tip, between two output steps; its rope hardly feels it.
TEST(JudgeStand, AFootThatLiftsForAMomentIsTold) {
  const Result r = run_text(R"(taut: 1
machine:
  signals: {p: {table: {t: [5.005 s, 5.045 s, 5.085 s], value: [0.01 kN, 70 kN, 0.01 kN]}}}
  points:
    tip: {body: crane, at: [3 m, 0 m, 6 m]}
    f1: {body: crane, at: [-2 m, 0 m, 0 m]}
    f2: {body: crane, at: [2 m, 0 m, 0 m]}
  ropes: {h: {mass: 0 kg/m, stiffness: 8 MN, breaking_force: 200 kN, damping_ratio: 0.1}}
  bodies:
    crane: {mass: 12 t, at: [0 m, 0 m, 0 m], centre: [-0.5 m, 0 m, 1.5 m], inertia: 30000 kg m^2, free: [x, z, ry]}
    load: {mass: 1 t, at: [3 m, 0 m, 2 m], free: [x, z]}
  faces: {gr: {from: [-6 m, 0 m, 0 m], to: [6 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts:
    - {point: f1, face: gr, stiffness: 40 MN/m, damping: 400 kN s/m, static_friction: 0.6}
    - {point: f2, face: gr, stiffness: 40 MN/m, damping: 400 kN s/m, static_friction: 0.6}
  drums: {w: {body: crane, at: [0 m, 0 m, 1 m], core_diameter: 300 mm, inertia: 5 kg m^2, length_on_drum: 20 m}}
  sheaves: {head: {body: crane, at: [2.85 m, 0 m, 6 m], diameter: 300 mm}}
  loads: [{at: tip, force: [0.01 kN, 0 kN, 0 kN], signal: p}]
  reevings: [{rope: h, path: [{drum: w}, {over: head}, {anchor: load}], length: 9.8 m}]
analyses: [{transient: {duration: 100 s, output_step: 0.1 s, tolerance: 1e-5}}]
checks: {ropes: {h: {dynamic_safety_factor: 4}}}
)");
  ASSERT_FALSE(r.unsafe.empty()) << r.message << to_text(r.errors);
  EXPECT_NE(r.unsafe[0].find("'crane' lifts 'f1'"), std::string::npos) << r.unsafe[0];
}

/// A crane of 5 t with its feet 4 m apart; its load of 3 t hangs 3 m beyond them and grows to 4.5 t.
std::string crane(const std::string& load, const std::string& point, const std::string& contact,
                  const std::string& sheave, const std::string& start = "settled") {
  return fmt::format(R"(taut: 1
machine:
  signals: {{more: {{ramp: {{from: 0 kN, to: 15 kN, start: 0.2 s, duration: 0.5 s, smooth: true}}}}}}
  points:
    f1: {{body: crane, at: [2 m, 0 m, 0 m]}}
    f3: {{body: crane, at: [-2 m, 0 m, 0 m]}}
    foot: {{body: crane, at: [0 m, 0 m, 2 m]}}
{1}  ropes: {{hoist: {{mass: 0 kg/m, stiffness: 10 MN, breaking_force: 400 kN, damping_ratio: 0.2, diameter: 16 mm}}}}
  bodies:
    crane: {{mass: 5 t, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 1 m], free: [x, z, ry], inertia: 20000 kg m^2}}
    load: {{mass: {0}, at: [5 m, 0 m, 3 m], free: [x, z]}}
  sheaves: {{jib: {{body: crane, {3}}}}}
  faces:
    ground: {{from: [-20 m, 0 m, 0 m], to: [20 m, 0 m, 0 m], normal: [0, 0, 1]}}
    stop: {{from: [12 m, 0 m, 0 m], to: [12 m, 0 m, 3 m], normal: [-1, 0, 0]}}
  contacts:
    - {{point: f1, face: ground, stiffness: 10 MN/m, damping: 200 kN s/m, static_friction: 0.5}}
    - {{point: f3, face: ground, stiffness: 10 MN/m, damping: 200 kN s/m, static_friction: 0.5}}
{2}  reevings: [{{rope: hoist, path: [{{anchor: foot}}, {{over: jib}}, {{anchor: load}}], length: 13.2 m}}]
  loads: [{{at: load, force: [0 kN, 0 kN, -1 kN], signal: more}}]
analyses: [{{transient: {{duration: 1.4 s, output_step: 20 ms, start: {4}}}}}]
checks: {{ropes: {{hoist: {{safety_factor: 4, diameter_ratio: 16}}}}}}
)",
                     load, point, contact, sheave, start);
}
constexpr const char* wheel = "at: [4.8 m, 0 m, 8 m], diameter: 400 mm";

/// The unsafe warnings, one a line.
std::string unsafe(const std::string& deck) {
  const Result r = run_text(deck);
  std::string all = r.status == Status::ok ? "" : r.message + to_text(r.errors);
  for (const std::string& one : r.unsafe) all += one + "\n";
  return all;
}

// A bumper that has not met its stop, an outrigger above the ground, and a sheave that is a point took the check away.
// With 3 t the crane bears 9 t m of 10 t m, with 4.5 t it tips.
TEST(JudgeStand, NoOtherContactAndNoPointSheaveHidesATippingCrane) {
  const std::string lifts = "'crane' lifts 'f3'";
  const auto contact = [](const std::string& face) {
    return "    - {point: other, face: " + face + ", stiffness: 5 MN/m, damping: 100 kN s/m}\n";
  };
  const auto point = [](const std::string& at) { return "    other: {body: crane, at: " + at + "}\n"; };
  EXPECT_NE(unsafe(crane("3 t", "", "", wheel)).find(lifts), std::string::npos);
  EXPECT_NE(unsafe(crane("3 t", point("[2.5 m, 0 m, 0.5 m]"), contact("stop"), wheel)).find(lifts), std::string::npos);
  EXPECT_NE(unsafe(crane("3 t", point("[-1 m, 0 m, 0.3 m]"), contact("ground"), wheel)).find(lifts), std::string::npos);
  const std::string no_wheel = crane("3 t", "", "", "at: [5 m, 0 m, 8 m]");
  EXPECT_NE(unsafe(no_wheel).find(lifts), std::string::npos) << unsafe(no_wheel);
  // what bears 6 t m at most stands, an outrigger above the ground lifts nothing
  const std::string stands = crane("0.5 t", point("[-1 m, 0 m, 0.3 m]"), contact("ground"), wheel);
  EXPECT_EQ(unsafe(stands), "");
}

// A crane on a mat that itself stands on the ground.
TEST(JudgeStand, ACraneOnAMatTipsToo) {
  std::string deck = crane("3 t", "", "", wheel);
  const auto put = [&](const std::string& behind, const std::string& text) {
    ASSERT_NE(deck.find(behind), std::string::npos) << behind;
    deck.insert(deck.find(behind) + behind.size(), text);
  };
  put("  points:\n", "    under: {body: mat, at: [0 m, 0 m, -0.2 m]}\n");
  put("  bodies:\n", "    mat: {mass: 3 t, at: [0 m, 0 m, 0 m], free: [z]}\n");
  put("ground: {", "body: mat, ");
  put("  faces:\n", "    soil: {from: [-20 m, 0 m, -0.2 m], to: [20 m, 0 m, -0.2 m], normal: [0, 0, 1]}\n");
  put("  contacts:\n", "    - {point: under, face: soil, stiffness: 200 MN/m, damping: 1 MN s/m}\n");
  EXPECT_NE(unsafe(deck).find("'crane' lifts 'f3'"), std::string::npos) << unsafe(deck);
}

// A cage with the lower block of its tackle stands on two skids, of which one leaves the ground first.
TEST(JudgeStand, AHookBlockIsPickedUp) {
  const std::string cage = R"(taut: 1
machine:
  signals: {v: {ramp: {to: 0.6 m/s, start: 0.5 s, duration: 0.5 s, smooth: true}}}
  points:
    dead: [0.4 m, 0 m, 8 m]
    k1: {body: cage, at: [-0.6 m, 0 m, -1 m]}
    k2: {body: cage, at: [0.6 m, 0 m, -1 m]}
  ropes: {h: {mass: 0.8 kg/m, stiffness: 10 MN, breaking_force: 200 kN, damping_ratio: 0.2, diameter: 16 mm}}
  sheaves:
    top: {at: [0 m, 0 m, 8 m], diameter: 400 mm}
    blk: {body: cage, at: [0 m, 0 m, 0.4 m], diameter: 400 mm}
  drums: {w: {at: [-6 m, 0 m, 1.5 m], core_diameter: 400 mm, drive: {speed: v}}}
  bodies:
    cage: {mass: 2 t, at: [0.4 m, 0 m, 1 m], centre: [0 m, 0 m, -0.4 m], free: [x, z, ry], inertia: 1000 kg m^2}
  faces: {ground: {from: [-20 m, 0 m, 0 m], to: [20 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts:
    - {point: k1, face: ground, stiffness: 5e6 N/m, damping: 1e5 N s/m, static_friction: 0.5}
    - {point: k2, face: ground, stiffness: 5e6 N/m, damping: 1e5 N s/m, static_friction: 0.5}
  reevings: [{rope: h, path: [{drum: w}, {over: top}, {over: blk}, {anchor: dead}], length: 23.4 m}]
analyses: [{transient: {duration: 3 s, output_step: 10 ms}}]
checks: {ropes: {h: {dynamic_safety_factor: 4}}}
)";
  const std::string told = unsafe(cage);
  EXPECT_EQ(told.find("begins to tip"), std::string::npos) << told;
}

// With 5 t it tips from the start, as its rope is tight there: its back foot has never stood.
TEST(JudgeStand, ACraneThatTipsFromTheStartIsUnsafe) {
  std::string deck = crane("5 t", "", "", wheel, "assembled");
  deck.replace(deck.find("13.2 m"), 6, "13.11 m");
  const std::string told = unsafe(deck);
  EXPECT_NE(told.find("'crane' never stands on 'f3'"), std::string::npos) << told;
}

// A crane of 3 t with its feet at 1 m, which holds its load by the plain end of a rope at 3.2 m: 3000 x 1 > m x 2.2 up
// to 1364 kg.
TEST(JudgeStand, ACraneTipsUnderALoadOnAPlainEnd) {
  const auto crane_with = [](const std::string& mass, const std::string& place = "[3.2 m, 0 m, 2 m]") {
    return fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: 5 MN, breaking_force: 200 kN, damping_ratio: 0.05}}}}
  bodies:
    c: {{mass: 3 t, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 1.5 m], free: [x, z, ry], inertia: 4000 kg m^2}}
    w: {{mass: {}, at: {}, free: [x, z]}}
  points: {{f1: {{body: c, at: [-1 m, 0 m, 0 m]}}, f2: {{body: c, at: [1 m, 0 m, 0 m]}}, tip: {{body: c, at: [3.2 m, 0 m, 5 m]}}}}
  faces: {{g: {{from: [-20 m, 0 m, 0 m], to: [20 m, 0 m, 0 m], normal: [0, 0, 1]}}}}
  contacts:
    - {{point: f1, face: g, stiffness: 5 MN/m, damping: 60 kN s/m, static_friction: 0.8}}
    - {{point: f2, face: g, stiffness: 5 MN/m, damping: 60 kN s/m, static_friction: 0.8}}
  reevings: [{{rope: r, path: [{{anchor: tip}}, {{anchor: w}}], length: 3 m}}]
analyses: [{{transient: {{duration: 0.8 s, tolerance: 1e-4, start: assembled}}}}]
checks: {{ropes: {{r: {{dynamic_safety_factor: 2}}}}}}
)",
                       mass, place);
  };
  EXPECT_NE(unsafe(crane_with("1.7 t")).find("'c' lifts 'f1'"), std::string::npos) << unsafe(crane_with("1.7 t"));
  EXPECT_EQ(unsafe(crane_with("600 kg")).find("'f1'"), std::string::npos) << unsafe(crane_with("600 kg"));
}

}  // namespace taut::judge_stand_test
