#include "taut/machine/compile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/complaints.hpp"
#include "test/support/described.hpp"

namespace taut::machine::compile_test {

using namespace described;
using taut_test::complaints_of;

std::string names_of(const Reeving& r) {
  std::string names;
  for (const Node& n : r.nodes) names += n.name + " ";
  return names;
}

TEST(Compile, ALineWithItsCarriage) {
  const auto model = compile(line());
  ASSERT_TRUE(model) << complaints_of(line());
  ASSERT_EQ(model->bodies.size(), 1U);
  EXPECT_EQ(model->bodies[0].free.size(), 3U);
  EXPECT_NEAR((model->bodies[0].position - Vector3(30, 0, 16)).norm(), 0, 1e-12) << "between head and jack";
  const Reeving& sky = model->reevings[0];
  EXPECT_EQ(names_of(sky), "head car jack tail ");
  EXPECT_EQ(sky.nodes[1].kind, NodeKind::contact);
  EXPECT_EQ(sky.nodes[2].support, Vector3::UnitZ());
  EXPECT_EQ(sky.nodes[2].law.friction, 0.1);
  EXPECT_EQ(sky.nodes[2].law.efficiency, 0);
  EXPECT_DOUBLE_EQ(sky.weight, 2 * 9.80665);
  EXPECT_EQ(sky.value, 103);
  EXPECT_EQ(model->reevings[1].given, Given::tension_at_start);
  EXPECT_EQ(model->reevings[1].haul, -1) << "to its drum";
  EXPECT_DOUBLE_EQ(model->reevings[1].nodes[0].radius, 0.2);
  EXPECT_EQ(model->reevings[1].nodes[0].side, 1) << "wound from above";
  EXPECT_EQ(model->carriages[0].mainline, 1);
  EXPECT_EQ(model->carriages[0].node, 1);
}

TEST(Compile, ARopeLiesHalfItsDiameterAboveTheDrum) {
  Machine m = line();
  m.ropes[1].diameter = 0.02;
  m.drums[0].layer = 3;
  EXPECT_DOUBLE_EQ(compile(m)->reevings[1].nodes[0].radius, 0.2 + 2.5 * 0.02);
}

TEST(Compile, WritesTacklesOut) {
  const std::vector<std::pair<Machine, std::string>> rows = {
      {tackle(6, {anchor("lead"), falls(6, "head", "block"), anchor("pin")}),
       "lead head block head block head block pin "},
      {tackle(5, {anchor("lead"), falls(5, "head", "block"), anchor("eye")}), "lead head block head block head eye "},
      {tackle(6, {anchor("lead"), over("head"), parts(6, over("block")), anchor("pin")}),
       "lead head block head block head block pin "},
      {tackle(6, {anchor("lead"), over("head"), falls(6, "block", "head"), anchor("pin")}),
       "lead head block head block head block pin "},
      {tackle(4, {anchor("pin"), parts(4, over("block")), over("head"), anchor("lead")}),
       "pin block head block head lead "},
      {tackle(4, {anchor("pin"), falls(4, "block", "head"), anchor("lead")}), "pin block head block head lead "},
      {tackle(2, {anchor("pin"), parts(2, over("block")), anchor("lead")}), "pin block lead "},
  };
  for (const auto& [machine, names] : rows) {
    const auto model = compile(machine);
    ASSERT_TRUE(model) << complaints_of(machine);
    const Reeving& r = model->reevings[0];
    EXPECT_EQ(names_of(r), names);
    for (const Node& n : r.nodes) {
      if (n.kind != NodeKind::contact || r.nodes[0].name != "lead") continue;
      EXPECT_EQ(n.side, 1) << names << n.name;
    }
  }
}

TEST(Compile, SidesFollowTheBendAndMirror) {
  // a block on a corner: the sheave lies on the inner side
  for (const double mirror : {1.0, -1.0}) {
    Machine m = tackle(1, {anchor("lead"), over("head"), anchor("pin")});
    m.bodies[0].free = {};
    m.points[0].at = {-10 * mirror, 0, 0};
    m.points[1].at = {3 * mirror, 0, 0};
    EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, mirror > 0 ? 1 : -1);
    m.sheaves[0].axis = {0, -1, 0};
    EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, mirror > 0 ? -1 : 1);
    m.reevings[0].path[1].side = description::Side::left;
    EXPECT_EQ(compile(m)->reevings[0].nodes[1].side, -1);
  }
}

