#include <fmt/format.h>

#include <algorithm>

#include "taut/machine/description/machine.hpp"
#include "taut/study/deck/parameter.hpp"
#include "test/support/machine_decks.hpp"

namespace sweep_analysis_test {

using namespace taut_test;
using taut::Result;
using taut::Status;
using taut::Table;

std::string sweep_of(const std::string& parameter, const std::string& from, const std::string& to, int steps) {
  return skyline_deck(
      fmt::format("  - sweep: {{parameter: '{}', from: {}, to: {}, steps: {}, motion: in, carriage: car, x: 170 m}}",
                  parameter, from, to, steps));
}

TEST(SweepAnalysis, EachValueIsASingleRunAndBackIsTheSame) {
  struct Case {
    std::string parameter, unit;
    double from, to;
  };
  for (const Case& c : {Case{.parameter = "loads[0].mass", .unit = "kg", .from = 0, .to = 3000},
                        Case{.parameter = "loads.car.mass", .unit = "kg", .from = 0, .to = 3000},
                        Case{.parameter = "reevings.skyline.length", .unit = "m", .from = 384, .to = 379},
                        Case{.parameter = "machine.points.tower.z", .unit = "m", .from = 118, .to = 130},
                        Case{.parameter = "carriages.car.mass", .unit = "kg", .from = 200, .to = 900},
                        Case{.parameter = "supports.jack1.friction", .unit = "", .from = 0, .to = 0.3}}) {
    SCOPED_TRACE(c.parameter);
    const auto text = [&](double v) { return fmt::format("{:.17g} {}", v, c.unit); };
    const Result r = run_text(sweep_of(c.parameter, text(c.from), text(c.to), 3));
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    const Result back = run_text(sweep_of(c.parameter, text(c.to), text(c.from), 3));
    const Table &t = table_of(r, "sweep"), &u = table_of(back, "sweep");
    ASSERT_EQ(t.rows.size(), 4U);
    ASSERT_EQ(u.rows.size(), 4U);
    EXPECT_EQ(value_of(r, "sweep_end"), c.to);
    for (std::size_t i = 0; i < 4; ++i) {
      const double value = c.from + (c.to - c.from) * static_cast<double>(i) / 3;
      EXPECT_NEAR(cell(t, i, "value"), value, 1e-12 * std::abs(value));
      const Result one = run_text(skyline_deck("  - equilibrium: {carriage: car, x: 170 m, motion: in}"),
                                  {fmt::format("{}={}", c.parameter, text(value))});  // the same path
      ASSERT_EQ(one.status, Status::ok) << one.message << to_text(one.errors);
      for (const char* name : {"skyline.T_max", "mainline.T_start", "car.z", "skyline.T_end"}) {
        EXPECT_NEAR(cell(t, i, name) / value_of(one, name), 1, 1e-7) << name;
        EXPECT_NEAR(cell(u, 3 - i, name) / cell(t, i, name), 1, 1e-7) << name;
      }
    }
  }
}

/// Guys are put up anew where the body that they hold stands elsewhere, not where it is heavier.
TEST(SweepAnalysis, ABodyElsewhereIsGuyedAnew) {
  const auto deck = [](const std::string& analyses) {
    return R"(taut: 1
machine:
  ropes: {guy: {mass: 1.5 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
  bodies: {tower: {mass: 2.5 t, at: [0 m, 0 m, 16 m]}}
  points: {s1: [-22 m, 12 m, 1 m], s2: [-22 m, -12 m, -1 m], s3: [20 m, 0 m, 0 m]}
  guys:
    g1: {rope: guy, from: tower, to: s1, install: {tension: 30 kN, at: top}}
    g2: {rope: guy, from: tower, to: s2, install: {tension: 30 kN, at: top}}
    g3: {rope: guy, from: tower, to: s3, install: {tension: 30 kN, at: top}}
analyses:
)" + analyses;
  };
  for (const char* path : {"bodies.tower.at.z", "machine.bodies.tower.at[2]"}) {
    const Result r =
        run_text(deck(fmt::format("  - sweep: {{parameter: '{}', from: 16 m, to: 16.2 m, steps: 1}}", path)));
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    for (const std::size_t i : {0U, 1U}) {
      for (const char* guy : {"g1.T_max", "g2.T_max", "g3.T_max"}) {
        EXPECT_NEAR(cell(table_of(r, "sweep"), i, guy), 30e3, 1e-3) << path << ", " << guy;
      }
    }
  }
}

TEST(SweepAnalysis, TheTemperatureChangesWhatLiesAtAReference) {
  const Result r = run_text(sweep_of("temperature", "-25 degC", "35 degC", 2));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "sweep");
  for (std::size_t i = 0; i < 3; ++i) {
    const Result one = run_text(skyline_deck("  - equilibrium: {carriage: car, x: 170 m, motion: in}"),
                                {fmt::format("machine.temperature={:.17g} K", cell(t, i, "value")),
                                 "machine.ropes.skyline.reference_temperature=15 degC",
                                 "machine.ropes.mainline.reference_temperature=15 degC"});
    EXPECT_NEAR(cell(t, i, "skyline.T_max") / value_of(one, "skyline.T_max"), 1, 1e-8);
  }
}

TEST(SweepAnalysis, TheAngleOfALoadTurnsItsForce) {
  const std::string deck = R"(taut: 1
machine:
  points: {a: [-10 m, 0 m, 10 m], b: [10 m, 0 m, 10 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN}}
  bodies: {knot: {at: [0 m, 0 m, 0 m], free: [x, y, z]}}
  reevings:
    - {rope: r, name: left, path: [{anchor: a}, {anchor: knot}], length: 14 m}
    - {rope: r, name: right, path: [{anchor: b}, {anchor: knot}], length: 14 m}
  loads: [{at: knot, force: [0 N, 0 N, -30 kN]}]
analyses: [{sweep: {parameter: loads.knot.force.angle, from: -80 deg, to: -120 deg, steps: 8}}]
)";
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table& t = table_of(r, "sweep");
  ASSERT_EQ(t.rows.size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) {
    const double q = cell(t, i, "value");
    EXPECT_NEAR(q, (-80 - 5.0 * static_cast<double>(i)) * M_PI / 180, 1e-12);
    // the knot's balance along x and z from its place
    const double x = cell(t, i, "knot.x"), z = cell(t, i, "knot.z");
    const double l = std::hypot(x + 10, 10 - z), s = std::hypot(10 - x, 10 - z);
    const double T = cell(t, i, "left.T_end"), U = cell(t, i, "right.T_end");
    EXPECT_NEAR(T * (x + 10) / l - U * (10 - x) / s, 30e3 * std::cos(q), 1e-3);
    EXPECT_NEAR((T / l + U / s) * (10 - z), -30e3 * std::sin(q), 1e-3);
  }
}

