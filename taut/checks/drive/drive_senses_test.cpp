#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Which way drums turn, and what a state that only lowers shows of its ropes.
namespace taut::drive_senses_test {

using taut_test::run_text;

/// With or without warnings.
bool passes(const Verdict& verdict) { return to_text(verdict.kind).starts_with("passes"); }

/// Two ropes hoist one block. Left to the places, they leave the drum on opposite sides, and their torques would
/// cancel.
TEST(DriveUses, ADrumDoesNotTurnBothWays) {
  const auto twin = [](const std::string& on_drum, const std::string& motion) {
    const std::string path = "path: [{drum: w" + on_drum + "}, ";
    return run_text(R"(taut: 1
machine:
  points: {p1: [-0.2 m, 0 m, 20 m], p2: [1.8 m, 0 m, 20 m]}
  ropes: {a: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 180 kN}, b: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 180 kN}}
  bodies: {hook: {mass: 8 t, at: [0 m, 0 m, 3 m], free: [z]}}
  sheaves:
    s1: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.9}
    s2: {body: hook, at: [2 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.9}
  drums: {w: {at: [1 m, -1 m, 20 m], core_diameter: 384 mm, brake_torque: 0.5 kN m, inertia: 5 kg m^2}}
  reevings:
    - {rope: a, )" + path +
                    "{over: s1}, {anchor: p1}], length: 45 m}\n    - {rope: b, " + path +
                    "{over: s2}, {anchor: p2}], length: 45 m}\nanalyses: [equilibrium: {motion: " + motion +
                    "}]\nchecks: {ropes: {a: {safety_factor: 5}, b: {safety_factor: 5}}}\n");
  };
  for (const char* const motion : {"hoist", "at_rest"}) {
    const Result open = twin("", motion);
    ASSERT_TRUE(verdict_of(open)) << to_text(open.errors);
    EXPECT_NE(to_text(verdict_of(open)->kind), "passes") << motion;
    EXPECT_NE(std::find_if(open.unmade.begin(), open.unmade.end(),
                           [](const std::string& one) { return one.find("turn both ways") != std::string::npos; }),
              open.unmade.end())
        << motion;
    const Result given = twin(", side: left", motion);
    EXPECT_TRUE(given.unmade.empty() || given.unmade.front().find("turn both ways") == std::string::npos);
  }
  const Result held = twin(", side: left", "at_rest");
  EXPECT_EQ(to_text(verdict_of(held)->kind), "fails") << verdict_of(held)->reason;
  EXPECT_NEAR(taut_test::check_of(held, "w.brake_torque").value, 8e3 * 9.80665 / 2 * 0.192, 50);
}

