#include "taut/checks/checked_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/verdict.hpp"
#include "test/paths.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::checked_parts_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::run_text;
using taut_test::skyline_deck;
using taut_test::table_of;

constexpr const char* anchors_and_lines =
    "checks:\n"
    "  anchors: {stump: {strength: 300 kN}, tower: {strength: 300 kN}}\n"
    "  lines: {skyline: {break_angles: true}}\n";

// The envelope's own table says the same extremes, and where.
TEST(CheckedParts, every_state_of_an_envelope) {
  const Result r = run_text(skyline_deck("  - envelope: {carriage: car, from: 140 m, to: 220 m, steps: 4, loads: [0.5 "
                                         "t, 2 t], motions: [in, out]}\n") +
                            anchors_and_lines);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "envelope");
  const auto largest = [&](const std::string& name, const std::string& what) {
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      if (taut_test::text_cell(t, i, "name") == name && taut_test::text_cell(t, i, "quantity") == what) {
        return cell(t, i, "max");
      }
    }
    return std::nan("");
  };
  const double pull = largest("skyline on stump", "resultant");
  EXPECT_NEAR(check_of(r, "stump.anchor_strength").value * pull / 300e3, 1, 1e-9);
  EXPECT_NE(check_of(r, "stump.anchor_strength").rule.find("envelope, "), std::string::npos);
  EXPECT_NE(check_of(r, "stump.anchor_strength").rule.find("2000 kg"), std::string::npos);
  const Table& angles = table_of(r, "envelope_angles");
  double wrap = 0;
  for (std::size_t i = 0; i < angles.rows.size(); ++i) {
    if (taut_test::text_cell(angles, i, "name") == "skyline on jack1") wrap = cell(angles, i, "max");
  }
  EXPECT_GT(wrap, 0);
  EXPECT_NEAR(check_of(r, "skyline.jack1.break_angle").value, wrap, 1e-9);
}

TEST(CheckedParts, a_cycle_is_a_load_case_and_a_sweep_is_none) {
  const Result r = run_text(
      skyline_deck("  - cycle: {carriage: car, from: 140 m, to: 220 m, steps: 4, phases: [{name: home, load: 2 t, "
                   "motion: in}]}\n") +
      anchors_and_lines);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NE(check_of(r, "stump.anchor_strength").rule.find("cycle, home, x = "), std::string::npos);
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), by);
}

void expect_same_checks(const Result& a, const Result& b) {
  ASSERT_EQ(a.status, Status::ok) << a.message << to_text(a.errors);
  ASSERT_EQ(b.status, Status::ok) << b.message << to_text(b.errors);
  ASSERT_EQ(a.checks.size(), b.checks.size());
  for (const Check& one : a.checks) {
    const Check& other = check_of(b, one.name);
    EXPECT_NEAR(other.value, one.value, 1e-6 * std::max(1.0, std::abs(one.value))) << one.name;
    EXPECT_NEAR(other.limit, one.limit, 1e-9 * std::abs(one.limit)) << one.name;
  }
}

// Ends of the ropes swapped, the machine mirrored, entries in another order: the same checks.
TEST(CheckedParts, the_same_machine_written_otherwise) {
  const std::string checks =
      "checks:\n"
      "  ropes: {skyline: {field: skyline.ch}, mainline: {safety_factor: 3, dynamic_factor: 1.3}}\n"
      "  anchors: {stump: {strength: 300 kN, uplift: 50 kN, angle: 30 deg, tree_diameter: 60 cm}, tower: {strength: "
      "300 "
      "kN}}\n"
      "  lines: {skyline: {tail_tree: jack1, break_angles: true, end_masts: [jack2], clearance: true}}\n";
  const std::string plain = skyline_deck(
                                "  - envelope: {carriage: car, from: 130 m, to: 220 m, steps: 3, loads: [0 t, 2 "
                                "t], motions: [in, out]}\n") +
                            checks;
  const Result original = run_text(plain);
  std::string swapped = plain;
  replace(swapped, "path: [{anchor: stump}, {over: jack1}, {through: car}, {over: jack2}, {anchor: tower}]",
          "path: [{anchor: tower}, {over: jack2}, {through: car}, {over: jack1}, {anchor: stump}]");
  replace(swapped, "path: [{drum: winch}, {anchor: car}]", "path: [{anchor: car}, {drum: winch}]");
  expect_same_checks(original, run_text(swapped));
  std::string mirrored = plain;
  replace(mirrored, "tower: [360 m, 0 m, 124 m]", "tower: [-360 m, 0 m, 124 m]");
  replace(mirrored, "jack1: {at: [110 m", "jack1: {at: [-110 m");
  replace(mirrored, "jack2: {at: [240 m", "jack2: {at: [-240 m");
  replace(mirrored, "winch: {at: [362 m", "winch: {at: [-362 m");
  replace(mirrored, "{x: [0 m, 110 m, 170 m, 240 m, 360 m], z: [-4 m, 22 m, 34 m, 66 m, 106 m]}",
          "{x: [-360 m, -240 m, -170 m, -110 m, 0 m], z: [106 m, 66 m, 34 m, 22 m, -4 m]}");
  replace(mirrored, "from: 130 m, to: 220 m", "from: -13000 cm, to: -0.22 km");
  replace(mirrored, "loads: [0 t, 2 t]", "loads: [2000 kg, 0 t]");
  expect_same_checks(original, run_text(mirrored));
}

