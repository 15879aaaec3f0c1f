#include "taut/app/cases/on_threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

namespace taut::app {

/// A system gives a program some ten thousand threads at most; one that asks for more ends.
TEST(OnThreads, NeverAsksForMoreThanTheSystemGives) {
  std::atomic<std::size_t> sum = 0;
  on_threads(1'000'000, 1000, [&](std::size_t i) { sum += i; });
  EXPECT_EQ(sum, 999U * 1000 / 2);
}

}  // namespace taut::app