TEST(Compile, FreedomsGuidesLoadsAndTemperature) {
  Machine m = tackle(6, {anchor("lead"), falls(6, "head", "block"), anchor("pin")});
  m.bodies[0].free = {"ry"};
  m.bodies[0].guide = Triple{0, 0, 2};
  m.loads = {{.at = "eye", .mass = 100.0, .force = {}}, {.at = "hook", .mass = {}, .force = Triple{1, 2, 3}}};
  m.take_up = {{.body = "hook", .weight = 50.0, .screw = {}, .along = {2, 0, 0}}};
  m.temperature = 303.15;
  m.ropes[0].reference_temperature = 283.15;
  m.gravity = 10;
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  ASSERT_EQ(model->bodies[0].free.size(), 2U);
  EXPECT_EQ(model->bodies[0].free[0].about, Vector3::UnitY());
  EXPECT_EQ(model->bodies[0].free[1].along, Vector3::UnitZ());
  EXPECT_EQ(model->loads[0].force, Vector3(0, 0, -1000));
  EXPECT_EQ(model->loads[0].at.at, Vector3(0, 0, 0.3));
  EXPECT_EQ(model->loads[1].force, Vector3(1, 2, 3));
  EXPECT_EQ(model->loads[2].force, Vector3(500, 0, 0));
  EXPECT_DOUBLE_EQ(model->reevings[0].thermal_strain, 1.2e-5 * 20);
  m.ropes[0].reference_temperature = {};
  EXPECT_EQ(compile(m)->reevings[0].thermal_strain, 0) << "its length holds at the machine's temperature";
}

TEST(Compile, GuysStandBehindTheReevings) {
  Machine m = line();
  m.guys = {{.name = "g1",
             .rope = "main",
             .from = "head",
             .to = "tail",
             .install = description::Install{.tension = 3e3, .at = description::InstallAt::anchor},
             .length = {}},
            {.name = "g2", .rope = "main", .from = "tail", .to = "head", .install = {}, .length = 120.0}};
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  EXPECT_EQ(model->reevings[2].given, Given::tension_at_end);
  EXPECT_EQ(model->reevings[2].value, 3e3);
  EXPECT_EQ(model->reevings[3].given, Given::length);
  EXPECT_EQ(names_of(model->reevings[3]), "tail head ");
}

TEST(Compile, ClampsWithoutALengthStandAtTheirShareOfTheWay) {
  Machine m = line();
  m.carriages[0].hold = description::Hold::clamped;
  m.carriages[0].mainline = {};
  m.reevings.pop_back();
  const auto model = compile(m);
  ASSERT_TRUE(model) << complaints_of(m);
  const double before = std::hypot(30, 6);
  const double all = std::hypot(60, 12) + std::hypot(40, 8);
  EXPECT_NEAR(model->reevings[0].nodes[1].length_before, 103 * before / all, 1e-9);
  m.carriages[0].length_before = 20;
  EXPECT_EQ(compile(m)->reevings[0].nodes[1].length_before, 20);
}

