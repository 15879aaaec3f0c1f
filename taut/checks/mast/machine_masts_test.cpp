#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/section_search.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::machine_masts_test {

using namespace taut_test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// 20 m on a hinge, guyed at its top and, with `middle`, at half its height; pushed at a quarter.
Result guyed(const std::string& bow, bool middle, const std::string& more = "") {
  std::string guys;
  for (int i = 1; i <= 3; ++i) {
    guys += fmt::format("    g{0}: {{rope: guy, from: mast.top, to: a{0}, install: {{tension: 14 kN, at: top}}}}\n", i);
    if (middle)
      guys += fmt::format("    m{0}: {{rope: guy, from: mid, to: a{0}, install: {{tension: 14 kN, at: top}}}}\n", i);
  }
  return run_text(fmt::format(
      "taut: 1\nmachine:\n  ropes: {{guy: {{mass: 0 kg/m, stiffness: 20 MN, breaking_force: 279 kN}}}}\n"
      "  points:\n    foot: [0 m, 0 m, 0 m]\n    head: [0 m, 0 m, 20 m]\n    mid: {{body: mast, at: [0 m, 0 "
      "m, 10 m]}}\n    quarter: {{body: mast, at: [0 m, 0 m, 5 m]}}\n    a1: [-20 m, 0 m, 0 m]\n    a2: [10 "
      "m, 17.32 m, 0 m]\n    a3: [10 m, -17.32 m, 0 m]\n{}  beams: {{mast: {{from: foot, to: head, section: "
      "CHS 139.7x6.3, steel: S355, base: hinge, mass: 0 kg/m, imperfection: {{bow: {}, sway: 0.012, towards: "
      "[1, 0, 0]}}}}}}\n  guys:\n{}  loads:\n    - {{at: mast.top, force: [{} kN, 0 kN, -{} kN]}}\n    - "
      "{{at: quarter, force: [{} kN, 0 kN, 0 kN]}}\nanalyses: [{{equilibrium: {{}}}}]\nchecks: {{guys: "
      "{{guy: {{safety_factor: 3, pretension: [0.001, 0.2], may_go_slack: true}}}}, masts: {{mast: "
      "{{load_factor: 1.0}}}}}}\n",
      more, bow, guys, 5, middle ? 70 : 10, middle ? 3.6 : 0.4));
}

// A half wave over 20 m has no bow in a bay of 10 m that buckles by itself: (6.61) is asked for, however large it is.
TEST(MachineMasts, OneBowOverTwoBaysIsNoneOfABay) {
  for (const char* bow : {"0.0032", "0.00334"}) {
    const Result r = guyed(bow, true);
    ASSERT_TRUE(has_check(r, "mast.member")) << r.message << to_text(r.errors);
    EXPECT_GT(check_of(r, "mast.member").value, 1.5);
  }
}

// Where only a load stands between its ends, it is the member's, 5.2.2 (7) a. On its guys alone the mast is not bent in
// the direction of its sway: (6.61) is asked for there, by hand 0.7505 + 0.9 (1 + 0.8 0.7505) 0.1319.
TEST(MachineMasts, OneBowFromHoldToHoldIsThatOfTheMember) {
  EXPECT_THAT(check_of(guyed("0.0032", false), "mast.member").rule, HasSubstr("annex B; at rest"));
  const Result r = guyed("0.00334", false);
  EXPECT_TRUE(has_check(r, "mast.section")) << r.message << to_text(r.errors);
  EXPECT_THAT(check_of(r, "mast.member").rule, HasSubstr("on its guys alone"));
  EXPECT_NEAR(check_of(r, "mast.member").value, 0.940, 1e-3);
}

/// A cantilever of 8 m in `parts` beams, `down` N at its top; `more` beams beside it.
Result upright(int parts, double down, double factor, const std::string& imperfection = "", bool strut = false) {
  std::string points, beams, names;
  for (int i = 1; i <= parts; ++i) {
    points += fmt::format("    j{}: [0 m, 0 m, {} m]\n", i, 8.0 * i / parts);
    beams += fmt::format("    b{}: {{from: {}, to: j{}, section: CHS 219.1x8, steel: S355, mass: 0 kg/m{}}}\n", i,
                         i == 1 ? std::string("foot") : fmt::format("b{}.top", i - 1), i, imperfection);
    names += fmt::format("{}b{}", i == 1 ? "" : ", ", i);
  }
  std::string loads = fmt::format("{{at: b{}.top, force: [0.1 kN, 0 kN, {} N]}}", parts, -down);
  if (strut) {
    points += "    f: [5 m, 0 m, 0 m]\n    h: [5 m, 0 m, 8 m]\n";
    beams += "    other: {from: f, to: h, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}\n";
    loads += ", {at: other.top, force: [0 kN, 0 kN, -90 kN]}";
  }
  return run_text(
      fmt::format("taut: 1\nmachine:\n  points:\n    foot: [0 m, 0 m, 0 m]\n{}  beams:\n{}  loads: [{}]\n"
                  "analyses: [{{equilibrium: {{}}}}]\nchecks: {{masts: {{all: {{beams: [{}], load_factor: "
                  "{}}}}}}}\n",
                  points, beams, loads, names, factor));
}

