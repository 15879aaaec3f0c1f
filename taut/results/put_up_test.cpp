#include "taut/results/put_up.hpp"

#include <fmt/format.h>

#include "test/support/machine_decks.hpp"

namespace put_up_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::Table;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// The skyline as put up, in place of its length.
std::string put_up_deck(const std::string& install, const std::string& analyses) {
  return replaced(skyline_deck(analyses), "length: 382 m", "install: " + install);
}

const char* const at_rest = "  - equilibrium: {carriage: car, x: 170 m}";

void expect_ok(const Result& r) { ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors); }

/// All values that both have are the same.
void expect_same_values(const Result& r, const Result& s) {
  std::size_t compared = 0;
  for (const taut::Value& v : r.values) {
    const auto w = std::find_if(s.values.begin(), s.values.end(), [&](const auto& one) { return one.name == v.name; });
    if (w == s.values.end()) {
      // what the put-up state adds where an analysis has no state at rest of its own
      const bool own = v.name.ends_with("base_tension") || v.name.ends_with("cut_length");
      const bool of_state = v.name.ends_with("T_max") || v.name.ends_with("safety_factor");
      EXPECT_TRUE(own || of_state) << v.name;
      continue;
    }
    ++compared;
    EXPECT_NEAR(v.value, w->value, 1e-6 * std::max(1.0, std::abs(w->value))) << v.name;
  }
  EXPECT_GE(compared, 5U);
}

TEST(PutUp, TheEmptyLineHasItsBaseTensionAndTheLengthIsKept) {
  for (const bool end : {false, true}) {
    const Result r = run_text(put_up_deck(fmt::format("{{tension: 35 kN, at: {}}}", end ? "end" : "start"), at_rest));
    expect_ok(r);
    EXPECT_NEAR(value_of(r, "skyline.base_tension"), 35e3, 1e-4);
    const Table& t = table_of(r, "put_up");
    ASSERT_EQ(t.rows.size(), 1U);
    EXPECT_NEAR(cell(t, 0, end ? "T_end" : "T_start"), 35e3, 1e-4);
    EXPECT_EQ(text_cell(t, 0, "state"), "skyline as put up, empty");
    EXPECT_GT(value_of(r, "skyline.T_start"), 40e3) << "loaded";
    // by hand: the tension at the upper end is higher by the weight of the rope between both heights
    EXPECT_NEAR(cell(t, 0, "T_end") - cell(t, 0, "T_start"), 1.6 * 9.80665 * 120, 25);
    // the empty machine with that tension held needs the same rope
    std::string empty = skyline_deck("");
    empty = replaced(empty,
                     "  carriages:\n    car: {mass: 350 kg, rides: skyline, hold: rolling, mainline: mainline}\n", "");
    empty = replaced(empty, "{through: car}, ", "");
    empty = replaced(empty, "    - {rope: mainline, path: [{drum: winch}, {anchor: car}], length: 192 m}\n", "");
    empty = replaced(empty, "  loads: [{at: car, mass: 0 kg}]\n", "");
    empty = replaced(empty, "analyses:\n\n", "");
    empty = replaced(empty, "length: 382 m", end ? "tension_at_end: 35 kN" : "tension_at_start: 35 kN");
    const Result alone = run_text(empty);
    expect_ok(alone);
    EXPECT_NEAR(value_of(r, "skyline.unstretched"), value_of(alone, "skyline.unstretched"), 1e-7);
    EXPECT_NEAR(value_of(r, "skyline.cut_length"), value_of(alone, "skyline.unstretched"), 1e-7);
    EXPECT_EQ(table_of(r, "put_up").rows.size(), 1U);
  }
}

