#include "taut/app/cases/study/case_counter.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace taut::app::case_counter_test {

TEST(CaseCounter, TellsTheShareAndTheWords) {
  std::vector<Progress> told;
  const CaseCounter::Ask ask = [&](const Progress& p) {
    told.push_back(p);
    return true;
  };
  CaseCounter exact("study", 4, true, ask), at_most("search", 4, false, ask);
  EXPECT_TRUE(exact.go_on());
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(at_most.go_on());
  ASSERT_EQ(told.size(), 6U);
  EXPECT_EQ(told[0].what, "study");
  EXPECT_EQ(told[0].words, "1 of 4 cases");
  EXPECT_EQ(told[0].done, 0.25);
  EXPECT_EQ(told[5].words, "5 cases");
  EXPECT_EQ(told[5].done, 1) << "more than were expected";
}

TEST(CaseCounter, OnceEndedItStaysSoAndAsksNoMore) {
  int asked = 0;
  const CaseCounter::Ask ask = [&](const Progress&) { return ++asked < 3; };
  CaseCounter counter("study", 10, true, ask);
  EXPECT_TRUE(counter.go_on());
  EXPECT_TRUE(counter.go_on());
  EXPECT_FALSE(counter.ended());
  EXPECT_FALSE(counter.go_on());
  EXPECT_TRUE(counter.ended());
  EXPECT_FALSE(counter.go_on());
  EXPECT_EQ(asked, 3);
}

TEST(CaseCounter, WithoutAnAskItNeverEnds) {
  const CaseCounter::Ask none;
  CaseCounter counter("study", 1, true, none);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(counter.go_on());
  EXPECT_FALSE(counter.ended());
}

TEST(CaseCounter, ThreadsAreToldOneAtATime) {
  int inside = 0, most = 0;
  const CaseCounter::Ask ask = [&](const Progress&) {
    most = std::max(most, ++inside);
    --inside;
    return true;
  };
  CaseCounter counter("study", 2000, true, ask);
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 500; ++i) counter.go_on();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
}

}  // namespace taut::app::case_counter_test
