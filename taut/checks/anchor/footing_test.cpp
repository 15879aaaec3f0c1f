#include "taut/checks/anchor/footing.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Whatever stands on the ground may be pulled off it.
namespace taut::checks::footing_test {

using taut_test::cell;
using taut_test::check_of;
using taut_test::expect_mistake;
using taut_test::run_text;
using taut_test::table_of;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double g = 9.80665;         // m/s2
constexpr double tube_mass = 25.182;  // kg/m, of a CHS 168.3x6.3 by its area and 7850 kg/m3

/// A tripod with 1 t on it, pulled aside at its head.
std::string tripod(const std::string& anchors, const std::string& pull = "10 kN", bool from_top = false) {
  std::string legs;
  for (const char* leg : {"1", "2", "3"}) {
    legs += fmt::format(
        "    leg{0}: {{from: {1}, to: {2}, section: CHS 168.3x6.3, steel: S355, base: hinge, top: hinge}}\n", leg,
        from_top ? "tip" : std::string("f") + leg, from_top ? std::string("f") + leg : "tip");
  }
  return R"(taut: 1
machine:
  ropes: {line: {stiffness: 20 MN, mass: 0 kg/m, breaking_force: 250 kN}}
  bodies:
    apex: {mass: 10 kg, at: [0 m, 0 m, 6 m], free: [x, y, z]}
    load: {mass: 1 t, at: [0 m, 0 m, 3 m], free: [x, y, z]}
  points:
    f1: [2 m, 0 m, 0 m]
    f2: [-1 m, 1.7 m, 0 m]
    f3: [-1 m, -1.7 m, 0 m]
    far: [10 m, 0 m, 6 m]
    tip: {body: apex, at: [0 m, 0 m, 0 m]}
  beams:
)" + legs +
         R"(  reevings:
    - {rope: line, path: [{anchor: apex}, {anchor: load}], length: 3 m, name: drop}
    - {rope: line, path: [{anchor: far}, {anchor: apex}], name: pull, tension_at_start: )" +
         pull + R"(}
analyses: [equilibrium: {motion: at_rest}]
checks:
  ropes: {line: {safety_factor: 3}}
  masts: {leg1: {load_factor: 1.35}, leg2: {load_factor: 1.35}, leg3: {load_factor: 1.35}}
)" + anchors;
}

/// By moments about the line through the feet 2 and 3, at x = -1 m.
double uplift_of_tripod() {
  const double near = 1.7, leg1 = tube_mass * g * std::hypot(2, 6), leg2 = tube_mass * g * std::hypot(1, near, 6);
  const double W = 1010 * g, H = 10e3;
  const double on_foot_1 = (H * 6 + W * 1 + leg1 * 2 + 2 * leg2 * 0.5) / 3;
  return (on_foot_1 - W - leg1 - 2 * leg2) / 2;
}

TEST(Footing, ATripodThatIsPulledOffTheGroundIsUnsafe) {
  const double uplift = uplift_of_tripod();
  for (const bool from_top : {false, true}) {
    const Result r = run_text(tripod("", "10 kN", from_top));
    EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes_with_warnings) << verdict_of(r)->reason << to_text(r.errors);
    EXPECT_THAT(r.unsafe, ElementsAre(HasSubstr("the foot of leg2 at 'f2' is pulled up with"),
                                      HasSubstr("the foot of leg3 at 'f3' is pulled up with")));
    const Result judged = run_text(
        tripod("  anchors: {f2: {uplift: 6 kN}, f3: {strength: 30 kN, safety_factor: 2}}\n", "10 kN", from_top));
    EXPECT_THAT(judged.unsafe, IsEmpty());
    EXPECT_EQ(verdict_of(judged)->kind, VerdictKind::passes) << verdict_of(judged)->reason << to_text(judged.errors);
    EXPECT_NEAR(check_of(judged, "f2.anchor_uplift").value, uplift, 0.01 * uplift);
    EXPECT_NEAR(cell(table_of(judged, "anchor_forces"), 1, "upwards"), uplift, 0.01 * uplift);
    EXPECT_GT(cell(table_of(judged, "anchor_forces"), 1, "force"), 1.05 * uplift) << "it pulls aside too";
  }
  const Result weak = run_text(tripod("  anchors: {f2: {uplift: 4 kN}, f3: {uplift: 6 kN}}\n"));
  EXPECT_EQ(verdict_of(weak)->kind, VerdictKind::fails);
  EXPECT_FALSE(check_of(weak, "f2.anchor_uplift").passes);
}

TEST(Footing, OneThatIsPressedHoldsNothing) {
  EXPECT_THAT(run_text(tripod("", "1 kN")).unsafe, IsEmpty());
  const Result r =
      run_text(tripod("  anchors: {f1: {uplift: 0 kN}, f2: {uplift: 6 kN}, f3: {angle: 80 deg, uplift: 6 kN}}\n"));
  EXPECT_THAT(r.unsafe, IsEmpty());
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::passes) << verdict_of(r)->reason << to_text(r.errors);
  EXPECT_EQ(check_of(r, "f1.anchor_uplift").value, 0);
  const Result strong = run_text(tripod("  anchors: {f1: {strength: 30 kN}}\n"));
  EXPECT_THAT(strong.unmade, Contains(HasSubstr("f1 is not checked: no load case of the deck pulls it up")));
}

