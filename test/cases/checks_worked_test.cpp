#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "test/support/machine_decks.hpp"

/// Every check of `checks:` against a number worked out on paper; its formula and source stand beside it. Life: by hand
/// in rope_life_test.cpp; masts: ec3_mast_test.cpp, cross_section_test.cpp, member_test.cpp.
namespace checks_worked_test {

using namespace taut_test;

constexpr double g = 9.80665;
constexpr double degree = std::numbers::pi / 180;

/// 3 t on one fall of a rope without weight, over a sheave of 400 mm onto a drum of as much: D/d = 25 at both, T =
/// 29419.95 N. EN 12385-4, 6x36 with a steel core: F_min = 0.356 x 16^2 x 1770 N = 161.3 kN, A = 0.460 x 16^2 =
/// 117.76 mm2.
std::string one_fall(const std::string& checks) {
  return R"(taut: 1
machine:
  ropes: {hoist: {rope: "EN 12385-4|6x36-IWRC|16|1770", mass: 0 kg/m, stiffness: 12 MN}}
  bodies: {load: {mass: 3 t, at: [0.2 m, 0 m, 5 m], free: [x, z]}}
  sheaves: {head: {at: [0 m, 0 m, 20 m], diameter: 400 mm}}
  drums: {winch: {at: [-8 m, 0 m, 2 m], core_diameter: 384 mm, face_width: 300 mm, flange_diameter: 600 mm, length_on_drum: 60 m, layers: auto}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: head}, {anchor: load}], length: 36 m}]
analyses: [equilibrium: {motion: hoist}]
checks: {ropes: {hoist: )" +
         checks + "}}\n";
}
constexpr double T = 3000 * g;
constexpr double F_min = 161300;

// ISO 4308-1: Z_p = F_min/S >= 4.5 for M5; D/d of M5 (recalled): sheaves 20, drums 18.
TEST(ChecksWorked, crane_rope_iso_4308) {
  const taut::Result r = run_text(one_fall("{field: crane_running, class: M5, termination: wedge_socket}"));
  EXPECT_NEAR(check_of(r, "hoist.safety_factor").value, 5.482674, 1e-5);
  EXPECT_EQ(check_of(r, "hoist.safety_factor").limit, 4.5);
  EXPECT_NEAR(check_of(r, "hoist.sheave_ratio").value, 25, 1e-9);
  EXPECT_NEAR(check_of(r, "hoist.drum_ratio").value, 25, 1e-9);
  EXPECT_GE(check_of(r, "hoist.sheave_ratio").limit, 20);   // the maker asks for more: 23
  EXPECT_EQ(check_of(r, "hoist.termination").value, 0.75);  // US Army TM 5-3810-305-10: 0.75 to 0.95
  EXPECT_EQ(check_of(r, "hoist.termination").limit, 0.8);
  const taut::Result even = run_text(one_fall("{field: crane_running, class: M5, compensating: [head]}"));
  EXPECT_NEAR(check_of(even, "hoist.compensating_ratio").value, 25, 1e-9);
  EXPECT_FALSE(has_check(even, "hoist.sheave_ratio"));
}

// EN 13001-2: phi_2 = 1.10 + 0.34 v_h of HC2 at 0.5 m/s is 1.27; handbooks of cable logging: peak at most 0.6 F_min.
TEST(ChecksWorked, dynamic_factor_and_elastic_limit) {
  const taut::Result r = run_text(one_fall("{hoist: {class: HC2, speed: 0.5 m/s}, dynamic_safety_factor: 3}"));
  EXPECT_NEAR(check_of(r, "hoist.elastic_limit").value, 37363.34, 0.01);
  EXPECT_NEAR(check_of(r, "hoist.elastic_limit").limit, 96780, 0.01);
  EXPECT_NEAR(check_of(r, "hoist.dynamic_safety_factor").value, 4.317066, 1e-5);
}

// Swiss practice, factor 3: 0.75 of the strength at the wedge, 1 - 0.5/sqrt(25) = 0.9 of it over the round.
TEST(ChecksWorked, weakest_place) {
  const taut::Result r = run_text(one_fall("{field: skyline.ch, termination: wedge_socket}"));
  EXPECT_NEAR(check_of(r, "hoist.termination").value, 4.112006, 1e-5);
  EXPECT_NEAR(check_of(r, "hoist.on_sheave").value, 4.934407, 1e-5);
  EXPECT_EQ(check_of(r, "hoist.on_sheave").limit, 3);
}

// EN 13001-3-2 as recalled: 25^0.8 = 13.1326, 1.35 + 5/9.1326 = 1.897 < 2.07; s_r = 1 x 5e5/5e5 = 1: F_u/7.
TEST(ChecksWorked, proofs_of_en_13001) {
  const taut::Result r = run_text(one_fall("{dynamic_factor: 1.27, en13001: {bends: 5e5, spectrum: 1, factor: 1}}"));
  EXPECT_NEAR(check_of(r, "hoist.resistance").value, 37363.34, 0.01);
  EXPECT_NEAR(check_of(r, "hoist.resistance").limit, 77922.7, 0.1);
  EXPECT_NEAR(check_of(r, "hoist.fatigue").limit, 23042.86, 0.01);
}

