#include <fmt/format.h>
#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "taut/app/cases/read_cases.hpp"
#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Sweeps of what a machine is put up with: at each value, and in load cases and studies too, it is put up as a deck
/// with that value would be.
namespace taut::app::sweep_put_up_test {

std::string line(const std::string& tension, const std::string& rest) {
  return R"(taut: 1
machine:
  temperature: 10 degC
  points: {a: [0 m, 0 m, 0 m], b: [200 m, 0 m, 30 m]}
  ropes: {r: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 200 kN, diameter: 20 mm}}
  carriages: {car: {mass: 200 kg, rides: r, hold: clamped, length_before: 101 m}}
  reevings: [{rope: r, path: [{anchor: a}, {through: car}, {anchor: b}], install: {tension: )" +
         tension + R"(}}]
  loads: [{name: logs, at: car, mass: 1 t}]
)" + rest;
}

double value_of(const Result& r, const std::string& name) {
  for (const Value& one : r.values) {
    if (one.name == name) return one.value;
  }
  throw std::runtime_error("no value " + name + ": " + r.message + to_text(r.errors));
}

CaseAnswer answer_of(const std::string& text, const std::vector<std::string>& outputs, const std::string& input,
                     double value) {
  const auto read = read_cases({.text = text, .name = "deck.yaml", .set = {}, .progress = {}});
  if (!read) throw std::runtime_error(to_text(read.error().errors));
  CaseQuestion question{.inputs = {{input, ""}}, .outputs = {}};
  for (const std::string& one : outputs) question.outputs.push_back({one, ""});
  const auto model = read->cases(question);
  if (!model) throw std::runtime_error(model.error().outcome.message);
  return model->answer(std::span(&value, 1));
}

// Put up with 80 kN it bears 1.1 t with 200/114.7 = 1.74; judged as put up with 30 kN it passed with 2.33.
TEST(SweepOfWhatIsPutUp, ACaseIsJudgedAtEachValue) {
  const std::string checks = "checks: {ropes: {r: {safety_factor: 2}}, anchors: {a: {strength: 100 kN}}}\n";
  const std::string swept =
      "analyses: [{sweep: {parameter: reevings.r.install.tension, from: 30 kN, to: 80 kN, steps: 1, carriage: car, "
      "x: 100 m}}]\n";
  const std::vector<std::string> outputs = {"checks.r.safety_factor", "checks.a.anchor_strength"};
  const auto found = answer_of(line("30 kN", swept + checks), outputs, "machine.loads[0].mass", 1000);
  ASSERT_EQ(found.outputs.size(), 2U) << found.outcome.message;
  const Result alone =
      taut_test::run_text(line("80 kN", "analyses: [{equilibrium: {carriage: car, x: 100 m}}]\n" + checks));
  EXPECT_NEAR(found.outputs[0], taut_test::check_of(alone, "r.safety_factor").value, 1e-7);
  EXPECT_NEAR(found.outputs[1], taut_test::check_of(alone, "a.anchor_strength").value, 1e-7);
  EXPECT_LT(found.outputs[0], 1.8);
}

// The guide of studies: lines are put up with the deck's own loads and temperature, whatever those of the case. At the
// deck's own geometry a sweep finds what the equilibrium of the same case has.
TEST(SweepOfWhatIsPutUp, ACasePutsItsLinesUpAsTheDeck) {
  const std::string both =
      "analyses:\n  - equilibrium: {carriage: car, x: 100 m}\n  - sweep: {parameter: points.b.z, from: 30.1 m, to: 30 "
      "m, steps: 1, carriage: car, x: 100 m}\n";
  const std::string with = line("30 kN, with: [car, logs]", both), empty = line("30 kN", both);
  const std::vector<std::string> outputs = {"equilibrium.T_max", "sweep.T_max"};
  for (const auto& [text, input, value] :
       {std::tuple{with, "machine.loads[0].mass", 2000.0}, std::tuple{empty, "machine.temperature", 253.15}}) {
    const auto found = answer_of(text, outputs, input, value);
    ASSERT_EQ(found.outputs.size(), 2U) << found.outcome.message;
    EXPECT_GE(found.outputs[1], found.outputs[0] * (1 - 1e-9)) << input;
    EXPECT_LT(found.outputs[1], 1.01 * found.outputs[0]) << input;
  }
}

TEST(SweepOfWhatIsPutUp, ACaseOfADesignThatChangesNothingChangesNothing) {
  const auto designed = [](const std::string& cases) {
    const std::string text = line(
        "30 kN",
        R"(analyses: [{sweep: {parameter: reevings.r.install.tension, from: 30 kN, to: 80 kN, steps: 2, carriage: car, x: 100 m}}]
checks: {ropes: {r: {safety_factor: 2.5}}, anchors: {a: {strength: 150 kN}}}
design:
  seek: lightest
  ropes: {r: {construction: 6x36, core: IWRC, grade: 1960 MPa}}
)" + cases);
    const std::string given = "{mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 200 kN, diameter: 20 mm}";
    std::string free = text;
    free.replace(free.find(given), given.size(), "{}");
    return taut_test::run_text(free);
  };
  const Result plain = designed(""), cases = designed("  cases: {loaded: {loads.logs.mass: 1 t}}\n");
  EXPECT_EQ(plain.status, cases.status) << cases.message;
  EXPECT_EQ(plain.message.substr(0, 40), cases.message.substr(0, 40));
  ASSERT_EQ(plain.status, Status::ok) << plain.message;
  EXPECT_NEAR(value_of(plain, "r.safety_factor"), value_of(cases, "r.safety_factor"), 1e-9);
}

// A guy of 90 kN put up with 100 kN breaks as it is put up; its value at rest was 48 kN, and the deck "not judged".
TEST(SweepOfWhatIsPutUp, WhatIsPutUpAtAValueIsAmongTheTensions) {
  const Result r = taut_test::run_text(R"(taut: 1
machine:
  ropes: {g: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 90 kN, diameter: 20 mm}}
  bodies: {mast: {mass: 2 t, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 6 m], free: [rx, ry, rz]}}
  points: {head: {body: mast, at: [0 m, 0 m, 12 m]}, s1: [12 m, 0 m, 0 m], s2: [0 m, 12 m, 0 m], s3: [-12 m, 0 m, 0 m], s4: [0 m, -12 m, 0 m]}
  guys:
    g1: {rope: g, from: head, to: s1, install: {tension: 20 kN}}
    g2: {rope: g, from: head, to: s2, install: {tension: 20 kN}}
    g3: {rope: g, from: head, to: s3, install: {tension: 20 kN}}
    g4: {rope: g, from: head, to: s4, install: {tension: 20 kN}}
analyses: [{sweep: {parameter: guys.g1.install.tension, from: 20 kN, to: 100 kN, steps: 2}}]
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "g1.T_max"), 100e3, 1);
  EXPECT_NEAR(value_of(r, "g1.safety_factor"), 0.9, 1e-6);
  EXPECT_EQ(to_text(verdict_of(r)->kind), "fails");
}

// The designer of an anchor reads the table: the largest pull of all values of the sweep.
TEST(SweepOfWhatIsPutUp, TablesHaveTheWorstOfEachPart) {
  const Result r = taut_test::run_text(line(
      "30 kN",
      "analyses: [{sweep: {parameter: reevings.r.install.tension, from: 30 kN, to: 80 kN, steps: 1, carriage: car, "
      "x: 100 m}}]\nchecks: {ropes: {r: {safety_factor: 1}}, anchors: {a: {strength: 100 kN}}}\n"));
  const Table& table = taut_test::table_of(r, "anchor_forces");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_NEAR(taut_test::cell(table, 0, "force"), 100e3 / taut_test::check_of(r, "a.anchor_strength").value, 1);
  EXPECT_NE(taut_test::text_cell(table, 0, "where").find("80 kN"), std::string::npos);
}

}  // namespace taut::app::sweep_put_up_test
