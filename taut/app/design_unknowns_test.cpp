#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "test/support/machine_decks.hpp"

/// Numbers that are free: each one that a designer names, found by the search and compared with the deck run by itself.
namespace taut::app::design_unknowns_test {

using namespace taut_test;
using testing::HasSubstr;

double worst_of(const Result& r) {
  double most = 0;
  for (const Check& c : r.checks) most = std::max(most, c.utilisation);
  return most;
}

bool passes(const Result& r) { return exit_code(r) == 0; }

/// An endless rope between a drive and a slide that a weight pulls.
std::string saw(const std::string& rope, const std::string& weight, const std::string& design) {
  return fmt::format(R"(taut: 1
machine:
  ropes: {{saw: {}}}
  bodies: {{slide: {{mass: 85 kg, at: [0 m, 0 m, 1 m], free: [x]}}}}
  sheaves:
    drive: {{at: [8 m, 0 m, 1 m], diameter: 700 mm, friction: 0.25, motor: {{speed: 10 m/s}}}}
    tail: {{body: slide, at: [0 m, 0 m, 0 m], diameter: 700 mm, efficiency: 0.98}}
  reevings: [{{rope: saw, path: [{{over: drive, side: left}}, {{over: tail, side: left}}], closed: true, length: 18.22 m}}]
  take_up: [{{body: slide, weight: {}, along: [-1, 0, 0]}}]
  rope_loads: [{{name: cut, rope: saw, between: [tail, drive], rate: 0.9 kN/m, from: 0.3, to: 0.67, elements: 3, direction: against_motion}}]
analyses: [equilibrium: {{motion: in}}]
checks: {{ropes: {{saw: {{safety_factor: 5}}}}}}
{})",
                     rope, weight, design);
}

constexpr const char* saw_rope = "{rope: \"EN 12385-4|6x36-IWRC|14|1960\", stiffness: 9 MN}";
constexpr const char* free_weight =
    "unknowns: {weight: {parameter: take_up.slide.weight, from: 0.1 t, to: 3000 kg, steps: 3}}";

// The lightest weight that lets the drive grip: the deck with it passes, with a hundredth less it slips.
TEST(DesignUnknowns, take_up_weight_is_the_least_that_grips) {
  const Result r = run_text(saw(saw_rope, "1 t", fmt::format("design: {{seek: lightest, {}}}", free_weight)));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  const double weight = value_of(r, "design_weight");
  EXPECT_GT(weight, 110);
  EXPECT_LT(weight, 2900);
  EXPECT_TRUE(passes(run_text(saw(saw_rope, fmt::format("{:.17g} kg", weight), ""))));
  EXPECT_FALSE(passes(run_text(saw(saw_rope, fmt::format("{:.17g} kg", 0.995 * weight), ""))));
  EXPECT_NEAR(worst_of(r), 1, 1e-3);
}

// Prices and tension ask for the same weight: the rope is tightened by nothing else. Other units, ends the other way
// round and a start in place of the grid find it too.
TEST(DesignUnknowns, the_same_however_it_is_asked_for) {
  const auto weight_by = [](const std::string& design) {
    const Result r = run_text(saw(saw_rope, "1 t", "design: {" + design + "}"));
    EXPECT_TRUE(passes(r)) << design << r.message << to_text(r.errors);
    return value_of(r, "design_weight");
  };
  const double weight = weight_by(free_weight);
  const std::string range = "parameter: take_up.slide.weight, from: 0.1 t, to: 3000 kg";
  EXPECT_NEAR(weight_by("seek: cheapest, unknowns: {weight: {" + range + ", price: 3}}"), weight, 2e-3 * weight);
  EXPECT_NEAR(weight_by("seek: least_tension, unknowns: {weight: {" + range + "}}"), weight, 2e-3 * weight);
  EXPECT_NEAR(weight_by("seek: least_tension, of: saw, unknowns: {weight: {" + range + "}}"), weight, 2e-3 * weight);
  EXPECT_NEAR(weight_by("unknowns: {weight: {parameter: take_up.slide.weight, from: 3 t, to: 220.46226 lb}}"), weight,
              2e-3 * weight);
  EXPECT_NEAR(weight_by("unknowns: {weight: {" + range + ", start: 2 t}}"), weight, 2e-3 * weight);
  EXPECT_NEAR(weight_by("unknowns: {weight: {parameter: \"machine.take_up[0].weight\", from: 100 kg, to: 3 t}}"),
              weight, 2e-3 * weight);
}

