#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Verdicts of whole decks: docs/guide/verdict.md.
namespace taut::verdict_deck_test {

using taut_test::run_text;

/// A clamped load on a line of 250 m; `more` follows the machine's parts.
std::string line(const std::string& rope, double length, const std::string& more, double mass = 1000) {
  return fmt::format(R"(taut: 1
machine:
  temperature: 15 degC
  points: {{head: [0 m, 0 m, 18 m], tail: [250 m, 0 m, 120 m]}}
  ropes: {{skyline: {}}}
  carriages: {{car: {{mass: 220 kg, rides: skyline, hold: clamped}}}}
  reevings: [{{rope: skyline, path: [{{anchor: head}}, {{through: car}}, {{anchor: tail}}], length: {} m}}]
  loads: [{{at: car, mass: {} kg}}]
{})",
                     rope, length, mass, more);
}

constexpr const char* strong = "{mass: 1.6 kg/m, stiffness: 26.6 MN, breaking_force: 279 kN}";
constexpr const char* middle = "analyses: [equilibrium: {carriage: car, x: 125 m}]\n";
constexpr const char* factor = "checks: {ropes: {skyline: {safety_factor: 3}}}\n";

struct Wanted {
  std::string deck, kind, verdict_class, reason;
  int exit = 0;
};

TEST(VerdictDeck, EveryStateCountsAndAskedMeansMade) {
  const std::string sweep =
      "analyses: [sweep: {parameter: \"loads[0].mass\", from: 0 t, to: 40 t, steps: 8, carriage: car, x: 125 m}]\n";
  const std::string put_up =
      "analyses: [installation: {reeving: skyline, temperatures: [-20 degC, 15 degC], given: {tension: 300 kN, at: "
      "end}}]\n";
  const std::vector<Wanted> all = {
      {.deck = line(strong, 272, middle),
       .kind = "not_judged",
       .verdict_class = "unasked",
       .reason = "skyline",
       .exit = 0},
      {.deck = line(strong, 272, std::string(middle) + factor),
       .kind = "passes",
       .verdict_class = "",
       .reason = "safety_factor",
       .exit = 0},
      {.deck = line(strong, 272, sweep),
       .kind = "fails",
       .verdict_class = "",
       .reason = "loads[0].mass = 40",
       .exit = 4},
      {.deck = line(strong, 272, sweep + factor), .kind = "fails", .verdict_class = "", .reason = "sweep", .exit = 4},
      {.deck = line(strong, 272, put_up), .kind = "fails", .verdict_class = "", .reason = "installation", .exit = 4},
      {.deck = line(strong, 250, middle),
       .kind = "fails",
       .verdict_class = "",
       .reason = "the rope is 250 m long and its ends are 270.01 m apart",
       .exit = 4},
      {.deck = line("{mass: 1.6 kg/m, stiffness: 26.6 MN}", 272, std::string(middle) + factor),
       .kind = "not_judged",
       .verdict_class = "unmade",
       .reason = "breaking force is not known",
       .exit = 4},
      {.deck = line(strong, 272, "  terrain: {x: [0 m, 125 m, 250 m], z: [15 m, 90 m, 15 m]}\n" + std::string(middle)),
       .kind = "fails",
       .verdict_class = "",
       .reason = "below the ground",
       .exit = 4},
      {.deck = line(strong, 272, std::string(middle) + "checks: {exempt: [skyline]}\n"),
       .kind = "not_judged",
       .verdict_class = "unasked",
       .reason = "",
       .exit = 0},
  };
  for (const Wanted& one : all) {
    const Result r = run_text(one.deck);
    ASSERT_TRUE(verdict_of(r)) << to_text(r.errors) << one.deck;
    const Verdict v = *verdict_of(r);
    EXPECT_EQ(to_text(v.kind), one.kind) << v.reason << "\n" << one.deck;
    EXPECT_EQ(v.verdict_class, one.verdict_class) << v.reason;
    EXPECT_NE(v.reason.find(one.reason), std::string::npos) << v.reason;
    EXPECT_EQ(exit_code(r), one.exit) << v.reason;
  }
}