/// The yarder of the examples with its analyses in another block.
std::string yarder(const std::string& analyses) {
  const auto job = app::read_job((taut_test::source_dir() / "examples/design/yarder_mast.yaml").string());
  EXPECT_TRUE(job.has_value());
  std::string text = job->text;
  const auto from = text.find("  - load_path:");
  text.replace(from, text.find('\n', from) + 1 - from, analyses);
  return text;
}

// The same states as an envelope, a load path or a cycle: the same mast.
TEST(CheckedParts, a_mast_over_an_envelope_and_a_cycle) {
  const std::string home = "{return: 1, traction: -1}";
  const std::string path = "  - load_path: {name: inhaul, carriage: car, from: 170 m, to: 30 m, steps: 7, motion: ";
  const auto expect_same = [&](const std::string& one, const std::string& other) {
    const Result a = run_text(yarder(one)), b = run_text(yarder(other));
    ASSERT_EQ(a.status, Status::ok) << a.message << to_text(a.errors);
    ASSERT_EQ(b.status, Status::ok) << b.message << to_text(b.errors);
    for (const char* name : {"mast.section", "mast.shear", "mast.allowable_stress", "guy1.guy_safety", "guy2.slackness",
                             "stump1.anchor_strength", "mast.top_stiffness"}) {
      EXPECT_NEAR(check_of(b, name).value / check_of(a, name).value, 1, 1e-6) << name << other;
    }
  };
  expect_same(path + "in}\n",
              "  - envelope: {name: inhaul, carriage: car, from: 30 m, to: 170 m, steps: 7, motions: [in]}\n");
  expect_same(
      path + home + "}\n",
      "  - cycle: {name: inhaul, carriage: car, from: 170 m, to: 30 m, steps: 7, phases: [{name: home, load: 0 kg, "
      "motion: " +
          home + "}]}\n");
}

TEST(CheckedParts, the_plate_of_a_spar) {
  const std::string path =
      "  - load_path: {name: inhaul, carriage: car, from: 30 m, to: 100 m, steps: 1, motion: in}\n";
  const Result r = run_text(yarder(path), {"checks.masts.mast.plate={guys: 3, guy_strength: 200 kN}"});
  EXPECT_EQ(check_of(r, "mast.guys_by_plate").value, 2);
  EXPECT_FALSE(check_of(r, "mast.guys_by_plate").passes);
  EXPECT_TRUE(check_of(r, "mast.guy_strength_by_plate").passes);  // 0.356 x 18^2 x 1960 N = 226 kN
  EXPECT_NEAR(check_of(r, "mast.guy_strength_by_plate").value, 226e3, 1e3);
}

