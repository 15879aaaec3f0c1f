#pragma once
#include <functional>
#include <optional>

namespace taut {

/// The root of `f` in [low, high] to the last few bits of a double (TOMS 748, Boost.Math). An end at which f is zero is
/// returned. Empty when f has the same sign at both ends, is not finite at one of them, or low >= high.
std::optional<double> find_root(const std::function<double(double)>& f, double low, double high);

/// Like find_root, but increases the upper end (high := low + 2 (high - low), at most `doublings` times) until the sign
/// changes. Empty when it does not change.
std::optional<double> find_root_above(const std::function<double(double)>& f, double low, double high,
                                      int doublings = 200);

}  // namespace taut
