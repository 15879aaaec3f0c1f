#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "test/support/guyed_decks.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::guy_checks_test {

using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::guyed;
using taut_test::run_text;
using taut_test::value_of;

TEST(GuyChecks, AllGuysOfARope) {
  const Result r = run_text(guyed("  guys: {guy: {dynamic_factor: 1.2, pretension: [0.05, 0.09]}}\n"));
  for (const std::string g : {"g1", "g2", "g3", "g4"}) {
    const double T = value_of(r, g + ".T_max");
    EXPECT_NEAR(check_of(r, g + ".guy_safety").value, 200e3 / (1.2 * T), 1e-9 * 200e3 / T);
    EXPECT_NEAR(check_of(r, g + ".pretension_max").value, 0.1, 1e-12);  // as put up
    // let go, the guys shorten the mast and lose 4 (EA/L) (h/L)^2 h/EA_mast of their tension: EA/L = 833 kN/m, h/L =
    // 2/3
    EXPECT_NEAR(check_of(r, g + ".pretension_min").value, 0.1 / (1 + 4 * 833.3e3 * 4 / 9 * 12 / 1.114e9), 2e-4);
    EXPECT_TRUE(check_of(r, g + ".pretension_min").passes);
    EXPECT_FALSE(check_of(r, g + ".pretension_max").passes);
    EXPECT_TRUE(check_of(r, g + ".slackness").passes);
  }
  EXPECT_NE(check_of(r, "g1.guy_safety").trust.find("UNVERIFIED"), std::string::npos);
  const Result own = run_text(guyed("  guys: {g1: {safety_factor: 3}}\n"));
  EXPECT_EQ(check_of(own, "g1.guy_safety").trust, "user");
  const Result ruled = run_text(guyed("  guys: {g1: {rule: safety.guyline.ch_at}}\n"));
  EXPECT_NEAR(check_of(ruled, "g1.guy_safety").limit, 3, 1e-12);
}

// A share of the breaking force, and the strength of an extension over its skyline, are no safety factors.
TEST(GuyChecks, ARuleThatIsNoFactorIsRefused) {
  for (const std::string rule : {"strength.skyline_elastic_limit", "strength.skyline_extension.us_wa"}) {
    expect_mistake(run_text(guyed("  guys: {g1: {rule: " + rule + "}}\n")), "is no safety factor");
  }
}

// Modes and quasi-static motions are states at rest: the dynamic factor counts in them as in an equilibrium.
TEST(GuyChecks, StatesOfRestHaveTheDynamicFactor) {
  const auto deck = [](const std::string& analysis) {
    return R"(taut: 1
machine:
  ropes: {g: {mass: 0.1 kg/m, stiffness: 20 MN, breaking_force: 130 kN}}
  points: {a: [0 m, 0 m, 20 m], b: [10 m, 0 m, 20 m]}
  bodies: {load: {mass: 4 t, at: [5 m, 0 m, 15 m], free: [x, z]}}
  guys: {g1: {rope: g, from: a, to: load, length: 7 m}, g2: {rope: g, from: b, to: load, length: 7 m}}
analyses: [)" +
           analysis +
           R"(]
checks: {guys: {g: {safety_factor: 3, dynamic_factor: 2}}, anchors: {a: {strength: 50 kN, dynamic_factor: 2}}}
)";
  };
  const Result rest = run_text(deck("equilibrium: {}"));
  const double guy = check_of(rest, "g1.guy_safety").value, anchor = check_of(rest, "a.anchor_strength").value;
  EXPECT_LT(anchor, 1);
  for (const std::string analysis :
       {"modes: {}", "transient: {duration: 1 s, quasi_static: true, output_step: 0.5 s}"}) {
    const Result same = run_text(deck(analysis));
    EXPECT_NEAR(check_of(same, "g1.guy_safety").value, guy, 1e-3 * guy) << analysis;
    EXPECT_NEAR(check_of(same, "a.anchor_strength").value, anchor, 1e-3 * anchor) << analysis;
  }
}