TEST(SweepAnalysis, SaysWhereAndWhyItEnds) {
  const Result r =
      run_text(sweep_of("reevings.skyline.length", "384 m", "370 m", 7), {"machine.ropes.skyline.stiffness=.inf"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double end = value_of(r, "sweep_end");
  EXPECT_GT(end, 370);
  const auto told = [&](const std::string& text) {
    return std::any_of(r.warnings.begin(), r.warnings.end(),
                       [&](const std::string& one) { return one.find(text) != std::string::npos; });
  };
  EXPECT_TRUE(told("the sweep ends at reevings.skyline.length = "));
  const auto alone = [&](double length) {
    return run_text(
        skyline_deck("  - equilibrium: {carriage: car, x: 170 m, motion: in}"),
        {"machine.ropes.skyline.stiffness=.inf", fmt::format("machine.reevings[0].length={:.17g} m", length)});
  };
  EXPECT_NE(alone(end - 0.01).status, Status::ok);
  const Result negative = run_text(sweep_of("loads[0].mass", "1 t", "-1 t", 4));
  EXPECT_EQ(exit_code(negative), 2) << "the deck's own range";
}

TEST(SweepAnalysis, TellsEachMistakeAtItsPlace) {
  const auto deck = [](const std::string& parameter) { return sweep_of(parameter, "1 t", "2 t", 3); };
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"loads[3].mass", "'3' is not one of its 1 entries"},
      {"load[0].mass", "'load' is not a field there; did you mean 'loads'?"},
      {"loads[0]", "names a group of fields, not a number"},
      {"loads", "is a list: name an entry"},
      {"carriages.cra.mass", "'cra' is not among them; did you mean 'car'?"},
      {"points.tower", "is a vector: name a component"},
      {"points.tower.w", "'w' is not a component"},
      {"drums.winch.layer", "is a whole number"},
      {"reevings[0].rope", "is not a number"},
      {"reevings.skylin.length", "'skylin' is not an entry of the list; did you mean 'skyline'?"},
      {"loads[0].mass.x", "is beyond a number"},
      {"terrain.file.x", "is not a number"},
      {"reevings[0].length", "from: "},
      {"ropes.skyline.diameter", "has no value in the deck that could change"},
  };
  for (const auto& [parameter, expected] : rows) expect_mistake(run_text(deck(parameter)), expected);
  expect_mistake(run_text(sweep_of("loads[0].mass", "1 t", "1000 kg", 3)), "is the same value as 'from'");
  expect_mistake(run_text(sweep_of("loads[0].mass", "1", "2 t", 3)), "a mass needs its unit");
  expect_mistake(run_text(sweep_of("temperature", "0 degC", "20 degC", 3), {"machine={gravity: 9.81 m/s^2}"}), "");
}

