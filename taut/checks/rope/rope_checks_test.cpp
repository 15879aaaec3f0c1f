#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "taut/calc/verdict.hpp"
#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rope.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::rope_checks_test {

using taut_test::expect_mistake;
using taut_test::run_text;
using taut_test::skyline_deck;
using taut_test::value_of;
using testing::HasSubstr;

const Check* find(const Result& r, const std::string& name) {
  const auto at = std::find_if(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == name; });
  EXPECT_NE(at, r.checks.end()) << name << "; " << r.message << to_text(r.errors);
  return at == r.checks.end() ? nullptr : &*at;
}

bool has(const Result& r, const std::string& name) {
  return std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == name; });
}

/// A skyline with a load path, and these checks.
std::string checked(const std::string& checks) {
  return skyline_deck("  - load_path: {carriage: car, from: 130 m, to: 230 m, steps: 10, motion: in}\nchecks:\n" +
                      checks);
}

/// A ground that the mainline does not touch.
constexpr const char* low_ground = "machine.terrain.z=[-40 m, -40 m, -40 m, -40 m, -40 m]";

TEST(RopeChecks, swiss_skyline) {
  const Result r = run_text(checked("  ropes: {skyline: {field: skyline.ch, dynamic_factor: 1.2}}"));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  const Check* static_factor = find(r, "skyline.safety_factor");
  EXPECT_DOUBLE_EQ(static_factor->value, 280e3 / value_of(r, "skyline.T_max"));
  EXPECT_EQ(static_factor->limit, 3.0);
  EXPECT_EQ(static_factor->trust, "verified");
  EXPECT_EQ(static_factor->part, "skyline");
  const Check* elastic = find(r, "skyline.elastic_limit");
  EXPECT_DOUBLE_EQ(elastic->value, 1.2 * value_of(r, "skyline.T_max"));
  EXPECT_DOUBLE_EQ(elastic->limit, 0.60 * 280e3);
  EXPECT_THAT(elastic->trust, HasSubstr("UNVERIFIED"));
  EXPECT_FALSE(has(r, "skyline.sheave_ratio"));  // it does not run
}

TEST(RopeChecks, groups_by_part_worst_first) {
  const Result r =
      run_text(checked("  ropes: {skyline: {field: skyline.ch}, mainline: {field: mainline.ch_at}}"), {low_ground});
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < r.checks.size(); ++i) {
    if (parts.empty() || parts.back() != r.checks[i].part) parts.push_back(r.checks[i].part);
    if (i > 0 && r.checks[i].part == r.checks[i - 1].part) {
      EXPECT_LE(r.checks[i].utilisation, r.checks[i - 1].utilisation);
    }
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"skyline", "mainline"}));
}

// Of a range the safe end: 3 to 5 of a mainline.
TEST(RopeChecks, safe_end_of_a_range) {
  const Result r = run_text(checked("  ropes: {mainline: {field: mainline.ch_at}}"));
  EXPECT_EQ(find(r, "mainline.safety_factor")->limit, 5.0);
}

TEST(RopeChecks, unverified_numbers_can_be_refused) {
  const std::string block = "  refuse_unverified: true\n  ropes: {mainline: {field: mainline.ch_at, safety_factor: 3}}";
  const Result r = run_text(checked(block));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_EQ(exit_code(r), 4);
  EXPECT_FALSE(find(r, "mainline.safety_factor")->passes);
  EXPECT_TRUE(std::isnan(find(r, "mainline.safety_factor")->utilisation));
  EXPECT_TRUE(find(r, "mainline.safety_factor_2")->passes);  // the deck's own
  EXPECT_TRUE(find(r, "mainline.safety_factor")->refused);
  const Result own =
      run_text(checked("  refuse_unverified: true\n"
                       "  ropes: {mainline: {safety_factor: 3, elastic_limit: 0.6, sheave_weakening: covered}}"),
               {low_ground});
  EXPECT_EQ(exit_code(own), 0) << own.message;
}

TEST(RopeChecks, envelope_counts) {
  const std::string block =
      "  - equilibrium: {carriage: car, x: 130 m}\n"
      "  - envelope: {carriage: car, from: 130 m, to: 220 m, steps: 4, load_at: car, loads: [0 t, 2 t]}\n"
      "checks:\n  ropes: {skyline: {field: skyline.ch}}";
  const Result r = run_text(skyline_deck(block));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_NEAR(find(r, "skyline.safety_factor")->value, 280e3 / value_of(r, "skyline.T_max_envelope"), 1e-9);
}