TEST(PutUp, EveryAnalysisIsThatOfTheLengthFound) {
  const std::string install = "{tension: 35 kN}";
  const Result once = run_text(put_up_deck(install, at_rest));
  expect_ok(once);
  const std::string length = fmt::format("length: {:.17g} m", value_of(once, "skyline.unstretched"));
  for (const char* analysis : {
           at_rest,
           "  - load_path: {carriage: car, from: 130 m, to: 220 m, steps: 3, motion: in}",
           "  - payload: {carriage: car, from: 150 m, to: 200 m, steps: 2, limits: {skyline: {safety_factor: 3}}}",
           "  - sweep: {parameter: \"loads[0].mass\", from: 0 t, to: 2 t, steps: 2, carriage: car, x: 170 m}",
           "  - sweep: {parameter: temperature, from: -20 degC, to: 30 degC, steps: 2, carriage: car, x: 170 m}",
           "  - cycle: {carriage: car, from: 220 m, to: 150 m, steps: 2, phases: [{name: a, motion: out}]}",
           "  - envelope: {carriage: car, from: 150 m, to: 200 m, steps: 2, loads: [0 t, 1 t], temperatures: [0 degC, "
           "20 degC]}",
           "  - installation: {reeving: skyline, temperatures: [-20 degC, 15 degC]}",
           "  - modes: {count: 2, rope_mass: true}",
           "  - transient: {duration: 0.2 s, output_step: 0.1 s, tolerance: 1e-4}",
       }) {
    SCOPED_TRACE(analysis);
    const Result r = run_text(put_up_deck(install, analysis));
    const Result s = run_text(replaced(skyline_deck(analysis), "length: 382 m", length));
    expect_ok(s);
    expect_ok(r);
    expect_same_values(r, s);
    for (const Table& t : s.tables) {
      const Table& own = table_of(r, t.name);
      ASSERT_EQ(own.rows.size(), t.rows.size()) << t.name;
    }
  }
}

TEST(PutUp, WhatHangsOnTheLineMeanwhileCounts) {
  const std::string with_load =
      replaced(put_up_deck("{tension: 60 kN, with: [car, logs]}", "  - equilibrium: {motion: at_rest}"),
               "{at: car, mass: 0 kg}", "{name: logs, at: car, mass: 900 kg}");
  const Result r = run_text(with_load);
  expect_ok(r);
  EXPECT_NEAR(value_of(r, "skyline.T_start"), 60e3, 1e-2) << "nothing has changed since";
  EXPECT_EQ(text_cell(table_of(r, "put_up"), 0, "state"), "skyline as put up, with car and its load");
  // without the load the carriage alone hangs there, the load comes later
  const Result later = run_text(replaced(with_load, "[car, logs]", "[car]"));
  expect_ok(later);
  EXPECT_GT(value_of(later, "skyline.T_start"), 65e3);
  const Result light = run_text(replaced(replaced(with_load, "[car, logs]", "[car]"), "mass: 900 kg", "mass: 0 kg"));
  expect_ok(light);
  EXPECT_NEAR(value_of(light, "skyline.T_start"), 60e3, 1e-2);
  EXPECT_NEAR(value_of(light, "skyline.unstretched"), value_of(later, "skyline.unstretched"), 1e-7);
}

TEST(PutUp, IsDoneAnewForEveryValueOfASweep) {
  for (const auto& [parameter, values] :
       {std::pair{std::string("reevings.skyline.install.tension"), std::vector<std::string>{"30 kN", "40 kN"}},
        {"points.tower.z", {"124 m", "130 m"}},
        {"carriages.car.mass", {"200 kg", "500 kg"}}}) {
    SCOPED_TRACE(parameter);
    const std::string install = "{tension: 35 kN, with: [car]}";
    const Result r = run_text(put_up_deck(
        install, fmt::format("  - sweep: {{parameter: {}, from: {}, to: {}, steps: 1, carriage: car, x: 170 m}}",
                             parameter, values[0], values[1])));
    expect_ok(r);
    const Table& t = table_of(r, "sweep");
    ASSERT_EQ(t.rows.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const Result one = run_text(put_up_deck(install, at_rest), {parameter + "=" + values[i]});
      expect_ok(one);
      EXPECT_NEAR(cell(t, i, "skyline.unstretched"), value_of(one, "skyline.unstretched"), 1e-6);
      EXPECT_NEAR(cell(t, i, "skyline.T_max") / value_of(one, "skyline.T_max"), 1, 1e-6);
    }
    EXPECT_GT(std::abs(cell(t, 0, "skyline.unstretched") - cell(t, 1, "skyline.unstretched")), 1e-3);
  }
}

