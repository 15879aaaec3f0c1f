#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

/// What a motion without inertia does not show.
namespace taut::checks::slow_motion_test {

using taut_test::run_text;
using testing::HasSubstr;

/// A cylinder pushes 500 kg off its shelf. They fall 0.3 m into their sling: T = m g (1 + sqrt(1 + 2 h k/(m g))), k =
/// 50 MN/5.3 m, is 171 kN, beyond the 100 kN of the rope.
TEST(SlowMotion, AFallIsNotJudged) {
  const Result r = run_text(R"(taut: 1
machine:
  bodies: {load: {at: [-0.5 m, 0 m, 5 m], mass: 500 kg, free: [x, z]}}
  points: {top: {at: [0 m, 0 m, 10 m]}, wall: {at: [-4 m, 0 m, 4.6 m]}}
  markers: {foot: {body: load, at: [0 m, 0 m, 0 m]}}
  faces: {shelf: {from: [-2 m, 0 m, 5 m], to: [0 m, 0 m, 5 m]}}
  contacts: [{point: foot, face: shelf, stiffness: 10 MN/m, damping: 50 kN s/m, static_friction: 0.3}]
  ropes: {hang: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 100 kN, damping_ratio: 0.02}}
  reevings: [{rope: hang, path: [{anchor: top}, {anchor: load}], length: 5.3 m, may_slack: true}]
  signals: {v: {ramp: {from: 0 m/s, to: 0.1 m/s, start: 0 s, duration: 1 s}}}
  actuators: {push: {from: wall, to: load, speed: v, lock_stiffness: 100 MN/m, lock_damping: 100 kN s/m}}
analyses: [{transient: {duration: 7 s, output_step: 0.5 s, quasi_static: true}}]
checks: {ropes: {hang: {safety_factor: 5}}}
)");
  ASSERT_TRUE(verdict_of(r)) << r.message << to_text(r.errors);
  EXPECT_EQ(verdict_of(r)->kind, VerdictKind::not_judged) << verdict_of(r)->reason;
  EXPECT_THAT(verdict_of(r)->reason, HasSubstr("load falls at t = 5.4"));
}

/// Of 49 kN, by (1000 kg 5 m + 500 kg 10 m) g over the lever of the cylinder, its law 30 kN + 100 kN s/m (0.1 m/s - v)
/// gives 40 kN at a standstill.
TEST(SlowMotion, ALoadBeyondTheLawOfACylinderIsTold) {
  const auto luffed = [](const std::string& F0) {
    return run_text(R"(taut: 1
machine:
  bodies:
    boom: {at: [0 m, 0 m, 2 m], mass: 1000 kg, centre: [5 m, 0 m, 0 m], inertia: 9000 kg m^2, free: ry}
    load: {at: [10 m, 0 m, -3 m], mass: 500 kg, free: [x, z]}
  points: {foot: {at: [1.5 m, 0 m, 0.5 m]}, eye: {body: boom, at: [4 m, 0 m, -0.3 m]}, tip: {body: boom, at: [10 m, 0 m, 0 m]}}
  ropes: {hang: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 100 kN}}
  reevings: [{rope: hang, path: [{anchor: tip}, {anchor: load}], length: 5 m}]
  events: [{at: 1 s, actuator: luff, mode: extend}]
  actuators:
    luff: {from: foot, to: eye, law: {F0: )" +
                    F0 + R"(, gain: 100 kN s/m, reference: 0.1 m/s}, mode: lock, lock_stiffness: 1000 MN/m,
      lock_damping: 100 kN s/m}
analyses: [{transient: {duration: 2 s, output_step: 0.5 s, quasi_static: true}}]
checks: {ropes: {hang: {safety_factor: 5}}}
)");
  };
  EXPECT_THAT(luffed("30 kN").unsafe,
              testing::ElementsAre(HasSubstr("'luff' bears 48.48 kN, more than its law gives at a standstill, 40 kN")));
  EXPECT_THAT(luffed("40 kN").unsafe, testing::IsEmpty());
}