// Price weighs rope against weight: the answer is the least of all ropes, each with the least weight of its own.
TEST(DesignUnknowns, rope_and_weight_together) {
  const Result r = run_text(saw("{}", "1 t",
                                fmt::format("design: {{seek: lightest, ropes: {{saw: {{construction: 6x36, core: IWRC, "
                                            "grade: 1960 MPa}}}}, {}}}",
                                            free_weight)));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  // no rope of the grid's places is lighter, and this one alone passes
  const Table& chosen = table_of(r, "design");
  const double weight = value_of(r, "design_weight");
  const std::string rope =
      fmt::format("{{mass: {:.17g} kg/m, stiffness: {:.17g} N, breaking_force: {:.17g} N, diameter: {:.17g} m}}",
                  taut_test::cell(chosen, 0, "mass_per_metre"), taut_test::cell(chosen, 0, "stiffness"),
                  taut_test::cell(chosen, 0, "breaking_force"), taut_test::cell(chosen, 0, "diameter"));
  EXPECT_TRUE(passes(run_text(saw(rope, fmt::format("{:.17g} kg", weight), ""))));
  EXPECT_NEAR(value_of(r, "design_cost"), weight + 18.2 * taut_test::cell(chosen, 0, "mass_per_metre"), 3);
}

// Four digits were rounded to the side that fails for about every second weight.
TEST(DesignUnknowns, the_weight_to_build_passes_as_it_is_printed) {
  for (const char* rate : {"0.8 kN/m", "0.85 kN/m", "0.95 kN/m", "1 kN/m", "1.05 kN/m", "1.1 kN/m"}) {
    const std::string cut = std::string("machine.rope_loads.cut.rate=") + rate;
    const Result r = run_text(saw(saw_rope, "1 t", fmt::format("design: {{seek: lightest, {}}}", free_weight)), {cut});
    ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
    const std::string& text = r.answers.front().text;
    const std::string weight = text.substr(text.find("weight = ") + 9);
    EXPECT_LT(weight.size(), 12U) << "no more digits than are needed";
    EXPECT_TRUE(passes(run_text(saw(saw_rope, weight, ""), {cut}))) << weight;
  }
}

/// A guyed mast that holds a line with a load.
std::string tower(double height, double pretension, double sag, const std::string& more) {
  return fmt::format(R"(taut: 1
machine:
  points:
    foot: [0 m, 0 m, 0 m]
    head: [0 m, 0 m, {} m]
    tail: [250 m, 0 m, 20 m]
    stump1: [-14 m, 9 m, 0 m]
    stump2: [-14 m, -9 m, 0 m]
  ropes:
    skyline: {{rope: "EN 12385-4|6x36-IWRC|18|1960", stiffness: 16 MN}}
    guy: {{rope: "EN 12385-4|6x36-IWRC|16|1960", stiffness: 13 MN}}
  beams: {{mast: {{from: foot, to: head, section: CHS 219.1x10, steel: S355, base: hinge}}}}
  carriages: {{car: {{mass: 250 kg, rides: skyline, hold: clamped}}}}
  reevings: [{{rope: skyline, path: [{{anchor: mast.top}}, {{through: car}}, {{anchor: tail}}], length: 253 m}}]
  guys:
    guy1: {{rope: guy, from: mast.top, to: stump1, install: {{tension: {} kN, at: top}}}}
    guy2: {{rope: guy, from: mast.top, to: stump2, install: {{tension: {} kN, at: top}}}}
  loads: [{{at: car, mass: 1 t}}]
analyses: [equilibrium: {{carriage: car, x: 120 m, given: {{reeving: skyline, sag: {} m}}}}]
checks:
  ropes: {{skyline: {{safety_factor: 3}}}}
  guys: {{guy: {{safety_factor: 3}}}}
  masts: {{mast: {{load_factor: 1.5, gamma_M1: 1.1}}}}
{})",
                     height, pretension, pretension, sag, more);
}

