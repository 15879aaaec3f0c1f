// mast_section: one branch angle, seven carriage positions, in double and written out over Num.
#include <benchmark/benchmark.h>

#include "taut/methods/mast_section/mast_section.hpp"

namespace {

using namespace taut;
using namespace taut::mast_section;

Input mast() {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.allowable_stress = 160e6;
  in.branch_angle = 0.21;
  return in;
}

Input with_positions() {
  Input in = mast();
  in.branch_angle.reset();
  in.span = Span{.length = 300,
                 .chord_slope = 0.12,
                 .carriage_position = {15, 50, 100, 150, 200, 250, 285},
                 .rope_weight = 18,
                 .load = 16e3,
                 .horizontal_tension = 85e3};
  return in;
}

void one_angle(benchmark::State& state) {
  const Input in = mast();
  for (auto _ : state) {
    Output out;
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out.D_tube);
  }
}
BENCHMARK(one_angle)->Unit(benchmark::kMicrosecond);

void one_angle_written_out(benchmark::State& state) {
  const Input in = mast();
  for (auto _ : state) {
    Output out;
    Sheet<Num> s("Shoshin et al. 2022", Input::describe(), &in);
    benchmark::DoNotOptimize(compute(in, s, out));
  }
}
BENCHMARK(one_angle_written_out)->Unit(benchmark::kMicrosecond);

void seven_positions(benchmark::State& state) {
  const Input in = with_positions();
  for (auto _ : state) {
    Output out;
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out.D_tube);
  }
}
BENCHMARK(seven_positions)->Unit(benchmark::kMicrosecond);

/// With catalogue sections, tables and figures.
void whole_result(benchmark::State& state) {
  const Input in = with_positions();
  for (auto _ : state) benchmark::DoNotOptimize(run(in));
}
BENCHMARK(whole_result)->Unit(benchmark::kMicrosecond);

}  // namespace
