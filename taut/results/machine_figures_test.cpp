#include "taut/results/machine_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "test/support/machine_decks.hpp"

/// Which state the drawings of a machine show, and their numbers.
namespace taut::results::machine_figures_test {

using taut_test::run_text;
using testing::HasSubstr;

Drawing drawing(const Result& r, const std::string& name) {
  for (const Figure& f : r.figures) {
    if (const auto* d = std::get_if<Drawing>(&f); d != nullptr && d->name == name) return *d;
  }
  ADD_FAILURE() << "no drawing " << name << ": " << r.message << to_text(r.errors);
  return {};
}

ForceArrow arrow(const Drawing& d, const std::string& label) {
  for (const Shape& s : d.shapes) {
    if (const auto* a = std::get_if<ForceArrow>(&s); a != nullptr && a->label == label) return *a;
  }
  ADD_FAILURE() << "no arrow " << label;
  return {};
}

// A rope of 10 kN from (0, 0, 0) to (30, 40, 120) m: 3, 4, 12 of 13 parts.
TEST(MachineFigures, ANumberIsTheWholeForce) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {low: [0 m, 0 m, 0 m], high: [30 m, 40 m, 120 m]}
  ropes: {guy: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 100 kN}}
  reevings: [{rope: guy, path: [{anchor: low}, {anchor: high}], tension_at_start: 13 kN}]
)");
  const ForceArrow side = arrow(drawing(r, "machine"), "F low"), above = arrow(drawing(r, "plan"), "F low");
  EXPECT_NEAR(*side.whole, 13e3, 1);
  EXPECT_NEAR(*above.whole, 13e3, 1);
  EXPECT_NEAR(std::hypot(above.fx, above.fy), 5e3, 1);
  EXPECT_THAT(drawing(r, "plan").caption, HasSubstr("A number is the whole force"));
}

TEST(MachineFigures, TheStateThatDecidesIsDrawn) {
  const auto of = [](const std::string& analyses) {
    return drawing(run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 30 m], b: [200 m, 0 m, 30 m]}
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, at: [100 m, 0 m, 20 m]}}
  reevings: [{rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 203 m}]
  loads: [{at: car, mass: 2 t}]
analyses:
)" + analyses),
                   "machine")
        .caption;
  };
  const std::string aside = "  - equilibrium: {name: parked, carriage: car, x: 20 m", middle =
                                                                                          "  - equilibrium: {name: "
                                                                                          "middle, carriage: car, "
                                                                                          "x: 100 m";
  EXPECT_THAT(of(aside + "}\n" + middle + "}\n"), HasSubstr("strains its ropes most: Equilibrium, middle"));
  EXPECT_THAT(of(aside + ", judge: false}\n" + middle + "}\n"), HasSubstr("Equilibrium, middle"));
  EXPECT_THAT(of(aside + "}\n" + middle + ", judge: false}\n"), HasSubstr("Equilibrium, parked"));
}

// From one span to the next, or from a winch over a sheave to its load, the ends of a rope are no span apart.
TEST(MachineFigures, ASpanIsMeasuredOnlyOfARopeWithOneSpan) {
  const auto has_span =
      [](const std::string& path) {
        const Drawing d = drawing(run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 30 m], b: [200 m, 0 m, 25 m]}
  sheaves: {post: {at: [150 m, 0 m, 29 m], diameter: 400 mm}}
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, at: [100 m, 0 m, 20 m]}}
  reevings: [{rope: sky, path: )" + path + R"(, length: 203 m}]
analyses: [equilibrium: {carriage: car, x: 100 m}]
)"),
                                  "machine");
        return std::any_of(d.shapes.begin(), d.shapes.end(), [](const Shape& s) {
          const auto* line = std::get_if<DimensionLine>(&s);
          return line != nullptr && line->text == "span";
        });
      };
  EXPECT_TRUE(has_span("[{anchor: a}, {through: car}, {anchor: b}]"));
  EXPECT_FALSE(has_span("[{anchor: a}, {through: car}, {over: post}, {anchor: b}]"));
}

/// A load on two falls, 2 t at rest.
std::string hoist(const std::string& analyses) {
  return drawing(run_text(R"(taut: 1
machine:
  points: {pin: [0 m, 0 m, 10 m], low: [10 m, 0 m, 0 m]}
  ropes: {rope: {mass: 0 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}
  bodies: {hook: {mass: 10 kg, at: [0 m, 0 m, 5 m], free: [x, z]}}
  reevings:
    - {rope: rope, path: [{anchor: pin}, {anchor: hook}], length: 5 m}
  loads: [{at: hook, mass: 2 t}]
analyses:
  - equilibrium: {name: rest}
)" + analyses),
                 "machine")
      .caption;
}

// The largest tension of the deck is in the sweep, so that is what the words below the drawing may be said of.
TEST(MachineFigures, ASweepIsComparedToo) {
  EXPECT_THAT(hoist(""), testing::StartsWith("Equilibrium, rest"));
  EXPECT_THAT(
      hoist("  - sweep: {parameter: 'loads[0].mass', from: 1 t, to: 12 t, steps: 4}\n"),
      testing::AllOf(HasSubstr("The state that strains its ropes most: "), HasSubstr("loads[0].mass = 12000 kg")));
  EXPECT_THAT(hoist("  - sweep: {parameter: 'loads[0].mass', from: 1 t, to: 12 t, steps: 4, judge: false}\n"),
              testing::StartsWith("Equilibrium, rest"));
}

TEST(MachineFigures, AHarderStateThatIsNotDrawnIsNamed) {
  EXPECT_THAT(hoist("  - transient: {start: assembled, duration: 0.5 s, output_step: 10 ms}\n"),
              testing::AllOf(
                  testing::StartsWith("Equilibrium, "),
                  HasSubstr("Its ropes bear more in a state that is not drawn: largest tension of rope (transient")));
}

}  // namespace taut::results::machine_figures_test