/// What the pulls of a `pretension` leave is a pretension too, also of a guy that has a length.
TEST(GuyChecks, AGuyThatIsPulledKeepsWithinItsWindow) {
  const auto deck = [](const std::string& own, const std::string& analysis) {
    return R"(taut: 1
machine:
  ropes: {wire: {mass: 1 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
  points: {top: [0 m, 0 m, 14 m], stake: [15 m, 0 m, 0 m]}
  guys: {g: {rope: wire, from: top, to: stake, )" +
           own + R"(}}
checks: {guys: {g: {safety_factor: 2, pretension: [0.08, 0.15]}}}
analyses:
  - )" + analysis +
           "\n";
  };
  const Result put_up = run_text(deck("install: {tension: 30 kN}", "equilibrium: {}"));
  EXPECT_NEAR(check_of(put_up, "g.pretension_max").value, 0.1, 1e-9);
  const std::string to_90 = "pretension: {pull: [{rope: g, force: 10 kN}, {rope: g, force: 90 kN}]}";
  for (const char* own : {"install: {tension: 30 kN}", "length: 20.5 m"}) {
    const Result r = run_text(deck(own, to_90));
    EXPECT_NEAR(check_of(r, "g.pretension_max").value, 0.3, 1e-6);
    EXPECT_FALSE(check_of(r, "g.pretension_max").passes);
    EXPECT_TRUE(check_of(r, "g.pretension_min").passes) << "10 kN are on the way";
  }
  const Result least = run_text(deck("length: 20.5 m", "pretension: {least: {ropes: [g], tension: 60 kN}}"));
  EXPECT_FALSE(check_of(least, "g.pretension_max").passes);
}

TEST(GuyChecks, SlackGuyIsTold) {
  const Result r = run_text(guyed("  guys: {guy: {}}\n", "[90 kN, 0 N, -20 kN]"));
  EXPECT_FALSE(check_of(r, "g3.slackness").passes);
  EXPECT_TRUE(check_of(r, "g1.slackness").passes);
  // pulled the other way, the others
  const Result s = run_text(guyed("  guys: {guy: {}}\n", "[-90 kN, 0 N, -20 kN]"));
  EXPECT_FALSE(check_of(s, "g1.slackness").passes);
  EXPECT_TRUE(check_of(s, "g3.slackness").passes);
}

// No tension makes an inextensible guy as short as its chord, unless it has no weight: then any tension does.
TEST(GuyChecks, AnInextensibleGuyIsNotJudgedForSlackness) {
  const auto with = [](const char* rope, const char* checks) {
    std::string deck = guyed(fmt::format("  guys: {{guy: {}}}\n  masts: {{mast: {{load_factor: 1.35}}}}\n", checks));
    const std::string own = "{mass: 1.2 kg/m, stiffness: 15 MN,";
    deck.replace(deck.find(own), own.size(), rope);
    return run_text(deck);
  };
  const Result heavy = with("{mass: 1.2 kg/m, stiffness: .inf,", "{}");
  ASSERT_EQ(heavy.status, Status::ok) << heavy.message << to_text(heavy.errors);
  EXPECT_FALSE(taut_test::has_check(heavy, "g1.slackness"));
  EXPECT_THAT(heavy.unmade, testing::Contains(testing::HasSubstr("g1: whether it hangs slack is not checked")));
  EXPECT_THAT(with("{mass: 1.2 kg/m, stiffness: .inf,", "{may_go_slack: true}").unmade, testing::IsEmpty());
  EXPECT_TRUE(check_of(with("{mass: 0 kg/m, stiffness: .inf,", "{}"), "g1.slackness").passes);
}

TEST(GuyChecks, StiffTopAgainstEuler) {
  const Result r = run_text(guyed("  masts: {mast: {top_criterion: 3}}\n", "[1 N, 0 N, -1 N]"));
  const auto& c = check_of(r, "mast.top_stiffness");
  const double I = std::numbers::pi / 64 * (std::pow(0.2191, 4) - std::pow(0.2031, 4));
  const double N_cr = std::pow(std::numbers::pi / 12, 2) * 210e9 * I;
  EXPECT_NEAR(c.limit / (3 * N_cr / 12), 1, 1e-5);
  // four guys, 18 m long: along y 4 (EA/L) (6/18)^2 and the tension's part (T/L) (1 - (6/18)^2); sag takes little
  const double L = 18, k = 4 * (15e6 / L / 9 + 20e3 / L * 8 / 9);
  EXPECT_NEAR(c.value / k, 1, 0.02);
}

// As if nothing held: the tension of a guy in a motion counts as it is, at rest times its factor.
TEST(GuyChecks, PeakOfAMotionCounts) {
  const std::string deck = R"(taut: 1
machine:
  ropes: {guy: {mass: 0.1 kg/m, stiffness: 1 MN, breaking_force: 100 kN}}
  points: {top: [0 m, 0 m, 0 m], eye: {body: load, at: [0 m, 0 m, 0 m]}}
  bodies: {load: {mass: 500 kg, at: [0 m, 0 m, -10 m], free: [x, z]}}
  guys: {g: {rope: guy, from: top, to: eye, length: 10 m}}
analyses:
  - transient: {name: drop, duration: 0.5 s, output_step: 1 ms, start: assembled, damping_ratio: 0, rope_mass: false}
checks:
  guys: {g: {safety_factor: 5, dynamic_factor: 1.5}}
  anchors: {top: {strength: 50 kN, dynamic_factor: 1.5}}
)";
  const Result r = run_text(deck);
  const double W = 500 * 9.80665;  // let go at its natural length: twice the weight
  EXPECT_NEAR(check_of(r, "g.guy_safety").value * 2 * W / 100e3, 1, 2e-3);
  EXPECT_NE(check_of(r, "g.guy_safety").rule.find("drop, t = "), std::string::npos);
  EXPECT_NEAR(check_of(r, "top.anchor_strength").value * 2 * W / 50e3, 1, 2e-3);
  EXPECT_FALSE(check_of(r, "g.slackness").passes);  // it begins without tension
  std::string with_rest = deck;
  with_rest.insert(with_rest.find("  - transient"), "  - equilibrium: {}\n");
  const Result both = run_text(with_rest);  // 1.5 W is less
  EXPECT_NEAR(check_of(both, "g.guy_safety").value, check_of(r, "g.guy_safety").value, 1e-9);
  const Result rest = run_text(with_rest, {"checks.guys.g.dynamic_factor=3"});
  EXPECT_NEAR(check_of(rest, "g.guy_safety").value * 3 * W / 100e3, 1, 2e-2);  // 3 (W + weight of the rope)
}

// One of four guys is cut: it is not slack because of that. The one across from it is, as nothing pulls against it.
TEST(GuyChecks, AGuyIsJudgedUpToItsBreak) {
  const auto mast = [](const std::string& events) {
    return run_text(R"(taut: 1
machine:
  ropes: {guy: {mass: 0.1 kg/m, stiffness: 5 MN, breaking_force: 200 kN, damping_ratio: 0.3}}
  points: {top: {body: mast, at: [0 m, 0 m, 16 m]}, a: [-20 m, 0 m, 0 m], b: [20 m, 0 m, 0 m]}
  bodies: {mast: {mass: 2 t, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 8 m], inertia: 40000 kg m^2, free: [ry]}}
  guys:
    left: {rope: guy, from: top, to: a, install: {tension: 30 kN}}
    right: {rope: guy, from: top, to: b, install: {tension: 30 kN}}
  loads: [{at: top, force: [5 kN, 0 kN, 0 kN]}]
)" + events + R"(analyses: [{transient: {duration: 1.2 s, output_step: 20 ms, tolerance: 1e-4}}]
checks: {guys: {guy: {safety_factor: 3}}}
)");
  };
  const Result whole = mast(""), broken = mast("  events: [{at: 1 s, break: left}]\n");
  const double least = check_of(whole, "left.slackness").value;
  EXPECT_GT(least, 1e3);
  EXPECT_NEAR(check_of(broken, "left.slackness").value, least, 1e-3 * least);
  EXPECT_FALSE(check_of(broken, "right.slackness").passes);
}

