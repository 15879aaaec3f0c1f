#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics::events_test {

int count(const Run& run, const std::string& what) {
  const auto& all = run.result.events;
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const auto& e) { return e.what == what; }));
}

// A rope that goes slack a hundred times a second fills the list; another one that goes slack after that is news.
TEST(Events, WhatAVerdictReadsIsKeptHoweverManyThereAre) {
  const machine::Model model;
  const TransientOptions options;
  dynamics::Run run{.model = model, .options = options};
  for (int i = 0; i < 30000; ++i) note(run, 0.01 * i, i % 2 == 0 ? "slack" : "taut", "a");
  const std::size_t full = run.result.events.size();
  EXPECT_LT(full, 30000U);
  EXPECT_EQ(count(run, "cut"), 1);
  note(run, 300, "taut", "b");
  EXPECT_EQ(run.result.events.size(), full);
  for (const char* const what : {"slack", "lift_off", "break", "stop", "unstable"}) {
    note(run, 301, what, "b");
    EXPECT_EQ(run.result.events.back().what, what);
    EXPECT_EQ(run.result.events.back().t, 301);
  }
  const std::size_t kept = run.result.events.size();
  note(run, 302, "slack", "b");
  note(run, 302, "slack", "a");
  EXPECT_EQ(run.result.events.size(), kept) << "the first one tells";
  EXPECT_EQ(count(run, "cut"), 1);
}

}  // namespace taut::solve::dynamics::events_test
