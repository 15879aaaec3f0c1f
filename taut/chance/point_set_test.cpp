#include "taut/chance/point_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <set>

#include "taut/base/expects.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance::point_set_test {

/// How many points of a replicate lie in each of a by b equal rectangles over two inputs.
std::vector<int> rectangles(const PointSet& set, std::size_t replicate, const std::array<std::size_t, 2>& inputs,
                            std::size_t a, std::size_t b) {
  std::vector<int> counts(a * b, 0);
  for (std::uint64_t k = 0; k < set.per_replicate(); ++k) {
    const Point p = set.at(replicate * set.per_replicate() + k);
    const auto i = static_cast<std::size_t>(p[inputs[0]] * static_cast<double>(a));
    const auto j = static_cast<std::size_t>(p[inputs[1]] * static_cast<double>(b));
    ++counts[i * b + j];
  }
  return counts;
}

bool all_alike(const std::vector<int>& counts) {
  return std::all_of(counts.begin(), counts.end(), [&](int c) { return c == counts.front(); });
}

TEST(PointSet, sizes) {
  const PointSet random(PointKind::random, 2, 1000, 1);
  EXPECT_EQ(random.size(), 1000u);
  EXPECT_EQ(random.replicates(), 1u);
  const PointSet latin(PointKind::latin, 2, 1000, 1);
  EXPECT_EQ(latin.replicates(), 16u);
  EXPECT_EQ(latin.per_replicate(), 63u);
  const PointSet sobol(PointKind::sobol, 2, 100000, 1);
  EXPECT_EQ(sobol.per_replicate(), 4096u);
  EXPECT_EQ(sobol.replicates(), 25u);
  EXPECT_EQ(sobol.size(), 102400u);
  EXPECT_EQ(PointSet(PointKind::sobol, 1, 1, 1).size(), 16u);
  EXPECT_EQ(PointSet(PointKind::sobol, 1, 16ULL * 1024, 1).size(), 16u * 1024);
  EXPECT_THROW(PointSet(PointKind::sobol, 4000, 10, 1), ContractViolation);
}

// Same bits whatever was asked before; another seed gives others.
TEST(PointSet, a_point_is_a_function_of_seed_and_index) {
  for (const PointKind kind : {PointKind::random, PointKind::latin, PointKind::sobol}) {
    const PointSet set(kind, 5, 4000, 7);
    const PointSet again(kind, 5, 4000, 7);
    const PointSet other(kind, 5, 4000, 8);
    for (std::uint64_t k = set.size(); k-- > 0;) {
      const Point p = set.at(k);
      EXPECT_EQ(p, again.at(k));
      EXPECT_NE(p, other.at(k));
      for (const double x : p) EXPECT_TRUE(x > 0 && x < 1);
    }
  }
}

TEST(PointSet, latin_has_one_point_in_each_interval) {
  for (const std::uint64_t samples : {16u * 3, 16u * 100, 16u * 63}) {
    const PointSet set(PointKind::latin, 3, samples, 5);
    const std::uint64_t n = set.per_replicate();
    for (std::size_t r = 0; r < 16; ++r) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::set<std::uint64_t> seen;
        for (std::uint64_t k = 0; k < n; ++k) {
          seen.insert(static_cast<std::uint64_t>(set.at(r * n + k)[i] * static_cast<double>(n)));
        }
        EXPECT_EQ(seen.size(), n);
      }
    }
  }
}

// All permutations of four are as frequent: chi squared with 23 degrees of freedom.
TEST(PointSet, shuffles_are_uniform) {
  std::vector<double> counts(256, 0);
  constexpr int keys = 24000;
  for (std::uint64_t key = 0; key < keys; ++key) {
    std::size_t word = 0;
    for (std::uint64_t i = 0; i < 4; ++i) word = word * 4 + shuffled(i, 4, key * 0x9E3779B97F4A7C15);
    ++counts[word];
  }
  double chi_squared = 0;
  int permutations = 0;
  for (const double c : counts) {
    if (c == 0) continue;
    ++permutations;
    chi_squared += (c - keys / 24.) * (c - keys / 24.) / (keys / 24.);
  }
  EXPECT_EQ(permutations, 24);
  EXPECT_GT(chi_squared_above(chi_squared, 23), 1e-4);
  EXPECT_EQ(shuffled(0, 1, 99), 0u);
  for (const std::uint64_t n : {5u, 8u, 1000u}) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < n; ++i) seen.insert(shuffled(i, n, 12));
    EXPECT_EQ(seen.size(), n);
    EXPECT_EQ(*seen.rbegin(), n - 1);
  }
}

