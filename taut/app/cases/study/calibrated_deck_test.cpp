#include "taut/app/cases/study/calibrated_deck.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/app/cases/study/study.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::calibrated_deck_test {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string length = "machine.reevings.sky.length", stiffness = "machine.ropes.sky.stiffness";
const std::string ropes = "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN}}\n";

std::string deck_with(const std::string& own_ropes, const std::string& more) {
  return "taut: 1\n"
         "machine:\n"
         "  points: {tail: [0 m, 0 m, 0 m], head: [200 m, 0 m, 30 m]}\n" +
         own_ropes +
         "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
         "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
         "  loads: [{at: car, mass: 1 t}]\n"
         "analyses: [{equilibrium: {motion: at_rest}}]\n"
         "calibrate:\n"
         "  free: {" +
         length + ": [203 m, 207 m], " + stiffness + ": [5 MN, 60 MN]}\n  measured: {file: measured.csv}\n" + more;
}

Job job_of(const std::string& text, const std::string& name = "line/deck.yaml", std::vector<std::string> set = {}) {
  return {.text = text, .name = name, .set = std::move(set), .progress = {}, .read = {}};
}

/// Numbers of a fit that was made elsewhere: 204.6 m +- 0.1 m and 18 MN +- 0.5 MN, with this correlation.
std::string calibrated(const Job& job, double correlation) {
  CaseModel model;
  model.inputs = {{.path = length, .unit = si::m, .range = {}, .base = 205},
                  {.path = stiffness, .unit = si::N, .range = {}, .base = 20e6}};
  model.outputs = {{.name = "equilibrium.sky.T_start", .unit = si::N, .label = {}}};
  chance::Calibration found;
  found.parameters.resize(2);
  found.parameters[0].value = 204.6;
  found.parameters[0].standard_error = 0.1;
  found.parameters[1].value = 18e6;
  found.parameters[1].standard_error = 0.5e6;
  const double both = correlation * 0.1 * 0.5e6;
  found.covariance = {0.01, both, both, 0.25e12};
  return calibrated_deck(
      job, model, {{.name = length, .low = 203, .high = 207}, {.name = stiffness, .low = 5e6, .high = 60e6}}, found);
}

Study study_of(const std::string& text, const std::string& name = "calibrated.yaml") {
  auto study = read_study(job_of(text, name));
  if (!study) throw std::runtime_error(study.error().message + to_text(study.error().errors) + text);
  return std::move(*study);
}

TEST(CalibratedDeck, IsAStudyOfTheNumbersFoundWithTheLawsOfTheFit) {
  const std::string text = calibrated(job_of(deck_with(ropes, "")), -0.8);
  EXPECT_THAT(text, testing::StartsWith("# Made by taut from 'deck.yaml'"));
  EXPECT_THAT(text, testing::Not(HasSubstr("calibrate:")));
  const Study study = study_of(text);
  ASSERT_EQ(study.model.inputs.size(), 2U);
  EXPECT_NEAR(study.model.inputs[0].base, 204.6, 1e-9);
  EXPECT_NEAR(study.model.inputs[1].base, 18e6, 1e-3);
  const chance::Distribution& one = study.inputs.of[0];
  EXPECT_NEAR(std::get<chance::Normal>(one.law).mean, 204.6, 1e-9);
  EXPECT_NEAR(std::get<chance::Normal>(one.law).sd, 0.1, 1e-12);
  EXPECT_NEAR(one.from.value(), 203, 1e-9);
  EXPECT_NEAR(one.to.value(), 207, 1e-9);
  EXPECT_NEAR(std::get<chance::Normal>(study.inputs.of[1].law).sd, 0.5e6, 1e-3);
  // of two scores with the correlation r, L is 1, r, sqrt(1 - r^2)
  ASSERT_EQ(study.inputs.correlation.lower.size(), 4U);
  EXPECT_NEAR(study.inputs.correlation.lower[2], -0.8, 1e-6);
  EXPECT_NEAR(study.inputs.correlation.lower[3], 0.6, 1e-6);
  EXPECT_THAT(study.request.of, testing::ElementsAre("equilibrium.sky.T_start")) << "what was measured";
}

