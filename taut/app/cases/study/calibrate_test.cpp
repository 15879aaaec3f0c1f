#include "taut/app/cases/study/calibrate.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>

#include "taut/app/cases/read_cases.hpp"
#include "taut/units/display.hpp"
#include "test/paths.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::calibrate_test {

using testing::HasSubstr;

constexpr double true_length = 204.6, true_stiffness = 18e6;  // m, N
constexpr double sd = 150;                                    // N

/// A skyline of one span with a load that rolls to the lowest place; two numbers are free.
std::string deck_of(const std::string& more = "") {
  return "taut: 1\n"
         "machine:\n"
         "  points: {tail: [0 m, 0 m, 0 m], head: [200 m, 0 m, 30 m]}\n"
         "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN}}\n"
         "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
         "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
         "  loads: [{at: car, mass: 1 t}]\n"
         "analyses: [{equilibrium: {motion: at_rest}}]\n"
         "calibrate:\n"
         "  free:\n"
         "    machine.reevings.sky.length: [203 m, 207 m]\n"
         "    machine.ropes.sky.stiffness: [5 MN, 60 MN]\n" +
         more + "  measured: {file: measured.csv}\n";
}

/// Tensions at both ends under six loads, calculated with the true numbers.
class Line : public testing::Test {
 protected:
  void SetUp() override {
    const auto read = read_cases({.text = deck_of(), .name = path("deck.yaml"), .set = {}, .progress = {}});
    ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
    const auto model = read->cases({.inputs = {{.name = "machine.reevings.sky.length", .place = ""},
                                               {.name = "machine.ropes.sky.stiffness", .place = ""},
                                               {.name = "machine.loads[0].mass", .place = ""}},
                                    .outputs = {{.name = "equilibrium.sky.T_start", .place = ""},
                                                {.name = "equilibrium.sky.T_end", .place = ""}}});
    ASSERT_TRUE(model.has_value());
    for (const double mass : masses) {
      const CaseAnswer a = model->answer(std::vector<double>{true_length, true_stiffness, mass});
      ASSERT_TRUE(a.outcome.ok()) << a.outcome.message;
      truth.push_back(a.outputs);
    }
  }

  std::string path(const std::string& name) const { return (scratch_.path() / name).string(); }
  void write(const std::string& csv) const { std::ofstream(path("measured.csv")) << csv; }
  Result fit(const std::string& more = "") const {
    return calibrate({.text = deck_of(more), .name = path("deck.yaml"), .set = {}, .progress = {}}, 2);
  }
  /// Twelve tensions with errors.
  std::string noisy(unsigned seed) const {
    std::mt19937 dice(seed);
    std::normal_distribution<double> error(0, sd);
    std::string csv = "output,value,sd,machine.loads[0].mass\n";
    for (std::size_t i = 0; i < masses.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        csv += fmt::format("equilibrium.sky.T_{},{:.3f} N,{} N,{} kg\n", k == 0 ? "start" : "end",
                           truth[i][k] + error(dice), sd, masses[i]);
      }
    }
    return csv;
  }

  static inline const std::vector<double> masses = {100, 400, 800, 1500, 2500, 4000};
  std::vector<std::vector<double>> truth;
  taut_test::ScratchFolder scratch_;
};

/// Whether the row of a number in the table `covariance` puts the truth into its 95 % interval.
bool holds(const Result& r, const std::string& path, double value) {
  const Value* found = r.find_value(path);
  const Value* error = r.find_value(path + ".standard_error");
  return found != nullptr && error != nullptr && std::abs(found->value - value) <= 1.959964 * error->value;
}

TEST_F(Line, TheTruthLiesInTheIntervalAsOftenAsItSays) {
  const int seeds = taut_test::watched ? 20 : 200;
  int length = 0, stiffness = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    write(noisy(static_cast<unsigned>(seed)));
    const Result r = fit();
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    length += holds(r, "machine.reevings.sky.length", true_length) ? 1 : 0;
    stiffness += holds(r, "machine.ropes.sky.stiffness", true_stiffness) ? 1 : 0;
  }
  RecordProperty("length", length);
  RecordProperty("stiffness", stiffness);
  const double least = seeds == 200 ? 0.90 : 0.75, most = seeds == 200 ? 0.99 : 1.0;
  for (const int hits : {length, stiffness}) {
    EXPECT_GE(hits, least * seeds);
    EXPECT_LE(hits, most * seeds);
  }
}

TEST_F(Line, ItTellsHowFarItIsAndAnInterruptLeavesNoNumbers) {
  write(noisy(1));
  int told = 0;
  const Job job{.text = deck_of(), .name = path("deck.yaml"), .set = {}, .progress = [&](const Progress& p) {
                  EXPECT_EQ(p.what, "calibration");
                  EXPECT_LE(p.done, 1);
                  return ++told < 10;
                }};
  const Result r = calibrate(job, 1);
  EXPECT_EQ(told, 10);
  EXPECT_TRUE(r.interrupted);
  EXPECT_EQ(exit_code(r), 130);
  EXPECT_TRUE(r.values.empty());
  EXPECT_TRUE(r.attachments.empty());
}