// Both guys are tightened alike: the pretension with the most reserve is better than its neighbours.
TEST(DesignUnknowns, pretension_has_the_most_reserve) {
  const Result r =
      run_text(tower(12, 12, 14,
                     "design: {seek: most_reserve, unknowns: {pretension: {parameter: "
                     "guys.guy1.install.tension, along_with: [guys.guy2.install.tension], from: 5 kN, to: 40 "
                     "kN}}}"));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  const double here = value_of(r, "design_pretension") / 1e3;
  const double least = worst_of(run_text(tower(12, here, 14, "")));
  EXPECT_NEAR(worst_of(r), least, 1e-9);
  for (const double x : {5.0, 8.0, 12.0, 15.0, 18.0, 22.0, 26.0, 30.0, 40.0, 0.98 * here, 1.02 * here}) {
    EXPECT_GE(worst_of(run_text(tower(12, x, 14, ""))), least - 2e-4) << x;
  }
}

// The sag that an analysis is given, and the height of the mast: the lowest and lightest mast, and the least sag that
// still passes, where the tension is sought least the deepest one.
TEST(DesignUnknowns, height_and_sag) {
  const std::string unknowns =
      "unknowns: {height: {parameter: points.head.z, from: 8 m, to: 14 m, steps: 1}, sag: {parameter: "
      "\"analyses[0].equilibrium.given.sag\", from: 6 m, to: 25 m, steps: 2}}";
  const Result light = run_text(tower(12, 15, 14, "design: {seek: lightest, " + unknowns + "}"));
  ASSERT_TRUE(passes(light)) << light.message << to_text(light.errors);
  EXPECT_NEAR(value_of(light, "design_height"), 8, 0.01);
  EXPECT_TRUE(passes(run_text(tower(value_of(light, "design_height"), 15, value_of(light, "design_sag"), ""))));
  const Result slack = run_text(tower(12, 15, 14, "design: {seek: least_tension, of: skyline, " + unknowns + "}"));
  ASSERT_TRUE(passes(slack)) << slack.message << to_text(slack.errors);
  EXPECT_NEAR(value_of(slack, "design_sag"), 25, 0.05);
  EXPECT_THAT(slack.warnings, testing::Contains(HasSubstr("sag is at an end of its range")));
  // a search that comes to the end from between may stop short of it, by its last step
  const Result between = run_text(tower(
      12, 15, 14,
      "design: {seek: lightest, unknowns: {height: {parameter: points.head.z, from: 8 m, to: 14 m, start: 11 m}}}"));
  ASSERT_TRUE(passes(between)) << between.message << to_text(between.errors);
  EXPECT_THAT(between.warnings, testing::Contains(HasSubstr("height is at an end of its range")));
}

/// A load in the middle of a level line of 100 m that bears 40 kN.
std::string level_line(const std::string& unknown) {
  return fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 30 m], b: [100 m, 0 m, 30 m]}}
  ropes: {{s: {{mass: 1 kg/m, stiffness: 20 MN, breaking_force: 120 kN}}}}
  carriages: {{car: {{mass: 100 kg, rides: s, hold: clamped}}}}
  reevings: [{{rope: s, path: [{{anchor: a}}, {{through: car}}, {{anchor: b}}], length: 102 m}}]
  loads: [{{at: car, mass: 1 t}}]