/// A chassis of 1500 kg on feet at +-2 m, a section of 400 kg on its pads, from whose head 600 kg hang: (1500 2 - 400 x
/// - 600 (2 + x)) kg m vanish at x = 1.8 m, at 18.5 s.
TEST(SlowMotion, AChassisTipsByWhatItsSectionsCarry) {
  const auto crane = [](const std::string& duration) {
    return run_text(R"(taut: 1
machine:
  bodies:
    base: {at: [0 m, 0 m, 1 m], mass: 1500 kg, inertia: 6000 kg m^2, free: [x, z, ry]}
    s2: {on: base, at: [0 m, 0 m, 1 m], mass: 400 kg, centre: [2 m, 0 m, 0 m], inertia: 500 kg m^2, free: [x, z, ry]}
    load: {at: [4 m, 0 m, -1 m], mass: 600 kg, free: [x, z]}
  points:
    f.rear: {body: base, at: [-2 m, 0 m, -1 m]}
    f.front: {body: base, at: [2 m, 0 m, -1 m]}
    head: {body: s2, at: [4 m, 0 m, 0 m]}
    c1: {body: base, at: [-3 m, 0 m, 1 m]}
    c2: {body: s2, at: [0 m, 0 m, 0 m]}
  markers:
    b.low: {body: base, at: [3 m, 0 m, 0.8 m]}
    b.high: {body: base, at: [3 m, 0 m, 1.2 m]}
    t.low: {body: s2, at: [0 m, 0 m, -0.2 m]}
    t.high: {body: s2, at: [0 m, 0 m, 0.2 m]}
  faces:
    ground: {from: [-5 m, 0 m, 0 m], to: [5 m, 0 m, 0 m]}
    s2.under: {body: s2, from: [-0.5 m, 0 m, -0.2 m], to: [5 m, 0 m, -0.2 m], normal: [0, 0, -1]}
    s2.upper: {body: s2, from: [-0.5 m, 0 m, 0.2 m], to: [5 m, 0 m, 0.2 m], normal: [0, 0, 1]}
    b.bottom: {body: base, from: [-4 m, 0 m, 0.8 m], to: [5 m, 0 m, 0.8 m], normal: [0, 0, 1]}
    b.top: {body: base, from: [-4 m, 0 m, 1.2 m], to: [5 m, 0 m, 1.2 m], normal: [0, 0, -1]}
  contacts:
    - {point: f.rear, face: ground, stiffness: 100 MN/m, damping: 100 kN s/m, static_friction: 0.5}
    - {point: f.front, face: ground, stiffness: 100 MN/m, damping: 100 kN s/m, static_friction: 0.5}
    - {point: b.low, face: s2.under, stiffness: 200 MN/m, damping: 100 kN s/m, static_friction: 0.1}
    - {point: b.high, face: s2.upper, stiffness: 200 MN/m, damping: 100 kN s/m, static_friction: 0.1}
    - {point: t.low, face: b.bottom, stiffness: 200 MN/m, damping: 100 kN s/m, static_friction: 0.1}
    - {point: t.high, face: b.top, stiffness: 200 MN/m, damping: 100 kN s/m, static_friction: 0.1}
  ropes: {hang: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 100 kN}}
  reevings: [{rope: hang, path: [{anchor: head}, {anchor: load}], length: 3 m}]
  signals: {v: {ramp: {from: 0 m/s, to: 0.1 m/s, start: 0 s, duration: 1 s}}}
  actuators: {cyl: {from: c1, to: c2, speed: v, mode: extend, lock_stiffness: 100 MN/m, lock_damping: 100 kN s/m}}
analyses: [{transient: {output_step: 1 s, tolerance: 1e-3, duration: )" +
                    duration + R"(}}]
checks: {ropes: {hang: {safety_factor: 5}}}
)");
  };
  EXPECT_THAT(crane("17 s").unsafe, testing::IsEmpty());
  EXPECT_THAT(crane("19.5 s").unsafe, testing::Contains(HasSubstr("'base' lifts 'f.rear'")));
}

TEST(SlowMotion, HasNoHoistFactor) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m]}
  ropes: {hang: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 100 kN}}
  bodies: {load: {at: [0 m, 0 m, 5 m], mass: 500 kg, free: [z]}}
  reevings: [{rope: hang, path: [{anchor: top}, {anchor: load}], length: 5 m}]
analyses: [{transient: {duration: 1 s, quasi_static: true, hoist_factor: {rope: hang, class: HC2, speed: 0.1 m/s}}}]
)");
  EXPECT_THAT(to_text(r.errors), HasSubstr("hoist_factor: without inertia"));
}

}  // namespace taut::checks::slow_motion_test