TEST(VerdictDeck, WhatAnAnalysisLeavesOutIsSaid) {
  const std::string sweep =
      "analyses:\n  - equilibrium: {carriage: car, x: 125 m}\n  - sweep: {parameter: \"loads[0].mass\", from: 0 t, to: "
      "40 t, steps: 4, carriage: car, x: 125 m, judge: false}\n";
  const Result r = run_text(line(strong, 272, sweep + factor));
  EXPECT_EQ(to_text(verdict_of(r)->kind), "passes") << verdict_of(r)->reason << to_text(r.errors);
  EXPECT_NE(verdict_of(r)->reason.find("'judge: false': sweep"), std::string::npos) << verdict_of(r)->reason;
  const Result design = run_text(line("{}", 272,
                                      sweep + factor +
                                          "design: {ropes: {skyline: {construction: 6x36, core: IWRC, grade: 1960 MPa, "
                                          "modulus: 100 GPa}}}\n"));
  EXPECT_EQ(exit_code(design), 2) << "a design is judged in every state";
}

// A sweep of a building is judged value by value; that the line is put up is no state of the deck beside it.
TEST(VerdictDeck, ASweepThatIsJudgedApartMeetsTheInstallationOfEachValue) {
  const Result r = run_text(R"(taut: 1
machine:
  temperature: 10 degC
  points: {a: [0 m, 0 m, 0 m], b: [120 m, 0 m, 20 m], w: [121 m, 0 m, 18 m]}
  ropes:
    sky: {mass: 2 kg/m, stiffness: 20 MN, breaking_force: 330 kN, diameter: 22 mm}
    main: {mass: 0.5 kg/m, stiffness: 6 MN, breaking_force: 84 kN, diameter: 11 mm}
  supports: {tail: {at: [10 m, 0 m, 10 m], diameter: 500 mm, friction: 0.1}}
  carriages: {car: {mass: 1 t, rides: sky, mainline: main, at: [60 m, 0 m, 12 m]}}
  reevings:
    - {rope: sky, path: [{anchor: a}, {over: tail}, {through: car}, {anchor: b}], install: {tension: 32 kN, at: end}}
    - {rope: main, path: [{anchor: w}, {anchor: car}], length: 60 m}
analyses:
  - sweep: {parameter: supports.tail.at.z, from: 10 m, to: 12 m, steps: 2, carriage: car, x: 60 m}
checks: {ropes: {sky: {safety_factor: 3, sheave_weakening: covered}, main: {safety_factor: 3}}}
)");
  EXPECT_TRUE(r.unmade.empty()) << r.unmade.front();
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes) << verdict_of(r)->reason;
  ASSERT_NE(r.find_value("sky.dynamic_safety_factor"), nullptr);
  EXPECT_NEAR(r.find_value("sky.dynamic_safety_factor")->value, r.find_value("sky.safety_factor")->value, 1e-6)
      << "of the loaded line, not of the empty one alone";
}

TEST(VerdictDeck, ADesignNeverPicksWhatNobodyJudges) {
  const std::string choose =
      "design: {ropes: {skyline: {construction: 6x36, core: IWRC, grade: 1960 MPa, modulus: 100 GPa}}}\n";
  const Result none = run_text(line("{}", 272, middle + ("checks: {refuse_unverified: false}\n" + choose)));
  ASSERT_TRUE(verdict_of(none)) << to_text(none.errors);
  EXPECT_EQ(to_text(verdict_of(none)->kind), "no_answer") << verdict_of(none)->reason;
  EXPECT_NE(verdict_of(none)->reason.find("no limit"), std::string::npos) << verdict_of(none)->reason;
  const Result some = run_text(line("{}", 272, std::string(middle) + factor + choose));
  EXPECT_EQ(exit_code(some), 0) << verdict_of(some)->reason << to_text(some.errors);
}

TEST(VerdictDeck, ABreakOfTheDeckIsNoFailureByItself) {
  const Result r = run_text(
      line(strong, 272,
           "  events: [{at: 0.2 s, break: skyline}]\nanalyses: [transient: {duration: 0.4 s}]\n" + std::string(factor),
           500),
      {"machine.carriages.car.length_before=136 m"});
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  EXPECT_EQ(verdict_of(r)->reason.find("The deck breaks skyline"), 0U) << verdict_of(r)->reason;
  EXPECT_EQ(exit_code(r), 0) << verdict_of(r)->reason;
}