/// Two hooks of 2 t left and right of a drum: by the places the ropes leave it on opposite sides, and their torques
/// cancel. A motion turns the drum so; whether that is meant only the deck can say.
TEST(DriveUses, AMotionAsksForTheSidesOfADrum) {
  const auto hooks = [](const std::string& one, const std::string& other) {
    const Result r = run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 400 kN, damping_ratio: 0.3}}
  bodies:
    hook: {mass: 2 t, at: [3.2 m, 0 m, 3 m], free: [z]}
    other: {mass: 2 t, at: [-3.2 m, 0 m, 3 m], free: [z]}
  sheaves: {h1: {at: [3 m, 0 m, 10.2 m], diameter: 400 mm}, h2: {at: [-3 m, 0 m, 10.2 m], diameter: 400 mm}}
  drums: {winch: {at: [0 m, 0 m, 10 m], core_diameter: 400 mm, inertia: 5 kg m^2, brake_torque: 2.5 kN m}}
  reevings:
    - {rope: hoist, name: a, path: [{drum: winch)" +
                              one + R"(}, {over: h1}, {anchor: hook}], length: 10 m}
    - {rope: hoist, name: b, path: [{drum: winch)" +
                              other + R"(}, {over: h2}, {anchor: other}], length: 10 m}
checks: {ropes: {hoist: {safety_factor: 3}}}
analyses: [transient: {duration: 0.2 s, tolerance: 1e-3}]
)");
    const auto verdict = verdict_of(r);
    EXPECT_TRUE(verdict) << to_text(r.errors);
    return verdict.value_or(Verdict{});
  };
  const Verdict open = hooks("", "");
  EXPECT_EQ(to_text(open.kind), "not_judged");
  EXPECT_NE(open.reason.find("turn both ways"), std::string::npos) << open.reason;
  EXPECT_TRUE(passes(hooks(", side: left", ", side: right"))) << "it is meant so";
  const Verdict both = hooks(", side: left", ", side: left");
  EXPECT_EQ(to_text(both.kind), "fails") << "2 x 2 t at 0.2 m are 7.8 kN m";
}

/// A car of 3 x 1 t and its counterweight of 1 t leave one drum on opposite sides: one runs off as the other comes in.
TEST(DriveUses, ACounterweightOnTheSameDrumRunsOff) {
  const auto lift = [](const std::string& haul) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
  bodies: {car: {mass: 3 t, at: [-0.5 m, 0 m, 2 m], free: [z]}, cwt: {mass: 1 t, at: [0.5 m, 0 m, 2 m], free: [z]}}
  drums: {w: {at: [0 m, 0 m, 20 m], core_diameter: 1 m, brake_torque: 10.1 kN m}}
  reevings:
    - {rope: r, name: up, path: [{drum: w, side: left}, {anchor: car}], length: 18 m}
    - {rope: r, name: down, path: [{drum: w, side: right}, {anchor: cwt}], length: 18 m)" +
                    haul + R"(}
analyses: [equilibrium: {}]
checks: {ropes: {up: {safety_factor: 4}, down: {safety_factor: 4}}}
)");
  };
  const Result open = lift("");
  ASSERT_FALSE(open.unmade.empty()) << open.message << to_text(open.errors);
  EXPECT_NE(open.unmade[0].find("where 'down' runs off while 'up' is hauled in"), std::string::npos) << open.unmade[0];
  EXPECT_NE(open.unmade[0].find("give 'down' 'haul: to_end'"), std::string::npos) << open.unmade[0];
  const Result told = lift(", haul: to_end");
  EXPECT_TRUE(told.unmade.empty()) << told.unmade.front();
  EXPECT_NEAR(taut_test::check_of(told, "w.brake_torque").value, (3e3 - 1e3) * 9.80665 * 0.5, 10);
}

/// A rope with both ends on one drum would run through from one to the other, though the drum takes both in.
TEST(DriveUses, ARopeWithBothEndsOnADrumIsNotJudged) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 180 kN}}
  bodies: {hook: {mass: 4 t, at: [0 m, 0 m, 3 m], free: [z]}}
  sheaves: {block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 1.2 m, efficiency: 0.95, axis: [0, 1, 0]}}
  drums: {w: {at: [0 m, -0.6 m, 20 m], axis: [1, 0, 0], core_diameter: 384 mm}}
  reevings: [{rope: hoist, path: [{drum: w, side: left}, {over: block}, {drum: w, side: right}], length: 35 m}]
analyses: [equilibrium: {motion: hoist}]
checks: {ropes: {hoist: {safety_factor: 3}}}
)");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_EQ(to_text(verdict_of(r)->kind), "not_judged") << verdict_of(r)->reason;
}