TEST(RopeChecks, mistakes_have_their_place) {
  expect_mistake(run_text(checked("  ropes: {skylin: {field: skyline.ch}}")), "did you mean 'skyline'");
  expect_mistake(run_text(checked("  ropes: {skyline: {field: skyline.hc}}")), "there is no field of use 'skyline.hc'");
  expect_mistake(run_text(checked("  ropes: {skyline: {field: crane_running}}")), "needs a 'class'");
  expect_mistake(run_text(checked("  ropes: {skyline: {field: crane_running, class: M9}}")), "has no class 'M9'");
  expect_mistake(run_text(checked("  ropes: {skyline: {termination: wegde}}")), "there is no termination 'wegde'");
  expect_mistake(run_text(checked("  ropes: {skyline: {groove: cast_iron}}")), "give 'groove_pressure'");
  expect_mistake(run_text(checked("  ropes: {skyline: {felt: 1}}")), "'felt' is not a field");
  expect_mistake(run_text(checked("  ropes: {skyline: {rope: nonsense}}")), "nonsense");
  expect_mistake(run_text(checked("  ropes: {skyline: {dynamic_factor: 1.2, hoist: {class: HC2, speed: 1 m/s}}}")),
                 "either 'dynamic_factor' or 'hoist'");
  const Result placed = run_text(checked("  ropes: {skyline: {field: skyline.hc}}"));
  ASSERT_EQ(placed.errors.size(), 1U);
  EXPECT_EQ(placed.errors[0].place.line, 23);
}

/// A hoist rope of the catalogue over two sheaves from a drum.
std::string hoist_deck(const std::string& checks) {
  return R"(taut: 1
machine:
  points: {end: [2 m, 0 m, 20 m]}
  ropes: {hoist: {rope: "EN 12385-4|6x36-IWRC|16|1960", stiffness: 12 MN}}
  bodies: {block: {mass: 5 t, at: [1.8 m, 0 m, 5 m], free: [x, z]}}
  sheaves:
    head: {at: [1.4 m, 0 m, 20 m], diameter: 400 mm, efficiency: 0.98}
    hook: {body: block, at: [0 m, 0 m, 0 m], diameter: 320 mm, efficiency: 0.98}
  drums: {winch: {at: [-8 m, 0 m, 2 m], core_diameter: 300 mm, face_width: 500 mm, length_on_drum: 60 m, layers: auto}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: head}, {over: hook}, {anchor: end}], length: 52 m}]
analyses: [equilibrium: {motion: hoist}]
checks:
)" + checks +
         "\n";
}

TEST(RopeChecks, crane_class_sets_factor_and_ratios) {
  const Result r =
      run_text(hoist_deck("  ropes: {hoist: {field: crane_running, class: M5, hoist: {class: HC2, speed: 0.5 m/s}}}"));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  const Check* factor = find(r, "hoist.safety_factor");
  EXPECT_EQ(factor->limit, 4.5);
  // K d^2 R = 0.356 x 16^2 x 1960
  EXPECT_NEAR(factor->value, 178.6e3 / value_of(r, "hoist.T_max"), 1e-3);
  // the catalogue has d = 16: D/d 20 at the hook, but the maker of 6x36WS asks for 23
  EXPECT_NEAR(find(r, "hoist.sheave_ratio")->value, 20, 1e-12);
  EXPECT_EQ(find(r, "hoist.sheave_ratio")->limit, 23);
  EXPECT_FALSE(find(r, "hoist.sheave_ratio")->passes);
  EXPECT_NEAR(find(r, "hoist.drum_ratio")->value, 316.0 / 16, 1e-12);
  EXPECT_FALSE(has(r, "hoist.on_sheave"));
  EXPECT_NEAR(find(r, "hoist.elastic_limit")->value, (1.10 + 0.34 * 0.5) * value_of(r, "hoist.T_max"), 1e-6);
}