/// A load that falls into its rope: the peak of an anchor's force is that of the rope, however few output steps there
/// are.
TEST(CheckedParts, a_peak_between_output_steps_counts) {
  const auto falling = [](const std::string& output, const std::string& more, const std::string& of_rope = "") {
    return run_text(R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 30 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 12 MN, breaking_force: 600 kN}}
  bodies: {load: {mass: 500 kg, at: [0 m, 0 m, 22 m], free: [x, y, z]}}
  reevings: [{rope: line, path: [{anchor: top}, {anchor: load}], length: 8.3 m, may_slack: true)" +
                    of_rope + "}]\nanalyses: [transient: {duration: 2 s, start: assembled, output_step: " + output +
                    more +
                    "}]\nchecks: {anchors: {top: {strength: 500 kN}}, ropes: {line: {dynamic_safety_factor: 2}}}\n");
  };
  const Result fine = falling("1 ms", ", tolerance: 1e-4"), coarse = falling("1 s", ", tolerance: 1e-4");
  const double force = check_of(fine, "top.anchor_strength").value;
  EXPECT_NEAR(check_of(coarse, "top.anchor_strength").value, force, 0.01 * force);
  EXPECT_NEAR(500e3 / force / check_of(coarse, "line.T_max").value, 1, 0.01);
  EXPECT_TRUE(coarse.unmade.empty());
  EXPECT_TRUE(falling("2 s", ", tolerance: 1e-4, branches: catenary").unmade.empty());

  const std::string verlet = ", method: verlet, step: 0.1 ms";
  const Result seldom = falling("1 s", verlet, ", segments: 4"), often = falling("1 ms", verlet, ", segments: 4");
  EXPECT_TRUE(seldom.unmade.empty());
  EXPECT_NEAR(check_of(seldom, "top.anchor_strength").value / check_of(often, "top.anchor_strength").value, 1, 0.01);
}

/// A rope at rest and in a motion has one check against its breaking force.
/// The peak of an anchor's force over all steps is where every step is an output step; `method`: of the motion.
void expect_same_in_few_outputs(const std::string& machine, const std::string& anchor, const std::string& method) {
  const auto held = [&](const std::string& motion) {
    const Result r = run_text("taut: 1\n" + machine + "checks: {anchors: {" + anchor +
                              ": {strength: 100 kN}}}\nanalyses: [{transient: {start: assembled, " + method + ", " +
                              motion + "}}]\n");
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return check_of(r, anchor + ".anchor_strength").value;
  };
  const double all = held("duration: 0.6 s, output_step: 0.2 ms"), few = held("duration: 60 s, output_step: 60 s");
  EXPECT_NEAR(few / all, 1, 5e-3) << machine;
}

// A carriage swings along a tight rope: each side has peaks where the other one pulls harder, and at an anchor the
// largest is not when the rope has its own.
TEST(CheckedParts, a_peak_of_one_branch_counts_beside_those_of_its_rope) {
  const std::string machine = R"(machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 400 kN, damping_ratio: 0.03}}
  points: {A: [0 m, 0 m, 10 m], B: [20 m, 0 m, 10 m]}
  carriages: {car: {mass: 500 kg, rides: ra, hold: clamped, length_before: 10.0045 m, at: [10 m, 0 m, 9.7 m]}}
  reevings: [{name: ra, rope: r, path: [{anchor: A}, {through: car}, {anchor: B}], length: 19.9592 m}]
)";
  expect_same_in_few_outputs(machine, "A", "method: implicit");
}

// Two loads fall into their ropes, one a little after the other: together they pull hardest between their own peaks.
TEST(CheckedParts, a_peak_of_two_ropes_together_counts_beside_their_own) {
  const std::string machine = R"(machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 1000 kN, damping_ratio: 0.1}}
  points: {top: [0 m, 0 m, 20 m]}
  bodies:
    a: {mass: 500 kg, at: [0 m, 0 m, 11 m], free: [z]}
    b: {mass: 500 kg, at: [0 m, 0 m, 11.161 m], free: [z]}
  reevings:
    - {name: ra, rope: r, path: [{anchor: top}, {anchor: a}], length: 10 m}
    - {name: rb, rope: r, path: [{anchor: top}, {anchor: b}], length: 10 m}
)";
  expect_same_in_few_outputs(machine, "top", "method: implicit");
}

// By Verlet too, whose steps of such machines are else taken many at once.
TEST(CheckedParts, points_show_their_moments) {
  const auto held = [](const std::string& output) {
    const Result r = run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 400 kN, damping_ratio: 0.02, diameter: 20 mm}}
  points: {A: [0 m, 0 m, 4 m], B: [40 m, 0 m, 4 m]}
  terrain: {x: [0 m, 40 m], z: [0 m, 0 m]}
  carriages: {car: {mass: 300 kg, rides: ra, hold: clamped, length_before: 20.05 m, at: [20 m, 0 m, 4.3 m]}}
  reevings: [{name: ra, rope: r, path: [{anchor: A}, {through: car}, {anchor: B}], length: 40.1 m, segments: 4}]
