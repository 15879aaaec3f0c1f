// A six-span skyline with a carriage in every span in turn, cold, and a load path of 100 positions, warm; the same
// lines by a textbook Newton in plain C++. The ratio is printed as the counter `of_textbook`, the share of positions
// solved as `solved`, the largest difference of the head's tension as `difference`.
#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "taut/study/load_path.hpp"

namespace {

using namespace taut;

constexpr int spans = 6;
constexpr double weight = 20, stiffness = 26e6, mass = 2000, gravity = 9.80665;

Vector3 support(int i) { return {150.0 * i, 0, 60.0 * i - 6.0 * i * i + 5 * (i % 2)}; }

double rope_length() {
  double chords = 0;
  for (int i = 0; i < spans; ++i) chords += (support(i + 1) - support(i)).norm();
  return 1.003 * chords;
}

/// The line with its carriage in one span.
machine::Model line(int loaded) {
  machine::Model m;
  machine::Body car;
  car.name = "car";
  car.position = (support(loaded) + support(loaded + 1)) / 2 - Vector3(0, 0, 6);
  car.mass = mass;
  car.free = {{.along = Vector3::UnitX(), .about = Vector3::Zero()},
              {.along = Vector3::UnitZ(), .about = Vector3::Zero()}};
  m.bodies.push_back(car);
  machine::Reeving sky;
  sky.name = "skyline";
  sky.weight = weight;
  sky.stiffness = stiffness;
  sky.value = rope_length();
  for (int i = 0; i <= spans; ++i) {
    machine::Node node;
    node.at.at = support(i);
    node.kind = i > 0 && i < spans ? machine::NodeKind::contact : machine::NodeKind::anchor;
    sky.nodes.push_back(node);
    if (i != loaded) continue;
    machine::Node wheel;
    wheel.kind = machine::NodeKind::contact;
    wheel.at.body = 0;
    sky.nodes.push_back(wheel);
  }
  m.reevings.push_back(sky);
  m.carriages.push_back({"car", 0, 0, loaded + 1, {}});
  return m;
}

// The baseline: unknown H, V, L of every branch, the carriage's height and the force along its track; the formulas as
// printed, derivatives by differences, Gauss with pivoting, the step halved until the misfit falls.
class Textbook {
 public:
  static constexpr int branches = spans + 1, unknowns = 3 * branches + 2;
  using Vector = std::array<double, unknowns>;

  Textbook(int loaded, double x) : loaded_(loaded), x_(x) {}

  /// The carriage where the deck puts it, the length shared out by the chords, each branch from the usual start of an
  /// inextensible catenary.
  Vector start() const {
    Vector u{};
    const double z = (support(loaded_).z() + support(loaded_ + 1).z()) / 2 - 6;
    double chords = 0;
    for (int k = 0; k < branches; ++k) chords += chord(k, z).norm();
    for (int k = 0; k < branches; ++k) {
      const Vector3 c = chord(k, z);
      const double L = c.norm() * rope_length() / chords;
      const double lambda = std::sqrt(3 * ((L * L - c.z() * c.z()) / (c.x() * c.x()) - 1));
      u[as_size(3 * k)] = weight * c.x() / (2 * lambda);
      u[as_size(3 * k + 1)] = weight / 2 * (c.z() / std::tanh(lambda) - L);
      u[as_size(3 * k + 2)] = L;
    }
    u[as_size(unknowns - 2)] = z;
    return u;
  }

  /// False: not solved in 100 steps.
  bool solve(Vector& u) const {
    Vector r = residual(u);
    for (int i = 0; i < 100; ++i) {
      if (misfit(r) < 1e-10) return true;
      const Vector step = newton_step(u, r);
      bool better = false;
      for (double part = 1; part > 1e-6 && !better; part /= 2) {
        Vector tried = u;
        for (int k = 0; k < unknowns; ++k) tried[as_size(k)] += part * step[as_size(k)];
        const Vector there = residual(tried);
        if (!(misfit(there) < misfit(r))) continue;
        u = tried;
        r = there;
        better = true;
      }
      if (!better) return false;
    }
    return false;
  }

  double head_tension(const Vector& u) const {
    const std::size_t k = as_size(3 * (branches - 1));
    return std::hypot(u[k], u[k + 1] + weight * u[k + 2]);
  }

 private:
  static std::size_t as_size(int i) { return static_cast<std::size_t>(i); }

  Vector3 node(int i, double z) const {
    return i <= loaded_ ? support(i) : i == loaded_ + 1 ? Vector3(x_, 0, z) : support(i - 1);
  }
  Vector3 chord(int k, double z) const { return node(k + 1, z) - node(k, z); }

  static double misfit(const Vector& r) {
    double sum = 0;
    for (const double v : r) sum += v * v;
    return std::isfinite(sum) ? std::sqrt(sum) : INFINITY;
  }

  /// Lengths by the line's, forces by the load.
  Vector residual(const Vector& u) const {
    Vector r{};
    const double z = u[as_size(unknowns - 2)], hold = u[as_size(unknowns - 1)];
    double total = 0, before = 0;
    int row = 0;
    double in_x = 0, in_z = 0;
    for (int k = 0; k < branches; ++k) {
      const double H = u[as_size(3 * k)], V = u[as_size(3 * k + 1)], L = u[as_size(3 * k + 2)], V1 = V + weight * L;
      const double T0 = std::hypot(H, V), T1 = std::hypot(H, V1);
      const Vector3 c = chord(k, z);
      r[as_size(row++)] = (H * L / stiffness + H / weight * (std::asinh(V1 / H) - std::asinh(V / H)) - c.x()) / 100;
      r[as_size(row++)] = ((V * L + weight * L * L / 2) / stiffness + (T1 - T0) / weight - c.z()) / 100;
      if (k > 0) r[as_size(row++)] = (T0 - before) / 20e3;
      if (k == loaded_ + 1) {
        double t_x = in_x / before + H / T0, t_z = in_z / before + V / T0;
        const double size = std::hypot(t_x, t_z);
        t_x /= size;
        t_z /= size;
        r[as_size(row++)] = (H - in_x + hold * t_x) / 20e3;
        r[as_size(row++)] = (V - in_z - mass * gravity + hold * t_z) / 20e3;
      }
      before = T1;
      in_x = H;
      in_z = V1;
      total += L;
    }
    r[as_size(row)] = (total - rope_length()) / 100;
    return r;
  }

