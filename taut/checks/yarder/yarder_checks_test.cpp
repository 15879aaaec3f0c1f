#include "taut/checks/yarder/yarder_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::checks::yarder_checks_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::has_check;
using taut_test::row_of;
using taut_test::run_text;
using taut_test::skyline_deck;
using taut_test::table_of;
using taut_test::value_of;

// By hand: 600 m of 18 mm: 600 (18/20)^2 = 486 m of 20 mm.
TEST(YarderChecks, CapacityBySquareOfTheDiameter) {
  catalogue::YarderDrum drum;
  drum.capacity = 600;
  drum.at_diameter = 0.018;
  EXPECT_DOUBLE_EQ(available_length(drum, 0.018), 600);
  EXPECT_NEAR(available_length(drum, 0.020), 486, 1e-9);
}

// By hand: core 400 mm, flanges 480 mm, 100 mm wide, rope 20 mm: 5 turns in a layer, 2 layers at radii 210 and 230 mm:
// 5 (hypot(2 pi 0.21, 0.02) + hypot(2 pi 0.23, 0.02)) = 13.82 m. Of 30 mm: 3 turns, 1 layer, radius 215 mm: 4.05 m.
TEST(YarderChecks, CapacityByTheMeasuresOfTheDrum) {
  catalogue::YarderDrum drum;
  drum.core = 0.4;
  drum.flange = 0.48;
  drum.face = 0.1;
  const double pi = std::numbers::pi;
  EXPECT_NEAR(available_length(drum, 0.02), 5 * (std::hypot(2 * pi * 0.21, 0.02) + std::hypot(2 * pi * 0.23, 0.02)),
              1e-9);
  EXPECT_NEAR(available_length(drum, 0.03), 3 * std::hypot(2 * pi * 0.215, 0.03), 1e-9);
  EXPECT_EQ(available_length(drum, 0.12), 0) << "no turn fits between the flanges";
}

std::string with_yarder(const std::string& keys,
                        const std::string& analyses = "  - equilibrium: {carriage: car, x: 170 m}") {
  return skyline_deck(analyses) + "checks:\n  yarders: {tower: {" + keys + "}}\n";
}
// with the sense of the skyline told: no band, so that tables and checks have the same states
const std::vector<std::string> diameters = {"machine.ropes.skyline.diameter=20 mm",
                                            "machine.ropes.mainline.diameter=11 mm",
                                            "machine.reevings[0].haul=to_start"};

TEST(YarderChecks, LengthsAndPullsOfALine) {
  const Result r =
      run_text(with_yarder("yarder: class 600 m, skyline: skyline, mainline: mainline, spare: 12 m, lateral: 30 m",
                           "  - load_path: {carriage: car, from: 135 m, to: 230 m, steps: 5, motion: in}"),
               diameters);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(check_of(r, "tower.skyline_length").value, 382 + 12, 1e-6);
  EXPECT_NEAR(check_of(r, "tower.skyline_length").limit, 600 * 324.0 / 400, 1e-9);
  const auto& t = table_of(r, "yarder_lines");
  const std::size_t main = row_of(t, "drum", "mainline");
  const auto& path = table_of(r, "load_path");
  double longest = 0;
  for (std::size_t i = 0; i < path.rows.size(); ++i) longest = std::max(longest, cell(path, i, "mainline.unstretched"));
  EXPECT_GT(longest, 192);
  EXPECT_NEAR(cell(t, main, "in_use"), longest, 1e-9);
  EXPECT_NEAR(check_of(r, "tower.mainline_length").value, cell(t, main, "in_use") + 42, 1e-9);
  EXPECT_NEAR(check_of(r, "tower.mainline_pull").value, value_of(r, "mainline.T_max"),
              0.02 * value_of(r, "mainline.T_max"));
  EXPECT_EQ(check_of(r, "tower.skyline_pull").limit, 120e3);
  EXPECT_NE(check_of(r, "tower.skyline_pull").trust.find("UNVERIFIED"), std::string::npos);
  EXPECT_FALSE(has_check(r, "tower.skyline_base_tension"));
}

TEST(YarderChecks, ALineThatIsPutUpNeedsThePullForIt) {
  std::string deck = with_yarder("yarder: class 600 m, skyline: skyline");
  deck.replace(deck.find("length: 382 m"), 13, "install: {tension: 95 kN, at: end}");
  const Result r = run_text(deck, diameters);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  // the larger end, as no drum of the machine says which one is at the yarder
  EXPECT_NEAR(check_of(r, "tower.skyline_base_tension").value, 95e3, 0.05 * 95e3);
  EXPECT_EQ(check_of(r, "tower.skyline_base_tension").limit, 90e3);
  EXPECT_FALSE(check_of(r, "tower.skyline_base_tension").passes);
}

TEST(YarderChecks, MistakesHaveTheirPlace) {
  expect_mistake(run_text(with_yarder("yarder: class 600 m, skyline: skyline")), "give its rope a 'diameter'");
}

// Two mainlines on one drum pull and need twice as much.
TEST(YarderChecks, AllCopiesOfALineAreOnItsDrum) {
  auto set = diameters;
  set.emplace_back("machine.reevings[1].copies=2");
  const Result r =
      run_text(with_yarder("yarder: class 600 m, skyline: skyline, mainline: mainline, spare: 12 m, lateral: 30 m",
                           "  - load_path: {carriage: car, from: 135 m, to: 230 m, steps: 2, motion: in}"),
               set);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto& path = table_of(r, "load_path");
  double longest = 0;
  for (std::size_t i = 0; i < path.rows.size(); ++i) longest = std::max(longest, cell(path, i, "mainline.unstretched"));
  EXPECT_NEAR(check_of(r, "tower.mainline_length").value, 2 * (longest + 42), 1e-9);
  EXPECT_NEAR(check_of(r, "tower.mainline_pull").value, 2 * value_of(r, "mainline.T_max"),
              0.04 * value_of(r, "mainline.T_max"));
}

}  // namespace taut::checks::yarder_checks_test
