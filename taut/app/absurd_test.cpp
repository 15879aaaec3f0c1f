#include "taut/app/absurd.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "taut/app/job.hpp"

namespace taut::app::absurd_test {

/// A single span with a clamped load, with more parts and another way between its ends.
struct Line {
  std::string head = "[0 m, 0 m, 18 m]", tail = "[250 m, 0 m, 120 m]";
  std::string length = "272 m";
  std::string points, more;
};

std::string deck_of(const Line& line) {
  return fmt::format(R"(taut: 1
machine:
  points: {{head: {}, tail: {}{}}}
  ropes: {{skyline: {{mass: 1.8 kg/m, stiffness: 26.6 MN}}{}
  carriages: {{car: {{mass: 220 kg, rides: skyline, hold: clamped}}}}
  reevings: [{{rope: skyline, path: [{{anchor: head}}, {{through: car}}, {{anchor: tail}}], length: {}}}]
  loads: [{{at: car, mass: 1 t}}]
analyses: [{{equilibrium: {{carriage: car, x: 125 m}}}}]
)",
                     line.head, line.tail, line.points, line.more.empty() ? "}" : line.more, line.length);
}

/// The warnings, one a line.
std::string warned(const std::string& deck) {
  const Result r = run(Job{.text = deck, .name = "deck.yaml", .set = {}});
  EXPECT_EQ(to_text(r.errors), "") << deck;
  std::string all;
  for (const std::string& one : r.warnings) all += one + "\n";
  return all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Absurd, AnOrdinaryLineHasNothing) { EXPECT_EQ(warned(deck_of({})), ""); }

TEST(Absurd, ASaddleThatSaysNothingOfItsFriction) {
  const auto over = [](const std::string& jack) {
    return warned(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 0 m], b: [100 m, 0 m, 0 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 20 MN}}
  supports: {jack: {at: [50 m, 0 m, 5 m])" +
                  jack + R"(}}
  reevings: [{rope: line, path: [{anchor: a}, {over: jack}, {anchor: b}], tension_at_start: 50 kN}]
)");
  };
  EXPECT_TRUE(has(over(""), "slips over 'jack' without friction")) << over("");
  EXPECT_FALSE(has(over(", friction: 0"), "without friction"));
  EXPECT_FALSE(has(over(", law: sheave"), "without friction"));
}

TEST(Absurd, WhatBelongsToAMotionOrATemperatureThatIsNotThere) {
  Line line;
  line.more =
      ", old: {mass: 1 kg/m, stiffness: 5 MN, reference_temperature: 20 degC}}\n"
      "  guys: {g: {rope: old, from: head, to: tail, length: 280 m}}\n"
      "  signals: {haul: {ramp: {to: 1 m/s, start: 0 s, duration: 1 s}}}\n"
      "  events: [{at: 1 s, break: skyline}]\n"
      "  observe: [car.z]";
  const std::string reported = warned(deck_of(line));
  for (const char* part :
       {"'events' belongs to motions", "'observe' belongs to motions", "signal 'haul' is used by nothing",
        "the 'reference_temperature' of 'old' counts only in analyses that say a temperature"}) {
    EXPECT_TRUE(has(reported, part)) << part << "\n" << reported;
  }
  line.more += "\n  temperature: 10 degC";
  EXPECT_FALSE(has(warned(deck_of(line)), "reference_temperature"));
}

TEST(Absurd, PartsThatNothingUses) {
  Line line;
  line.points = ", spare: [1 m, 0 m, 1 m]";
  line.more =
      ", hoist: {mass: 1 kg/m, stiffness: 5 MN}}\n"
      "  bodies: {crate: {mass: 5 kg, at: [0 m, 0 m, 0 m]}, frame: {at: [9 m, 0 m, 0 m]}}\n"
      "  sheaves: {block: {at: [10 m, 0 m, 5 m], diameter: 400 mm}}\n"
      "  supports: {jack: {body: frame, at: [10 m, 0 m, 5 m], friction: 0.1}}\n"
      "  drums: {winch: {at: [0 m, 0 m, 1 m], core_diameter: 400 mm}}";
  const std::string reported = warned(deck_of(line));
  for (const char* part :
       {"sheave 'block' touches no rope", "support 'jack' touches no rope", "drum 'winch' has no rope",
        "point 'spare' is used by nothing", "rope 'hoist' is on no path", "body 'crate' is used by nothing"}) {
    EXPECT_TRUE(has(reported, part)) << part << "\n" << reported;
  }
  EXPECT_FALSE(has(reported, "'frame'")) << "the support stands on it\n" << reported;
}

TEST(Absurd, WhatIsObservedIsUsed) {
  Line line;
  line.points = ", spare: [1 m, 0 m, 1 m]";
  line.more = "}\n  observe: [spare.x]";
  EXPECT_FALSE(has(warned(deck_of(line)), "'spare'"));
}

TEST(Absurd, ARopeShorterThanItsWay) {
  Line line;
  line.length = "250 m";
  EXPECT_TRUE(has(warned(deck_of(line)), "rope 'skyline' is shorter than its way: 250 m of rope for 270.01 m"))
      << warned(deck_of(line));
  line.length = "270.01 m";
  EXPECT_FALSE(has(warned(deck_of(line)), "shorter")) << warned(deck_of(line));
}

TEST(Absurd, TheWayOverASheaveCountsItsArc) {
  const auto over = [](double length) {
    return fmt::format(R"(taut: 1
machine:
  points: {{a: [0 m, 0 m, 0 m], b: [2 m, 0 m, 0 m]}}
  ropes: {{line: {{mass: 1 kg/m, stiffness: 10 MN}}}}
  sheaves: {{top: {{at: [1 m, 0 m, 10 m], diameter: 2 m}}}}
  reevings: [{{rope: line, path: [{{anchor: a}}, {{over: top}}, {{anchor: b}}], length: {} m}}]
)",
                       length);
  };
  // 10 m up, half the circle, 10 m down
  EXPECT_TRUE(has(warned(over(23.14)), "23.14 m of rope for 23.142 m")) << warned(over(23.14));
  EXPECT_EQ(warned(over(23.15)), "");
}

