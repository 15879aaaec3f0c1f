#pragma once
#include "taut/chance/correlation.hpp"
#include "taut/chance/distribution.hpp"
#include "taut/chance/point.hpp"

namespace taut::chance {

/// What varies in a study: the law of each input, and how their scores are correlated.
struct Inputs {
  std::vector<Distribution> of;
  Correlation correlation = {};  ///< as many inputs as `of`, or empty
};

/// SI values at independent standard normal numbers u (one for each input, in their order): the standard space of FORM.
/// x_i = value_at_score(of[i], (L u)_i).
Point values_at_scores(const Inputs& inputs, const Point& u);

/// SI values at a point of the unit cube, 0 < p < 1: u_i = Phi^-1(p_i), then as above.
Point values_at(const Inputs& inputs, const Point& unit);

/// The inverse of values_at_scores; continuous laws only.
Point scores_of(const Inputs& inputs, const Point& values);

}  // namespace taut::chance
