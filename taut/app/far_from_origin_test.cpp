#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "test/support/machine_decks.hpp"

/// Machines in the coordinates of a national grid: the same as near the origin.
namespace taut::app::far_from_origin_test {

using namespace taut_test;

/// 500 kg on two ropes of 2 m and 3 m, whose stiffness makes a force of 4e-4 N of the smallest step of a place.
std::string hung(double x, double y, const std::string& analysis) {
  return fmt::format(R"(taut: 1
machine:
  points: {{p: [{} m, {} m, 20 m], q: [{} m, {} m, 20.5 m]}}
  ropes: {{r: {{mass: 1.8 kg/m, stiffness: 20 MN, breaking_force: 300 kN, damping_ratio: 0.05}}}}
  bodies: {{b: {{mass: 500 kg, at: [{} m, {} m, 19.9 m], free: [x, y, z]}}}}
  reevings:
    - {{rope: r, name: a, path: [{{anchor: p}}, {{anchor: b}}], length: 2.01 m}}
    - {{rope: r, name: c, path: [{{anchor: b}}, {{anchor: q}}], length: 3.075 m}}
  observe: [b.x, b.z, p.y]
analyses: [{}]
)",
                     x, y, x + 5, y, x + 2, y, analysis);
}

constexpr double x_far = 512345.5, y_far = -912345.25;

TEST(FarFromOrigin, AMachineComesToRest) {
  const char* rest = "equilibrium: {motion: at_rest}";
  const Result here = run_text(hung(0, 0, rest)), there = run_text(hung(x_far, y_far, rest));
  ASSERT_EQ(there.message, "");
  EXPECT_NEAR(value_of(there, "T_max"), value_of(here, "T_max"), 1e-8 * value_of(here, "T_max"));
  const Table &near = table_of(here, "bodies"), &far = table_of(there, "bodies");
  EXPECT_NEAR(cell(far, 0, "x") - x_far, cell(near, 0, "x"), 1e-9);
  EXPECT_NEAR(cell(far, 0, "y") - y_far, cell(near, 0, "y"), 1e-9);
  EXPECT_NEAR(cell(far, 0, "z"), cell(near, 0, "z"), 1e-9);
}

TEST(FarFromOrigin, AMachineMovesAndVibrates) {
  for (const char* branches : {"straight", "catenary"}) {
    const std::string motion = fmt::format("transient: {{duration: 0.5 s, branches: {}}}", branches);
    const Result here = run_text(hung(0, 0, motion)), there = run_text(hung(x_far, y_far, motion));
    ASSERT_EQ(there.message, "") << branches;
    EXPECT_NEAR(value_of(there, "T_max"), value_of(here, "T_max"), 1e-7 * value_of(here, "T_max"));
    EXPECT_NEAR(value_of(there, "b.x_max") - x_far, value_of(here, "b.x_max"), 1e-8);
    EXPECT_NEAR(value_of(there, "b.z_min"), value_of(here, "b.z_min"), 1e-8);
    EXPECT_NEAR(value_of(there, "p.y_max"), y_far, 1e-9);
  }
  const Result here = run_text(hung(0, 0, "modes: {count: 3}")),
               there = run_text(hung(x_far, y_far, "modes: {count: 3}"));
  ASSERT_EQ(there.message, "");
  for (std::size_t k = 0; k < 3; ++k) {
    const double frequency = cell(table_of(here, "modes"), k, "frequency");
    EXPECT_NEAR(cell(table_of(there, "modes"), k, "frequency"), frequency, 1e-6 * frequency);
  }
}

// Words name places as the deck does.
TEST(FarFromOrigin, AMessageNamesThePlaceOfTheDeck) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {p: [500000 m, 0 m, 50 m], q: [500100 m, 0 m, 50 m]}
  ropes: {r: {mass: 1.8 kg/m, stiffness: 20 MN, breaking_force: 300 kN}}
  carriages: {car: {mass: 300 kg, rides: r, hold: rolling, at: [500050 m, 0 m, 45 m]}}
  reevings: [{rope: r, path: [{anchor: p}, {through: car}, {anchor: q}], length: 101 m}]
analyses: [equilibrium: {motion: at_rest, carriage: car, x: 500150 m}]
)");
  EXPECT_NE(r.message.find("'car' is put at x = 500150 m, but its rope runs from x = 500000 m"), std::string::npos)
      << r.message << to_text(r.errors);
}

}  // namespace taut::app::far_from_origin_test
