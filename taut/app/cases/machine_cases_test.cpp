#include "taut/app/cases/machine_cases.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>

#include "taut/app/cases/read_cases.hpp"
#include "test/paths.hpp"

namespace taut::app::machine_cases_test {

using testing::HasSubstr;

/// A rolling load with two equilibria, a load path and a check; `parameters` give the height of its head.
const char* const deck =
    "taut: 1\n"
    "parameters: {height: 30 m}\n"
    "machine:\n"
    "  points: {tail: [0 m, 0 m, 0 m], head: [200 m, 0 m, = height]}\n"
    "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
    "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
    "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
    "  loads: [{at: car, mass: 1 t}]\n"
    "analyses:\n"
    "  - equilibrium: {motion: at_rest}\n"
    "  - equilibrium: {carriage: car, x: 50 m, held: true}\n"
    "  - equilibrium: {name: far, carriage: car, x: 170 m, held: true}\n"
    "  - load_path: {carriage: car, from: 40 m, to: 160 m, steps: 6, held: true}\n"
    "checks: {ropes: {sky: {safety_factor: 3}}}\n";

Job job_of(const std::string& text, std::vector<std::string> set = {}) {
  return {.text = text, .name = "deck.yaml", .set = std::move(set), .progress = {}};
}

CaseQuestion question_of(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  CaseQuestion q;
  for (const std::string& one : inputs) q.inputs.push_back({one, ""});
  for (const std::string& one : outputs) q.outputs.push_back({one, ""});
  return q;
}

CaseModel model_of(const std::string& text, const CaseQuestion& question) {
  const auto read = read_cases(job_of(text));
  if (!read) throw std::runtime_error(to_text(read.error().errors));
  auto made = read->cases(question);
  if (!made) {
    throw std::runtime_error(made.error().complaints.empty() ? made.error().outcome.message
                                                             : made.error().complaints.front().message);
  }
  return std::move(*made);
}

double value_with(const std::vector<std::string>& set, const std::string& analysis, const std::string& name) {
  std::vector<std::string> all = set;
  if (!analysis.empty()) all.push_back("analyses=[" + analysis + "]");
  const Result r = run(job_of(deck, all));
  const Value* v = r.find_value(name);
  return v != nullptr ? v->value : std::nan("");
}

/// A line of 100 m; `given`: how it comes by its length.
std::string line_of_100(const std::string& given, const std::string& more = "") {
  return "taut: 1\n"
         "parameters: {air: 20 degC}\n"
         "machine:\n"
         "  temperature: = air\n"
         "  points: {a: [0 m, 0 m, 10 m], b: [100 m, 0 m, 10 m]}\n"
         "  ropes: {sky: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 200 kN, reference_temperature: 20 degC}}\n"
         "  reevings: [{rope: sky, path: [{anchor: a}, {anchor: b}], " +
         given +
         "}]\n"
         "analyses: [{equilibrium: {}}]\n"
         "checks: {ropes: {sky: {safety_factor: 3}}}\n" +
         more;
}

// Put up with 20 kN at 20 degC: the length is kept in the cold, by whatever name the temperature is varied.
TEST(MachineCases, WhatIsPutUpKeepsItsLength) {
  const std::string put_up = line_of_100("install: {tension: 20 kN, at: start}");
  const double length = run(job_of(put_up)).find_value("sky.unstretched")->value;
  const Result cold = run(job_of(line_of_100(fmt::format("length: {:.17g} m", length)), {"parameters.air=-30 degC"}));
  const double T = cold.find_value("sky.T_max")->value;
  EXPECT_GT(T, 25.5e3);
  for (const char* name : {"machine.temperature", "parameters.air"}) {
    const CaseModel model =
        model_of(put_up, question_of({name}, {"equilibrium.sky.T_max", "checks.sky.safety_factor"}));
    const double kelvin = 243.15;
    const CaseAnswer answer = model.answer(std::span(&kelvin, 1));
    ASSERT_TRUE(answer.outcome.ok()) << answer.outcome.message;
    EXPECT_NEAR(answer.outputs[0] / T, 1, 1e-9) << name;
    EXPECT_NEAR(answer.outputs[1] * T / 200e3, 1, 1e-9) << name;
  }
  // another base tension is another line
  const CaseModel model = model_of(
      put_up, question_of({"machine.reevings.sky.install.tension", "machine.temperature"}, {"equilibrium.sky.T_max"}));
  const double both[] = {25e3, 293.15};
  EXPECT_NEAR(model.answer(both).outputs[0],
              run(job_of(line_of_100("install: {tension: 25 kN, at: start}"))).find_value("sky.T_max")->value, 1e-3);
}

// A load that is drawn into the stiffer of two ropes that were drawn to equal tensions: 9.81 kN + 2 t x 10/11.
TEST(MachineCases, RopesOfEqualTensionKeepTheirLengths) {
  const std::string two =
      "taut: 1\n"
      "machine:\n"
      "  gravity: 10 m/s^2\n"
      "  points: {a: [-1 m, 0 m, 10 m], b: [1 m, 0 m, 10 m]}\n"
      "  ropes: {stiff: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}, soft: {mass: 0 kg/m, stiffness: 1 "
      "MN}}\n"
      "  bodies: {hook: {at: [0 m, 0 m, 0 m], free: [z]}}\n"
      "  loads: [{at: hook, mass: 2 t}]\n"
      "  reevings:\n"
      "    - {name: r2, rope: soft, path: [{anchor: b}, {anchor: hook}], length: 10 m}\n"
      "    - {name: r1, rope: stiff, path: [{anchor: a}, {anchor: hook}], tension_equals: r2}\n"
      "analyses: [{equilibrium: {}}]\n";
  const CaseModel model = model_of(two, question_of({"machine.loads[0].mass"}, {"equilibrium.r1.T_max"}));
  double mass = 2000;
  const double before = model.answer(std::span(&mass, 1)).outputs[0];
  mass = 2100;
  const double rises = model.answer(std::span(&mass, 1)).outputs[0] - before;
  EXPECT_NEAR(rises / (1000 * 10 / 11.0 * std::sqrt(101) / 10), 1, 0.02) << before;
}

// A case begins near the state of the deck, but what is fixed in it stands where the case has it.
TEST(MachineCases, WhatIsFixedStandsWhereTheCaseHasIt) {
  const std::string posts =
      "taut: 1\n"
      "machine:\n"
      "  points: {a: [0 m, 0 m, 10 m]}\n"
      "  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}\n"
      "  bodies:\n"
      "    post: {at: [10.01 m, 0 m, 10 m]}\n"
      "    slide: {at: [21 m, 0 m, 10 m], free: [x]}\n"
      "  reevings:\n"
      "    - {name: r1, rope: r, path: [{anchor: a}, {anchor: post}], length: 10 m}\n"
      "    - {name: r2, rope: r, path: [{anchor: post}, {anchor: slide}], length: 10 m}\n"
      "  take_up: [{body: slide, screw: 8 kN, keeps: place}]\n"
      "analyses: [{equilibrium: {}}]\n";
  const CaseModel model = model_of(posts, question_of({"machine.bodies.post.at.x", "machine.take_up[0].screw"},
                                                      {"equilibrium.r1.T_max", "equilibrium.r2.T_max"}));
  for (const double x : {10.01, 10.02}) {
    for (const double screw : {8e3, 3e3}) {
      const double both[] = {x, screw};
      const CaseAnswer answer = model.answer(both);
      EXPECT_NEAR(answer.outputs[0], 10e6 * (x - 10) / 10, 1e-3);
      EXPECT_NEAR(answer.outputs[1], screw, 1e-3);
    }
  }
}

// A screw takes up the tolerance of its rope.
TEST(MachineCases, AScrewIsSetOnTheRopeOfTheCase) {
  const std::string slide =
      "taut: 1\n"
      "machine:\n"
      "  points: {a: [0 m, 0 m, 10 m]}\n"
      "  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}\n"
      "  bodies: {slide: {at: [10 m, 0 m, 10 m], free: [x]}}\n"
      "  reevings: [{name: r1, rope: r, path: [{anchor: a}, {anchor: slide}], length: 10 m}]\n"
      "  take_up: [{body: slide, screw: 8 kN, keeps: place}]\n"
      "analyses: [{equilibrium: {}}]\n";
  const CaseModel model = model_of(slide, question_of({"machine.reevings.r1.length"}, {"equilibrium.r1.T_max"}));
  for (const double length : {9.99, 10.01}) {
    EXPECT_NEAR(model.answer(std::span(&length, 1)).outputs[0], 8e3, 1e-3);
  }
}

TEST(MachineCases, AnInputThatEveryAnalysisSetsAnewIsAMistake) {
  const auto mistake = [](const std::string& analyses, const std::string& input) {
    std::string text = deck;
    text.replace(text.find("analyses:"), text.find("checks:") - text.find("analyses:"),
                 "analyses: [" + analyses + "]\n");
    try {
      model_of(text, question_of({input}, {"checks.sky.safety_factor"}));
    } catch (const std::runtime_error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string sweep = "{sweep: {parameter: loads.car.mass, from: 1 t, to: 2 t, steps: 2}}";
  EXPECT_THAT(mistake(sweep, "machine.loads[0].mass"), HasSubstr("every analysis sets 'machine.loads[0].mass' anew"));
  EXPECT_EQ(mistake(sweep + ", {equilibrium: {carriage: car, x: 50 m, held: true}}", "machine.loads[0].mass"), "");
  EXPECT_EQ(mistake(sweep, "machine.carriages.car.mass"), "");
  const std::string given = "{equilibrium: {carriage: car, x: 100 m, held: true, given: {reeving: sky, sag: 8 m}}}";
  EXPECT_THAT(mistake(given, "machine.reevings.sky.length"), HasSubstr("it would change nothing"));
}

TEST(MachineCases, EachAnalysisHasTheValuesOfARunWithItAlone) {
  const CaseModel m =
      model_of(deck, question_of({"machine.loads[0].mass"}, {"equilibrium.sky.T_max", "equilibrium_2.sky.T_max",
                                                             "equilibrium_far.sky.T_max", "load_path.sky.T_max"}));
  const CaseAnswer a = m.answer(std::vector<double>{1300});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  const std::vector<std::string> set = {"machine.loads[0].mass=1300 kg"};
  const std::string analyses[] = {"{equilibrium: {motion: at_rest}}",
                                  "{equilibrium: {carriage: car, x: 50 m, held: true}}",
                                  "{equilibrium: {name: far, carriage: car, x: 170 m, held: true}}",
                                  "{load_path: {carriage: car, from: 40 m, to: 160 m, steps: 6, held: true}}"};
  for (std::size_t i = 0; i < a.outputs.size(); ++i) {
    const double expected = value_with(set, analyses[i], "sky.T_max");
    EXPECT_NEAR(a.outputs[i], expected, 1e-8 * expected) << analyses[i];
  }
  EXPECT_NE(a.outputs[1], a.outputs[2]);
}

/// The answers of all these cases, to the last bit, asked in this order.
std::vector<std::vector<double>> answers_in(const CaseModel& m, const std::vector<std::vector<double>>& cases) {
  std::vector<std::vector<double>> all;
  all.reserve(cases.size());
  for (const std::vector<double>& one : cases) all.push_back(m.answer(one).outputs);
  return all;
}

TEST(MachineCases, ACaseDoesNotDependOnThoseBefore) {
  std::string text = deck;
  text.replace(text.find("{at: car, mass: 1 t}"), 20, "{at: car, mass: 1 t}, {at: car, force: [1 kN, 0 N, -2 kN]}");
  const std::vector<std::string> plain = {"machine.loads[0].mass", "machine.points.head.z"};
  // a direction keeps the length of its force, which a component changes
  const std::vector<std::string> angle = {"machine.loads[1].force.x", "machine.loads[1].force.angle"};
  const std::vector<std::string> asked = {"equilibrium.sky.T_start", "equilibrium.sky.T_max", "equilibrium_2.car.z"};
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::vector<double>>>> questions = {
      {plain, {{900, 28}, {1300, 31}, {-5, 30}, {900, 28}}},
      {angle, {{500, -1.2}, {1500, -1.0}, {800, -1.4}, {500, -1.2}}}};
  for (const auto& [inputs, cases] : questions) {
    const auto alone = [&](const std::vector<double>& one) {
      return model_of(text, question_of(inputs, asked)).answer(one).outputs;
    };
    const auto one_after_the_other = answers_in(model_of(text, question_of(inputs, asked)), cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const std::vector<double> expected = alone(cases[i]);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        if (std::isnan(expected[k])) {
          EXPECT_TRUE(std::isnan(one_after_the_other[i][k]));
        } else {
          EXPECT_EQ(one_after_the_other[i][k], expected[k]) << inputs.back() << ", case " << i << ", " << asked[k];
        }
      }
    }
    EXPECT_EQ(one_after_the_other.front(), one_after_the_other.back());
  }
}

TEST(MachineCases, WhatTheVerdictSaysIsThereWhereItIsWanted) {
  const std::vector<std::string> judged = {"equilibrium.T_max", "equilibrium.sky.T_max",
                                           "equilibrium.sky.safety_factor", "equilibrium.sky.T_max.utilisation",
                                           "equilibrium.rope_clearance_min"};
  std::string text = deck;
  text.replace(text.find("machine:"), 8, "machine:\n  terrain: {x: [-10 m, 250 m], z: [-40 m, -40 m]}");
  const CaseModel m = model_of(text, question_of({"machine.loads[0].mass"}, judged));
  const CaseAnswer a = m.answer(std::vector<double>{1300});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  EXPECT_NEAR(a.outputs[0], a.outputs[1], 1e-9 * a.outputs[1]) << "one rope";
  EXPECT_NEAR(a.outputs[2], 300e3 / a.outputs[1], 1e-9 * a.outputs[2]);
  EXPECT_NEAR(a.outputs[3], a.outputs[1] / 300e3, 1e-9);
  EXPECT_GT(a.outputs[4], 0);
}

TEST(MachineCases, ChecksAreOfTheWholeDeck) {
  const CaseModel m = model_of(deck, question_of({"machine.loads[0].mass"},
                                                 {"checks.sky.safety_factor", "checks.sky.safety_factor.utilisation"}));
  const CaseAnswer a = m.answer(std::vector<double>{1300});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  const double factor = value_with({"machine.loads[0].mass=1300 kg"}, "", "sky.safety_factor");
  EXPECT_NEAR(a.outputs[0], factor, 1e-8 * factor);
  EXPECT_NEAR(a.outputs[1], 3 / factor, 1e-8);
}

/// 500 kg on a rope of 150 kN, and 50 kN that come within a second and stay: 5 kN at rest, 55 kN at the end.
std::string pulled(const std::string& factor) {
  return "taut: 1\n"
         "machine:\n"
         "  signals: {pull: {ramp: {to: 50 kN, start: 0.2 s, duration: 1 s, smooth: true}}}\n"
         "  points: {top: [0 m, 0 m, 20 m]}\n"
         "  ropes: {r: {breaking_force: 150 kN, stiffness: 15 MN, mass: 1 kg/m, damping_ratio: 0.05}}\n"
         "  bodies: {hook: {mass: 500 kg, at: [0 m, 0 m, 10 m], free: [z]}}\n"
         "  reevings: [{rope: r, path: [{anchor: top}, {anchor: hook}], length: 10 m}]\n"
         "  loads: [{at: hook, force: [0 kN, 0 kN, -1 N], signal: pull}]\n"
         "analyses: [{transient: {duration: 2 s, output_step: 20 ms}}]\n"
         "checks: {ropes: {r: {" +
         factor + "}}}\n";
}

const char* const pulled_mass = "machine.bodies.hook.mass";

// The factor at rest is 30, and the check holds 2.7 against its limit.
TEST(MachineCases, AFactorOfTheChecksIsThatOfTheCheckAlsoInAMotion) {
  const std::string text = pulled("safety_factor: 2.5");
  const CaseModel m = model_of(
      text, question_of({pulled_mass}, {"checks.r.safety_factor", "transient.r.safety_factor", "checks.r.T_max"}));
  const CaseAnswer a = m.answer(std::vector<double>{510});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  const Result r = run(job_of(text, {"machine.bodies.hook.mass=510 kg"}));
  const auto check =
      std::find_if(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name == "r.safety_factor"; });
  ASSERT_NE(check, r.checks.end());
  EXPECT_NEAR(a.outputs[0], check->value, 1e-9 * check->value);
  EXPECT_NEAR(a.outputs[0], 150e3 / a.outputs[2], 1e-9 * check->value) << "by the peak";
  EXPECT_NEAR(a.outputs[1], r.find_value("r.safety_factor")->value, 1e-9 * a.outputs[1]);
  EXPECT_NEAR(a.outputs[1], 150e3 / (510 + 10) / 9.80665, 0.01 * a.outputs[1]) << "at rest: the rope weighs 10 kg";
}

// Not judged by a run of the deck: the factor is enough at rest, and not at the peak.
TEST(MachineCases, AFactorThatNoCheckCouldTellHasNoAnswer) {
  for (const char* factor : {"safety_factor: 5", "diameter: 16 mm"}) {
    const auto read = read_cases(job_of(pulled(factor)));
    ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
    const auto made = read->cases(question_of({pulled_mass}, {"checks.r.safety_factor"}));
    ASSERT_FALSE(made.has_value()) << factor;
    EXPECT_THAT(made.error().outcome.message, HasSubstr("the motion reaches 55")) << factor;
    EXPECT_THAT(made.error().outcome.message, HasSubstr("more than twice the tension at rest")) << factor;
  }
}

TEST(MachineCases, AFactorAtRestThatAMotionGoesBeyondIsTold) {
  const CaseModel m = model_of(pulled("safety_factor: 5"), question_of({pulled_mass}, {"transient.r.safety_factor"}));
  const auto open_of = [&](double mass) {
    const CaseAnswer a = m.answer(std::vector<double>{mass});
    EXPECT_TRUE(a.outcome.ok()) << a.outcome.message;
    const auto found = std::find_if(a.flaws.begin(), a.flaws.end(),
                                    [](const CaseFlaw& one) { return one.check == "r.safety_factor"; });
    return found == a.flaws.end() ? std::nullopt : std::optional(*found);
  };
  const auto open = open_of(500);
  ASSERT_TRUE(open.has_value());
  EXPECT_EQ(open->kind, CaseFlaw::Kind::unmade);
  EXPECT_EQ(open->analysis, "transient");
  EXPECT_THAT(open->words, HasSubstr("r.safety_factor is for the tension at rest: the motion reaches 55"));
  EXPECT_THAT(open->words, HasSubstr("full load and limit checks.r.safety_factor, or limit the T_max of r"));
  // 50 kN more than 2 MN are no news
  EXPECT_FALSE(open_of(200e3).has_value());
}

TEST(MachineCases, AnalysesThatNoOutputNeedsAreNamed) {
  const auto not_run = [](const std::string& text, const std::vector<std::string>& outputs) {
    return model_of(text, question_of({"machine.loads[0].mass"}, outputs)).not_run;
  };
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(not_run(deck, {"equilibrium_2.sky.T_max"}), ElementsAre("equilibrium", "equilibrium_far", "load_path"));
  EXPECT_THAT(not_run(deck, {"equilibrium_2.sky.T_max", "checks.sky.safety_factor"}), IsEmpty());
  std::string text = deck;
  text.replace(text.find("name: far"), 9, "name: far, judge: false");
  EXPECT_THAT(not_run(text, {"equilibrium_2.sky.T_max"}), ElementsAre("equilibrium", "load_path"))
      << "what a run of the deck does not judge is not missed";
}

/// The same number by a run of its own and by a case.
struct SetNumber {
  const char* path;   ///< of the deck
  double value;       ///< SI
  const char* text;   ///< the same
  const char* check;  ///< that it is seen by
  bool of_limit = false;
};

std::optional<Check> check_with(const std::string& text, const SetNumber& one) {
  const Result r = run(job_of(text, {fmt::format("{}={}", one.path, one.text)}));
  const auto found =
      std::find_if(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == one.check; });
  return found == r.checks.end() ? std::nullopt : std::optional(*found);
}

