#include <benchmark/benchmark.h>

#include <numbers>

#include "taut/methods/closed_loop/closed_loop.hpp"

namespace {

using namespace taut;
using namespace taut::closed_loop;

/// One carriage position, no sizing.
Input one_position(double slope) {
  Input in;
  in.span = 200;
  in.slope = slope;
  in.position = {80};
  in.sag = 10;
  in.gathering_force = 29420;
  in.gathering_angle = std::numbers::pi / 6;
  in.return_weight = 9.8;
  in.traction_weight = 14.7;
  in.tail_efficiency = 0.9;
  return in;
}

void one_position_in_double(benchmark::State& state) {
  const Input in = one_position(0.01 * static_cast<double>(state.range(0)));
  for (auto _ : state) {
    Output out;
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(one_position_in_double)->Arg(0)->Arg(20);

void one_position_with_its_note(benchmark::State& state) {
  const Input in = one_position(0.2);
  for (auto _ : state) {
    Output out;
    Sheet<Num> s("Martynikhin 1971", Input::describe(), &in);
    benchmark::DoNotOptimize(compute(in, s, out));
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(one_position_with_its_note);

void two_sections_in_double(benchmark::State& state) {
  Input in = one_position(0.2);
  in.carriage = Carriage::two_section;
  in.section_distance = 3;
  for (auto _ : state) {
    Output out;
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out);
  }
}
BENCHMARK(two_sections_in_double);

}  // namespace
