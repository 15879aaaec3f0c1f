#include "taut/design/sizing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace taut::design::sizing_test {

using Choice = std::vector<std::size_t>;

/// All choices of the lists, by counting.
std::vector<Choice> all_of(const std::vector<std::vector<double>>& costs) {
  std::vector<Choice> all = {{}};
  for (const auto& list : costs) {
    std::vector<Choice> longer;
    for (const Choice& head : all) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        longer.push_back(head);
        longer.back().push_back(i);
      }
    }
    all = std::move(longer);
  }
  return all;
}

double cost_of(const std::vector<std::vector<double>>& costs, const Choice& choice) {
  double cost = 0;
  for (std::size_t k = 0; k < choice.size(); ++k) cost += costs[k][choice[k]];
  return cost;
}

// Random lists and random, not monotone, answers: the search finds what counting finds, and nothing cheaper passes.
TEST(Sizing, agrees_with_brute_force_on_200_random_cases) {
  std::mt19937 random(20261121);
  for (int run = 0; run < 200; ++run) {
    std::vector<std::vector<double>> costs(1 + random() % 3);
    for (auto& list : costs) {
      list.resize(1 + random() % 12);
      for (double& x : list) x = static_cast<double>(random() % 50);  // with equal ones
      std::sort(list.begin(), list.end());
    }
    const std::vector<Choice> all = all_of(costs);
    std::vector<bool> passes(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) passes[i] = random() % 8 == 0;
    const auto answer = cheapest(costs, [&](const Choice& c) {
      const auto at = std::find(all.begin(), all.end(), c);
      return SizingTrial{
          .passes = passes[static_cast<std::size_t>(at - all.begin())], .utilisation = 0.5, .governs = "x"};
    });
    double least = -1;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (passes[i] && (least < 0 || cost_of(costs, all[i]) < least)) least = cost_of(costs, all[i]);
    }
    EXPECT_EQ(answer.outcome.ok(), least >= 0) << run;
    if (!answer.outcome.ok()) continue;
    EXPECT_EQ(answer.best.cost, least) << run;
    EXPECT_EQ(cost_of(costs, answer.best.choice), least) << run;
    for (const auto& other : answer.above) EXPECT_GE(other.cost, least);
    for (const auto& other : answer.below) EXPECT_LE(other.cost, least);
  }
}

TEST(Sizing, each_choice_is_tried_once_and_in_order) {
  const std::vector<std::vector<double>> costs = {{1, 2, 5}, {0, 3}, {1, 1, 4}};
  std::vector<Choice> seen;
  const auto answer = cheapest(costs, [&](const Choice& c) {
    seen.push_back(c);
    return SizingTrial{};
  });
  EXPECT_FALSE(answer.outcome.ok());
  EXPECT_EQ(seen.size(), 18U);
  for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_LE(cost_of(costs, seen[i - 1]), cost_of(costs, seen[i]));
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
}

TEST(Sizing, spent_trials_are_told) {
  SizingOptions options;
  options.most_trials = 3;
  const auto answer = cheapest(
      {{1, 2, 3, 4, 5}}, [](const Choice&) { return SizingTrial{}; }, options);
  EXPECT_EQ(answer.outcome.status, Status::not_converged);
  EXPECT_EQ(answer.trials, 3U);
}

// What is measured has no order: all are tried, the least that passes is found, those that fail stand nearest last.
TEST(Sizing, measured_agrees_with_counting_on_200_random_cases) {
  std::mt19937 random(7);
  for (int run = 0; run < 200; ++run) {
    std::vector<std::vector<double>> lists(random() % 4);  // also none
    for (auto& list : lists) list.resize(1 + random() % 6);
    const std::vector<Choice> all = all_of(lists);
    std::vector<SizingTrial> trials(all.size());
    for (SizingTrial& t : trials) {
      t.passes = random() % 4 == 0;
      t.utilisation = static_cast<double>(random() % 100) / 50;
      t.measured = static_cast<double>(random() % 20);
    }
    std::vector<std::size_t> counts;
    counts.reserve(lists.size());
    for (const auto& list : lists) counts.push_back(list.size());
    const auto answer = least_measured(counts, [&](const Choice& c) {
      return trials[static_cast<std::size_t>(std::find(all.begin(), all.end(), c) - all.begin())];
    });
    EXPECT_EQ(answer.trials, all.size());
    double least = HUGE_VAL;
    for (const SizingTrial& t : trials) least = t.passes ? std::min(least, t.measured) : least;
    ASSERT_EQ(answer.outcome.ok(), least < HUGE_VAL);
    EXPECT_EQ(answer.outcome.ok() ? answer.best.cost : HUGE_VAL, least);
    for (std::size_t i = 1; i < answer.below.size(); ++i) {
      EXPECT_GE(answer.below[i - 1].trial.utilisation, answer.below[i].trial.utilisation);
    }
  }
}

TEST(Sizing, too_many_to_measure_are_not_tried) {
  SizingOptions options;
  options.most_trials = 8;
  const auto never = [](const Choice&) -> SizingTrial {
    ADD_FAILURE();
    return {};
  };
  EXPECT_EQ(least_measured({3, 3}, never, options).outcome.status, Status::not_converged);
}