// A heavy guy that a force draws out as far as it does at rest: the upper end has more than the mean, which is what
// tells whether it hangs slack.
TEST(GuyChecks, SlacknessInAMotionIsThatAtRest) {
  const auto drawn = [](const std::string& load, const std::string& analysis) {
    return run_text(R"(taut: 1
machine:
  signals: {pull: {ramp: {from: 60 kN, to: 30 kN, start: 1 s, duration: 20 s, smooth: true}}}
  ropes: {guy: {mass: 10 kg/m, stiffness: 20 MN, breaking_force: 1000 kN, damping_ratio: 0.1}}
  bodies: {slide: {mass: 2.5 t, at: [0 m, 0 m, 100 m], free: [x]}}
  points: {stump1: [-100 m, 0 m, 0 m]}
  guys: {g1: {rope: guy, from: slide, to: stump1, length: 141.5 m}}
  loads: [{at: slide, force: )" +
                    load + "}]\nanalyses: [{" + analysis + "}]\nchecks: {guys: {g1: {}}}\n");
  };
  const Result rest = drawn("[30 kN, 0 N, 0 kN]", "equilibrium: {motion: at_rest}");
  const Check still = check_of(rest, "g1.slackness");
  EXPECT_FALSE(still.passes);
  for (const char* how : {"branches: catenary", "branches: catenary, quasi_static: true, output_step: 0.5 s"}) {
    const Result r = drawn("[60 kN, 0 N, 0 kN], signal: pull", std::string("transient: {duration: 40 s, ") + how + "}");
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_NEAR(check_of(r, "g1.slackness").value, still.value, 2e-3 * still.value) << how;
    EXPECT_FALSE(check_of(r, "g1.slackness").passes);
  }
}

TEST(GuyChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(guyed("  guys: {g9: {}}\n")), "no guy");
  expect_mistake(run_text(guyed("  guys: {g1: {pretension: [0.2, 0.1]}}\n")), "[0.08, 0.15]");
  expect_mistake(run_text(guyed("  guys: {g1: {rule: layout.tail_tree_angle}}\n")), "no safety factor");
}

