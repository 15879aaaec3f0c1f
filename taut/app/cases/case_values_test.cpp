#include "taut/app/cases/case_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace taut::app::case_values_test {

using testing::HasSubstr;

Value value_of(const std::string& name, double x, const std::string& label = {}) {
  Value v;
  v.name = name;
  v.value = x;
  v.unit = si::N;
  v.label = label;
  return v;
}

/// A tension, the same of a second analysis, and a check.
Result some() {
  Result r;
  r.values = {value_of("sky.T_max", 3e3, "largest tension"), value_of("sky.T_max_2", 5e3)};
  Check c;
  c.name = "sky.safety_factor";
  c.value = 4;
  c.utilisation = 0.75;
  c.rule = "at least 3";
  r.checks = {c};
  return r;
}

TEST(CaseValues, AreFoundByNameByTheEndingOfTheirAnalysisAndAsChecks) {
  const std::vector<WantedValue> wanted = {
      {.output = 2, .name = "sky.T_max", .ending = "", .place = ""},
      {.output = 0, .name = "sky.safety_factor", .ending = "", .place = ""},
      {.output = 1, .name = "sky.safety_factor.utilisation", .ending = "", .place = ""}};
  std::vector<double> outputs(3, 0);
  ASSERT_TRUE(take_values(some(), wanted, outputs).ok());
  EXPECT_THAT(outputs, testing::ElementsAre(4, 0.75, 3e3));
  Result second = some();
  second.values.erase(second.values.begin());
  ASSERT_TRUE(take_values(second, {{.output = 0, .name = "sky.T_max", .ending = "_2", .place = ""}}, outputs).ok());
  EXPECT_EQ(outputs[0], 5e3);
}

// The value is of the tension at rest, the check of the peak that it has to hold: 9.8 beside 5.5 of a winch.
TEST(CaseValues, WhereChecksComeFirstTheirNumberIsTaken) {
  Result r = some();
  r.values.push_back(value_of("sky.safety_factor", 9));
  WantedValue wanted{.output = 0, .name = "sky.safety_factor", .ending = "", .place = ""};
  std::vector<double> outputs(1, 0);
  ASSERT_TRUE(take_values(r, {wanted}, outputs).ok());
  EXPECT_EQ(outputs[0], 9);
  wanted.checks_first = true;
  ASSERT_TRUE(take_values(r, {wanted}, outputs).ok());
  EXPECT_EQ(outputs[0], 4);
  CaseModel made;
  made.outputs.resize(1);
  NoCases wrong;
  add_outputs(r, {wanted}, made, wrong);
  EXPECT_EQ(made.outputs[0].base, 4);
  wanted.name = "sky.T_max";
  ASSERT_TRUE(take_values(r, {wanted}, outputs).ok());
  EXPECT_EQ(outputs[0], 3e3) << "what no check has is a value";
}

TEST(CaseValues, AValueIsAskedForOnceWhateverItsSpelling) {
  CaseModel made;
  for (const char* name : {"equilibrium_2.sky.T_max", "equilibrium_2.sky.T_max_2"}) {
    made.outputs.push_back({.name = name, .unit = {}, .label = {}});
  }
  Result second = some();
  second.values.erase(second.values.begin());
  NoCases wrong;
  add_outputs(second,
              {{.output = 0, .name = "sky.T_max", .ending = "_2", .place = "study.of[0]"},
               {.output = 1, .name = "sky.T_max_2", .ending = "_2", .place = "study.of[1]"}},
              made, wrong);
  ASSERT_EQ(wrong.complaints.size(), 1U);
  EXPECT_EQ(wrong.complaints[0].path, "study.of[1]");
  EXPECT_THAT(wrong.complaints[0].message, HasSubstr("is the same value as 'equilibrium_2.sky.T_max'"));
}

