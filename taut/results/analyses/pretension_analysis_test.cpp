#include <fmt/format.h>

#include <algorithm>

#include "test/support/machine_decks.hpp"

/// The analysis `pretension` and slow motions from decks: results, and mistakes at their places.
namespace pretension_analysis_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

/// A ring between two ropes of 20 m, which a floor holds where the deck has one.
std::string ring_deck(const std::string& analyses, bool floor = false) {
  const std::string contacts = R"(
  faces: {floor: {from: [-1 m, 0 m, 0 m], to: [1 m, 0 m, 0 m]}}
  markers: {sole: {body: ring, at: [0 m, 0 m, 0 m]}}
  contacts: [{point: sole, face: floor, stiffness: 10000 MN/m, static_friction: 0.3}]
  measures: {out: {of: ring.x}}
)";
  return fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
  ropes: {{wire: {{mass: 0 kg/m, stiffness: 2 MN}}}}
  bodies: {{ring: {{mass: 500 kg, at: [0 m, 0 m, 0 m], free: [x{}]}}}}
  points: {{a: [-20 m, 0 m, 0 m], b: [20 m, 0 m, 0 m]}}
  reevings:
    - {{rope: wire, name: left, path: [{{anchor: a}}, {{anchor: ring}}], tension_at_start: 10 kN}}
    - {{rope: wire, name: right, path: [{{anchor: ring}}, {{anchor: b}}], length: 19.9 m}}
{}analyses:
{}
)",
                     floor ? ", z" : "", floor ? contacts : "", analyses);
}

bool has_mistake(const Result& r, const std::string& words) {
  return std::any_of(r.errors.begin(), r.errors.end(),
                     [&](const auto& e) { return e.message.find(words) != std::string::npos; });
}

