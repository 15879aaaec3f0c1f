#include "taut/math/linear_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace taut::linear_system_test {

/// A chain of springs k_i between `n` bodies and two walls; the bodies named in `loose` hang on nothing.
Entries chain(int n, const Array<int>& loose = {}) {
  Entries A;
  A.reset(n);
  const auto held = [&](int i) { return std::find(loose.begin(), loose.end(), i) == loose.end(); };
  for (int i = 0; i <= n; ++i) {
    const double k = 1 + 0.5 * std::sin(i);
    const bool first = i > 0 && held(i - 1), second = i < n && held(i);
    if (first) A.add(i - 1, i - 1, k);
    if (second) A.add(i, i, k);
    if (first && second) A.add(i - 1, i, -k);
    if (first && second) A.add(i, i - 1, -k);
  }
  return A;
}

class OfBothKinds : public testing::TestWithParam<int> {};  // small: full; large: sparse
INSTANTIATE_TEST_SUITE_P(LinearSystem, OfBothKinds, testing::Values(5, 100, 1000));

TEST_P(OfBothKinds, SolvesInTheUnitsOfItsUnknowns) {
  const int n = GetParam();
  const Entries A = chain(n);
  const Eigen::VectorXd scale = Eigen::VectorXd::LinSpaced(n, 0.5, 20), x = Eigen::VectorXd::LinSpaced(n, -3, 7);
  LinearSystem system;
  system.factor(A, scale);
  EXPECT_FALSE(system.singular());
  EXPECT_EQ(system.undetermined().size(), 0);
  const Eigen::VectorXd b = A.columns() * x;
  EXPECT_LT((scale.cwiseProduct(system.solve(b)) - x).norm(), 1e-9 * x.norm());
  EXPECT_LT((A.dense() * x - b).norm(), 1e-12 * b.norm());
}

TEST_P(OfBothKinds, LeavesAloneWhatNoRowDetermines) {
  const int n = GetParam();
  const Entries A = chain(n, {1, 3});
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, 1, 2);
  LinearSystem system;
  system.factor(A, Eigen::VectorXd::Ones(n));
  EXPECT_TRUE(system.singular());
  const Eigen::VectorXd found = system.solve(A.columns() * x), open = system.undetermined();
  ASSERT_EQ(open.size(), n);
  for (int i = 0; i < n; ++i) {
    const bool loose = i == 1 || i == 3;
    EXPECT_NEAR(open[i], loose ? 1 : 0, 1e-9) << i;
    EXPECT_NEAR(found[i], loose ? 0 : x[i], 1e-8) << i;
  }
}

TEST(LinearSystem, IsUsedAgainForAnotherPattern) {
  LinearSystem system;
  for (const int n : {300, 200, 300}) {
    const Entries A = chain(n);
    system.factor(A, Eigen::VectorXd::Ones(n));
    const Eigen::VectorXd x = Eigen::VectorXd::Ones(n);
    EXPECT_LT((system.solve(A.columns() * x) - x).norm(), 1e-9);
  }
}

}  // namespace taut::linear_system_test
