#include "web/jobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace taut::web::jobs_test {

/// Against a test that hangs; no test waits for it to pass.
constexpr std::chrono::minutes hangs_after{10};

AskedDeck named(const std::string& name) { return {.text = "text of " + name, .name = name}; }

/// A calculation that waits until it is let go, and does what the name of its deck says.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(turn_);
    open_ = true;
    changed_.notify_all();
  }
  /// Waits until so many calculations have begun.
  void await(int count) {
    std::unique_lock lock(turn_);
    ASSERT_TRUE(changed_.wait_for(lock, hangs_after, [&] { return begun_ >= count; }));
  }
  Result operator()(const AskedDeck& deck, const std::function<bool(const Progress&)>& goes_on) {
    {
      const std::lock_guard lock(turn_);
      ++begun_;
      most_ = std::max(most_, ++at_work_);
    }
    changed_.notify_all();
    Result r;
    r.title = deck.name;
    r.interrupted = !wait(goes_on);
    const std::lock_guard lock(turn_);
    --at_work_;
    if (deck.name == "throws") throw std::logic_error("a bug");
    return r;
  }
  int begun() {
    const std::lock_guard lock(turn_);
    return begun_;
  }
  int most() {
    const std::lock_guard lock(turn_);
    return most_;
  }

 private:
  bool wait(const std::function<bool(const Progress&)>& goes_on) {
    for (int step = 0;; ++step) {
      if (!goes_on({.what = "waits", .done = 0.5, .words = std::to_string(step)})) return false;
      std::unique_lock lock(turn_);
      if (changed_.wait_for(lock, std::chrono::milliseconds(1), [&] { return open_; })) return true;
    }
  }
  std::mutex turn_;
  std::condition_variable changed_;
  bool open_ = false;
  int begun_ = 0, at_work_ = 0, most_ = 0;
};

/// Reads a job's news until it has ended.
JobNews ended(const Jobs& jobs, const std::string& id) {
  long seen = -1;
  while (true) {
    const auto news = jobs.wait(id, seen, hangs_after);
    if (!news) throw std::logic_error("no such job");
    if (news->ended()) return *news;
    if (news->version == seen) throw std::logic_error("it hangs");
    seen = news->version;
  }
}

TEST(Jobs, EndWithTheAnswerOfTheirDeck) {
  Gate gate;
  gate.open();
  Jobs jobs({.threads = 3}, std::ref(gate));
  std::vector<std::string> ids;
  ids.reserve(50);
  for (int i = 0; i < 50; ++i) ids.push_back(jobs.add(named("deck " + std::to_string(i))).value());
  for (int i = 0; i < 50; ++i) {
    const std::string& id = ids[static_cast<std::size_t>(i)];
    EXPECT_EQ(ended(jobs, id).state, JobState::done);
    ASSERT_TRUE(jobs.end(id));
    EXPECT_EQ(jobs.end(id)->result->title, "deck " + std::to_string(i));
    EXPECT_NE(jobs.end(id)->answer->find("{\"page\":{\"title\":\"deck " + std::to_string(i) + "\""), std::string::npos);
    EXPECT_EQ(jobs.deck(id)->text, "text of deck " + std::to_string(i));
  }
  EXPECT_EQ(jobs.list().size(), 50U);
  EXPECT_LE(gate.most(), 3);
}

TEST(Jobs, SoManyAreAtWorkAndTheOthersWait) {
  Gate gate;
  Jobs jobs({.threads = 2, .waiting = 3}, std::ref(gate));
  jobs.add(named("a"));
  jobs.add(named("b"));
  gate.await(2);
  for (const char* name : {"c", "d", "e"}) EXPECT_TRUE(jobs.add(named(name)));
  EXPECT_FALSE(jobs.add(named("f"))) << "the queue is full";
  EXPECT_EQ(jobs.news("3")->state, JobState::waiting);
  EXPECT_FALSE(jobs.end("1"));
  gate.open();
  for (const char* id : {"1", "2", "3", "4", "5"}) EXPECT_EQ(ended(jobs, id).state, JobState::done);
  EXPECT_EQ(gate.most(), 2);
}

