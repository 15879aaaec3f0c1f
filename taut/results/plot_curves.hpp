#pragma once
#include "taut/calc/figure.hpp"

namespace taut::results {

/// As many curves as a plot shows: more could not be told apart.
inline constexpr std::size_t most_shown_curves = 6;

/// Keeps the `most` curves with the largest |y|, in their order; the caption says how many were left out.
void keep_largest(Plot& plot, std::size_t most);

}  // namespace taut::results
