#include "taut/io/child.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "test/support/scratch_folder.hpp"

namespace taut::io::child_test {

namespace fs = std::filesystem;

class ChildProgram : public ::testing::Test {
 protected:
  Child shell(const std::string& command) const {
    Child child;
    child.words = {"/bin/sh", "-c", command};
    child.output = (top_ / "output").string();
    return child;
  }
  std::string printed() const {
    std::ostringstream text;
    text << std::ifstream(top_ / "output").rdbuf();
    return text.str();
  }
  taut_test::ScratchFolder scratch_;
  fs::path top_ = scratch_.path();
};

TEST_F(ChildProgram, ItsCodeOutputAndEnvironment) {
  Child child = shell("echo out; echo $TAUT_CHILD >&2; cat; exit 7");
  child.environment = {"TAUT_CHILD=given"};
  const auto done = run_child(child);
  ASSERT_TRUE(done.has_value()) << done.error();
  EXPECT_EQ(done->end, ChildEnd::ended);
  EXPECT_EQ(done->code, 7);
  EXPECT_EQ(printed(), "out\ngiven\n") << "standard input is empty";
}

TEST_F(ChildProgram, ASignalIsACode) {
  const auto done = run_child(shell("kill -9 $$"));
  ASSERT_TRUE(done.has_value());
  EXPECT_EQ(done->code, 128 + 9);
}

/// Whether a process is gone, or dead and nobody has waited for it. One that was killed ends when the system comes to
/// it: it is asked for again and again, far longer than that takes.
bool ends(int process) {
  for (int k = 0; k < 6000; ++k) {
    std::ifstream state(fs::path("/proc") / std::to_string(process) / "stat");
    std::string id, name, letter;
    state >> id >> name >> letter;
    if (letter.empty() || letter == "Z" || letter == "X") return true;
    usleep(10'000);
  }
  return false;
}

TEST_F(ChildProgram, IsStoppedWithAllThatItStarted) {
  Child child = shell("trap '' TERM; sleep 1000 & echo $! > " + (top_ / "pid").string() + "; wait; wait; sleep 1000");
  child.go_on = [this] { return !fs::exists(top_ / "pid") || fs::file_size(top_ / "pid") == 0; };
  const auto done = run_child(child);
  ASSERT_TRUE(done.has_value());
  EXPECT_EQ(done->end, ChildEnd::stopped);
  int number = 0;
  std::ifstream(top_ / "pid") >> number;
  ASSERT_GT(number, 1);
  EXPECT_TRUE(ends(number));
}

TEST_F(ChildProgram, IsEndedAfterItsTime) {
  Child child = shell("exec sleep 1000");
  child.limit = std::chrono::seconds(0);
  const auto done = run_child(child);
  ASSERT_TRUE(done.has_value());
  EXPECT_EQ(done->end, ChildEnd::too_long);
}

TEST_F(ChildProgram, WhatIsNotThereIsNotStarted) {
  Child child = shell("");
  child.words = {(top_ / "nothing").string()};
  EXPECT_NE(run_child(child).error().find("can't start"), std::string::npos);
  EXPECT_FALSE(start_apart(child.words, std::chrono::milliseconds(0)).has_value());
}

TEST_F(ChildProgram, ApartItsFailureIsSeenWhileItIsWatched) {
  constexpr std::chrono::hours long_enough{1};
  const auto failed = start_apart({"/bin/sh", "-c", "exit 3"}, long_enough);
  ASSERT_TRUE(failed.has_value());
  EXPECT_EQ(failed->value_or(0), 3);
  const auto fine = start_apart({"/bin/sh", "-c", "exit 0"}, long_enough);
  ASSERT_TRUE(fine.has_value());
  EXPECT_FALSE(fine->has_value());
}

TEST_F(ChildProgram, IsFoundInTheFoldersOfPath) {
  EXPECT_TRUE(program_path("sh").has_value());
  EXPECT_FALSE(program_path("").has_value());
  EXPECT_FALSE(program_path("no-such-program-of-taut").has_value());
  const fs::path file = top_ / "tool";
  std::ofstream(file) << "#!/bin/sh\n";
  EXPECT_FALSE(program_path(file.string()).has_value()) << "it cannot be run";
  chmod(file.c_str(), S_IRWXU);
  EXPECT_EQ(program_path(file.string()), file.string());
  EXPECT_FALSE(program_path(top_.string() + "/").has_value()) << "a folder";
}

}  // namespace taut::io::child_test
