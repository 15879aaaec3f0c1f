#include "taut/app/library/library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::library_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::has_check;
using taut_test::run_text;
using taut_test::table_of;
using taut_test::value_of;

/// A single span with a carriage; its keys, the load on it, analyses and checks.
struct Span {
  std::string carriage = "carriage: LARIX MOKO-25";
  std::string load = "1 t";
  std::string analyses = "  - equilibrium: {carriage: car, x: 50 m}\n";
  std::string checks = "";
};

std::string deck_of(const Span& span) {
  return "taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 30 m], block: [100 m, 0 m, 29 m]}\n"
         "  ropes:\n    skyline: {diameter: 18 mm, mass: 1.3 kg/m, stiffness: 15 MN, breaking_force: 250 kN}\n"
         "    mainline: {diameter: 10 mm, mass: 0.4 kg/m, stiffness: 5 MN, breaking_force: 80 kN}\n"
         "  carriages: {car: {rides: skyline, mainline: mainline, " +
         span.carriage +
         "}}\n  reevings:\n    - {rope: skyline, path: [{anchor: a}, {through: car}, {anchor: b}], length: 102.5 m}\n"
         "    - {rope: mainline, path: [{anchor: block}, {anchor: car}], length: 50 m}\n"
         "  loads: [{at: car, mass: " +
         span.load + "}]\nanalyses:\n" + span.analyses +
         "checks:\n  ropes: {skyline: {safety_factor: 1.5}, mainline: {safety_factor: 2}}\n" + span.checks;
}

TEST(Library, ACarriageTakesItsRow) {
  const Result r = run_text(deck_of({}));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Check& c = check_of(r, "car.payload");
  EXPECT_NEAR(c.value, 1000, 1e-6);
  EXPECT_EQ(c.limit, 2500);
  EXPECT_TRUE(c.passes);
  EXPECT_EQ(c.trust, "verified");
  EXPECT_TRUE(std::any_of(r.assumptions.begin(), r.assumptions.end(), [](const std::string& text) {
    return text.find("mass 560 kg, rated payload 2500 kg of 'LARIX MOKO-25'") != std::string::npos;
  }));
  // the same figures by hand: the same tensions
  const Result by_hand = run_text(deck_of({.carriage = "mass: 560 kg"}));
  EXPECT_EQ(value_of(r, "skyline.T_max"), value_of(by_hand, "skyline.T_max"));
  EXPECT_FALSE(has_check(by_hand, "car.payload"));
}

TEST(Library, TheDecksOwnFiguresStand) {
  const Result r = run_text(deck_of({.carriage = "carriage: LARIX MOKO-25, mass: 600 kg, rated_payload: 900 kg"}));
  EXPECT_FALSE(check_of(r, "car.payload").passes);
  EXPECT_EQ(check_of(r, "car.payload").trust, "user");
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::fails);
  EXPECT_EQ(value_of(r, "skyline.T_max"), value_of(run_text(deck_of({.carriage = "mass: 600 kg"})), "skyline.T_max"));
  EXPECT_TRUE(std::any_of(r.assumptions.begin(), r.assumptions.end(), [](const std::string& text) {
    return text.find("the deck's own: mass, rated_payload") != std::string::npos;
  }));
}

TEST(Library, AnUnverifiedRatingThatDecidesIsAWarning) {
  const Result r = run_text(deck_of({.carriage = "carriage: class 1.5 t", .load = "1.2 t"}));
  EXPECT_NE(check_of(r, "car.payload").trust.find("UNVERIFIED"), std::string::npos);
  EXPECT_TRUE(check_of(r, "car.most_rope").passes);
  EXPECT_TRUE(check_of(r, "car.least_rope").passes);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes_with_warnings) << verdict_of(r)->reason;
  const Result thick =
      run_text(deck_of({.carriage = "carriage: class 1.5 t"}), {"machine.ropes.skyline.diameter=20 mm"});
  EXPECT_FALSE(check_of(thick, "car.most_rope").passes);
}

TEST(Library, TheRatingLimitsAPayload) {
  const Span span{
      .load = "0 kg",
      .analyses = "  - payload: {carriage: car, from: 50 m, to: 50 m, limits: {skyline: {safety_factor: 1.01}}}\n"};
  const Result r = run_text(deck_of(span));
  const auto& t = table_of(r, "payload");
  EXPECT_NEAR(cell(t, 0, "payload"), 2500, 0.01);
  EXPECT_EQ(taut_test::text_cell(t, 0, "governing"), "rated payload of 'car'");
  EXPECT_TRUE(check_of(r, "car.payload").passes) << "it lies on its own limit";
  EXPECT_NEAR(check_of(r, "car.payload").value, 2500, 0.01);
  // what hangs on it already counts
  Span loaded = span;
  loaded.load = "400 kg";
  EXPECT_NEAR(cell(table_of(run_text(deck_of(loaded)), "payload"), 0, "payload"), 2100, 0.01);
}

