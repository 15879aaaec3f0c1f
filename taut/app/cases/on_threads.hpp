#pragma once
#include <algorithm>
#include <cstddef>

#ifndef __EMSCRIPTEN__
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace taut::app {

inline constexpr int most_threads = 1024;  ///< an arena of tbb with some ten thousand ends the program

/// Calls f(0) to f(count - 1) on so many threads, 1024 at most; 0: all that the machine has. The engine in a browser
/// has one.
template <class F>
void on_threads([[maybe_unused]] int threads, std::size_t count, const F& f) {
#ifdef __EMSCRIPTEN__
  for (std::size_t i = 0; i < count; ++i) f(i);
#else
  tbb::task_arena arena(threads > 0 ? std::min(threads, most_threads) : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, f, tbb::simple_partitioner()); });
#endif
}

}  // namespace taut::app
