// Ropes chosen from the whole catalogue: the closed loop over a hundred positions, each pair proved by catenaries at
// all of them (a second on one core is the aim), and beside it one such proof (`proofs`: time in units of it).
#include <benchmark/benchmark.h>

#include <chrono>

#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/methods/closed_loop/position.hpp"

namespace {

using namespace taut;
using namespace taut::closed_loop;

Input hundred_positions() {
  Input in;
  in.span = 200;
  in.slope = -0.15;
  in.sag = 10;
  in.gathering_force = 29e3;
  in.gathering_angle = 0.5;
  in.tail_efficiency = 0.9;
  in.safety_factor = 3.5;
  in.choose_ropes.emplace();
  for (int i = 1; i <= 100; ++i) in.position.push_back(200.0 * i / 101);
  return in;
}

void closed_loop_from_the_whole_catalogue(benchmark::State& state) {
  const Input in = hundred_positions();
  double all = 0;
  double proofs = 0;
  const auto seconds = [](auto&& what) {
    const auto start = std::chrono::steady_clock::now();
    what();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (auto _ : state) {
    Ropes ropes;
    all += seconds([&] { benchmark::DoNotOptimize(ropes_of(in, ropes, app::loop_engine())); });
    state.PauseTiming();
    proofs += seconds([&] { benchmark::DoNotOptimize(sweep(in, ropes, app::loop_engine())); });
    state.ResumeTiming();
  }
  state.counters["proofs"] = all / proofs;
}
BENCHMARK(closed_loop_from_the_whole_catalogue)->Unit(benchmark::kMillisecond);

}  // namespace