class OwnTables : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder / "mine.csv")
        << "name,mass_kg,payload_kg,rollers,wheelbase_m,trust\nOWN,300,800,2,0.8,verified\n";
    std::ofstream(folder / "bad.csv") << "name,mass_kg,payload_kg,trust\nOWN,0.3,800,verified\n";
    std::ofstream(folder / "yarders.csv") << "yarder,drum,capacity_m,at_diameter_mm,pull_kN,hold_kN,trust\n"
                                             "OWN,skyline,100,20,40,90,verified\nOWN,mainline,80,10,20,,verified\n";
  }
  Result run(const Span& span) const {
    return app::run(Job{.text = deck_of(span), .name = (folder / "deck.yaml").string(), .set = {}, .progress = {}});
  }
  taut_test::ScratchFolder scratch;
  std::filesystem::path folder = scratch.path();
};

TEST_F(OwnTables, OfCarriages) {
  const Result r = run({.carriage = "carriage: own, catalogue: mine.csv"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_FALSE(check_of(r, "car.payload").passes);
  EXPECT_EQ(check_of(r, "car.payload").limit, 800);
  const Result by_hand = run({.carriage = "mass: 300 kg, rollers: 2, wheelbase: 0.8 m"});
  EXPECT_EQ(value_of(r, "skyline.T_max"), value_of(by_hand, "skyline.T_max"));
  // the deck's one roller needs no wheelbase
  const Result one = run({.carriage = "carriage: own, catalogue: mine.csv, rollers: 1"});
  EXPECT_EQ(value_of(one, "skyline.T_max"), value_of(run({.carriage = "mass: 300 kg"}), "skyline.T_max"));
}

TEST_F(OwnTables, Mistakes) {
  expect_mistake(run({.carriage = "carriage: MOKO"}), "no carriage 'MOKO'");
  expect_mistake(run({.carriage = "carriage: LARIX MOKO-52"}), "did you mean 'LARIX MOKO-25'");
  expect_mistake(run({.carriage = "carriage: OWN, catalogue: none.csv"}), "none.csv");
  expect_mistake(run({.carriage = "carriage: OWN, catalogue: bad.csv"}), "bad.csv:2:5: error");
  expect_mistake(run({.carriage = "mass: 1 kg, catalogue: mine.csv"}), "'carriage' says which one");
  expect_mistake(run({.carriage = "mass: 1 kg, rope_diameters: [20 mm, 16 mm]"}), "in this order");
  expect_mistake(run({.checks = "  yarders: {tower: {yarder: big, skyline: skyline}}\n"}), "no yarder 'big'");
  expect_mistake(run({.checks = "  yarders: {tower: {yarder: class 600 m}}\n"}), "say which lines are on it");
  expect_mistake(run({.checks = "  yarders: {tower: {yarder: class 600 m, skyline: sky}}\n"}), "no reeving 'sky'");
  expect_mistake(run({.checks = "  yarders: {tower: {yarder: OWN, catalogue: yarders.csv, haulback: mainline}}\n"}),
                 "has no haulback drum");
}

// By hand: 100 m of 20 mm are 100 (20/18)^2 = 123.46 m of 18 mm; 102.5 m in use and 10 m spare are 112.5 m. The
// mainline: 50 m, 10 m spare and 25 m to the side against 80 m.
TEST_F(OwnTables, OfYarders) {
  const std::string tower =
      "tower: {yarder: OWN, catalogue: yarders.csv, skyline: skyline, mainline: mainline, lateral: 25 m}";
  const Result r = run({.analyses = "  - equilibrium: {motion: at_rest}\n", .checks = "  yarders: {" + tower + "}\n"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Check& sky = check_of(r, "tower.skyline_length");
  EXPECT_NEAR(sky.value, 112.5, 1e-6);
  EXPECT_NEAR(sky.limit, 100.0 * 400 / 324, 1e-9);
  EXPECT_TRUE(sky.passes);
  const Check& main = check_of(r, "tower.mainline_length");
  EXPECT_NEAR(main.value, 85, 1e-6);
  EXPECT_EQ(main.limit, 80);
  EXPECT_FALSE(main.passes);
  EXPECT_EQ(check_of(r, "tower.skyline_pull").limit, 90e3) << "the brake";
  EXPECT_EQ(check_of(r, "tower.mainline_pull").limit, 20e3);
  EXPECT_EQ(table_of(r, "yarder_lines").rows.size(), 2U);
}

}  // namespace taut::app::library_test