// The line hangs with 0.5 t as it is put up, and with 5 t in the last state: the deck of that length.
TEST(PutUp, IsKeptWhileLoadsChange) {
  const std::string rest = "  - equilibrium: {motion: at_rest}";
  const auto deck = [&](const std::string& analysis) {
    return replaced(put_up_deck("{tension: 60 kN, with: [car, logs]}", analysis), "{at: car, mass: 0 kg}",
                    "{name: logs, at: car, mass: 500 kg}");
  };
  const Result once = run_text(deck(rest));
  expect_ok(once);
  const std::string length = fmt::format("length: {:.17g} m", value_of(once, "skyline.unstretched"));
  const Result swept = run_text(
      deck("  - sweep: {parameter: loads.logs.mass, from: 500 kg, to: 2000 kg, steps: 3, carriage: car, x: 170 m}"));
  expect_ok(swept);
  const Table& t = table_of(swept, "sweep");
  for (std::size_t i = 0; i < 4; ++i) {
    const Result alone = run_text(replaced(
        replaced(skyline_deck("  - equilibrium: {carriage: car, x: 170 m, motion: at_rest}"), "length: 382 m", length),
        "{at: car, mass: 0 kg}", fmt::format("{{name: logs, at: car, mass: {} kg}}", 500 + 500 * i)));
    expect_ok(alone);
    EXPECT_NEAR(cell(t, i, "skyline.unstretched"), value_of(once, "skyline.unstretched"), 1e-9);
    EXPECT_NEAR(cell(t, i, "skyline.T_max") / value_of(alone, "skyline.T_max"), 1, 1e-7);
  }
}

TEST(PutUp, ALineThatBreaksWhileItIsPutUpFails) {
  const Result r = run_text(put_up_deck("{tension: 300 kN}", at_rest));
  expect_ok(r);
  const auto check =
      std::find_if(r.checks.begin(), r.checks.end(), [](const auto& c) { return c.name == "skyline.T_max"; });
  ASSERT_NE(check, r.checks.end());
  EXPECT_FALSE(check->passes);
  EXPECT_GT(check->value, 300e3) << "at the tower, higher up";
  EXPECT_EQ(exit_code(r), 4);
}

TEST(PutUp, LinesArePutUpInTurn) {
  // the guyed head gives way: the second line finds it pulled by the first
  const std::string deck = R"(taut: 1
machine:
  points: {a: [-40 m, 0 m, 0 m], b: [60 m, 0 m, 0 m], c: [60 m, 0 m, 20 m]}
  ropes: {r: {mass: 1 kg/m, stiffness: 5 MN}}
  bodies: {head: {mass: 200 kg, at: [0 m, 0 m, 20 m], free: [x]}}
  guys: {stay: {rope: r, from: head, to: a, install: {tension: 20 kN}}}
  reevings:
    - {rope: r, name: low, path: [{anchor: b}, {anchor: head}], install: {tension: 9 kN}}
    - {rope: r, name: high, path: [{anchor: c}, {anchor: head}], install: {tension: 7 kN}}
)";
  const Result both = run_text(deck);
  expect_ok(both);
  const Table& t = table_of(both, "put_up");
  ASSERT_EQ(t.rows.size(), 2U);
  const Result low = run_text(replaced(
      deck, "    - {rope: r, name: high, path: [{anchor: c}, {anchor: head}], install: {tension: 7 kN}}\n", ""));
  expect_ok(low);
  EXPECT_NEAR(cell(t, 0, "unstretched"), value_of(low, "low.unstretched"), 1e-8);
  EXPECT_NEAR(value_of(low, "low.T_start"), 9e3, 1e-3);
  EXPECT_NEAR(value_of(both, "high.T_start"), 7e3, 1e-3) << "put up last: as it stands";
  EXPECT_LT(value_of(both, "low.T_start"), 9e3) << "eased by the one that came later";
}

TEST(PutUp, AHeldTensionIsSaidAndWarnedOfWhereNothingHoldsIt) {
  const auto held = [](const Result& r) {
    return std::count_if(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
      return w ==
             "tension_at_start of 'skyline': the tension at 'stump' is held at 70 kN in every state at rest, and no "
             "drum or take-up is there; for a line with fixed ends give install: {tension: 70 kN, at: start}";
    });
  };
  const auto assumed = [](const Result& r, const std::string& words) {
    return std::any_of(r.assumptions.begin(), r.assumptions.end(),
                       [&](const std::string& text) { return text.find(words) != std::string::npos; });
  };
  const std::string deck = replaced(skyline_deck(at_rest), "length: 382 m", "tension_at_start: 70 kN");
  const Result r = run_text(deck);
  expect_ok(r);
  EXPECT_EQ(held(r), 1);
  EXPECT_TRUE(assumed(r, "Rope skyline: its tension at its start is held at 70 kN in every state at rest"));
  // a drum can hold it
  const Result drum = run_text(
      replaced(replaced(deck, "    winch:", "    sky: {at: [0 m, 0 m, 4 m], core_diameter: 600 mm}\n    winch:"),
               "{anchor: stump}", "{drum: sky}"));
  expect_ok(drum);
  EXPECT_EQ(held(drum), 0);
  EXPECT_TRUE(assumed(drum, "is held at 70 kN"));
  const Result up = run_text(put_up_deck("{tension: 70 kN}", at_rest));
  expect_ok(up);
  EXPECT_EQ(held(up), 0);
  EXPECT_TRUE(assumed(up, "Rope skyline: put up empty with 70 kN at its start"));
}

