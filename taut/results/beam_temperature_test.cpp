#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "test/support/machine_decks.hpp"

namespace beam_temperature_test {

using namespace taut_test;
using taut::Result;
using taut::Table;

/// A pole, 30 m, and a rope beside it that plays no part; `beam`, `rope`, `machine`: more keys of each.
std::string pole(const std::string& beam, const std::string& rope, const std::string& machine,
                 const std::string& more) {
  return fmt::format(
      "taut: 1\nmachine:\n{}  ropes: {{r: {{mass: 0.1 kg/m, stiffness: 20 MN{}}}}}\n  points: {{foot: [0 m, 0 m, 0 m], "
      "head: [0 m, 0 m, 30 m], a: [5 m, 0 m, 0 m], c: [55 m, 0 m, 0 m]}}\n  beams: {{mast: {{from: foot, to: head, "
      "section: CHS 323.9x10, mass: 0 kg/m{}}}}}\n  reevings: [{{rope: r, path: [{{anchor: a}}, {{anchor: c}}], "
      "length: "
      "50.1 m}}]\n{}",
      machine, rope, beam, more);
}

/// How much higher its top is than drawn, m.
double top_of(const std::string& deck) {
  const Result r = run_text(deck);
  return value_of(r, "mast.top.z") - 30;
}

// A forgotten e-6, and temperatures at which nothing is a rope any more.
TEST(BeamTemperature, WhatNoSolidDoesIsRefused) {
  const std::string warm = "  temperature: 60 degC\n";
  for (const auto& [beam, rope, machine, key] :
       {std::tuple("", ", expansion: 12 1/K", warm, "expansion"),
        std::tuple("", ", expansion: -0.001 1/K", warm, "expansion"),
        std::tuple("", ", reference_temperature: 1e300 degC", warm, "reference_temperature"),
        std::tuple(", expansion: 12 1/K", "", warm, "expansion"),
        std::tuple(", reference_temperature: 1e300 degC", "", warm, "reference_temperature"),
        std::tuple("", "", std::string("  temperature: 1e300 degC\n"), "temperature")}) {
    const Result r = run_text(pole(beam, rope, machine, ""));
    ASSERT_EQ(r.errors.size(), 1U) << beam << rope << machine;
    EXPECT_NE(r.errors[0].message.find(key), std::string::npos) << r.errors[0].message;
  }
  EXPECT_TRUE(run_text(pole("", ", expansion: -1.2e-5 1/K", warm, "")).errors.empty()) << "fibres of polyethylene";
}

// Steel, 12e-6 1/K: 30 m are 14.4 mm longer for 40 K.
TEST(BeamTemperature, ABeamIsLongerWhereItIsWarmer) {
  const std::string warm = "  temperature: 60 degC\n";
  EXPECT_NEAR(top_of(pole(", reference_temperature: 20 degC", "", warm, "")), 12e-6 * 40 * 30, 1e-9);
  EXPECT_NEAR(top_of(pole(", reference_temperature: 20 degC, expansion: 0 1/K", "", warm, "")), 0, 1e-9);
  EXPECT_NEAR(top_of(pole("", "", warm, "")), 0, 1e-9) << "built at the machine's temperature";
}

// Held at both ends it is pressed by EA a dT.
TEST(BeamTemperature, AHeldBeamIsPressed) {
  const Result r = run_text(
      "taut: 1\nmachine:\n  temperature: 30 degC\n  points: {foot: [0 m, 0 m, 0 m], head: {body: wall, at: [0 m, 0 m, "
      "0 "
      "m]}}\n  bodies: {wall: {mass: 0 kg, at: [0 m, 0 m, 4 m]}}\n  beams: {mast: {from: foot, to: head, A: 50 cm^2, "
      "I: "
      "5000 cm^4, E: 200 GPa, mass: 0 kg/m, reference_temperature: 20 degC}}\n");
  EXPECT_NEAR(value_of(r, "mast.N_base"), -200e9 * 50e-4 * 12e-6 * 10, 200);
}

/// A mast of 30 m with three guys that are put up with 30 kN; `mast`: more keys of it.
Result guyed(const std::string& machine, const std::string& mast, const std::string& analysis) {
  return run_text(fmt::format(
      R"(taut: 1
machine:
{}  ropes: {{guy: {{mass: 1.6 kg/m, stiffness: 20 MN}}}}
  points: {{foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 30 m], s1: [10 m, 0 m, 0 m], s2: [-5 m, 8.66 m, 0 m], s3: [-5 m, -8.66 m, 0 m]}}
  beams: {{mast: {{from: foot, to: head, section: CHS 323.9x10, base: hinge{}}}}}
  guys:
    g1: {{rope: guy, from: mast.top, to: s1, install: {{tension: 30 kN, at: top}}}}
    g2: {{rope: guy, from: mast.top, to: s2, install: {{tension: 30 kN, at: top}}}}
    g3: {{rope: guy, from: mast.top, to: s3, install: {{tension: 30 kN, at: top}}}}
analyses: [{}]
)",
      machine, mast, analysis));
}

// Mast and guys of steel grow alike, h and l by e h, e l; the ground does not: the guy would be l (1 + e) and reaches
// from its stake to the top over sqrt(r^2 + h^2 (1 + e)^2) = l (1 + e h^2/l^2), short of it by e r^2/l.
TEST(BeamTemperature, AGuyedMastKeepsItsTension) {
  const Result r =
      guyed("  temperature: 20 degC\n", "", "{sweep: {parameter: temperature, from: -20 degC, to: 60 degC, steps: 2}}");
  const Table& t = table_of(r, "sweep");
  ASSERT_EQ(t.rows.size(), 3U) << r.message << to_text(r.errors);
  const double slack = 12e-6 * 40 * 100 / 1000;  // of the length: e r^2/l^2
  for (const std::size_t i : {0U, 2U}) {
    const double change = cell(t, i, "g1.T_max") - cell(t, 1, "g1.T_max");
    EXPECT_NEAR(change, (i == 0 ? 1 : -1) * 20e6 * slack, 0.3 * 20e6 * slack) << i;  // the mast gives way a little
  }
}

// Put up with the same tension on a mast of the same temperature, whatever that is.
TEST(BeamTemperature, GuysArePutUpOnTheWarmMast) {
  const auto T = [](const char* temperature) {
    return value_of(
        guyed(fmt::format("  temperature: {}\n", temperature), ", reference_temperature: 20 degC", "equilibrium: {}"),
        "g1.T_max");
  };
  EXPECT_NEAR(T("60 degC"), T("20 degC"), 10);
}

TEST(BeamTemperature, ASweepNeedsToKnowAtWhichABeamIsAsLong) {
  const std::string sweep = "analyses: [{sweep: {parameter: temperature, from: 0 degC, to: 10 degC, steps: 1}}]\n";
  expect_mistake(run_text(pole("", ", reference_temperature: 20 degC", "", sweep)),
                 "beam 'mast' holds at no temperature");
}

}  // namespace beam_temperature_test