// What the machine says of its rope is not replaced by a row that the checks name.
TEST(RopeChecks, a_row_of_the_checks_fills_only_what_is_unknown) {
  const std::string row = "rope: \"EN 12385-4|6x36-IWRC|16|1960\"";
  const auto told = [&](const std::string& rope, const std::string& entry) {
    return run_text(hoist_deck("  ropes: {hoist: {safety_factor: 4, " + entry + "}}"), {"machine.ropes.hoist=" + rope});
  };
  const std::string weak = "{diameter: 16 mm, breaking_force: 60 kN, mass: 1 kg/m, stiffness: 13 MN}";
  EXPECT_NEAR(find(told(weak, row), "hoist.safety_factor")->value,
              find(told(weak, "dynamic_factor: 1"), "hoist.safety_factor")->value, 1e-9);
  expect_mistake(told("{diameter: 12 mm, breaking_force: 60 kN, mass: 0.6 kg/m, stiffness: 7 MN}", row),
                 "is a rope of 16 mm, and that of the machine has 12 mm");
  expect_mistake(told("{rope: \"EN 12385-4|6x36-FC|16|1960\", stiffness: 13 MN}", "core: IWRC"),
                 "the rope has the core FC");
}

TEST(RopeChecks, a_sheave_that_runs_does_not_compensate) {
  const Result r = run_text(hoist_deck("  ropes: {hoist: {field: crane_running, class: M3, compensating: [head]}}"));
  EXPECT_THAT(r.unmade, testing::Contains(HasSubstr("'head' does not compensate")));
}

TEST(RopeChecks, u_bolt_grips_and_saddles_are_nothing_for_a_crane) {
  const Result grips =
      run_text(hoist_deck("  ropes: {hoist: {field: crane_running, class: M3, termination: u_bolt_grips}}"));
  EXPECT_THAT(grips.unmade, testing::Contains(HasSubstr("not for lifting")));
  const Result clips = run_text(hoist_deck("  ropes: {hoist: {field: crane_running, class: M3, termination: clips}}"));
  EXPECT_THAT(clips.unmade, testing::Not(testing::Contains(HasSubstr("not for lifting"))));
  const std::vector<std::string> saddle = {
      "machine.sheaves.head={at: [1.4 m, 0 m, 20 m], diameter: 60 mm, law: saddle, friction: 0.1}"};
  const Result slides = run_text(hoist_deck("  ropes: {hoist: {field: crane_running, class: M3}}"), saddle);
  EXPECT_THAT(slides.unmade, testing::Contains(HasSubstr("slides over the saddle 'head'")));
}

// 'running: runs' asks for D/d: what of it has no number is not judged. By field nobody asks.
TEST(RopeChecks, a_rope_that_is_said_to_run_has_all_its_ratios_judged) {
  const auto unmade = [](const std::string& running, const std::string& head, const char* construction = "6x36-IWRC") {
    const std::string deck = hoist_deck(fmt::format("  ropes: {{hoist: {{safety_factor: 2{}}}}}", running));
    const Result r = run_text(
        deck, {fmt::format("machine.sheaves.head={{at: [1.4 m, 0 m, 20 m], {}efficiency: 0.98}}", head),
               "machine.sheaves.hook.diameter=400 mm", "machine.drums.winch.core_diameter=400 mm",
               fmt::format("machine.ropes.hoist={{rope: \"EN 12385-4|{}|16|1960\", stiffness: 12 MN}}", construction)});
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return r.unmade;
  };
  const std::string runs = ", running: runs", known = "diameter: 400 mm, ";
  EXPECT_TRUE(unmade(runs, known).empty());
  EXPECT_TRUE(unmade("", "").empty());
  EXPECT_THAT(unmade(runs, ""),
              testing::ElementsAre(HasSubstr("hoist: D/d is not checked: no diameter is known of 'head'")));
  EXPECT_THAT(unmade(runs, known, "6x7-FC"), testing::ElementsAre(HasSubstr("no rule is for its construction")));
}

// The calculation is written at the round that its check judges, not at that of the least D/d.
TEST(RopeChecks, the_calculation_is_that_of_the_check) {
  const Result r = run_text(
      hoist_deck("  ropes: {hoist: {field: crane_running, class: M3, groove: cast_steel, en13001: {bends: 1e5}}}"),
      {"machine.sheaves.head.efficiency=0.7"});
  const auto step = [&](const std::string& symbol) {
    const auto at = std::find_if(r.steps.begin(), r.steps.end(), [&](const Step& s) { return s.symbol == symbol; });
    EXPECT_NE(at, r.steps.end()) << symbol << r.message << to_text(r.errors);
    return at == r.steps.end() ? 0 : at->value;
  };
  EXPECT_NEAR(step("p"), find(r, "hoist.groove_pressure")->value, 1);
  EXPECT_NEAR(step("F_Rd"), find(r, "hoist.resistance")->limit, 1);
}