TEST(CaseValues, WhatKeepsAResultFromPassingIsItsFlaw) {
  Result r = some();
  r.checks[0].passes = true;
  EXPECT_TRUE(flaws_of(r, Display()).empty());
  Check broken =
      make_check("sky.T_max", 12e3, si::N, {.sense = Sense::at_most, .limit = 10e3, .rule = "breaks", .trust = "user"});
  broken.limits = false;
  r.checks.push_back(broken);
  r.unmade = {"no angle", "no clearance"};
  warn_unsafe(r, "it is slack");
  const auto flaws = flaws_of(r, Display());
  ASSERT_EQ(flaws.size(), 3U);
  EXPECT_EQ(flaws[0].kind, CaseFlaw::Kind::fails);
  EXPECT_EQ(flaws[0].check, "sky.T_max");
  EXPECT_TRUE(flaws[0].fact);
  EXPECT_EQ(flaws[0].words, "12 kN, limit at most 10 kN: breaks");
  EXPECT_EQ(flaws[1].words, "no angle");
  EXPECT_EQ(flaws[2].words, "it is slack");
}

TEST(CaseValues, ACaseWithoutOneOfThemHasNoAnswer) {
  std::vector<double> outputs(1, 0);
  const WantedValue wanted{.output = 0, .name = "sky.T_min", .ending = "", .place = ""};
  const Outcome missing = take_values(some(), {wanted}, outputs);
  EXPECT_EQ(missing.status, Status::infeasible);
  EXPECT_THAT(missing.message, HasSubstr("'sky.T_min'"));
  Result none = some();
  none.values[0].value = std::nan("");
  EXPECT_FALSE(take_values(none, {{.output = 0, .name = "sky.T_max", .ending = "", .place = ""}}, outputs).ok());
  Result failed;
  failed.status = Status::not_converged;
  failed.message = "why";
  const Outcome outcome = take_values(failed, {wanted}, outputs);
  EXPECT_EQ(outcome.status, Status::not_converged);
  EXPECT_EQ(outcome.message, "why");
}

TEST(CaseValues, AnUnknownOutputIsToldAtItsPlaceWithWhatThereIs) {
  CaseModel made;
  made.outputs.resize(1);
  NoCases wrong;
  add_outputs(some(), {{.output = 0, .name = "sky.T_maxx", .ending = "", .place = "study.of[0]"}}, made, wrong);
  ASSERT_EQ(wrong.complaints.size(), 1U);
  EXPECT_EQ(wrong.complaints[0].path, "study.of[0]");
  EXPECT_THAT(wrong.complaints[0].message, HasSubstr("did you mean 'sky.T_max'"));
  wrong = {};
  add_outputs(some(), {{.output = 0, .name = "sky.T_max", .ending = "", .place = ""}}, made, wrong);
  EXPECT_TRUE(wrong.complaints.empty());
  EXPECT_EQ(made.outputs[0].label, "largest tension");
  EXPECT_EQ(made.outputs[0].base, 3e3);
}

TEST(CaseValues, AnAssignmentHasEveryDigit) {
  const CaseInput travel{.path = "parameters.travel", .unit = si::m, .range = {}, .base = 3};
  EXPECT_EQ(assignment(travel, 0.1), "parameters.travel=0.10000000000000001 m");
  const CaseInput share{.path = "parameters.share", .unit = si::one, .range = {}, .base = 0.5};
  EXPECT_EQ(assignment(share, 0.25), "parameters.share=0.25");
  const CaseInput grade{.path = "parameters.grade", .unit = si::one.in("%"), .range = {}, .base = 0.3};
  EXPECT_EQ(assignment(grade, 0.25), "parameters.grade=25 %");
}

// A case that lost a state of which its deck asks can't be judged, whatever its other numbers say.
TEST(CaseValues, ACaseWithoutOneOfItsStatesIsNoAnswer) {
  Result r;
  r.missing.push_back({"positions", 1, 3, "x = 40 m", "the roller lifts off"});
  std::vector<double> outputs;
  const Outcome outcome = take_values(r, {}, outputs);
  EXPECT_EQ(outcome.status, Status::infeasible);
  EXPECT_EQ(outcome.message, "positions, x = 40 m: the roller lifts off");
}

TEST(CaseValues, AParameterIsSetInTheUnitThatItsFormulasCountIn) {
  const CaseInput winter{.path = "parameters.winter", .unit = si::K.in("degC"), .range = {}, .base = 253.15};
  EXPECT_EQ(assignment(winter, 273.15), "parameters.winter=0 degC");
  const CaseInput rise{.path = "parameters.rise", .unit = si::K, .range = {}, .base = 5};
  EXPECT_EQ(assignment(rise, 5), "parameters.rise=5 K");
}

}  // namespace taut::app::case_values_test
