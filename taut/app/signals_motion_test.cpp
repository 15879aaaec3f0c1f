#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "test/support/machine_decks.hpp"

/// What a motion makes of signals that are short, and of what statics alone keeps.
namespace taut::app::signals_motion_test {

using namespace taut_test;

/// 1 t on a rope, and a blow of 40 ms on it after 50 s of rest.
Result struck(const std::string& law, const std::string& options = "") {
  return run_text(R"(taut: 1
machine:
  signals: {hit: )" +
                  law + R"(}
  points: {top: [0 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 30 kN, damping_ratio: 0.02}}
  bodies: {m: {mass: 1 t, at: [0 m, 0 m, -10 m], free: [z]}}
  loads: [{at: m, force: [0 kN, 0 kN, -1 N], signal: hit}]
  reevings: [{rope: r, path: [{anchor: top}, {anchor: m}], length: 9.9 m}]
checks: {ropes: {r: {dynamic_safety_factor: 1}}}
analyses: [transient: {duration: 100 s)" +
                  options + "}]\n");
}

// The same triangle as a table, whose points every step meets; and a smooth peak, against a run in short steps.
TEST(SignalsInMotion, APulseOfAFormulaIsNotPassedBy) {
  const double by_table =
      value_of(struck("{table: {t: [0 s, 50.005 s, 50.025 s, 50.045 s], value: [0 kN, 0 kN, 60 kN, 0 kN]}}"), "T_max");
  EXPECT_GT(by_table, 20e3);
  const char* pulse = "{formula: \"max(0, 1 - abs(t - 50.025 s)/(0.02 s)) * 60 kN\"}";
  EXPECT_NEAR(value_of(struck(pulse), "T_max"), by_table, 1e-4 * by_table);
  const char* peak = "{formula: \"60 kN/(1 + ((t - 50.0251 s)/(0.004 s))^2)^2\"}";
  const double in_short_steps = value_of(struck(peak, ", step: 1 ms"), "T_max");
  EXPECT_GT(in_short_steps, 12e3);
  EXPECT_NEAR(value_of(struck(peak), "T_max"), in_short_steps, 3e-3 * in_short_steps);
}

/// 100 kg on a rope, and a signal that pulls it down.
Result pulled(const std::string& law, const std::string& motion) {
  return run_text(R"(taut: 1
machine:
  signals: {s: )" +
                  law + R"(}
  points: {p: [0 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 3 MN, breaking_force: 60 kN, damping_ratio: 0.1}}
  bodies: {b: {mass: 100 kg, at: [0 m, 0 m, -5 m], free: [z]}}
  loads: [{at: b, force: [0 kN, 0 kN, -1 N], signal: s}]
  reevings: [{rope: r, path: [{anchor: p}, {anchor: b}], length: 5 m}]
checks: {ropes: {r: {dynamic_safety_factor: 2}}}
analyses: [transient: {)" +
                  motion + "}]\n");
}

// Steps of half a period, each at the mean; and one step over the whole bulge of a spline.
TEST(SignalsInMotion, TheTopsOfASineAndOfASmoothTableAreSeenBetweenOutputs) {
  const double weight = 100 * 9.80665;
  const Result slow =
      pulled("{sine: {mean: 10 kN, amplitude: 5 kN, period: 2 s}}", "duration: 1000 s, quasi_static: true");
  EXPECT_NEAR(value_of(slow, "T_max"), 15e3 + weight, 1);
  const std::string table =
      "{table: {t: [0 s, 2 s, 22 s, 24 s], value: [10 kN, 14 kN, 14 kN, 10 kN], interpolation: cubic}}";
  const Result coarse = pulled(table, "duration: 60 s, output_step: 10 s");
  EXPECT_NEAR(value_of(coarse, "T_max"), value_of(pulled(table, "duration: 60 s, output_step: 0.1 s"), "T_max"), 1);
}

TEST(SignalsInMotion, ARopeByItsTensionKeepsItsLengthAndSaysSo) {
  const auto hung = [](const std::string& given) {
    return run_text(R"(taut: 1
machine:
  signals: {f: {ramp: {to: 5 kN, duration: 1 s, smooth: true}}}
  points: {p: [0 m, 0 m, 0 m], q: [10 m, 0 m, 0 m]}
  ropes: {r: {mass: 0.5 kg/m, stiffness: 5 MN, breaking_force: 100 kN, damping_ratio: 0.1}}
  bodies: {a: {mass: 300 kg, at: [5 m, 0 m, -1 m], free: [x, z]}}
  reevings:
    - {name: r1, rope: r, path: [{anchor: p}, {anchor: a}], )" +
                    given + R"(}
    - {name: r2, rope: r, path: [{anchor: a}, {anchor: q}], length: 5.1 m}
  loads: [{at: a, force: [0 kN, 0 kN, -1 N], signal: f}]
checks: {ropes: {r: {dynamic_safety_factor: 3}}}
analyses: [transient: {duration: 2 s}]
)");
  };
  const auto told = [](const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& words) {
      return words.find("'r1' keeps its length in motion; the 10 kN at its start") != std::string::npos;
    });
  };
  EXPECT_TRUE(told(hung("tension_at_start: 10 kN")));
  EXPECT_FALSE(told(hung("length: 5.1 m")));
}

TEST(SignalsInMotion, AGivenTensionThatAMachineWithContactsLosesAtRestIsTold) {
  const auto against = [](double length) {
    return run_text(fmt::format(R"(taut: 1
machine:
  points: {{p: [0 m, 0 m, 0 m], q: [5 m, 0 m, 0 m], tip: {{body: a, at: [0 m, 0 m, 0 m]}}}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 1 MN, breaking_force: 100 kN, damping_ratio: 0.1}}}}
  bodies: {{a: {{mass: 100 kg, at: [2 m, 0 m, 0 m], free: [x]}}}}
  faces: {{floor: {{from: [-9 m, 0 m, -1 m], to: [9 m, 0 m, -1 m], normal: [0, 0, 1]}}}}
  contacts: [{{point: tip, face: floor, stiffness: 1 MN/m, damping: 1 kN s/m}}]
  reevings:
    - {{name: r1, rope: r, path: [{{anchor: p}}, {{anchor: tip}}], tension_at_start: 5 kN}}
    - {{name: r2, rope: r, path: [{{anchor: tip}}, {{anchor: q}}], length: {} m}}
checks: {{ropes: {{r: {{dynamic_safety_factor: 3}}}}}}
analyses: [transient: {{duration: 0.1 s}}]
)",
                                length));
  };
  const auto told = [](const Result& r) {
    return std::any_of(r.unsafe.begin(), r.unsafe.end(), [](const std::string& words) {
      return words.find("'r1' has 8.054 kN at its start where the motion begins, not 5 kN") != std::string::npos;
    });
  };
  // by hand: N = (5 - 2/1.005 - 2.97)/((2/1.005 + 2.97)/EA) = 8.054 kN
  const Result stretched = against(2.97);
  EXPECT_NEAR(value_of(stretched, "r1.T_max"), (5 - 2 / 1.005 - 2.97) / (2 / 1.005 + 2.97) * 1e6, 1);
  EXPECT_TRUE(told(stretched));
  EXPECT_TRUE(against(3 / 1.005).unsafe.empty());
}