checks: {anchors: {A: {strength: 85 kN}}, lines: {ra: {least_clearance: 2.5 m}}}
analyses: [{transient: {duration: 1 s, start: assembled, method: verlet, step: 0.02 ms, output_step: )" +
                              output + "}}]\n");
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return std::pair(check_of(r, "A.anchor_strength").value, check_of(r, "ra.clearance").value);
  };
  const auto all = held("0.1 ms"), few = held("1 s");
  EXPECT_NEAR(few.first / all.first, 1, 1e-3);
  EXPECT_NEAR(few.second, all.second, 1e-3);
}

TEST(CheckedParts, a_check_of_several_analyses_is_one_at_its_worst) {
  const std::string deck = R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 5 MN, breaking_force: 100 kN}}
  bodies: {load: {mass: 1 t, at: [0 m, 0 m, 5 m], free: [x, z]}}
  reevings: [{rope: line, path: [{anchor: top}, {anchor: load}], length: 5 m}]
  signals: {jerk: {ramp: {to: -20 mm, start: 0 s, duration: 50 ms}}}
  tensioners: [{reeving: line, end: start, change: jerk}]
analyses: [{equilibrium: {motion: at_rest}}, {transient: {duration: 1 s, tolerance: 1e-3}}]
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto same = [](const Check& c) { return c.name == "line.T_max"; };
  EXPECT_EQ(std::count_if(r.checks.begin(), r.checks.end(), same), 1);
  EXPECT_DOUBLE_EQ(check_of(r, "line.T_max").value, taut_test::value_of(r, "T_max"));
  EXPECT_GT(check_of(r, "line.T_max").value, 1.2 * 1e3 * 9.81);
  EXPECT_NE(check_of(r, "line.T_max").where.find("transient"), std::string::npos);
}

/// A line that is put up on a day of 15 degC; what holds it has to hold it on a cold one, and on a hot one it may not
/// lie on the ground.
TEST(CheckedParts, every_temperature_of_an_installation) {
  const auto line = [](const std::string& analyses) {
    return run_text(R"(taut: 1
machine:
  temperature: 15 degC
  ropes: {line: {mass: 1.5 kg/m, stiffness: 20 MN, breaking_force: 250 kN, diameter: 20 mm}}
  points: {a: [0 m, 0 m, 10 m], b: [100 m, 0 m, 10 m]}
  terrain: {x: [0 m, 40 m, 60 m, 100 m], z: [0 m, 8.8 m, 8.8 m, 0 m]}
  reevings: [{rope: line, path: [{anchor: a}, {anchor: b}], install: {tension: 20 kN}}]
checks:
  ropes: {line: {safety_factor: 3, termination_efficiency: 0.8}}
  anchors: {a: {strength: 25 kN}}
  masts: {spar: {section: CHS 219.1x8, steel: S355, height: 10 m, sway: 0, bow: 0, foot: [0 m, 0 m, 0 m], towards: [1, 0], carries: [a]}}
analyses:
  - equilibrium: {motion: at_rest}
)" + analyses);
  };
  const auto installed = [&](const std::string& temperature) {
    return line("  - installation: {reeving: line, temperatures: [15 degC, " + temperature +
                "], given: {tension: 20 kN, temperature: 15 degC}}\n");
  };
  const Result mild = line(""), cold = installed("-40 degC"), hot = installed("60 degC");
  EXPECT_TRUE(check_of(mild, "a.anchor_strength").passes);
  EXPECT_FALSE(taut_test::has_check(mild, "line.ground"));
  // the pull at its head bends the mast in proportion, but for what it bends further
  const double bent = check_of(cold, "spar.section").value / check_of(mild, "spar.section").value;
  EXPECT_NEAR(bent, cold.find_value("line.T_max")->value / mild.find_value("line.T_max")->value, 0.02);
  const double T = cold.find_value("line.T_max")->value;
  EXPECT_NEAR(check_of(cold, "a.anchor_strength").value, 25e3 / T, 1e-3);
  EXPECT_NEAR(check_of(cold, "line.termination").value, 0.8 * 250e3 / T, 1e-3);
  EXPECT_FALSE(check_of(cold, "a.anchor_strength").passes);
  EXPECT_FALSE(check_of(hot, "line.ground").passes);
  EXPECT_FALSE(taut_test::has_check(cold, "line.ground"));
}