/// A level strut between two walls that warms up and cools down pulls and presses them, but not upwards: what rounding
/// leaves of that is no pull. At its reference temperature no force at all is larger.
TEST(Footing, ALevelStrutIsNotPulledUpByRounding) {
  const auto strut = [](const std::string& mass, const std::string& anchors) {
    return run_text(R"(taut: 1
machine:
  temperature: 10 degC
  points: {a: [0 m, 0 m, 1 m], b: [4 m, 0 m, 1 m], c: [0 m, 5 m, 1 m], d: [4 m, 5 m, 1 m]}
  beams:
    s: {from: a, to: b, section: CHS 168.3x8, steel: S355, top: hinge, base: hinge)" +
                    mass + R"(}
    u: {from: c, to: d, section: RHS 300x200x8, steel: S355, top: clamped)" +
                    mass + R"(}
analyses: [sweep: {parameter: temperature, from: -20 degC, to: 50 degC, steps: 7}]
checks:
  masts: {s: {load_factor: 1.35}, u: {load_factor: 1.35}}
)" + anchors);
  };
  const std::string four =
      "  anchors: {a: {strength: 1 MN, angle: 20 deg}, b: {strength: 1 MN, angle: 20 deg},\n"
      "            c: {strength: 1 MN, angle: 20 deg}, d: {strength: 1 MN, angle: 20 deg}}\n";
  EXPECT_THAT(strut(", mass: 0 kg/m", "").unsafe, IsEmpty());
  for (const char* mass : {", mass: 0 kg/m", ""}) {
    const Result r = strut(mass, four);
    EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged) << verdict_of(r)->reason << to_text(r.errors);
    for (const char* point : {"a", "b", "c", "d"}) {
      EXPECT_THAT(r.unmade, Contains(fmt::format("{} is not checked: no load case of the deck pulls it up, and what "
                                                 "only presses it or pulls it aside is not counted",
                                                 point)));
    }
  }
}

TEST(Footing, WhatIsOfRopesIsNotAskedOfIt) {
  expect_mistake(run_text(tripod("  anchors: {f2: {tree_diameter: 40 cm}}\n")), "no rope ends at 'f2'");
  expect_mistake(run_text(tripod("  anchors: {f2: {strength: 9 kN, as_strong_as_rope: true}}\n")),
                 "no rope ends at 'f2'");
  expect_mistake(run_text(tripod("  anchors: {f4: {}}\n")), "no rope ends at 'f4', and nothing stands there");
}

/// A spar that two ropes lift: 30 kN at 45 deg in each.
std::string spar(const std::string& spar, const std::string& head, const std::string& checks) {
  return R"(taut: 1
machine:
  ropes: {line: {stiffness: 20 MN, mass: 0 kg/m, breaking_force: 400 kN}}
  points:
    foot: [0 m, 0 m, 0 m]
    head: [0 m, 0 m, 10 m]
    s1: [-10 m, 0 m, 20 m]
    s2: [10 m, 0 m, 20 m]
    s3: [0 m, 10 m, 10 m]
    s4: [0 m, -10 m, 10 m]
)" + spar +
         R"(  reevings:
    - {rope: line, path: [{anchor: s1}, {anchor: )" +
         head + R"(}], tension_at_start: 30 kN, name: u1}
    - {rope: line, path: [{anchor: s2}, {anchor: )" +
         head + R"(}], length: 14.13 m, name: u2}
    - {rope: line, path: [{anchor: s3}, {anchor: )" +
         head + R"(}], length: 9.99 m, name: u3}
    - {rope: line, path: [{anchor: s4}, {anchor: )" +
         head + R"(}], length: 9.99 m, name: u4}
)" + checks;
}

TEST(Footing, ASparOnABallJointIsHeldAsOneOfABeam) {
  const std::string rest = "analyses: [equilibrium: {motion: at_rest}]\n";
  const std::string ropes = rest + "checks:\n  ropes: {line: {safety_factor: 3}}\n";
  const double pulls = 2 * 30e3 * std::sqrt(0.5);
  const std::string as_body =
      "    eye: {body: spar, at: [0 m, 0 m, 10 m]}\n"
      "  bodies: {spar: {mass: 400 kg, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 5 m], free: [rx, ry, rz]}}\n";
  const Result bare = run_text(spar(as_body, "eye", ropes));
  EXPECT_THAT(bare.unsafe, ElementsAre(HasSubstr("the joint of 'spar' is pulled up with 38.")))
      << bare.message << to_text(bare.errors);
  const Result held = run_text(spar(as_body, "eye", ropes + "  anchors: {spar: {uplift: 40 kN}}\n"));
  EXPECT_THAT(held.unsafe, IsEmpty());
  EXPECT_NEAR(check_of(held, "spar.anchor_uplift").value, pulls - 400 * g, 0.005 * pulls);
  const std::string as_beam =
      "  beams: {spar: {from: foot, to: head, section: CHS 219.1x8, steel: S355, base: hinge}}\n";
  EXPECT_THAT(run_text(spar(as_beam, "spar.top", ropes + "  masts: {spar: {load_factor: 1.35}}\n")).unsafe,
              Contains(HasSubstr("the foot of spar at 'foot' is pulled up with 38.")));
}

TEST(Footing, AMotionDoesNotKnowTheForceOnAJoint) {
  const Result r = run_text(spar(
      "    eye: {body: spar, at: [0 m, 0 m, 10 m]}\n"
      "  bodies: {spar: {mass: 400 kg, at: [0 m, 0 m, 0 m], centre: [0 m, 0 m, 5 m], inertia: 3000 kg m^2, free: "
      "[ry]}}\n",
      "eye",
      "analyses: [equilibrium: {motion: at_rest}, transient: {duration: 0.1 s, output_step: 50 ms, tolerance: 1e-3}]\n"
      "checks: {ropes: {line: {safety_factor: 3}}, anchors: {spar: {uplift: 40 kN}}}\n"));
  EXPECT_THAT(r.unmade, Contains(HasSubstr("spar is not checked in a motion"))) << r.message << to_text(r.errors);
}

}  // namespace taut::checks::footing_test