TEST(MachineCases, NumbersOfTheChecksAreThoseOfTheCase) {
  std::string text = deck;
  text.replace(text.find("checks:"), std::string::npos,
               "checks:\n"
               "  ropes:\n"
               "    sky: {safety_factor: 3, dynamic_safety_factor: 2, dynamic_factor: 1.2, elastic_limit: 0.9,\n"
               "          temperature: 120 degC, core: IWRC, termination_efficiency: 0.95,\n"
               "          diameter: 20 mm}\n"
               "  anchors:\n"
               "    head: {strength: 200 kN, safety_factor: 1.5, dynamic_factor: 1.3}\n");
  std::string hoisted = text;
  hoisted.replace(hoisted.find("dynamic_factor: 1.2"), 19, "hoist: {class: HC2, speed: 0.2 m/s}");
  const std::pair<std::string, SetNumber> all[] = {
      {text, {"checks.ropes.sky.safety_factor", 6, "6", "sky.safety_factor", true}},
      {text, {"checks.ropes.sky.dynamic_safety_factor", 5, "5", "sky.dynamic_safety_factor", true}},
      {text, {"checks.ropes.sky.dynamic_factor", 2, "2", "sky.dynamic_safety_factor"}},
      {text, {"checks.ropes.sky.elastic_limit", 0.5, "0.5", "sky.elastic_limit", true}},
      {text, {"checks.ropes.sky.temperature", 423.15, "150 degC", "sky.temperature"}},
      {text, {"checks.ropes.sky.termination_efficiency", 0.5, "0.5", "sky.termination"}},
      {hoisted, {"checks.ropes.sky.hoist.speed", 1, "1 m/s", "sky.dynamic_safety_factor"}},
      {text, {"checks.anchors.head.strength", 150e3, "150 kN", "head.anchor_strength"}},
      {text, {"checks.anchors.head.dynamic_factor", 2, "2", "head.anchor_strength"}}};
  for (const auto& [machine, one] : all) {
    const auto expected = check_with(machine, one);
    ASSERT_TRUE(expected.has_value()) << one.path;
    const std::string output = fmt::format("checks.{}", one.check);
    const CaseModel m = model_of(machine, question_of({one.path}, {output, output + ".utilisation"}));
    const CaseAnswer a = m.answer(std::vector<double>{one.value});
    ASSERT_TRUE(a.outcome.ok()) << one.path << ": " << a.outcome.message;
    EXPECT_NEAR(a.outputs[0], expected->value, 1e-8 * expected->value) << one.path;
    EXPECT_NEAR(a.outputs[1], expected->utilisation, 1e-8 * expected->utilisation) << one.path;
    const std::size_t seen = one.of_limit ? 1 : 0;
    EXPECT_GT(std::abs(a.outputs[seen] / m.outputs[seen].base - 1), 0.01) << one.path << " changes nothing";
  }
}

