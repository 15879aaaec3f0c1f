#include "taut/app/terrain.hpp"

#include <gtest/gtest.h>

#include "test/support/machine_decks.hpp"

namespace taut::app::terrain_test {

TEST(Terrain, ReadsTheColumnsThatItNeeds) {
  for (const char* text :
       {"x,z\n0,1\n2.5,-3\n", "\xEF\xBB\xBFname;z [m];x [m]\r\na;1;0\r\n# half way\r\nb;-3;2.5\r\n\r\n",
        "\"x_m\"\t\"z_m\"\n0\t1\n2.5\t-3"}) {
    machine::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(text, "p.csv", terrain, mistakes);
    EXPECT_TRUE(mistakes.empty()) << to_text(mistakes);
    EXPECT_EQ(terrain.x, (std::vector<double>{0, 2.5}));
    EXPECT_EQ(terrain.z, (std::vector<double>{1, -3}));
    EXPECT_TRUE(terrain.y.empty());
  }
}

TEST(Terrain, ReadsTheUnitThatAColumnNames) {
  machine::description::Terrain terrain;
  Diagnostics mistakes;
  read_terrain("chainage [ft],z (cm)\n0,100\n10,-300\n", "p.csv", terrain, mistakes);
  EXPECT_TRUE(mistakes.empty()) << to_text(mistakes);
  ASSERT_EQ(terrain.x.size(), 2U);
  EXPECT_DOUBLE_EQ(terrain.x[1], 3.048);
  EXPECT_DOUBLE_EQ(terrain.z[0], 1);
  EXPECT_DOUBLE_EQ(terrain.z[1], -3);
}

TEST(Terrain, KnowsTheColumnsByTheirNamesElseByTheirCount) {
  struct Row {
    const char* text;
    std::vector<double> x, y, z;
  };
  const std::vector<Row> rows = {
      {.text = "0,1\n2.5,-3\n", .x = {0, 2.5}, .y = {}, .z = {1, -3}},
      {.text = "chainage,z\n0,1\n2.5,-3\n", .x = {0, 2.5}, .y = {}, .z = {1, -3}},
      {.text = "Z;Station [m]\n1;0\n-3;2.5\n", .x = {0, 2.5}, .y = {}, .z = {1, -3}},
      {.text = "7,5,1\n2,8,-3\n", .x = {7, 2}, .y = {5, 8}, .z = {1, -3}},
      {.text = "z,x,point,y\n1,7,a,5\n-3,2,b,8\n", .x = {7, 2}, .y = {5, 8}, .z = {1, -3}},
  };
  for (const Row& row : rows) {
    machine::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(row.text, "p.csv", terrain, mistakes);
    EXPECT_TRUE(mistakes.empty()) << to_text(mistakes);
    EXPECT_EQ(terrain.x, row.x) << row.text;
    EXPECT_EQ(terrain.y, row.y) << row.text;
    EXPECT_EQ(terrain.z, row.z) << row.text;
  }
}

TEST(Terrain, TellsWhatIsWrongAtItsLine) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "p.csv:1:1: error: a ground profile has two points"},
      {"x,z\n1,2\n", "two points"},
      {"a,b\n1,2\n", "p.csv:1:1: error: the first line names the columns"},
      {"x [kg],z\n1,2\n", "the first line names the columns"},
      {"x [furlongs],z\n1,2\n", "the first line names the columns"},
      {"x,z\n1,2\n2\n3,1\n", "p.csv:3:1: error: the line has 1 cells"},
      {"x,z\n1,2\nb,3\n4,4\n", "p.csv:3:1: error: x: "},
      {"x,z\n1,2\n2,\n4,4\n", "p.csv:3:1: error: z: "},
      {"x,y,z\n1,2,3\n2,?,3\n4,4,4\n", "p.csv:3:1: error: y: "},
      {"1,2,3,4\n", "three are x, y and z"},
      {"x,z\n1,2\n1,3\n", "p.csv:3:1: error: x has to grow"},
  };
  for (const auto& [text, expected] : rows) {
    machine::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(text, "p.csv", terrain, mistakes);
    EXPECT_NE(to_text(mistakes).find(expected), std::string::npos) << text << "\n" << to_text(mistakes);
  }
}

