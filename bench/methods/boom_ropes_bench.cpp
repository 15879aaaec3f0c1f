// boom_ropes: the static part and the sliding model, in double and written out over Num.
#include <benchmark/benchmark.h>

#include <numbers>

#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"

namespace {

using namespace taut;
using namespace taut::boom_ropes;

constexpr double degree = std::numbers::pi / 180;

Input crane() {
  Input in;
  in.section_weight = 8.44e3;
  in.pad_friction = 0.15;
  in.tackle_efficiency = 0.95;
  in.extension_stiffness = printed_C1;
  in.retraction_stiffness = printed_C2;
  in.cases = {{.name = "rated lift",
               .operation = Operation::lift,
               .luffing_angle = 77 * degree,
               .suspended_weight = 248.2e3,
               .falls = 8},
              {.name = "static test",
               .operation = Operation::lift,
               .luffing_angle = 77 * degree,
               .suspended_weight = 296.8e3,
               .falls = 8},
              {.name = "retract 3 t",
               .operation = Operation::retract,
               .luffing_angle = 5 * degree,
               .suspended_weight = 32.4e3,
               .falls = 6},
              {.name = "retract hook",
               .operation = Operation::retract,
               .luffing_angle = 5 * degree,
               .suspended_weight = 2.94e3,
               .falls = 6}};
  return in;
}

Sliding sliding() {
  Sliding q;
  q.boom_length = {9, 12, 15, 18, 21};
  q.luffing_angle = {19 * degree, 52 * degree, 76 * degree};
  q.suspended_weight = {2943, 32373};
  return q;
}

/// Four cases, an output that is used again.
void static_part(benchmark::State& state) {
  const Input in = crane();
  Output out;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(in, out));
    benchmark::DoNotOptimize(out.S20_min);
  }
}
BENCHMARK(static_part);

void static_part_written_out(benchmark::State& state) {
  const Input in = crane();
  for (auto _ : state) {
    Output out;
    Sheet<Num> s("Reutov 2021", Input::describe(), &in);
    benchmark::DoNotOptimize(compute(in, s, out));
  }
}
BENCHMARK(static_part_written_out);

/// One position: jammed, 21 m.
void one_position(benchmark::State& state) {
  const Input in = crane();
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
  Input in = crane();
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
  Input in = crane();
  in.sliding = sliding();
  for (auto _ : state) benchmark::DoNotOptimize(run(in));
}
BENCHMARK(whole_result);

}  // namespace
