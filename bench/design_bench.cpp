// Ropes chosen from the whole catalogue: the closed loop over a hundred positions, each pair proved by catenaries at
// all of them (a second on one core is the aim), and beside it one such proof (`proofs`: time in units of it). The same
// by a deck with `design:`, whose every choice is a whole calculation (`runs`: time in units of one).
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/app/job.hpp"
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
  for (int i = 1; i <= 100; ++i) in.position.push_back(20 + 1.6 * i);
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

std::string deck_of(const std::string& input, const std::string& more) {
  std::string positions;
  for (int i = 1; i <= 100; ++i) positions += std::to_string(20 + 1.6 * i) + " m, ";
  return "taut: 1\nmethod: closed_loop\ninput:\n  {span: 200 m, slope: -8 deg, sag: 10 m, gathering_force: 29 kN, "
         "gathering_angle: 30 deg, tail_efficiency: 0.9, " +
         input + "position: [" + positions +
         "]}\nchecks: {ropes: {return: {safety_factor: 3.5}, traction: {safety_factor: 3.5}}}\n" + more;
}

void closed_loop_by_a_design_deck(benchmark::State& state) {
  const app::Job design{
      .text = deck_of(
          "",
          "design: {ropes: {return: {construction: 6x36, core: IWRC}, traction: {construction: 6x36, core: IWRC}}}"),
      .name = "deck",
      .set = {},
      .progress = {}};
  const app::Job one{
      .text = deck_of("return_rope: 6x36-IWRC 20 mm 1960 MPa, traction_rope: 6x36-IWRC 22 mm 1960 MPa, ", ""),
      .name = "deck",
      .set = {},
      .progress = {}};
  double all = 0;
  double runs = 0;
  const auto seconds = [](const app::Job& job) {
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(app::run(job));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (auto _ : state) {
    all += seconds(design);
    state.PauseTiming();
    runs += seconds(one);
    state.ResumeTiming();
  }
  state.counters["runs"] = all / runs;
}
BENCHMARK(closed_loop_by_a_design_deck)->Unit(benchmark::kMillisecond);

}  // namespace
