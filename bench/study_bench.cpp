// One case of a study against the bare equilibrium that it rests on: the same machine, its model ready, from the same
// state (`of_bare`: time in units of it, with the release of its result, as in any loop). What a case has besides: the
// numbers put in, the model compiled, lines put up, the outputs taken.
#include <benchmark/benchmark.h>

#include <chrono>
#include <optional>
#include <stdexcept>

#include "taut/app/cases/read_cases.hpp"
#include "taut/machine/compile.hpp"
#include "taut/study/deck/parameter.hpp"

namespace {

using namespace taut;

/// A deck with one equilibrium, a path that varies, and an output.
struct Kind {
  const char* deck;
  const char* path;
  const char* output;
};

constexpr const char* rolling_load =
    "taut: 1\nmachine:\n  points: {tail: [0 m, 0 m, 0 m], head: [200 m, 0 m, 30 m]}\n"
    "  ropes: {sky: {mass: 1.5 kg/m, stiffness: 20 MN}}\n"
    "  carriages: {car: {mass: 200 kg, rides: sky, hold: rolling}}\n"
    "  reevings: [{rope: sky, path: [{anchor: tail}, {through: car}, {anchor: head}], length: 205 m}]\n"
    "  loads: [{at: car, mass: 1 t}]\nanalyses: [{equilibrium: {motion: at_rest}}]\n";

constexpr const char* three_spans =
    "taut: 1\nmachine:\n"
    "  points: {stump: [0 m, 0 m, 4 m], tower: [360 m, 0 m, 124 m], block: [360 m, 0 m, 122 m]}\n"
    "  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN}, main: {mass: 0.54 kg/m, stiffness: 7 MN}}\n"
    "  supports: {jack1: {at: [110 m, 0 m, 33 m], diameter: 400 mm, friction: 0.1}, "
    "jack2: {at: [240 m, 0 m, 78 m], diameter: 400 mm, friction: 0.1}}\n"
    "  carriages: {car: {mass: 350 kg, rides: sky, hold: rolling, mainline: main}}\n"
    "  reevings:\n"
    "    - {rope: sky, path: [{anchor: stump}, {over: jack1}, {through: car}, {over: jack2}, {anchor: tower}], "
    "length: 382 m}\n"
    "    - {rope: main, path: [{anchor: block}, {anchor: car}], length: 190 m}\n"
    "  loads: [{at: car, mass: 1.5 t}]\nanalyses: [{equilibrium: {motion: at_rest}}]\n";

constexpr const char* tackle =
    "taut: 1\nmachine:\n"
    "  bodies: {hook: {mass: 2 t, at: [0 m, 0 m, 5 m], free: [x, z]}}\n"
    "  points: {eye: [0.4 m, 0 m, 20 m]}\n"
    "  ropes: {hoist: {mass: 1 kg/m, stiffness: 15 MN}}\n"
    "  sheaves: {top: {at: [0 m, 0 m, 20 m], diameter: 400 mm, efficiency: 0.98}, "
    "block: {body: hook, at: [0 m, 0 m, 0 m], diameter: 400 mm, efficiency: 0.98}}\n"
    "  drums: {winch: {at: [-8 m, 0 m, 1 m], core_diameter: 400 mm}}\n"
    "  reevings: [{rope: hoist, path: [{drum: winch}, {over: top}, {over: block}, {anchor: eye}], length: 50 m}]\n"
    "analyses: [{equilibrium: {motion: at_rest}}]\n";

const Kind kinds[] = {{rolling_load, "machine.loads[0].mass", "equilibrium.sky.T_start"},
                      {three_spans, "machine.loads[0].mass", "equilibrium.sky.T_start"},
                      {tackle, "machine.bodies.hook.mass", "equilibrium.hoist.T_start"}};

double seconds(const std::chrono::steady_clock::time_point& since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

void case_of_bare(benchmark::State& state) {
  const Kind& kind = kinds[state.range(0)];
  const auto read = app::read_cases({.text = kind.deck, .name = "deck", .set = {}, .progress = {}});
  if (!read) throw std::runtime_error(read.error().message + to_text(read.error().errors));
  const auto model = read->cases({.inputs = {{kind.path, ""}}, .outputs = {{kind.output, ""}}});
  if (!model) throw std::runtime_error("no cases");
  const auto& machine = std::get<app::ReadMachine>(read->of);
  study::EquilibriumRun run = machine.asked.equilibria.front();
  study::solve(machine.model, run);
  run.near = run.result.state;
  double bare = 0, whole = 0;
  double value = model->inputs[0].base;
  for (auto _ : state) {
    value = value * 1.0001;
    const std::vector<double> p = {value};
    auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(model->answer(p));
    whole += seconds(begin);
    app::MachineDeck deck = *machine.deck;
    study::parameter_at(app::MachineDeck::describe(), &deck, kind.path)->set(value);
    const auto compiled = machine::compile(deck.machine);
    std::optional<study::EquilibriumRun> again = run;
    begin = std::chrono::steady_clock::now();
    study::solve(*compiled, *again);
    benchmark::DoNotOptimize(again->result.state);
    again.reset();
    bare += seconds(begin);
    if (value > 1.05 * model->inputs[0].base) value = model->inputs[0].base;
  }
  state.counters["of_bare"] = whole / bare;
  state.counters["us_per_case"] = 1e6 * whole / static_cast<double>(state.iterations());
}
BENCHMARK(case_of_bare)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

}  // namespace