TEST(Absurd, TheWayOfAnEndlessRopeOrOfAHookIsNotKnown) {
  const std::string hook = R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 10 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 10 MN}}
  bodies: {hook: {mass: 100 kg, at: [0 m, 0 m, 1 m], free: [x, z]}}
  reevings: [{rope: line, path: [{anchor: a}, {anchor: hook}], length: 5 m}]
)";
  EXPECT_EQ(warned(hook), "");
}

TEST(Absurd, ZIsUp) {
  Line line;
  line.head = "[0 m, 18 m, 0 m]";
  line.tail = "[250 m, 120 m, 0 m]";
  EXPECT_TRUE(has(warned(deck_of(line)), "z is 0 everywhere and y is used along 'skyline'"));
  line.tail = "[250 m, 120 m, 1 m]";
  EXPECT_FALSE(has(warned(deck_of(line)), "z is 0"));
  line.head = "[0 m, 0 m, 0 m]";
  line.tail = "[270 m, 0 m, 0 m]";
  EXPECT_FALSE(has(warned(deck_of(line)), "z is 0")) << "level, and y not used";
}

// A hook 5 m below: z is used, and is up.
TEST(Absurd, AFreeBodyBelowMakesAMachineUpright) {
  const std::string deck = R"(taut: 1
machine:
  points: {a: [-10 m, 0 m, 0 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 10 MN}}
  bodies: {hook: {mass: 4 t, at: [0.2 m, 0.2 m, -5 m], free: [z]}}
  sheaves: {head: {at: [0 m, 0.2 m, 0 m], diameter: 400 mm}}
  reevings: [{rope: line, path: [{anchor: a}, {over: head}, {anchor: hook}], length: 15.3 m}]
)";
  EXPECT_FALSE(has(warned(deck), "z is 0")) << warned(deck);
  EXPECT_TRUE(has(warned(std::regex_replace(deck, std::regex("-5 m"), "0 m")), "z is 0 everywhere"));
}

