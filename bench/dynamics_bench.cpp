// The swing of a load on a chain of 50 segments over 10 s, and a tackle of six falls with losses over 3 s, by the
// general way of the transient analysis, a belt drive into its steady state, a telescopic boom that extends from 9 to
// 21 m; beside them the same chain by a plain
// velocity Verlet written for it. Times are CPU times of one core; `of_baseline` is the ratio to the baseline in this
// run, `error` the distance from the reference place at 10 s, m.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "taut/solve/motion/transient.hpp"
#include "test/support/boom_machine.hpp"

namespace {

using namespace taut;

constexpr double EA = 1e7, gravity = 9.81, limit = 0.632e-3;
const Vector3 reference(40, 18.8184917186, -23.4280878018);

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Vector3 start_of_load() {
  const double leg = 50 * (1 + 2250 / EA), R = std::sqrt(leg * leg - 1600);
  return {40, R * std::sqrt(0.75), -R / 2};
}

// The baseline, as tight as plain C++ allows: 49 masses in arrays; each link's force is used for the masses at both of
// its ends in the same pass; the two half steps of the velocities between two steps are one.
Vector3 plain_verlet(double step) {
  constexpr std::size_t n = 51;
  std::array<double, n> x{}, y{}, z{}, u{}, v{}, w{}, inverse{};
  const Vector3 M = start_of_load();
  for (std::size_t k = 0; k < n; ++k) {
    const double i = static_cast<double>(k), s = k <= 25 ? i / 25 : (50 - i) / 25;
    x[k] = k <= 25 ? s * M.x() : 80 - s * (80 - M.x());
    y[k] = s * M.y();
    z[k] = s * M.z();
    inverse[k] = k == 25 ? 1.0 / 502 : 1.0 / 2;
  }
  const auto kick = [&](double h) {
    double fx = 0, fy = 0, fz = 0;
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double dx = x[k + 1] - x[k], dy = y[k + 1] - y[k], dz = z[k + 1] - z[k];
      const double l = std::sqrt(dx * dx + dy * dy + dz * dz), e = l * 0.5 - 1;
      const double T = e > 0 ? EA * e / l : 0;
      const double gx = T * dx, gy = T * dy, gz = T * dz;
      if (k > 0) {
        u[k] += h * inverse[k] * (gx - fx);
        v[k] += h * inverse[k] * (gy - fy);
        w[k] += h * (inverse[k] * (gz - fz) - gravity);
      }
      fx = gx;
      fy = gy;
      fz = gz;
    }
  };
  const long steps = std::lround(std::ceil(10 / step));
  const double h = 10.0 / static_cast<double>(steps);
  kick(h / 2);
  for (long i = 0; i < steps; ++i) {
    for (std::size_t k = 1; k + 1 < n; ++k) {
      x[k] += h * u[k];
      y[k] += h * v[k];
      z[k] += h * w[k];
    }
    kick(i + 1 < steps ? h : h / 2);
  }
  return {x[25], y[25], z[25]};
}

double baseline_time() {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const double start = cpu();
    benchmark::DoNotOptimize(plain_verlet(0.8 * limit));
    best = std::min(best, cpu() - start);
  }
  return best;
}

machine::Node node_at(const Vector3& at, int body = machine::ground) {
  machine::Node node;
  node.at = {.body = body, .at = at};
  return node;
}

machine::Body point_mass(const Vector3& at, double mass, bool in_space) {
  machine::Body body;
  body.position = at;
  body.mass = mass;
  if (in_space)
    body.free = {{.along = Vector3::UnitX(), .about = Vector3::Zero()},
                 {.along = Vector3::UnitY(), .about = Vector3::Zero()}};
  body.free.push_back({Vector3::UnitZ(), Vector3::Zero()});
  return body;
}

