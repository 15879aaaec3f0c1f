#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// A motion in an equilibrium that the machine does not stay in.
namespace taut::unstable_motion_test {

using taut_test::run_text;

/// A mast on a ball foot, with a guy on each side in the plane x-z alone, and `more` guys.
std::string mast(const std::string& motion, const std::string& more = "") {
  return R"(taut: 1
machine:
  ropes: {g: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 100 kN, damping_ratio: 0.05}}
  bodies:
    mast: {mass: 800 kg, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 5 m], inertia: [7000 kg m^2, 7000 kg m^2, 50 kg m^2],
           free: [rx, ry, rz]}
  points:
    top: {body: mast, at: [0 m, 0 m, 10 m]}
    l: [-8 m, 0 m, 0 m]
    r: [8 m, 0 m, 0 m]
    f: [0 m, -8 m, 0 m]
    b: [0 m, 8 m, 0 m]
  reevings:
    - {name: gl, rope: g, path: [{anchor: top}, {anchor: l}], length: 12.8 m}
    - {name: gr, rope: g, path: [{anchor: top}, {anchor: r}], length: 12.8 m}
)" + more +
         "analyses: [transient: {duration: 2 s" + motion + "}]\nchecks: {ropes: {g: {safety_factor: 3}}}\n";
}

const std::string across = R"(    - {name: gf, rope: g, path: [{anchor: top}, {anchor: f}], length: 12.8 m}
    - {name: gb, rope: g, path: [{anchor: top}, {anchor: b}], length: 12.8 m}
)";

std::string unsafe_words(const Result& r) {
  std::string all;
  for (const std::string& words : r.unsafe) all += words + "\n";
  return all;
}

const std::string falls = "at the least push body 'mast' turns over about x";

// It passed: without a push the mast stays upright for good.
TEST(UnstableMotion, WhereItSettlesOrBeginsItIsUnsafe) {
  for (const char* const motion : {"", ", quasi_static: true", ", start: assembled"}) {
    const Result r = run_text(mast(motion));
    EXPECT_EQ(to_text(verdict_of(r)->kind), "passes_with_warnings") << motion;
    EXPECT_NE(unsafe_words(r).find("at t = 0 s the machine rests in an equilibrium that it does not stay in: " + falls),
              std::string::npos)
        << motion << ": " << unsafe_words(r);
    EXPECT_EQ(to_text(verdict_of(run_text(mast(motion, across)))->kind), "passes") << motion;
  }
}

// All guys meet its axis: it may turn about that as rounding will, and rests all the same.
TEST(UnstableMotion, AMastThatTurnsFreelyAboutItsAxisComesToRest) {
  std::string deck = mast("", across + "  loads: [{at: top, force: [2 kN, 0.7 kN, 0 kN]}]\n");
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const std::string motion = "transient: {duration: 2 s}";
  const Result at_rest = run_text(deck.replace(deck.find(motion), motion.size(), "equilibrium: {}"));
  for (const char* rope : {"gl.T_max", "gr.T_max", "gf.T_max", "gb.T_max"}) {
    EXPECT_NEAR(taut_test::value_of(r, rope), taut_test::value_of(at_rest, rope), 1) << rope;
  }
}

/// A strut between two guys under a load that grows; on a foot that is `aside`.
std::string strut(const std::string& motion, const std::string& aside, const std::string& load) {
  return R"(taut: 1
machine:
  signals: {head: {ramp: {from: 1 kN, to: )" +
         load + R"(, start: 0.2 s, duration: 2 s, smooth: true}}}
  ropes: {g: {mass: 0 kg/m, stiffness: 0.5 MN, breaking_force: 100 kN, damping_ratio: 0.05}}
  bodies: {mast: {mass: 800 kg, at: [)" +
         aside + R"(, 0 m, 0 m], centre: [0 m, 0 m, 5 m], inertia: 7000 kg m^2, free: [ry]}}
  points: {top: {body: mast, at: [0 m, 0 m, 10 m]}, l: [-8 m, 0 m, 0 m], r: [8 m, 0 m, 0 m]}
  loads: [{at: top, name: p, force: [0 kN, 0 kN, -1 kN], signal: head}]
  reevings:
    - {name: gl, rope: g, path: [{anchor: top}, {anchor: l}], length: 12.6 m}
    - {name: gr, rope: g, path: [{anchor: top}, {anchor: r}], length: 12.6 m}
analyses: [transient: {duration: 3 s)" +
         motion + "}]\nchecks: {ropes: {g: {safety_factor: 3}}}\n";
}

// It buckles between 1 and 400 kN: both guys together hold 10 m * 2 EA/L (8/12.8)^2 = 300 kN.
TEST(UnstableMotion, ALoadThatGrowsPastTheCriticalOneIsUnsafe) {
  for (const char* const motion : {"", ", quasi_static: true, output_step: 50 ms"}) {
    const Result r = run_text(strut(motion, "0 m", "400 kN"));
    EXPECT_NE(unsafe_words(r).find("body 'mast' turns over about y"), std::string::npos) << motion << unsafe_words(r);
    const Result less = run_text(strut(motion, "0 m", "200 kN"));
    EXPECT_EQ(unsafe_words(less), "") << motion;
  }
}

// A cage on a drum is heavier the more rope is out; its brake holds it.
TEST(UnstableMotion, WhatABrakeHoldsStays) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 300 kN, damping_ratio: 0.1}}
  bodies: {cage: {mass: 1 t, at: [0.5 m, 0 m, -20 m], free: [z]}}
  drums: {w: {at: [0 m, 0 m, 0 m], core_diameter: 1000 mm, inertia: 500 kg m^2, drive: {brake: set}, brake_torque: 8 kN m}}
  reevings: [{rope: r, path: [{drum: w}, {anchor: cage}], length: 20 m}]
checks: {ropes: {r: {safety_factor: 5}}}
analyses: [{transient: {duration: 2 s}}]
)");
  EXPECT_EQ(unsafe_words(r), "") << r.message << to_text(r.errors);
}

// A sheave with inertia has no drive of its own.
TEST(UnstableMotion, AHookUnderASheaveStays) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 300 kN, damping_ratio: 0.1}}
  bodies: {hook: {mass: 1 t, at: [0.2 m, 0 m, 6 m], free: [z]}}
  sheaves: {head: {at: [0 m, 0 m, 12 m], diameter: 400 mm, efficiency: 0.98, inertia: 0.5 kg m^2}}
  drums: {winch: {at: [-5 m, 0 m, 1 m], core_diameter: 400 mm}}
  reevings: [{rope: r, path: [{drum: winch}, {over: head}, {anchor: hook}], length: 18.3 m}]
checks: {ropes: {r: {safety_factor: 4}}}
analyses: [{transient: {duration: 0.5 s}}]
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(unsafe_words(r), "");
}

// What falls is seen to move: the motion tells.
TEST(UnstableMotion, WhatFallsIsInMotion) {
  const Result r = run_text(strut("", "50 mm", "400 kN"));
  EXPECT_EQ(unsafe_words(r).find("does not stay in"), std::string::npos) << unsafe_words(r);
}

}  // namespace taut::unstable_motion_test
