#pragma once
#include "taut/calc/result.hpp"

namespace taut::app {

/// Moves all that one result holds behind what another one holds. A value that both have is the larger of the two.
void append(Result& from, Result& to);

}  // namespace taut::app