machine::Model swing() {
  machine::Model m;
  m.gravity = gravity;
  m.bodies.push_back(point_mass(start_of_load(), 500, true));
  for (const bool left : {true, false}) {
    machine::Reeving rope;
    rope.name = left ? "left" : "right";
    rope.nodes = {node_at({0, 0, 0}), node_at(Vector3::Zero(), 0)};
    if (!left) rope.nodes = {node_at(Vector3::Zero(), 0), node_at({80, 0, 0})};
    rope.value = 50;
    rope.weight = gravity;
    rope.stiffness = EA;
    rope.segments = 25;
    m.reevings.push_back(rope);
  }
  return m;
}

void run_swing(benchmark::State& state, solve::TimeMethod method, double step) {
  const machine::Model m = swing();
  solve::TransientOptions options;
  options.duration = 10;
  options.output_step = 10;
  options.start = solve::Start::assembled;
  options.method = method;
  options.step = step;
  double best = std::numeric_limits<double>::infinity(), error = 0, iterations = 0;
  for (auto _ : state) {
    const double start = cpu();
    const auto r = transient(m, options);
    best = std::min(best, cpu() - start);
    error = (r.frames.back().bodies[0].position - reference).norm();
    iterations = static_cast<double>(r.iterations) / static_cast<double>(r.steps);
  }
  state.counters["of_baseline"] = best / baseline_time();
  state.counters["iterations"] = iterations;
  state.counters["error"] = error;
}

void baseline(benchmark::State& state) {
  double error = 0;
  for (auto _ : state) error = (plain_verlet(0.8 * limit) - reference).norm();
  state.counters["error"] = error;
}

void swing_verlet(benchmark::State& state) { run_swing(state, solve::TimeMethod::verlet, 0.8 * limit); }
void swing_implicit(benchmark::State& state) { run_swing(state, solve::TimeMethod::implicit, 5e-3); }

void tackle(benchmark::State& state) {
  machine::Model m;
  m.gravity = gravity;
  m.bodies.push_back(point_mass({0, 0, -10}, 3000, false));
  machine::Reeving rope;
  rope.name = "hoist";
  rope.nodes.push_back(node_at({-10, 0, 0}));
  for (int i = 0; i < 6; ++i) {
    rope.nodes.push_back(node_at(Vector3::Zero(), i % 2 == 0 ? machine::ground : 0));
    rope.nodes.back().kind = machine::NodeKind::contact;
    rope.nodes.back().law.efficiency = 0.97;
  }
  rope.nodes.push_back(node_at(Vector3::Zero()));
  rope.value = 70 / (1 + 4905 / EA);
  rope.stiffness = EA;
  rope.damping_time = 1e-3;
  m.reevings.push_back(rope);
  machine::Signal in;
  in.law = machine::Curve{.t = {0, 0.5, 4}, .value = {0, -0.125, -1.875}, .slopes = {0, -0.5, -0.5}};
  m.tensioners.push_back({0, true, in});
  solve::TransientOptions options;
  options.duration = 3;
  options.output_step = 3;
  options.start = solve::Start::assembled;
  options.step = 1e-3;
  double iterations = 0;
  for (auto _ : state) {
    const auto r = transient(m, options);
    iterations = static_cast<double>(r.iterations) / static_cast<double>(r.steps);
  }
  state.counters["iterations"] = iterations;
}