// A lighter rope whose construction no rule of D/d knows is no choice.
TEST(RopeChecks, a_design_does_not_take_what_no_rule_knows) {
  const auto design = [](const std::string& diameter, const std::string& mass) {
    return run_text(
        hoist_deck("  ropes: {hoist: {field: mainline.ch_at, termination: clips}}\n"
                   "design: {seek: lightest, ropes: {hoist: {}}}"),
        {"machine.ropes.hoist={}", "machine.bodies.block.mass=" + mass, "machine.sheaves.head.diameter=" + diameter,
         "machine.sheaves.hook.diameter=" + diameter, "machine.drums.winch.core_diameter=" + diameter});
  };
  // 6x37M-FC of 52 mm was the answer
  EXPECT_EQ(to_text(verdict_of(design("300 mm", "9 t"))->kind), "no_answer");
  const Result wide = design("900 mm", "2 t");
  ASSERT_EQ(exit_code(wide), 0) << wide.message << to_text(wide.errors);
  EXPECT_TRUE(has(wide, "hoist.sheave_ratio"));
}

// 0.6 F_min is a rule of skylines. An entry that asks for something else gives a hoist rope no limit of its strength.
TEST(RopeChecks, no_entry_without_a_limit_of_strength_judges_a_rope) {
  for (const char* entry : {"{}", "{diameter_ratio: 10}", "{temperature: 20 degC}", "{discard: true, drum: grooved}"}) {
    const Result r = run_text(hoist_deck(fmt::format("  ropes: {{hoist: {}}}", entry)));
    ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
    EXPECT_TRUE(find(r, "hoist.elastic_limit")->passes) << entry;
    EXPECT_THAT(r.unjudged, testing::Contains("hoist")) << entry;
  }
  const Result asked = run_text(hoist_deck("  ropes: {hoist: {dynamic_factor: 1.2}}"));
  EXPECT_TRUE(find(asked, "hoist.elastic_limit")->passes);
  EXPECT_THAT(asked.unjudged, testing::Contains("hoist"));
  const Result own = run_text(hoist_deck("  ropes: {hoist: {elastic_limit: 0.5}}"));
  EXPECT_THAT(own.unjudged, testing::Not(testing::Contains("hoist")));
}

TEST(RopeChecks, drum_and_groove) {
  const Result r = run_text(hoist_deck(
      "  ropes: {hoist: {field: crane_running, class: M3, drum: grooved, groove: cast_steel, rated_pull: 40 kN, "
      "termination: wedge}}"));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  // the rope to the head sheave lies in the drum's plane: half the face less the rope, over the free rope
  const double free = std::sqrt(9.4 * 9.4 + 18 * 18 - std::pow(0.2 - 0.174, 2));  // the sag takes 0.7 mm from it
  EXPECT_NEAR(find(r, "hoist.fleet_angle")->value, std::atan(0.242 / (free - 0.7e-3)), 1e-8);
  EXPECT_EQ(find(r, "hoist.drum_layers")->value, 2);  // 31 turns of 0.99 m in the first layer
  EXPECT_NEAR(find(r, "hoist.last_layer_pull")->limit, 40e3 * 0.158 / 0.174, 1e-6);
  EXPECT_NEAR(find(r, "hoist.groove_pressure")->limit, 7.41e6, 1);
  EXPECT_EQ(find(r, "hoist.termination")->limit, 0.8);
  EXPECT_EQ(find(r, "hoist.termination")->value, 0.75);
}

/// A head sheave of the given axis; the rope, without weight, comes from its drum at half the face beside the middle.
double fleet_angle_at(const std::string& axis) {
  std::string deck = hoist_deck("  ropes: {hoist: {field: crane_running, class: M3, drum: grooved}}");
  const std::string head = "head: {at: [1.4 m, 0 m, 20 m]", stiffness = "stiffness: 12 MN";
  deck.insert(deck.find(stiffness), "mass: 0 kg/m, ");
  deck.insert(deck.find(head) + head.size(), ", axis: " + axis);
  const Result r = run_text(deck);
  EXPECT_EQ(r.status, Status::ok) << to_text(r.errors);
  return find(r, "hoist.fleet_angle")->value;
}

