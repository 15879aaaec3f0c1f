#pragma once
#include <functional>
#include <span>
#include <vector>

#include "taut/chance/reliability/limit_state.hpp"

/// Limit states of functions: what tests of reliability ask.
namespace taut_test {

using OutputOf = std::function<double(const taut::chance::Point&)>;

/// A model whose second output is f; the first one is another output, that nobody asks for.
inline taut::chance::Evaluate model(const OutputOf& f) {
  return [f](std::span<const taut::chance::Point> points) {
    std::vector<std::vector<double>> rows;
    for (const taut::chance::Point& x : points) rows.push_back({0, f(x)});
    return rows;
  };
}

/// f against a limit; without one, f >= 0.
inline taut::chance::LimitState state_of(const taut::chance::Inputs& inputs, const OutputOf& f,
                                         taut::chance::Limit limit = {}) {
  return {inputs, model(f), 1, limit};
}

/// n standard normal inputs: their values are their scores.
inline taut::chance::Inputs normals(std::size_t n) {
  return {.of = std::vector<taut::chance::Distribution>(n, {taut::chance::Normal{}})};
}

}  // namespace taut_test
