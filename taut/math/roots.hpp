#pragma once
#include <functional>
#include <optional>

namespace taut {

/// The root of `f` in [low, high] to the last few bits of a double (TOMS 748, Boost.Math).
/// Empty when f has the same sign at both ends, is NaN at one of them, or low >= high. An end that is a root is
/// returned.
std::optional<double> find_root(const std::function<double(double)>& f, double low, double high);

/// Like find_root, but widens the upper end (high := low + 2 (high - low), at most `doublings` times) until the sign
/// changes.
std::optional<double> find_root_above(const std::function<double(double)>& f, double low, double high,
                                      int doublings = 200);

}  // namespace taut
