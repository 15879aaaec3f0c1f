#include "taut/checks/drive_uses.hpp"

#include <gtest/gtest.h>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// Drives count in every analysis.
namespace taut::drive_uses_test {

using taut_test::run_text;

/// A belt over a driven sheave and a tail sheave that a weight pulls; a brake holds the belt back.
std::string belt(const std::string& analyses) {
  return R"(taut: 1
machine:
  ropes: {belt: {mass: 0.6 kg/m, stiffness: 0.65 MN, breaking_force: 60 kN}}
  bodies: {slide: {mass: 85 kg, at: [9 m, 0 m, 0 m], free: [x]}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 500 mm, friction: 0.2, inertia: 4 kg m^2, motor: {speed: 3 m/s}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 500 mm, efficiency: 0.95, inertia: 2 kg m^2}
  take_up: [{body: slide, weight: 300 kg, along: [1, 0, 0]}]
  reevings: [{rope: belt, path: [{over: drive, side: left}, {over: tail, side: left}], closed: true, length: 19.53 m}]
  rope_loads: [{name: cut, rope: belt, between: [tail, drive], rate: 60 N/m, from: 0.2, to: 0.7}]
checks: {ropes: {belt: {safety_factor: 3}}}
analyses: [)" +
         analyses + "]\n";
}

Verdict judged(const std::string& analyses) {
  const Result r = run_text(belt(analyses));
  EXPECT_TRUE(verdict_of(r)) << to_text(r.errors);
  return verdict_of(r).value_or(Verdict{});
}

TEST(DriveUses, AGripThatFailsInAnyStateFails) {
  EXPECT_EQ(to_text(judged("equilibrium: {motion: in}").kind), "passes") << judged("equilibrium: {motion: in}").reason;
  const std::string sweep = "{parameter: \"rope_loads[0].rate\", from: 60 N/m, to: 400 N/m, steps: 4, motion: in}";
  const Verdict swept = judged("equilibrium: {motion: in}, sweep: " + sweep);
  EXPECT_EQ(to_text(swept.kind), "fails") << swept.reason;
  EXPECT_NE(swept.reason.find("drive.grip"), std::string::npos) << swept.reason;
  EXPECT_NE(swept.reason.find("sweep"), std::string::npos) << swept.reason;
}

TEST(DriveUses, AnAnalysisThatIsNotJudgedDoesNotCount) {
  const Verdict v = judged(
      "equilibrium: {motion: in}, sweep: {parameter: \"rope_loads[0].rate\", from: 60 N/m, to: 400 N/m, steps: 4, "
      "motion: in, judge: false}");
  EXPECT_EQ(to_text(v.kind), "passes") << v.reason;
}

TEST(DriveUses, ARopeThatSlipsInAMotionIsUnsafe) {
  const std::string slow = "transient: {duration: 0.5 s, output_step: 10 ms, tolerance: 1e-3}";
  const Result r = run_text(belt(slow), {"machine.rope_loads[0].rate=450 N/m"});
  ASSERT_TRUE(verdict_of(r)) << to_text(r.errors);
  EXPECT_EQ(to_text(verdict_of(r)->kind), "passes_with_warnings") << verdict_of(r)->reason;
  ASSERT_FALSE(r.unsafe.empty());
  EXPECT_NE(r.unsafe.front().find("the rope slips on 'drive'"), std::string::npos) << r.unsafe.front();
}

}  // namespace taut::drive_uses_test