  Vector newton_step(const Vector& u, const Vector& r) const {
    std::array<Vector, unknowns> a{};
    for (int j = 0; j < unknowns; ++j) {
      Vector moved = u;
      const double h = 1e-7 * std::max(1.0, std::abs(u[as_size(j)]));
      moved[as_size(j)] += h;
      const Vector there = residual(moved);
      for (int i = 0; i < unknowns; ++i) a[as_size(i)][as_size(j)] = (there[as_size(i)] - r[as_size(i)]) / h;
    }
    Vector b;
    for (int i = 0; i < unknowns; ++i) b[as_size(i)] = -r[as_size(i)];
    for (int p = 0; p < unknowns; ++p) {
      int best = p;
      for (int i = p + 1; i < unknowns; ++i) {
        if (std::abs(a[as_size(i)][as_size(p)]) > std::abs(a[as_size(best)][as_size(p)])) best = i;
      }
      std::swap(a[as_size(p)], a[as_size(best)]);
      std::swap(b[as_size(p)], b[as_size(best)]);
      for (int i = p + 1; i < unknowns; ++i) {
        const double f = a[as_size(i)][as_size(p)] / a[as_size(p)][as_size(p)];
        for (int j = p; j < unknowns; ++j) a[as_size(i)][as_size(j)] -= f * a[as_size(p)][as_size(j)];
        b[as_size(i)] -= f * b[as_size(p)];
      }
    }
    for (int i = unknowns - 1; i >= 0; --i) {
      for (int j = i + 1; j < unknowns; ++j) b[as_size(i)] -= a[as_size(i)][as_size(j)] * b[as_size(j)];
      b[as_size(i)] /= a[as_size(i)][as_size(i)];
    }
    return b;
  }

  int loaded_;
  double x_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What both answered, and how long they took.
struct Tally {
  double ours = 0, textbook = 0, difference = 0;
  int positions = 0, solved = 0, textbook_solved = 0;

  void print(benchmark::State& state) const {
    state.counters["of_textbook"] = ours / textbook;
    state.counters["solved"] = static_cast<double>(solved) / positions;
    state.counters["textbook_solved"] = static_cast<double>(textbook_solved) / positions;
    state.counters["difference"] = difference;
  }
};

void six_span_line(benchmark::State& state) {
  std::vector<machine::Model> lines;
  lines.reserve(spans);
  for (int k = 0; k < spans; ++k) lines.push_back(line(k));
  Tally tally;
  for (auto _ : state) {
    double all_six = 0;
    for (int k = 0; k < spans; ++k) {
      solve::EquilibriumOptions options;
      options.prescribed = machine::Prescribed{.carriage = 0, .x = 150.0 * k + 75};
      auto start = std::chrono::steady_clock::now();
      const auto ours = solve::equilibrium(lines[static_cast<std::size_t>(k)], options);
      const double took = seconds_since(start);
      tally.ours += took;
      all_six += took;
      start = std::chrono::steady_clock::now();
      const Textbook textbook(k, 150.0 * k + 75);
      auto u = textbook.start();
      const bool solved = textbook.solve(u);
      tally.textbook += seconds_since(start);
      tally.positions += 1;
      tally.solved += ours.outcome.ok() ? 1 : 0;
      tally.textbook_solved += solved ? 1 : 0;
      if (ours.outcome.ok() && solved) {
        tally.difference =
            std::max(tally.difference, std::abs(ours.branches.back().T_to / textbook.head_tension(u) - 1));
      }
    }
    state.SetIterationTime(all_six);
  }
  tally.print(state);
}

void load_path_100(benchmark::State& state) {
  const machine::Model m = line(2);
  study::LoadPathOptions options;
  options.from = 305;
  options.to = 445;
  options.steps = 99;
  Tally tally;
  for (auto _ : state) {
    auto start = std::chrono::steady_clock::now();
    const auto path = study::load_path(m, options);
    const double took = seconds_since(start);
    tally.ours += took;
    state.SetIterationTime(took);
    start = std::chrono::steady_clock::now();
    std::vector<double> heads;
    Textbook::Vector u = Textbook(2, options.from).start();
    for (const auto& point : path.points) {
      const Textbook textbook(2, point.x);
      const bool solved = textbook.solve(u);
      tally.textbook_solved += solved ? 1 : 0;
      heads.push_back(solved ? textbook.head_tension(u) : 0);
      if (!solved) u = Textbook(2, point.x).start();
    }
    tally.textbook += seconds_since(start);
    for (std::size_t i = 0; i < heads.size(); ++i) {
      tally.positions += 1;
      tally.solved += path.points[i].at.outcome.ok() ? 1 : 0;
      if (heads[i] == 0) continue;
      tally.difference = std::max(tally.difference, std::abs(path.points[i].at.branches.back().T_to / heads[i] - 1));
    }
  }
  tally.print(state);
}

BENCHMARK(six_span_line)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(load_path_100)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