analyses: [equilibrium: {{carriage: car, x: 50 m}}]
checks: {{ropes: {{s: {{safety_factor: 3}}}}}}
design: {{seek: lightest, unknowns: {{it: {{{}}}}}}}
)",
                     unknown);
}

// At 40 kN an anchor bears half of 1100 kg and 101 kg, 5.889 kN, upright and 39.56 kN level. From the carriage to it
// the line rises by 5.642/39.56 on 50 m, is 50.506 m long and stretched by 39.95 kN / 20 MN: unstretched 2 * 50.405 m.
TEST(DesignUnknowns, the_lightest_line_is_the_shortest_that_passes) {
  const Result r = run_text(level_line("parameter: reevings.s.length, from: 100.5 m, to: 110 m, start: 105 m"));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "design_it"), 100.81, 0.01);
  EXPECT_NEAR(value_of(r, "design_cost"), 100.81, 0.01) << "1 kg/m";
  EXPECT_THAT(r.warnings, testing::Not(testing::Contains(HasSubstr("end of its range"))));
}

// The mass of the load is none of the machine: the least one is chosen for its reserve.
TEST(DesignUnknowns, what_changes_no_cost_is_chosen_for_the_reserve) {
  const Result r = run_text(level_line("parameter: loads.car.mass, from: 0.5 t, to: 1 t, start: 0.8 t"));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "design_it"), 500, 0.2);
  EXPECT_THAT(r.warnings, testing::Contains(HasSubstr("what is sought does not change with it")));
}

// The load cases are all kept: the one with twice the load decides, and the design passes each of them by itself.
TEST(DesignUnknowns, load_cases_all_pass) {
  const std::string weight = "unknowns: {sag: {parameter: \"analyses[0].equilibrium.given.sag\", from: 4 m, to: 25 m}}";
  const auto design = [&](const std::string& cases) {
    return run_text(tower(12, 15, 14, "design: {seek: smallest, " + cases + weight + "}"));
  };
  const Result r = design("cases: {empty: {loads.car.mass: 0.1 t}, full: {\"loads[0].mass\": 1800 kg}}, ");
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "design_cases");
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_EQ(text_cell(t, 0, "case"), "empty");
  EXPECT_GT(taut_test::cell(t, 1, "utilisation"), 0);
  EXPECT_TRUE(
      std::any_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.name.ends_with(" [full]"); }));
  const double sag = value_of(r, "design_sag");
  for (const char* load : {"machine.loads[0].mass=0.1 t", "machine.loads[0].mass=1800 kg"}) {
    EXPECT_TRUE(passes(run_text(tower(12, 15, sag, ""), {load}))) << load;
  }
}

/// A clamped carriage with logs in the middle of a line that is put up, by the key `install`; 600 kN.
std::string put_up_line(const std::string& install, const std::string& more) {
  return R"(taut: 1
machine:
  temperature: 15 degC
  points: {A: [0 m, 0 m, 60 m], B: [200 m, 0 m, 80 m]}
  ropes: {sky: {mass: 1.7 kg/m, stiffness: 20 MN, breaking_force: 600 kN, diameter: 20 mm, reference_temperature: 15 degC}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, length_before: 100 m}}
  reevings: [{rope: sky, path: [{anchor: A}, {through: car}, {anchor: B}], )" +
         install + R"(}]
  loads: [{at: car, mass: 0.5 t, name: logs}]
analyses: [equilibrium: {}]
checks: {ropes: {sky: {safety_factor: 1.1}}, confirmed: [elastic_limit]}
)" + more;
}