TEST(RopeChecks, the_fleet_angle_is_that_of_the_sheave_where_it_is_larger) {
  const double flat = fleet_angle_at("[0, 1, 0]");
  const double centres = std::hypot(9.4, 18), length = std::hypot(std::sqrt(centres * centres - 0.026 * 0.026), 0.242);
  for (const double turned : {0.05, -0.05, 0.2}) {  // rad, about the vertical
    // from where the rope leaves the drum, 0.174 m behind its axis
    const double ahead = 9.4 + 0.174 * 18 / centres;
    const double out = ahead * std::sin(std::abs(turned)) + 0.242 * std::cos(turned);
    EXPECT_NEAR(fleet_angle_at(fmt::format("[{}, {}, 0]", std::sin(turned), std::cos(turned))), std::asin(out / length),
                1e-5);
  }
  EXPECT_NEAR(fleet_angle_at("[0, -1, 0]"), flat, 1e-12);
}

// A rope that crosses over between drum and sheave is free along the inner tangent only; one in the planes of a drum
// that lies and a sheave that lies flat is out of neither.
TEST(RopeChecks, the_fleet_angle_is_that_of_the_rope_as_it_runs) {
  const auto angle = [](const std::string& sheave, const std::string& end, const char* side) {
    const Result r = run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{r: {{diameter: 20 mm, mass: 0 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}}}
  sheaves: {{s: {{{}}}}}
  drums: {{w: {{at: [0 m, 0 m, 0 m], core_diameter: 580 mm, face_width: 120 mm}}}}
  points: {{e: {}}}
  reevings: [{{rope: r, path: [{{drum: w}}, {{over: s, side: {}}}, {{anchor: e}}], tension_at_end: 10 kN}}]
analyses: [equilibrium: {{}}]
checks: {{ropes: {{r: {{safety_factor: 4, fleet_angle: 2 deg}}}}}}
)",
                                          sheave, end, side));
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return find(r, "r.fleet_angle")->value;
  };
  const double free = std::sqrt(1.6 * 1.6 - 0.8 * 0.8);  // pitch radii of 0.3 m and 0.5 m
  EXPECT_NEAR(angle("at: [1.6 m, 0 m, 0 m], diameter: 1000 mm", "[1.6 m, 0 m, 5 m]", "left"), std::atan(0.05 / free),
              1e-9);
  const double outer = std::sqrt(1.6 * 1.6 - 0.2 * 0.2);
  EXPECT_NEAR(angle("at: [1.6 m, 0 m, 0 m], diameter: 1000 mm", "[1.6 m, 0 m, 5 m]", "right"), std::atan(0.05 / outer),
              1e-9);
}

/// A rope of 30 MN and 10 m that is drawn in from 10 kN to 15 kN.
double factor_of(const std::string& motion) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {line: {mass: 0 kg/m, stiffness: 30 MN, breaking_force: 60 kN, damping_ratio: 0.1}}
  points: {left: [0 m, 0 m, 0 m], right: [10 m, 0 m, 0 m]}
  signals: {in: {ramp: {to: -1.6667 mm, start: 0.1 s, duration: 1 s, smooth: true}}}
  reevings: [{rope: line, path: [{anchor: left}, {anchor: right}], length: 9.996667 m}]
  tensioners: [{reeving: line, end: start, change: in}]
checks: {ropes: {line: {safety_factor: 3}}}
analyses: [{transient: {tolerance: 1e-4, )" +
                            motion + "}}]\n");
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  return find(r, "line.safety_factor")->value;
}

TEST(RopeChecks, a_load_that_lasts_in_a_motion_counts_as_at_rest) {
  EXPECT_NEAR(factor_of("duration: 5 s"), 4, 0.01) << "3.9 s are too short to tell: it may stay";
  EXPECT_NEAR(factor_of("duration: 7 s"), 4, 0.01);
  EXPECT_NEAR(factor_of("duration: 7 s, output_step: 7 s"), 4, 0.01);
  EXPECT_NEAR(factor_of("duration: 2 s, output_step: 0.1 s, quasi_static: true"), 4, 0.01);
}