TEST_F(Line, APairThatTheMeasurementsCannotTellApartIsNamed) {
  // one state: a longer rope and a softer one give the same tensions
  write(fmt::format("output,value,sd\nequilibrium.sky.T_start,{:.3f} N,100 N\nequilibrium.sky.T_end,{:.3f} N,100 N\n",
                    truth[2][0] + 40, truth[2][1]));
  const Result r = calibrate(
      {.text = deck_of(), .name = path("deck.yaml"), .set = {"machine.loads[0].mass=800 kg"}, .progress = {}}, 2);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  std::string warnings;
  for (const std::string& one : r.warnings) warnings += one + "\n";
  EXPECT_THAT(warnings, HasSubstr("not identifiable"));
  EXPECT_EQ(r.find_value("machine.ropes.sky.stiffness"), nullptr) << "no number for what is not told";
  EXPECT_TRUE(r.attachments.empty()) << "no deck with numbers that nobody measured";
  EXPECT_THAT(warnings, HasSubstr("can't tell these apart: machine.reevings.sky.length, machine.ropes.sky.stiffness"));
}

TEST_F(Line, TheCalibratedDeckGivesTheMeasurements) {
  std::string csv = "output,value,sd,machine.loads[0].mass\n";
  for (std::size_t i = 0; i < masses.size(); ++i) {
    csv += fmt::format("equilibrium.sky.T_start,{:.6f} N,10 N,{} kg\n", truth[i][0], masses[i]);
  }
  write(csv);
  const Result r = fit();
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  ASSERT_EQ(r.attachments.size(), 1U);
  const Result again = run({.text = r.attachments[0].text,
                            .name = path("calibrated.yaml"),
                            .set = {fmt::format("machine.loads[0].mass={} kg", masses[3])},
                            .progress = {}});
  ASSERT_EQ(again.status, Status::ok) << again.message << to_text(again.errors);
  EXPECT_NEAR(again.find_value("sky.T_start")->value, truth[3][0], 1e-4 * truth[3][0]);
}

/// A study would take the numbers found for surer than they are.
TEST_F(Line, NoStudyGoesOnFromADoubtfulFit) {
  const auto measured = [&](const std::string& head, const std::string& error, double scatter, std::size_t count) {
    std::string csv = head;
    for (std::size_t i = 0; i < count; ++i) {
      csv += fmt::format("equilibrium.sky.T_start,{:.6f} N,{}{} kg\n", truth[i][0] + (i % 2 == 0 ? scatter : -scatter),
                         error, masses[i]);
    }
    write(csv);
    return fit();
  };
  const auto why = [](const Result& r) { return r.warnings.empty() ? std::string() : r.warnings.back(); };
  const std::string with_sd = "output,value,sd,machine.loads[0].mass\n",
                    without = "output,value,machine.loads[0].mass\n";
  EXPECT_EQ(measured(with_sd, "10 N,", 5, 6).attachments.size(), 1U);
  const Result misfit = measured(with_sd, "10 N,", 100, 6);
  EXPECT_TRUE(misfit.attachments.empty());
  EXPECT_THAT(why(misfit), HasSubstr("less sure than the standard deviations"));
  EXPECT_EQ(measured(without, "", 10, 6).attachments.size(), 1U);
  const Result few = measured(without, "", 10, 4);
  EXPECT_TRUE(few.attachments.empty());
  EXPECT_THAT(why(few), HasSubstr("2 measurements more than numbers"));
}

TEST_F(Line, WithoutSdTheScatterHasTheUnitOfTheMeasurements) {
  std::string csv = "output,value,machine.loads[0].mass\n";
  for (std::size_t i = 0; i < masses.size(); ++i) {
    csv += fmt::format("equilibrium.sky.T_start,{:.6f} N,{} kg\n", truth[i][0] + (i % 2 == 0 ? 100 : -100), masses[i]);
  }
  write(csv);
  const Result r = fit();
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(r.find_value("chi_squared"), nullptr) << "a sum of squares over nothing is no number without a unit";
  const Value* found = r.find_value("sd");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->unit.symbol, "N");
  EXPECT_GT(found->value, 50) << "the residuals are 100 N less what two numbers take up";
  EXPECT_LE(found->value, 100 * std::sqrt(6. / 4)) << "6 measurements less 2 numbers";
  write(noisy(1));
  EXPECT_NE(fit().find_value("chi_squared"), nullptr);
}

