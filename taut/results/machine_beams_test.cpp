#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "test/support/machine_decks.hpp"

namespace machine_beams_test {

using namespace taut_test;

/// A pole of figures, pressed and pushed at its top.
std::string pole(const std::string& beam, const std::string& more = "") {
  return R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}
  beams:
    mast: {from: foot, to: head, A: 50 cm^2, I: 5000 cm^4, E: 200 GPa, mass: 0 kg/m)" +
         beam + R"(}
  loads: [{at: mast.top, force: [3 N, 4 N, -300 kN]}]
)" + more;
}

TEST(MachineBeams, PoleIsTheBeamColumnWithoutAnyRope) {
  const taut::Result r = run_text(pole(""), {"machine.beams.mast.A=1000000 cm^2"});  // hardly shortened
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  const double EI = 200e9 * 5000e-8, N = 300e3, k = std::sqrt(N / EI), M = 5 * std::tan(k * 8) / k;
  EXPECT_NEAR(value_of(r, "mast.M_max"), M, 1e-6 * M);
  EXPECT_NEAR(value_of(r, "mast.N_base"), -N, 1e-4 * N);
  EXPECT_NEAR(value_of(r, "mast.Mx"), 0.8 * M, 1e-6 * M);
  EXPECT_NEAR(value_of(r, "mast.My"), -0.6 * M, 1e-6 * M);
  EXPECT_NEAR(value_of(r, "mast.Rz"), N, 1e-6 * N);
  EXPECT_NEAR(value_of(r, "mast.top.x"), 0.6 * (M - 5 * 8) / N, 1e-9);
  EXPECT_NEAR(value_of(r, "mast.N_cr"), std::pow(std::numbers::pi / 16, 2) * EI, 100);
  const taut::Result s = run_text(pole(""));
  EXPECT_EQ(table_of(s, "beams").rows.size(), 17U);
  EXPECT_EQ(table_of(s, "bodies").rows.size(), 1U);
  EXPECT_NEAR(cell(table_of(s, "beams"), 8, "s"), 4, 1e-12);
}

// A tie buckles with no other beam, however near to it they are.
TEST(MachineBeams, WhatIsPulledHasNoCriticalFactor) {
  const taut::Result r = run_text(R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m], hook: [3 m, 0 m, 8 m], low: [3 m, 0 m, 0 m]}
  beams:
    mast: {from: foot, to: head, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}
    tie: {from: hook, to: low, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}
  loads: [{at: mast.top, force: [0 kN, 0 kN, -100 kN]}, {at: tie.top, force: [0 kN, 0 kN, -50 kN]}]
)");
  EXPECT_TRUE(has_check(r, "mast.alpha_cr")) << to_text(r.errors);
  EXPECT_FALSE(has_check(r, "tie.alpha_cr"));
}

/// A boom whose stay is held above a place 0.5 m before its foot, 4 m above it and 8 m beside the tip: sideways T/l of
/// the stay holds it against N/h of the boom. T/l : N/h = 8 : 7.5 by the level forces at the tip, whatever the load.
TEST(MachineBeams, ASwingOfTheMachineIsToldBesideTheBuckling) {
  for (const std::string load : {"1 t", "4 t"}) {
    const taut::Result r = run_text(R"(taut: 1
machine:
  ropes: {r: {stiffness: 3000 MN, mass: 0 kg/m, breaking_force: 400 kN}}
  points: {foot: [0 m, 0 m, 0 m], mast: [0.5 m, 0 m, 4 m], end: {body: tip, at: [0 m, 0 m, 0 m]}}
  bodies: {tip: {mass: )" + load + R"(, at: [8 m, 0 m, 0 m], free: [x, y, z]}}
  beams: {boom: {from: foot, to: end, section: CHS 168.3x6.3, steel: S355, mass: 0 kg/m, base: hinge, top: hinge}}
  reevings: [{rope: r, path: [{anchor: mast}, {anchor: tip}], length: 8.5 m}]
checks: {ropes: {r: {safety_factor: 3}}}
)");
    ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
    EXPECT_THAT(r.warnings, testing::Contains(testing::HasSubstr("from 1.067 times the forces on its beams")));
    const double I = std::numbers::pi / 64 * (std::pow(0.1683, 4) - std::pow(0.1557, 4));
    EXPECT_NEAR(value_of(r, "boom.N_cr") / (std::pow(std::numbers::pi / 8, 2) * 210e9 * I), 1, 0.01);
  }
}

