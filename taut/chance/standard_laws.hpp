#pragma once

namespace taut::chance {

// The standard laws that estimates and intervals need, by Boost.Math 1.74 in double. "Below" is P(X <= x), "above" is
// P(X > x); each is accurate in its own small tail (relative error about 1e-15), so a small chance is never 1 - p.

double normal_density(double z);
double normal_below(double z);
double normal_above(double z);

/// The score z with normal_below(z) = p; 0 <= p <= 1, -inf at 0, +inf at 1. For a p near 1 take normal_score_above.
double normal_score(double p);
/// The score z with normal_above(z) = q.
double normal_score_above(double q);

/// t with P(T <= t) = p of Student's law; 0 < p < 1, freedom > 0.
double student_value(double p, double freedom);

/// P(X > x) of the chi-squared law; x >= 0, freedom > 0.
double chi_squared_above(double x, double freedom);

/// x with P(X <= x) = p of the beta law with shapes a, b > 0; 0 <= p <= 1.
double beta_value(double p, double a, double b);

/// P(K <= k) of the binomial law, k of n with chance p each; 0 if k < 0, 1 if k >= n.
double binomial_below(double k, double n, double p);

}  // namespace taut::chance