TEST(VerdictDeck, TheRestOfVibrationsIsJudged) {
  const std::string modes = "analyses: [modes: {count: 2}]\n";
  const std::vector<std::string> held = {"machine.carriages.car.length_before=136 m"};
  const Result light = run_text(line(strong, 272, modes + factor, 500), held);
  const Result heavy = run_text(line(strong, 272, modes + factor, 50000), held);
  ASSERT_TRUE(verdict_of(light) && verdict_of(heavy)) << to_text(light.errors);
  EXPECT_EQ(exit_code(light), 0) << verdict_of(light)->reason;
  EXPECT_EQ(exit_code(heavy), 4) << verdict_of(heavy)->reason;
  EXPECT_NE(verdict_of(heavy)->reason.find("skyline"), std::string::npos) << verdict_of(heavy)->reason;
}

TEST(VerdictDeck, WhatAMotionDipsIntoTheGroundFails) {
  const auto with = [](const std::string& level, const std::string& segments) {
    return run_text(R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 20 m], tail: [100 m, 0 m, 20 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 10 MN, breaking_force: 279 kN}}
  reevings: [{rope: line, path: [{anchor: head}, {anchor: tail}], length: 103 m, segments: )" +
                    segments + "}]\n  terrain: {x: [0 m, 100 m], z: [" + level + " m, " + level +
                    " m]}\nchecks: {ropes: {line: {safety_factor: 3}}}\n" +
                    "analyses: [transient: {duration: 0.1 s, branches: catenary}]\n");
  };
  // the sag is 10.7 m
  for (const char* segments : {"1", "8"}) {
    const Result clear = with("9", segments), dips = with("10", segments);
    ASSERT_TRUE(verdict_of(clear) && verdict_of(dips)) << to_text(clear.errors);
    EXPECT_EQ(exit_code(clear), 0) << verdict_of(clear)->reason;
    EXPECT_EQ(exit_code(dips), 4) << verdict_of(dips)->reason;
    EXPECT_NE(verdict_of(dips)->reason.find("below the ground"), std::string::npos) << verdict_of(dips)->reason;
  }
}

// 1 t falls by 0.3 m into its rope: sqrt(2 m g h EA/L) is 49 kN above its weight, so that the peak is 59 kN beside
// 9.8 kN at rest. The deck has that analysis at rest, in either order: to add it does not help.
TEST(VerdictDeck, APeakBeyondAnAnalysisAtRestAsksForNoOtherOne) {
  const auto snatched = [](const std::string& analyses) {
    const Result r = run_text(R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 4 MN, breaking_force: 130 kN}}
  bodies: {w: {mass: 1 t, at: [0 m, 0 m, -9.7 m], free: [x, z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: w}], length: 10 m}]
checks: {ropes: {r: {safety_factor: 3}}}
analyses: [)" + analyses + "]\n");
    EXPECT_EQ(exit_code(r), 4) << to_text(r.errors);
    return verdict_of(r)->reason;
  };
  const std::string motion = "transient: {duration: 1 s, start: assembled, output_step: 5 ms, damping_ratio: 0}";
  EXPECT_NE(snatched(motion).find("add an analysis at rest"), std::string::npos) << snatched(motion);
  for (const std::string& both : {motion + ", equilibrium: {}", "equilibrium: {}, " + motion}) {
    const std::string reason = snatched(both);
    EXPECT_NE(reason.find("the motion reaches 59"), std::string::npos) << reason;
    EXPECT_EQ(reason.find("add an analysis at rest"), std::string::npos) << reason;
    EXPECT_NE(reason.find("less slack"), std::string::npos) << reason;
  }
}