TEST(RopeChecks, of_a_method) {
  const std::string deck = R"(taut: 1
method: closed_loop
input:
  span: 250 m
  slope: 20 deg
  mode: sag
  sag: 12 m
  gathering_force: 15 kN
  gathering_angle: 30 deg
  tail_efficiency: 0.9
  return_rope: "EN 12385-4|6x36-IWRC|20|1770"
  traction_rope: "EN 12385-4|6x36-IWRC|20|1770"
checks:
  ropes: {return: {field: mainline.ch_at, termination: sleeve}, traction: {safety_factor: 3.5}}
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = taut_test::table_of(r, "ropes");
  EXPECT_NEAR(find(r, "return.safety_factor")->value, taut_test::cell(t, 0, "safety_factor"), 1e-12);
  EXPECT_NEAR(find(r, "return.termination")->value, 0.95 * taut_test::cell(t, 0, "safety_factor"), 1e-12);
  EXPECT_NEAR(find(r, "traction.safety_factor")->value, taut_test::cell(t, 1, "safety_factor"), 1e-12);
  std::string wrong = deck;
  wrong.replace(wrong.find("{return:"), 8, "{retorn:");
  expect_mistake(run_text(wrong), "the method has no rope 'retorn': return, traction");
}

// Steel loses strength in the heat: the value beside the check is that of the hot rope too.
TEST(RopeChecks, values_in_the_heat) {
  const Result r = run_text(checked("  ropes: {skyline: {field: skyline.ch, core: IWRC, temperature: 390 degC}}"));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_DOUBLE_EQ(value_of(r, "skyline.safety_factor"), find(r, "skyline.safety_factor")->value);
  EXPECT_LT(value_of(r, "skyline.safety_factor"), 0.7 * 280e3 / value_of(r, "skyline.T_max"));
  EXPECT_DOUBLE_EQ(value_of(r, "skyline.dynamic_safety_factor"), value_of(r, "skyline.safety_factor"));
}

// Two ropes on one drum fill it as one rope of twice the length: 158 m in layers of 20 turns on a core of 400 mm.
TEST(RopeChecks, all_ropes_of_a_drum_make_its_layers) {
  const auto layers = [](const std::string& length, int copies) {
    const Result r = run_text(fmt::format(R"(taut: 1
machine:
  ropes: {{w: {{diameter: 20 mm, mass: 0 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}}}
  sheaves: {{s1: {{at: [0 m, 0 m, 10 m], diameter: 800 mm}}}}
  bodies: {{load: {{mass: 4 t, at: [0.4 m, 0 m, 2 m], free: [x, z]}}}}
  drums: {{winch: {{at: [-10 m, 0 m, 0 m], core_diameter: 400 mm, face_width: 400 mm, flange_diameter: 900 mm,
                    length_on_drum: {}, layers: auto}}}}
  reevings: [{{rope: w, copies: {}, path: [{{drum: winch}}, {{over: s1}}, {{anchor: load}}], length: 20 m}}]
checks: {{ropes: {{w: {{safety_factor: 3, drum: grooved, fleet_angle: 5 deg}}}}}}
)",
                                          length, copies));
    return find(r, "w.drum_layers")->value;
  };
  // layer k: 20 turns of 2 pi (0.21 + 0.02 (k - 1)) m: 26.4, 28.9, 31.4, 33.9, 36.4 m
  EXPECT_EQ(layers("79 m", 1), 3);
  EXPECT_EQ(layers("79 m", 2), layers("158 m", 1));
  EXPECT_EQ(layers("79 m", 2), 6);
}

// The deck's own efficiency takes the place of a number: what the name says of heat and of lifting stays.
TEST(RopeChecks, an_efficiency_hides_no_limit_of_the_termination) {
  const auto ended = [](const std::string& end) {
    return run_text(hoist_deck(
        "  ropes: {hoist: {field: crane_running, class: M3, termination_efficiency: 0.85, termination: " + end + "}}"));
  };
  EXPECT_THAT(ended("u_bolt_grips").unmade, testing::Contains(HasSubstr("not for lifting")));
  EXPECT_FALSE(find(ended("ferrule, temperature: 180 degC"), "hoist.end_temperature")->passes);
  expect_mistake(ended("sokcet"), "did you mean 'socket'");
  const auto does_not_know = testing::Contains(HasSubstr("the tables do not have the termination 'aluminium sleeve'"));
  const Result cold = ended("aluminium sleeve"), hot = ended("aluminium sleeve, temperature: 180 degC");
  EXPECT_THAT(cold.unsafe, does_not_know);
  EXPECT_THAT(cold.unmade, testing::Not(does_not_know));
  EXPECT_THAT(hot.unmade, does_not_know);
  EXPECT_THAT(ended("socket").unsafe, testing::Not(testing::Contains(HasSubstr("termination"))));
}

