#pragma once
#include "taut/calc/result.hpp"

namespace taut::results {

/// Moves all that one result holds behind what another one holds. A value that both have is the larger of the two.
void append(Result& from, Result& to);

}  // namespace taut::results
