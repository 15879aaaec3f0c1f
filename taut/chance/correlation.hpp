#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace taut::chance {

/// Two inputs and the correlation r of their scores (not of their values), -1 < r < 1.
struct CorrelatedPair {
  std::size_t first = 0, second = 0;
  double r = 0;
};

/// A Gaussian copula: the scores Z = Phi^-1(F(X)) of the inputs are jointly normal with the matrix R (Nataf;
/// Lebrun & Dutfoy 2009). R = L L^T; Z = L U with U independent. Empty: all inputs are independent.
struct Correlation {
  std::size_t inputs = 0;     ///< rows of L; 0: independent
  std::vector<double> lower;  ///< L row by row, `inputs` squared numbers, 0 above the diagonal
};

/// The correlation of `names.size()` inputs, all others than the pairs with r = 0. The error text names what is wrong:
/// a pair with itself, given twice or with |r| >= 1, or, where R is not positive definite (its least eigenvalue not
/// above 1e-10), the pairs that make it so and the factor on all r below which it is.
tl::expected<Correlation, std::string> correlation(std::span<const CorrelatedPair> pairs,
                                                   std::span<const std::string> names);

bool independent(const Correlation& c);

/// Z = L u: scores of the inputs from independent standard normal numbers. `u` has one for each input.
std::vector<double> correlated(const Correlation& c, std::vector<double> u);

/// U = L^-1 z, its inverse.
std::vector<double> uncorrelated(const Correlation& c, std::vector<double> z);

/// L^-T v; what a gradient by u becomes by z: dg/dz = L^-T dg/du.
std::vector<double> gradient_by_scores(const Correlation& c, std::vector<double> v);

}  // namespace taut::chance
