#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/base/gravity.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/catalogue/section_search.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::own_mast_test {

using namespace taut_test;

/// Beside a rope that plays no part, a mast of 20 m under 10 kN of the case g.
Result weighed(const std::string& mast, const std::string& loads = "{case: g, down: 10 kN}",
               const std::string& weight = "own_weight: true, ") {
  return run_text(
      "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m], c: [50 m, 0 m, 0 m]}\n  ropes: {r: {mass: 1 kg/m, stiffness: "
      "20 MN, breaking_force: 300 kN}}\n  reevings: [{rope: r, path: [{anchor: a}, {anchor: c}], tension_at_start: 20 "
      "kN}]\nanalyses: [{equilibrium: {}}]\nchecks: {ropes: {r: {safety_factor: 3}}, masts: {m: {height: 20 m, "
      "section: CHS 508x25, steel: S355, " +
      weight + "loads: [" + loads + "], " + mast + "}}}\n");
}

bool says(const std::vector<std::string>& all, const std::string& text) {
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& one) { return one.find(text) != std::string::npos; });
}

// Without a factor of its own the weight has the largest of its combination.
TEST(OwnMast, OwnWeightHasTheFactorOfTheCombination) {
  const double weight = catalogue::find_section("CHS 508x25")->mass_per_length * standard_gravity * 20;
  const auto N = [](const Result& r) { return cell(table_of(r, "masts"), 0, "N"); };
  const Result combined = weighed("combinations: {uls: {g: 1.35}}");
  EXPECT_NEAR(N(combined), 1.35 * (10e3 + weight), 1) << to_text(combined.errors);
  EXPECT_NEAR(N(combined), N(weighed("load_factor: 1.35")), 1);
  EXPECT_TRUE(says(combined.assumptions, "own weight times 1.35 (uls) without dynamic factor"));
  const Result named = weighed("dynamic_factor: 1.2, combinations: {uls: {g: 1.5, own_weight: 1.1}}");
  EXPECT_NEAR(N(named), 1.5 * 1.2 * 10e3 + 1.1 * weight, 1);
  EXPECT_TRUE(says(named.assumptions, "own weight times 1.1 (uls)"));
  EXPECT_TRUE(says(weighed("load_factor: 1.2").assumptions, "own weight times 1.2 without"));
}

TEST(OwnMast, WhereItIsPulledItsWeightRelieves) {
  const std::string up = "{case: g, down: -200 kN}", relieves = "where its weight relieves";
  EXPECT_TRUE(says(weighed("combinations: {uls: {g: 1.35}}", up).warnings, relieves));
  EXPECT_TRUE(says(weighed("load_factor: 1.35", up).warnings, relieves));
  EXPECT_FALSE(says(weighed("combinations: {uls: {g: 1.35, own_weight: 1}}", up).warnings, relieves));
  EXPECT_FALSE(says(weighed("combinations: {a: {g: 1.35}, b: {g: 1.35, own_weight: 0.9}}", up).warnings, relieves));
}

TEST(OwnMast, MistakesOfTheWeight) {
  expect_mistake(weighed("load_factor: 1.35, combinations: {uls: {g: 1.35}}"),
                 "of the weight by the name 'own_weight'");
  expect_mistake(weighed("combinations: {uls: {own_weight: 1.35}}", "{case: own_weight, down: 10 kN}"),
                 "give the load case another name");
  expect_mistake(weighed("combinations: {uls: {g: 1.35, own_weight: 1.35}}", "{case: g, down: 10 kN}", ""),
                 "needs 'own_weight: true'");
}

// The foot in tension, the mast above it pressed by 130 kN: it leans as the deck says.
TEST(OwnMast, AnUpliftBelowDropsNoSway) {
  const auto lifted = [](const std::string& lift) {
    return run_text(
        "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m], c: [50 m, 0 m, 0 m]}\n  ropes: {r: {mass: 1 kg/m, "
        "stiffness: 20 MN, breaking_force: 300 kN}}\n  reevings: [{rope: r, path: [{anchor: a}, {anchor: c}], "
        "tension_at_start: 20 kN}]\nanalyses: [{equilibrium: {}}]\nchecks: {ropes: {r: {safety_factor: 3}}, masts: "
        "{up: {height: 8 m, section: CHS 219.1x8, steel: S355, sway: 0.08, loads: [{at: 2 m, down: -" +
        lift + "}, {down: 130 kN, across: 2 kN}]}}}\n");
  };
  const Result pressed = lifted("129 kN"), pulled = lifted("131 kN");
  EXPECT_FALSE(check_of(pulled, "up.section").passes);
  EXPECT_NEAR(check_of(pulled, "up.section").value, check_of(pressed, "up.section").value, 0.03);
  EXPECT_TRUE(says(pulled.assumptions, "as built leaning by 0.08"));
}

// Cases that nobody put together, and cases that nobody named.
TEST(OwnMast, LoadCasesThatAreNotCheckedTogether) {
  const std::string two = "{case: g, down: 10 kN}, {case: wind, across: 5 kN}";
  const std::string one_at_a_time = "are checked one at a time";
  EXPECT_TRUE(says(weighed("load_factor: 1.35", two).unmade, one_at_a_time));
  EXPECT_FALSE(says(weighed("combinations: {a: {g: 1.35, wind: 1.5}}", two).unmade, one_at_a_time));
  EXPECT_TRUE(says(weighed("combinations: {a: {g: 1.35}}", two).unjudged, "m in 'wind'"));
  EXPECT_TRUE(weighed("combinations: {a: {g: 1.35}, b: {wind: 1.5}}", two).unjudged.empty());
}

// A cantilever of 20 m buckles as a column of 40 m; with its top held clamped and hinged as one of 14 m (0.699).
TEST(OwnMast, ABucklingLengthShorterThanThatOfTheMastIsUnsafe) {
  const auto with = [](const char* keys, const char* loads = "{case: g, down: 10 kN}") {
    return weighed(std::string("load_factor: 1.5, ") + keys, loads, "").unsafe;
  };
  const std::string shorter = "m: 'buckling_length' of 20 m is shorter than that of the mast";
  EXPECT_TRUE(says(with("buckling_length: 20 m"), shorter));
  EXPECT_TRUE(says(with("buckling_length: 20 m"), "'top_stiffness', 40 m (g"));
  EXPECT_TRUE(with("buckling_length: 40 m").empty());
  EXPECT_TRUE(with("buckling_length: 14 m, top_stiffness: .inf").empty());
  EXPECT_TRUE(says(with("buckling_length: 10 m, base: hinge, top_stiffness: .inf"), "'top_stiffness', 20 m"));
  EXPECT_TRUE(with("buckling_length: 10 m", "{case: g, down: -10 kN}").empty());  // pulled
}

// On a hinge a weak spring lets the top go as far as it is pushed: 1000 kN over 400 kN/m are 2.5 m of 20 m.
TEST(OwnMast, AMastThatLeansFarIsNotJudged) {
  const auto leans = [](const char* across) {
    return weighed("base: hinge, top_stiffness: 400 kN/m, load_factor: 1.5",
                   std::string("{case: g, down: 10 kN, across: ") + across + "}");
  };
  EXPECT_FALSE(says(leans("20 kN").unmade, "beyond small rotations"));
  EXPECT_TRUE(says(leans("1000 kN").unmade, "beyond small rotations"));
}

}  // namespace taut::checks::own_mast_test