// The line is put up with its logs of 0.5 t at 15 degC. The cases have the length of that day.
TEST(DesignUnknowns, cases_keep_the_length_of_a_line) {
  const std::string install = "install: {tension: 60 kN, at: start, with: [car, logs]}";
  const std::string design = R"(design:
  seek: lightest
  unknowns: {m: {parameter: carriages.car.mass, from: 299.999 kg, to: 300 kg, start: 300 kg}}
  cases: {heavy: {loads.logs.mass: 5 t}, cold: {temperature: -20 degC}}
)";
  const Result r = run_text(put_up_line(install, design));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double cut = value_of(run_text(put_up_line(install, {})), "sky.unstretched");
  const std::string length = fmt::format("length: {:.17g} m", cut);
  const auto factor = [&](const std::string& set) {
    return value_of(run_text(put_up_line(length, {}), {set}), "sky.safety_factor");
  };
  EXPECT_NEAR(check_of(r, "sky.safety_factor [heavy]").value / factor("machine.loads.logs.mass=5 t"), 1, 1e-4);
  EXPECT_NEAR(check_of(r, "sky.safety_factor [cold]").value / factor("machine.temperature=-20 degC"), 1, 1e-4);
  EXPECT_LT(check_of(r, "sky.safety_factor [cold]").value, 9.98) << "10 as it is put up";
}

TEST(DesignUnknowns, mistakes) {
  const auto design = [](const std::string& words) {
    return run_text(saw(saw_rope, "1 t", "design: {" + words + "}"));
  };
  const std::string weight = "parameter: take_up.slide.weight, from: 0.1 t, to: 3 t";
  expect_mistake(design("unknowns: {w: {parameter: take_up.slid.weight, from: 1 t, to: 2 t}}"), "did you mean 'slide'");
  expect_mistake(design("unknowns: {w: {parameter: take_up.slide.weight, from: 1 kN, to: 2 t}}"), "unit of force");
  expect_mistake(design("unknowns: {w: {parameter: take_up.slide.weight, from: 1 t, to: 1000 kg}}"), "same as 'from'");
  expect_mistake(design("unknowns: {w: {parameter: take_up.slide.weight, from: -1 t, to: 1000 kg}}"), "must be");
  expect_mistake(design("unknowns: {w: {" + weight + ", start: 4 t}}"), "is not between");
  expect_mistake(design("unknowns: {w: {" + weight + ", along_with: [reevings.saw.length]}}"),
                 "no quantity of the same kind");
  expect_mistake(design("seek: cheapest, unknowns: {w: {" + weight + "}}"), "has a price");
  expect_mistake(design("seek: least_tension, of: sow, unknowns: {w: {" + weight + "}}"), "did you mean 'saw'");
  expect_mistake(design("of: saw, unknowns: {w: {" + weight + "}}"), "least_tension");
  expect_mistake(design("cases: {a: {take_up.slide.weight: 1 t}}, unknowns: {w: {" + weight + "}}"),
                 "is free by the unknown");
  expect_mistake(design("cases: {a: {bodies.slide.mass: 1 m}}, unknowns: {w: {" + weight + "}}"), "unit of length");
  expect_mistake(design("unknowns: {cost: {" + weight + "}}"), "give it another name");
}

// No weight is enough: the nearest is reported, in words and as exit code.
TEST(DesignUnknowns, impossible_limits) {
  const Result r = run_text(
      saw(saw_rope, "1 t", "design: {unknowns: {w: {parameter: take_up.slide.weight, from: 1 kg, to: 30 kg}}}"));
  EXPECT_EQ(exit_code(r), 3);
  EXPECT_THAT(r.message, HasSubstr("no choice passes all checks; the nearest, w = 30 kg, fails by"));
  ASSERT_FALSE(r.answers.empty());
  EXPECT_EQ(r.answers.front().label, "Nearest");
  EXPECT_THAT(r.answers.front().text, HasSubstr("w = 30 kg; fails by"));
}