// p = 2 F/(d D) = 58839.9/(16 x 400 mm2); Shigley: T/A + E_r delta/D with delta = 0.0588 d: 249.830 + 194.510 MPa.
TEST(ChecksWorked, groove_and_wires) {
  const taut::Result r = run_text(one_fall("{groove: cast_steel}"));
  EXPECT_NEAR(check_of(r, "hoist.groove_pressure").value, 9.193734e6, 1);
  EXPECT_NEAR(check_of(r, "hoist.groove_pressure").limit, 7.41e6, 1);  // 1075 psi
  EXPECT_NEAR(check_of(r, "hoist.wire_stress").value, 444.340e6, 2e3);
  EXPECT_NEAR(check_of(r, "hoist.wire_stress").limit, 1770e6, 1);
}

// EN 12385-3 as recalled: 0.9 of the strength up to 200 degC, not hotter than 400; an aluminium ferrule up to 150.
TEST(ChecksWorked, hot_rope) {
  const taut::Result r = run_text(one_fall("{safety_factor: 4, temperature: 160 degC, termination: ferrule_eye}"));
  EXPECT_NEAR(check_of(r, "hoist.safety_factor").value, 0.9 * F_min / T, 1e-6);
  EXPECT_NEAR(check_of(r, "hoist.temperature").limit, 673.15, 1e-9);
  EXPECT_NEAR(check_of(r, "hoist.end_temperature").limit, 423.15, 1e-9);
  EXPECT_FALSE(check_of(r, "hoist.end_temperature").passes);
  const taut::Result cool = run_text(one_fall("{safety_factor: 4, temperature: 60 degC, termination: ferrule_eye}"));
  EXPECT_NEAR(check_of(cool, "hoist.safety_factor").value, F_min / T, 1e-6);
  EXPECT_TRUE(check_of(cool, "hoist.end_temperature").passes);
}

// 18 wraps of 16 mm on 300 mm: 22.6 m in the first layer, 47.0 m in two, so that 60 m lie in three, of 200 and 232 mm
// radius. Fleet angle: 142 mm aside on the tangent of drum and sheave, sqrt(8^2 + 18^2 - (0.232 - 0.2)^2) m.
TEST(ChecksWorked, drum) {
  const taut::Result r = run_text(one_fall("{drum: grooved, rated_pull: 35 kN}"));
  EXPECT_EQ(check_of(r, "hoist.drum_layers").value, 3);
  EXPECT_EQ(check_of(r, "hoist.drum_layers").limit, 3);
  EXPECT_NEAR(check_of(r, "hoist.last_layer_pull").value, T, 0.01);
  EXPECT_NEAR(check_of(r, "hoist.last_layer_pull").limit, 35e3 * 200 / 232, 0.01);
  EXPECT_NEAR(check_of(r, "hoist.fleet_angle").value, std::atan(0.142 / 19.69769), 1e-8);
  EXPECT_NEAR(check_of(r, "hoist.fleet_angle").limit, 2 * degree, 1e-12);
  EXPECT_NEAR(check_of(r, "winch.capacity").value, 60, 1e-9);
}

/// 10 kN upwards, held by two ropes at 45 degrees: T = 7071.07 N, 5 kN upwards at each foot.
std::string kite(const std::string& checks) {
  return R"(taut: 1
machine:
  points: {left: [-10 m, 0 m, 0 m], right: [10 m, 0 m, 0 m], eye: {body: kite, at: [0 m, 0 m, 0 m]}}
  ropes: {guy: {mass: 0 kg/m, stiffness: 1000 MN, breaking_force: 40 kN}}
  bodies: {kite: {mass: 0 kg, at: [0 m, 0 m, 10 m], free: [x, z]}}
  guys:
    a: {rope: guy, from: eye, to: left, length: 14.142 m}
    b: {rope: guy, from: right, to: eye, length: 14.142 m}
  loads: [{at: kite, force: [0 N, 0 N, 10 kN]}]
checks:
)" + checks;
}

