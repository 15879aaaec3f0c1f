#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/machine_decks.hpp"

namespace missing_test {

using namespace taut_test;
using taut::Status;

/// A level line of 101 m over 100 m with a carriage that rolls on it; `%A`: its analyses.
std::string level(const std::string& carriage, const std::string& analyses) {
  return R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m]}
  ropes: {line: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  carriages: {car: {mass: 200 kg, rides: line, hold: rolling)" +
         carriage + R"(}}
  reevings: [{rope: line, path: [{anchor: a}, {through: car}, {anchor: b}], length: 101 m}]
analyses:
)" + analyses +
         "\n";
}

bool warns(const taut::Result& r, const std::string& text) {
  return std::any_of(r.warnings.begin(), r.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

TEST(Missing, CarriageThatNothingHoldsHasNoPlace) {
  const auto r = run_text(level("", "  - load_path: {carriage: car, from: 5 m, to: 95 m, steps: 9}"));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.message.find("'car' stays at x = 5 m only by a force of"), std::string::npos) << r.message;
  EXPECT_NE(r.message.find("kN"), std::string::npos);
  EXPECT_NE(r.message.find("held: true"), std::string::npos);
}

TEST(Missing, WhereItStandsByItselfIsAPlaceAndTheRestIsCounted) {
  const auto r = run_text(level("", "  - load_path: {carriage: car, from: 10 m, to: 90 m, steps: 8}"));
  EXPECT_EQ(r.status, Status::ok) << r.message;
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].missing, 8);
  EXPECT_EQ(r.missing[0].places, 9);
  EXPECT_EQ(r.missing[0].first, "x = 10 m");
  EXPECT_TRUE(warns(r,
                    "no equilibrium at 8 of 9 places, x = 10 m to x = 40 m (4 states); x = 60 m to x = 90 m (4 "
                    "states); the first: 'car'"));
  const taut::Table& t = table_of(r, "load_path");
  ASSERT_EQ(t.rows.size(), 1U);
  EXPECT_NEAR(cell(t, 0, "x"), 50, 1e-9);
}

TEST(Missing, HeldCarriageHasAllPlacesInEveryAnalysis) {
  for (const std::string one :
       {"load_path: {carriage: car, from: 5 m, to: 95 m, steps: 3, held: true}",
        "envelope: {carriage: car, from: 5 m, to: 95 m, steps: 3, held: true}",
        "payload: {carriage: car, from: 5 m, to: 95 m, steps: 3, held: true, limits: {line: {safety_factor: 3}}}",
        "sweep: {parameter: carriages.car.mass, from: 100 kg, to: 200 kg, steps: 2, carriage: car, x: 9 m, held: true}",
        "equilibrium: {carriage: car, x: 30 m, held: true}"}) {
    const auto held = run_text(level("", "  - " + one));
    EXPECT_EQ(held.status, Status::ok) << one << held.message << to_text(held.errors);
    EXPECT_TRUE(held.missing.empty()) << one;
    std::string without = one;
    without.replace(without.find(", held: true"), 12, "");
    const auto r = run_text(level("", "  - " + without));
    EXPECT_EQ(r.status, Status::infeasible) << without;
    EXPECT_NE(r.message.find("only by a force"), std::string::npos) << r.message;
  }
}

TEST(Missing, PlacesBeyondTheReachOfAMainlineAreCountedInAPayloadAndACycle) {
  // pulled from the upper end: beyond the lowest point of the line it has to be pushed
  const std::string deck = R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m], high: [100 m, 0 m, 21 m]}
  ropes:
    line: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 100 kN}
    pull: {mass: 0 kg/m, stiffness: 2 MN, breaking_force: 50 kN}
  drums: {winch: {at: [100 m, 0 m, 21 m], core_diameter: 0 mm}}
  carriages: {car: {mass: 200 kg, rides: line, hold: rolling, mainline: pull}}
  reevings:
    - {rope: line, path: [{anchor: a}, {through: car}, {anchor: b}], length: 101 m}
    - {rope: pull, path: [{anchor: high}, {anchor: car}], length: 60 m}
analyses:
)";
  const auto path = run_text(deck + "  - load_path: {carriage: car, from: 20 m, to: 80 m, steps: 3}\n");
  EXPECT_EQ(path.status, Status::ok) << path.message << to_text(path.errors);
  ASSERT_EQ(path.missing.size(), 1U);
  EXPECT_EQ(path.missing[0].missing, 2);
  EXPECT_EQ(path.missing[0].places, 4);
  const auto cycle = run_text(
      deck + "  - cycle: {carriage: car, from: 80 m, to: 20 m, steps: 3, phases: [{name: out, motion: out}]}\n");
  EXPECT_EQ(cycle.status, Status::ok) << cycle.message << to_text(cycle.errors);
  ASSERT_EQ(cycle.missing.size(), 1U);
  EXPECT_EQ(cycle.find_value("cycle_energy"), nullptr);
  EXPECT_EQ(cycle.find_table("cycle_work"), nullptr) << "no work over a way with gaps";
  const auto loads = run_text(deck +
                              "  - payload: {carriage: car, from: 20 m, to: 80 m, steps: 3, limits: {line: "
                              "{safety_factor: 3}}}\n");
  EXPECT_EQ(loads.status, Status::ok) << loads.message << to_text(loads.errors);
  ASSERT_EQ(loads.missing.size(), 1U);
  EXPECT_EQ(table_of(loads, "payload").rows.size(), 4U);
}

}  // namespace missing_test
