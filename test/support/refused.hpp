#pragma once
#include <rapidcheck/gtest.h>

#include "taut/solve/equilibrium.hpp"

namespace taut_test {

/// A machine without an answer has a reason and no half of a result.
inline void refused(const taut::solve::EquilibriumResult& r) {
  RC_ASSERT(!r.outcome.message.empty());
  RC_ASSERT(r.branches.empty());
}

}  // namespace taut_test
