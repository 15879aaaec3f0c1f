#include "taut/app/cases/study/slurm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "test/support/scratch_folder.hpp"

namespace taut::app::slurm_test {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr const char* deck =
    "taut: 1\n"
    "machine:\n"
    "  points: {tail: [0 m, 0 m, 0 m], head: [200 m, 0 m, 30 m]}\n"
    "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN}}\n"
    "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
    "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
    "study:\n"
    "  vary: {machine.carriages.car.mass: {normal: {mean: 1 t, cov: 10 %}}}\n"
    "  of: [equilibrium.sky.T_start]\n"
    "  samples: 128\n";

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A study in a folder whose name a shell would take apart.
class Slurm : public testing::Test {
 protected:
  void SetUp() override {
    const auto read = read_study(job);
    ASSERT_TRUE(read.has_value()) << to_text(read.error().errors);
    study = *read;
  }
  std::string folder() const { return (scratch_.path() / "it's a study").string(); }

  Job job{.text = deck, .name = "<stdin>", .set = {}, .progress = {}, .read = {}};
  Study study;

 private:
  taut_test::ScratchFolder scratch_;
};

TEST_F(Slurm, WritesAnArrayAndAMergeThatFollowsIt) {
  const auto cases = StudyFolder::make(folder(), job, study);
  ASSERT_TRUE(cases.has_value()) << cases.error().message;
  const auto made = write_slurm(study, *cases, folder(),
                                {.program = "/opt/taut 0.1/taut", .throttle = 8, .lines = {"--partition=long"}});
  ASSERT_TRUE(made.has_value()) << made.error().message;
  EXPECT_EQ(made->shards, 1U) << "128 cases of microseconds are no work for two";
  EXPECT_GT(made->seconds, 0);
  const fs::path place = fs::path(folder()) / "slurm";
  const std::string array = text_of(place / "cases.sbatch"), merge = text_of(place / "merge.sbatch");
  EXPECT_THAT(array, HasSubstr("#SBATCH --array=1-1%8\n"));
  EXPECT_THAT(array, HasSubstr("#SBATCH --requeue\n"));
  EXPECT_THAT(array, HasSubstr("#SBATCH --time=10\n")) << "not less than the least time";
  EXPECT_THAT(array, HasSubstr("exec '/opt/taut 0.1/taut' study resume '"));
  EXPECT_THAT(array, HasSubstr("it'\\''s a study' --shard \"$SLURM_ARRAY_TASK_ID/1\" --threads 1 --quiet\n"));
  EXPECT_THAT(merge, HasSubstr("exec '/opt/taut 0.1/taut' study merge '"));
  for (const std::string& text : {array, merge}) {
    EXPECT_TRUE(text.starts_with("#!/bin/sh\n")) << "Slurm wants it first";
    EXPECT_THAT(text, HasSubstr("#SBATCH --partition=long\n"));
    EXPECT_GT(text.find("exec "), text.rfind("#SBATCH")) << "it reads no option behind a command";
  }
  const std::string submit = text_of(made->submit);
  EXPECT_THAT(submit, HasSubstr("cases=$(sbatch --parsable '"));
  EXPECT_THAT(submit, HasSubstr("sbatch --dependency=\"afterok:$cases\" '"));
}

TEST_F(Slurm, WhereNothingCanBeWrittenItSaysWhere) {
  const auto cases = StudyFolder::make(folder(), job, study);
  ASSERT_TRUE(cases.has_value());
  std::ofstream(fs::path(folder()) / "slurm") << "a file";
  const auto made = write_slurm(study, *cases, folder(), {});
  ASSERT_FALSE(made.has_value());
  EXPECT_THAT(made.error().message, HasSubstr("slurm'"));
}

}  // namespace taut::app::slurm_test