TEST(Terrain, OfASurveyIsThatOfItsProfile) {
  const auto deck = [](const std::string& terrain) {
    std::string text = taut_test::skyline_deck("  - load_path: {carriage: car, from: 130 m, to: 220 m, steps: 9}");
    const auto at = text.find("terrain: {");
    return text.replace(at, text.find('\n', at) - at, "terrain: " + terrain);
  };
  const Result profile =
      taut_test::run_text(deck("{x: [0 m, 110 m, 170 m, 240 m, 360 m], z: [-4 m, 22 m, 34 m, 66 m, 106 m]}"));
  ASSERT_EQ(profile.status, Status::ok) << profile.message;
  // unordered, beside the line, seen from the tower
  for (const char* between : {"between: [stump, tower]", "between: [tower, stump]", "corridor: 8 m"}) {
    const Result survey = taut_test::run_text(deck(
        std::string("{x: [0 m, 240 m, 170 m, 110 m, 360 m], y: [0 m, -3 m, 1 m, 7 m, 0 m], z: [-4 m, 66 m, 34 m, 22 m, "
                    "106 m], ") +
        between + "}"));
    ASSERT_EQ(survey.status, Status::ok) << survey.message << to_text(survey.errors);
    EXPECT_NEAR(taut_test::value_of(survey, "clearance_min"), taut_test::value_of(profile, "clearance_min"), 1e-9);
    EXPECT_NEAR(taut_test::value_of(survey, "rope_clearance_min"), taut_test::value_of(profile, "rope_clearance_min"),
                1e-9);
    const auto off = std::count_if(survey.warnings.begin(), survey.warnings.end(), [](const std::string& w) {
      return w.starts_with(
          "terrain: 1 of the 5 rows of the survey is off the line by more than the corridor, row 4 the most, by 7 m");
    });
    EXPECT_EQ(off, between[0] == 'b' ? 1 : 0);
  }
}

/// A rope of 200 m along x, over a survey along the line of `rows`.
std::string across(const std::string& rows) {
  return "taut: 1\nmachine:\n  terrain: {" + rows +
         "}\n  points: {a: [0 m, 3 m, 30 m], b: [200 m, 3 m, 30 m]}\n"
         "  ropes: {r: {mass: 2 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
         "  carriages: {car: {mass: 500 kg, rides: r}}\n"
         "  reevings: [{rope: r, path: [{anchor: a}, {through: car}, {anchor: b}], length: 202 m}]\n"
         "analyses: [{equilibrium: {carriage: car, x: 100 m, held: true}}]\n"
         "checks: {ropes: {r: {safety_factor: 2}}, lines: {r: {least_clearance: 3 m}}}\n";
}

// A survey whose line runs along y has no ground under a rope along x: the end b is 200 m off it.
TEST(Terrain, WarnsOfARopeThatRunsFarFromItsLine) {
  const auto warned = [](const std::string& rows) {
    const Result r = taut_test::run_text(across(rows));
    EXPECT_NE(r.status, Status::bad_deck) << to_text(r.errors);
    std::string all;
    for (const std::string& one : r.warnings) all += one + "\n";
    return all;
  };
  const std::string wrong = warned("x: [0 m, 0 m, 0 m], y: [0 m, 80 m, 200 m], z: [0 m, 20 m, 0 m]");
  EXPECT_NE(wrong.find("terrain: rope 'r' is 200 m off the line of the terrain in plan"), std::string::npos) << wrong;
  const std::string right = warned("x: [0 m, 80 m, 200 m], y: [0 m, 0 m, 0 m], z: [0 m, 10 m, 0 m]");
  EXPECT_EQ(right.find("off the line of the terrain"), std::string::npos) << "3 m: within the corridor\n" << right;
}

// As a spreadsheet of a country with decimal commas writes it: "170,00;33,00" are two numbers.
TEST(Terrain, ADecimalCommaIsNoSeparator) {
  for (const char* text : {"x,z,note\n0,1,start\n50,2\n100,3,end\n", "x,z\n0,1,\n50,2,\n100,3,\n"}) {
    machine::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(text, "p.csv", terrain, mistakes);
    EXPECT_TRUE(mistakes.empty()) << to_text(mistakes);
    EXPECT_EQ(terrain.z, (std::vector<double>{1, 2, 3})) << text;
  }
  const auto mistakes_in = [](const char* text) {
    machine::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(text, "p.csv", terrain, mistakes);
    return to_text(mistakes);
  };
  EXPECT_NE(mistakes_in("x;z\n0,00;33,00\n170,00;34,50\n").find("a comma in a number"), std::string::npos);
  EXPECT_NE(mistakes_in("0;12,5\n10;13,5\n").find("the first line names the columns"), std::string::npos);
  EXPECT_NE(mistakes_in("x,z\n0,1\n2,5,3\n").find("p.csv:3:1: error: the line has 3 cells, the first one has 2"),
            std::string::npos);
}

}  // namespace taut::app::terrain_test