TEST(ChecksWorked, guys_and_anchors) {
  const taut::Result r = run_text(kite(
      "  guys: {guy: {safety_factor: 3, dynamic_factor: 1.5}}\n"
      "  anchors: {left: {strength: 20 kN, safety_factor: 2, dynamic_factor: 1.5, as_strong_as_rope: true, uplift: 8 "
      "kN, angle: 50 deg, tree_diameter: 25 cm, ground_slope: 10 deg}, right: {}}\n"));
  const double pull = 10e3 / std::numbers::sqrt2;
  EXPECT_NEAR(check_of(r, "a.guy_safety").value, 40e3 / (1.5 * pull), 1e-3);
  EXPECT_NEAR(check_of(r, "left.anchor_strength").value, 20e3 / (1.5 * pull), 1e-3);
  EXPECT_NEAR(check_of(r, "left.anchor_uplift").value, 7500, 1);
  EXPECT_NEAR(check_of(r, "left.anchor_angle").value, 45 * degree, 1e-4);
  EXPECT_NEAR(check_of(r, "left.anchor_as_rope").limit, 40e3, 1e-6);
  // 10.6 kN at 35 deg above the ground: the first row of the table of anchor trees, 15 kN and 24 cm
  EXPECT_NEAR(check_of(r, "left.anchor_tree").limit, 0.24, 1e-12);
  const taut::Table& t = table_of(r, "anchor_forces");
  EXPECT_NEAR(cell(t, 1, "horizontal"), 5e3, 1);
  EXPECT_NEAR(cell(t, 1, "angle"), 45 * degree, 1e-4);
}

// A guy just as long as its chord of 30 m hangs with H^3 = EA (w L)^2/24: EA 15 MN, 1.2 kg/m: 4270.6 N.
TEST(ChecksWorked, slack_guy) {
  const taut::Result r = run_text(R"(taut: 1
machine:
  points: {post: [0 m, 0 m, 0 m], eye: {body: block, at: [0 m, 0 m, 0 m]}}
  ropes: {guy: {mass: 1.2 kg/m, stiffness: 15 MN, breaking_force: 200 kN}}
  bodies: {block: {mass: 10 kg, at: [30 m, 0 m, 0 m], free: [x]}}
  guys: {g: {rope: guy, from: post, to: eye, install: {tension: 20 kN, at: top}}}
  loads: [{at: block, force: [5 kN, 0 N, 0 N]}]
checks: {guys: {g: {safety_factor: 3}}}
)");
  const double w = 1.2 * g;
  EXPECT_NEAR(check_of(r, "g.slackness").limit, std::cbrt(15e6 * std::pow(w * 30, 2) / 24), 5);
  EXPECT_NEAR(check_of(r, "g.slackness").limit, 4270.6, 5);
  EXPECT_NEAR(check_of(r, "g.slackness").value, 5e3, 10);
  EXPECT_NEAR(check_of(r, "g.pretension_min").value, 0.1, 1e-12);  // 20 of 200 kN
  EXPECT_NEAR(check_of(r, "g.pretension_max").limit, 0.15, 1e-12);
}

// Straight ropes between points: angles of plain geometry. WAC 296-54-567: 50 and 8 degrees; SEILAPLAN: 30, 60, 3, 1.
TEST(ChecksWorked, line) {
  const auto deck = [](const std::string& rest) {
    return std::string(R"(taut: 1
machine:
  ropes: {skyline: {mass: 0 kg/m, stiffness: 30 MN, breaking_force: 400 kN}}
  points: {head: [0 m, 0 m, 30 m], stump: [330 m, 4.5 m, 10 m]}
  supports:
    jack: {at: [150 m, 0 m, 40 m], friction: 0}
    tree: {at: [300 m, 0 m, 35 m], friction: 0}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {over: jack}, {over: tree}, {anchor: stump}], tension_at_start: 100 kN}
checks: {lines: {skyline: {tail_tree: tree, break_angles: true, end_masts: [tree], spar_rating: 350 kN)") +
           rest + "}}}\n";
  };
  const taut::Result r = run_text(deck(""));
  EXPECT_NEAR(check_of(r, "skyline.tail_angle").value, std::atan(25 / std::hypot(30, 4.5)), 1e-6);
  EXPECT_NEAR(check_of(r, "skyline.tail_angle").limit, 50 * degree, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.anchor_off_line").value, std::atan(4.5 / 30), 1e-9);
  EXPECT_NEAR(check_of(r, "skyline.anchor_off_line").limit, 8 * degree, 1e-12);
  const double jack = std::atan(10.0 / 150) + std::atan(5.0 / 150);
  EXPECT_NEAR(check_of(r, "skyline.jack.break_angle").value, jack, 1e-9);
  EXPECT_NEAR(check_of(r, "skyline.jack.break_angle").limit, 30 * degree, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.tree.break_angle").limit, 60 * degree, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.jack.least_break_angle").value, jack, 1e-9);
  EXPECT_NEAR(check_of(r, "skyline.jack.least_break_angle").limit, 3 * degree, 1e-12);
  EXPECT_NEAR(check_of(run_text(deck(", hold_down: true")), "skyline.jack.least_break_angle").limit, degree, 1e-12);
  EXPECT_NEAR(check_of(r, "skyline.spar_rating").value, 400e3, 1e-6);
  EXPECT_FALSE(check_of(r, "skyline.spar_rating").passes);
  EXPECT_NEAR(check_of(run_text(deck(", limiter: 300 kN")), "skyline.limiter").value, 300e3, 1e-6);
}

}  // namespace checks_worked_test
