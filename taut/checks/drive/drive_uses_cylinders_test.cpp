#include <gtest/gtest.h>

#include <string>

#include "test/support/machine_decks.hpp"

/// Cylinders at their force limit.
namespace taut::drive_uses_cylinders_test {

using taut_test::run_text;

TEST(CylinderUses, ACylinderThatGivesWayIsUnsafe) {
  const auto boom = [](const std::string& limit) {
    return run_text(R"(taut: 1
machine:
  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 500 kN, damping_ratio: 0.05}}
  bodies:
    boom: {at: [0 m, 0 m, 0 m], centre: [3 m, 0 m, 3 m], mass: 2 t, inertia: [9000 kg m^2, 18000 kg m^2, 9000 kg m^2], free: [ry]}
    load: {at: [6 m, 0 m, 2 m], mass: 4 t, free: [x, z]}
  points: {tip: {body: boom, at: [6 m, 0 m, 6 m]}, lug: {body: boom, at: [2 m, 0 m, 2 m]}, frame: [2 m, 0 m, 0 m]}
  actuators: {cyl: {from: frame, to: lug, speed: 0 m/s, lock_stiffness: 50 MN/m, lock_damping: 500 kN s/m, force_limit: )" +
                    limit + R"(}}
  reevings: [{rope: r, path: [{anchor: tip}, {anchor: load}], length: 4 m}]
checks: {ropes: {r: {safety_factor: 3}}}
analyses: [{transient: {duration: 0.5 s, output_step: 0.1 s, start: assembled, tolerance: 1e-3}}]
)");
  };
  const Result r = boom("100 kN");
  ASSERT_EQ(r.unsafe.size(), 1U) << r.message << to_text(r.errors);
  EXPECT_NE(r.unsafe[0].find("'cyl' is at its force limit of 100 kN"), std::string::npos) << r.unsafe[0];
  EXPECT_TRUE(boom("500 kN").unsafe.empty());
}

// 2 t rest on a cylinder of a given force or law: 19.6 kN.
TEST(CylinderUses, ACylinderAtItsLimitIsUnsafeWhateverDrivesIt) {
  const auto lift = [](const std::string& law, const std::string& limit) {
    return run_text(R"(taut: 1
machine:
  gravity: 9.81 m/s^2
  signals: {v: {constant: 0 m/s}, F: {constant: 19.62 kN}}
  points: {base: [0 m, 0 m, 0 m], q: [3 m, 0 m, 40 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 2 MN, breaking_force: 180 kN, damping_time: 2 ms}}
  bodies: {w: {mass: 100 kg, at: [3 m, 0 m, 30 m], free: [z]}, m: {mass: 2 t, at: [0 m, 0 m, 2 m], free: [z]}}
  actuators: {cyl: {from: base, to: m, )" +
                    law + ", force_limit: " + limit + R"(}}
  reevings: [{name: s, rope: r, path: [{anchor: q}, {anchor: w}], length: 10 m}]
checks: {ropes: {r: {safety_factor: 3}}}
analyses: [{transient: {duration: 0.3 s, output_step: 10 ms, tolerance: 1e-3, start: assembled}}]
)");
  };
  for (const char* law : {"law: {F0: 19.62 kN, gain: 2 MN s/m, reference: v}", "force: F"}) {
    const Result weak = lift(law, "15 kN");
    ASSERT_EQ(weak.unsafe.size(), 1U) << law << weak.message << to_text(weak.errors);
    EXPECT_NE(weak.unsafe[0].find("'cyl' is at its force limit of 15 kN"), std::string::npos) << weak.unsafe[0];
    EXPECT_TRUE(lift(law, "25 kN").unsafe.empty()) << law;
  }
}

// 19.62 kN and a rope: a lock ignores the limit, the verdict does not.
TEST(CylinderUses, ALockedCylinderAboveItsLimitIsUnsafe) {
  const auto locked = [](const std::string& limit) {
    return run_text(R"(taut: 1
machine:
  gravity: 9.81 m/s^2
  points: {base: [0 m, 0 m, 0 m], q: [3 m, 0 m, 40 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 2 MN, breaking_force: 180 kN, damping_time: 2 ms}}
  bodies: {w: {mass: 100 kg, at: [3 m, 0 m, 30 m], free: [z]}, m: {mass: 2 t, at: [0 m, 0 m, 2 m], free: [z]}}
  actuators: {cyl: {from: base, to: m, force: 5 kN, mode: lock, lock_stiffness: 20 MN/m, lock_damping: 100 kN s/m, force_limit: )" +
                    limit + R"(}}
  reevings: [{name: s, rope: r, path: [{anchor: q}, {anchor: w}], length: 10 m}]
checks: {ropes: {r: {safety_factor: 3}}}
analyses: [{transient: {duration: 0.3 s, output_step: 10 ms, tolerance: 1e-3}}]
)");
  };
  const Result weak = locked("15 kN");
  ASSERT_EQ(weak.unsafe.size(), 1U) << weak.message << to_text(weak.errors);
  EXPECT_NE(weak.unsafe[0].find("more than its force limit of 15 kN: it is locked"), std::string::npos)
      << weak.unsafe[0];
  EXPECT_TRUE(locked("25 kN").unsafe.empty());
}

}  // namespace taut::drive_uses_cylinders_test
