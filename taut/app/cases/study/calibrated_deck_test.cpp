#include "taut/app/cases/study/calibrated_deck.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/app/cases/read_cases.hpp"
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

/// What differs from fit to fit: the first number, and a bound of the second.
struct FreeNumbers {
  std::string first = length;
  Unit unit = si::m;
  double least_stiffness = 5e6;
};

/// Numbers of a fit that was made elsewhere: 204.6 m +- 0.1 m and 18 MN +- 0.5 MN, with this correlation.
std::string calibrated(const Job& job, double correlation, const FreeNumbers& of = {}) {
  const auto read = read_cases(job);
  if (!read) throw std::runtime_error(read.error().message + to_text(read.error().errors) + job.text);
  CaseModel model;
  model.inputs = {{.path = of.first, .unit = of.unit, .range = {}, .base = 205},
                  {.path = stiffness, .unit = si::N, .range = {.low = 0, .low_included = false}, .base = 20e6}};
  model.outputs = {{.name = "equilibrium.sky.T_start", .unit = si::N, .label = {}}};
  chance::Calibration found;
  found.parameters.resize(2);
  found.parameters[0].value = 204.6;
  found.parameters[0].standard_error = found.parameters[0].spread = 0.1;
  found.parameters[1].value = 18e6;
  found.parameters[1].standard_error = found.parameters[1].spread = 0.5e6;
  const double both = correlation * 0.1 * 0.5e6;
  found.covariance = {0.01, both, both, 0.25e12};
  return calibrated_deck(
      *read, model,
      {{.name = of.first, .low = 203, .high = 207}, {.name = stiffness, .low = of.least_stiffness, .high = 60e6}},
      found);
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

std::vector<std::string> paths_of(const Study& study) {
  std::vector<std::string> paths;
  paths.reserve(study.model.inputs.size());
  for (const CaseInput& one : study.model.inputs) paths.push_back(one.path);
  return paths;
}

/// The text with another one in place of a part that it has once.
std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos || text.find(part, at + 1) != std::string::npos) throw std::runtime_error(part + text);
  return text.replace(at, part.size(), by);
}

// Each key of a deck may be set, also one that the deck does not have: none of them belongs to the machine.
TEST(CalibratedDeck, AKeyOfTheDeckThatWasSetStandsAtItsTop) {
  const Job job = job_of(deck_with(ropes, ""), "deck.yaml", {"title=Other", "display.force=N", "project.author=Ada"});
  const Study study = study_of(calibrated(job, 0));
  EXPECT_EQ(study.title, "Other");
  EXPECT_EQ(study.display.units().at("force"), "N");
  EXPECT_EQ(study.project.author, "Ada");
}

/// The deck whose length is an expression.
std::string deck_by(const std::string& expression, const std::string& more) {
  return replaced(deck_with(ropes, more), "length: 205 m", "length: '" + expression + "'");
}

TEST(CalibratedDeck, AParameterWhoseOnlyUseWasTheNumberFoundIsLeftOut) {
  const std::string text = calibrated(job_of(deck_by("= len", "parameters: {len: 205 m}\n")), 0);
  EXPECT_NEAR(study_of(text).model.inputs[0].base, 204.6, 1e-9);
  EXPECT_THAT(text, testing::Not(HasSubstr("\nparameters:")));
  EXPECT_THAT(text, HasSubstr("\n# - parameters.len: nothing in this deck uses it\n"));
}

TEST(CalibratedDeck, AParameterGoesWithAllThatServedItAloneAndOthersStay) {
  const std::string more =
      "parameters: {chord: 200 m, slack: 2 m, len: '= chord + spare', spare: '= slack + 3 m', heavy: 2 t}\n";
  const std::string deck = replaced(deck_by("= len", more), "mass: 1 t", "mass: = heavy");
  const std::string text = calibrated(job_of(replaced(deck, "[200 m, 0 m, 30 m]", "[= chord, 0 m, 30 m]")), 0);
  EXPECT_NO_THROW(study_of(text));
  EXPECT_THAT(text, HasSubstr("\n  chord: 200 m\n  heavy: 2 t\n"));
  for (const char* gone : {"\n  len:", "\n  slack:", "\n  spare:"}) EXPECT_THAT(text, testing::Not(HasSubstr(gone)));
}