// What the checks read of the machine itself counts at each value, as in a run of the deck that has it.
TEST(SweepAnalysis, EachValueIsJudgedAsADeckOfItsOwn) {
  const auto crane = [](const std::string& analysis, const std::vector<std::string>& set = {}) {
    return run_text(fmt::format(R"(taut: 1
machine:
  points: {{hook: {{body: load, at: [0 m, 0 m, 0 m]}}}}
  ropes: {{hoist: {{rope: "EN 12385-4|6x36-IWRC|20|1960"}}}}
  bodies: {{load: {{mass: 4 t, at: [0.2 m, 0 m, 1 m], free: [z]}}}}
  sheaves: {{head: {{at: [0 m, 0 m, 9 m], diameter: 400 mm, efficiency: 0.98}}}}
  drums: {{winch: {{at: [-6 m, 0 m, 0 m], core_diameter: 400 mm, face_width: 500 mm, length_on_drum: 20 m, layers: auto}}}}
  reevings: [{{rope: hoist, path: [{{drum: winch}}, {{over: head}}, {{anchor: hook}}], length: 18.6 m, haul: to_start}}]
analyses: [{}]
checks: {{ropes: {{hoist: {{field: crane_running, class: M4, drum: grooved, rated_pull: 60 kN}}}}}}
)",
                                analysis),
                    set);
  };
  for (const auto& [parameter, to] : std::vector<std::pair<std::string, std::string>>{
           {"sheaves.head.diameter", "150 mm"}, {"drums.winch.core_diameter", "200 mm"}}) {
    SCOPED_TRACE(parameter);
    const Result swept =
        crane(fmt::format("sweep: {{parameter: {}, from: 400 mm, to: {}, steps: 2, motion: in}}", parameter, to));
    ASSERT_EQ(swept.status, Status::ok) << swept.message << to_text(swept.errors);
    for (const std::string& value : {std::string("400 mm"), to}) {
      const Result one = crane("equilibrium: {motion: in}", {fmt::format("machine.{}={}", parameter, value)});
      ASSERT_FALSE(one.checks.empty()) << one.message << to_text(one.errors);
      for (const taut::Check& c : one.checks) {
        const taut::Check& worst = check_of(swept, c.name);
        EXPECT_TRUE(std::isnan(c.utilisation) || worst.utilisation >= c.utilisation * (1 - 1e-7)) << c.name;
        EXPECT_TRUE(c.passes || !worst.passes) << c.name;
      }
    }
    EXPECT_FALSE(check_of(swept, parameter.front() == 's' ? "hoist.sheave_ratio" : "hoist.drum_ratio").passes);
  }
}

}  // namespace sweep_analysis_test