// In a run of the deck the factor of a rope at 300 degC is 0.75 of that of the cold one.
TEST(MachineCases, TheHeatOfARopeWeakensItInEachAnalysis) {
  std::string text = deck;
  text.replace(text.find("safety_factor: 3"), 16, "safety_factor: 3, core: IWRC, temperature: 40 degC");
  const std::string only = "analyses=[{equilibrium: {motion: at_rest}}]";
  for (const char* path : {"checks.ropes.sky.temperature", "machine.loads[0].mass"}) {
    const bool heated = path[0] == 'c';
    const std::string set = heated ? "=300 degC" : "=2 t";
    const std::string own = heated ? text : text.replace(text.find("40 degC"), 7, "300 degC");
    const CaseModel m = model_of(own, question_of({path}, {"equilibrium.sky.safety_factor"}));
    const CaseAnswer a = m.answer(std::vector<double>{heated ? 573.15 : 2000});
    ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
    const Result r = run(job_of(own, {only, path + set}));
    EXPECT_NEAR(a.outputs[0], r.find_value("sky.safety_factor")->value, 1e-8 * a.outputs[0]) << path;
    const Result cold = run(job_of(own, {only, path + set, "checks.ropes.sky.temperature=40 degC"}));
    EXPECT_NEAR(a.outputs[0], 0.75 * cold.find_value("sky.safety_factor")->value, 1e-3 * a.outputs[0]);
  }
}