// pi^2 E I/(4 L^2) over 100 kN, in however many beams it stands: the sum of Dunkerley's would be 1.62.
TEST(MachineMasts, AMastOfManyBeamsHasTheFactorOfAll) {
  const double alpha = std::pow(std::numbers::pi / 16, 2) * 210e9 * catalogue::find_section("CHS 219.1x8")->I_y / 100e3;
  const Result one = upright(1, 100e3, 2), four = upright(4, 100e3, 2);
  EXPECT_NEAR(check_of(four, "all.buckling").value, check_of(one, "all.buckling").value, 1e-3);
  EXPECT_NEAR(check_of(four, "all.section").value, check_of(one, "all.section").value, 1e-3);
  EXPECT_TRUE(check_of(four, "all.buckling").passes);
  const std::string rule = check_of(upright(4, 100e3, 1.01 * alpha), "all.section").rule;
  EXPECT_NE(rule.find("the mast buckles, its critical factor is 2.39"), std::string::npos) << rule;
}

/// One mast of 8 m under 100 kN with these keys of its check.
Result checked(const std::string& keys) {
  return run_text(
      "taut: 1\nmachine:\n  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 8 m]}\n  beams: {m: {from: "
      "foot, to: head, section: CHS 219.1x8, steel: S355, mass: 0 kg/m}}\n  loads: [{at: m.top, force: [0.1 "
      "kN, 0 kN, -100 kN]}]\nanalyses: [{equilibrium: {name: rest}}]\nchecks: {masts: {m: {" +
      keys + "}}}\n");
}

// A cantilever of 8 m buckles as a column of 16 m.
TEST(MachineMasts, ABucklingLengthShorterThanThatOfTheMachineIsUnsafe) {
  const Result r = checked("load_factor: 1.35, buckling_length: 4 m");
  EXPECT_THAT(r.unsafe, Contains(HasSubstr("'buckling_length' of 4 m is shorter than that of the machine, 16 m")));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes_with_warnings) << verdict_of(r)->reason;
  EXPECT_THAT(checked("load_factor: 1.35, buckling_length: 16 m").unsafe, IsEmpty());
}

TEST(MachineMasts, LoadsThatCountWithLessThanTheyAreAreUnsafe) {
  EXPECT_THAT(checked("load_factor: 0.3").unsafe, Contains(HasSubstr("its forces count with a factor of 0.3")));
  EXPECT_THAT(checked("load_factor: 0.8, dynamic_factor: 1.3").unsafe, IsEmpty());
  EXPECT_THAT(checked("combinations: {U: {rest: 0.2}}").unsafe, Contains(HasSubstr("the forces of 'rest' count with")));
  EXPECT_THAT(checked("combinations: {U: {rest: 0.2}, V: {rest: 1.35}}").unsafe, IsEmpty());
}

// With a beam beside it that presses too, the sum is what is known, and said to be a bound.
TEST(MachineMasts, BesideOthersThatPressABoundIsCalledOne) {
  const Result r = upright(4, 100e3, 2, "", true);
  const std::string rule = check_of(r, "all.section").rule;
  EXPECT_NE(rule.find("the mast may buckle, its critical factor is at least 1.62"), std::string::npos) << rule;
  EXPECT_NE(rule.find("Dunkerley"), std::string::npos) << rule;
}

