// The cost of a drawing over the number of its parts: n hoists side by side, each a rope over a sheave with its name,
// the force on the sheave, the winch and the weight. `growth`: p in time ~ n^p between n/2 and n; 1 is linear, 2 would
// be every label against every other. The same for a whole calculation with its page (`page_of_hoists`).
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <string>

#include "taut/app/job.hpp"
#include "taut/report/figure/svg_drawing.hpp"
#include "taut/report/html.hpp"

namespace {

using namespace taut;

Drawing hoists(int n) {
  Drawing d;
  d.title = "hoists";
  d.across = "x";
  d.upward = "z";
  for (int i = 0; i < n; ++i) {
    const double x = 4.0 * i, T = 10e3 + 100 * i;
    const Point winch{.x = x - 1.5, .y = 1}, head{.x = x, .y = 10}, load{.x = x + 0.15, .y = 3};
    d.shapes.emplace_back(Polyline{.points = {winch, head, load}, .role = Role::rope});
    d.shapes.emplace_back(Circle{.center = head, .radius = 0.15});
    d.shapes.emplace_back(ForceArrow{.at = head, .fx = -0.16 * T, .fy = -2 * T, .label = fmt::format("F head_{}", i)});
    d.shapes.emplace_back(ForceArrow{.at = winch, .fx = 0.16 * T, .fy = T, .label = fmt::format("F winch_{}", i)});
    d.shapes.emplace_back(
        ForceArrow{.at = load, .fx = 0, .fy = -T, .label = fmt::format("W load_{}", i), .role = Role::second_force});
  }
  return d;
}

std::string deck_of_hoists(int n) {
  std::string points, bodies, sheaves, drums, paths;
  for (int i = 0; i < n; ++i) {
    points += fmt::format("    hook_{0}: {{body: load_{0}, at: [0 m, 0 m, 0 m]}}\n", i);
    bodies +=
        fmt::format("    load_{}: {{mass: {} kg, at: [{} m, 0 m, 3 m], free: [z]}}\n", i, 1000 + 10 * i, 4 * i + 0.15);
    sheaves += fmt::format("    head_{}: {{at: [{} m, 0 m, 10 m], diameter: 300 mm, efficiency: 0.97}}\n", i, 4 * i);
    drums += fmt::format("    winch_{}: {{at: [{} m, 0 m, 1 m], core_diameter: 300 mm}}\n", i, 4 * i - 1.5);
    paths += fmt::format(
        "    - {{name: rope_{0}, rope: hoist, path: [{{drum: winch_{0}}}, {{over: head_{0}}}, {{anchor: hook_{0}}}], "
        "length: 16 m}}\n",
        i);
  }
  return fmt::format(
      "taut: 1\ntitle: {} hoists\nmachine:\n  points:\n{}  ropes:\n    hoist: {{rope: \"EN "
      "12385-4|6x36-IWRC|16|1960\", "
      "stiffness: 13 MN}}\n  bodies:\n{}  sheaves:\n{}  drums:\n{}  reevings:\n{}analyses:\n  - equilibrium: {{motion: "
      "hoist}}\n",
      n, points, bodies, sheaves, drums, paths);
}

/// Processor time: other programs do not change it.
template <class Once>
double seconds(Once&& once) {
  const std::clock_t start = std::clock();
  once();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template <class Of>
void growth(benchmark::State& state, Of&& of) {
  const auto n = static_cast<int>(state.range(0));
  double all = 0, halves = 0;
  for (auto _ : state) {
    all += seconds([&] { of(n); });
    state.PauseTiming();
    halves += seconds([&] { of(n / 2); });
    state.ResumeTiming();
  }
  state.counters["growth"] = std::log2(all / halves);
}

void drawing_of_hoists(benchmark::State& state) {
  growth(state, [](int n) { benchmark::DoNotOptimize(report::drawing_svg(hoists(n), Display{})); });
}
BENCHMARK(drawing_of_hoists)->RangeMultiplier(2)->Range(25, 400)->Unit(benchmark::kMillisecond);

void page_of_hoists(benchmark::State& state) {
  growth(state, [](int n) {
    const app::Job job{.text = deck_of_hoists(n), .name = "deck", .set = {}, .progress = {}};
    benchmark::DoNotOptimize(report::to_html(app::run(job)));
  });
}
BENCHMARK(page_of_hoists)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
