#include "taut/app/cases/study/study_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace taut::app::study_inputs_test {

using testing::HasSubstr;

CaseInput mass() { return {.path = "machine.loads[0].mass", .unit = si::kg, .range = {.low = 0}, .base = 1000}; }
CaseInput temperature() { return {.path = "machine.temperature", .unit = si::K, .range = {}, .base = 293.15}; }

VaryRequest normal(const std::string& name, const std::string& mean, std::optional<std::string> sd,
                   std::optional<std::string> cov = {}) {
  VaryRequest vary;
  vary.name = name;
  vary.normal = MeanRequest{.mean = mean, .sd = std::move(sd), .cov = std::move(cov)};
  return vary;
}

std::string complaints_of(const std::vector<VaryRequest>& vary, const std::vector<CaseInput>& inputs,
                          const std::vector<std::vector<std::string>>& correlate = {}) {
  StudyRequest request;
  request.vary = vary;
  for (const auto& pair : correlate) request.correlate.push_back({pair});
  std::vector<Complaint> complaints;
  study_inputs(request, inputs, complaints);
  std::string text;
  for (const Complaint& c : complaints) text += c.path + ": " + c.message + "\n";
  return text;
}

TEST(StudyInputs, LawsAreInSi) {
  StudyRequest request;
  request.vary = {normal("machine.loads[0].mass", "1.2 t", {}, "5 %"), normal("machine.temperature", "20 degC", "8 K")};
  request.vary[0].truncate = {"1 t", "1.5 t"};
  std::vector<Complaint> complaints;
  const chance::Inputs made = study_inputs(request, {mass(), temperature()}, complaints);
  ASSERT_TRUE(complaints.empty()) << complaints.front().message;
  const auto& load = std::get<chance::Normal>(made.of[0].law);
  EXPECT_DOUBLE_EQ(load.mean, 1200);
  EXPECT_DOUBLE_EQ(load.sd, 60);
  EXPECT_DOUBLE_EQ(made.of[0].from.value(), 1000);
  EXPECT_DOUBLE_EQ(made.of[0].to.value(), 1500);
  const auto& warm = std::get<chance::Normal>(made.of[1].law);
  EXPECT_DOUBLE_EQ(warm.mean, 293.15);
  EXPECT_DOUBLE_EQ(warm.sd, 8);
}

TEST(StudyInputs, StepsReachBothEnds) {
  VaryRequest vary;
  vary.name = "machine.loads[0].mass";
  vary.from = "0.5 t", vary.to = "2 t", vary.steps = 3;
  StudyRequest request;
  request.vary = {vary};
  std::vector<Complaint> complaints;
  const chance::Inputs made = study_inputs(request, {mass()}, complaints);
  ASSERT_TRUE(complaints.empty()) << complaints.front().message;
  EXPECT_THAT(std::get<chance::Listed>(made.of[0].law).values, testing::ElementsAre(500, 1000, 1500, 2000));
}

TEST(StudyInputs, TellsEachMistakeAtItsPath) {
  const std::string load = "machine.loads[0].mass", warm = "machine.temperature";
  const VaryRequest good = normal(load, "1 t", "50 kg"), also = normal(warm, "20 degC", "8 K");
  EXPECT_THAT(complaints_of({normal(load, "1 m", "50 kg")}, {mass()}),
              HasSubstr("study.vary." + load + ".normal.mean: "));
  EXPECT_THAT(complaints_of({normal(load, "1 t", {}, "5 kg")}, {mass()}), HasSubstr(".normal.cov: "));
  EXPECT_THAT(complaints_of({normal(warm, "20 degC", {}, "10 %")}, {temperature()}),
              HasSubstr("study.vary." + warm + ".normal.cov: a share of a temperature"));
  EXPECT_THAT(complaints_of({normal(warm, "20 degC", "8 degC")}, {temperature()}),
              HasSubstr("a difference of temperatures is given in K"));
  EXPECT_THAT(complaints_of({normal(load, "-1 t", "50 kg")}, {mass()}), HasSubstr("half of its values are outside"));
  EXPECT_THAT(complaints_of({good, also}, {mass(), temperature()}, {{load, "machine.temperatur", "0.5"}}),
              HasSubstr("did you mean 'machine.temperature'"));
  EXPECT_THAT(complaints_of({good, also}, {mass(), temperature()}, {{load, warm}}),
              HasSubstr("study.correlate[0]: [path, path, correlation] is expected"));
  EXPECT_EQ(complaints_of({good, also}, {mass(), temperature()}, {{load, warm, "0.5"}}), "");
}

TEST(StudyLimits, AreInSiAndOfOutputsThatAreAsked) {
  StudyRequest request;
  request.limit = {{.name = "equilibrium.sky.T_max", .at_least = {}, .at_most = "90 kN", .allowed = 1e-3}};
  const std::vector<CaseOutput> outputs = {{.name = "equilibrium.car.z", .unit = si::m, .label = {}},
                                           {.name = "equilibrium.sky.T_max", .unit = si::N, .label = {}}};
  std::vector<Complaint> complaints;
  const auto limits = study_limits(request, outputs, complaints);
  ASSERT_TRUE(complaints.empty());
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0].output, 1U);
  EXPECT_DOUBLE_EQ(limits[0].limit.value, 90e3);
  EXPECT_EQ(limits[0].limit.bound, chance::Bound::at_most);
  EXPECT_EQ(limits[0].allowed, 1e-3);
  request.limit[0].name = "equilibrium.sky.T_maxx";
  study_limits(request, outputs, complaints);
  request.limit[0] = {.name = "equilibrium.car.z", .at_least = "3 kN", .at_most = {}, .allowed = {}};
  study_limits(request, outputs, complaints);
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_THAT(complaints[0].message, HasSubstr("did you mean 'equilibrium.sky.T_max'"));
  EXPECT_EQ(complaints[1].path, "study.limit.equilibrium.car.z.at_least");
}

}  // namespace taut::app::study_inputs_test
