#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "test/support/machine_decks.hpp"

/// Rounds without a diameter in motions: they lead and wind rope; what turns them by a moment needs their radius.
namespace taut::app::points_motion_test {

using namespace taut_test;
using testing::HasSubstr;

/// 1 t on a rope of 10 mm over a sheave to a drum.
Result hoist(const std::string& drum, const std::string& sheave, const std::string& event = "",
             const std::string& more = "") {
  return run_text(fmt::format(R"(taut: 1
machine:
  signals: {{v: {{sequence: [{{at: 0.2 s, to: 0.3 m/s, over: 0.5 s}}]}}, p: {{constant: 9806.65 N}}}}
  ropes: {{h: {{mass: 0 kg/m, stiffness: 6 MN, breaking_force: 300 kN, damping_ratio: 0.1, diameter: 10 mm}}}}
  bodies: {{L: {{mass: 1 t, at: [0 m, 0 m, 5 m], free: [z]}}}}
  sheaves: {{s: {{at: [0 m, 0 m, 20 m]{}}}}}
  drums: {{w: {{at: [-9 m, 0 m, 20 m], {}}}}}
  reevings: [{{rope: h, path: [{{drum: w}}, {{over: s}}, {{anchor: L}}]{}}}]
{}
  observe: [L.z{}]
analyses: [{{transient: {{duration: 1 s, tolerance: 1e-3}}}}]
checks: {{ropes: {{h: {{dynamic_safety_factor: 4}}}}}}
)",
                              sheave, drum, drum.find("pull") == std::string::npos ? ", length: 24 m" : "",
                              event.empty() ? "" : "  events: [" + event + "]", more));
}

TEST(PointsInMotion, AMomentOfADrumNeedsItsCore) {
  const std::vector<std::array<std::string, 4>> refused = {
      {"drive: {speed: v}, inertia: 20 kg m^2", "", "", "turns with its 'inertia': a motion needs its 'core_diameter'"},
      {"drive: {pull: p}, inertia: 20 kg m^2", "{at: 0.5 s, drive: w, torque: 1 kN m}", "",
       "an event gives it a torque: a motion needs its 'core_diameter'"},
      {"drive: {pull: p}, inertia: 20 kg m^2, brake_torque: 1 kN m", "{at: 0.5 s, brake: w}", "",
       "it needs a 'core_diameter'"},
      {"brake_torque: 1 kN m, inertia: 20 kg m^2", "", "", "it needs a 'core_diameter'"},
      {"drive: {speed: v}", "", ", w.torque", "'w.torque' needs its 'core_diameter'"}};
  for (const auto& [drum, event, more, words] : refused) {
    const Result r = hoist(drum, "", event, more);
    EXPECT_EQ(r.status, Status::bad_deck) << drum << event << r.message;
    EXPECT_THAT(to_text(r.errors), HasSubstr(words)) << drum << event;
    const Result with = hoist(drum + ", core_diameter: 400 mm", "", event, more);
    EXPECT_NE(with.status, Status::bad_deck) << to_text(with.errors);
  }
  for (const char* drum : {"drive: {speed: v}", "drive: {pull: p}", "drive: {pull: p}, inertia: 20 kg m^2",
                           "inertia: 20 kg m^2", "drive: {brake: set}"}) {
    EXPECT_EQ(hoist(drum, "").status, Status::ok) << drum;
  }
}

// Its rope stood still on it for ever: what turns a sheave without a radius is nothing.
TEST(PointsInMotion, AnInertiaOfASheaveNeedsItsDiameter) {
  const std::string drum = "core_diameter: 400 mm, drive: {speed: v}";
  const Result r = hoist(drum, ", inertia: 0.5 kg m^2");
  EXPECT_EQ(r.status, Status::bad_deck) << r.message;
  EXPECT_THAT(to_text(r.errors), HasSubstr("machine.sheaves.s.inertia"));
  EXPECT_THAT(to_text(r.errors), HasSubstr("a motion needs its 'diameter'"));
  EXPECT_EQ(hoist(drum, ", efficiency: 0.96").status, Status::ok);
  EXPECT_EQ(hoist(drum, ", inertia: 0.5 kg m^2, diameter: 300 mm").status, Status::ok);
}

// A drum in rest with the rope it holds: turns round half of its thickness are none to count.
TEST(PointsInMotion, TurnsLeftAreNotCountedRoundAPoint) {
  const Result r = hoist("drive: {speed: v}, length_on_drum: 1 m", "");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_THAT(r.unmade,
              testing::Contains(HasSubstr("how many turns are left on it is not checked: give its 'core_diameter'")));
}

}  // namespace taut::app::points_motion_test
