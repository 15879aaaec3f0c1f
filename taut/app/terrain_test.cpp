#include "taut/app/terrain.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

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
    const auto off = [](const std::string& one) {
      return one.find("off the line of the terrain") != std::string::npos;
    };
    EXPECT_EQ(std::count_if(r.unmade.begin(), r.unmade.end(), off),
              std::count_if(r.warnings.begin(), r.warnings.end(), off))
        << "a clearance is asked";
    return all;
  };
  const std::string wrong = warned("x: [0 m, 0 m, 0 m], y: [0 m, 80 m, 200 m], z: [0 m, 20 m, 0 m]");
  EXPECT_NE(wrong.find("terrain: rope 'r' is 200 m off the line of the terrain in plan"), std::string::npos) << wrong;
  const std::string right = warned("x: [0 m, 80 m, 200 m], y: [0 m, 0 m, 0 m], z: [0 m, 10 m, 0 m]");
  EXPECT_EQ(right.find("off the line of the terrain"), std::string::npos) << "3 m: within the corridor\n" << right;
}

// A side force holds the carriage 13 m off the line, which was in the corridor as it was described.
TEST(Terrain, LooksAtTheCorridorInEachState) {
  const auto text = [](const std::string& asked) {
    return "taut: 1\nmachine:\n  points: {head: [0 m, 0 m, 40 m], tail: [200 m, 0 m, 40 m]}\n"
           "  ropes: {skyline: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
           "  carriages: {car: {mass: 300 kg, rides: skyline, hold: clamped}}\n"
           "  reevings: [{rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 201 m}]\n"
           "  loads: [{name: logs, at: car, force: [0 N, 30 kN, -10 kN]}]\n"
           "  terrain: {x: [0 m, 200 m], z: [0 m, 0 m]}\n" +
           asked;
  };
  const std::string safe = "checks: {ropes: {skyline: {safety_factor: 2}}";
  const std::string state = "analyses: [{equilibrium: {carriage: car, x: 100 m}}]\n";
  const Result plain = taut_test::run_text(text(state + safe + "}\n"));
  ASSERT_EQ(plain.unsafe.size(), 1U) << plain.message;
  EXPECT_NE(plain.unsafe[0].find("is 13.23 m off the line"), std::string::npos) << plain.unsafe[0];
  EXPECT_TRUE(plain.unmade.empty());
  const Result check = taut_test::run_text(text(state + safe + ", lines: {skyline: {least_clearance: 5 m}}}\n"));
  EXPECT_EQ(check.unmade.size(), 1U);
  const Result payload =
      taut_test::run_text(text("analyses: [{payload: {carriage: car, from: 90 m, to: 110 m, limits: {skyline: "
                               "{safety_factor: 2}, clearance: 5 m}}}]\n" +
                               safe + "}\n"));
  EXPECT_EQ(payload.unmade.size(), 1U);
  const Result wide = taut_test::run_text(text(state + safe + "}\n"), {"machine.terrain.corridor=14 m"});
  EXPECT_TRUE(wide.unsafe.empty());
}

/// A span of 640 m with a carriage at 300 kg, over ground with these corners from 306 m on.
std::string knoll(const std::string& x, const std::string& z, const std::string& asked) {
  return "taut: 1\nmachine:\n  points: {head: [0 m, 0 m, 60 m], tail: [640 m, 0 m, 60 m]}\n"
         "  ropes: {skyline: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
         "  carriages: {car: {mass: 300 kg, rides: skyline, hold: clamped}}\n"
         "  reevings: [{rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 642 m}]\n"
         "  terrain: {x: [0 m, 306 m, " +
         x + ", 640 m], z: [0 m, 0 m, " + z + ", 0 m]}\nanalyses: [" + asked + "]\n";
}

std::string carried(const std::string& from, const std::string& to, const char* steps) {
  return "{payload: {carriage: car, from: " + from + ", to: " + to + ", steps: " + steps +
         ", limits: {skyline: {safety_factor: 3}, clearance: 15.5 m}}}";
}

