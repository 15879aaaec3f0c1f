#include "taut/chance/inputs.hpp"

#include "taut/base/expects.hpp"
#include "taut/chance/standard_laws.hpp"

namespace taut::chance {

Point values_at_scores(const Inputs& inputs, const Point& u) {
  expects(u.size() == inputs.of.size(), "one score for each input");
  Point x = correlated(inputs.correlation, u);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = value_at_score(inputs.of[i], x[i]);
  return x;
}

Point values_at(const Inputs& inputs, const Point& unit) {
  expects(unit.size() == inputs.of.size(), "one number for each input");
  Point u = unit;
  // points of 52 bits: 1 - p is exact
  for (double& p : u) p = p < 0.5 ? normal_score(p) : normal_score_above(1 - p);
  return values_at_scores(inputs, u);
}

Point scores_of(const Inputs& inputs, const Point& values) {
  expects(values.size() == inputs.of.size(), "one value for each input");
  Point z = values;
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = score_of(inputs.of[i], z[i]);
  return uncorrelated(inputs.correlation, z);
}

}  // namespace taut::chance
