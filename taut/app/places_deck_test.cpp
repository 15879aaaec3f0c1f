// Places by their height over the ground, as a deck has them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "test/support/machine_decks.hpp"

namespace taut::app::places_deck_test {

using taut_test::cell;
using taut_test::run_text;
using taut_test::table_of;

/// The skyline of machine_decks.hpp with this place of jack1, and this terrain.
std::string with_jack(const std::string& at, const std::string& analyses, const std::string& terrain = {}) {
  std::string text = taut_test::skyline_deck(analyses);
  const auto put = [&](const std::string& from, const std::string& to) {
    const auto found = text.find(from);
    EXPECT_NE(found, std::string::npos) << from;
    text.replace(found, from.size(), to);
  };
  put("at: [110 m, 0 m, 33 m]", "at: " + at);
  if (!terrain.empty()) {
    const auto from = text.find("terrain: {");
    text.replace(from, text.find('\n', from) - from, terrain);
  }
  return text;
}

constexpr const char* at_rest = "  - equilibrium: {carriage: car, x: 170 m}";

void expect_place(const Result& r, double x, double y, double z) {
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "places");
  ASSERT_EQ(t.rows.size(), 1U);
  EXPECT_EQ(taut_test::text_cell(t, 0, "part"), "support jack1");
  EXPECT_NEAR(cell(t, 0, "x"), x, 1e-9);
  EXPECT_NEAR(cell(t, 0, "y"), y, 1e-9);
  EXPECT_NEAR(cell(t, 0, "z"), z, 1e-9);
}

TEST(PlacesOverGround, AreThePlacesThatAVectorGives) {
  const Result vector = run_text(with_jack("[110 m, 0 m, 33 m]", at_rest));
  const Result over = run_text(with_jack("{chainage: 110 m, over_ground: 11 m}", at_rest));
  expect_place(over, 110, 0, 33);
  EXPECT_EQ(vector.find_table("places"), nullptr);
  for (const char* name : {"skyline.T_max", "mainline.T_max", "car.z"})
    EXPECT_EQ(taut_test::value_of(vector, name), taut_test::value_of(over, name)) << name;
}

TEST(PlacesOverGround, LeanAndOffsetAndOtherUnits) {
  // the ground at 55 m is at 9 m
  expect_place(run_text(with_jack("{chainage: 55 m, over_ground: 10 m, lean: 30 deg, offset: -0.5 m}", at_rest)), 60,
               -0.5, 9 + 10 * std::sqrt(0.75));
  expect_place(run_text(with_jack("{chainage: 55 м, over_ground: 1000 см, lean: -30 град}", at_rest)), 50, 0,
               9 + 10 * std::sqrt(0.75));
}

TEST(PlacesOverGround, OnASurveyFromAFile) {
  const auto file = std::filesystem::path(testing::TempDir()) / "places_deck_survey.csv";
  std::ofstream(file) << "x,y,z\n380,0,110\n0,-1,-4\n110,1,22\n-30,0,-6\n";
  expect_place(run_text(with_jack("{chainage: 55 m, over_ground: 10 m}", at_rest,
                                  fmt::format("terrain: {{file: {}, between: [stump, tower]}}", file.string()))),
               55, 0, 19);
  std::filesystem::remove(file);
}

TEST(PlacesOverGround, AreGivenAsTheDeckHasThem) {
  const Result r = run_text(with_jack("{chainage: 110 m, over_ground: 11 m}", at_rest));
  const auto given = [&](const std::string& key) {
    const auto found = std::find_if(r.given.begin(), r.given.end(), [&](const Given& g) { return g.key == key; });
    return found == r.given.end() ? std::vector<double>{} : found->numbers;
  };
  EXPECT_EQ(given("machine.supports.jack1.at.over_ground"), std::vector<double>{11});
  EXPECT_EQ(given("machine.supports.jack1.at"), std::vector<double>{});
  EXPECT_EQ(given("machine.supports.jack2.at"), (std::vector<double>{240, 0, 78}));
}

TEST(PlacesOverGround, AreSetAndSwept) {
  const std::string text = with_jack("{chainage: 110 m, over_ground: 11 m}", at_rest);
  expect_place(run_text(text, {"supports.jack1.at.over_ground=12 m"}), 110, 0, 34);
  expect_place(run_text(text, {"machine.supports.jack1.at.chainage=55 m"}), 55, 0, 20);
  const Result swept = run_text(with_jack(
      "{chainage: 110 m, over_ground: 11 m}",
      "  - sweep: {parameter: supports.jack1.at.over_ground, from: 8 m, to: 12 m, steps: 2, carriage: car, x: "
      "170 m}"));
  const Table& t = table_of(swept, "sweep");
  ASSERT_EQ(t.rows.size(), 3U);
  const Result last = run_text(text, {"supports.jack1.at.over_ground=12 m"});
  EXPECT_NEAR(cell(t, 2, "skyline.T_max") / taut_test::value_of(last, "skyline.T_max"), 1, 1e-9);
  taut_test::expect_mistake(run_text(with_jack("{chainage: 110 m, over_ground: 11 m}",
                                               "  - sweep: {parameter: supports.jack1.at.z, from: 8 m, to: 12 m}")),
                            "'z' is not a field there");
}

TEST(PlacesOverGround, AreFreeInADesign) {
  const Result r =
      run_text(with_jack("{chainage: 110 m, over_ground: 11 m}",
                         "  - load_path: {carriage: car, from: 150 m, to: 220 m, steps: 7}\n"
                         "checks: {ropes: {skyline: {safety_factor: 2}, mainline: {safety_factor: 2}}}\n"
                         "design:\n"
                         "  seek: most_reserve\n"
                         "  unknowns:\n"
                         "    height: {parameter: supports.jack1.at.over_ground, from: 6 m, to: 12 m, steps: 3}",
                         "terrain: {x: [0 m, 100 m, 110 m, 120 m, 360 m], z: [-60 m, -60 m, 22 m, -60 m, -60 m]}"),
               {"loads[0].mass=1 t"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(cell(table_of(r, "places"), 0, "z"), 22 + taut_test::value_of(r, "design_height"), 1e-9);
}

TEST(PlacesOverGround, WithoutGroundAreMistakesOfTheDeck) {
  const auto mistake = [](const std::string& at, const std::string& text, const std::string& terrain = {}) {
    taut_test::expect_mistake(run_text(with_jack(at, at_rest, terrain)), text);
  };
  mistake("{chainage: 400 m, over_ground: 9 m}", "there is no terrain at 400 m: it goes from 0 m to 360 m");
  mistake("{chainage: 400 m, over_ground: 9 m}", "deck.yaml:9:");
  mistake("{chainage: 110 m, over_ground: 9 m}", "needs the ground: give the machine a 'terrain'",
          "gravity: 9.81 m/s^2");
  mistake("{chainage: 110 m, over_ground: -9 m}", "over_ground: must be at least 0 m");
  mistake("{chainage: 110 m}", "lacks 'over_ground'");
  mistake("{chainage: 110 m, over_ground: 9 m, leans: 5 deg}", "'leans' is not a field of at; did you mean 'lean'?");
  mistake("{chainage: 110 m, over_ground: 9 m, lean: 90 deg}", "lean: must be above -90 deg and below 90 deg");
  mistake("9 m", "(or a map of chainage, offset, over_ground, lean)");
}

}  // namespace taut::app::places_deck_test