TEST(MachineBeams, FirstOrderIsStatics) {
  const taut::Result r = run_text(pole(", order: first, elements: 3"));
  EXPECT_EQ(exit_code(r), 4) << "alpha_cr is below 10";
  EXPECT_NEAR(value_of(r, "mast.M_max"), 40, 1e-8);
  EXPECT_EQ(table_of(r, "beams").rows.size(), 4U);
}

/// Hinged at both ends, heavy: M = w L^2/8 in its middle.
std::string span(const std::string& elements) {
  return R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 5 m], w: {body: wall, at: [0 m, 0 m, 0 m]}}
  bodies: {wall: {at: [4 m, 0 m, 5 m]}}
  beams:
    b: {from: a, to: w, section: CHS 219.1x8, steel: S355, base: hinge, top: hinge, mass: 6000 kg/m, order: first, elements: )" +
         elements + "}\nchecks: {masts: {b: {load_factor: 1.0}}}\n";
}

/// What `elements` says is which sections the table has: not where the largest values are looked for.
TEST(MachineBeams, ElementsThinTheTableOnly) {
  const taut::Result r = run_text(span("16"));
  EXPECT_NEAR(value_of(r, "b.M_max"), 6000 * 9.80665 * 16 / 8, 1);
  EXPECT_FALSE(check_of(r, "b.stress_max").passes);
  for (const char* elements : {"1", "2", "3", "7"}) {
    const taut::Result s = run_text(span(elements));
    EXPECT_EQ(table_of(s, "beams").rows.size(), std::stoul(elements) + 1);
    for (const char* name : {"b.M_max", "b.stress_max"}) {
      EXPECT_NEAR(value_of(s, name) / value_of(r, name), 1, 1e-3) << elements << name;
    }
    for (const char* name : {"b.stress_max", "b.section"}) {
      EXPECT_NEAR(check_of(s, name).value / check_of(r, name).value, 1, 1e-3) << elements << name;
    }
    EXPECT_EQ(exit_code(s), 4);
  }
}

/// A box of figures, bent over its corner.
std::string corner(const std::string& figures) {
  return R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 6 m], a1: {body: b, at: [0 m, 2 m, 6 m]}, a2: {body: b, at: [0 m, -2 m, 6 m]}}
  beams:
    b: {from: foot, to: head, steel: S355, )" +
         figures + R"(}
  loads: [{at: b.top, force: [7 kN, 7 kN, -10 kN]}]
)";
}

/// With one W the stress is known only between a tube and a corner: a limit between is not judged, others are.
TEST(MachineBeams, FiguresAreABoxIfTheirAxesAreSaid) {
  const std::string box = "A: 44.8 cm^2, I: 1490 cm^4, W: 199 cm^3";
  const taut::Result r = run_text(corner(box)), both = run_text(corner(box + ", W_weak: 199 cm^3"));
  const taut::Result round = run_text(corner(box + ", round: true")),
                     turned = run_text(corner(box + ", strong: [1, 1, 0]"));
  const taut::Result axes = run_text(corner(box + ", strong: [1, 0, 0]"));
  for (const taut::Result* one : {&both, &axes}) {
    EXPECT_NEAR(value_of(*one, "b.stress_max"), 442.7e6, 0.1e6);
    EXPECT_FALSE(check_of(*one, "b.stress_max").passes);
    EXPECT_TRUE(one->unmade.empty());
  }
  for (const taut::Result* one : {&round, &turned}) {
    EXPECT_NEAR(value_of(*one, "b.stress_max"), 313.8e6, 0.1e6);
    EXPECT_TRUE(one->unmade.empty()) << "no torsion";
    EXPECT_EQ(exit_code(*one), 0);
  }
  EXPECT_NEAR(value_of(r, "b.stress_max"), 313.8e6, 0.1e6);
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_NE(r.unmade[0].find("442.7 MPa"), std::string::npos) << r.unmade[0];
  EXPECT_EQ(exit_code(r), 4);
  const taut::Result light = run_text(corner(box), {"machine.loads[0].force=[5.5 kN, 5.5 kN, -10 kN]"});
  EXPECT_TRUE(light.unmade.empty()) << "the corner keeps the limit too";
  const taut::Result heavy = run_text(corner(box), {"machine.loads[0].force=[9 kN, 9 kN, -10 kN]"});
  EXPECT_TRUE(heavy.unmade.empty());
  EXPECT_FALSE(check_of(heavy, "b.stress_max").passes);
  expect_mistake(run_text(corner(box + ", round: true, W_weak: 150 cm^3")), "a round section has one 'W'");
  expect_mistake(run_text(corner(box + ", round: true, J: 150 cm^4")), "2 I");
  expect_mistake(run_text(corner("section: CHS 219.1x8, round: true")), "belongs to a section by figures");
}

