#include "taut/results/machine_scene.hpp"

#include "test/support/machine_decks.hpp"

namespace machine_scene_test {

using namespace taut_test;
using taut::Result;
using taut::Role;
using taut::Scene;
using taut::SceneLine;
using taut::Status;

const SceneLine* line_of(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.lines.begin(), scene.lines.end(), [&](const auto& l) { return l.name == name; });
  return found == scene.lines.end() ? nullptr : &*found;
}

TEST(MachineScene, AMastStandsInItFromFootToTop) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {foot: [0 m, 0 m, 0 m], head: [0 m, 0 m, 16 m], west: [-20 m, 0 m, 0 m], east: [20 m, 0 m, 0 m]}
  ropes: {guy: {mass: 1 kg/m, stiffness: 20 MN}}
  beams: {mast: {from: foot, to: head, section: "CHS 323.9x10", steel: S355}}
  guys:
    w: {rope: guy, from: mast.top, to: west, install: {tension: 20 kN}}
    e: {rope: guy, from: mast.top, to: east, install: {tension: 20 kN}}
  loads: [{at: mast.top, force: [10 kN, 0 kN, 0 kN]}]
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Scene& scene = r.scenes.at(0);
  const SceneLine* mast = line_of(scene, "mast");
  ASSERT_NE(mast, nullptr);
  EXPECT_EQ(mast->role, Role::structure);
  EXPECT_TRUE(mast->tension.empty());
  const auto& points = mast->points.at(0);
  EXPECT_NEAR(points.front()[2], 0, 1e-12);
  EXPECT_NEAR(points.back()[2], 16, 0.01);
  EXPECT_GT(points.back()[0], 0.001) << "bent by its load";
  for (const auto& point : scene.points) EXPECT_NE(point.name.find("mast at"), 0U) << point.name;
}

TEST(MachineScene, ABodysLinesMoveWithIt) {
  const Result r = run_text(R"(taut: 1
machine:
  signals: {up: {ramp: {to: 0.2 m, duration: 0.3 s}}}
  bodies: {beam: {mass: 100 kg, at: [0 m, 0 m, 5 m], motion: {z: up}}}
  points: {top: [1 m, 0 m, 10 m], eye: {body: beam, at: [1 m, 0 m, 0.5 m]}}
  ropes: {sling: {mass: 0 kg/m, stiffness: 100 kN}}
  reevings: [{rope: sling, path: [{anchor: top}, {anchor: eye}], length: 4 m}]
analyses: [{transient: {duration: 0.4 s, output_step: 0.1 s}}]
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const SceneLine* line = line_of(r.scenes.at(0), "body[1]");
  ASSERT_NE(line, nullptr);
  ASSERT_EQ(line->points.size(), r.scenes[0].t.size());
  for (const auto& frame : line->points) {
    ASSERT_EQ(frame.size(), 2U);
    EXPECT_NEAR(frame[1][0] - frame[0][0], 1, 1e-9);
    EXPECT_NEAR(frame[1][2] - frame[0][2], 0.5, 1e-9);
  }
  EXPECT_GT(std::abs(line->points.back()[0][2] - line->points.front()[0][2]), 1e-3);
}

}  // namespace machine_scene_test
