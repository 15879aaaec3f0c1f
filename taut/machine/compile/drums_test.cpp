#include "taut/machine/compile/drums.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "taut/machine/compile.hpp"
#include "test/support/complaints.hpp"

namespace drums_test {

using namespace taut;
using namespace taut::machine;
using taut_test::complaints_of;
using testing::HasSubstr;

RopeData rope16() {
  RopeData rope;
  rope.name = "line";
  rope.diameter = 0.016;
  rope.stiffness = 10e6;
  return rope;
}

description::Drum winch(double on_drum) {
  description::Drum d;
  d.name = "winch";
  d.core_diameter = 0.3;
  d.layers = description::Layers::automatic;
  d.face_width = 0.4;  // 25 turns
  d.length_on_drum = on_drum;
  return d;
}

/// Machine with so many reevings of so many copies each, from that drum to a point.
Machine wound(int reevings, int copies) {
  Machine m;
  for (int i = 0; i < reevings; ++i) {
    description::Reeving& one = m.reevings.emplace_back();
    one.rope = "line";
    one.copies = copies;
    one.path.resize(2);
    one.path.front().drum = "winch";
    one.path.back().anchor = "load";
  }
  return m;
}

int layer_of(const description::Drum& drum, int reevings = 1, int copies = 1) {
  const Array<RopeData> ropes = {rope16()};
  return machine::layer_of({.machine = wound(reevings, copies), .ropes = ropes, .drum = drum, .rope = ropes.front()});
}

double radius_of(const description::Drum& drum) {
  const Array<RopeData> ropes = {rope16()};
  return machine::radius_of({.machine = wound(1, 1), .ropes = ropes, .drum = drum, .rope = ropes.front()});
}

/// Rope in n full layers, summed turn by turn.
double full(int layers) {
  double sum = 0;
  for (int k = 1; k <= layers; ++k) sum += 25 * std::hypot(2 * M_PI * (0.15 + (k - 0.5) * 0.016), 0.016);
  return sum;
}

TEST(Drums, TheLayerFollowsFromTheRopeOnTheDrum) {
  EXPECT_EQ(layer_of(winch(0)), 1);
  for (const int k : {1, 2, 3, 5}) {
    EXPECT_EQ(layer_of(winch(full(k) - 1e-6)), k);
    EXPECT_EQ(layer_of(winch(full(k) + 1e-6)), k + 1);
    EXPECT_NEAR(radius_of(winch(full(k) - 1e-6)), 0.15 + (k - 0.5) * 0.016, 1e-12);
  }
}

TEST(Drums, AllRopesOfADrumMakeItsLayers) {
  for (const int k : {2, 4}) {
    const description::Drum drum = winch(full(k) / 2 + 1e-6);
    EXPECT_LE(layer_of(drum), k);
    EXPECT_EQ(layer_of(drum, 2, 1), k + 1);
    EXPECT_EQ(layer_of(drum, 1, 2), k + 1);
    EXPECT_EQ(layer_of(winch(full(k) / 4 - 1e-6), 2, 2), k);
  }
}

TEST(Drums, ARopeWoundTightIsShorterUnstretched) {
  description::Drum d = winch(full(2) / (1 + 30e3 / 10e6) + 1e-6);
  EXPECT_EQ(layer_of(d), 2);
  d.wound_at = 30e3;
  EXPECT_EQ(layer_of(d), 3);
}

TEST(Drums, ALayerThatIsGivenStays) {
  description::Drum d = winch(60);
  d.layers.reset();
  EXPECT_EQ(layer_of(d), 1);
  d.layer = 4;
  EXPECT_EQ(layer_of(d), 4);
  d.layer_height = 0.014;
  EXPECT_NEAR(radius_of(d), 0.158 + 3 * 0.014, 1e-12);
}

TEST(Drums, ATorqueGivesTheTensionOfEachCopy) {
  Drive drive;
  drive.kind = DriveKind::torque;
  drive.signal = Signal{.name = {}, .unit = si::N_m, .law = 4e3};
  const description::Drum d = winch(full(2) / 2 + 1);
  const Array<RopeData> ropes = {rope16()};
  const Machine two = wound(1, 2);
  const EndOnDrum end{.machine = two, .ropes = ropes, .drum = d, .rope = ropes.front()};
  EXPECT_NEAR(pull_of_torque(end, drive, 2).value_or(0), 4e3 / (0.15 + 2.5 * 0.016) / 2, 1e-9);
  drive.signal = Signal{.name = {}, .unit = si::N_m, .law = 0.0};
  EXPECT_FALSE(pull_of_torque(end, drive, 2)) << "nothing pulls yet";
}

Machine lift() {
  Machine m;
  description::Rope rope;
  rope.name = "line";
  rope.mass = 0.9;
  rope.stiffness = 10e6;
  rope.diameter = 0.016;
  m.ropes = {rope};
  description::Body hook;
  hook.name = "hook";
  hook.mass = 2000;
  hook.at = {0, 0, -30};
  hook.free = {"x", "z"};
  m.bodies = {hook};
  m.drums = {winch(60)};
  description::Reeving r;
  r.rope = "line";
  r.path.resize(2);
  r.path[0].drum = "winch";
  r.path[1].anchor = "hook";
  r.length = 30;
  m.reevings = {r};
  return m;
}

TEST(Drums, OfAMachine) {
  Machine m = lift();
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_EQ(model->drums[0].layer, 3);
  EXPECT_NEAR(model->reevings[0].nodes[0].radius, 0.19, 1e-12);
  m.reevings[0].length.reset();
  m.drums[0].drive.emplace();
  m.drums[0].drive->torque = "4 kN m";
  const auto pulled = compile(m);
  ASSERT_TRUE(pulled) << complaints_of(m);
  EXPECT_EQ(pulled->reevings[0].given, machine::Given::tension_at_start);
  EXPECT_NEAR(pulled->reevings[0].value, 4e3 / 0.19, 1e-9);
}

// Half of the rope's thickness is no lever: 10 kN at 5 mm would pass as 0.05 kN m.
TEST(Drums, ABrakeTorqueNeedsACore) {
  for (const bool known : {false, true}) {
    Machine m = lift();
    if (!known) m.ropes[0].diameter.reset();
    description::Drum& drum = m.drums[0];
    drum = {};
    drum.name = "winch";
    EXPECT_TRUE(compile(m, ModelFor::rest)) << "it only winds: " << complaints_of(m);
    drum.brake_torque = 1500;
    const auto refused = compile(m, ModelFor::rest);
    ASSERT_FALSE(refused);
    ASSERT_EQ(refused.error().size(), 1U);
    EXPECT_EQ(refused.error()[0].path, "drums.winch");
    EXPECT_THAT(refused.error()[0].message, HasSubstr("it needs a 'core_diameter'"));
    drum.core_diameter = 0.4;
    EXPECT_TRUE(compile(m, ModelFor::rest)) << complaints_of(m);
  }
}

TEST(Drums, TellsEachMistakeAtItsPlace) {
  const std::vector<std::pair<std::function<void(Machine&)>, std::string>> cases = {
      {[](Machine& m) { m.drums[0].length_on_drum.reset(); }, "drums.winch: 'layers: auto' needs the 'length_on_drum'"},
      {[](Machine& m) { m.drums[0].face_width.reset(); }, "drums.winch: 'layers: auto' needs the 'face_width'"},
      {[](Machine& m) { m.drums[0].core_diameter = 0; }, "drums.winch: 'layers: auto' needs a 'core_diameter'"},
      {[](Machine& m) { m.drums[0].layer = 2; }, "drums.winch.layer: follows from the length on the drum"},
      {[](Machine& m) { m.drums[0].flange_diameter = 0.2; }, "drums.winch.flange_diameter: is not larger"},
      {[](Machine& m) { m.drums[0].face_width.reset(), m.drums[0].pitch = 0.02; },
       "drums.winch.pitch: gives the turns of a layer and needs the 'face_width'"}};
  for (const auto& [change, words] : cases) {
    Machine m = lift();
    change(m);
    EXPECT_THAT(complaints_of(m), HasSubstr(words));
  }
}

}  // namespace drums_test
