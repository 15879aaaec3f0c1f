// friction_drive: one drive, in double and written out over Num.
#include <benchmark/benchmark.h>

#include "taut/methods/friction_drive/friction_drive.hpp"

namespace {

using namespace taut;
using namespace taut::friction_drive;

Input saw() {
  Input in;
  in.cutting_force = 4000;
  in.friction = 0.35;
  in.wrap = 3.49;
  in.rope_mass = 0.6;
  in.speed = 15;
  in.grip_reserve = 1.3;
  in.section_factor = 0.126;
  in.sheave_radius = 0.25;
  in.rope_area = 60e-6;
  return in;
}

void one_drive(benchmark::State& state) {
  const Input in = saw();
  for (auto _ : state) {
    Output out;
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out.takeup_no_slip);
  }
}
BENCHMARK(one_drive)->Unit(benchmark::kMicrosecond);

void one_drive_written_out(benchmark::State& state) {
  const Input in = saw();
  for (auto _ : state) {
    Output out;
    Sheet<Num> s("Ryabukhin et al. 2022", Input::describe(), &in);
    benchmark::DoNotOptimize(compute(in, s, out));
  }
}
BENCHMARK(one_drive_written_out)->Unit(benchmark::kMicrosecond);

/// With tables and figures.
void whole_result(benchmark::State& state) {
  const Input in = saw();
  for (auto _ : state) benchmark::DoNotOptimize(run(in));
}
BENCHMARK(whole_result)->Unit(benchmark::kMicrosecond);

}  // namespace