TEST(Sizing, what_is_skipped_does_not_count) {
  SizingOptions options;
  options.most_trials = 2;
  const auto one = [](const Choice& c) {
    SizingTrial t;
    t.skipped = c[0] < 3;
    t.passes = c[0] == 4;
    return t;
  };
  const auto a = cheapest({{1, 2, 3, 4, 5}}, one, options);
  EXPECT_TRUE(a.outcome.ok());
  EXPECT_EQ(a.trials, 2U);
  EXPECT_EQ(a.below.size(), 1U);
}

// Whatever is set aside, the answer after its trials is that of counting.
TEST(Sizing, what_is_set_aside_is_tried_after_all) {
  std::mt19937 random(11);
  for (int run = 0; run < 200; ++run) {
    std::vector<std::vector<double>> costs(1 + random() % 3);
    for (auto& list : costs) {
      list.resize(1 + random() % 5);
      for (double& one : list) one = static_cast<double>(random() % 9);
      std::sort(list.begin(), list.end());
    }
    const std::vector<Choice> all = all_of(costs);
    std::vector<SizingTrial> trials(all.size());
    for (SizingTrial& t : trials) {
      t.passes = random() % 6 == 0;
      t.utilisation = static_cast<double>(random() % 100) / 50;
      t.measured = static_cast<double>(random() % 20);
      t.skipped = random() % 3 == 0;
    }
    std::vector<std::size_t> counts;
    counts.reserve(costs.size());
    for (const auto& list : costs) counts.push_back(list.size());
    const bool measured = run % 2 == 0;
    const auto first = [&](const Choice& c) {
      SizingTrial t = trials[static_cast<std::size_t>(std::find(all.begin(), all.end(), c) - all.begin())];
      t.passes = t.passes && !t.skipped;
      return t;
    };
    const auto after = [&](const Choice& c) {
      SizingTrial t = trials[static_cast<std::size_t>(std::find(all.begin(), all.end(), c) - all.begin())];
      t.skipped = false;
      return t;
    };
    auto answer = measured ? least_measured(counts, first) : cheapest(costs, first);
    try_aside(answer, after, all.size());
    EXPECT_TRUE(answer.aside.empty());
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (trials[i].passes) least = std::min(least, measured ? trials[i].measured : cost_of(costs, all[i]));
    }
    ASSERT_EQ(answer.outcome.ok(), least < HUGE_VAL) << run;
    if (!answer.outcome.ok()) continue;
    EXPECT_EQ(answer.best.cost, least) << run;
    EXPECT_TRUE(answer.best.trial.passes);
    for (const auto& other : answer.above) EXPECT_GE(other.cost, least);
    if (measured) continue;
    for (const auto& other : answer.below) EXPECT_LE(other.cost, least);
  }
}

TEST(Sizing, what_is_left_aside_is_told) {
  const auto first = [](const Choice& c) {
    SizingTrial t;
    t.skipped = c[0] < 3;
    t.passes = c[0] == 4;
    return t;
  };
  const auto after = [](const Choice& c) {
    SizingTrial t;
    t.passes = c[0] == 2;
    return t;
  };
  auto a = cheapest({{1, 2, 3, 4, 5}}, first);
  ASSERT_EQ(a.aside.size(), 3U);
  try_aside(a, after, 1);  // the costliest comes first
  EXPECT_EQ(a.best.choice, Choice{2});
  EXPECT_EQ(a.above.front().choice, Choice{4});
  EXPECT_EQ(a.aside.size(), 2U);
  EXPECT_TRUE(a.below.empty());  // it was costlier
}

// Without an answer those that are left are the nearest to it, not the last.
TEST(Sizing, without_an_answer_the_nearest_are_kept) {
  SizingOptions options;
  options.neighbours = 2;
  const std::vector<double> use = {5, 1.2, 7, 1.1, std::nan(""), 9};
  const auto one = [&](const Choice& c) {
    SizingTrial t;
    t.utilisation = use[c[0]];
    return t;
  };
  const auto a = cheapest({{1, 2, 3, 4, 5, 6}}, one, options);
  ASSERT_EQ(a.below.size(), 2U);
  EXPECT_EQ(a.below[0].choice, Choice{1});
  EXPECT_EQ(a.below[1].choice, Choice{3});
}

TEST(Sizing, ends_when_a_trial_says_so) {
  int calls = 0;
  const auto one = [&](const Choice&) {
    SizingTrial t;
    t.passes = ++calls == 2;
    t.ended = calls == 4;
    return t;
  };
  const auto a = cheapest({{1, 2, 3, 4, 5, 6}}, one);
  EXPECT_TRUE(a.ended);
  EXPECT_TRUE(a.outcome.ok());
  EXPECT_EQ(a.best.choice, Choice{1});
  calls = 2;
  const auto none = least_measured({6}, one);
  EXPECT_TRUE(none.ended);
  EXPECT_FALSE(none.outcome.ok());
}

}  // namespace taut::design::sizing_test