// A slow motion is at rest at all its steps; an equilibrium beside it does not make its tensions count less.
TEST(CheckedParts, the_ends_of_a_slow_motion) {
  const auto tightened = [](const std::string& equilibrium) {
    const Result r = run_text(R"(taut: 1
machine:
  signals: {in: {ramp: {to: 0.1 m/s, start: 0 s, duration: 0.5 s, smooth: true}}}
  ropes: {line: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 330 kN}}
  points: {head: [0 m, 0 m, 20 m]}
  sheaves: {s: {at: [100 m, 0 m, 20 m], diameter: 800 mm}}
  drums: {winch: {at: [100 m, 0 m, 0 m], core_diameter: 800 mm, drive: {speed: in}}}
  reevings: [{rope: line, path: [{anchor: head}, {over: s}, {drum: winch}], length: 120.1 m}]
checks: {ropes: {line: {safety_factor: 4, termination_efficiency: 0.8}}}
analyses:
)" + equilibrium + "  - transient: {duration: 4 s, output_step: 0.1 s, quasi_static: true}\n");
    return std::pair(check_of(r, "line.termination").value, check_of(r, "line.safety_factor").value);
  };
  const auto [alone, factor] = tightened("");
  EXPECT_NEAR(alone, 0.8 * factor, 2e-3);
  EXPECT_NEAR(tightened("  - equilibrium: {}\n").first, alone, 1e-9);
}

/// At rest friction holds anywhere between both directions of motion: what bears the rope has to bear both.
TEST(CheckedParts, whatBearsARopeAtRestBearsBothMotions) {
  const std::string on_support = R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 0 m], B: [22 m, 0 m, 0 m], C: [3 m, 10 m, 0 m]}
  ropes: {r: {mass: 1 kg/m, stiffness: 24 MN, breaking_force: 450 kN, diameter: 20 mm}}
  supports: {S: {at: [10 m, 0 m, 8 m], diameter: 400 mm, friction: 0.3}}
  reevings: [{rope: r, path: [{anchor: A}, {over: S}, {anchor: B}], tension_at_end: 50 kN}]
checks:
  anchors: {A: {strength: 80 kN}}
  supports: {S: {tree_diameter: 36 cm, height: 8 m}}
  masts: {spar: {section: CHS 219.1x8, steel: S355, carries: S, foot: [10 m, 0 m, 0 m], height: 8 m}}
)";
  const std::string on_beam = R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 0 m], B: [22 m, 0 m, 0 m], foot: [10 m, 0 m, 0 m], top: [10 m, 0 m, 8 m]}
  ropes: {r: {mass: 1 kg/m, stiffness: 24 MN, breaking_force: 450 kN, diameter: 20 mm}}
  beams: {spar: {from: foot, to: top, section: CHS 323.9x10, steel: S355}}
  supports: {S: {body: spar, at: [0 m, 0 m, 8 m], diameter: 400 mm, friction: 0.3}}
  reevings: [{rope: r, path: [{anchor: A}, {over: S}, {anchor: B}], tension_at_end: 100 kN}]
checks: {masts: {spar: {load_factor: 1.35}}}
)";
  for (const auto& [deck, names] :
       {std::pair{on_support, std::vector<std::string>{"A.anchor_strength", "S.support_tree", "spar.section"}},
        {on_beam, {"spar.section", "spar.member"}}}) {
    const auto moving = [&, &text = deck](const char* motion) {
      return run_text(text + "analyses: [{equilibrium: {motion: " + motion + "}}]\n");
    };
    const Result rest = moving("at_rest"), in = moving("in"), out = moving("out");
    ASSERT_EQ(rest.status, Status::ok) << rest.message << to_text(rest.errors);
    for (const std::string& name : names) {
      const double worst = std::max(check_of(in, name).utilisation, check_of(out, name).utilisation);
      EXPECT_NEAR(check_of(rest, name).utilisation / worst, 1, 1e-6) << name;
      EXPECT_NE(check_of(rest, name).rule.find("held by friction"), std::string::npos) << check_of(rest, name).rule;
    }
  }
}