TEST(Jobs, StopGivesWhatThereIs) {
  Gate gate;
  Jobs jobs({.threads = 1}, std::ref(gate));
  const std::string running = jobs.add(named("a")).value();
  const std::string waiting = jobs.add(named("b")).value();
  gate.await(1);
  EXPECT_TRUE(jobs.stop(waiting));
  EXPECT_EQ(jobs.news(waiting)->state, JobState::stopped);
  EXPECT_FALSE(jobs.end(waiting)->result);
  EXPECT_EQ(*jobs.end(waiting)->answer, "{\"failure\":\"stopped before it began\"}");
  EXPECT_TRUE(jobs.stop(running));
  EXPECT_EQ(ended(jobs, running).state, JobState::stopped);
  EXPECT_TRUE(jobs.end(running)->result->interrupted);
  EXPECT_TRUE(jobs.stop(running)) << "once more is no harm";
  EXPECT_FALSE(jobs.stop("4711"));
  EXPECT_EQ(gate.begun(), 1);
}

TEST(Jobs, ABugOfACalculationIsItsAnswer) {
  Gate gate;
  gate.open();
  Jobs jobs({.threads = 1}, std::ref(gate));
  const std::string id = jobs.add(named("throws")).value();
  EXPECT_EQ(ended(jobs, id).state, JobState::failed);
  EXPECT_EQ(*jobs.end(id)->answer, "{\"failure\":\"a bug\"}");
  EXPECT_EQ(ended(jobs, jobs.add(named("next")).value()).state, JobState::done);
}

TEST(Jobs, TellHowFarTheyAre) {
  Gate gate;
  Jobs jobs({.threads = 1}, std::ref(gate));
  const std::string id = jobs.add(named("a")).value();
  JobNews news = *jobs.news(id);
  for (int i = 0; i < 20 && news.progress.what.empty(); ++i) news = *jobs.wait(id, news.version, hangs_after);
  EXPECT_EQ(news.progress.what, "waits");
  EXPECT_EQ(news.progress.done, 0.5);
  EXPECT_EQ(jobs.wait(id, -1, std::chrono::milliseconds(0))->state, JobState::running);
  EXPECT_FALSE(jobs.wait("4711", 0, hangs_after));
}

TEST(Jobs, OnlyTheLatestOfThoseEndedAreKept) {
  Gate gate;
  gate.open();
  Jobs jobs({.threads = 2, .ended = 5}, std::ref(gate));
  for (int i = 0; i < 20; ++i) ended(jobs, jobs.add(named("a")).value());
  ASSERT_EQ(jobs.list().size(), 5U);
  EXPECT_EQ(jobs.list().front().id, "16");
  EXPECT_FALSE(jobs.news("15"));
  Jobs small({.threads = 1, .bytes = 100}, std::ref(gate));
  EXPECT_FALSE(small.add({.text = std::string(101, 'x')})) << "larger than all that may wait";
  for (int i = 0; i < 3; ++i) ended(small, small.add(named("a")).value());
  EXPECT_EQ(small.list().size(), 1U) << "the latest is kept whatever its size";
}

TEST(Jobs, ADroppedOneIsGoneAndTheOthersGoOn) {
  Gate gate;
  Jobs jobs({.threads = 1}, std::ref(gate));
  const std::string a = jobs.add(named("a")).value(), b = jobs.add(named("b")).value();
  gate.await(1);
  EXPECT_TRUE(jobs.drop(a));
  EXPECT_FALSE(jobs.news(a));
  EXPECT_FALSE(jobs.drop(a));
  gate.await(2);
  gate.open();
  EXPECT_EQ(ended(jobs, b).state, JobState::done);
}

TEST(Jobs, ManyThreadsAskAtTheSameTime) {
  Gate gate;
  gate.open();
  Jobs jobs({.threads = 4, .ended = 10}, std::ref(gate));
  std::vector<std::thread> askers;
  askers.reserve(8);
  std::atomic<int> added = 0;
  for (int k = 0; k < 8; ++k) {
    askers.emplace_back([&, k] {
      for (int i = 0; i < 40; ++i) {
        const auto id = jobs.add(named(std::to_string(k)));
        if (!id) continue;
        ++added;
        if (i % 3 == 0) jobs.stop(*id);
        if (i % 5 == 0) jobs.drop(*id);
        jobs.wait(*id, -1, std::chrono::milliseconds(1));
        jobs.list();
        jobs.end(*id);
      }
    });
  }
  for (std::thread& one : askers) one.join();
  EXPECT_GT(added, 0);
}

TEST(Jobs, TheEndOfAllStopsThoseAtWork) {
  Gate gate;
  {
    Jobs jobs({.threads = 2}, std::ref(gate));
    for (int i = 0; i < 10; ++i) jobs.add(named("a"));
    gate.await(2);
  }
  EXPECT_EQ(gate.begun(), 2);
}

}  // namespace taut::web::jobs_test
