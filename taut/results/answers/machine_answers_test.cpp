#include "taut/results/answers/machine_answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "test/support/machine_decks.hpp"

namespace machine_answers_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

/// Texts of all lines with that label.
std::string lines_of(const Result& r, const std::string& label) {
  std::string all;
  for (const taut::Answer& a : r.answers) {
    if (a.label == label) all += a.text + "\n";
  }
  return all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(MachineAnswers, RopesHaveDesignationAndLength) {
  const Result r = run_text(skyline_deck("  - load_path: {carriage: car, from: 140 m, to: 220 m, steps: 2}"),
                            {"machine.ropes.skyline={rope: EN 12385-4|6x36-IWRC|20|1960, stiffness: 20 MN}"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const std::string given = lines_of(r, "Given");
  EXPECT_TRUE(has(given, "skyline EN 12385-4 6x36-IWRC 20 mm 1960 MPa, cut 382 m")) << given;
  EXPECT_TRUE(has(given, "mainline breaking force 110 kN, 0.54 kg/m, ")) << given;
  EXPECT_TRUE(has(given, " between its ends")) << "the mainline is let out: " << given;
  EXPECT_TRUE(has(lines_of(r, "Tension"), "skyline ")) << lines_of(r, "Tension");
  EXPECT_TRUE(has(lines_of(r, "Tension"), "load path")) << "the line says where";
  EXPECT_TRUE(has(lines_of(r, "Clearance"), "lowest rope"));
  EXPECT_TRUE(lines_of(r, "Build").empty());
}

// 37 m between its ends and 30 m on the drum: 67 m to order. What the winch takes in is no other rope.
TEST(MachineAnswers, WhatLiesOnTheDrumIsCutToo) {
  const auto given = [](const std::string& on_drum, const std::string& rope, const std::string& analyses) {
    const Result r = run_text(R"(taut: 1
machine:
  sheaves: {head: {at: [0 m, 0 m, 20 m], diameter: 400 mm}}
  drums: {winch: {at: [-6 m, 0 m, 1 m], core_diameter: 400 mm, face_width: 500 mm)" +
                              on_drum + R"(}}
  ropes: {hoist: {diameter: 16 mm, mass: 1 kg/m, stiffness: 13 MN}}
  bodies: {hook: {mass: 2 t, at: [0.2 m, 0 m, 3 m], free: [x, z]}}
  reevings: [{rope: hoist, path: [{drum: winch}, {over: head}, {anchor: hook}], )" +
                              rope + "}]\nanalyses: [" + analyses + "]\n");
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return lines_of(r, "Given");
  };
  const std::string rest = "equilibrium: {motion: at_rest}";
  EXPECT_TRUE(has(given(", length_on_drum: 30 m", "length: 37 m", rest), "cut 67 m (37 m between its ends)"));
  EXPECT_TRUE(has(given("", "length: 37 m", rest), "37 m between its ends and what is on the drum"));
  EXPECT_FALSE(has(given("", "length: 37 m", rest), "cut"));
}

TEST(MachineAnswers, AreInTheUnitsOfTheDeck) {
  const std::string deck = "display: {force: kgf, length: ft}\n" + skyline_deck("  - equilibrium: {motion: at_rest}");
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(has(lines_of(r, "Tension"), " kgf")) << lines_of(r, "Tension");
  EXPECT_TRUE(has(lines_of(r, "Given"), " ft")) << lines_of(r, "Given");
}

TEST(MachineAnswers, StatesThatAreNotJudgedStillHaveTensions) {
  const Result r = run_text(skyline_deck("  - equilibrium: {motion: at_rest, judge: false}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(has(lines_of(r, "Tension"), "skyline ")) << lines_of(r, "Tension");
}

TEST(MachineAnswers, ThePayloadComesFirst) {
  const std::string payload =
      "  - payload: {carriage: car, from: 140 m, to: 170 m, steps: 3, motion: in, limits: {skyline: {safety_factor: "
      "3.5}}}";
  const Result r = run_text(skyline_deck(payload), {"machine.loads[0].mass=200 kg"});
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  ASSERT_FALSE(r.answers.empty());
  EXPECT_EQ(r.answers.front().label, "Carries");
  const std::string& text = r.answers.front().text;
  EXPECT_TRUE(has(text, "t or more, least at x = ")) << text;
  EXPECT_TRUE(has(text, "governed by tension of 'skyline'")) << text;
  EXPECT_TRUE(has(text, "on top of the 0.2 t")) << text;
  EXPECT_EQ(r.key_figure, "payload_profile");
  EXPECT_EQ(r.headline, "carries " + text.substr(0, text.find("; on top")));
}

TEST(MachineAnswers, WhereNothingIsCarriedIsSaidFirst) {
  const Result r =
      run_text(skyline_deck("  - payload: {carriage: car, from: 130 m, to: 225 m, steps: 8, motion: in, "
                            "limits: {clearance: 5.5 m}, most: 30 t}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const std::string& text = r.answers.front().text;
  EXPECT_EQ(r.answers.front().label, "Carries");
  if (value_of(r, "payload_min") == 0) {
    EXPECT_TRUE(text.starts_with("nothing ")) << text;
    EXPECT_TRUE(has(text, "elsewhere ") || !has(text, " t or more")) << text;
  } else {
    FAIL() << "the deck is meant to have a place where nothing is carried: " << text;
  }
}

TEST(MachineAnswers, PlacesWithoutAnAnswerAreCounted) {
  // pulled from the upper end: beyond the lowest point of the line it has to be pushed
  const Result r = run_text(R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 20 m], b: [100 m, 0 m, 20 m], high: [100 m, 0 m, 21 m]}
  ropes:
    line: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 100 kN}
    pull: {mass: 0 kg/m, stiffness: 2 MN, breaking_force: 50 kN}
  drums: {winch: {at: [100 m, 0 m, 21 m], core_diameter: 0 mm}}
  carriages: {car: {mass: 200 kg, rides: line, hold: rolling, mainline: pull}}
  reevings:
    - {rope: line, path: [{anchor: a}, {through: car}, {anchor: b}], length: 101 m}
    - {rope: pull, path: [{anchor: high}, {anchor: car}], length: 60 m}
analyses:
  - payload: {carriage: car, from: 20 m, to: 80 m, steps: 3, limits: {line: {safety_factor: 3}}}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(has(r.answers.front().text, "at 2 of 4 places; the others have no answer")) << r.answers.front().text;
}

TEST(MachineAnswers, AMotionEndsWithForcesFirst) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 10 m], hook: {at: [0 m, 0 m, 0 m], body: log}}
  ropes: {line: {mass: 0 kg/m, stiffness: 1 MN, breaking_force: 100 kN, damping_ratio: 0.05}}
  bodies: {log: {mass: 100 kg, at: [0 m, 0 m, 0 m], free: [z]}}
  reevings:
    - {rope: line, path: [{anchor: top}, {anchor: hook}], length: 10 m}
  observe: [log.vz, log.z, line.T_max]
analyses:
  - transient: {duration: 0.1 s, output_step: 0.05 s}
)");
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const std::string end = lines_of(r, "At the end");
  const std::size_t force = end.find("line.T_max"), place = end.find("log.z"), speed = end.find("log.vz");
  ASSERT_NE(speed, std::string::npos) << end;
  EXPECT_LT(force, place) << end;
  EXPECT_LT(place, speed) << end;
}

TEST(MachineAnswers, SeveralAnalysesHaveTheirHeadings) {
  const Result r =
      run_text(skyline_deck("  - equilibrium: {motion: at_rest}\n  - equilibrium: {motion: in, name: haul}\n"
                            "  - sweep: {parameter: \"loads[0].mass\", from: 0 kg, to: 200 kg, steps: 2}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(table_of(r, "spans").heading, "equilibrium, at rest");
  EXPECT_EQ(table_of(r, "spans_haul").heading, "equilibrium haul, in");
  EXPECT_EQ(table_of(r, "sweep").heading, "sweep");
  EXPECT_EQ(r.find_value("skyline.T_start_haul")->heading, "equilibrium haul, in");
  EXPECT_TRUE(r.find_value("T_max")->heading.empty()) << "over all states";
  const Result one = run_text(skyline_deck("  - equilibrium: {motion: at_rest}"));
  EXPECT_TRUE(table_of(one, "spans").heading.empty());
}

TEST(MachineAnswers, WhatAnAnalysisIsNotAboutIsDetail) {
  const Result r =
      run_text(skyline_deck("  - equilibrium: {motion: at_rest}\n"
                            "  - load_path: {carriage: car, from: 140 m, to: 220 m, steps: 2}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_TRUE(table_of(r, "closure").detail);
  EXPECT_TRUE(table_of(r, "bodies").detail);
  EXPECT_FALSE(table_of(r, "spans").detail);
  EXPECT_TRUE(r.find_value("skyline.T_start")->detail);
  EXPECT_FALSE(r.find_value("skyline.T_max")->detail);
  const taut::Table shown = without_detail(table_of(r, "load_path"));
  EXPECT_FALSE(table_of(r, "load_path").detail);
  std::vector<std::string> names;
  for (const taut::Column& c : shown.columns) names.push_back(c.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"x", "z", "clearance", "skyline.T_max", "mainline.T_max", "rope_clearance"}));
  EXPECT_EQ(shown.rows.front().size(), names.size());
}

}  // namespace machine_answers_test