/// The couple of two forces twists it: without W_t its stress is not judged; above f_y it fails whatever the torsion.
TEST(MachineBeams, TorsionOfFiguresNeedsItsModulus) {
  const std::string loads = "  - {at: a1, force: [10 kN, 0 kN, 0 kN]}\n  - {at: a2, force: [-10 kN, 0 kN, 0 kN]}\n";
  const auto twisted = [&](const std::string& more, const std::string& H) {
    std::string deck = corner("A: 44.8 cm^2, I: 1490 cm^4, W: 199 cm^3" + more);
    const std::string plain = "  loads: [{at: b.top, force: [7 kN, 7 kN, -10 kN]}]\n";
    deck.replace(deck.find(plain), plain.size(),
                 "  loads:\n  - {at: b.top, force: [" + H + ", 0 kN, -10 kN]}\n" + loads);
    return run_text(deck);
  };
  const auto tells = [](const taut::Result& r) {
    return r.unmade.size() == 1 && r.unmade[0].find("'W_t'") != std::string::npos;
  };
  const taut::Result unknown = twisted("", "5 kN");
  EXPECT_TRUE(tells(unknown));
  EXPECT_EQ(exit_code(unknown), 4);
  EXPECT_TRUE(check_of(unknown, "b.stress_max").passes);
  const taut::Result fails = twisted("", "15 kN");
  EXPECT_FALSE(check_of(fails, "b.stress_max").passes);
  const taut::Result known = twisted(", W_t: 321 cm^3", "5 kN"), round = twisted(", round: true", "5 kN");
  EXPECT_TRUE(known.unmade.empty() && round.unmade.empty());
  const double sigma = value_of(unknown, "b.stress_max"), twist = 40e3 * 6 / (210e9 / 2.6 * 2980e-8);
  const double T = 40e3 * std::cos(twist);  // the arms turn, the forces don't
  EXPECT_NEAR(value_of(known, "b.stress_max"), std::hypot(sigma, std::sqrt(3) * T / 321e-6), 3e5);
  EXPECT_NEAR(value_of(round, "b.stress_max"), std::hypot(sigma, std::sqrt(3) * T / 398e-6), 3e5);
}

TEST(MachineBeams, BucklingIsExitThree) {
  const taut::Result r = run_text(pole(", base: hinge"));
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_NE(r.message.find("'mast'"), std::string::npos) << r.message;
  const taut::Result s = run_text(pole(""), {"machine.loads[0].force=[0 N, 0 N, -450 kN]"});
  EXPECT_EQ(exit_code(s), 3);
  EXPECT_NE(s.message.find("buckles"), std::string::npos) << s.message;
}

/// A search for a sag goes without factors, but where it ends its reason has them: 1 where the mast just buckles.
TEST(MachineBeams, ASearchThatEndsWhereABeamBucklesTellsWhichAndByHowMuch) {
  const char* const deck = R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 12 m], tail: [250 m, 0 m, 20 m], west: [-14 m, 9 m, 0 m], east: [-14 m, -9 m, 0 m]}
  ropes: {line: {mass: 1.5 kg/m, stiffness: 20 MN}}
  beams: {mast: {from: foot, to: head, section: CHS 114.3x4, steel: S355, base: hinge}}
  carriages: {car: {mass: 250 kg, rides: skyline, hold: clamped}}
  reevings:
    - {name: skyline, rope: line, path: [{anchor: mast.top}, {through: car}, {anchor: tail}], length: 256 m}
  guys:
    one: {rope: line, from: mast.top, to: west, install: {tension: 5 kN, at: top}}
    two: {rope: line, from: mast.top, to: east, install: {tension: 5 kN, at: top}}
  loads: [{at: car, mass: 0.3 t}]
analyses:
  - equilibrium: {carriage: car, x: 125 m, given: {reeving: skyline, sag: 4 m}}
)";
  const taut::Result r = run_text(deck);
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_NE(r.message.find("no length of 'skyline' found with this sag"), std::string::npos) << r.message;
  // a tighter line has less sag, until the mast buckles between its ends: pi^2 EI/L^2 = 30.4 kN, and half its weight
  EXPECT_NE(r.message.find("beam 'mast' buckles: its compression of 30.9"), std::string::npos) << r.message;
  EXPECT_NE(r.message.find("is 1 times what it holds"), std::string::npos) << r.message;
}