TEST(PutUp, RefusesWhatCanNotBePutUp) {
  const auto deck = [](const std::string& install) { return put_up_deck(install, at_rest); };
  expect_mistake(run_text(deck("{tension: 35 kN, with: [cra]}")), "did you mean 'car'?");
  expect_mistake(run_text(deck("{tension: 35 kN}, length: 380 m")), "has length and install; give one of them");
  expect_mistake(run_text(deck("{at: end}")), "lacks 'tension'");
  expect_mistake(run_text(replaced(deck("{tension: 35 kN, with: [logs]}"), "{at: car, mass: 0 kg}",
                                   "{name: logs, at: car, mass: 9 kg}")),
                 "the load 'logs' hangs on 'car': name that too");
  expect_mistake(
      run_text(replaced(deck("{tension: 35 kN}"), "{at: car, mass: 0 kg}", "{name: car, at: car, mass: 9 kg}")),
      "another body or carriage is called 'car'");
  // the line's own weight pulls harder than that
  const Result r = run_text(deck("{tension: 0.5 kN}"));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.message.find("'skyline' can't be put up with 0.5 kN at its start"), std::string::npos) << r.message;
}

/// Two cars on two tracks of their own, a haul rope from one over a sheave to the other.
std::string jig_back(const std::string& first, const std::string& second) {
  return R"(taut: 1
machine:
  ropes:
    track: {mass: 3 kg/m, stiffness: 40 MN, breaking_force: 500 kN, diameter: 28 mm}
    haul: {mass: 0.6 kg/m, stiffness: 8 MN, breaking_force: 100 kN, diameter: 12 mm}
  points: {tA: [0 m, 1 m, 100 m], bA: [200 m, 1 m, 0 m], tB: [0 m, -1 m, 100 m], bB: [200 m, -1 m, 0 m]}
  sheaves:
    top: {at: [-2 m, 0 m, 100 m], diameter: 2 m, axis: [0.4472, 0, 0.8944], friction: 0.3, motor: {}}
  carriages:
    down: {mass: 100 kg, rides: trackA, hold: rolling, mainline: haul}
    up: {mass: 100 kg, rides: trackB, hold: rolling, haulback: haul}
  reevings:
    - {rope: track, name: trackA, path: [{anchor: tA}, {through: down}, {anchor: bA}], )" +
         first + R"(}
    - {rope: track, name: trackB, path: [{anchor: tB}, {through: up}, {anchor: bB}], )" +
         second + R"(}
    - {rope: haul, path: [{anchor: down}, {over: top}, {anchor: up}], tension_at_start: 3 kN, length: 225 m}
  loads: [{at: down, mass: 600 kg}]
analyses: [equilibrium: {motion: at_rest}]
)";
}

// With its own car the haul rope goes, and with that the other car, which nothing holds on its track; the tracks are
// equal, so they get one length, also where the other one is there already.
TEST(PutUp, TheTracksOfAJigBackRopeway) {
  const Result both = run_text(jig_back("install: {tension: 100 kN}", "install: {tension: 100 kN}"));
  expect_ok(both);
  EXPECT_NEAR(value_of(both, "trackA.base_tension"), 100e3, 1e-3);
  EXPECT_NEAR(value_of(both, "trackB.base_tension"), 100e3, 1e-3);
  const double cut = value_of(both, "trackA.cut_length");
  EXPECT_NEAR(value_of(both, "trackB.cut_length"), cut, 1e-6);
  const Result second = run_text(jig_back("length: 223.2 m", "install: {tension: 100 kN}"));
  expect_ok(second);
  EXPECT_NEAR(value_of(second, "trackB.cut_length"), cut, 1e-6);
}

}  // namespace put_up_test
