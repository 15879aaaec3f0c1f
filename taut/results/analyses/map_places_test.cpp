#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "test/support/machine_decks.hpp"

// Lines in the coordinates of a national grid: 2600 km east, 1200 km north (Switzerland), 5200 km north (UTM).
namespace map_places_test {

using namespace taut_test;
using taut::Column;
using taut::Result;
using taut::Table;

/// Where a line begins on the map, and its direction in plan.
struct OnMap {
  double east = 0, north = 0;
  std::array<double, 2> along = {1, 0};

  [[nodiscard]] double x(double s) const { return east * along[0] + north * along[1] + s; }
};

/// A line of two spans over a slope; places are `s` along it.
std::string line(const OnMap& map) {
  const auto at = [&](double s, double z) {
    return fmt::format("[{:.12g} m, {:.12g} m, {:.12g} m]", map.east + s * map.along[0], map.north + s * map.along[1],
                       z);
  };
  const auto way = [&](double from, double to) {
    return fmt::format("carriage: car, from: {:.12g} m, to: {:.12g} m, steps: 6, along: [{}, {}]", map.x(from),
                       map.x(to), map.along[0], map.along[1]);
  };
  const std::string along = fmt::format("[{}, {}]", map.along[0], map.along[1]);
  return fmt::format(R"(taut: 1
machine:
  points: {{a: {}, b: {}, winch: {}}}
  ropes: {{sky: {{rope: "EN 12385-4|6x36-IWRC|20|1960", stiffness: 20 MN}}, main: {{mass: 0.5 kg/m, stiffness: 6 MN, breaking_force: 90 kN}}}}
  supports: {{jack: {{at: {}, diameter: 400 mm, friction: 0.1}}}}
  carriages: {{car: {{mass: 350 kg, rides: sky, hold: rolling, mainline: main}}}}
  reevings:
    - {{rope: sky, path: [{{anchor: a}}, {{over: jack}}, {{through: car}}, {{anchor: b}}], install: {{tension: 45 kN, at: start}}}}
    - {{rope: main, path: [{{anchor: winch}}, {{anchor: car}}], length: 100 m}}
  loads: [{{at: car, mass: 600 kg}}]
  terrain: {{from: [{:.12g} m, {:.12g} m], along: {}, x: [-20 m, 100 m, 320 m], z: [-12 m, 40 m, 128 m]}}
analyses:
  - load_path: {{{}, motion: in}}
  - payload: {{{}, motion: in, limits: {{sky: {{safety_factor: 3}}, clearance: 1 m}}}}
  - cycle: {{{}, speed: 3 m/s, phases: [{{name: up, motion: in, load: 300 kg}}]}}
  - envelope: {{{}, loads: [0 t, 1 t], motions: [in, out]}}
  - sweep: {{parameter: 'carriages.car.mass', from: 300 kg, to: 400 kg, steps: 2, carriage: car, x: {:.12g} m, along: {}}}
  - equilibrium: {{carriage: car, x: {:.12g} m, along: {}}}
checks:
  ropes: {{sky: {{safety_factor: 2.5}}, main: {{safety_factor: 3}}}}
  lines: {{sky: {{break_angles: true, least_clearance: 1 m}}}}
  supports: {{jack: {{tree_diameter: 40 cm}}}}
  anchors: {{a: {{strength: 200 kN, angle: 30 deg}}, b: {{strength: 200 kN}}}}
)",
                     at(0, 10), at(300, 140), at(302, 139), at(100, 56), map.east, map.north, along, way(130, 270),
                     way(130, 270), way(150, 270), way(150, 270), map.x(200), along, map.x(200), along);
}

bool is_place(const std::string& name) {
  const auto ends = [&](const char* part) { return name == part || name.ends_with(std::string(".") + part); };
  return ends("x") || ends("y") || name.ends_with("_x") || name == "x_min" || name == "x_max";
}

/// To 1e-7: of what is larger than 1, else absolutely. Places differ by where the map counts from.
void expect_same(double here, double on_map, const std::string& name) {
  if (is_place(name) || (std::isnan(here) && std::isnan(on_map))) return;
  EXPECT_NEAR(here, on_map, 1e-7 * std::max(1.0, std::abs(here))) << name;
}

TEST(MapPlaces, ALineOnTheMapIsTheSameLine) {
  const Result here = run_text(line({}));
  ASSERT_EQ(here.status, taut::Status::ok) << here.message << to_text(here.errors);
  for (const OnMap& map :
       {OnMap{.east = 2600000, .north = 1200000}, OnMap{.east = 650000, .north = 5200000, .along = {0, 1}},
        OnMap{.east = 650000, .north = 5200000, .along = {0.6, 0.8}}}) {
    const Result r = run_text(line(map));
    ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
    EXPECT_NEAR(value_of(r, "payload_min_x"), map.x(value_of(here, "payload_min_x")), 1e-6);
    for (const taut::Value& v : here.values) expect_same(v.value, value_of(r, v.name), v.name);
    ASSERT_EQ(r.checks.size(), here.checks.size());
    for (const taut::Check& c : here.checks) {
      expect_same(c.value, check_of(r, c.name).value, c.name);
      EXPECT_EQ(c.passes, check_of(r, c.name).passes) << c.name;
    }
    for (const char* name : {"payload", "cycle", "cycle_work"}) {
      const Table &t = table_of(here, name), &other = table_of(r, name);
      ASSERT_EQ(t.rows.size(), other.rows.size()) << name;
      for (std::size_t i = 0; i < t.rows.size(); ++i) {
        for (const Column& c : t.columns) {
          // sideways forces turn with the line
          if (c.name.ends_with(".Fx") || c.name.ends_with(".Fy")) continue;
          expect_same(cell(t, i, c.name), cell(other, i, c.name), c.name);
        }
      }
    }
  }
}

TEST(MapPlaces, SentencesNameThePlaceToTheCentimetre) {
  std::string text = line({.east = 2600000, .north = 1200000});
  const std::string strong = "main: {safety_factor: 3}";
  text.replace(text.find(strong), strong.size(), "main: {safety_factor: 50}");
  const Result r = run_text(text);
  const taut::Check& c = check_of(r, "main.safety_factor");
  EXPECT_NE(c.rule.find("x = 2600"), std::string::npos) << c.rule;
  EXPECT_EQ(c.rule.find("e+06"), std::string::npos) << c.rule;
}

TEST(MapPlaces, WhatLiesBeyondTheEarthIsAMistake) {
  std::string text = line({});
  text.replace(text.find("from: 130 m"), 11, "from: 3e7 m");
  expect_mistake(run_text(text), "from: must be at least -2e7 m and at most 2e7 m, not 3e7 m");
}

}  // namespace map_places_test