const char* const guyed = R"(taut: 1
machine:
  ropes: {guy: {mass: 1.2 kg/m, stiffness: 15 MN, breaking_force: 180 kN}}
  points:
    foot: [1 m, 2 m, 3 m]
    head: [1 m, 2 m, 15 m]
    a1: [-12 m, 8 m, 4 m]
    a2: [-12 m, -4 m, 2 m]
    a3: [5 m, 14 m, 3 m]
    a4: [5 m, -10 m, 3 m]
    lug: {body: mast, at: [0.2 m, 0 m, 11 m]}
  beams:
    mast: {from: foot, to: head, section: "CHS 219.1x8", steel: S355, base: hinge, imperfection: 0.0033}
  guys:
    g1: {rope: guy, from: mast.top, to: a1, install: {tension: 12 kN, at: top}}
    g2: {rope: guy, from: mast.top, to: a2, install: {tension: 12 kN, at: anchor}}
    g3: {rope: guy, from: lug, to: a3, install: {tension: 9 kN, at: top}}
    g4: {rope: guy, from: lug, to: a4, install: {tension: 9 kN, at: top}}
  loads: [{at: mast.top, force: [30 kN, 3 kN, -40 kN]}]
)";

TEST(MachineBeams, GuysAreInstalledOnTheUnloadedMastThenKept) {
  const taut::Result unloaded =
      run_text(guyed, {"machine.loads[0].force=[0 N, 0 N, 0 N]", "machine.gravity=1e-9 m/s^2"});
  const taut::Result r = run_text(guyed);
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  ASSERT_EQ(exit_code(unloaded), 0) << unloaded.message;
  EXPECT_GT(value_of(r, "g1.T_max"), 20e3);
  EXPECT_GT(value_of(r, "mast.top.x"), 1.001);
  EXPECT_LT(cell(table_of(r, "closure"), 0, "balance"), 1e-4);
  EXPECT_GT(r.checks.size(), 5U);
  // a lug off the axis, 11 m up: two sections at its height, and the moment jumps there
  const auto& beams = table_of(r, "beams");
  bool jumps = false;
  for (std::size_t i = 1; i < beams.rows.size(); ++i) {
    const bool twice = std::abs(cell(beams, i, "s") - cell(beams, i - 1, "s")) < 1e-9;
    jumps = jumps || (twice && std::abs(cell(beams, i, "M") - cell(beams, i - 1, "M")) > 100);
  }
  EXPECT_TRUE(jumps);
}

/// A cutting force that follows its rope has no potential; a pole beside the saw has nothing to do with it.
TEST(MachineBeams, WhatABeamDoesNotHoldIsNotItsFall) {
  const auto saw = [](const std::string& top) {
    return run_text(R"(taut: 1
machine:
  points: {foot: [100 m, 0 m, 0 m], top: [100 m, 0 m, 5 m]}
  ropes: {saw: {mass: 0.6 kg/m, stiffness: 6.5 MN, breaking_force: 100 kN, diameter: 12 mm}}
  bodies: {slide: {mass: 85 kg, at: [0 m, 0 m, 1 m], free: [x]}}
  sheaves:
    drive: {at: [8 m, 0 m, 1 m], diameter: 700 mm, friction: 0.25, motor: {}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 700 mm}
  beams: {pole: {from: foot, to: top, section: CHS 88.9x5, steel: S355, mass: 0 kg/m}}
  reevings: [{rope: saw, path: [{over: drive}, {over: tail}], closed: true, length: 18.2 m}]
  take_up: [{body: slide, weight: 1.4 t, along: [-1, 0, 0]}]
  rope_loads: [{name: cut, rope: saw, between: [tail, drive], rate: 0.1 kN/m, elements: 6}]
)" + top + R"(
analyses: [{equilibrium: {motion: in}}]
checks: {ropes: {saw: {safety_factor: 5}}, exempt: [pole]}
)");
  };
  const taut::Result r = saw("");
  ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "saw.T_max"), 1400 * 9.80665 / 2 + 800, 1);  // and what is cut on 8 m
  // a cantilever of 5 m: pi^2 EI/(4 L^2) = 24 kN
  EXPECT_EQ(saw("  loads: [{at: pole.top, force: [0 kN, 0 kN, -20 kN]}]").status, taut::Status::ok);
  const taut::Result buckles = saw("  loads: [{at: pole.top, force: [0 kN, 0 kN, -30 kN]}]");
  EXPECT_EQ(buckles.status, taut::Status::infeasible);
  EXPECT_NE(buckles.message.find("'pole' buckles"), std::string::npos) << buckles.message;
}