TEST(CalibratedDeck, AParameterThatNothingUsesAnyMoreDoesNotVaryEither) {
  const std::string study =
      "parameters: {len: 205 m, mean: 1 t}\n"
      "study:\n"
      "  vary:\n"
      "    parameters.len: {normal: {mean: 205 m, sd: 1 m}}\n"
      "    machine.loads[0].mass: {normal: {mean: = mean, cov: 5 %}}\n"
      "  correlate: [[parameters.len, 'machine.loads[0].mass', 0.3]]\n"
      "  of: [equilibrium.car.z]\n";
  const Study after = study_of(calibrated(job_of(deck_by("= len", study)), 0));
  EXPECT_THAT(paths_of(after), testing::ElementsAre("machine.loads[0].mass", length, stiffness));
  EXPECT_EQ(std::get<chance::Normal>(after.inputs.of[0].law).mean, 1000);
  EXPECT_TRUE(chance::independent(after.inputs.correlation));
}

// An included deck may have parameters that nothing uses; a deck of one file may not.
TEST(CalibratedDeck, WhatAnIncludedDeckLeftUnusedIsLeftOut) {
  const taut_test::ScratchFolder scratch;
  std::ofstream(scratch.path() / "ropes.yaml") << "parameters: {spare: 3 m}\nmachine:\n" << ropes;
  const Job job = job_of(deck_with("", "include: ropes.yaml\n"), (scratch.path() / "deck.yaml").string());
  EXPECT_NO_THROW(study_of(calibrated(job, 0)));
}

TEST(CalibratedDeck, FilesThatTheDoorGivesAreReadByIt) {
  Job job = job_of(deck_with("", "include: ropes.yaml\n"));
  job.read = [](const std::string&) -> tl::expected<std::string, io::Unreadable> { return "machine:\n" + ropes; };
  EXPECT_THAT(calibrated(job, 0), HasSubstr("mass: 1.5 kg/m"));
}

/// A study of the mass and the stiffness, with these lines more.
std::string study_with(const std::string& more) {
  return "study:\n"
         "  vary:\n"
         "    machine.loads[0].mass: {normal: {mean: 1 t, cov: 5 %}}\n"
         "    " +
         stiffness +
         ": {normal: {mean: 20 MN, cov: 20 %}}\n"
         "  of: [equilibrium.car.z]\n" +
         more;
}

TEST(CalibratedDeck, ItsCorrelationReplacesThatOfTheDeckInEitherOrder) {
  const std::string free_length = "    " + length + ": {uniform: {low: 204 m, high: 206 m}}\n  of:";
  for (const std::string& pair : {fmt::format("{}, {}", length, stiffness), fmt::format("{}, {}", stiffness, length)}) {
    const std::string study = study_with(fmt::format("  correlate: [{{pair: [{}, 0.3]}}]\n", pair));
    const std::string text = calibrated(job_of(deck_with(ropes, replaced(study, "  of:", free_length))), -0.8);
    const Study after = study_of(text);
    EXPECT_THAT(paths_of(after), testing::ElementsAre("machine.loads[0].mass", stiffness, length));
    EXPECT_NEAR(after.inputs.correlation.lower[7], -0.8, 1e-9);
    EXPECT_THAT(text, HasSubstr(fmt::format("# - study.correlate: [{}, 0.3] gives way to that of the fit\n", pair)));
  }
}