// Scrambling keeps the net: 256 points of the first two inputs in every shape of 256 equal rectangles, one each; of any
// input one in each of 256 intervals; of the inputs 3 and 6, whose directions have 3 and 4 bits of polynomial, in 4
// x 4.
TEST(PointSet, sobol_is_a_net) {
  const PointSet set(PointKind::sobol, 40, 16ULL * 256, 11);
  ASSERT_EQ(set.per_replicate(), 256u);
  for (const std::size_t r : {0u, 7u, 15u}) {
    for (const std::size_t a : {1u, 2u, 8u, 16u, 64u, 256u})
      EXPECT_TRUE(all_alike(rectangles(set, r, {0, 1}, a, 256 / a)));
    for (std::size_t i = 0; i < 40; ++i) EXPECT_TRUE(all_alike(rectangles(set, r, {i, i}, 256, 1)));
    EXPECT_TRUE(all_alike(rectangles(set, r, {3, 6}, 4, 4)));
  }
}

// The directions are those of Boost's own generator (which leaves out the point 0): a scramble permutes the 16 x 16
// squares of two inputs, so their counts are the same but for order, of all pairs of twelve inputs.
TEST(PointSet, directions_are_those_of_boost) {
  constexpr std::size_t inputs = 12;
  const PointSet set(PointKind::sobol, inputs, 16ULL * 256, 11);
  boost::random::sobol engine(inputs);
  std::vector<std::vector<std::size_t>> places(256, std::vector<std::size_t>(inputs, 0));
  for (std::size_t k = 1; k < 256; ++k) {
    for (std::size_t& place : places[k]) place = engine() >> 60;
  }
  for (std::size_t i = 0; i < inputs; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<int> theirs(256, 0);
      for (const auto& place : places) ++theirs[place[i] * 16 + place[j]];
      std::vector<int> ours = rectangles(set, 5, {i, j}, 16, 16);
      std::sort(theirs.begin(), theirs.end());
      std::sort(ours.begin(), ours.end());
      EXPECT_EQ(ours, theirs) << i << ' ' << j;
    }
  }
}

// Replicates are independent of each other and unbiased: the means of u over 400 scrambles of one point lie as the
// means of random numbers do (5 standard deviations).
TEST(PointSet, scrambles_are_uniform) {
  double sum = 0;
  double products = 0;
  constexpr int seeds = 400;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const PointSet set(PointKind::sobol, 2, 16ULL * 8, seed);
    const Point p = set.at(3);
    const Point q = set.at(8 + 3);
    sum += p[1];
    products += (p[1] - 0.5) * (q[1] - 0.5);
  }
  EXPECT_NEAR(sum / seeds, 0.5, 5 * std::sqrt(1. / 12 / seeds));
  EXPECT_NEAR(products / seeds, 0, 5. / 12 / std::sqrt(seeds));
}

// The integral of prod (1 + (x_i - 1/2)/2) over eight inputs is 1: Sobol points are far better than random ones.
TEST(PointSet, sobol_integrates_a_smooth_function) {
  const auto error = [](PointKind kind) {
    const PointSet set(kind, 8, 16ULL * 1024, 2);
    double sum = 0;
    for (std::uint64_t k = 0; k < set.size(); ++k) {
      double product = 1;
      for (const double x : set.at(k)) product *= 1 + (x - 0.5) / 2;
      sum += product;
    }
    return std::abs(sum / static_cast<double>(set.size()) - 1);
  };
  EXPECT_LT(error(PointKind::sobol), 2e-4);
  EXPECT_LT(error(PointKind::random), 2e-2);
}

TEST(PointSet, grid) {
  const std::vector<std::uint64_t> sizes{2, 3, 4};
  EXPECT_EQ(grid_size(sizes), 24u);
  EXPECT_EQ(grid_places(sizes, 0), (std::vector<std::uint64_t>{0, 0, 0}));
  EXPECT_EQ(grid_places(sizes, 5), (std::vector<std::uint64_t>{0, 1, 1}));
  EXPECT_EQ(grid_places(sizes, 23), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(grid_size({1u << 31, 1u << 31, 8}), 0u);
  EXPECT_EQ(grid_size({}), 1u);
}

}  // namespace taut::chance::point_set_test