TEST(MachineCases, ChecksThatAreAMistakeWithTheNumbersOfACaseHaveNoAnswer) {
  std::string text = deck;
  text.replace(text.find("safety_factor: 3"), 16, "safety_factor: 3, breaking_force: 300 kN");
  const CaseModel m = model_of(text, question_of({"checks.ropes.sky.breaking_force"}, {"checks.sky.safety_factor"}));
  EXPECT_TRUE(m.answer(std::vector<double>{300e3}).outcome.ok());
  const CaseAnswer a = m.answer(std::vector<double>{400e3});
  EXPECT_EQ(a.outcome.status, Status::infeasible);
  EXPECT_THAT(a.outcome.message, HasSubstr("checks.ropes.sky.breaking_force: the rope has another value already"));
}

TEST(MachineCases, ParametersAreReadAnewBesideOtherNumbers) {
  const CaseModel m = model_of(deck, question_of({"parameters.height", "machine.loads[0].mass"},
                                                 {"equilibrium.sky.T_max", "equilibrium.car.z"}));
  EXPECT_EQ(m.inputs[0].base, 30);
  const CaseAnswer a = m.answer(std::vector<double>{22.5, 900});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  const std::vector<std::string> set = {"parameters.height=22.5 m", "machine.loads[0].mass=900 kg"};
  EXPECT_NEAR(a.outputs[0], value_with(set, "{equilibrium: {motion: at_rest}}", "sky.T_max"), 1e-4);
  EXPECT_NEAR(a.outputs[1], value_with(set, "{equilibrium: {motion: at_rest}}", "car.z"), 1e-7);
}

