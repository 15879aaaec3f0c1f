#include "taut/app/cases/read_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "taut/app/methods.hpp"

namespace taut::app::read_cases_test {

using testing::HasSubstr;

const std::string machine =
    "taut: 1\n"
    "parameters: {span: 200 m}\n"
    "machine:\n"
    "  points: {tail: [0 m, 0 m, 0 m], head: [= span, 0 m, 30 m]}\n"
    "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN}}\n"
    "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
    "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
    "study:\n"
    "  vary: {machine.carriages.car.mass: {normal: {mean: 1 t, cov: 10 %}}}\n"
    "  of: [equilibrium.sky.T_startt]\n";

Job job_of(const std::string& text, std::vector<std::string> set = {}) {
  return {.text = text, .name = "deck.yaml", .set = std::move(set), .progress = {}, .read = {}};
}

TEST(ReadCases, AMistakeOfTheDeckIsToldAtItsPlace) {
  std::string text = machine;
  text.replace(text.find("stiffness"), 9, "stifness");
  const auto read = read_cases(job_of(text));
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().status, Status::bad_deck);
  EXPECT_THAT(to_text(read.error().errors), HasSubstr("deck.yaml:5:"));
}

TEST(ReadCases, AnOutputThatIsNotThereIsToldWhereTheBlockHasIt) {
  const auto read = read_cases(job_of(machine));
  ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
  const auto made =
      read->cases({.inputs = {{.name = "machine.carriages.car.mass", .place = "study.vary.machine.carriages.car.mass"}},
                   .outputs = {{.name = "equilibrium.sky.T_startt", .place = "study.of[0]"}}});
  ASSERT_FALSE(made.has_value());
  const Result r = refusal(made.error(), read->blocks());
  EXPECT_EQ(r.status, Status::bad_deck);
  EXPECT_THAT(to_text(r.errors), HasSubstr("deck.yaml:10:"));
  EXPECT_THAT(to_text(r.errors), HasSubstr("did you mean 'sky.T_start'"));
}

TEST(ReadCases, ANumberHasOnePlaceUnderAllSpellings) {
  const auto of_machine = read_cases(job_of(machine));
  ASSERT_TRUE(of_machine.has_value()) << to_text(of_machine.error().errors);
  const std::vector<std::vector<std::string>> same = {
      {"machine.reevings[0].length", "machine.reevings.0.length", "machine.reevings.sky.length",
       "machine.reevings[sky].length"},
      {"machine.points.head.z", "machine.points.head[2]", "machine.points[head].at.z", "machine.points.head.at[2]"},
      {"machine.ropes.sky.stiffness", "machine.ropes[sky].stiffness"},
      {"machine.ropes.sky.mass"},
      {"machine.carriages.car.mass"},
      {"parameters.span"},
      {"machine.points.head.x"},
      {"machine.points.head.angle"}};
  std::set<std::string> places;
  for (const auto& spellings : same) {
    for (const std::string& one : spellings) {
      EXPECT_EQ(of_machine->place_of(one), of_machine->place_of(spellings[0])) << one;
    }
    places.insert(of_machine->place_of(spellings[0]));
  }
  EXPECT_EQ(places.size(), same.size()) << "other numbers have other places";
  EXPECT_EQ(of_machine->place_of("machine.reevings.sky.lenght"), "machine.reevings.sky.lenght") << "leads nowhere";
}

TEST(ReadCases, ANumberIsAskedForOnce) {
  const auto read = read_cases(job_of(machine));
  ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
  const auto made = read->cases({.inputs = {{.name = "machine.reevings.sky.length", .place = ""},
                                            {.name = "parameters.span", .place = ""},
                                            {.name = "machine.reevings[0].length", .place = "study.vary.second"}},
                                 .outputs = {{.name = "equilibrium.sky.T_start", .place = ""}}});
  ASSERT_FALSE(made.has_value());
  ASSERT_EQ(made.error().complaints.size(), 1U);
  EXPECT_EQ(made.error().complaints[0].path, "study.vary.second");
  EXPECT_THAT(made.error().complaints[0].message,
              testing::AllOf(HasSubstr("'machine.reevings[0].length'"), HasSubstr("'machine.reevings.sky.length'")));
}

TEST(ReadCases, AParameterOfExpressionsIsAnInput) {
  const auto read = read_cases(job_of(machine));
  ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
  const auto made = read->cases({.inputs = {{.name = "parameters.span", .place = ""}},
                                 .outputs = {{.name = "equilibrium.sky.T_start", .place = ""}}});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->inputs[0].base, 200);
  const auto longer = read_cases(job_of(machine, {"parameters.span=202 m"}));
  const auto expected = longer->cases({.inputs = {{.name = "parameters.span", .place = ""}},
                                       .outputs = {{.name = "equilibrium.sky.T_start", .place = ""}}});
  EXPECT_NEAR(made->answer(std::vector<double>{202}).outputs[0], expected->outputs[0].base,
              1e-8 * expected->outputs[0].base);
  const auto none = read->cases({.inputs = {{.name = "parameters.spam", .place = "here"}},
                                 .outputs = {{.name = "equilibrium.sky.T_start", .place = ""}}});
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().complaints[0].path, "here");
}

TEST(ReadCases, WhatWasSetMakesAnotherHash) {
  const auto plain = read_cases(job_of(machine)), again = read_cases(job_of(machine)),
             set = read_cases(job_of(machine, {"machine.carriages.car.mass=300 kg"}));
  EXPECT_EQ(plain->hash, again->hash);
  EXPECT_NE(plain->hash, set->hash);
}

TEST(ReadCases, OfAMethodAreItsInputsAndResults) {
  const auto read = read_cases(job_of(std::string(find_method("closed_loop")->example)));
  ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
  EXPECT_TRUE(std::holds_alternative<MethodDeck>(read->of));
  EXPECT_EQ(read->place_of("gathering_force"), read->place_of("input.gathering_force"));
  const auto made = read->cases(
      {.inputs = {{.name = "input.gathering_force", .place = ""}}, .outputs = {{.name = "T_lA", .place = ""}}});
  ASSERT_TRUE(made.has_value());
  const double base = made->inputs[0].base;
  EXPECT_EQ(made->answer(std::vector<double>{base}).outputs[0], made->outputs[0].base);
  EXPECT_NE(made->answer(std::vector<double>{1.1 * base}).outputs[0], made->outputs[0].base);
}

}  // namespace taut::app::read_cases_test