TEST(MachineBeams, PlacesCountFromTheBaseOrTheTop) {
  std::string deck = guyed;
  const taut::Result r = run_text(deck);
  const std::string lug = "lug: {body: mast, at: [0.2 m, 0 m, 11 m]}";
  deck.replace(deck.find(lug), lug.size(),
               "lug: {body: mast, at: [20 cm, 0 m, 1100 cm]}\n    high: {body: mast.top, at: [0 m, 0 m, 0 m]}");
  deck.replace(deck.find("{at: mast.top,"), 14, "{at: high,");
  const taut::Result s = run_text(deck);
  ASSERT_EQ(exit_code(s), 0) << s.message << to_text(s.errors);
  EXPECT_NEAR(value_of(s, "mast.M_max"), value_of(r, "mast.M_max"), 1e-7 * value_of(r, "mast.M_max"));
  EXPECT_NEAR(value_of(s, "g3.T_max"), value_of(r, "g3.T_max"), 1e-3);
}

TEST(MachineBeams, JibOnAMastInAnyOrder) {
  const std::string mast = "    mast: {from: foot, to: head, section: \"CHS 219.1x8\"}\n";
  const std::string jib = "    jib: {from: mast.top, to: tip, section: \"RHS 200x100x8\"}\n";
  const auto deck = [&](const std::string& beams) {
    return "taut: 1\nmachine:\n  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 5 m], tip: [0 m, 3 m, 5 m]}\n  "
           "beams:\n" +
           beams + "  loads: [{at: jib.top, force: [0 N, 0 N, -5 kN]}]\n";
  };
  const taut::Result r = run_text(deck(mast + jib)), s = run_text(deck(jib + mast));
  ASSERT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "mast.Mx"), value_of(s, "mast.Mx"), 1e-6 * value_of(r, "mast.Mx"));
  EXPECT_NEAR(value_of(r, "jib.top.z"), value_of(s, "jib.top.z"), 1e-9);
  EXPECT_GT(value_of(r, "jib.M_max"), 5e3 * 3);
  EXPECT_LT(value_of(r, "jib.M_max"), 5.8e3 * 3);
}

TEST(MachineBeams, StressAboveTheYieldIsACheckThatFails) {
  const taut::Result r =
      run_text(guyed, {"machine.loads[0].force=[30 kN, 3 kN, -40 kN]", "machine.beams.mast.section=CHS 60.3x4"});
  EXPECT_NE(exit_code(r), 0);
  EXPECT_NE(exit_code(r), 2) << to_text(r.errors);
}

TEST(MachineBeams, MistakesAreToldAtTheirPlace) {
  const auto mistake = [](const std::string& set, const std::string& reported) {
    expect_mistake(run_text(guyed, {set}), reported);
  };
  mistake("machine.beams.mast.section=CHS 219.1x88", "no section");
  mistake("machine.beams.mast.steel=S356", "S355");
  mistake("machine.beams.mast.elements=0", "elements");
  mistake("machine.beams.mast.to=foot", "same place");
  mistake("machine.beams.mast.from=fot", "did you mean 'foot'");
  mistake("machine.beams.mast.from=mast.top", "on the beam itself");
  mistake("machine.beams.mast.base=ball", "clamped");
  mistake("machine.beams.mast.I=3 cm^4", "belongs to a section by figures");
  mistake("machine.beams.mast.imperfection={bow: 0.003, towards: [0, 0, 1]}", "no part across");
  mistake("machine.beams.mast.imperfection=0.3", "0.05");
  mistake("machine.guys.g1.from=mast", "'mast.top'");
  mistake("machine.points.lug.body=mats", "did you mean 'mast'");
  expect_mistake(run_text(pole(""), {"machine.beams.mast.I=0 cm^4"}), "I");
  expect_mistake(run_text(pole(""), {"machine.beams.mast.E=0 GPa"}), "E");
  expect_mistake(run_text(pole(", steel: S355")), "'W'");
  expect_mistake(run_text(pole(", section: \"CHS 219.1x8\"")), "section");
  expect_mistake(run_text(pole("", "  bodies: {mast: {mass: 3 kg}}\n")), "already");
  expect_mistake(run_text(pole(", top: clamped, imperfection: {sway: 0.003}")), "free top");
}

}  // namespace machine_beams_test
