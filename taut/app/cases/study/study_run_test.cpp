#include "taut/app/cases/study/study_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "test/support/made_study.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::app::study_run_test {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// 300 cases, in parts of 64 and a last one of 44: the square of a number from -1 to 3, which has none below 0.
Study squares() {
  return taut_test::sampled(taut_test::made_study({{.law = chance::Uniform{.low = -1, .high = 3}}}, 1,
                                                  [](const chance::Point& p) -> std::vector<double> {
                                                    return {p[0] < 0 ? std::nan("") : p[0] * p[0]};
                                                  }),
                            chance::PointKind::random, 300);
}

class StudyRun : public testing::Test {
 protected:
  StudyFolder folder_of(const Study& study) const {
    const Job job{.text = "taut: 1\n", .name = "deck.yaml", .set = {}, .progress = {}, .read = {}};
    auto folder = StudyFolder::make(path(), job, study);
    if (!folder) throw std::runtime_error(folder.error().message);
    return std::move(*folder);
  }
  std::string path() const { return (scratch_.path() / "study").string(); }

  taut_test::ScratchFolder scratch_;
};

TEST_F(StudyRun, AShardCalculatesEveryNthPartAndNoOther) {
  Study study = squares();
  std::atomic<int> asked = 0;
  study.model.answer = [&asked, own = study.model.answer](std::span<const double> p) {
    ++asked;
    return own(p);
  };
  const StudyFolder folder = folder_of(study);
  const auto state = run_cases(study, folder, {.threads = 2, .shard = 2, .of = 3});
  ASSERT_TRUE(state.has_value()) << state.error().message;
  EXPECT_THAT(folder.done(), ElementsAre(false, true, false, false, true));
  EXPECT_EQ(asked, 64 + 44);
  EXPECT_EQ(state->cases, 300U);
  EXPECT_EQ(state->cases_done, 64U + 44U);
  EXPECT_EQ(state->parts, 5U);
  EXPECT_EQ(state->parts_done, 2U);
  EXPECT_FALSE(state->whole());
  EXPECT_FALSE(state->interrupted);
  EXPECT_EQ(state_of(folder).cases_done, state->cases_done) << "who looks later sees the same";
}

TEST_F(StudyRun, EachCaseIsKeptWithItsNumbersAndItsReason) {
  const Study study = squares();
  const StudyFolder folder = folder_of(study);
  ASSERT_TRUE(run_cases(study, folder, {.threads = 2})->whole());
  std::uint64_t next = 0, failed = 0;
  for (std::uint64_t part = 0; part < folder.parts().count(); ++part) {
    const auto rows = folder.read(part, study);
    ASSERT_TRUE(rows.has_value()) << rows.error().message;
    for (const KeptCase& row : *rows) {
      EXPECT_EQ(row.index, next);
      EXPECT_EQ(row.values, study.values_at(next));
      const double x = row.values[0];
      if (x < 0) {
        EXPECT_TRUE(std::isnan(row.answer.outputs[0])) << next;
        EXPECT_EQ(row.answer.outcome.status, Status::infeasible);
        EXPECT_EQ(row.answer.outcome.message, "the function has no value there");
        ++failed;
      } else {
        EXPECT_EQ(row.answer.outputs[0], x * x) << next;
      }
      ++next;
    }
  }
  EXPECT_EQ(next, 300U);
  // a quarter of the law lies below 0: 75 of 300 cases, with a standard deviation of 7.5
  EXPECT_NEAR(static_cast<double>(failed), 75, 4 * 7.5);
}

TEST_F(StudyRun, APartThatAPowerCutHasCutIsCalculatedAnew) {
  const Study study = squares();
  const StudyFolder folder = folder_of(study);
  ASSERT_TRUE(run_cases(study, folder, {.threads = 2})->whole());
  const auto before = folder.read(2, study);
  fs::resize_file(fs::path(path()) / "parts" / "00002.h5", 512);
  EXPECT_FALSE(state_of(folder).whole());
  ASSERT_TRUE(run_cases(study, folder, {.threads = 2})->whole());
  const auto again = folder.read(2, study);
  ASSERT_TRUE(before && again);
  for (std::size_t i = 0; i < before->size(); ++i) EXPECT_EQ((*again)[i].values, (*before)[i].values);
}

TEST_F(StudyRun, TellsOfItsOwnCasesHowManyAreDone) {
  const Study study = squares();
  std::vector<Progress> told;
  const auto listen = [&](const Progress& p) {
    told.push_back(p);
    return true;
  };
  ASSERT_TRUE(run_cases(study, folder_of(study), {.threads = 1, .shard = 2, .of = 3, .progress = listen}));
  ASSERT_EQ(told.size(), 108U);
  EXPECT_DOUBLE_EQ(told[26].done, 0.25);
  EXPECT_DOUBLE_EQ(told.back().done, 1);
  EXPECT_EQ(told.back().words, "108 of 108 cases");
}

TEST_F(StudyRun, APartThatCannotBeWrittenIsAnErrorThatNamesIt) {
  const Study study = squares();
  const StudyFolder folder = folder_of(study);
  // a file in the place of the folder: not even root can write into it
  fs::remove_all(fs::path(path()) / "parts");
  std::ofstream(fs::path(path()) / "parts") << "in the way";
  const auto state = run_cases(study, folder, {.threads = 1});
  ASSERT_FALSE(state.has_value());
  EXPECT_THAT(state.error().message, HasSubstr((fs::path(path()) / "parts").string()));
}

TEST(StudyParallel, GivesRowsInTheOrderOfThePointsUntilItIsEnded) {
  const Study study = squares();
  const chance::Points points = {{2}, {-1}, {3}, {0.5}};
  for (const int threads : {1, 2}) {
    const auto rows = parallel(study.model, threads)(points);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_THAT(rows[0], ElementsAre(4));
    EXPECT_TRUE(std::isnan(rows[1].at(0)));
    EXPECT_THAT(rows[2], ElementsAre(9));
    EXPECT_THAT(rows[3], ElementsAre(0.25));
  }
  int told = 0;
  const CaseCounter::Ask two = [&](const Progress&) { return ++told < 2; };
  CaseCounter counter("cases", 4, true, two);
  const auto ended = parallel(study.model, 1, &counter)(points);
  EXPECT_TRUE(counter.ended());
  EXPECT_EQ(told, 2);
  ASSERT_EQ(ended.size(), 4U);
  std::size_t without = 0;
  for (const auto& row : ended) without += std::isnan(row.at(0)) ? 1 : 0;
  EXPECT_GE(without, 2U) << "the cases after the second are not calculated";
  EXPECT_TRUE(parallel(study.model, 2)(chance::Points{}).empty());
}

}  // namespace taut::app::study_run_test