TEST_F(Line, TheErrorOfATemperatureIsADifference) {
  const auto replaced = [](std::string text, const std::string& part, const std::string& by) {
    return text.replace(text.find(part), part.size(), by);
  };
  std::string deck = replaced(deck_of(), "machine:\n", "machine:\n  temperature: 15 degC\n");
  deck = replaced(deck, "    machine.reevings.sky.length: [203 m, 207 m]\n",
                  "    machine.temperature: [-220 degC, 80 degC]\n");
  write(noisy(1));
  const Result r = calibrate({.text = deck, .name = path("deck.yaml"), .set = {}, .progress = {}}, 2);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Value* error = r.find_value("machine.temperature.standard_error");
  ASSERT_NE(error, nullptr);
  const std::string shown =
      Display(std::map<std::string, std::string>{{"temperature", "degC"}}).brief(error->value, error->unit);
  EXPECT_THAT(shown, testing::EndsWith(" K"));
  EXPECT_THAT(shown, testing::Not(testing::StartsWith("-")));
}

// The true length is 204.6 m: bounds that end at 204 m are no interval of what is found there.
TEST_F(Line, BoundsAreNoInterval) {
  std::string deck = deck_of();
  const std::string bounds = "[203 m, 207 m]";
  deck.replace(deck.find(bounds), bounds.size(), "[203 m, 204 m]");
  write(noisy(1));
  const Result r = calibrate({.text = deck, .name = path("deck.yaml"), .set = {}, .progress = {}}, 2);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(r.answers.at(0).text, "machine.reevings.sky.length 204 m (at its upper bound, no interval)");
  const Table& t = *r.find_table("calibrated");
  EXPECT_EQ(std::get<std::string>(t.rows.at(0).at(3)), "-");
  EXPECT_EQ(std::get<std::string>(t.rows.at(0).at(4)), "-");
  // as many numbers as measurements, without their sd
  write(
      fmt::format("output,value,machine.loads[0].mass\nequilibrium.sky.T_start,{:.6f} N,{} kg\n"
                  "equilibrium.sky.T_start,{:.6f} N,{} kg\n",
                  truth[0][0], masses[0], truth[5][0], masses[5]));
  const Result exact = fit();
  ASSERT_EQ(exact.status, Status::ok) << exact.message << to_text(exact.errors);
  EXPECT_EQ(exact.answers.at(0).text, "machine.reevings.sky.length 204.6 m (no interval)");
}

// A sign too many: a mass below 0 makes no case.
TEST_F(Line, ARowWithoutAnAnswerIsNamed) {
  write(noisy(1) + "equilibrium.sky.T_start,20 kN,150 N,-9 t\n");
  const Result r = fit();
  EXPECT_EQ(r.status, Status::not_converged);
  EXPECT_THAT(r.message,
              HasSubstr("1 of 13 measurements have no answer at the first start, the first is measurement 13 "
                        "(machine.loads[0].mass -9"))
      << r.message;
  EXPECT_THAT(r.message, HasSubstr("measured.csv"));
}

TEST_F(Line, MistakesHaveTheirPlace) {
  const auto mistakes = [&](const std::string& csv) {
    write(csv);
    return to_text(fit().errors);
  };
  EXPECT_THAT(mistakes("output,value\nequilibrium.sky.T_start,20 m\n"), HasSubstr("measured.csv:2:25: error"));
  EXPECT_THAT(mistakes("output,value\n\nequilibrium.sky.T_start,20\n"), HasSubstr("measured.csv:3:25: error"));
  EXPECT_THAT(mistakes("output,value\nequilibrium.sky.T_strat,20 kN\n"), HasSubstr("did you mean 'sky.T_start'"));
  EXPECT_THAT(mistakes("output\nequilibrium.sky.T_start\n"), HasSubstr("'value'"));
  EXPECT_THAT(mistakes("output,value,sd\nequilibrium.sky.T_start,20 kN,1 kN\nequilibrium.sky.T_end,20 kN,\n"),
              HasSubstr("give it in all or in none"));
  EXPECT_THAT(mistakes("output,value\n"), HasSubstr("no measurement"));
  EXPECT_THAT(mistakes("output,value\nequilibrium.sky.T_start,20 kN\nequilibrium.car.z,-7 m\n"),
              HasSubstr("measured.csv:3:19: error"));
}

/// The same for `calibrate`, with its file.
TEST_F(Line, ACheckOfTheDeckFindsMistakesOfItsBlock) {
  write(noisy(1));
  const auto found = [&](const std::string& more, std::string free = {}) {
    std::string text = deck_of(more);
    if (!free.empty()) text.replace(text.find("[203 m, 207 m]"), std::string("[203 m, 207 m]").size(), free);
    return to_text(check({.text = text, .name = path("deck.yaml"), .set = {}, .progress = {}}));
  };
  EXPECT_EQ(found(""), "");
  EXPECT_THAT(found("", "[207 m, 203 m]"), HasSubstr("must be below"));
  EXPECT_THAT(found("", "[203 m, 207 kN]"), HasSubstr("207 kN"));
  EXPECT_THAT(found("    machine.loads[3].mass: [1 t, 2 t]\n"), HasSubstr("loads"));
  std::filesystem::remove(path("measured.csv"));
  EXPECT_THAT(found(""), HasSubstr("measured.csv"));
}

}  // namespace taut::app::calibrate_test
