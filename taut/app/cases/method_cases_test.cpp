#include "taut/app/cases/method_cases.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/app/cases/read_cases.hpp"

namespace taut::app::method_cases_test {

using testing::HasSubstr;

/// A rope-saw whose working arc is its whole wrap, so that its forces have closed forms.
const char* const deck =
    "taut: 1\n"
    "parameters: {cut: 4 kN}\n"
    "method: friction_drive\n"
    "input:\n"
    "  cutting_force: = cut\n"
    "  friction: 0.35\n"
    "  wrap: 200 deg\n"
    "  rope_mass: 0.6 kg/m\n"
    "  speed: 15 m/s\n"
    "  grip_reserve: 1.3\n";

constexpr double wrap = 200 * std::numbers::pi / 180;

/// What pulls the idler of a drive that does not slip: T_1 + T_2 - 2 c with T_2 - c = m P/(e - 1), T_1 = T_2 + P.
double takeup(double P, double friction) { return P + 2 * 1.3 * P / std::expm1(friction * wrap); }

ReadCases read(const std::string& more = "", const std::vector<std::string>& set = {}) {
  auto made = read_cases({.text = deck + more, .name = "deck.yaml", .set = set, .progress = {}, .read = {}});
  if (!made) throw std::runtime_error(made.error().message + to_text(made.error().errors));
  return std::move(*made);
}

/// Inputs and outputs, each with its place in a study.
CaseQuestion question_of(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  CaseQuestion q;
  for (const std::string& one : inputs) q.inputs.push_back({.name = one, .place = "study.vary." + one});
  for (const std::string& one : outputs) {
    q.outputs.push_back({.name = one, .place = fmt::format("study.of[{}]", q.outputs.size())});
  }
  return q;
}

MadeCases cases_of(const ReadCases& read, const std::vector<std::string>& inputs,
                   const std::vector<std::string>& outputs) {
  return method_cases(std::get<MethodDeck>(read.of), question_of(inputs, outputs), {});
}

std::vector<std::string> lines_of(const MadeCases& made) {
  std::vector<std::string> lines;
  if (made) return lines;
  for (const Complaint& c : made.error().complaints) lines.push_back(c.path + ": " + c.message);
  if (lines.empty()) lines.push_back(made.error().outcome.message);
  return lines;
}

TEST(MethodCases, AnswersAreThoseOfTheClosedForm) {
  const auto made =
      cases_of(read(), {"input.friction", "input.speed", "input.wrap"}, {"c", "takeup_no_slip", "euler_ratio"});
  ASSERT_TRUE(made.has_value()) << lines_of(made)[0];
  EXPECT_NEAR(made->inputs[2].base, wrap, 1e-12);
  EXPECT_NEAR(made->outputs[1].base, takeup(4e3, 0.35), 1e-8);
  for (const double friction : {0.1, 0.35, 0.8}) {
    const CaseAnswer a = made->answer(std::vector<double>{friction, 20, wrap});
    ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
    EXPECT_NEAR(a.outputs[0], 0.6 * 20 * 20, 1e-9);
    EXPECT_NEAR(a.outputs[1], takeup(4e3, friction), 1e-9 * takeup(4e3, friction));
  }
  const CaseAnswer half = made->answer(std::vector<double>{0.5, 20, wrap / 2});
  EXPECT_NEAR(half.outputs[2], std::exp(0.25 * wrap), 1e-9);
  EXPECT_EQ(made->answer(std::vector<double>{0.35, 15, wrap}).outputs[1], made->outputs[1].base)
      << "other cases leave nothing behind";
}

TEST(MethodCases, AParameterChangesBesideANumberOfTheInput) {
  const auto made = read().cases(question_of({"parameters.cut", "input.friction"}, {"takeup_no_slip"}));
  ASSERT_TRUE(made.has_value()) << lines_of(made)[0];
  EXPECT_EQ(made->inputs[0].base, 4e3);
  const CaseAnswer a = made->answer(std::vector<double>{7e3, 0.2});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  EXPECT_NEAR(a.outputs[0], takeup(7e3, 0.2), 1e-6);
}

TEST(MethodCases, AnOutputMayBeACheck) {
  const auto made =
      cases_of(read(), {"input.friction"}, {"checks.no slip", "slip_ratio", "checks.no slip.utilisation", "checks.e"});
  ASSERT_TRUE(made.has_value()) << lines_of(made)[0];
  const CaseAnswer a = made->answer(std::vector<double>{0.5});
  ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
  EXPECT_EQ(a.outputs[0], a.outputs[1]);
  EXPECT_NEAR(a.outputs[2], a.outputs[1] / std::exp(0.5 * wrap), 1e-12);
}

// The idler takes 8 % of the slack branch: without exp(mu alpha) > 1.08 nothing turns it, and with the reserve 1.3 the
// grip is enough from 1 + 1.3 * 0.08 on.
TEST(MethodCases, ACaseWithoutAnAnswerTellsWhyAndHasNoNumbers) {
  const std::string rope = "  rope: \"6x36-IWRC 12 mm 1960 MPa\"\n  rope_area: 65 mm^2\n";
  const auto made = cases_of(read(rope), {"input.friction", "input.rope_area"}, {"takeup_no_slip"});
  ASSERT_TRUE(made.has_value()) << lines_of(made)[0];
  const double least = std::log(1.08) / wrap, enough = std::log1p(1.3 * 0.08) / wrap, area = 65e-6;
  const CaseAnswer some = made->answer(std::vector<double>{1.001 * enough, area});
  EXPECT_TRUE(some.outcome.ok()) << some.outcome.message;
  const auto why = [&](double friction, double rope_area) {
    const CaseAnswer a = made->answer(std::vector<double>{friction, rope_area});
    EXPECT_EQ(a.outcome.status, Status::infeasible);
    EXPECT_TRUE(std::isnan(a.outputs.at(0)));
    return a.outcome.message;
  };
  EXPECT_FALSE(why(0.999 * least, area).empty());
  EXPECT_THAT(why(1.6, area), HasSubstr("friction")) << "outside its range";
  EXPECT_THAT(why(0.35, 2 * area), HasSubstr("is not the metallic area")) << "a rule between two numbers";
  const auto none = cases_of(read("", {"input.friction=0.02"}), {"input.friction"}, {"c"});
  ASSERT_FALSE(none.has_value());
  EXPECT_THAT(none.error().outcome.message, HasSubstr("the deck as it is has no answer"));
}

TEST(MethodCases, PartsWithoutALimitAreTold) {
  const auto parts_of = [](const std::string& more) {
    const auto made = cases_of(read(more), {"input.friction"}, {"takeup_no_slip"});
    EXPECT_TRUE(made.has_value()) << lines_of(made)[0];
    std::vector<std::string> names;
    for (const UnaskedPart& part : made->unasked().parts) names.push_back(part.name);
    return names;
  };
  const std::string rope = "  rope: 6x36-IWRC 20 mm 1960 MPa\n";
  EXPECT_THAT(parts_of(""), testing::ElementsAre("rope"));
  EXPECT_THAT(parts_of(rope), testing::ElementsAre("rope"));
  EXPECT_THAT(parts_of(rope + "checks: {ropes: {rope: {safety_factor: 3}}}\n"), testing::IsEmpty());
}

TEST(MethodCases, ANumberWithAndWithoutInputBeforeItIsTheSame) {
  const std::vector<std::string> lines =
      lines_of(cases_of(read(), {"input.friction", "input.wrap", "friction"}, {"c"}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(lines[0], HasSubstr("'friction' is the same number of the deck as 'input.friction'"));
}

TEST(MethodCases, WhatTheDeckDoesNotHaveIsToldAtItsPlace) {
  const auto inputs = cases_of(read(), {"input.fricton", "input.rope_area"}, {"c"});
  const std::vector<std::string> lines = lines_of(inputs);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_THAT(lines[0], testing::StartsWith("study.vary.input.fricton: "));
  EXPECT_THAT(lines[0], HasSubstr("did you mean 'friction'"));
  EXPECT_THAT(lines[1], testing::StartsWith("study.vary.input.rope_area: "));
  EXPECT_THAT(lines[1], HasSubstr("has no value in the deck"));
  const auto outputs = cases_of(read(), {"input.friction"}, {"c", "takeup_no_slipp"});
  ASSERT_EQ(lines_of(outputs).size(), 1U);
  EXPECT_THAT(lines_of(outputs)[0], testing::StartsWith("study.of[1]: "));
  EXPECT_THAT(lines_of(outputs)[0], HasSubstr("did you mean 'takeup_no_slip'"));
}

}  // namespace taut::app::method_cases_test
