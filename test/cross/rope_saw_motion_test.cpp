#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "taut/app/job.hpp"
#include "test/cross/drive_results.hpp"

// The rope saw in time: beside the same machine in steady motion, and beside the published method and what it should
// have said.
namespace rope_saw_motion_test {

using namespace taut;
using namespace taut_test::drive_results;

struct Saw {
  double cutting_force = 4000, friction = 0.35, speed = 15, idler_loss = 1, pull = 13e3;
  bool screw = false, reversed = false;
  double position = 0.5;
  std::string analyses;
};

Result machine(const Saw& k) {
  // a screw: the length with which the rope pulls the idler with that force at rest
  const double rest = (2 * 9 + M_PI * 0.5) / (1 + k.pull / 2 / 6.5e6);
  const std::string side = k.reversed ? "right" : "left";
  const std::string deck = fmt::format(
      R"(taut: 1
machine:
  gravity: 0.001 m/s^2
  signals:
    running: {{ramp: {{to: {2} m/s, start: 0.2 s, duration: 1.5 s, smooth: true}}}}
    cutting: {{ramp: {{to: {0} N, start: 2 s, duration: 1 s, smooth: true}}}}
  ropes: {{saw: {{mass: 0.6 kg/m, stiffness: 6.5 MN, damping_time: 2 ms}}}}
  bodies: {{slide: {{mass: 60 kg, at: [{8} m, 0 m, 0 m], free: [x]}}}}
  sheaves:
    drive: {{at: [0 m, 0 m, 0 m], diameter: 500 mm, friction: {1}, inertia: 4 kg m^2, motor: {{speed: running}}}}
    idler: {{body: slide, at: [0 m, 0 m, 0 m], diameter: 500 mm, efficiency: {3:.17g}, inertia: 2 kg m^2}}
  reevings: [{{rope: saw, path: [{{over: drive, side: {4}}}, {{over: idler, side: {4}}}], closed: true, length: {5:.17g} m}}]
  {7}
  rope_loads: [{{name: cut, rope: saw, between: [idler, drive], tangential: {0} N, signal: cutting, position: {6}}}]
  observe: [drive.T_in, drive.T_out, drive.slip, drive.speed, cut.T_in, cut.T_out, cut.speed]
analyses: [{9}]
)",
      k.cutting_force, k.friction, k.speed, 1 / k.idler_loss, side, rest, k.position,
      fmt::format("take_up: [{{body: slide, screw: {} N, keeps: {}}}]", k.pull, k.screw ? "place" : "force"),
      k.screw ? 8.97 : 9.0, k.analyses);
  return taut::app::run(taut::app::Job{.text = deck, .name = "saw.yaml", .set = {}});
}

const char* const in_time = "transient: {duration: 6 s, output_step: 20 ms, tolerance: 1e-4}";

/// Weight and screw, with and without the idler's loss, slow and fast, both ways round, wherever the force acts.
TEST(RopeSawMotion, ComesToTheSteadyTensions) {
  for (const bool screw : {false, true}) {
    for (const double speed : {2.0, 25.0}) {
      Saw k;
      k.screw = screw;
      k.speed = speed;
      k.idler_loss = screw ? 1.0 : 1.08;
      k.position = speed > 10 ? 0.3 : 0.6;
      k.reversed = screw != (speed > 10);
      k.analyses = "equilibrium: {motion: in}";
      const Result steady = machine(k);
      k.analyses = in_time;
      const Result motion = machine(k);
      ASSERT_EQ(motion.status, Status::ok) << motion.message << to_text(motion.errors);
      // fixed centres: in motion the arcs hold as much rope as at rest, whatever its stretch there; they are 8 % of it
      const double allowed = (screw ? 6e-3 : 5e-4) * drive(steady, "T_in");
      for (const char* side : {"T_in", "T_out"}) {
        EXPECT_NEAR(value(motion, fmt::format("drive.{}_end", side)), drive(steady, side), allowed)
            << side << (screw ? " screw " : " weight ") << speed;
      }
      EXPECT_NEAR(value(motion, "cut.T_out_end") - value(motion, "cut.T_in_end"), k.cutting_force, 1e-3);
      EXPECT_LT(value(motion, "drive.slip_share"), 1e-6);
      EXPECT_LT(std::abs(value(motion, "energy_residual")), 1e-5);
    }
  }
}

/// The published initial tension lets the rope slip until it stands, the no-slip one doesn't. The force acts in the
/// middle of the branch here, the idler feels the slack tension alone: (r + 1) P/(e - r) is the least pull.
TEST(RopeSawMotion, ThePublishedTensionSlipsTheOtherDoesNot) {
  const Result method = taut::app::run(taut::app::Job{.text = R"(taut: 1
method: friction_drive
input: {cutting_force: 4 kN, friction: 0.35, wrap: 180 deg, rope_mass: 0.6 kg/m, speed: 15 m/s, grip_reserve: 1.2, idler_loss: 1.08}
)",
                                                      .name = "method.yaml",
                                                      .set = {}});
  Saw k;
  k.idler_loss = 1.08;
  k.analyses = in_time;
  const auto share = [&](double pull) {
    k.pull = pull;
    const Result r = machine(k);
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return std::pair{value(r, "drive.slip_share"), value(r, "cut.speed_end")};
  };
  const auto published = share(value(method, "P_M"));
  EXPECT_GT(published.first, 0.4);
  EXPECT_NEAR(published.second, 0, 1e-6);
  const auto held = share(value(method, "takeup_with_idler_loss"));
  EXPECT_LT(held.first, 1e-6);
  EXPECT_NEAR(held.second, 15, 0.02);
  const double least = 2.08 * 4000 / (std::exp(0.35 * M_PI) - 1.08);
  const auto more = share(1.02 * least), less = share(0.98 * least);
  EXPECT_LT(more.first, 1e-6);
  EXPECT_GT(less.first, 0.05);
}

TEST(RopeSawMotion, MistakesAreTold) {
  Saw k;
  k.analyses = in_time;
  const auto reported = [&](const std::string& set) {
    taut::app::Job job;
    job.text = R"(taut: 1
machine:
  ropes: {saw: {mass: 0.6 kg/m, stiffness: 6.5 MN}}
  bodies: {load: {mass: 600 kg, at: [0 m, 0 m, 0 m], free: [z]}}
  points: {top: [0 m, 0 m, 9 m]}
  reevings: [{rope: saw, path: [{anchor: top}, {anchor: load}], length: 9 m}]
  rope_loads: [{name: brake, rope: saw, between: [top, load], tangential: 200 N, signal: 200 N}]
analyses: [transient: {duration: 0.1 s}]
)";
    job.name = "deck.yaml";
    job.set = {set};
    return to_text(taut::app::run(job).errors);
  };
  EXPECT_EQ(reported("machine.ropes.saw.damping_time=1 ms"), "");
  EXPECT_EQ(reported("machine.reevings[0].segments=4"), "");
  EXPECT_NE(reported("machine.rope_loads[0].signal=3 m/s").find("signal"), std::string::npos);
  EXPECT_NE(reported("machine.rope_loads[0].signal=cuting").find("cuting"), std::string::npos);
}

}  // namespace rope_saw_motion_test
