#include "cli/progress.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <vector>

namespace taut::cli::progress_test {

/// What becomes of an interrupt after these questions: 7: it is heard, and the next question ends the calculation.
[[noreturn]] void interrupted_after(const std::vector<Progress>& questions) {
  take_interrupts();
  ProgressLine line(false);
  for (const Progress& one : questions) line(one);
  std::raise(SIGINT);
  std::_Exit(line({.what = "transient", .done = 0.6, .words = {}}) ? 0 : 7);
}

TEST(ProgressLine, AnInterruptIsHeldWhileACalculationAsks) {
  EXPECT_EXIT(interrupted_after({}), testing::ExitedWithCode(130), "");
  EXPECT_EXIT(interrupted_after({{.what = "transient", .done = 0.5, .words = {}}}), testing::ExitedWithCode(7), "");
}

TEST(ProgressLine, BehindTheLastQuestionAnInterruptEndsTheProgram) {
  const Progress last{.what = "checks", .done = 1, .words = "all analyses done", .last = true};
  EXPECT_EXIT(interrupted_after({{.what = "transient", .done = 0.5, .words = {}}, last}), testing::ExitedWithCode(130),
              "");
  EXPECT_EXIT(interrupted_after({last, {.what = "transient", .done = 0.5, .words = {}}}), testing::ExitedWithCode(7),
              "");
}

}  // namespace taut::cli::progress_test