/// Losses of sheaves help what lowers: 5 % at each of two.
TEST(DriveUses, ARopeThatIsOnlyLoweredIsNotJudged) {
  const auto hoist = [](const std::string& analyses) {
    return run_text(R"(taut: 1
machine:
  points: {pin: [-0.4 m, 0 m, 20 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 13 MN, breaking_force: 100 kN}}
  bodies: {hook: {mass: 4 t, at: [0 m, 0 m, 3 m], free: [z]}}
  sheaves: {block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.9}}
  drums: {w: {at: [0.4 m, 0 m, 20 m], core_diameter: 400 mm}}
  reevings: [{rope: hoist, path: [{drum: w}, {over: block}, {anchor: pin}], length: 35 m}]
checks: {ropes: {hoist: {safety_factor: 3}}}
analyses: [)" + analyses +
                    "]\n");
  };
  const Result lowered = hoist("equilibrium: {motion: lower}");
  ASSERT_TRUE(verdict_of(lowered)) << lowered.message << to_text(lowered.errors);
  EXPECT_EQ(to_text(verdict_of(lowered)->kind), "not_judged") << verdict_of(lowered)->reason;
  EXPECT_NE(verdict_of(lowered)->reason.find("only while it runs off 'w'"), std::string::npos);
  EXPECT_EQ(to_text(verdict_of(hoist("equilibrium: {motion: hoist}"))->kind), "passes");
  EXPECT_EQ(to_text(verdict_of(hoist("equilibrium: {motion: lower}, equilibrium: {}"))->kind), "passes");
  // written as senses of contacts: a drum at the start of the path takes in against it
  EXPECT_EQ(to_text(verdict_of(hoist("equilibrium: {motion: {block: 1}}"))->kind), "not_judged");
  EXPECT_EQ(to_text(verdict_of(hoist("equilibrium: {motion: {block: -1}}"))->kind), "passes");
}

