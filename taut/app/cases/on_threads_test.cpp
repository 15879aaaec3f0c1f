#include "taut/app/cases/on_threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

namespace taut::app {

/// An arena of 100000 threads ends the program, whatever there is to do in it.
TEST(OnThreads, AsksForSoManyThreadsAtMost) {
  std::atomic<int> calls = 0;
  on_threads(100'000, 1, [&](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 1);
}

}  // namespace taut::app