// Drawn in to the left the bunch rubs against the mainline; by a direction to the right it would help it.
TEST(Absurd, ABunchThatTravelsAwayFromItsMainline) {
  const auto deck = [](const char* along) {
    return fmt::format(R"(taut: 1
machine:
  points: {{head: [0 m, 0 m, 18 m], tail: [250 m, 0 m, 60 m]}}
  ropes:
    skyline: {{mass: 1.8 kg/m, stiffness: 26.6 MN}}
    main: {{mass: 0.6 kg/m, stiffness: 7 MN}}
  drums: {{winch: {{at: [-1 m, 0 m, 17 m]}}}}
  carriages: {{car: {{mass: 220 kg, rides: skyline, mainline: main, at: [125 m, 0 m, 30 m]}}}}
  reevings:
    - {{rope: skyline, path: [{{anchor: head}}, {{through: car}}, {{anchor: tail}}], length: 260 m}}
    - {{rope: main, path: [{{drum: winch}}, {{anchor: car}}], length: 128 m}}
  loads: [{{at: car, mass: 1 t, dragged: {{ground_angle: 10 deg, friction: 0.6, along: {}}}}}]
analyses: [{{equilibrium: {{}}}}]
)",
                       along);
  };
  EXPECT_EQ(warned(deck("[-1, 0]")), "");
  EXPECT_TRUE(has(warned(deck("[1, 0]")), "points away from 'main', the mainline of 'car'"));
  EXPECT_TRUE(has(warned(deck("[0.17, 0.98]")), "goes across the line of 'car'"));
  // on a hook below the carriage too
  const std::string hook = std::regex_replace(
      std::regex_replace(deck("[1, 0]"), std::regex("at: car, mass"), "at: hook, mass"), std::regex("  reevings:\n"),
      "  bodies: {hook: {mass: 20 kg, at: [125 m, 0 m, 28 m], free: [x, y, z]}}\n  reevings:\n"
      "    - {rope: main, name: drop, path: [{anchor: car}, {anchor: hook}], length: 2 m}\n");
  EXPECT_TRUE(has(warned(hook), "points away from 'main'")) << hook;
  const Result none = run(Job{
      .text = std::regex_replace(deck("[1, 0]"), std::regex(", along: .1, 0."), ""), .name = "deck.yaml", .set = {}});
  EXPECT_TRUE(has(to_text(none.errors), "along")) << to_text(none.errors);
}

TEST(Absurd, ARopeThatLiesFlatOnItsSheaves) {
  const std::string flat = R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 0 m], b: [9 m, 8 m, 0 m]}
  ropes: {line: {mass: 1 kg/m, stiffness: 10 MN}}
  sheaves: {corner: {at: [9 m, 0 m, 0 m], diameter: 300 mm, axis: [0, 0, 1]}}
  reevings: [{rope: line, path: [{anchor: a}, {over: corner, side: right}, {anchor: b}], length: 17.3 m}]
)";
  EXPECT_EQ(warned(flat), "");
  const std::string reported = warned(std::regex_replace(flat, std::regex("17.3 m"), "18 m"));
  EXPECT_TRUE(has(reported, "line runs 30.07 deg out of the plane of 'corner'")) << reported;
}

TEST(Absurd, ASupportInTheGround) {
  const std::string deck = R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 20 m], tail: [100 m, 0 m, -2 m]}
  ropes: {skyline: {mass: 1.8 kg/m, stiffness: 26.6 MN}}
  supports: {jack: {at: [60 m, 0 m, 9 m], diameter: 300 mm, friction: 0.1}}
  reevings: [{rope: skyline, path: [{anchor: head}, {over: jack}, {anchor: tail}], tension_at_start: 60 kN}]
  terrain: {x: [0 m, 60 m, 100 m], z: [0 m, 0 m, 0 m]}
analyses: [{equilibrium: {motion: at_rest}}]
)";
  EXPECT_EQ(warned(deck).find("below the ground"), std::string::npos) << "an anchor may be buried";
  const std::string low = warned(std::regex_replace(deck, std::regex("0 m, 0 m, 0 m\\]}"), "0 m, 11 m, 0 m]}"));
  EXPECT_TRUE(has(low, "'jack' is 2 m below the ground")) << low;
}

TEST(Absurd, ASagOfMoreThanHalfTheSpan) {
  Line line;
  line.tail = "[250 m, 0 m, 18 m]";
  line.length = "500 m";
  const std::string reported = warned(deck_of(line));
  EXPECT_TRUE(has(reported, "rope 'skyline' sags by 21") && has(reported, "between 'head' and 'tail', 250 m apart"))
      << reported;
  line.length = "300 m";
  EXPECT_FALSE(has(warned(deck_of(line)), "sags")) << warned(deck_of(line));
}

}  // namespace taut::app::absurd_test