// A steel core keeps 0.65 of its strength up to 400 degC: each case has the factor of a run of the deck that it is.
TEST(MachineCases, AHotMachineHasHotRopesInEveryCase) {
  const std::string text =
      "taut: 1\nmachine:\n  temperature: 20 degC\n  points: {A: [0 m, 0 m, 30 m], B: [200 m, 0 m, 30 m]}\n  ropes: {r: "
      "{rope: \"EN 12385-4|6x36-IWRC|16|1960\", reference_temperature: 20 degC}}\n  reevings: [{rope: r, path: "
      "[{anchor: A}, {anchor: B}], length: 200.5 m}]\nanalyses: [{equilibrium: {}}, {envelope: {temperatures: [20 "
      "degC, 150 degC]}}]\nchecks: {ropes: {r: {safety_factor: 3}}}\n";
  std::string told = text;
  told.replace(told.find("safety_factor: 3"), 16, "safety_factor: 3, temperature: 20 degC");
  const CaseQuestion question = question_of(
      {"machine.temperature"}, {"equilibrium.r.safety_factor", "envelope.r.safety_factor", "checks.r.safety_factor"});
  const CaseModel m = model_of(text, question), unweakened = model_of(told, question);
  for (const auto& [t, words, alone] : {std::tuple(293.15, "20 degC", 1.0), std::tuple(623.15, "350 degC", 0.65)}) {
    const CaseAnswer a = m.answer(std::vector<double>{t}), plain = unweakened.answer(std::vector<double>{t});
    ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
    ASSERT_TRUE(plain.outcome.ok()) << plain.outcome.message;
    const double together = std::min(alone, 0.9);  // the envelope is at 150 degC
    EXPECT_NEAR(a.outputs[0], alone * plain.outputs[0], 1e-9 * plain.outputs[0]) << words;
    EXPECT_NEAR(a.outputs[2], together * plain.outputs[2], 1e-9 * plain.outputs[2]) << words;
    EXPECT_NEAR(a.outputs[1], a.outputs[2], 1e-6 * a.outputs[2]) << words;
    const Result whole = run(job_of(text, {fmt::format("machine.temperature={}", words)}));
    const double check = whole.find_value("r.safety_factor")->value;
    EXPECT_NEAR(a.outputs[2], check, 1e-9 * check) << words;
  }
}