/// A skyline that nobody hauls over two jacks, its path written from either end: the checks are the same, and no better
/// than with the rope drawn into the span of the carriage over both.
TEST(CheckedParts, creepOverSupportsCountsBothWays) {
  const auto run = [](bool turned, const std::string& motion) {
    const char* path = turned ? "[{anchor: B}, {over: jack2}, {through: car}, {over: jack1}, {anchor: A}]"
                              : "[{anchor: A}, {over: jack1}, {through: car}, {over: jack2}, {anchor: B}]";
    return run_text(std::string(R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 0 m], B: [300 m, 0 m, 10 m], winch: [300 m, 0 m, 12 m]}
  ropes:
    sky: {mass: 2 kg/m, stiffness: 30 MN, breaking_force: 350 kN}
    main: {mass: 0.5 kg/m, stiffness: 8 MN, breaking_force: 60 kN}
  supports:
    jack1: {at: [80 m, 0 m, 14 m], diameter: 400 mm, friction: 0.15}
    jack2: {at: [220 m, 0 m, 18 m], diameter: 400 mm, friction: 0.15}
  carriages: {car: {mass: 2 t, rides: sky, hold: rolling, mainline: main, friction: 0.02}}
  reevings:
    - {rope: sky, path: )") +
                    path + R"(, install: {tension: 70 kN, at: )" + (turned ? "start" : "end") + R"(}}
    - {rope: main, path: [{anchor: winch}, {anchor: car}], length: 150 m}
checks: {ropes: {sky: {safety_factor: 3}, main: {safety_factor: 3}}, anchors: {A: {strength: 200 kN}}}
analyses: [{equilibrium: {carriage: car, x: 140 m, motion: )" +
                    motion + "}}]\n");
  };
  const Result one = run(false, "in"), other = run(true, "in");
  ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
  ASSERT_EQ(other.status, Status::ok) << other.message << to_text(other.errors);
  ASSERT_FALSE(one.checks.empty());
  for (const Check& check : one.checks) {
    EXPECT_NEAR(check_of(other, check.name).value / check.value, 1, 1e-7) << check.name;
  }
  std::vector<Result> signs;
  for (const char* jacks :
       {"jack1: 1, jack2: -1", "jack1: -1, jack2: 1", "jack1: 1, jack2: 1", "jack1: -1, jack2: -1"}) {
    signs.push_back(run(false, std::string("{car: -1, ") + jacks + "}"));
    ASSERT_EQ(signs.back().status, Status::ok) << signs.back().message << to_text(signs.back().errors);
  }
  for (const Check& check : one.checks) {
    double worst = 0;
    for (const Result& r : signs) worst = std::max(worst, check_of(r, check.name).utilisation);
    EXPECT_NEAR(check.utilisation / worst, 1, 1e-7) << check.name;
  }
}

/// The rope lies on the saddle m, or has lifted off it, by the way in which friction acts on it. The answer is one of
/// them; the other counts all the same, from whichever end the path is written.
TEST(CheckedParts, whatLiftsOffInOneDirectionOfFrictionCountsBothWays) {
  const auto run = [](bool turned, const std::string& motion) {
    const char* path = turned ? "[{anchor: B}, {through: car}, {over: m}, {over: b}, {anchor: A}]"
                              : "[{anchor: A}, {over: b}, {over: m}, {through: car}, {anchor: B}]";
    return run_text(std::string(R"(taut: 1
machine:
  points: {A: [0 m, 0 m, 0 m], B: [200 m, 0 m, 0 m]}
  ropes: {sky: {mass: 2 kg/m, stiffness: 30 MN, breaking_force: 350 kN}}
  supports:
    b: {at: [20 m, 0 m, 10 m], diameter: 400 mm, friction: 0.3, uplift: lift}
    m: {at: [100 m, 0 m, 1.9 m], diameter: 400 mm, friction: 0.3, uplift: lift}
  carriages: {car: {mass: 1 t, rides: sky, hold: rolling}}
  reevings:
    - {rope: sky, path: )") +
                    path + R"(, install: {tension: 40 kN, at: )" + (turned ? "start" : "end") + R"(}}
checks: {ropes: {sky: {safety_factor: 3}}, anchors: {A: {strength: 200 kN}, B: {strength: 200 kN}}}
analyses: [{equilibrium: {carriage: car, x: 150 m, held: true, motion: )" +
                    motion + "}}]\n");
  };
  const Result one = run(false, "in"), other = run(true, "in");
  const Result signs[] = {run(false, "{b: 1, m: 1}"), run(false, "{b: -1, m: -1}")};
  for (const Result* r : {&one, &other, &signs[0], &signs[1]}) {
    ASSERT_EQ(r->status, Status::ok) << r->message << to_text(r->errors);
    EXPECT_TRUE(r->unsafe.empty()) << r->unsafe.front();
  }
  const auto lifted = [](const Result& r) {
    const Table& t = table_of(r, "sheaves");
    return taut_test::text_cell(t, taut_test::row_of(t, "name", "m"), "state") == "lifted";
  };
  EXPECT_NE(lifted(signs[0]), lifted(signs[1])) << "else the machine shows nothing";
  ASSERT_FALSE(one.checks.empty());
  for (const Check& check : one.checks) {
    const double worst =
        std::max(check_of(signs[0], check.name).utilisation, check_of(signs[1], check.name).utilisation);
    EXPECT_NEAR(check.utilisation / worst, 1, 1e-7) << check.name;
    EXPECT_NEAR(check_of(other, check.name).utilisation / worst, 1, 1e-7) << check.name;
  }
}

/// 5 t on two ropes: where one breaks, the other takes 3/2 of the weight for a moment, which no state of rest shows.
TEST(CheckedParts, ABreakWithoutInertiaIsNotJudged) {
  const auto hook = [](const std::string& more) {
    return run_text(R"(taut: 1
machine:
  points: {a: [-0.5 m, 0 m, 12 m], b: [0.5 m, 0 m, 12 m]}
  ropes: {hoist: {mass: 0.1 kg/m, stiffness: 9.8 MN, breaking_force: 60 kN, damping_ratio: 0.02}}
  bodies: {hook: {mass: 5 t, at: [0 m, 0 m, 2 m], free: [z]}}
  reevings:
    - {name: r1, rope: hoist, path: [{anchor: a}, {anchor: hook}], length: 10 m}
    - {name: r2, rope: hoist, path: [{anchor: b}, {anchor: hook}], length: 10 m}
  events: [{at: 0.2 s, break: r1}]
checks: {ropes: {hoist: {safety_factor: 1.15, elastic_limit: 0.95}}}
analyses: [{transient: {duration: 0.6 s, output_step: 10 ms)" +
                    more + "}}]\n");
  };
  const Result slow = hook(", quasi_static: true");
  ASSERT_EQ(slow.status, Status::ok) << slow.message << to_text(slow.errors);
  EXPECT_EQ(verdict_of(slow)->kind, VerdictKind::not_judged);
  EXPECT_THAT(slow.unmade, testing::Contains(testing::HasSubstr("breaks at t = 0.2 s in a motion without inertia")));
  EXPECT_EQ(verdict_of(hook(""))->kind, VerdictKind::fails);
}

/// Two ropes without mass, one of them 0.5 m too long: it never carries.
TEST(CheckedParts, ARopeThatIsSlackAllTheTimeIsTold) {
  const auto hook = [](const std::string& more) {
    return run_text(R"(taut: 1
machine:
  points: {a: [-0.5 m, 0 m, 12 m], b: [0.5 m, 0 m, 12 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 9.8 MN, breaking_force: 600 kN, damping_ratio: 0.02}}
  bodies: {hook: {mass: 5 t, at: [0 m, 0 m, 2 m], free: [z]}}
  reevings:
    - {name: r1, rope: hoist, path: [{anchor: a}, {anchor: hook}], length: 10 m}
    - {name: r2, rope: hoist, path: [{anchor: b}, {anchor: hook}], length: 10.5 m)" +
                    more + R"(}
checks: {ropes: {r1: {safety_factor: 2}}}
analyses: [{transient: {duration: 0.2 s, output_step: 10 ms}}]
)");
  };
  const Result r = hook("");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_THAT(r.unsafe, testing::ElementsAre(testing::HasSubstr("r2 between b and hook is slack all the time")));
  EXPECT_TRUE(hook(", may_slack: true").unsafe.empty());
}

// A screw pulls hardest where it is set: the saw is judged warm alone, where its loop is slacker.
TEST(CheckedParts, what_a_screw_pulls_when_it_is_set) {
  const Result r = run_text(R"(taut: 1
machine:
  temperature: 0 degC
  ropes: {loop: {mass: 0.1 kg/m, stiffness: 6 MN, breaking_force: 100 kN, diameter: 12 mm}}
  bodies: {slide: {mass: 10 kg, at: [0 m, 0 m, 1 m], free: [x]}}
  sheaves:
    drive: {at: [8 m, 0 m, 1 m], diameter: 700 mm, friction: 0.25, motor: {speed: 1 m/s}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 700 mm}
  reevings: [{rope: loop, path: [{over: drive, side: left}, {over: tail, side: left}], closed: true, length: 18 m}]
  take_up: [{body: slide, screw: 204 kN, along: [-1, 0, 0], keeps: place}]
analyses: [{sweep: {parameter: temperature, from: 80 degC, to: 90 degC, steps: 1, motion: at_rest}}]
checks: {ropes: {loop: {safety_factor: 1, sheave_weakening: covered}}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(check_of(r, "loop.safety_factor").value, 100.0 / 102, 1e-4);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
}

// One name, one number: the value is what the check and a study read.
TEST(CheckedParts, the_safety_factor_of_a_motion_counts_what_lasts) {
  const Result r = run_text(R"(taut: 1
machine:
  signals: {F: {ramp: {from: 25 kN, to: 50 kN, start: 1 s, duration: 2 s, smooth: true}}}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN, diameter: 10 mm, damping_ratio: 0.05}}
  points: {p: [0 m, 0 m, 10 m]}
  bodies: {b: {mass: 10 kg, at: [0 m, 0 m, 5 m], free: [z]}}
  reevings: [{rope: r, path: [{anchor: p}, {anchor: b}], length: 5 m}]
  loads: [{at: b, force: [0 N, 0 N, -25 kN], signal: F}]
analyses: [{equilibrium: {}}, {transient: {duration: 10 s, output_step: 50 ms, tolerance: 1e-3}}]
checks: {ropes: {r: {safety_factor: 1.5}}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double factor = taut_test::value_of(r, "r.safety_factor");
  EXPECT_NEAR(factor, 100 / 50.1, 2e-3);
  EXPECT_EQ(check_of(r, "r.safety_factor").value, factor);
}

// Two ropes pull an anchor to both sides; one lets go for 60 ms, between two output steps.
TEST(CheckedParts, a_rope_that_lets_go_for_a_moment_leaves_the_pull_of_the_other_one) {
  const auto anchor = [](const std::string& output) {
    return run_text(R"(taut: 1
machine:
  signals: {s: {table: {t: [5.005 s, 5.035 s, 5.065 s], value: [50 kN, 7 kN, 50 kN]}}}
  points: {P: [0 m, 0 m, 10 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 1000 kN, damping_ratio: 1}}
  bodies: {A: {mass: 20 kg, at: [5 m, 0 m, 10 m], guide: [1, 0, 0]}, B: {mass: 20 kg, at: [-5 m, 0 m, 10 m], guide: [1, 0, 0]}}
  loads: [{at: A, force: [50 kN, 0 kN, 0 kN]}, {at: B, force: [-50 kN, 0 kN, 0 kN], signal: s}]
  reevings:
    - {name: ra, rope: r, path: [{anchor: P}, {anchor: A}], length: 5 m}
    - {name: rb, rope: r, path: [{anchor: P}, {anchor: B}], length: 5 m}
analyses: [{transient: {duration: 100 s, tolerance: 1e-5, output_step: )" +
                    output + "}}]\nchecks: {anchors: {P: {strength: 40 kN}}, ropes: {ra: {dynamic_safety_factor: 2}, " +
                    "rb: {dynamic_safety_factor: 2}}}\n");
  };
  const Result fine = anchor("10 ms"), coarse = anchor("0.1 s");
  const double reserve = check_of(fine, "P.anchor_strength").value;
  EXPECT_NEAR(reserve, 40.0 / 43, 0.02);
  EXPECT_NEAR(check_of(coarse, "P.anchor_strength").value, reserve, 0.01);
}

}  // namespace taut::checks::checked_parts_test