// What is chosen is in the inputs with its value, and first on the page; the rest of the inputs is the deck's.
TEST(DesignUnknowns, what_is_chosen_is_marked_among_the_inputs) {
  const Result r = run_text(saw(saw_rope, "1 t", fmt::format("design: {{seek: lightest, {}}}", free_weight)));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  std::vector<std::string> chosen;
  for (const Given& g : r.given) {
    if (!g.chosen) continue;
    chosen.push_back(g.key);
    EXPECT_EQ(g.numbers, std::vector<double>{value_of(r, "design_weight")});
  }
  ASSERT_EQ(chosen.size(), 1U) << fmt::format("{}", fmt::join(chosen, ", "));
  EXPECT_THAT(chosen[0], HasSubstr("weight"));
  EXPECT_EQ(r.answers.front().label, "Build");
  EXPECT_THAT(r.answers.front().text, HasSubstr("weight = "));
}

TEST(DesignUnknowns, a_rope_that_is_chosen_is_named_in_full) {
  const Result r = run_text(
      saw("{}", "1 t", "design: {ropes: {saw: {construction: 6x36, core: IWRC, grade: 1960 MPa, modulus: 100 GPa}}}"));
  ASSERT_TRUE(passes(r)) << r.message << to_text(r.errors);
  const auto row =
      std::find_if(r.given.begin(), r.given.end(), [](const Given& g) { return g.key == "machine.ropes.saw.rope"; });
  ASSERT_NE(row, r.given.end());
  EXPECT_TRUE(row->chosen);
  EXPECT_EQ(row->text, text_cell(table_of(r, "design"), 0, "designation"));
  EXPECT_EQ(r.answers.front().label, "Build");
  EXPECT_THAT(r.answers.front().text, HasSubstr("saw EN 12385-4 6x36-IWRC "));
}

// Interrupted before anything passes, and after: then the best so far is there, marked as such.
TEST(DesignUnknowns, interrupted) {
  const auto run_until = [](int calls) {
    int made = 0;
    Job job{.text = saw(saw_rope, "1 t", fmt::format("design: {{{}}}", free_weight)),
            .name = "deck.yaml",
            .set = {},
            .progress = {}};
    job.progress = [&made, calls](const Progress& p) {
      EXPECT_EQ(p.what, "design");
      return ++made <= calls;
    };
    return run(job);
  };
  const Result none = run_until(0);
  EXPECT_TRUE(none.interrupted);
  EXPECT_EQ(exit_code(none), 130);
  EXPECT_THAT(none.message, HasSubstr("before any choice passed"));
  const Result some = run_until(12);
  EXPECT_EQ(exit_code(some), 130);
  EXPECT_THAT(some.message, HasSubstr("best design up to there"));
  EXPECT_FALSE(some.checks.empty());
}

/// A hoist of 12 t; its rope is free.
std::string hoist_of(const std::string& checks, const std::string& analyses, const std::string& design) {
  return fmt::format(R"(taut: 1
machine:
  temperature: 20 degC
  points: {{top: [-5 m, 0 m, 0 m]}}
  sheaves: {{head: {{at: [0 m, 0 m, 20 m], diameter: 900 mm, efficiency: 0.98}}}}
  bodies: {{hook: {{mass: 10 kg, at: [0.45 m, 0 m, 10 m], free: [x, z]}}}}
  ropes: {{r: {{}}}}
  reevings: [{{rope: r, path: [{{anchor: top}}, {{over: head}}, {{anchor: hook}}], length: 31 m}}]
  loads: [{{at: hook, mass: 12 t}}]
analyses: [{}]
checks: {{ropes: {{r: {{safety_factor: 4{}}}}}}}
design: {})",
                     analyses, checks, design);
}