/// A line of 600 m with a sag of 33 m over a hill between two points of a motion's polygon, at rest and in a motion.
Result over_a_hill(double peak, const std::string& analysis, int segments = 1, double length = 604.2) {
  return run_text(fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 42 m], b: [600 m, 0 m, 42 m]}}
  ropes: {{sky: {{mass: 2 kg/m, stiffness: 25 MN, breaking_force: 400 kN, damping_ratio: 0.1}}}}
  reevings: [{{rope: sky, path: [{{anchor: a}}, {{anchor: b}}], length: {} m, segments: {}}}]
  terrain: {{x: [0 m, 258.75 m, 318.75 m, 378.75 m, 600 m], z: [0 m, 0 m, {} m, 0 m, 0 m]}}
analyses: [{}]
checks: {{ropes: {{sky: {{safety_factor: 2}}}}}}
)",
                              length, segments, peak, analysis));
}

// The points of its pictures lie on the catenary, and the chords between them up to sag/16^2 = 0.13 m above it: at rest
// the hill was 0.052 m above the rope, and in the motion 0.079 m below it.
TEST(VerdictDeck, AMotionAtRestClearsTheGroundAsTheStaticsDo) {
  const auto clearance = [](const Result& r) { return taut_test::value_of(r, "rope_clearance_min"); };
  for (const double peak : {9.05, 6.95}) {
    const double exact = clearance(over_a_hill(peak, "equilibrium: {}"));
    const Result motion = over_a_hill(peak, "transient: {duration: 0.1 s, tolerance: 1e-4, branches: catenary}");
    EXPECT_NEAR(clearance(motion), exact, 1e-6) << peak;
    EXPECT_EQ(exit_code(motion) == 4, exact < 0) << verdict_of(motion)->reason;
    // A chain of the same length hangs deeper, as it is longer than its chords by W^2/(24 T^2) of each: so it is safe,
    // and the nearer to the rope the more segments it has.
    double before = 1;
    for (const int n : {6, 12, 24}) {
      const double chain = clearance(over_a_hill(peak, "transient: {duration: 0.1 s, tolerance: 1e-4}", n));
      EXPECT_LT(chain, exact + 1e-3) << n;
      EXPECT_LT(exact - chain, before) << n;
      before = exact - chain;
    }
  }
  // a straight branch has the length of the rope, and hangs as it would; here 15 m deep
  const std::string straight = "transient: {duration: 0.1 s, tolerance: 1e-4, branches: straight}";
  EXPECT_NEAR(clearance(over_a_hill(9, straight, 1, 599.7)), clearance(over_a_hill(9, "equilibrium: {}", 1, 599.7)),
              1e-6);
}

TEST(VerdictDeck, ARopeThatMaySlackIsNoNewsInAMotion) {
  // a winch that lets the rope out faster than its load falls; the rope has two branches
  const auto with = [](const std::string& slack) {
    return run_text(R"(taut: 1
machine:
  signals: {haul: {sequence: [{at: 0.1 s, to: -3 m/s, over: 0.1 s}]}}
  ropes: {line: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 100 kN}}
  bodies: {load: {mass: 100 kg, at: [1 m, 0 m, 0 m], free: [z]}}
  sheaves: {top: {at: [0.9 m, 0 m, 10 m], diameter: 200 mm}}
  drums: {winch: {at: [-3 m, 0 m, 0 m], core_diameter: 200 mm, drive: {speed: haul}}}
  reevings: [{rope: line, path: [{drum: winch}, {over: top}, {anchor: load}], length: 20.5 m)" +
                    slack + "}]\nanalyses: [transient: {duration: 0.3 s}]\n");
  };
  const auto of_slack = [](const Result& r) {
    return std::count_if(r.warnings.begin(), r.warnings.end(),
                         [](const std::string& w) { return w.find("goes slack") != std::string::npos; });
  };
  EXPECT_EQ(of_slack(with("")), 2);
  EXPECT_EQ(of_slack(with(", may_slack: true")), 0);
}

