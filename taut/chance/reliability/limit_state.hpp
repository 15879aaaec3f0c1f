#pragma once
#include <cstdint>
#include <utility>

#include "taut/chance/inputs.hpp"
#include "taut/chance/statistics.hpp"

namespace taut::chance {

/// One output of the model against a limit, over independent standard normal scores u of the inputs: g(u) is the
/// margin of the output at values_at_scores(inputs, u); the limit is not kept where g < 0. NaN: a failed case. It
/// counts its cases, so one thread asks at a time; the model may share a batch among threads.
class LimitState {
 public:
  /// `output` is the column of the model's rows.
  LimitState(Inputs inputs, Evaluate evaluate, std::size_t output, Limit limit)
      : inputs_(std::move(inputs)), evaluate_(std::move(evaluate)), output_(output), limit_(limit) {}

  const Inputs& inputs() const { return inputs_; }
  std::size_t size() const { return inputs_.of.size(); }
  /// g at each of the points, in one batch of the model.
  std::vector<double> margins(const Points& scores) const;
  /// Points given to the model so far.
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  Inputs inputs_;
  Evaluate evaluate_;
  std::size_t output_;
  Limit limit_;
  mutable std::uint64_t evaluations_ = 0;
};

/// g and its derivatives by the scores at a point.
struct Slope {
  double margin = 0;             ///< NaN: failed
  std::vector<double> gradient;  ///< NaN where neither side of the point has a value
  double steepness = 0;          ///< |gradient|; NaN where a component is
};

/// Central differences over u_i - step, u_i + step; one-sided where one of both failed. One batch of 2 n + 1.
Slope slope(const LimitState& state, const Point& u, double step);

/// The noise of g near u: the standard deviation of its irregular part, from the fourth to sixth differences of seven
/// points 1e-3 apart along the diagonal (Hamming's difference table; More & Wild 2011, section 3). 0 where a case
/// failed. Rounding, the tolerance of a solver and a kink all count.
double noise(const LimitState& state, const Point& u);

}  // namespace taut::chance
