#include "taut/study/deck/watch.hpp"

#include <fmt/format.h>

#include "test/support/machine_decks.hpp"

namespace taut::study::watch_test {

using namespace taut_test;

struct Asked {
  std::string analysis, table, what;
  std::size_t states;
  bool sums = true;  ///< whether the table says something of a part, too
};

const std::vector<Asked>& asked() {
  static const std::vector<Asked> all = {
      {.analysis = "load_path: {carriage: car, from: 130 m, to: 220 m, steps: 9}",
       .table = "load_path",
       .what = "load path",
       .states = 10},
      {.analysis = "payload: {carriage: car, from: 130 m, to: 220 m, steps: 9, limits: {skyline: {tension: 90 kN}}}",
       .table = "payload",
       .what = "payload",
       .states = 10},
      {.analysis = "cycle: {carriage: car, from: 130 m, to: 220 m, steps: 9, phases: [{name: a, motion: out}, {name: "
                   "b, motion: "
                   "in}]}",
       .table = "cycle",
       .what = "cycle",
       .states = 20,
       .sums = false},
      {.analysis = "sweep: {parameter: \"loads[0].mass\", from: 0 t, to: 1 t, steps: 9, carriage: car, x: 170 m}",
       .table = "sweep",
       .what = "sweep",
       .states = 10},
      {.analysis = "envelope: {carriage: car, from: 130 m, to: 220 m, steps: 9, loads: [0 t, 1 t], motions: [in, out]}",
       .table = "envelope",
       .what = "envelope",
       .states = 40,
       .sums = false},
  };
  return all;
}

std::string words_of(const Cell& cell) {
  if (const auto* x = std::get_if<double>(&cell)) return fmt::format("{:.17g}", *x);
  return std::get<std::string>(cell);
}

Result run_until(const std::string& analysis, std::size_t last, std::vector<Progress>& reported) {
  app::Job job;
  job.text = skyline_deck("  - " + analysis);
  job.progress = [&reported, last](const Progress& p) {
    if (p.last) return true;
    reported.push_back(p);
    return reported.size() < last;
  };
  return app::run(job);
}

TEST(Watch, TellsEveryStateOfALongAnalysis) {
  for (const Asked& one : asked()) {
    SCOPED_TRACE(one.what);
    std::vector<Progress> reported;
    const Result r = run_until(one.analysis, 1000, reported);
    ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_FALSE(r.interrupted);
    ASSERT_EQ(reported.size(), one.states);
    for (std::size_t i = 0; i < reported.size(); ++i) {
      EXPECT_EQ(reported[i].what, one.what);
      EXPECT_NEAR(reported[i].done, static_cast<double>(i) / static_cast<double>(one.states), 1e-12);
      EXPECT_FALSE(reported[i].words.empty());
    }
  }
}

// Who asked holds an interrupt back until it is heard: behind the last question nobody would hear it.
TEST(Watch, ItIsToldThatNobodyAsksAnyMore) {
  for (const bool goes_on : {true, false}) {
    std::vector<bool> last;
    app::Job job;
    job.text = skyline_deck("  - " + asked()[0].analysis + "\n  - " + asked()[1].analysis);
    job.progress = [&](const Progress& p) {
      last.push_back(p.last);
      return goes_on || !p.last;
    };
    const Result r = app::run(job);
    ASSERT_EQ(last.size(), asked()[0].states + asked()[1].states + 1);
    EXPECT_EQ(std::count(last.begin(), last.end(), true), 1);
    EXPECT_TRUE(last.back());
    EXPECT_EQ(r.interrupted, !goes_on);
    EXPECT_EQ(r.message, goes_on ? "" : "interrupted behind the last analysis");
    EXPECT_NE(r.find_table("payload"), nullptr) << "what was done stays";
  }
}

TEST(Watch, OfACycleTheFinishedPhasesStay) {
  const Asked& cycle =
      *std::find_if(asked().begin(), asked().end(), [](const Asked& one) { return one.what == "cycle"; });
  std::vector<Progress> reported;
  const Result whole = run_until(cycle.analysis, 1000, reported);
  const std::size_t all = reported.size();
  for (const std::size_t left : {std::size_t{1}, std::size_t{10}}) {
    reported.clear();
    const Result r = run_until(cycle.analysis, all - left + 1, reported);
    EXPECT_EQ(exit_code(r), 130);
    const Table& positions = table_of(r, "cycle");
    EXPECT_EQ(positions.rows.size(), all - left);
    for (std::size_t i = 0; i < positions.rows.size(); ++i) {
      EXPECT_EQ(words_of(positions.rows[i][2]), words_of(table_of(whole, "cycle").rows[i][2])) << i;
    }
    const Table& work = table_of(r, "cycle_work");
    EXPECT_EQ(2 * work.rows.size(), table_of(whole, "cycle_work").rows.size());
    EXPECT_GT(cell(work, 0, "pull_max"), 0);
  }
}

TEST(Watch, WhatWasComputedBeforeStays) {
  for (const Asked& one : asked()) {
    SCOPED_TRACE(one.what);
    for (const std::size_t last : {std::size_t{1}, std::size_t{5}, one.states}) {
      std::vector<Progress> reported;
      const Result r = run_until(one.analysis, last, reported);
      EXPECT_TRUE(r.interrupted);
      EXPECT_EQ(exit_code(r), 130);
      EXPECT_EQ(reported.size(), last) << "asked no more";
      EXPECT_NE(r.message.find(one.what + ": interrupted before " + reported.back().words), std::string::npos)
          << r.message;
      const Table* t = r.find_table(one.table);
      if (last == 1) {
        EXPECT_TRUE(t == nullptr || t->rows.empty());
      } else if (one.sums) {
        ASSERT_NE(t, nullptr);
        EXPECT_EQ(t->rows.size(), last - 1);
        std::vector<Progress> all;
        const Result whole = run_until(one.analysis, 1000, all);
        const Table& complete = table_of(whole, one.table);
        for (std::size_t i = 0; i < t->rows.size(); ++i) {
          for (std::size_t k = 0; k < t->columns.size(); ++k) {
            EXPECT_EQ(words_of(t->rows[i][k]), words_of(complete.rows[i][k])) << i << " " << t->columns[k].name;
          }
        }
      }
    }
  }
}

TEST(Watch, NothingIsBegunBehindAnInterruption) {
  std::vector<Progress> reported;
  const Result r = run_until(asked()[0].analysis + "\n  - " + asked()[1].analysis, 3, reported);
  EXPECT_EQ(r.find_table("payload"), nullptr);
  EXPECT_EQ(reported.size(), 3U);
}

}  // namespace taut::study::watch_test
