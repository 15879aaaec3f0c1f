// boom_ropes: the static part and the sliding model, in double and written out over Num.
#include <benchmark/benchmark.h>

#include "taut/math/degree.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/printed_boom_test.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"

namespace {

using namespace taut;
using namespace taut::boom_ropes;

Sliding sliding() {
  Sliding q;
  q.boom_length = {9, 12, 15, 18, 21};
  q.luffing_angle = {19 * degree, 52 * degree, 76 * degree};
  q.suspended_weight = {2943, 32373};
  return q;
}

/// Four cases, an output that is used again.
void static_part(benchmark::State& state) {
  const Input in = whole_boom();
  Output out;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out.S20_min);
  }
}
BENCHMARK(static_part);

void static_part_written_out(benchmark::State& state) {
  const Input in = whole_boom();
  for (auto _ : state) {
    Output out;
    Sheet<Num> s("Reutov 2021", Input::describe(), &in);
    benchmark::DoNotOptimize(compute(in, s, out));
  }
}
BENCHMARK(static_part_written_out);

/// One position: jammed, 21 m.
void one_position(benchmark::State& state) {
  const Input in = whole_boom();
  const Sliding q = sliding();
  Sheet<double> s;
  SlidingPoint p;
  for (auto _ : state) {
    benchmark::DoNotOptimize(slide(in, q, {.weight = 1, .angle = 0, .length = 4}, s, p));
    benchmark::DoNotOptimize(p.Fh);
  }
}
BENCHMARK(one_position);

void one_position_written_out(benchmark::State& state) {
  Input in = whole_boom();
  in.sliding = sliding();
  SlidingPoint p;
  for (auto _ : state) {
    Sheet<Num> s("Reutov 2021", Input::describe(), &in);
    benchmark::DoNotOptimize(slide(in, *in.sliding, {.weight = 1, .angle = 0, .length = 4}, s, p));
  }
}
BENCHMARK(one_position_written_out);

/// Everything a report needs, 30 positions.
void whole_result(benchmark::State& state) {
  Input in = whole_boom();
  in.sliding = sliding();
  for (auto _ : state) benchmark::DoNotOptimize(run(in));
}
BENCHMARK(whole_result);

}  // namespace