TEST(CalibratedDeck, CanBeCalibratedAgain) {
  const std::string first = calibrated(job_of(deck_with(ropes, "")), 0.5);
  const std::string free =
      "calibrate: {free: {" + length + ": [203 m, 207 m], " + stiffness + ": [5 MN, 60 MN]}, measured: m.csv}\n";
  const Study again = study_of(calibrated(job_of(first + free), -0.6));
  ASSERT_EQ(again.model.inputs.size(), 2U);
  EXPECT_NEAR(again.inputs.correlation.lower[2], -0.6, 1e-9);
  EXPECT_TRUE(chance::independent(study_of(calibrated(job_of(first + free), 0)).inputs.correlation))
      << "the fit knows that they are independent";
}

// 0.9 with each of two numbers needs at least 2 * 0.9^2 - 1 = 0.62 between them.
TEST(CalibratedDeck, ACorrelationWithAnotherInputStaysUnlessItContradictsTheFit) {
  const std::string study =
      replaced(study_with("  correlate: [['machine.loads[0].mass', " + stiffness +
                          ", 0.9], ['machine.loads[0].mass', " + length + ", = much]]\n" + "parameters: {much: 0.9}\n"),
               "  of:", "    " + length + ": {uniform: {low: 204 m, high: 206 m}}\n  of:");
  const Study both = study_of(calibrated(job_of(deck_with(ropes, study)), 0.7));
  EXPECT_NEAR(both.inputs.correlation.lower[3], 0.9, 1e-9);
  EXPECT_NEAR(both.inputs.correlation.lower[6], 0.9, 1e-9);
  const std::string text = calibrated(job_of(deck_with(ropes, study)), 0.5);
  const Study fit = study_of(text);
  EXPECT_EQ(fit.inputs.correlation.lower[3], 0);
  EXPECT_EQ(fit.inputs.correlation.lower[6], 0);
  EXPECT_NEAR(fit.inputs.correlation.lower[7], 0.5, 1e-9);
  EXPECT_THAT(text, HasSubstr(", 0.9] contradicts the correlation of the fit\n"));
}

// 1 - r is less than the sixth digit shows
TEST(CalibratedDeck, ACorrelationNextToOneIsNotRoundedToOne) {
  const Study study = study_of(calibrated(job_of(deck_with(ropes, "")), 0.99999999));
  EXPECT_NEAR(study.inputs.correlation.lower[2], 0.99999999, 1e-11);
}

// A law of which half lies outside of the number's range is refused.
TEST(CalibratedDeck, ALawEndsWhereTheNumberDoes) {
  const Study study = study_of(calibrated(job_of(deck_with(ropes, "")), 0, {.least_stiffness = -60e6}));
  EXPECT_EQ(study.inputs.of[1].from, 0);
}

TEST(CalibratedDeck, AsksForNoIndicesOfCorrelatedInputs) {
  const Job both = job_of(deck_with(ropes, study_with("  answer: [indices, quantiles]\n")));
  const Job alone = job_of(deck_with(ropes, study_with("  answer: [indices]\n")));
  EXPECT_THAT(study_of(calibrated(both, 0)).request.answer, testing::ElementsAre("indices", "quantiles"));
  EXPECT_THAT(study_of(calibrated(both, 0.5)).request.answer, testing::ElementsAre("quantiles"));
  EXPECT_THAT(study_of(calibrated(alone, 0.5)).request.answer, testing::ElementsAre("quantiles"));
  EXPECT_THAT(calibrated(alone, 0.5), HasSubstr("# - study.answer: 'indices' are of independent inputs"));
}

TEST(CalibratedDeck, AGridBecomesASampleAndItsListsStay) {
  const std::string study =
      "study:\n"
      "  vary:\n"
      "    machine.loads[0].mass: {list: [0.5 t, 1 t, 2 t]}\n"
      "    " +
      length + ": {from: 204 m, to: 206 m, steps: 4}\n  points: grid\n  of: [equilibrium.car.z]\n";
  const std::string text = calibrated(job_of(deck_with(ropes, study)), 0.5);
  const Study after = study_of(text);
  EXPECT_EQ(after.request.points, StudyPoints::sobol);
  EXPECT_THAT(paths_of(after), testing::ElementsAre("machine.loads[0].mass", length, stiffness));
  EXPECT_EQ(std::get<chance::Listed>(after.inputs.of[0].law).values.size(), 3U);
  EXPECT_THAT(text, HasSubstr("# - study.points: a grid is made of single values"));
}

