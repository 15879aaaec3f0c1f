#include "taut/app/cases/study/study_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace taut::app::study_words_test {

CaseInput input_of(const std::string& path, const Unit& unit) {
  return {.path = path, .unit = unit, .range = {}, .base = 0};
}

/// Inputs of these paths in a deck that shows forces in MN, masses in t and temperatures in degC.
Study study_of(const std::vector<CaseInput>& inputs) {
  Study study;
  study.model.inputs = inputs;
  study.inputs.of.resize(inputs.size());
  study.display = Display({{"force", "MN"}, {"mass", "t"}, {"temperature", "degC"}});
  return study;
}

std::string words(const chance::Distribution& d, const Unit& unit) {
  Study study = study_of({input_of("machine.ropes.sky.stiffness", unit)});
  study.inputs.of[0] = d;
  return law_in_words(study, 0);
}

TEST(StudyWords, ALawIsInTheUnitsOfTheDeck) {
  EXPECT_EQ(words({.law = chance::Normal{.mean = 20e6, .sd = 1.2e6}, .from = 15e6, .to = 25e6}, si::N),
            "normal, mean 20 MN, sd 1.2 MN, cut to 15 MN ... 25 MN");
  EXPECT_EQ(words({.law = chance::Lognormal{.mean = 1620, .sd = 81}}, si::kg), "lognormal, mean 1.62 t, sd 0.081 t");
  EXPECT_EQ(words({.law = chance::Uniform{.low = 0, .high = 1e6}}, si::N), "uniform, 0 MN to 1 MN");
  EXPECT_EQ(words({.law = chance::Gumbel{.mode = 2e6, .scale = 1e5}}, si::N), "Gumbel, mode 2 MN, scale 0.1 MN");
  EXPECT_EQ(words({.law = chance::Weibull{.shape = 1.5, .scale = 500, .shift = 1000}}, si::kg),
            "Weibull, shape 1.5, scale 0.5 t, shift 1 t");
  EXPECT_EQ(words({.law = chance::Triangular{.low = 1000, .mode = 1250, .high = 3000}}, si::kg),
            "triangular, 1 t to 3 t, most likely 1.25 t");
  EXPECT_EQ(words({.law = chance::Listed{.values = {1000, 2000, 4000}}}, si::kg), "3 values, 1 t to 4 t");
  EXPECT_EQ(words({.law = chance::Listed{.values = {2000, 4000, 1000, 3000}}}, si::kg), "4 values, 1 t to 4 t")
      << "from the smallest to the largest, wherever they stand";
}

TEST(StudyWords, ADifferenceOfTemperaturesIsInKelvin) {
  EXPECT_EQ(words({.law = chance::Normal{.mean = 293.15, .sd = 8}}, si::K), "normal, mean 20 degC, sd 8 K");
  EXPECT_EQ(words({.law = chance::Gumbel{.mode = 303.15, .scale = 2.5}}, si::K), "Gumbel, mode 30 degC, scale 2.5 K");
  EXPECT_EQ(words({.law = chance::Weibull{.shape = 2, .scale = 4, .shift = 263.15}}, si::K),
            "Weibull, shape 2, scale 4 K, shift -10 degC");
}

TEST(StudyWords, AShortNameTellsTheInputsApart) {
  const Study study =
      study_of({input_of("machine.ropes.sky.mass", si::kg_per_m), input_of("machine.carriages.sky.mass", si::kg),
                input_of("machine.loads[0].mass", si::kg), input_of("machine.loads[1].mass", si::kg),
                input_of("parameters.span", si::m), input_of("input.take_up.mass", si::kg)});
  EXPECT_EQ(short_name(study, 0), "ropes.sky.mass");
  EXPECT_EQ(short_name(study, 1), "carriages.sky.mass");
  EXPECT_EQ(short_name(study, 2), "loads[0].mass");
  EXPECT_EQ(short_name(study, 4), "parameters.span");
  EXPECT_EQ(short_name(study, 5), "take_up.mass");
  std::set<std::string> all;
  for (std::size_t i = 0; i < study.model.inputs.size(); ++i) all.insert(short_name(study, i));
  EXPECT_EQ(all.size(), study.model.inputs.size());
}

TEST(StudyWords, NumbersOfACaseAndOfALimitHaveTheirUnits) {
  Study study =
      study_of({input_of("machine.loads[0].mass", si::kg), input_of("machine.ropes.skyline.stiffness", si::N)});
  EXPECT_EQ(values_in_words(study, {1620, 19.8e6}), "loads[0].mass 1.62 t, skyline.stiffness 19.8 MN");
  EXPECT_EQ(values_in_words(study, {}), "");
  study.model.outputs = {{.name = "equilibrium.skyline.safety_factor", .unit = si::one, .label = {}},
                         {.name = "equilibrium.skyline.T_max", .unit = si::N, .label = {}}};
  const StudyLimit least{.output = 0, .limit = {.bound = chance::Bound::at_least, .value = 3}, .allowed = {}};
  const StudyLimit most{.output = 1, .limit = {.bound = chance::Bound::at_most, .value = 9e4}, .allowed = {}};
  EXPECT_EQ(beyond_in_words(study, least), "equilibrium.skyline.safety_factor below 3");
  EXPECT_EQ(beyond_in_words(study, most), "equilibrium.skyline.T_max above 0.09 MN");
}

TEST(StudyWords, AProbabilityKeepsThreeDigitsHoweverSmallItIs) {
  EXPECT_EQ(probability_in_words(0), "0");
  EXPECT_EQ(probability_in_words(1), "1");
  EXPECT_EQ(probability_in_words(0.09437), "0.0944");
  EXPECT_EQ(probability_in_words(1.234e-5), "1.23e-05");
  for (const double p : {0.999, 0.5, 0.01234, 1e-3, 9.994e-4, 1.234e-5, 4.56e-12, 7.89e-300}) {
    EXPECT_NEAR(std::stod(probability_in_words(p)), p, 0.005 * p) << probability_in_words(p);
    EXPECT_LE(probability_in_words(p).size(), 9U) << p;
  }
  EXPECT_EQ(name_ending(0, 1), "") << "a single one needs no number";
  EXPECT_EQ(name_ending(0, 2), "_1");
  EXPECT_EQ(name_ending(11, 12), "_12");
}

}  // namespace taut::app::study_words_test