TEST(PretensionAnalysis, PullsRopesInTurn) {
  const Result r = run_text(ring_deck(
      "  - pretension: {rounds: 2, pull: [{rope: left, force: 30 kN}, {rope: right, end: end, take_up: -5 mm}]}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto& t = table_of(r, "tensioning");
  ASSERT_EQ(t.rows.size(), 5U);
  EXPECT_NEAR(cell(t, 1, "left.T_start"), 30e3, 1e-3);
  EXPECT_NEAR(cell(t, 1, "right.T_end"), 30e3, 1e-3);
  EXPECT_EQ(text_cell(t, 2, "pulled"), "right");
  EXPECT_NEAR(cell(t, 2, "taken_out"), -5e-3, 1e-12);
  EXPECT_NEAR(cell(t, 4, "taken_out_in_all"), -10e-3, 1e-12);
  EXPECT_NEAR(value_of(r, "right.pretension_taken_out"), -10e-3, 1e-12);
  EXPECT_NEAR(value_of(r, "right.pretension_length"), 19.91, 1e-9);
  EXPECT_NEAR(value_of(r, "left.pretension_T_start"), cell(t, 4, "left.T_start"), 1e-9);
  EXPECT_NEAR(value_of(r, "right.T_max"), 30e3, 1e-3) << "every state of the pulling counts, not the last alone";
}

TEST(PretensionAnalysis, PullsUntilSomethingSlides) {
  const Result r =
      run_text(ring_deck("  - pretension: {name: slow, pull: [{rope: left, until: out, moves: 0.01 mm}, {rope: right, "
                         "end: end, until: out, moves: 0.01 mm}]}",
                         true));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto& t = table_of(r, "tensioning_slow");
  for (const std::size_t i : {1U, 2U}) {
    const double difference = cell(t, i, "left.T_start") - cell(t, i, "right.T_end");
    EXPECT_NEAR(difference, (i == 1 ? 1 : -1) * 0.3 * 5000, 3);
  }
  EXPECT_NEAR(value_of(r, "out_1_slow"), cell(t, 1, "out"), 0);
}

/// Friction holds the ring, so that the ropes are pulled slowly: their tensions are checked as those of other states.
TEST(PretensionAnalysis, SlowPullsAreChecked) {
  std::string deck = ring_deck("  - pretension: {pull: [{rope: left, until: out, moves: 0.01 mm}]}", true);
  deck += "checks: {ropes: {wire: {running: stands, safety_factor: 50, breaking_force: 100 kN}}}\n";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto& t = table_of(r, "tensioning");
  for (const std::string rope : {"left", "right"}) {
    const double largest = std::max(cell(t, 0, rope + ".T_start"), cell(t, 1, rope + ".T_start"));
    EXPECT_NEAR(check_of(r, rope + ".safety_factor").value, 100e3 / largest, 1e-3 * 100e3 / largest) << rope;
    EXPECT_FALSE(check_of(r, rope + ".safety_factor").passes);
  }
}

TEST(PretensionAnalysis, LengthsThatKeepRopesTautUnderAllLoads) {
  const Result r = run_text(ring_deck(R"(  - pretension:
      least:
        ropes: [left, right]
        tension: 2 kN
        cases:
          - {name: right, loads: [{at: ring, force: [5 kN, 0 N, 0 N]}]}
          - {name: left, loads: [{at: ring, force: [-5 kN, 0 N, 0 N]}]})"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto& t = table_of(r, "least_tension");
  ASSERT_EQ(t.rows.size(), 2U);
  const double L = 40 / (2 + 9e3 / 2e6);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_NEAR(cell(t, i, "T_least"), 2e3, 1e-2);
    EXPECT_NEAR(cell(t, i, "unstretched"), L, 1e-7);
  }
  EXPECT_EQ(text_cell(t, 0, "governed_by"), "left");
  EXPECT_NEAR(value_of(r, "left.pretension_T_least"), 2e3, 1e-2);
}

TEST(PretensionAnalysis, MistakesAreToldAtTheirPlaces) {
  struct Case {
    const char *deck, *words;
    bool floor;
  };
  for (const Case& c :
       {Case{.deck = "  - pretension: {pull: [{rope: lft, force: 30 kN}]}",
       .words = "did you mean 'left'",
       .floor = false},
        Case{.deck = "  - pretension: {pull: [{rope: left}]}", .words = "force", .floor = false},
        Case{.deck = "  - pretension: {pull: [{rope: left, force: 30 kN, take_up: 1 mm}]}",
        .words = "force",
        .floor = false},
        Case{.deck = "  - pretension: {pull: [{rope: left, end: end, force: 30 kN}]}",
        .words = "keeps the tension given at its start",
        .floor = false},
        Case{.deck = "  - pretension: {pull: [{rope: right, end: end, force: 30 kN}]}",
        .words = "'left' has a given tension, which no slow motion keeps",
        .floor = true},
        Case{.deck = "  - pretension: {longest: 1 mm, pull: [{rope: right, take_up: -2 mm}]}",
        .words = "is more than 0.001 m, 'longest'",
        .floor = false},
        Case{.deck = "  - pretension: {pull: []}", .words = "list is empty", .floor = false},
        Case{.deck = "  - pretension: {pull: [{rope: left, until: out}]}", .words = "needs 'moves'", .floor = true},
        Case{.deck = "  - pretension: {pull: [{rope: left, until: out, moves: 3 kN}]}", .words = "kN", .floor = true},
        Case{.deck = "  - pretension: {pull: [{rope: left, force: 3 kN, moves: 3 mm}]}",
        .words = "belongs to 'until'",
        .floor = false},
        Case{.deck = "  - pretension: {least: {ropes: [left, left], tension: 1 kN}}",
        .words = "named twice",
        .floor = false},
        Case{.deck = "  - pretension: {least: {ropes: [left], tension: 1 kN, cases: [{name: a, loads: [{at: nowhere, "
                     "mass: 1 "
                     "kg}]}]}}",
        .words = "nowhere",
        .floor = false},
        Case{.deck = "  - pretension: {least: {ropes: [left], tension: 1 kN}}",
        .words = "without contacts",
        .floor = true},
        Case{.deck = "  - transient: {duration: 1 s, start: sliding}", .words = "needs 'slid'", .floor = true},
        Case{.deck = "  - transient: {duration: 1 s, slid: [{drum: w, by: 1 m}]}",
        .words = "belongs to a start 'sliding'",
        .floor = true},
        Case{.deck = "  - transient: {duration: 1 s, start: sliding, slid: [{drum: w, by: 1 m}]}",
        .words = "there is no drum 'w'",
        .floor = true},
        Case{.deck = "  - transient: {duration: 1 s, quasi_static: true, method: verlet}",
        .words = "its own steps",
        .floor = true}}) {
    const Result r = run_text(ring_deck(c.deck, c.floor));
    EXPECT_EQ(r.status, Status::bad_deck) << c.deck;
    EXPECT_TRUE(has_mistake(r, c.words)) << c.deck << to_text(r.errors);
  }
}

/// Ropes that are drawn to equal tensions keep their lengths under the loads of the cases: as those lengths given.
TEST(PretensionAnalysis, RopesDrawnEqualKeepTheirLengthsInEveryCase) {
  const auto deck = [](const std::string& second) {
    return fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{mass: 0 kg/m, stiffness: 10 MN}}}}
  bodies: {{bar: {{mass: 0 kg, at: [0 m, 0 m, 0 m], guide: [0, 0, 1]}}}}
  points: {{A: [0 m, 0 m, 5 m], B: [0 m, 0 m, 20 m], C: [0 m, 0 m, -10 m]}}
  reevings:
    - {{rope: r, name: a, path: [{{anchor: A}}, {{anchor: bar}}], length: 4.99 m}}
    - {{rope: r, name: b, path: [{{anchor: B}}, {{anchor: bar}}], {}}}
    - {{rope: r, name: d, path: [{{anchor: C}}, {{anchor: bar}}], length: 9.97 m}}
analyses:
  - equilibrium: {{}}
  - pretension:
      least: {{ropes: [d], tension: 10 kN, cases: [{{name: pulled, loads: [{{at: bar, force: [0 N, 0 N, -100 kN]}}]}}]}}
)",
                       second);
  };
  const Result r = run_text(deck("tension_equals: a"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Result s = run_text(deck(fmt::format("length: {:.17g} m", value_of(r, "b.unstretched"))));
  ASSERT_EQ(s.status, Status::ok) << s.message << to_text(s.errors);
  for (const char* name : {"d.pretension_length", "d.pretension_T", "a.T_max", "b.T_max"}) {
    EXPECT_NEAR(value_of(r, name) / value_of(s, name), 1, 1e-7) << name;
  }
  EXPECT_GT(value_of(r, "a.T_max"), 1.2 * value_of(r, "b.T_max")) << "the shorter one is the stiffer";
}

/// What is asked for can be impossible: that is no mistake of the deck.
TEST(PretensionAnalysis, WhatCannotBeReachedIsTold) {
  const Result r = run_text(ring_deck("  - pretension: {longest: 1 mm, pull: [{rope: left, force: 900 kN}]}", true));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.message.find("pull 1, 'left'"), std::string::npos) << r.message;
}

