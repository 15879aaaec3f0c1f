#pragma once
#include <functional>
#include <span>
#include <vector>

namespace taut::chance {

/// The inputs of one case in the order of the study: SI values, scores or numbers from 0 to 1, as the function says.
using Point = std::vector<double>;
using Points = std::vector<Point>;

/// The model: for each point (SI values of the inputs) the row of its outputs, in the order of the points. An output
/// that has no value (no equilibrium) is NaN: a failed case. The same point must give the same bits in any batch.
using Evaluate = std::function<std::vector<std::vector<double>>(std::span<const Point> points)>;

}  // namespace taut::chance