TEST(Compile, TellsEachMistakeAtItsPath) {
  struct Row {
    void (*spoil)(Machine&);
    std::string expected;
  };
  const std::vector<Row> rows = {
      {.spoil = [](Machine& m) { m.points[0].body = "bom"; }, .expected = "points.head.body: there is no body 'bom'"},
      {.spoil = [](Machine& m) { m.reevings[0].path[0] = anchor("haed"); },
       .expected = "reevings[0].path[0].anchor: there is no point, body, carriage, sheave or support 'haed'; did you "
                   "mean 'head'?"},
      {.spoil = [](Machine& m) { m.reevings[0].path[2] = over("head"); },
       .expected = "reevings[0].path[2].over: 'head' is a point; here a sheave or support is named"},
      {.spoil =
           [](Machine& m) {
             m.sheaves.push_back({});
             m.sheaves.back().name = "head";
             m.sheaves.back().at = {0, 0, 99};
           },
       .expected = "reevings[0].path[0].anchor: 'head' is a point and, at another place, a sheave or support: rename "
                   "one of them"},
      {.spoil = [](Machine& m) { m.reevings[0].rope = "skylin"; },
       .expected = "reevings[0].rope: there is no rope 'skylin'; did you mean"},
      {.spoil = [](Machine& m) { m.reevings[0].length = {}; }, .expected = "reevings[0]: needs one of length"},
      {.spoil = [](Machine& m) { m.reevings[0].tension_at_end = 3; },
       .expected = "reevings[0]: has length and tension_at_end"},
      {.spoil =
           [](Machine& m) {
             m.drums[0].drive =
                 description::Drive{.speed = {}, .torque = {}, .pull = "4 kN", .brake = description::Brake::open};
           },
       .expected = "reevings[1]: has tension_at_start and the pull of its first drum"},
      {.spoil =
           [](Machine& m) {  // the torque of its drum is no rope's alone
             m.drums[0].drive =
                 description::Drive{.speed = {}, .torque = "2 kN m", .pull = {}, .brake = description::Brake::open};
             m.reevings[1].tension_at_start = {};
             m.reevings.push_back(m.reevings[1]);
             m.reevings[2].name = "beside";
           },
       .expected = "reevings[1]: needs one of length"},
      {.spoil = [](Machine& m) { m.reevings[0].path.pop_back(); },
       .expected = "reevings[0].path[2]: a rope's first and last"},
      {.spoil = [](Machine& m) { m.reevings[0].path[2] = anchor("head"); },
       .expected = "reevings[0].path[2]: a rope is fixed at its ends"},
      {.spoil = [](Machine& m) { m.reevings[0].path[2].parts = 4; },
       .expected = "reevings[0].path[2].parts: no sheave is beside this one"},
      {.spoil = [](Machine& m) { m.reevings[0].path[2] = falls(4, "jack", "jack"); },
       .expected = "path[2].between: two sheaves"},
      {.spoil = [](Machine& m) { m.reevings[0].path[2] = falls(1, "jack", "head"); },
       .expected = "path[2].between: belongs to a tackle of two 'parts' or more"},
      {.spoil = [](Machine& m) { m.reevings[0].path[1] = over("jack"); },
       .expected = "carriages.car: the path of the rope it rides on goes past"},
      {.spoil = [](Machine& m) { m.supports[0].motor.emplace(); },
       .expected = "reevings[0]: runs over a sheave with a motor: needs two of"},
      {.spoil =
           [](Machine& m) {
             m.supports[0].motor.emplace();
             m.supports[0].motor->speed = "3 m/s";
           },
       .expected = "or the motor's 'torque' in place of its 'speed'; it has"},
      {.spoil =
           [](Machine& m) {
             m.supports[0].motor.emplace();
             m.supports[0].motor->speed = "3 m/s";
           },
       .expected = "A motion can begin with the torque, and an event at its start give the speed: events"},
      {.spoil = [](Machine& m) { m.carriages[0].rides = "main"; },
       .expected = "carriages.car: rides on 'main', but the path of 'skyline'"},
      {.spoil = [](Machine& m) { m.carriages[0].mainline = "skyline"; },
       .expected = "carriages.car.mainline: the path of 'skyline' does not"},
      {.spoil = [](Machine& m) { m.carriages[0].length_before = 3; },
       .expected = "carriages.car.length_before: belongs to"},
      {.spoil = [](Machine& m) { m.ropes[0].mass = {}; }, .expected = "ropes.skyline: says neither"},
      {.spoil = [](Machine& m) { m.ropes[0].stiffness = {}; }, .expected = "ropes.skyline: lacks its 'stiffness', EA"},
      {.spoil = [](Machine& m) { m.ropes[0].rope = "EN 12385-4|6x36-IWRC|20|1961"; },
       .expected = "ropes.skyline.rope: "},
      {.spoil =
           [](Machine& m) {
             m.bodies = {{.name = "hook",
                          .mass = 1.0,
                          .at = {0, 0, 1},
                          .centre = {},
                          .free = {"z"},
                          .guide = {},
                          .inertia = {},
                          .motion = {}}};
           },
       .expected = "bodies.hook: may move, but no rope runs to it"},
      {.spoil =
           [](Machine& m) {
             m.supports[0].axis = {0, 0, 0};
           },
       .expected = "supports.jack.axis: the axis is zero"},
      {.spoil = [](Machine& m) { m.supports[0].efficiency = 0.9; },
       .expected = "supports.jack.efficiency: belongs to 'law: sheave'; a saddle does not turn: give its 'friction'"},
      {.spoil = [](Machine& m) { m.supports[0].inertia = 2; }, .expected = "supports.jack.inertia: belongs to"},
      {.spoil = [](Machine& m) { m.supports[0].drag = 2; }, .expected = "supports.jack.drag: belongs to"},
      {.spoil = [](Machine& m) { m.supports[0].motor.emplace(); }, .expected = "supports.jack.motor: belongs to"},
      {.spoil = [](Machine& m) { m.loads = {{.at = "head", .mass = 3.0, .force = {}}}; },
       .expected = "loads[0].at: 'head' is fixed to the ground"},
      {.spoil = [](Machine& m) { m.loads = {{.at = "cat", .mass = 3.0, .force = {}}}; },
       .expected = "loads[0].at: there is no body"},
      {.spoil = [](Machine& m) { m.reevings[1].rope = "skyline"; },
       .expected = "reevings[1]: another rope is called 'skyline'"},
      {.spoil =
           [](Machine& m) {
             m.beams.emplace_back();
             m.beams.back().name = "skyline";
             m.beams.back().from = "foot";
             m.beams.back().to = "head";
             m.beams.back().section = "CHS 168.3x6.3";
           },
       .expected = "beams.skyline: a rope is called so too"},
      {.spoil =
           [](Machine& m) {
             m.points[1].at = {60, 0, 22};
           },
       .expected = "reevings[0].path: 'jack' and 'tail' are at the same place"},
      {.spoil =
           [](Machine& m) {
             m.terrain = description::Terrain{.file = {}, .x = {0, 5, 4}, .z = {0, 0, 0}, .from = {}, .along = {}};
           },
       .expected = "terrain.x[2]: x has to grow"},
      {.spoil =
           [](Machine& m) {
             m.terrain = description::Terrain{.file = {}, .x = {0, 5}, .z = {0}, .from = {}, .along = {}};
           },
       .expected = "terrain.z: 1 heights for 2 places"},
      {.spoil = [](Machine& m) { m.reevings.clear(), m.carriages.clear(); }, .expected = "the machine has no rope"},
  };
  for (const Row& row : rows) {
    Machine m = line();
    row.spoil(m);
    EXPECT_NE(complaints_of(m).find(row.expected), std::string::npos) << row.expected << "\n" << complaints_of(m);
  }
  Machine m = tackle(2, {anchor("pin"), parts(2, over("block")), anchor("lead")});
  m.bodies[0].free = {"rx", "ry"};
  EXPECT_NE(complaints_of(m).find("bodies.hook.free: one rotation or all three"), std::string::npos);
  m.bodies[0].free = {"x", "x"};
  EXPECT_NE(complaints_of(m).find("bodies.hook.free: 'x' stands there twice"), std::string::npos);
  m.bodies[0].free = {"x"};
  m.bodies[0].guide = Triple{0, 0, 1};
  EXPECT_NE(complaints_of(m).find("bodies.hook.guide: a body on a guide"), std::string::npos);
}

TEST(Compile, TellsAllMistakesAtOnce) {
  Machine m = line();
  m.ropes[0].mass = {};
  m.reevings[0].path[0] = anchor("x");
  m.reevings[1].tension_at_start = {};
  m.loads = {{.at = "nothing", .mass = 1.0, .force = {}}};
  const auto model = compile(m);
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().size(), 4U) << complaints_of(m);
}

}  // namespace taut::machine::compile_test