TEST(PretensionAnalysis, SlowMotionsSayHowTheyAreMeant) {
  const Result r = run_text(ring_deck("  - transient: {duration: 1 s, output_step: 0.1 s, quasi_static: true}", true));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(std::any_of(r.assumptions.begin(), r.assumptions.end(),
                          [](const std::string& one) { return one.find("quasi-static") != std::string::npos; }));
  EXPECT_EQ(text_cell(table_of(r, "energy"), 4, "form"), "damped where it fell");
}

/// A guy pulled to 40 kN has 49.6 kN in winter; the sweep has the guy as it is put up.
TEST(PretensionAnalysis, ItsPullsAreToldToCountInItAlone) {
  const std::string deck = R"(taut: 1
machine:
  temperature: 10 degC
  ropes: {wire: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN, diameter: 20 mm}}
  points: {top: [0 m, 0 m, 15.5 m], stump: [25 m, 0 m, 1 m]}
  guys: {g: {rope: wire, from: top, to: stump, install: {tension: 30 kN}}}
analyses:
  - pretension: {pull: [{rope: g, force: 40 kN}]}
  - sweep: {name: winter, parameter: temperature, from: -30 degC, to: 10 degC, steps: 1}
checks: {guys: {g: {safety_factor: 6.5, pretension: [0.08, 0.15]}}}
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.unmade.size(), 1U);
  EXPECT_NE(r.unmade[0].find("'g' is pulled in the pretension alone"), std::string::npos);
  EXPECT_TRUE(run_text(deck, {"analyses=[{pretension: {pull: [{rope: g, force: 40 kN}]}}]"}).unmade.empty());
}

/// Cases of a search for lengths know guys that have been put up.
TEST(PretensionAnalysis, CasesHaveTheGuysAsTheyArePutUp) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {wire: {mass: 1.6 kg/m, stiffness: 20 MN}}
  bodies: {tower: {mass: 2.5 t, centre: [0 m, 0 m, 8 m], free: [ry]}}
  points: {head: {body: tower, at: [0 m, 0 m, 16 m]}, s1: [-22 m, 0 m, 0 m], s2: [22 m, 0 m, 0 m]}
  guys:
    g1: {rope: wire, from: head, to: s1, install: {tension: 30 kN}}
    g2: {rope: wire, from: head, to: s2, install: {tension: 30 kN}}
analyses: [{pretension: {least: {ropes: [g1], tension: 5 kN, cases: [{name: w, loads: [{at: head, force: [1 kN, 0 N, 0 N]}]}]}}}]
)");
  EXPECT_EQ(r.message.find("put_up_all"), std::string::npos) << r.message;
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
}

}  // namespace pretension_analysis_test