// 0.3 alone is no slope.
TEST(MachineCases, ASlopeInPercentIsOneInEveryCase) {
  std::string text = deck;
  const std::string given = "parameters: {", checked = "checks: {";
  text.insert(text.find(given) + given.size(), "grade: 30 %, ");
  text.insert(text.find(checked) + checked.size(), "anchors: {tail: {tree_diameter: 60 cm, ground_slope: = grade}}, ");
  const CaseModel m = model_of(text, question_of({"parameters.grade"}, {"checks.tail.anchor_tree"}));
  EXPECT_EQ(m.inputs[0].base, 0.3);
  EXPECT_EQ(m.inputs[0].unit.shown, "%");
  for (const auto& [share, percent] : {std::pair(0.1, "10 %"), std::pair(0.6, "60 %")}) {
    const CaseAnswer a = m.answer(std::vector<double>{share});
    ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
    const Result alone = run(job_of(text, {fmt::format("parameters.grade={}", percent)}));
    const auto tree = std::find_if(alone.checks.begin(), alone.checks.end(),
                                   [](const Check& c) { return c.name == "tail.anchor_tree"; });
    ASSERT_NE(tree, alone.checks.end());
    EXPECT_EQ(a.outputs[0], tree->value);
  }
}

/// A light line between two anchors, 99.9 m cut at 15 degC for 100 m; `winter` is a parameter.
const char* const line =
    "taut: 1\n"
    "parameters: {winter: 15 degC}\n"
    "machine:\n"
    "  temperature: = winter + 0 K\n"
    "  points: {a: [0 m, 0 m, 0 m], b: [100 m, 0 m, 0 m]}\n"
    "  ropes: {r: {mass: 1 g/m, stiffness: 10 MN, breaking_force: 60 kN}}\n"
    "  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: 99.9 m}]\n"
    "analyses: [{equilibrium: {}}]\n"
    "checks: {ropes: {r: {safety_factor: 3}}}\n";

