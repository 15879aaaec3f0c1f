#include <fmt/format.h>
#include <gtest/gtest.h>

#include "test/support/machine_decks.hpp"

/// What keys of motions are refused for, and what they may leave out.
namespace taut_test::motion_keys_test {

/// 2 t that stand on a cylinder: it bears 20 kN at rest.
std::string deck(const std::string& cylinder, const std::string& analyses, const std::string& events = "") {
  return fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {{foot: [0 m, 0 m, 0 m], hook: [3 m, 0 m, 3 m]}}
  bodies:
    b: {{mass: 2 t, at: [0 m, 0 m, 2 m], guide: [0, 0, 1]}}
    other: {{mass: 1 t, at: [3 m, 0 m, 0 m], free: [z]}}
  ropes: {{r: {{mass: 0 kg/m, stiffness: 10 MN}}}}
  reevings: [{{rope: r, path: [{{anchor: hook}}, {{anchor: other}}], length: 3 m}}]
  actuators: {{c: {{from: foot, to: b, {}}}}}
{}  observe: [c.F]
analyses: {}
)",
                     cylinder, events.empty() ? events : fmt::format("  events: {}\n", events), analyses);
}

constexpr const char* at_rest = "[equilibrium: {}]";
constexpr const char* stiff = "lock_stiffness: 50 MN/m, lock_damping: 500 kN s/m";

std::string errors_of(const std::string& text) {
  const taut::Result r = run_text(text);
  EXPECT_EQ(r.status, taut::Status::bad_deck);
  return to_text(r.errors);
}

TEST(MotionKeys, ALockedCylinderNeedsNothingThatMovesIt) {
  const std::string motion = "[transient: {duration: 0.5 s, output_step: 0.1 s}]";
  const std::string locked = fmt::format("mode: lock, {}", stiff);
  const taut::Result r = run_text(deck(locked, motion));
  ASSERT_EQ(r.status, taut::Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(value_of(r, "c.F_max"), 20e3, 1);
  EXPECT_EQ(run_text(deck(locked, motion, "[{at: 0.1 s, actuator: c, mode: free}]")).status, taut::Status::ok);
  EXPECT_NE(errors_of(deck(locked, motion, "[{at: 0.1 s, actuator: c, mode: extend}]"))
                .find("needs one of force, law, speed: 'events[0]' sets its mode to extend"),
            std::string::npos);
  EXPECT_NE(errors_of(deck(stiff, at_rest)).find("needs one of force, law, speed, unless its 'mode' is lock or free"),
            std::string::npos);
  EXPECT_NE(errors_of(deck("force: 1 kN, speed: 0 m/s, " + locked, at_rest)).find("give one of force, law, speed"),
            std::string::npos);
}

/// A file that the run writes besides would be written over the state, or the state over it.
TEST(MotionKeys, AStateIsSavedInAFileOfItsOwn) {
  const std::string locked = fmt::format("mode: lock, {}", stiff);
  const auto saved = [&](const std::string& name, const std::string& second) {
    return deck(locked,
                fmt::format("[transient: {{duration: 0.2 s, save: {}}}, transient: {{name: two, duration: 0.2 s, "
                            "save: {}}}]",
                            name, second));
  };
  const taut::Result r = run_text(saved("one.json", "two.json"));
  EXPECT_EQ(r.attachments.size(), 2U) << r.message << to_text(r.errors);
  EXPECT_NE(errors_of(saved("time.csv", "two.json")).find("name it as in 'state.json'"), std::string::npos);
  EXPECT_NE(errors_of(saved("report.md", "two.json")).find("another file of the results"), std::string::npos);
  EXPECT_NE(errors_of(saved("s.json", "s.json")).find("analyses[0] saves its state in 's.json' too"),
            std::string::npos);
}

}  // namespace taut_test::motion_keys_test