/// The tension that a deck's own run has.
double tension_of(const std::string& text) {
  const Result r = run(job_of(text));
  const Value* T = r.find_value("sky.T_start");
  if (T == nullptr) throw std::runtime_error(r.message + to_text(r.errors) + text);
  return T->value;
}

// 204.6 K found where the deck has 15 degC: the rope of 205 m at 15 degC is 0.2 m shorter.
TEST(CalibratedDeck, LengthsHoldAtTheTemperatureThatTheDeckHadInTheFit) {
  const std::string cold = "machine.temperature";
  const std::string plain = replaced(deck_with(ropes, ""), "machine:\n", "machine:\n  temperature: 15 degC\n");
  const std::string by_parameter = "parameters: {now: 15 degC}\n" + replaced(plain, "15 degC\n", "= now\n");
  const std::string own = replaced(plain, "stiffness: 20 MN", "stiffness: 20 MN, reference_temperature: 30 degC");
  for (const auto& [deck, path] :
       {std::pair(plain, cold), std::pair(by_parameter, std::string("parameters.now")), std::pair(own, cold)}) {
    const auto read = read_cases(job_of(deck));
    ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
    const auto cases =
        read->cases({.inputs = {{path, ""}, {stiffness, ""}}, .outputs = {{"equilibrium.sky.T_start", ""}}});
    ASSERT_TRUE(cases.has_value());
    const CaseAnswer fitted = cases->answer(std::vector<double>{204.6, 18e6});
    ASSERT_TRUE(fitted.outcome.ok()) << fitted.outcome.message;
    const std::string text = calibrated(job_of(deck), 0.5, {.first = path, .unit = si::K});
    EXPECT_NEAR(tension_of(text), fitted.outputs[0], 1e-6 * fitted.outputs[0]) << text;
  }
  // a deck whose temperature stays needs no reference
  EXPECT_THAT(calibrated(job_of(plain), 0.5), testing::Not(HasSubstr("reference_temperature")));
}

// The direction of a vector is no number that a deck has: its components depend on the length, too.
TEST(CalibratedDeck, SaysWhichValueFoundIsInItsLawOnly) {
  const std::string angle = "machine.loads[0].force.angle";
  const std::string deck = replaced(deck_with(ropes, ""), "mass: 1 t}", "force: [1 kN, 0 kN, -10 kN]}");
  const std::string text = calibrated(job_of(deck), 0.5, {.first = angle, .unit = si::rad});
  EXPECT_THAT(text, HasSubstr("# - " + angle + ": 204.6 rad is in its law only, not in the deck: the direction"));
  EXPECT_THAT(paths_of(study_of(text)), testing::ElementsAre(angle, stiffness));
}

TEST(CalibratedDeck, ANumberUnderAnotherSpellingIsTheSameNumber) {
  const std::string other = "machine.reevings[0].length";
  const std::string study = replaced(study_with("  correlate: [['" + other + "', 'machine.loads[0].mass', 0.4]]\n"),
                                     "  of:", "    " + other + ": {normal: {mean: 205 m, sd: 2 m}}\n  of:");
  const Study after = study_of(calibrated(job_of(deck_with(ropes, study)), 0.5));
  EXPECT_THAT(paths_of(after), testing::ElementsAre("machine.loads[0].mass", stiffness, other));
  EXPECT_NEAR(std::get<chance::Normal>(after.inputs.of[2].law).mean, 204.6, 1e-9);
  EXPECT_NEAR(after.inputs.correlation.lower[6], 0.4, 1e-9) << "with the mass, as in the deck";
  EXPECT_NEAR(after.inputs.correlation.lower[7], 0.5, 1e-9) << "with the stiffness, of the fit";
}

}  // namespace taut::app::calibrated_deck_test