// On paper: L = 99.9 m (1 + 12e-6 (t - 15)), T = EA (100 m/L - 1).
TEST(MachineCases, LengthsHoldAtTheTemperatureOfTheDeckWhateverItIsInACase) {
  for (const char* path : {"machine.temperature", "parameters.winter"}) {
    const CaseModel m = model_of(line, question_of({path}, {"equilibrium.r.T_max"}));
    EXPECT_NEAR(m.inputs[0].base, 288.15, 1e-9);
    for (const double t : {-20., 15., 30.}) {
      const CaseAnswer a = m.answer(std::vector<double>{t + 273.15});
      ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
      const double length = 99.9 * (1 + 12e-6 * (t - 15));
      EXPECT_NEAR(a.outputs[0], 10e6 * (100 / length - 1), 3) << path << ' ' << t;
    }
  }
}

TEST(MachineCases, ANumberOutsideItsRangeIsACaseWithoutAnAnswer) {
  const CaseModel m = model_of(deck, question_of({"machine.ropes.sky.stiffness"}, {"equilibrium.sky.T_max"}));
  const CaseAnswer a = m.answer(std::vector<double>{-1e6});
  EXPECT_EQ(a.outcome.status, Status::infeasible);
  EXPECT_THAT(a.outcome.message, HasSubstr("machine.ropes.sky.stiffness"));
  EXPECT_TRUE(std::isnan(a.outputs[0]));
}