/// A slender tower of 14 m on a hinge and three guys of 40 kN, which a load lifts: it is pressed most where it stands
/// alone.
Result lifted(const std::string& section, const std::string& force, const std::string& mast = "load_factor: 1.5",
              const std::string& head = "mast.top") {
  std::string guys;
  for (int i = 1; i <= 3; ++i) {
    guys +=
        fmt::format("    g{0}: {{rope: guy, from: {1}, to: s{0}, install: {{tension: 40 kN, at: top}}}}\n", i, head);
  }
  return run_text(fmt::format(
      "taut: 1\nmachine:\n  ropes: {{guy: {{mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 279 kN}}}}\n  points:\n"
      "    foot: [0 m, 0 m, 0 m]\n    head: [0 m, 0 m, 14 m]\n    lug: {{body: mast, at: [0 m, 0 m, 14 m]}}\n    s1: "
      "[-14 m, 0 m, 0 m]\n    s2: [7 m, 12 m, 0 m]\n    s3: [7 m, -12 m, 0 m]\n  beams: {{mast: {{from: foot, to: "
      "head, section: {}, steel: S355, base: hinge}}}}\n  guys:\n{}  loads: [{{at: mast.top, force: [0 kN, 0 kN, "
      "{}]}}]\nanalyses: [{{equilibrium: {{name: work}}}}]\nchecks: {{guys: {{guy: {{safety_factor: 3, may_go_slack: "
      "true}}}}, masts: {{mast: {{{}}}}}}}\n",
      section, guys, force, mast));
}

// As it stands on its guys alone it is as in the equilibrium of the same machine without its load.
TEST(MachineMasts, OnItsGuysAloneItIsJudgedToo) {
  const Result up = lifted("CHS 168.3x6.3", "75 kN"), unloaded = lifted("CHS 168.3x6.3", "0 kN");
  const Check &worst = check_of(up, "mast.section"), &same = check_of(unloaded, "mast.section");
  EXPECT_FALSE(worst.passes);
  EXPECT_THAT(worst.rule, HasSubstr("on its guys alone, unloaded: under 1.5 times its forces the mast buckles"));
  EXPECT_THAT(same.rule, HasSubstr("under 1.5 times its forces the mast buckles"));
  EXPECT_THAT(lifted("CHS 219.1x8", "75 kN").unmade, IsEmpty());
  EXPECT_NEAR(check_of(lifted("CHS 219.1x8", "75 kN"), "mast.buckling").value,
              check_of(lifted("CHS 219.1x8", "0 kN"), "mast.buckling").value, 1e-3);
}

// Under its load it is pulled; let go on its guys without it, 82 kN are three times what it holds.
TEST(MachineMasts, WhatItsGuysAlonePressDownIsNotJudged) {
  const Result r = lifted("CHS 114.3x5", "75 kN");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_THAT(r.unmade, Contains(HasSubstr("stands on its guys alone, unloaded: beam 'mast' buckles")));
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged) << verdict_of(r)->reason;
}

// What is put up has the factor of each combination, unless one names it.
TEST(MachineMasts, WhatIsPutUpCountsInEveryCombination) {
  const auto rule = [](const Result& r) { return check_of(r, "mast.buckling").rule; };
  const Result all = lifted("CHS 219.1x8", "75 kN", "combinations: {ULS: {work: 1.5}}");
  EXPECT_THAT(all.unjudged, IsEmpty()) << to_text(all.errors);
  EXPECT_THAT(rule(all), HasSubstr("ULS: as the machine stands on its guys alone"));
  const Result named = lifted("CHS 219.1x8", "75 kN", "combinations: {ULS: {work: 1.5}, UP: {installation: 1.2}}");
  EXPECT_THAT(named.unjudged, IsEmpty()) << to_text(named.errors);
  EXPECT_NEAR(check_of(named, "mast.buckling").value, 1.2 / 1.5 * check_of(all, "mast.buckling").value, 1e-3);
}

// Guys at a point of the beam that is its top hold the top.
TEST(MachineMasts, GuysAtALugOnItsTopHoldIt) {
  const std::string keys = "load_factor: 1.5, top_criterion: 3, plate: {guys: 3}";
  const Result lug = lifted("CHS 219.1x8", "10 kN", keys, "lug"), top = lifted("CHS 219.1x8", "10 kN", keys);
  ASSERT_EQ(lug.status, Status::ok) << lug.message << to_text(lug.errors);
  EXPECT_GT(check_of(lug, "mast.top_stiffness").value, 0);
  EXPECT_NEAR(check_of(lug, "mast.top_stiffness").value / check_of(top, "mast.top_stiffness").value, 1, 1e-6);
  EXPECT_EQ(check_of(lug, "mast.guys_by_plate").value, 3);
}

// The bows of the parts of a member that nothing holds where they meet are none of the member.
TEST(MachineMasts, BowsOfPartsAreNoneOfTheMember) {
  const std::string crooked = ", imperfection: {bow: -0.004, sway: 0.006, towards: [1, 0, 0]}";
  EXPECT_FALSE(has_check(upright(1, 100e3, 1.2, crooked), "all.member"));
  EXPECT_TRUE(has_check(upright(2, 100e3, 1.2, crooked), "all.member"));
}

}  // namespace taut::checks::machine_masts_test
