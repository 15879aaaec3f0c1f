#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "test/support/machine_decks.hpp"

namespace taut::checks::carrying_mast_test {

using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::run_text;

/// A load on a rope over a head sheave on a mast of 10 m, pulled by a winch behind; the mast stands in `checks`.
std::string derrick(const std::string& mast, const std::string& analyses = "  - equilibrium: {motion: at_rest}\n",
                    const std::string& more = "") {
  return R"(taut: 1
machine:
  ropes: {hoist: {mass: 0 kg/m, stiffness: 2 MN, breaking_force: 200 kN}}
  points: {winch: [-10 m, 0 m, 0 m]}
  bodies: {load: {mass: 2 t, at: [0.2 m, 0 m, 5 m], free: [z]}}
  sheaves: {head: {at: [0 m, 0 m, 10 m], diameter: 400 mm, efficiency: 1}}
  reevings: [{rope: hoist, path: [{anchor: winch}, {over: head}, {anchor: load}], length: 19.3 m}]
)" + more +
         "analyses:\n" + analyses + "checks:\n  masts:\n" + mast;
}

constexpr const char* tube = "section: CHS 219.1x8, steel: S355, height: 10 m, sway: 0, bow: 0, load_factor: 1.35";

// By hand: T = 2 t x g; the rope to the winch leaves the sheave at 45 degrees and a bit.
TEST(CarryingMast, forces_of_its_ropes) {
  const Result r = run_text(derrick(std::string("    mast: {") + tube + ", carries: [head]}\n"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double T = 2000 * 9.80665;
  const double slope = std::atan2(10, 10) + std::asin(0.2 / std::hypot(10, 10));
  const double across = -T * std::cos(slope), down = T * (1 + std::sin(slope));
  const Result own = run_text(
      "taut: 1\nmethod: mast_section\ninput: {skyline_force: 1 kN, mainline_force: 1 kN, skyline_block_height: 10 m, "
      "branch_angle: 12 deg, allowable_stress: 160 MPa}\nchecks:\n  masts:\n    mast: {" +
      std::string(tube) + fmt::format(", loads: [{{down: {:.9g} N, across: {:.9g} N}}]}}\n", down, across));
  ASSERT_EQ(own.status, Status::ok) << own.message << to_text(own.errors);
  for (const char* name : {"mast.section", "mast.member", "mast.buckling", "mast.shear"}) {
    EXPECT_NEAR(check_of(r, name).value / check_of(own, name).value, 1, 1e-6) << name;
  }
  // turned by a quarter and with its foot aside: bends by the weight's arm about the other axis
  const Result aside = run_text(
      derrick(std::string("    mast: {") + tube + ", carries: [head], foot: [0 m, -0.3 m, 0 m], towards: [0, 1]}\n"));
  EXPECT_GT(check_of(aside, "mast.section").value, check_of(r, "mast.section").value);
}

// The sheave stands 0.3 m aside of the axis: what pulls it towards the winch turns the mast by T cos(slope) 0.3 m. On
// the other side it turns the other way. The load of the deck that turns it back leaves nothing.
TEST(CarryingMast, a_pull_beside_its_axis_turns_it) {
  const double slope = std::atan2(10, 10) + std::asin(0.2 / std::hypot(10, 10));
  const double turns = 2000 * 9.80665 * std::cos(slope) * 0.3;
  const double T_Rd = 2 * std::acos(-1.0) / 4 * std::pow(0.2111, 2) * 8e-3 * 355e6 / std::sqrt(3.0);
  const auto with = [&](const std::string& foot, const std::string& more) {
    return run_text(derrick(std::string("    mast: {") + tube + ", carries: [head], foot: " + foot + more + "}\n"));
  };
  for (const char* foot : {"[0 m, -0.3 m, 0 m]", "[0 m, 0.3 m, 0 m]"}) {
    EXPECT_NEAR(check_of(with(foot, ""), "mast.torsion").value / (1.35 * turns / T_Rd), 1, 1e-4) << foot;
    EXPECT_NEAR(check_of(with(foot, ", towards: [1, 2]"), "mast.torsion").value / (1.35 * turns / T_Rd), 1, 1e-4);
  }
  const Result straight = with("[0 m, 0 m, 0 m]", "");
  EXPECT_EQ(std::find_if(straight.checks.begin(), straight.checks.end(),
                         [](const Check& c) { return c.name == "mast.torsion"; }),
            straight.checks.end());
  // the head pulls by -x at y = 0.3 m from the foot: upwards positive
  const std::string back = fmt::format(", loads: [{{torsion: {:.4g} N m}}]", -turns);
  EXPECT_LT(check_of(with("[0 m, -0.3 m, 0 m]", back), "mast.torsion").value, 1e-4);
}

// Dropped from its natural length: twice the force at rest (and a bit, as the rope between has no mass), at its moment.
TEST(CarryingMast, a_motion_presses_it) {
  const std::string motion =
      "  - transient: {name: drop, duration: 0.6 s, output_step: 1 ms, start: assembled, damping_ratio: 0}\n";
  const double wrap = std::acos(-1.0) / 2 + std::atan2(10, 10) + std::asin(0.2 / std::hypot(10, 10));
  const double natural = std::sqrt(200 - 0.04) + 0.2 * wrap + 5;
  const std::string mast = std::string("    mast: {") + tube + ", dynamic_factor: 1.5, carries: [head]}\n";
  const Result r = run_text(derrick(mast, motion), {fmt::format("machine.reevings[0].length={:.12g} m", natural)});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NE(check_of(r, "mast.section").rule.find("drop, t = "), std::string::npos);
  const Result rest = run_text(derrick(mast), {"checks.masts.mast.dynamic_factor=2"});
  EXPECT_NEAR(check_of(r, "mast.buckling").value / check_of(rest, "mast.buckling").value, 1, 0.01);
  // combinations name analyses, and loads of the deck come besides
  const Result both = run_text(
      derrick("    mast: {section: CHS 219.1x8, steel: S355, height: 10 m, carries: [head], loads: [{case: dead, down: "
              "20 kN}], combinations: {ULS: {dead: 1.35, drop: 1.5}}}\n",
              motion));
  ASSERT_EQ(both.status, Status::ok) << both.message << to_text(both.errors);
  EXPECT_NE(check_of(both, "mast.section").rule.find("ULS: transient, drop, t = "), std::string::npos);
}

TEST(CarryingMast, mistakes) {
  const auto mast = [](const std::string& rest) {
    return run_text(derrick("    mast: {section: CHS 219.1x8, steel: S355" + rest + "}\n"));
  };
  expect_mistake(mast(", height: 10 m, carries: [haed]"), "did you mean 'head'");
  expect_mistake(mast(", carries: [head]"), "needs 'height'");
  expect_mistake(mast(", height: 9 m, carries: [head]"), "10 m above the mast's foot");
  expect_mistake(mast(", height: 10 m, carries: [head], towards: [0, 0]"), "horizontal direction");
  expect_mistake(mast(", height: 10 m, carries: [head], combinations: {a: {equilibrum: 1.5}}"),
                 "did you mean 'equilibrium'");
  expect_mistake(run_text(derrick("    mast: {section: CHS 219.1x8, steel: S355, height: 10 m, carries: [head], "
                                  "combinations: {ULS: {a: 1, b: 1}}}\n",
                                  "  - equilibrium: {name: a}\n  - equilibrium: {name: b}\n")),
                 "takes one analysis");
  expect_mistake(mast(", height: 10 m"), "'carries'");
  expect_mistake(mast(", height: 10 m, loads: [{down: 1 kN}], foot: [0 m, 0 m, 1 m]"), "foot: belongs to a mast that");
  expect_mistake(mast(", height: 10 m, loads: [{down: 1 kN}], towards: [0, 1]"), "towards: belongs to a mast that");
}

// A load without 'case' is of the case 'work': its name may be that of the analysis too.
TEST(CarryingMast, a_name_of_a_load_and_of_an_analysis_means_both) {
  const auto spar = [](const std::string& load, const std::string& terms) {
    return run_text(derrick("    mast: {section: CHS 219.1x8, steel: S355, height: 10 m, carries: [head], loads: [{" +
                                load + "at: 6 m, sideways: 1 kN}], combinations: {ULS: {" + terms + "}}}\n",
                            "  - equilibrium: {name: work, motion: at_rest}\n"));
  };
  const Result both = spar("", "work: 1.5"), apart = spar("case: wind, ", "wind: 1.5, work: 1.5");
  ASSERT_EQ(both.status, Status::ok) << both.message << to_text(both.errors);
  for (const char* name : {"mast.section", "mast.member", "mast.buckling", "mast.shear"}) {
    EXPECT_DOUBLE_EQ(check_of(both, name).value, check_of(apart, name).value) << name;
  }
  EXPECT_GT(check_of(both, "mast.section").value, 1);  // 1.5 19.6 kN cos(46 deg) 10 m
  EXPECT_EQ(both.unjudged.size(), 1U);                 // the rope has no limit
  expect_mistake(run_text(derrick("    mast: {section: CHS 219.1x8, steel: S355, height: 10 m, carries: [head], "
                                  "own_weight: true, combinations: {ULS: {own_weight: 1.5}}}\n",
                                  "  - equilibrium: {name: own_weight}\n")),
                 "give the analysis another name");
}

// A line over a head sheave that nothing loads but its own weight: as put up it pulls as in the equilibrium.
TEST(CarryingMast, a_line_as_it_is_put_up_counts_in_every_combination) {
  const auto spar = [](const std::string& combinations, const std::string& analyses) {
    return run_text(R"(taut: 1
machine:
  temperature: 15 degC
  ropes: {sky: {mass: 2 kg/m, stiffness: 25 MN, breaking_force: 400 kN}}
  points: {stump: [-12 m, 0 m, 0 m], tail: [200 m, 0 m, -30 m]}
  sheaves: {head: {at: [0 m, 0 m, 9 m], diameter: 600 mm, efficiency: 1}}
  reevings: [{name: skyline, rope: sky, path: [{anchor: stump}, {over: head}, {anchor: tail}], install: {tension: 40 kN}}]
analyses: [)" + analyses +
                    R"(]
checks:
  ropes: {skyline: {safety_factor: 2.5}}
  masts: {spar: {section: CHS 323.9x12.5, steel: S355, height: 9 m, carries: [head], combinations: {)" +
                    combinations + "}}}\n");
  };
  const std::string rest = "{equilibrium: {name: work, motion: at_rest}}";
  const Result plain = spar("ULS: {work: 1.35}", rest);
  ASSERT_EQ(plain.status, Status::ok) << plain.message << to_text(plain.errors);
  EXPECT_TRUE(plain.unjudged.empty());
  const auto rule = [](const Result& r) { return check_of(r, "spar.section").rule; };
  const auto use = [](const Result& r) { return check_of(r, "spar.section").value; };
  const Result named = spar("ULS: {work: 1.35}, UP: {installation: 1.5}", rest);
  EXPECT_NE(rule(named).find("UP: skyline as put up"), std::string::npos) << rule(named) << to_text(named.errors);
  EXPECT_GT(use(named), use(plain));
  EXPECT_DOUBLE_EQ(use(named), use(spar("ULS: {work: 1.35}, UP: {work: 1.5}", rest)));
  // an analysis of that kind has a name of its own
  const std::string days = rest + ", {installation: {name: days, reeving: skyline, temperatures: [15 degC]}}";
  const Result unsaid = spar("ULS: {work: 1.35}", days);
  ASSERT_EQ(unsaid.unjudged.size(), 1U) << to_text(unsaid.errors);
  EXPECT_NE(unsaid.unjudged[0].find("spar in 'days', which none of its combinations names: add {days: its factor}"),
            std::string::npos)
      << unsaid.unjudged[0];
  EXPECT_TRUE(spar("ULS: {work: 1.35}, D: {days: 1.35}", days).unjudged.empty());
}

// The place of rest of 'modes' is a state of its own.
TEST(CarryingMast, modes_may_be_named) {
  const auto spar = [](const std::string& more) {
    return run_text(
        derrick("    mast: {section: CHS 219.1x8, steel: S355, height: 10 m, carries: [head], combinations: "
                "{ULS: {work: 1.5}" +
                    more + "}}\n",
                "  - equilibrium: {name: work, motion: at_rest}\n  - modes: {}\n"));
  };
  EXPECT_EQ(spar("").unjudged.size(), 2U);  // the rope has no limit
  const Result named = spar(", M: {modes: 1.5}");
  ASSERT_EQ(named.status, Status::ok) << named.message << to_text(named.errors);
  EXPECT_EQ(named.unjudged.size(), 1U);
}

// The machine's gravity weighs the mast too: without load factors, mass times length times g.
TEST(CarryingMast, its_own_weight_is_that_of_the_machine) {
  const auto N = [](const std::string& gravity, const std::string& own) {
    const Result r = run_text(derrick(std::string("    mast: {") + tube + ", carries: [head]" + own + "}\n"),
                              {"machine.gravity=" + gravity});
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return check_of(r, "mast.buckling").value;
  };
  const auto share = [&](const std::string& gravity) { return N(gravity, ", own_weight: true") - N(gravity, ""); };
  EXPECT_NEAR(share("20 m/s^2") / share("10 m/s^2"), 2, 0.02);
}

/// A spar with a held top: the pull at its middle bends it, that at its head does not. No place of a path is worse than
/// the path.
TEST(CarryingMast, no_place_of_a_path_is_worse_than_the_path) {
  const auto spar = [](const std::string& last, const std::string& steps) {
    return run_text(R"(taut: 1
machine:
  ropes:
    sky: {mass: 2 kg/m, stiffness: 30 MN, breaking_force: 1500 kN}
    main: {mass: 0.8 kg/m, stiffness: 12 MN, breaking_force: 600 kN}
  points: {back: [-0.2 m, 0 m, 0 m], tail: [200 m, 0 m, -30 m], block: [0 m, 0 m, 6 m]}
  supports: {head: {at: [0 m, 0 m, 12 m], diameter: 400 mm}}
  carriages: {car: {rides: skyline, mass: 5.6 t, mainline: mainline}}
  reevings:
    - {rope: sky, name: skyline, path: [{anchor: back}, {over: head}, {through: car}, {anchor: tail}], length: 217.7 m}
    - {rope: main, name: mainline, path: [{anchor: block}, {anchor: car}], length: 100 m}
analyses: [{load_path: {carriage: car, from: 28 m, to: )" +
                    last + ", steps: " + steps + R"(}}]
checks:
  masts:
    spar: {carries: [head, block], foot: [0 m, 0 m, 0 m], towards: [1, 0], height: 12 m, section: CHS 273x6.3, steel: S355, base: hinge, top_stiffness: .inf, load_factor: 1.35}
)");
  };
  const double path = check_of(spar("178 m", "25"), "spar.member").value;
  EXPECT_GE(path, check_of(spar("28.01 m", "1"), "spar.member").value - 1e-3);
  EXPECT_GT(path, 1.05);
}

/// A mast of 10 m whose head and middle are pulled by masses on guides: across at both places, and down at its head.
/// Each pull is a list of steps of a signal.
Result pulled(const std::string& head, const std::string& middle, const std::string& down, const std::string& mast,
              const std::string& analyses) {
  const auto signal = [](const std::string& steps) { return "{sequence: [" + steps + "]}"; };
  return run_text(R"(taut: 1
machine:
  gravity: 9.81 m/s^2
  signals:
    across: )" + signal(head) +
                  "\n    beside: " + signal(middle) + "\n    down: " + signal(down) + R"(
  points: {head: [0 m, 0 m, 10 m], middle: [0 m, 0 m, 5 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 100 MN, breaking_force: 6 MN, damping_ratio: 0.2}}
  bodies:
    a: {mass: 500 kg, at: [10 m, 0 m, 10 m], guide: [1, 0, 0]}
    b: {mass: 500 kg, at: [10 m, 0 m, 5 m], guide: [1, 0, 0]}
    c: {mass: 200 kg, at: [0 m, 0 m, 2 m], guide: [0, 0, 1]}
  reevings:
    - {name: ra, rope: r, path: [{anchor: head}, {anchor: a}], length: 9.99 m}
    - {name: rb, rope: r, path: [{anchor: middle}, {anchor: b}], length: 9.99 m}
    - {name: rc, rope: r, path: [{anchor: head}, {anchor: c}], length: 8 m}
  loads:
    - {at: a, force: [0.5 kN, 0 kN, 0 kN], signal: across}
    - {at: b, force: [0.5 kN, 0 kN, 0 kN], signal: beside}
    - {at: c, force: [0 kN, 0 kN, -0.5 kN], signal: down}
checks:
  ropes: {r: {safety_factor: 3}}
  masts:
    mast: {height: 10 m, foot: [0 m, 0 m, 0 m], steel: S355, towards: [1, 0], )" +
                  mast + "}\nanalyses: [{transient: {tolerance: 1e-3, start: settled, " + analyses + "}}]\n");
}
std::string step(double at, const char* to) {
  return fmt::format("{{at: {} s, to: {}, over: 0.8 s, smooth: true}}", at, to);
}
constexpr const char* little = "{at: 0 s, to: 0.5 kN, over: 0.1 s}";

// Held at its head, which 40 kN pull first: that bends it nowhere. Then 60 kN in its middle, by hand
// 1.35 P l/4 = 202.5 kN m over W_pl f_y = 357 cm^3 355 MPa. 700 moments.
TEST(CarryingMast, every_moment_of_a_motion_counts_where_its_top_is_held) {
  const std::string mast =
      "section: CHS 219.1x8, base: hinge, top_stiffness: .inf, sway: 0, bow: 0, load_factor: 1.35, carries: [head, "
      "middle]";
  const std::string top = step(1, "40 kN") + ", " + step(2, "0.5 kN"), mid = step(4, "60 kN") + ", " + step(5, "1 kN");
  const Result r = pulled(top, mid, little, mast, "duration: 7 s, output_step: 10 ms");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(check_of(r, "mast.section").value, 1.35 * 60e3 * 10 / 4 / (357e-6 * 355e6), 0.02);
  EXPECT_NE(check_of(r, "mast.section").rule.find("t = 4."), std::string::npos) << check_of(r, "mast.section").rule;
  // the same motion in less moments
  const Result few = pulled(top, mid, little, mast, "duration: 7 s, output_step: 50 ms");
  EXPECT_NEAR(check_of(r, "mast.section").value, check_of(few, "mast.section").value, 1e-3);
}

// Pressed alone, bent alone, then a little less of both together, which is the worst.
TEST(CarryingMast, force_and_moment_together_count_where_each_alone_is_larger) {
  const std::string mast = "section: CHS 323.9x12.5, load_factor: 1.05, carries: [head]";
  const std::string down = step(1, "400 kN") + ", " + step(2, "1 kN"),
                    across = step(4, "34 kN") + ", " + step(5, "1 kN");
  const auto run = [&](const char* N, const char* M, const std::string& more) {
    return pulled(across + ", " + step(7, M), little, down + ", " + step(7, N), mast, more);
  };
  const Result apart = run("1 kN", "1 kN", "output_step: 12 ms, duration: 9 s");
  ASSERT_EQ(apart.status, Status::ok) << apart.message << to_text(apart.errors);
  EXPECT_LT(check_of(apart, "mast.section").value, 0.9);
  EXPECT_LT(check_of(apart, "mast.member").value, 0.9);
  const Result both = run("350 kN", "29 kN", "output_step: 12 ms, duration: 9 s");
  EXPECT_NEAR(check_of(both, "mast.section").value, 1.32, 0.03);
  EXPECT_NEAR(check_of(both, "mast.member").value, 1.44, 0.03);
}

// The lightest section that passes, passes in its own run too, by every moment.
TEST(CarryingMast, a_chosen_section_passes_every_moment) {
  const std::string down = step(1, "400 kN") + ", " + step(2, "1 kN") + ", " + step(7, "350 kN");
  const std::string across = step(4, "34 kN") + ", " + step(5, "1 kN") + ", " + step(7, "29 kN");
  const auto run = [&](const std::string& section) {
    return pulled(across, little, down, "load_factor: 1.05, carries: [head], section: " + section,
                  "output_step: 14 ms, duration: 8 s");
  };
  const Result r = run("CHS 323.9x12.5, choose: {shape: chs}");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto table =
      std::find_if(r.tables.begin(), r.tables.end(), [](const auto& t) { return t.name == "mast_sections"; });
  ASSERT_NE(table, r.tables.end());
  const std::string chosen = std::get<std::string>(table->rows.front()[1]);
  const Result own = run(chosen);
  for (const Check& c : own.checks) EXPECT_TRUE(c.passes) << chosen << ": " << c.name << " " << c.value;
}

}  // namespace taut::checks::carrying_mast_test