/// A hinged mast on one guy, pushed at its top and at its middle; guys from a diameter on, sections of one diameter.
Result mast_and_guy(const char* least, const char* load_factor) {
  return run_text(fmt::format(R"(taut: 1
machine:
  points:
    foot: [0 m, 0 m, 0 m]
    head: [0 m, 0 m, 10 m]
    mid: {{body: mast, at: [0 m, 0 m, 5 m]}}
    stump: [-10 m, 0 m, 0 m]
  ropes: {{guy: {{}}}}
  beams: {{mast: {{from: foot, to: head, section: CHS 168.3x8, steel: S355}}}}
  guys: {{g: {{rope: guy, from: mast.top, to: stump, install: {{tension: 4 kN, at: top}}}}}}
  loads: [{{at: mast.top, force: [20 kN, 0 kN, 0 kN]}}, {{at: mid, force: [20 kN, 0 kN, 0 kN]}}]
analyses: [equilibrium: {{}}]
checks:
  guys: {{g: {{safety_factor: 2, check_pretension: false}}}}
  masts: {{mast: {{load_factor: {}}}}}
design:
  seek: lightest
  ropes: {{guy: {{construction: 6x36, core: IWRC, grade: 1960 MPa, least_diameter: {}, most_diameter: 40 mm}}}}
  sections: {{mast: {{shape: chs, forming: hot, standard: EN 10210, least_height: 168 mm, most_height: 169 mm}}}}
)",
                              load_factor, least));
}

// With thin guys every mast fails by far. That says nothing of it with a thick one.
TEST(DesignUnknowns, a_mast_that_fails_with_thin_guys_is_tried_with_thick_ones) {
  for (const char* load_factor : {"1.44", "1.217"}) {
    const Result all = mast_and_guy("12 mm", load_factor), thick = mast_and_guy("20 mm", load_factor);
    ASSERT_TRUE(passes(all)) << all.message << to_text(all.errors);
    ASSERT_TRUE(passes(thick)) << thick.message << to_text(thick.errors);
    EXPECT_NEAR(value_of(all, "design_cost"), value_of(thick, "design_cost"), 1e-9) << load_factor;
    EXPECT_THAT(all.warnings, testing::Not(testing::Contains(HasSubstr("set aside")))) << "all were tried";
  }
}

// Nobody knows the life of the compacted ropes of the catalogue, which have no grade.
TEST(DesignUnknowns, a_rope_without_the_life_that_is_asked_for_is_no_choice) {
  const auto chosen = [](const std::string& checks) {
    return run_text(hoist_of(checks, "{equilibrium: {}}", "{ropes: {r: {}}}"));
  };
  EXPECT_TRUE(passes(chosen("")));
  const Result lives = chosen(", running: runs, duty: [{name: w, cycles: 1e5}]");
  ASSERT_TRUE(passes(lives)) << lives.message << to_text(lives.errors);
  EXPECT_LE(check_of(lives, "r.life").utilisation, 1);
  EXPECT_FALSE(passes(chosen(", running: runs, duty: [{name: w, cycles: 2e6}]")));
}

TEST(DesignUnknowns, a_load_case_that_changes_nothing_is_a_mistake) {
  const auto mistakes = [](const std::string& analysis, const std::string& setting) {
    const std::string design = "{ropes: {r: {construction: 6x36, core: IWRC, grade: 1960 MPa}}, cases: {one: {" +
                               setting + "}, other: {loads.hook.mass: 10 t}}}";
    return to_text(run_text(hoist_of("", analysis, design)).errors);
  };
  const std::string sweep = "{sweep: {parameter: loads.hook.mass, from: 1 t, to: 2 t, steps: 2}}";
  EXPECT_THAT(mistakes(sweep, "loads.hook.mass: 8 t"), HasSubstr("every analysis sets this number anew"));
  EXPECT_THAT(mistakes("{envelope: {temperatures: [20 degC]}}", "temperature: -30 degC"),
              HasSubstr("sets this number anew"));
  const std::string sag = "{equilibrium: {given: {reeving: r, winch_pull: 120 kN}}}";
  EXPECT_THAT(mistakes(sag, "temperature: -30 degC"), HasSubstr("which is cut once"));
  EXPECT_EQ(mistakes("{equilibrium: {}}", "temperature: -30 degC"), "");
}

}  // namespace taut::app::design_unknowns_test