// A drum's layers need the diameter of the rope that the machine winds, which `checks` can not give.
TEST(RopeChecks, what_a_drum_lacks_for_its_layers_is_named) {
  const auto lacks = [](const std::string& rope, const std::string& drum) {
    return run_text(hoist_deck("  ropes: {hoist: {safety_factor: 4, breaking_force: 178 kN, rated_pull: 60 kN" + rope +
                               "}}"),
                    {"machine.ropes.hoist={mass: 1 kg/m, stiffness: 12 MN}",
                     "machine.drums.winch={at: [-8 m, 0 m, 2 m], core_diameter: 300 mm" + drum + "}"})
        .unmade;
  };
  EXPECT_THAT(lacks(", diameter: 16 mm", ", face_width: 500 mm, length_on_drum: 60 m"),
              testing::ElementsAre(testing::EndsWith("the drum 'winch' needs the 'diameter' of its rope in 'ropes' of "
                                                     "the machine")));
  EXPECT_THAT(lacks("", ", face_width: 500 mm"),
              testing::Contains(HasSubstr("needs 'length_on_drum' and the 'diameter'")));
}

// As the methods and `checks` read it.
TEST(RopeChecks, ARopeOfTheMachineMayBeNamedByItsProperties) {
  const auto hang = [](const std::string& rope) {
    return taut_test::run_text(
        "taut: 1\nmachine:\n  points: {top: [0 m, 0 m, 10 m]}\n  ropes: {h: {rope: \"" + rope +
        "\"}}\n  bodies: {hook: {mass: 2 t, at: [0 m, 0 m, 2 m], free: [z]}}\n  reevings: [{rope: h, path: [{anchor: "
        "top}, {anchor: hook}], length: 8 m}]\nanalyses: [equilibrium: {}]\nchecks: {ropes: {h: {safety_factor: "
        "5}}}\n");
  };
  const Result by_id = hang("EN 12385-4|6x36-IWRC|16|1960"), in_words = hang("6x36-IWRC 16 mm 1960 MPa");
  ASSERT_EQ(in_words.status, Status::ok) << in_words.message << to_text(in_words.errors);
  ASSERT_EQ(by_id.values.size(), in_words.values.size());
  for (std::size_t k = 0; k < by_id.values.size(); ++k)
    EXPECT_EQ(by_id.values[k].value, in_words.values[k].value) << by_id.values[k].name;
  EXPECT_EQ(taut_test::check_of(by_id, "h.safety_factor").value,
            taut_test::check_of(in_words, "h.safety_factor").value);
  EXPECT_THAT(to_text(hang("6x36-IWRC 16.3 mm").errors), testing::HasSubstr("the nearest are"));
}

// D/d 20 at the hook and 19.75 at the drum: M6 asks 22.4 and 20, with the class in the field too.
TEST(RopeChecks, a_class_within_the_field_checks_the_ratios) {
  for (const char* field : {"field: crane_running.M6", "field: crane_running, class: m6"}) {
    const Result r = run_text(hoist_deck(fmt::format("  ropes: {{hoist: {{{}, discard: true}}}}", field)),
                              {"machine.ropes.hoist={rope: \"EN 12385-4|6x36-FC|16|1960\", stiffness: 12 MN}"});
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_FALSE(find(r, "hoist.sheave_ratio")->passes) << field;
    EXPECT_FALSE(find(r, "hoist.drum_ratio")->passes) << field;
    EXPECT_EQ(find(r, "hoist.drum_ratio")->limit, 20) << field;
    const Table& t = taut_test::table_of(r, "discard_hoist");
    EXPECT_THAT(std::get<std::string>(t.rows.at(0).at(4)), HasSubstr("class M6")) << field;
  }
  expect_mistake(run_text(hoist_deck("  ropes: {hoist: {field: crane_running.M5, class: M1}}")),
                 "'crane_running.M5' is of the class M5, and 'class' says M1");
}

// A drum and a saddle got the D/d of a compensating sheave, or none.
TEST(RopeChecks, only_a_sheave_compensates) {
  const std::string checks = "  ropes: {hoist: {field: crane_running, class: M3, compensating: ";
  expect_mistake(run_text(hoist_deck(checks + "winch}}")), "'winch' is a drum: name a sheave that stands");
  expect_mistake(
      run_text(hoist_deck(checks + "[hook, head]}}"),
               {"machine.sheaves.head={at: [1.4 m, 0 m, 20 m], diameter: 60 mm, law: saddle, friction: 0.1}"}),
      "'head' is a saddle");
  expect_mistake(run_text(hoist_deck(checks + "hed}}")), "no sheave 'hed' with a diameter; did you mean 'head'");
}

