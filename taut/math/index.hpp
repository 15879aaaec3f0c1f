#pragma once
#include <cstddef>

namespace taut {

/// A number of entries as the standard library takes it. `n` is not negative.
inline std::size_t as_size(int n) { return static_cast<std::size_t>(n); }

}  // namespace taut