TEST(MachineCases, OfADesignOnlyItsOutcomeIsAsked) {
  std::ifstream file(taut_test::source_dir() / "examples/design/crane_hoist.yaml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto read = read_cases(job_of(text));
  ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
  const auto state = read->cases(question_of({"machine.loads[0].mass"}, {"equilibrium.T_max"}));
  ASSERT_FALSE(state.has_value());
  EXPECT_THAT(state.error().complaints.front().message, HasSubstr("one of design"));
  // the lightest rope that holds 10 t is lighter than that for 25 t
  const CaseModel m = model_of(text, question_of({"machine.loads[0].mass"}, {"design.design_cost"}));
  const CaseAnswer a = m.answer(std::vector<double>{10e3});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  EXPECT_LT(a.outputs[0], m.outputs[0].base);
  const Result r = run(job_of(text, {"machine.loads[0].mass=10 t"}));
  EXPECT_NEAR(a.outputs[0], r.find_value("design_cost")->value, 1e-9 * a.outputs[0]);
}

TEST(MachineCases, WhatADesignChoosesFromVariesByParametersOnly) {
  std::ifstream file(taut_test::source_dir() / "examples/design/crane_hoist.yaml");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  text.replace(text.find("taut: 1"), 7, "taut: 1\nparameters: {thin: 12 mm}");
  text.replace(text.find("core: IWRC, grade"), 11, "core: IWRC, least_diameter: = thin,");
  const auto read = read_cases(job_of(text));
  ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
  const auto design = read->cases(question_of({"design.ropes.hoist.least_diameter"}, {"design.design_cost"}));
  ASSERT_FALSE(design.has_value());
  EXPECT_THAT(design.error().complaints.front().message, HasSubstr("let one of the 'parameters' vary"));
  const CaseModel m = model_of(text, question_of({"parameters.thin"}, {"design.design_cost"}));
  const CaseAnswer a = m.answer(std::vector<double>{0.015});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  EXPECT_NEAR(a.outputs[0], run(job_of(text, {"parameters.thin=15 mm"})).find_value("design_cost")->value, 1e-9);
  EXPECT_GT(a.outputs[0], 1.2 * m.outputs[0].base);
}

TEST(MachineCases, WithoutAnAnswerOfTheDeckItselfThereAreNoCases) {
  const auto read = read_cases(job_of(deck, {"machine.reevings[0].length=100 m"}));
  ASSERT_TRUE(read.has_value());
  const auto made = read->cases(question_of({"machine.loads[0].mass"}, {"equilibrium.sky.T_max"}));
  ASSERT_FALSE(made.has_value());
  EXPECT_THAT(made.error().outcome.message, HasSubstr("the deck as it is has no answer"));
}

// IWRC up to 400 degC, FC up to 100 degC: a hotter case had the factor of the cold rope.
TEST(MachineCases, ARopeTooHotForTheTablesHasNoFactor) {
  for (const auto& [core, known, too_hot] : {std::tuple("IWRC", 400.0, 420.0), std::tuple("FC", 90.0, 150.0)}) {
    const std::string text = fmt::format(R"(taut: 1
machine:
  temperature: 20 degC
  points: {{a: [0 m, 0 m, 10 m]}}
  ropes: {{r: {{rope: "EN 12385-4|6x36-{}|10|1960", reference_temperature: 20 degC}}}}
  bodies: {{B: {{mass: 2 t, at: [0 m, 0 m, 5 m], free: [z]}}}}
  reevings: [{{rope: r, path: [{{anchor: a}}, {{anchor: B}}], length: 4.9 m}}]
analyses: [{{equilibrium: {{}}}}]
checks: {{ropes: {{r: {{safety_factor: 1}}}}}}
)",
                                         core);
    for (const char* factor : {"equilibrium.r.safety_factor", "checks.r.safety_factor"}) {
      const CaseModel m = model_of(text, question_of({"machine.temperature"}, {factor}));
      EXPECT_TRUE(m.answer(std::vector<double>{273.15 + known}).outcome.ok()) << core << factor;
      const CaseAnswer hot = m.answer(std::vector<double>{273.15 + too_hot});
      EXPECT_EQ(hot.outcome.status, Status::infeasible) << core << factor;
      EXPECT_THAT(hot.outcome.message, HasSubstr("no strength is known of a rope at")) << factor;
    }
  }
}

}  // namespace taut::app::machine_cases_test
