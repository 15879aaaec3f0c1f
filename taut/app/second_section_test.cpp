#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

#include "taut/app/job.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::second_section_test {

/// A running skyline with a carriage in two sections, 3 m apart on the return rope.
std::string two_sections(const std::string& tail, const std::string& analysis) {
  return fmt::format(R"(taut: 1
machine:
  points: {{winch: [0 m, 0 m, 20 m]}}
  ropes:
    traction: {{mass: 1.5 kg/m, stiffness: 24 MN}}
    return: {{mass: 1 kg/m, stiffness: 16 MN}}
  sheaves: {{tail: {{at: [{}, 0 m, 20 m], diameter: 400 mm, efficiency: 0.9}}}}
  carriages:
    first: {{mass: 90 kg, rides: return, hold: rolling, mainline: traction}}
    second: {{mass: 40 kg, rides: return, hold: clamped, length_before: 3 m}}
  reevings:
    - {{rope: traction, path: [{{anchor: winch}}, {{anchor: first}}], length: 100 m}}
    - {{rope: return, path: [{{anchor: first}}, {{through: second}}, {{over: tail}}, {{through: first}}, {{anchor: winch}}],
       tension_at_end: 62 kN, haul: to_start}}
  loads: [{{at: second, force: [14.7 kN, 0 kN, -25.5 kN]}}]
analyses:
  - {}
)",
                     tail, analysis);
}

/// A running skyline: the rope that carries the carriage comes back to it over the tail block.
std::string running_skyline(double x) {
  return fmt::format(R"(taut: 1
machine:
  points: {{tower: [0 m, 0 m, 12 m], winch: [-3 m, 0 m, 1 m]}}
  ropes:
    haulback: {{mass: 0.8 kg/m, stiffness: 9.8 MN}}
    mainline: {{mass: 0.6 kg/m, stiffness: 7.2 MN}}
  sheaves:
    tower_sheave: {{at: [0 m, 0 m, 13 m], diameter: 300 mm}}
    tail_block: {{at: [200 m, 0 m, 40 m], diameter: 300 mm}}
  carriages:
    car: {{mass: 250 kg, rides: haulback, hold: rolling, mainline: mainline, at: [100 m, 0 m, 22 m]}}
  reevings:
    - {{rope: haulback, path: [{{anchor: winch}}, {{over: tower_sheave}}, {{through: car}}, {{over: tail_block}}, {{anchor: car}}],
       tension_at_start: 25 kN}}
    - {{rope: mainline, path: [{{anchor: tower}}, {{anchor: car}}], length: 102 m}}
  loads: [{{at: car, mass: 900 kg}}]
analyses: [{{equilibrium: {{carriage: car, x: {} m}}}}]
)",
                     x);
}

std::string reported(const std::string& deck) {
  const Result r = run(Job{.text = deck, .name = "deck.yaml", .set = {}});
  return fmt::format("{}: {}{}{}", r.status == Status::ok ? "ok" : "no", r.message, to_text(r.errors),
                     r.missing.empty() ? std::string{} : r.missing.front().reason);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SecondSection, NoPlaceOfItIsPastTheSheave) {
  const auto path = [](const char* to, int steps) {
    return reported(two_sections(
        "200 m", fmt::format("load_path: {{carriage: first, from: 30 m, to: {}, steps: {}, motion: in}}", to, steps)));
  };
  EXPECT_TRUE(has(path("190 m", 8), "ok"));
  const std::string words = path("198 m", 70);
  EXPECT_TRUE(has(words, "'second'") && has(words, "past 'tail'")) << words;
}

TEST(SecondSection, ACarriageOutsideItsRopeIsRefusedByName) {
  for (const char* analysis :
       {"equilibrium: {carriage: first, x: 100 m, z: 10 m}", "equilibrium: {carriage: first, x: 100 m}",
        "load_path: {carriage: first, from: 20 m, to: 40 m, steps: 2}"}) {
    const std::string words = reported(two_sections("-200 m", analysis));
    EXPECT_TRUE(has(words, "no: ") && has(words, "'first'") && has(words, "'winch'")) << words;
  }
}

TEST(SecondSection, ACarriagePastTheNextSheaveIsRefusedByName) {
  EXPECT_TRUE(has(reported(running_skyline(199)), "ok")) << reported(running_skyline(199));
  const std::string words = reported(running_skyline(201));
  EXPECT_TRUE(has(words, "'car'") && has(words, "'tail_block'")) << words;
}

/// An endless haul rope whose guide stands where its drive is: neighbours only when the carriage is elsewhere.
TEST(SecondSection, SheavesAtOnePlaceThatBecomeNeighboursAreRefusedByName) {
  const auto haul = [](const char* guide, int x,
                       const std::string& analysis = "equilibrium: {motion: in, carriage: car, x: X m}") {
    return fmt::format(R"(taut: 1
machine:
  points: {{valley: [0 m, 0 m, 14 m], top: [420 m, 0 m, 122 m]}}
  ropes:
    track: {{mass: 2 kg/m, stiffness: 29 MN}}
    haul: {{mass: 0.4 kg/m, stiffness: 5 MN}}
  bodies: {{slide: {{mass: 250 kg, at: [420 m, 0 m, 119 m], guide: [1, 0, 0]}}}}
  supports: {{shoe: {{at: [190 m, 0 m, 66 m], diameter: 6 m, friction: 0.12}}}}
  sheaves:
    drive: {{at: [0 m, 0 m, 10 m], diameter: 800 mm, friction: 0.3, motor: {{}}}}
    guide: {{at: {}, diameter: 250 mm, efficiency: 0.98, uplift: lift}}
    return: {{body: slide, at: [0 m, 0 m, 0 m], diameter: 800 mm, efficiency: 0.96}}
  carriages:
    car: {{mass: 260 kg, rides: track, hold: fixed_to, fixed_to: haul, rollers: 2, wheelbase: 0.9 m, height: 0.6 m}}
  reevings:
    - {{rope: track, path: [{{anchor: valley}}, {{through: car}}, {{over: shoe}}, {{anchor: top}}], length: 437.5 m}}
    - {{rope: haul, path: [{{over: drive}}, {{through: car}}, {{over: guide, side: right}}, {{over: return}}], closed: true, length: 869 m}}
  take_up: [{{body: slide, weight: 3.4 t, along: [1, 0, 0]}}]
  loads: [{{at: car, mass: 900 kg}}]
analyses: [{{{}}}]
)",
                       guide, std::regex_replace(analysis, std::regex("X"), std::to_string(x)));
  };
  EXPECT_TRUE(has(reported(haul("[190 m, 0 m, 62 m]", 300)), "ok")) << reported(haul("[190 m, 0 m, 62 m]", 300));
  // a load path past the guide: the carriage is another node of the haul rope behind it
  const Result past = taut_test::run_text(
      haul("[250 m, 0 m, 62 m]", 400, "load_path: {carriage: car, from: 210 m, to: X m, steps: 19, motion: in}"));
  EXPECT_NE(past.find_table("load_path"), nullptr) << past.message << to_text(past.errors);
  const std::string words = reported(haul("[0 m, 0 m, 10 m]", 300));
  EXPECT_TRUE(has(words, "no: ") && has(words, "'drive'") && has(words, "'guide'") && has(words, "0 m apart")) << words;
}

}  // namespace taut::app::second_section_test