/// A belt on two sheaves 10 m apart: the drive is brought to 2 m/s, a brake's moment works on the other one. The steady
/// state: tensions that differ by the moment, the belt creeping on the drive.
void belt(benchmark::State& state) {
  machine::Model m;
  m.gravity = gravity;
  machine::Reeving rope;
  rope.name = "belt";
  rope.closed = true;
  for (const bool drive : {true, false}) {
    machine::Node node = node_at({drive ? 0.0 : 10.0, 0, 0});
    node.kind = drive ? machine::NodeKind::drive : machine::NodeKind::contact;
    node.radius = 0.5;
    node.inertia = 5;
    node.law.friction = 0.4;
    node.motor = drive ? 0 : 1;
    rope.nodes.push_back(node);
  }
  rope.value = (20 + 2 * 0.5 * std::numbers::pi) / (1 + 5000 / EA);
  rope.stiffness = EA;
  rope.damping_time = 1e-3;
  m.reevings.push_back(rope);
  m.motors.resize(2);
  m.motors[0].drive.kind = machine::DriveKind::speed;
  m.motors[0].drive.signal.law =
      machine::Moves{.from = 0, .moves = {{.at = 0, .to = 2, .over = 0.2, .change = machine::Change::smooth}}};
  m.motors[1].drive.kind = machine::DriveKind::torque;
  m.motors[1].drive.signal.law =
      machine::Moves{.from = 0, .moves = {{.at = 0, .to = -1000, .over = 0.2, .change = machine::Change::smooth}}};
  solve::TransientOptions options;
  options.duration = 2;
  options.output_step = 2;
  options.start = solve::Start::assembled;
  options.tolerance = 1e-3;
  double difference = 0, steps = 0;
  for (auto _ : state) {
    const auto r = transient(m, options);
    if (!r.outcome.ok()) state.SkipWithError(r.outcome.message.c_str());
    const auto& last = r.frames.back().branches;
    difference = std::abs(last[0].T_from - last[1].T_from);
    steps = static_cast<double>(r.steps);
  }
  state.counters["T_difference"] = difference;
  state.counters["steps"] = steps;
}

/// The boom of Reutov (2021) with pads, ropes, cylinder, tackle and load at 52 degrees, extending by 0.4 m/s.
constexpr double boom_lasts = 32.8;
solve::TransientResult extension(double tolerance) {
  solve::TransientOptions options;
  options.duration = boom_lasts;
  options.output_step = 0.1;
  options.tolerance = tolerance;
  return transient(taut_test::boom_machine({}), options);
}

/// `of_real_time`: how many seconds of motion a second computes. `off`: the largest distance of cylinder force and rope
/// tensions from a run of a hundred times finer tolerance, over all outputs, as a share of the largest one.
void boom(benchmark::State& state) {
  const auto fine = extension(1e-5);
  double best = std::numeric_limits<double>::infinity(), off = 0, steps = 0, length = 0;
  for (auto _ : state) {
    const double start = cpu();
    const auto r = extension(1e-3);
    best = std::min(best, cpu() - start);
    if (!r.outcome.ok() || r.frames.size() != fine.frames.size()) state.SkipWithError(r.outcome.message.c_str());
    std::array<double, 3> largest{}, apart{};
    for (std::size_t i = 0; i < std::min(r.frames.size(), fine.frames.size()); ++i) {
      const auto a = taut_test::boom_state({}, r.frames[i]), b = taut_test::boom_state({}, fine.frames[i]);
      const std::array<std::pair<double, double>, 3> pairs{{{a.Fh, b.Fh}, {a.S1, b.S1}, {a.S2, b.S2}}};
      for (std::size_t k = 0; k < 3; ++k) {
        largest[k] = std::max(largest[k], std::abs(pairs[k].second));
        apart[k] = std::max(apart[k], std::abs(pairs[k].first - pairs[k].second));
      }
      length = a.Lb;
    }
    off = 0;
    for (std::size_t k = 0; k < 3; ++k) off = std::max(off, apart[k] / largest[k]);
    steps = static_cast<double>(r.steps);
  }
  state.counters["of_real_time"] = boom_lasts / best;
  state.counters["off"] = off;
  state.counters["length"] = length;
  state.counters["steps"] = steps;
}

BENCHMARK(baseline)->Unit(benchmark::kMillisecond);
BENCHMARK(swing_verlet)->Unit(benchmark::kMillisecond);
BENCHMARK(swing_implicit)->Unit(benchmark::kMillisecond);
BENCHMARK(tackle)->Unit(benchmark::kMillisecond);
BENCHMARK(belt)->Unit(benchmark::kMillisecond);
BENCHMARK(boom)->Unit(benchmark::kMillisecond);

}  // namespace