/// 0.5 t on a rope of 34.6 rad/s, at its resonance.
Result in_given_steps(const std::string& step, const std::string& frequency = "5.51328895 Hz") {
  return run_text(R"(taut: 1
machine:
  signals: {s: {sine: {mean: 30 kN, amplitude: 0.5 kN, frequency: )" +
                  frequency + R"(}}}
  points: {p: [0 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 3 MN, breaking_force: 400 kN}}
  bodies: {b: {mass: 500 kg, at: [0 m, 0 m, -5.00817 m], free: [z]}}
  loads: [{at: b, force: [0 kN, 0 kN, -30 kN], signal: s}]
  reevings: [{rope: r, path: [{anchor: p}, {anchor: b}], length: 5 m, may_slack: true}]
checks: {ropes: {r: {dynamic_safety_factor: 4}}}
analyses: [transient: {duration: 4 s, output_step: 20 ms)" +
                  step + "}]\n");
}

bool told_as_too_long(const Result& r) {
  return std::any_of(r.unsafe.begin(), r.unsafe.end(), [](const std::string& words) {
    return words.find("its given steps leave an error of up to") != std::string::npos;
  });
}

// 9 steps a swing lose a third of its top.
TEST(SignalsInMotion, AGivenStepThatIsTooLongIsUnsafe) {
  const Result coarse = in_given_steps(", step: 20 ms"), fine = in_given_steps(", step: 0.5 ms");
  EXPECT_TRUE(told_as_too_long(coarse)) << coarse.message << to_text(coarse.errors);
  EXPECT_FALSE(told_as_too_long(fine));
  EXPECT_LT(value_of(coarse, "T_max"), 0.9 * value_of(fine, "T_max"));
  EXPECT_NEAR(value_of(fine, "T_max"), value_of(in_given_steps(""), "T_max"), 0.02 * value_of(fine, "T_max"));
}

// Each step as long as a period: all would meet the sine at its mean. It makes 0.5 kN/((50/5.51)^2 - 1) = 6 N.
TEST(SignalsInMotion, AGivenStepMeetsTheTopsOfASine) {
  const Result r = in_given_steps(", step: 20 ms", "50 Hz");
  EXPECT_GT(value_of(r, "T_max"), 30e3 + 500 * 9.80665 + 5);
}

}  // namespace taut::app::signals_motion_test