TEST(CalibratedDeck, WithoutCorrelationTheInputsAreIndependent) {
  EXPECT_TRUE(chance::independent(study_of(calibrated(job_of(deck_with(ropes, "")), 1e-4)).inputs.correlation));
  EXPECT_FALSE(chance::independent(study_of(calibrated(job_of(deck_with(ropes, "")), 2e-3)).inputs.correlation));
}

TEST(CalibratedDeck, WhatItsStudyHadBesidesStays) {
  const std::string study =
      "study:\n"
      "  vary:\n"
      "    machine.loads[0].mass: {uniform: {low: 0.9 t, high: 1.1 t}}\n"
      "    " +
      stiffness +
      ": {normal: {mean: 20 MN, cov: 20 %}}\n"
      "  of: [equilibrium.car.z]\n"
      "  samples: 64\n"
      "  points: random\n";
  const Study after = study_of(calibrated(job_of(deck_with(ropes, study)), 0.5));
  EXPECT_THAT(after.request.of, testing::ElementsAre("equilibrium.car.z"));
  EXPECT_EQ(after.sample.count, 64U);
  std::vector<std::string> paths;
  paths.reserve(after.model.inputs.size());
  for (const CaseInput& one : after.model.inputs) paths.push_back(one.path);
  EXPECT_THAT(paths, testing::ElementsAre("machine.loads[0].mass", stiffness, length));
  EXPECT_EQ(std::get<chance::Uniform>(after.inputs.of[0].law).high, 1100);
  EXPECT_NEAR(std::get<chance::Normal>(after.inputs.of[1].law).mean, 18e6, 1e-3) << "the fit knows better";
  // the two of the fit are the second and the third
  EXPECT_NEAR(after.inputs.correlation.lower[7], 0.5, 1e-6);
  EXPECT_EQ(after.inputs.correlation.lower[3], 0);
  EXPECT_EQ(after.inputs.correlation.lower[6], 0);
}

TEST(CalibratedDeck, ValuesSetOverTheDeckStandInIt) {
  const Job job = job_of(deck_with(ropes, ""), "deck.yaml", {"machine.loads[0].mass=3 t", stiffness + "=30 MN"});
  const std::string text = calibrated(job, 0);
  const auto study = read_study(job_of(text, "calibrated.yaml"));
  ASSERT_TRUE(study.has_value()) << to_text(study.error().errors);
  EXPECT_NEAR(study->model.inputs[1].base, 18e6, 1e-3) << "what was found goes before what was set";
  const Result heavy = run(job_of(text)), light = run({.text = text,
                                                       .name = "deck.yaml",
                                                       .set = {"machine.loads[0].mass=1 t"},
                                                       .progress = {},
                                                       .read = {}});
  EXPECT_GT(heavy.find_value("sky.T_start")->value, 1.5 * light.find_value("sky.T_start")->value);
}

// The new deck may lie in another folder: what the old one names is in it, or named by its whole path.
TEST(CalibratedDeck, NeedsNoIncludeAndFindsItsFilesFromElsewhere) {
  const taut_test::ScratchFolder scratch;
  const fs::path line = scratch.path() / "line";
  fs::create_directories(line / "parts");
  std::ofstream(line / "parts" / "ropes.yaml") << "machine:\n" << ropes << "  terrain: {file: ground.csv}\n";
  std::ofstream(line / "parts" / "ground.csv") << "x,z\n-10,-60\n100,-40\n250,-30\n";
  const std::string deck = deck_with("", "include: parts/ropes.yaml\n");
  const std::string text = calibrated(job_of(deck, (line / "deck.yaml").string()), 0);
  EXPECT_THAT(text, testing::Not(HasSubstr("include")));
  EXPECT_THAT(text, HasSubstr((line / "parts" / "ground.csv").string()));
  fs::remove(line / "parts" / "ropes.yaml");
  EXPECT_NO_THROW(study_of(text, (scratch.path() / "elsewhere.yaml").string()));
}

}  // namespace taut::app::calibrated_deck_test
