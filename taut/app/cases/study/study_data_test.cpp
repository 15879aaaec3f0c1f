#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/app/cases/study/study_result.hpp"
#include "taut/base/long_rows.hpp"
#include "test/support/made_study.hpp"
#include "test/support/scratch_folder.hpp"

/// Of study_result.hpp the cases that are read again.
namespace taut::app::study_data_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two inputs; their sum and product, which 100 cases have in two parts.
Study sums() {
  const chance::Distribution law{.law = chance::Uniform{.low = 1, .high = 2}};
  Study study = taut_test::sampled(taut_test::made_study({law, law}, 2,
                                                         [](const chance::Point& p) -> std::vector<double> {
                                                           return {p[0] + p[1], p[0] * p[1]};
                                                         }),
                                   chance::PointKind::random, 100);
  study.model.inputs[1].unit = si::kg;
  study.model.outputs[1].unit = si::N;
  return study;
}

/// The rows of a part, without those answers that fail at these cases.
std::vector<KeptCase> rows_of(const Study& study, const CaseBlock& block, const std::vector<FailedCase>& failed) {
  std::vector<KeptCase> rows;
  for (std::uint64_t i = block.first; i < block.end(); ++i) {
    rows.push_back({.index = i, .values = study.values_at(i), .answer = study.model.answer(study.values_at(i))});
    for (const FailedCase& one : failed) {
      if (one.index != i) continue;
      rows.back().answer = {.outputs = {std::nan(""), std::nan("")}, .outcome = infeasible(one.reason)};
    }
  }
  return rows;
}

class StudyDataOf : public testing::Test {
 protected:
  StudyFolder folder_of(const Study& study) const {
    const Job job{.text = "taut: 1\n", .name = "deck.yaml", .set = {}, .progress = {}, .read = {}};
    auto folder = StudyFolder::make((scratch_.path() / "study").string(), job, study);
    if (!folder) throw std::runtime_error(folder.error().message);
    return std::move(*folder);
  }

  taut_test::ScratchFolder scratch_;
};

TEST_F(StudyDataOf, HasARowForEachCaseInTheOrderOfTheirNumbers) {
  const Study study = sums();
  const StudyFolder folder = folder_of(study);
  // as two shards may end: the last part first
  for (const std::uint64_t part : {1U, 0U}) {
    ASSERT_TRUE(folder.write(part, study, rows_of(study, folder.parts().of(part), {})).has_value());
  }
  const auto data = read_cases(study, folder);
  ASSERT_TRUE(data.has_value()) << data.error().message;
  std::vector<std::string> names;
  for (const Column& c : data->rows.columns) names.push_back(c.name + " " + std::string(c.unit.symbol));
  EXPECT_THAT(names, ElementsAre("case 1", "machine.x1.value 1", "machine.x2.value kg", "y1 1", "y2 N", "status 1"));
  EXPECT_TRUE(data->failed.empty());
  ASSERT_EQ(data->rows.long_rows->size(), 100U);
  std::uint64_t at = 0;
  data->rows.long_rows->each([&](const double* row) {
    const chance::Point p = study.values_at(at);
    EXPECT_THAT(std::vector<double>(row, row + 6),
                ElementsAre(static_cast<double>(at), p[0], p[1], p[0] + p[1], p[0] * p[1], 0));
    EXPECT_EQ(data->outputs[1].at(at), p[0] * p[1]);
    ++at;
  });
}

TEST_F(StudyDataOf, AFailedCaseStaysInItsPlaceWithAStatusAndAReason) {
  const Study study = sums();
  const StudyFolder folder = folder_of(study);
  const std::vector<FailedCase> failed = {{.index = 3, .reason = "too short"}, {.index = 70, .reason = "too long"}};
  for (const std::uint64_t part : {0U, 1U}) {
    ASSERT_TRUE(folder.write(part, study, rows_of(study, folder.parts().of(part), failed)).has_value());
  }
  const auto data = read_cases(study, folder);
  ASSERT_TRUE(data.has_value()) << data.error().message;
  ASSERT_EQ(data->failed.size(), 2U);
  EXPECT_EQ(data->failed[0].index, 3U);
  EXPECT_EQ(data->failed[1].index, 70U);
  EXPECT_EQ(data->failed[1].reason, "too long");
  const std::vector<double> status = data->rows.long_rows->column(5);
  for (std::size_t i = 0; i < 100; ++i) {
    const bool none = i == 3 || i == 70;
    EXPECT_EQ(status[i] != 0, none) << i;
    EXPECT_EQ(std::isnan(data->outputs[0][i]), none) << i;
  }
}

TEST_F(StudyDataOf, APartThatIsNotThereOrOfAnotherStudyIsAnErrorWithItsFile) {
  const Study study = sums();
  const StudyFolder folder = folder_of(study);
  ASSERT_TRUE(folder.write(0, study, rows_of(study, folder.parts().of(0), {})).has_value());
  const auto missing = read_cases(study, folder);
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message, HasSubstr("00001.h5"));
  ASSERT_TRUE(folder.write(1, study, rows_of(study, folder.parts().of(0), {})).has_value());
  const auto twice = read_cases(study, folder);
  ASSERT_FALSE(twice.has_value()) << "the cases of part 0 stand in part 1";
  EXPECT_THAT(twice.error().message, HasSubstr("is not a part of this study"));
}

}  // namespace taut::app::study_data_test