/// The hoist rope chosen; `checks` of it and `ropes` to choose from.
Result chosen(const std::string& checks, const std::string& ropes, std::vector<std::string> set = {}) {
  set.emplace_back("machine.ropes.hoist={}");
  return run_text(hoist_deck("  ropes: {hoist: {" + checks + "}}\ndesign: {seek: lightest, ropes: {hoist: {" + ropes +
                             ", standard: EN, grade: 1960 MPa}}}"),
                  set);
}

// 6x7-IWRC was the answer, judged by the rules of 6x36: every candidate is what its row says.
TEST(RopeChecks, a_design_judges_each_candidate_by_its_own_construction) {
  const std::vector<std::string> wide = {"machine.sheaves.head.diameter=600 mm", "machine.sheaves.hook.diameter=600 mm",
                                         "machine.drums.winch.core_diameter=600 mm"};
  const std::string use = "field: crane_running, class: M3, groove: manganese_steel";
  const Result denied = chosen(use + ", construction: 6x36", "construction: 6x7, core: IWRC", wide);
  EXPECT_EQ(to_text(verdict_of(denied)->kind), "no_answer") << denied.message << to_text(denied.errors);
  EXPECT_THAT(denied.message, HasSubstr("the rope has the construction 6x7"));
  const Result free = chosen(use + ", construction: 6x36", "core: IWRC", wide);
  ASSERT_EQ(exit_code(free), 0) << free.message << to_text(free.errors);
  const std::string designation = taut_test::text_cell(taut_test::table_of(free, "design"), 0, "designation");
  EXPECT_EQ(catalogue::construction_class(catalogue::find_rope(designation)->construction), "6x36") << designation;
  expect_mistake(chosen(use + ", rope: \"EN 12385-4|6x36-IWRC|16|1960\"", "core: IWRC", wide),
                 "'design' chooses this rope, and each candidate has the values of its row");
}

// 6x7-FC was the answer, with a remark that no rule of D/d is for it.
TEST(RopeChecks, a_design_by_an_own_factor_takes_no_rope_without_a_rule_of_its_ratios) {
  const Result r = chosen("safety_factor: 4", "construction: 6x7, core: FC");
  EXPECT_EQ(to_text(verdict_of(r)->kind), "no_answer");
  EXPECT_THAT(r.message, HasSubstr("no rule is for its construction"));
  EXPECT_EQ(exit_code(chosen("safety_factor: 4, running: stands", "construction: 6x7, core: FC")), 0);
  EXPECT_EQ(exit_code(chosen("safety_factor: 4, diameter_ratio: 10", "construction: 6x7, core: FC")), 0);
}

// A candidate is rejected by what can't be checked of it: its weakening on a sheave of no known diameter.
TEST(RopeChecks, a_design_takes_no_rope_over_a_sheave_without_diameter) {
  const std::vector<std::string> point = {"machine.sheaves.head.diameter=0 mm"};
  const Result r = chosen("field: crane_stay, class: M3, diameter_ratio: 10", "construction: 6x36, core: IWRC", point);
  EXPECT_EQ(to_text(verdict_of(r)->kind), "no_answer") << r.message;
  EXPECT_THAT(r.message, HasSubstr("no diameter is known of 'head'"));
}

// Above 400 degC nobody knows what is left of a steel rope: neither a factor nor the value beside it.
TEST(RopeChecks, a_rope_too_hot_for_the_tables_has_no_factor) {
  const Result r = run_text(checked("  ropes: {skyline: {field: skyline.ch, core: IWRC, temperature: 401 degC}}"));
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_FALSE(has(r, "skyline.safety_factor"));
  EXPECT_FALSE(find(r, "skyline.temperature")->passes);
  EXPECT_TRUE(std::isnan(value_of(r, "skyline.safety_factor")));
  EXPECT_TRUE(std::isnan(value_of(r, "skyline.dynamic_safety_factor")));
  EXPECT_THAT(r.unmade, testing::Contains(HasSubstr("no strength is known of a rope at 401 degC")));
}

}  // namespace taut::checks::rope_checks_test
