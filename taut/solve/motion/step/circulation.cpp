#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/values.hpp"

/// Closed ropes that slip at all of their contacts. Tensions follow from the rope between each two of them, so that
/// what runs round all of them alike changes none: nothing but rounding says how much that is, while laws change their
/// sides by it and the thrust of fast rope takes all grip away. A rope has its own inertia along itself, though: it
/// goes on as it ran, and gets faster by no more than its tensions could make its mass.
namespace taut::solve::dynamics {
namespace {

constexpr double taut_strain = 1e-3;  ///< with which its inertia is measured, where its tensions are less

struct ClosedRope {
  Array<std::size_t> contacts;
  double misfit = 0;   ///< that all of it is too long or too short, m
  double fastest = 0;  ///< rim or rope before, m/s
  double acceleration = 0;
  bool slips_all_round = true;
};

ClosedRope closed_rope(const Mechanism& m, std::size_t reeving, const Values& before, const Values& now) {
  ClosedRope rope;
  double mass = 0, largest = 0;
  const auto [first, lines] = m.first_line[reeving];
  for (int k = first; k < first + lines; ++k) {
    const LineValues& is = now.lines[k];
    rope.misfit += std::abs(is.e) * is.L;
    mass += m.lines[k].mass * is.L;
    largest = std::max({largest, before.lines[k].T, taut_strain * m.lines[k].stiffness});
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (m.contacts[i].reeving != static_cast<int>(reeving)) continue;
    rope.contacts.push_back(i);
    rope.fastest = std::max({rope.fastest, std::abs(now.contacts[i].roll_rate), std::abs(before.contacts[i].steady)});
    const bool held = now.contacts[i].grip == Grip::stuck || loose(m.contacts[i], now);
    rope.slips_all_round = rope.slips_all_round && !held;
  }
  if (mass > 0) rope.acceleration = 2 * static_cast<double>(rope.contacts.size()) * largest / mass;
  return rope;
}

double mean_of(const Mechanism& m, const ClosedRope& rope, const Array<double>& by_column) {
  double sum = 0;
  for (const std::size_t i : rope.contacts) sum += by_column[m.contacts[i].column];
  return sum / static_cast<double>(rope.contacts.size());
}

}  // namespace

void hold_circulation(const Mechanism& m, const Scheme& s, const Values& before, const Values& now,
                      Array<double>& step) {
  const double time = s.h > 0 ? s.h : s.slip_now > 0 ? 1 / s.slip_now : 0;
  for (std::size_t r = 0; r < m.model->reevings.size(); ++r) {
    if (!m.model->reevings[r].closed) continue;
    const ClosedRope rope = closed_rope(m, r, before, now);
    const bool runs = rope.slips_all_round && rope.acceleration > 0 && !s.at_rest;
    const double most = rope.misfit + time * rope.fastest;
    const double all = runs ? mean_of(m, rope, step) : 0;
    for (const std::size_t i : rope.contacts) {
      double& passes = step[m.contacts[i].column];
      if (now.contacts[i].grip != Grip::stuck) passes = std::clamp(passes - all, -most, most);
    }
    if (!runs) continue;
    const double farthest = time * (rope.fastest + time * rope.acceleration);
    const double is = mean_of(m, rope, now.q) - mean_of(m, rope, before.q);
    const double back = is - std::clamp(is - all, -farthest, farthest);
    for (const std::size_t i : rope.contacts) step[m.contacts[i].column] += back;
  }
}

}  // namespace taut::solve::dynamics
