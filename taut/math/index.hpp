#pragma once
#include <cstddef>

namespace taut {

/// The number `i` of an entry as the standard library counts it. The indices of a model are int, with -1 for "none";
/// `i` must not be negative here, which a checked standard library notices at the place of use.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace taut
