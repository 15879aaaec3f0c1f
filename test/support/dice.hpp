#pragma once
#include <cmath>
#include <random>

namespace taut_test {

/// Random numbers that are the same everywhere: distributions of the standard library are not.
struct Dice {
  std::mt19937 source;
  double in(double low, double high) { return low + (high - low) * (static_cast<double>(source()) / 4294967296.0); }
  double ten_to(double low, double high) { return std::pow(10, in(low, high)); }
  int below(int n) { return static_cast<int>(source() % static_cast<unsigned>(n)); }
};

}  // namespace taut_test