// W = 196 kN on four parts of 0.97: hauled in W/(0.97 + 0.97^2 + 0.97^3 + 0.97^4) = 52.88 kN, 260/52.88 = 4.92.
// Lowered, the largest has W/(1 + 0.97 + 0.97^2 + 0.97^3) = 51.30 kN, 5.07, which passed.
TEST(DriveUses, AMotionThatOnlyLowersDoesNotShowTheRopeHauledIn) {
  const auto moved = [](const std::string& speed, const std::string& limit, const std::string& more) {
    return run_text(R"(taut: 1
machine:
  signals: {run: {table: {t: [0 s, 0.2 s, 1.2 s, 2 s, 3 s], value: [0 m/s, 0 m/s, )" +
                    speed + ", " + speed + R"(, 0 m/s]}}}
  points: {pin: [-0.2 m, 0 m, 20 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 30 MN, breaking_force: 260 kN, damping_ratio: 0.3}}
  bodies: {hook: {mass: 20 t, at: [0 m, 0 m, 6 m], free: [x, z]}}
  sheaves:
    head: {at: [0 m, 0 m, 20 m], diameter: 400 mm, efficiency: 0.97}
    block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.97}
  drums: {winch: {at: [-9 m, 0 m, 20 m], core_diameter: 380 mm, inertia: 400 kg m^2, drive: {speed: run}}}
  reevings:
    - {rope: hoist, path: [{drum: winch}, {over: head, parts: 4, between: [head, block]}, {anchor: pin}], length: 67.2 m}
checks: {ropes: {hoist: {)" +
                    limit +
                    R"(}}}
analyses:
  - transient: {duration: 8 s, tolerance: 1e-4}
)" + more);
  };
  const Result lowered = moved("-0.2 m/s", "safety_factor: 5", "");
  EXPECT_EQ(to_text(verdict_of(lowered)->kind), "not_judged") << verdict_of(lowered)->reason;
  EXPECT_NE(verdict_of(lowered)->reason.find("only while it runs off 'winch'"), std::string::npos);
  EXPECT_EQ(to_text(verdict_of(moved("-0.2 m/s", "safety_factor: 5", "  - equilibrium: {motion: hoist}\n"))->kind),
            "fails");
  // the peak of a motion is that motion's alone
  const Result peak = moved("-0.2 m/s", "dynamic_safety_factor: 3", "");
  EXPECT_EQ(to_text(verdict_of(peak)->kind), "passes") << verdict_of(peak)->reason;
  const Result raised = moved("0.2 m/s", "safety_factor: 3", "");
  EXPECT_EQ(to_text(verdict_of(raised)->kind), "passes") << verdict_of(raised)->reason;
}

/// A saw whose rope runs along its path with 'motion: in'. Its wheels hold it with 16 kN in all; the tail takes
/// (1 - 0.97)/(1 + 0.97) of that, and its mean tension is 8 kN: about 0.24 kN, or 85 N m at the drive's rim.
std::string saw(const std::string& motor, const std::string& load, const std::string& motion) {
  return R"(taut: 1
machine:
  ropes: {saw: {mass: 0.6 kg/m, stiffness: 6.5 MN, diameter: 12 mm, breaking_force: 100 kN}}
  bodies: {slide: {mass: 85 kg, at: [0 m, 0 m, 1 m], free: [x]}}
  sheaves:
    drive: {at: [8 m, 0 m, 1 m], diameter: 700 mm, friction: 0.5, motor: {)" +
         motor + R"(}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 700 mm, efficiency: 0.97}
  reevings:
    - {rope: saw, path: [{over: drive, side: left}, {over: tail, side: left}], closed: true, length: 18.19 m}
  take_up: [{body: slide, screw: 16 kN, keeps: force, along: [-1, 0, 0]}]
  rope_loads: [{name: cut, rope: saw, between: [tail, drive], )" +
         load + R"(}]
analyses: [)" +
         motion + R"(]
checks: {ropes: {saw: {safety_factor: 5}}}
)";
}

/// What the verdict says of a saw whose rope runs in these senses.
Verdict verdict_of_saw(const std::string& motor, const std::string& load, const std::string& motion) {
  const Result r = run_text(saw(motor, load, motion));
  const auto verdict = verdict_of(r);
  EXPECT_TRUE(verdict) << to_text(r.errors);
  return verdict.value_or(Verdict{});
}

constexpr const char* in = "equilibrium: {name: saws, motion: in}";
constexpr const char* out = "equilibrium: {name: back, motion: out}";

TEST(DriveUses, AnUnknownLoadDoesNotDrawTheRope) {
  const std::string cut = "direction: against_motion";
  EXPECT_TRUE(passes(verdict_of_saw("torque: 1.9 kN m", cut, in)));
  EXPECT_TRUE(passes(verdict_of_saw("torque: 100 N m", cut, in)));
  for (const char* const torque : {"torque: 20 N m", "torque: 70 N m", "torque: -200 N m"}) {
    const Verdict weak = verdict_of_saw(torque, cut, in);
    EXPECT_EQ(to_text(weak.kind), "not_judged") << torque;
    EXPECT_NE(weak.reason.find("'cut' would have to draw the rope"), std::string::npos) << weak.reason;
  }
  EXPECT_TRUE(passes(verdict_of_saw("torque: -1.9 kN m", cut, out)));
}

TEST(DriveUses, AMotorDrivesInTheSenseOfItsTorque) {
  const std::string cut = "tangential: 5 kN, direction: against_motion";
  EXPECT_TRUE(passes(verdict_of_saw("torque: 1.9 kN m", cut, in)));
  EXPECT_EQ(to_text(verdict_of_saw("torque: 1.8 kN m", cut, in).kind), "fails") << "5 kN at 0.35 m, and the tail";
  const Verdict wrong = verdict_of_saw("torque: -1.9 kN m", cut, in);
  EXPECT_EQ(to_text(wrong.kind), "not_judged");
  EXPECT_NE(wrong.reason.find("needs one along it"), std::string::npos) << wrong.reason;
  EXPECT_TRUE(passes(verdict_of_saw("torque: -1.9 kN m", cut, out)));
}

/// The sense of a motion has to be that of the motor's speed, in one of the states.
TEST(DriveUses, ARopeRunsAsItsMotorTurns) {
  const std::string cut = "tangential: 5 kN, direction: against_motion";
  EXPECT_TRUE(passes(verdict_of_saw("speed: 20 m/s", cut, in)));
  const Verdict back = verdict_of_saw("speed: -20 m/s", cut, in);
  EXPECT_EQ(to_text(back.kind), "not_judged");
  EXPECT_NE(back.reason.find("judged only while it runs along its path"), std::string::npos) << back.reason;
  EXPECT_TRUE(passes(verdict_of_saw("speed: -20 m/s", cut, out)));
  EXPECT_TRUE(passes(verdict_of_saw("speed: 20 m/s", cut, std::string(in) + ", " + out)));
}

}  // namespace taut::drive_senses_test