// A knoll of 10 m between the places 307.5 m and 320 m: 1.745 t passed where 0.482 t are carried. A broad hill whose
// top is between two places; one of many points, as a survey from the air has it.
TEST(Terrain, APayloadKnowsTheTopsBetweenItsPlaces) {
  std::string hill_x, hill_z;
  for (int i = 1; i < 80; ++i) {
    const double u = (i - 40) / 40.0;
    hill_x += fmt::format("{}{:.1f} m", i > 1 ? ", " : "", 306 + 0.5 * i);
    hill_z += fmt::format("{}{:.4f} m", i > 1 ? ", " : "", 12 * (1 - u * u));
  }
  const std::pair<std::string, std::string> grounds[] = {{"308 m, 312 m, 315 m, 319 m", "0 m, 10 m, 10 m, 0 m"},
                                                         {"326 m, 346 m", "12 m, 0 m"},
                                                         {hill_x + ", 346 m", hill_z + ", 0 m"}};
  for (const auto& [x, z] : grounds) {
    const Result coarse = taut_test::run_text(knoll(x, z, carried("20 m", "620 m", "48")));
    ASSERT_EQ(coarse.status, Status::ok) << coarse.message << to_text(coarse.errors);
    const Result fine = taut_test::run_text(knoll(x, z, carried("306 m", "347 m", "164")));
    const double least = taut_test::value_of(fine, "payload_min");
    EXPECT_NEAR(taut_test::value_of(coarse, "payload_min") / least, 1, 1e-3) << x;
    EXPECT_NEAR(taut_test::value_of(coarse, "clearance_min"), 15.5, 1e-6);
    const Table& t = taut_test::table_of(coarse, "payload");
    EXPECT_LE(t.rows.size(), 52U);
    for (std::size_t i = 1; i < t.rows.size(); ++i)
      EXPECT_LT(taut_test::cell(t, i - 1, "x"), taut_test::cell(t, i, "x"));
    const Result back = taut_test::run_text(knoll(x, z, carried("620 m", "20 m", "48")));
    EXPECT_NEAR(taut_test::value_of(back, "payload_min") / taut_test::value_of(coarse, "payload_min"), 1, 1e-6);
  }
}

// The load path: the peak of 29.5 m at 316 m between two places.
TEST(Terrain, ALoadPathKnowsTheTopsBetweenItsPlaces) {
  const char* path = "{load_path: {carriage: car, from: 20 m, to: 620 m, steps: 48}}";
  const Result r = taut_test::run_text(knoll("314 m, 316 m, 318 m", "0 m, 12 m, 0 m", path));
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const Result there =
      taut_test::run_text(knoll("314 m, 316 m, 318 m", "0 m, 12 m, 0 m", "{equilibrium: {carriage: car, x: 316 m}}"));
  EXPECT_NEAR(taut_test::value_of(r, "clearance_min"), taut_test::value_of(there, "clearance_min"), 1e-6);
  const Table& t = taut_test::table_of(r, "load_path");
  ASSERT_EQ(t.rows.size(), 50U);
  EXPECT_NEAR(taut_test::cell(t, 24, "x"), 316, 1e-9);
  const Result level = taut_test::run_text(knoll("320 m", "0 m", path));
  EXPECT_EQ(taut_test::table_of(level, "load_path").rows.size(), 49U) << "where no top is there is no other place";
}

/// A line over a support at 100 m, that stands on a ridge with a cliff beside it at 104 m.
std::string ridge(const std::string& asked) {
  return "taut: 1\nmachine:\n  points: {head: [0 m, 0 m, 30 m], tail: [200 m, 0 m, 30 m]}\n"
         "  ropes: {skyline: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}\n"
         "  supports: {saddle: {at: [100 m, 0 m, 40 m]}}\n"
         "  carriages: {car: {mass: 300 kg, rides: skyline, hold: clamped}}\n"
         "  reevings: [{rope: skyline, path: [{anchor: head}, {through: car}, {over: saddle}, {anchor: tail}], "
         "length: 202 m}]\n"
         "  terrain: {x: [0 m, 90 m, 100 m, 104 m, 105 m, 200 m], z: [0 m, 0 m, 25 m, 34 m, 0 m, 0 m]}\n"
         "analyses: [" +
         asked + "]\n";
}

// The places 95 m and 105 m are in two spans.
TEST(Terrain, ATopBetweenASupportAndTheNextPlaceIsAPlaceToo) {
  const auto there = taut_test::run_text(ridge("{equilibrium: {carriage: car, x: 104 m}}"));
  ASSERT_EQ(there.status, Status::ok) << there.message << to_text(there.errors);
  const double clearance = taut_test::value_of(there, "clearance_min");
  const Result path = taut_test::run_text(ridge("{load_path: {carriage: car, from: 15 m, to: 185 m, steps: 17}}"));
  EXPECT_NEAR(taut_test::value_of(path, "clearance_min"), clearance, 1e-6);
  EXPECT_EQ(taut_test::table_of(path, "load_path").rows.size(), 21U) << "two beside the support";
  const std::string limits = ", limits: {skyline: {safety_factor: 4}, clearance: 3 m}}}";
  const Result payload =
      taut_test::run_text(ridge("{payload: {carriage: car, from: 185 m, to: 15 m, steps: 17" + limits));
  const Result alone = taut_test::run_text(ridge("{payload: {carriage: car, from: 104 m, to: 104 m" + limits));
  EXPECT_NEAR(taut_test::value_of(payload, "payload_min"), taut_test::value_of(alone, "payload_min"), 1e-3);
  EXPECT_NEAR(taut_test::value_of(payload, "payload_min_x"), 104, 1e-9);
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
