#include "taut/app/cases/said_by_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "taut/app/prepare_machine.hpp"
#include "taut/io/deck/deck.hpp"

namespace taut::app::said_by_cases_test {

using testing::ElementsAre;
using testing::IsEmpty;

// 2.1 t on one rope of 100 kN: its factor is 4.86, and 20.6 kN are more than the anchor of 20 kN holds.
MachineDeck hung(const std::string& checks) {
  const std::string text = R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  bodies: {hook: {mass: 2.1 t, at: [0 m, 0 m, 3 m], free: [x, z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: hook}], length: 7 m}]
)" + checks;
  Diagnostics mistakes;
  const auto deck = io::read_deck(text, "deck.yaml", {}, {}, mistakes);
  const auto read = deck ? read_machine(deck->input, deck->display, mistakes) : std::nullopt;
  if (!read) throw std::runtime_error(to_text(mistakes));
  return *read->deck;
}

std::vector<std::string> names(const std::vector<Check>& checks) {
  std::vector<std::string> all;
  for (const Check& one : checks) all.push_back(one.name);
  return all;
}

TEST(SaidByCases, WhatNoCaseMakesIsSaidWithItsAnalysis) {
  const MachineDeck deck =
      hung("checks: {ropes: {r: {safety_factor: 4}}, anchors: {top: {strength: 20 kN, safety_factor: 1}}}\n");
  SaidByCases said;
  Result cases;
  cases.checks.push_back(
      make_check("r.T_max", 20.6e3, si::N, {.sense = Sense::at_most, .limit = 1e5, .rule = "", .trust = ""}));
  said.hear(cases);
  const Unasked found = beside_cases(deck, said, "equilibrium");
  EXPECT_EQ(found.analysis, "equilibrium");
  EXPECT_THAT(names(found.unmade),
              testing::UnorderedElementsAre("r.safety_factor", "r.elastic_limit", "top.anchor_strength"));
  ASSERT_EQ(found.fails.size(), 1U);
  EXPECT_EQ(found.fails[0].check, "top.anchor_strength");
  EXPECT_EQ(found.fails[0].analysis, "equilibrium");
  EXPECT_THAT(found.parts, IsEmpty());
  EXPECT_EQ(found.strengths.at("r"), 1e5);
}

TEST(SaidByCases, AFailureThatTheCasesTellIsNotSaidAgain) {
  const MachineDeck deck = hung("checks: {ropes: {r: {safety_factor: 5}}}\n");
  SaidByCases said;
  EXPECT_EQ(beside_cases(deck, said, "").fails.size(), 1U);
  Result cases;
  cases.unjudged = {"r"};
  cases.checks.push_back(make_check("r.safety_factor", 4.86, si::one,
                                    {.sense = Sense::at_least, .limit = 5, .rule = "", .trust = "user"}));
  said.hear(cases);
  said.hear(cases);
  EXPECT_THAT(said.unjudged, ElementsAre("r"));
  const Unasked found = beside_cases(deck, said, "");
  EXPECT_THAT(found.fails, IsEmpty());
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].why, "no case makes the deck's r.safety_factor: name an output checks.r.safety_factor");
}

TEST(SaidByCases, TheStrengthOfABeamIsThatOfAStress) {
  MachineDeck deck = hung("");
  deck.machine.beams.emplace_back().name = "mast";
  EXPECT_EQ(check_of_strength(deck, "r"), "r.T_max");
  EXPECT_EQ(check_of_strength(deck, "mast"), "mast.stress_max");
}

}  // namespace taut::app::said_by_cases_test