/// A mast on a hinge between four equal guys, put up with 101 kN; in use it is pressed down a little.
Result put_up_at_its_strength(const std::string& checks) {
  return run_text(R"(taut: 1
machine:
  ropes: {guy: {mass: 1 kg/m, stiffness: 12 MN, breaking_force: 100 kN, diameter: 16 mm}}
  points: {e: [9 m, 0 m, 0 m], n: [0 m, 9 m, 0 m], w: [-9 m, 0 m, 0 m], s: [0 m, -9 m, 0 m]}
  bodies: {head: {mass: 10 kg, at: [0 m, 0 m, 12 m], free: [x, y]}}
  guys:
    g1: {rope: guy, from: head, to: e, install: {tension: 101 kN, at: top}}
    g2: {rope: guy, from: head, to: n, install: {tension: 101 kN, at: top}}
    g3: {rope: guy, from: head, to: w, install: {tension: 101 kN, at: top}}
    g4: {rope: guy, from: head, to: s, install: {tension: 101 kN, at: top}}
  temperature: 20 degC
analyses: [{sweep: {parameter: temperature, from: 60 degC, to: 80 degC, steps: 1}}]
checks: {)" + checks +
                  "}\n");
}

// The state in which guys are put up is one of theirs: by any check, or none.
TEST(GuyChecks, GuysBreakWhereTheyArePutUp) {
  const Result by_guys = put_up_at_its_strength("guys: {guy: {safety_factor: 1, check_pretension: false}}");
  ASSERT_EQ(by_guys.status, Status::ok) << by_guys.message << to_text(by_guys.errors);
  EXPECT_NEAR(check_of(by_guys, "g1.guy_safety").value, 100.0 / 101, 1e-9);
  EXPECT_NE(check_of(by_guys, "g1.guy_safety").rule.find("as the guys are put up"), std::string::npos);
  const Result by_ropes = put_up_at_its_strength("ropes: {guy: {safety_factor: 1}}");
  EXPECT_NEAR(check_of(by_ropes, "g1.safety_factor").value, 100.0 / 101, 1e-9);
  const Result by_nobody = put_up_at_its_strength("anchors: {e: {strength: 100 kN}}");
  EXPECT_FALSE(check_of(by_nobody, "g1.T_max").passes);
  EXPECT_NEAR(check_of(by_nobody, "e.anchor_strength").value, 1, 0.01);
}

// The moment in which guys are put up shows nothing of the machine in use.
TEST(GuyChecks, AMachineThatIsPutUpAloneIsNotJudged) {
  const auto judged = [](const char* judge) {
    return run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{guy: {{mass: 1 kg/m, stiffness: 12 MN, breaking_force: 200 kN, diameter: 16 mm}}}}
  points: {{e: [9 m, 0 m, 0 m], w: [-9 m, 0 m, 0 m]}}
  bodies: {{head: {{mass: 10 kg, at: [0 m, 0 m, 12 m], free: [x]}}}}
  guys:
    g1: {{rope: guy, from: head, to: e, install: {{tension: 20 kN, at: top}}}}
    g2: {{rope: guy, from: head, to: w, install: {{tension: 20 kN, at: top}}}}
analyses: [{{equilibrium: {{judge: {}}}}}]
checks: {{guys: {{guy: {{safety_factor: 3}}}}, anchors: {{e: {{strength: 50 kN}}, w: {{strength: 50 kN}}}}}}
)",
                                judge));
  };
  EXPECT_THAT(judged("true").unmade, testing::IsEmpty());
  EXPECT_THAT(judged("false").unmade,
              testing::Contains(testing::HasSubstr("no state of the machine in use is judged")));
}

}  // namespace taut::checks::guy_checks_test
