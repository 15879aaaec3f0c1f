// The closed loop by catenaries: one position cold, a hundred positions at a sag and with a loop length, each beside
// the closed form of the same positions (`of_closed_form`: time in units of it).
#include <benchmark/benchmark.h>

#include <chrono>

#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/methods/closed_loop/position.hpp"

namespace {

using namespace taut;
using namespace taut::closed_loop;

Input hundred_positions(Mode mode) {
  Input in;
  in.span = 200;
  in.slope = -0.15;
  in.mode = mode;
  if (mode == Mode::sag) in.sag = 10;
  if (mode == Mode::loop_length) in.loop_length = 407;
  in.gathering_force = 29e3;
  in.gathering_angle = 0.5;
  in.return_weight = 9.8;
  in.traction_weight = 14.7;
  in.return_stiffness = 1.1e7;
  in.traction_stiffness = 1.6e7;
  in.tail_efficiency = 0.9;
  for (int i = 1; i <= 100; ++i) in.position.push_back(20 + 1.6 * i);
  return in;
}

double seconds_of(const Input& in, const Engine& engine) {
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(sweep(
      in, {.q_b = *in.return_weight, .q_T = *in.traction_weight, .return_rope = {}, .traction_rope = {}}, engine));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void hundred_exact_positions(benchmark::State& state) {
  const Input in = hundred_positions(state.range(0) == 0 ? Mode::sag : Mode::loop_length);
  const Input plain = hundred_positions(Mode::sag);
  double exact = 0;
  double closed = 0;
  for (auto _ : state) {
    exact += seconds_of(in, app::loop_engine());
    state.PauseTiming();
    closed += seconds_of(plain, no_engine);
    state.ResumeTiming();
  }
  state.counters["of_closed_form"] = exact / closed;
}
BENCHMARK(hundred_exact_positions)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