TEST(VerdictDeck, TerrainCoversWhatAClearanceIsAskedOf) {
  const auto with = [](const std::string& x, const std::string& z) {
    return run_text(line(strong, 272,
                         "  terrain: {x: " + x + ", z: " + z +
                             "}\nanalyses: [payload: {carriage: car, from: 60 m, to: " +
                             "190 m, steps: 4, limits: {skyline: {safety_factor: 3}, clearance: 3 m}}]\n"));
  };
  const Result whole = with("[0 m, 250 m]", "[-40 m, -40 m]");
  EXPECT_EQ(exit_code(whole), 0) << verdict_of(whole)->reason << to_text(whole.errors);
  EXPECT_NE(verdict_of(whole)->reason.find("carries"), std::string::npos) << "the payload is the headline";
  const Result half = with("[0 m, 150 m]", "[-40 m, -40 m]");
  EXPECT_EQ(verdict_of(half)->verdict_class, "unmade") << verdict_of(half)->reason << to_text(half.errors);
  EXPECT_NE(verdict_of(half)->reason.find("40 m"), std::string::npos) << verdict_of(half)->reason;
}

/// A slide of 100 kg between two ropes of just their lengths, pulled tight in turn: both are slack at first.
std::string slide(const std::string& pulls) {
  return R"(taut: 1
machine:
  ropes: {a: {mass: 0 kg/m, stiffness: 5 MN, breaking_force: 60 kN}}
  bodies: {s: {mass: 100 kg, at: [0 m, 0 m, 0 m], guide: [1, 0, 0]}}
  points: {pa: [-10 m, 0 m, 0 m], pb: [10 m, 0 m, 0 m], pc: [10 m, 0 m, 1 m]}
  reevings:
    - {rope: a, path: [{anchor: pa}, {anchor: s}], length: 10 m}
    - {rope: a, name: b, path: [{anchor: pb}, {anchor: s}], length: 10 m}
    - {rope: a, name: c, path: [{anchor: pc}, {anchor: s}], length: 11 m}
analyses: [pretension: {pull: [{rope: a, until: s.x, moves: 5 mm}, {rope: b, force: 8 kN})" +
         pulls + R"(]}]
checks: {ropes: {a: {safety_factor: 2}, b: {safety_factor: 2}}, exempt: [c]}
)";
}

/// It is one motion, shown pull by pull: a rope is slack all the time where no pull tightens it.
TEST(VerdictDeck, APretensionThatTightensARopeHasItNotSlackAllTheTime) {
  const Result r = run_text(slide(""));
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  std::vector<std::string> slack;
  for (const std::string& one : r.warnings) {
    if (one.find("slack all the time") != std::string::npos) slack.push_back(one);
  }
  ASSERT_EQ(slack.size(), 1U) << verdict_of(r)->reason;
  EXPECT_EQ(slack.front(), "pretension: c between pc and s is slack all the time");
  EXPECT_TRUE(r.unsafe.empty()) << r.unsafe.front();  // c is exempt
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes) << verdict_of(r)->reason;
}

/// All ropes that a deck breaks are named, those of one time together.
TEST(VerdictDeck, EachBreakIsNamed) {
  const auto preface = [](const std::string& events) {
    return run_text(R"(taut: 1
machine:
  ropes: {l: {mass: 0.5 kg/m, stiffness: 5 MN, breaking_force: 40 kN, damping_ratio: 0.05}}
  bodies: {b: {mass: 1 t, at: [0 m, 0 m, 0 m], free: [x, z]}}
  points: {pl: [-5 m, 0 m, 5 m], pr: [5 m, 0 m, 5 m], pm: [0 m, 0 m, 5 m]}
  reevings:
    - {rope: l, path: [{anchor: pl}, {anchor: b}], length: 7.07 m}
    - {rope: l, name: r, path: [{anchor: pr}, {anchor: b}], length: 7.07 m}
  events: )" + events +
                    R"(
analyses: [transient: {duration: 0.5 s, output_step: 0.1 s}]
checks: {ropes: {l: {safety_factor: 1}}}
)")
        .preface;
  };
  EXPECT_EQ(preface("[{at: 0.2 s, break: r}, {at: 0.2 s, break: l}]"), "The deck breaks r and l at 0.2 s");
  EXPECT_EQ(preface("[{at: 0.3 s, break: l}, {at: 0.2 s, break: r}]"), "The deck breaks r at 0.2 s, l at 0.3 s");
  EXPECT_EQ(preface("[{at: 0.2 s, break: r}]"), "The deck breaks r at 0.2 s");
}

}  // namespace taut::verdict_deck_test
