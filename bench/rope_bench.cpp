// One elastic span, cold and warm, against a textbook Newton in plain C++; then a span with a load, a tangent line
// between skew sheaves. The ratio of the spans is printed as the counter `of_textbook`, the share of spans solved as
// `solved`.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include "taut/rope/catenary.hpp"
#include "taut/rope/loaded_span.hpp"
#include "taut/rope/span.hpp"
#include "taut/rope/tangent.hpp"

namespace {

using namespace taut;
using namespace taut::rope;

struct Case {
  CatenaryRope rope;
  double x, z;
  CatenaryForce near;  // solution of a span 0.1 % longer
};

// Slope to 63 degrees, length 0.98 to 1.5 of the chord, EA 1e6 to 1e9 N, 1 to 200 N/m.
std::vector<Case> spans() {
  std::mt19937_64 source(1);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(source); };
  std::vector<Case> all;
  for (int i = 0; i < 3000; ++i) {
    const double chord = in(10, 1000), slope = in(-1.1, 1.1);
    Case c{.rope = {.length = chord * in(0.98, 1.5), .weight = in(1, 200), .stiffness = std::pow(10, in(6, 9))},
           .x = chord * std::cos(slope),
           .z = chord * std::sin(slope),
           .near = {}};
    c.near = solve_catenary(c.rope, 1.001 * c.x, 1.001 * c.z)->force;
    all.push_back(c);
  }
  return all;
}

// The baseline: the formulas as printed (asinh of the end slopes), Newton with their derivatives as printed, the start
// of Peyrot and Goulois, the residual to 1e-9 of the chord, no damping but H > 0.
struct Textbook {
  double H = 0, V = 0;  // at the start
  bool solved = false;
};

Textbook textbook(const CatenaryRope& rope, double x, double z, double H, double V) {
  const double L = rope.length, w = rope.weight, EA = rope.stiffness, chord = std::hypot(x, z);
  for (int i = 0; i < 100; ++i) {
    const double V1 = V + w * L, T0 = std::hypot(H, V), T1 = std::hypot(H, V1);
    const double arc = std::asinh(V1 / H) - std::asinh(V / H);
    const double rx = x - (H * L / EA + H / w * arc);
    const double rz = z - ((V * L + w * L * L / 2) / EA + (T1 - T0) / w);
    if (std::hypot(rx, rz) <= 1e-9 * chord) return {.H = H, .V = V, .solved = true};
    const double xH = L / EA + arc / w + (V / T0 - V1 / T1) / w;
    const double xV = H / w * (1 / T1 - 1 / T0);
    const double zV = L / EA + (V1 / T1 - V / T0) / w;
    const double det = xH * zV - xV * xV;
    const double dH = (zV * rx - xV * rz) / det, dV = (xH * rz - xV * rx) / det;
    H = H + dH > 0 ? H + dH : H / 10;
    V += dV;
  }
  return {};
}

Textbook textbook(const CatenaryRope& rope, double x, double z) {
  const double L = rope.length, chord = std::hypot(x, z);
  const double lambda = L > chord ? std::sqrt(3 * ((L * L - z * z) / (x * x) - 1)) : 0.2;
  return textbook(rope, x, z, rope.weight * x / (2 * lambda), rope.weight / 2 * (z / std::tanh(lambda) - L));
}

double seconds(const auto& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Runs `ours` and `theirs` over all 3000 spans in turn; the time is that of ours.
void compare(benchmark::State& state, const auto& ours, const auto& theirs) {
  const auto all = spans();
  double own = 0, other = 0;
  long solved = 0, theirs_solved = 0, count = 0;
  for (auto _ : state) {
    const double t = seconds([&] {
      for (const Case& c : all) solved += ours(c) ? 1 : 0;
    });
    other += seconds([&] {
      for (const Case& c : all) theirs_solved += theirs(c) ? 1 : 0;
    });
    own += t;
    count += static_cast<long>(all.size());
    state.SetIterationTime(t);
  }
  state.counters["ns_per_span"] = 1e9 * own / static_cast<double>(count);
  state.counters["of_textbook"] = own / other;
  state.counters["solved"] = static_cast<double>(solved) / static_cast<double>(count);
  state.counters["textbook_solved"] = static_cast<double>(theirs_solved) / static_cast<double>(count);
}

void cold_span(benchmark::State& state) {
  compare(
      state, [](const Case& c) { return bool(solve_catenary(c.rope, c.x, c.z)); },
      [](const Case& c) { return textbook(c.rope, c.x, c.z).solved; });
}
BENCHMARK(cold_span)->UseManualTime();

void warm_span(benchmark::State& state) {
  compare(
      state, [](const Case& c) { return bool(solve_catenary(c.rope, c.x, c.z, c.near)); },
      [](const Case& c) {
        return textbook(c.rope, c.x, c.z, c.near.H, c.near.V - c.rope.weight * c.rope.length / 2).solved;
      });
}
BENCHMARK(warm_span)->UseManualTime();

void warm_span_in_space_with_stiffness(benchmark::State& state) {
  const auto all = spans();
  std::size_t i = 0;
  for (auto _ : state) {
    const Case& c = all[i++ % all.size()];
    const auto s = solve_span(c.rope, {0.6 * c.x, 0.8 * c.x, c.z}, c.near);
    benchmark::DoNotOptimize(stiffness(*s));
  }
}
BENCHMARK(warm_span_in_space_with_stiffness);

void loaded_span(benchmark::State& state) {
  const bool warm = state.range(0) != 0;
  const std::vector<PointLoad> load{{.s = 120, .force = {0, 0, -3e4}}};
  const auto near = solve_loaded_span({.length = 255, .weight = 15, .stiffness = 2.5e7}, {250, 0, 20}, load)->force;
  for (auto _ : state) {
    const std::optional<Vector3> start = warm ? std::optional(near) : std::nullopt;
    benchmark::DoNotOptimize(
        solve_loaded_span({.length = 255, .weight = 15, .stiffness = 2.5e7}, {250, 1, 20}, load, start));
  }
}
BENCHMARK(loaded_span)->ArgName("warm")->Arg(0)->Arg(1);

void tangent_between_sheaves(benchmark::State& state) {
  const double lean = state.range(0) != 0 ? 0.1 : 0;
  const Round from = sheave({0, 0, 0}, {0, 1, 0}, 0.5, 1), to = sheave({10, 0.2, 4}, {lean, 1, 0}, 0.3, -1);
  for (auto _ : state) benchmark::DoNotOptimize(tangent_line(from, to));
}
BENCHMARK(tangent_between_sheaves)->ArgName("skew")->Arg(0)->Arg(1);

}  // namespace
