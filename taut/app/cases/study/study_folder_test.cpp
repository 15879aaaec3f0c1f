#include "taut/app/cases/study/study_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "test/support/scratch_folder.hpp"

namespace taut::app::study_folder_test {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// One input, one output, 100 cases, without a deck behind it.
Study small(const std::string& hash = "abc") {
  Study study;
  study.model.inputs = {{.path = "machine.loads[0].mass", .unit = si::kg, .range = {}, .base = 1}};
  study.model.outputs = {{.name = "equilibrium.sky.T_max", .unit = si::N, .label = {}}};
  study.bars = {.first = 0, .count = 100};
  study.hash = hash;
  return study;
}

Job job() { return {.text = "taut: 1\n", .name = "<stdin>", .set = {"a=1"}, .progress = {}, .read = {}}; }

std::vector<KeptCase> rows_of(const CaseBlock& block) {
  std::vector<KeptCase> rows;
  for (std::uint64_t i = block.first; i < block.end(); ++i) {
    rows.push_back({.index = i, .values = {1.0 / (1.0 + static_cast<double>(i))}, .answer = {}});
    rows.back().answer.outputs = {std::sqrt(static_cast<double>(i))};
    if (i % 2 == 0) rows.back().answer.weaker = {{"sky", 1e5 / (1.0 + static_cast<double>(i))}};
  }
  rows.front().answer = {.outputs = {std::nan("")}, .outcome = infeasible("no equilibrium, 'sky' is too short")};
  return rows;
}

class Folder : public testing::Test {
 protected:
  std::string path() const { return (scratch_.path() / "study").string(); }
  taut_test::ScratchFolder scratch_;
};

TEST(StudyParts, HoldEachCaseOnce) {
  for (const std::uint64_t cases : {1U, 63U, 64U, 65U, 16384U, 16385U, 100000U}) {
    const StudyParts parts = parts_of(cases);
    EXPECT_LE(parts.count(), 256U) << cases;
    std::uint64_t next = 0;
    for (std::uint64_t p = 0; p < parts.count(); ++p) {
      EXPECT_EQ(parts.of(p).first, next);
      EXPECT_GT(parts.of(p).count, 0U);
      next = parts.of(p).end();
    }
    EXPECT_EQ(next, cases);
  }
}

TEST_F(Folder, KeepsRowsToTheLastBit) {
  const Study study = small();
  const auto folder = StudyFolder::make(path(), job(), study);
  ASSERT_TRUE(folder.has_value()) << folder.error().message;
  EXPECT_THAT(folder->done(), testing::ElementsAre(false, false));
  const auto rows = rows_of(folder->parts().of(1));
  ASSERT_TRUE(folder->write(1, study, rows).has_value());
  EXPECT_THAT(folder->done(), testing::ElementsAre(false, true));
  const auto again = StudyFolder::open(path());
  ASSERT_TRUE(again.has_value()) << again.error().message;
  const auto read = again->read(1, study);
  ASSERT_TRUE(read.has_value()) << read.error().message;
  ASSERT_EQ(read->size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ((*read)[i].index, rows[i].index);
    EXPECT_EQ((*read)[i].values, rows[i].values);
    if (i == 0) continue;  // it has no number
    EXPECT_EQ((*read)[i].answer.outputs, rows[i].answer.outputs);
    EXPECT_EQ((*read)[i].answer.weaker, rows[i].answer.weaker);
  }
  EXPECT_TRUE(std::isnan(read->front().answer.outputs.front()));
  EXPECT_EQ(read->front().answer.outcome.status, Status::infeasible);
  EXPECT_EQ(read->front().answer.outcome.message, "no equilibrium, 'sky' is too short");
  EXPECT_EQ(StudyFolder::job_in(path())->set, job().set);
}

TEST_F(Folder, OfAnotherStudyIsRefused) {
  ASSERT_TRUE(StudyFolder::make(path(), job(), small()).has_value());
  EXPECT_TRUE(StudyFolder::make(path(), job(), small()).has_value());
  const auto other = StudyFolder::make(path(), job(), small("def"));
  ASSERT_FALSE(other.has_value());
  EXPECT_THAT(other.error().message, HasSubstr("holds another study"));
}

TEST_F(Folder, ThatIsNoneIsRefused) {
  EXPECT_FALSE(StudyFolder::open(path()).has_value());
  fs::create_directories(path());
  for (const char* text : {"", "[]", "{\"study\": 3}", "{\"study\": \"abc\""}) {
    std::ofstream(fs::path(path()) / "study.json") << text;
    const auto folder = StudyFolder::open(path());
    ASSERT_FALSE(folder.has_value()) << text;
    EXPECT_THAT(folder.error().message, HasSubstr("is not the file of a study")) << text;
  }
}

TEST_F(Folder, APartThatIsCutIsAnErrorWithItsName) {
  const Study study = small();
  const auto folder = StudyFolder::make(path(), job(), study);
  ASSERT_TRUE(folder->write(0, study, rows_of(folder->parts().of(0))).has_value());
  const fs::path part = fs::path(path()) / "parts" / "00000.h5";
  ASSERT_TRUE(fs::exists(part));
  fs::resize_file(part, fs::file_size(part) / 2);
  const auto read = folder->read(0, study);
  ASSERT_FALSE(read.has_value());
  EXPECT_THAT(read.error().message, HasSubstr("00000.h5"));
}

TEST_F(Folder, APartThatCanNotBeReadIsNotDone) {
  const Study study = small();
  const auto folder = StudyFolder::make(path(), job(), study);
  for (const std::uint64_t part : {0U, 1U}) {
    ASSERT_TRUE(folder->write(part, study, rows_of(folder->parts().of(part))).has_value());
  }
  const fs::path parts = fs::path(path()) / "parts";
  fs::resize_file(parts / "00000.h5", 100);
  EXPECT_THAT(folder->done(), testing::ElementsAre(false, true));
  fs::resize_file(parts / "00000.h5", 0);
  EXPECT_THAT(folder->done(), testing::ElementsAre(false, true));
  fs::copy_file(parts / "00001.h5", parts / "00000.h5", fs::copy_options::overwrite_existing);
  EXPECT_THAT(folder->done(), testing::ElementsAre(false, true)) << "the cases of another part";
}

TEST_F(Folder, KeepsWhatIsSaidAgainstACase) {
  const Study study = small();
  const auto folder = StudyFolder::make(path(), job(), study);
  auto rows = rows_of(folder->parts().of(1));
  rows[5].answer.flaws = {
      {.kind = CaseFlaw::Kind::fails, .check = "sky.T_max", .words = "\"11 kN\", limit 10 kN", .fact = true},
      {.kind = CaseFlaw::Kind::fails, .check = "sky.safety_factor", .sense = Sense::at_least, .analysis = "cycle_2"},
      {.kind = CaseFlaw::Kind::unmade, .words = "no angle"},
      {.kind = CaseFlaw::Kind::unsafe, .words = "a rope of \xC3\xBC is slack"}};
  ASSERT_TRUE(folder->write(1, study, rows).has_value());
  const auto again = folder->read(1, study);
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_TRUE(again->at(4).answer.flaws.empty());
  const auto& flaws = again->at(5).answer.flaws;
  ASSERT_EQ(flaws.size(), 4U);
  for (std::size_t i = 0; i < flaws.size(); ++i) {
    const CaseFlaw& own = rows[5].answer.flaws[i];
    EXPECT_EQ(flaws[i].kind, own.kind);
    EXPECT_EQ(flaws[i].check, own.check);
    EXPECT_EQ(flaws[i].words, own.words);
    EXPECT_EQ(flaws[i].fact, own.fact);
    EXPECT_EQ(flaws[i].sense, own.sense);
    EXPECT_EQ(flaws[i].analysis, own.analysis);
  }
}

TEST_F(Folder, TidyRemovesWhatKilledProgramsLeftAndNothingElse) {
  const Study study = small();
  const auto folder = StudyFolder::make(path(), job(), study);
  ASSERT_TRUE(folder->write(0, study, rows_of(folder->parts().of(0))).has_value());
  const fs::path left = fs::path(path()) / "parts" / "00001.h5.unfinished-999999999";
  std::ofstream(left) << "half";
  EXPECT_THAT(folder->done(), testing::ElementsAre(true, false)) << "a part is there whole or not";
  folder->tidy();
  EXPECT_FALSE(fs::exists(left));
  EXPECT_THAT(folder->done(), testing::ElementsAre(true, false));
}

}  // namespace taut::app::study_folder_test
