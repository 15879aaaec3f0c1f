#include "taut/solve/motion/step/points.hpp"

#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/step/stable.hpp"

namespace taut::solve::dynamics {
namespace {

void gather(const Run& run, Points& p) {
  const Mechanism& m = run.m;
  const std::size_t n = m.bodies.size() + 1;
  p.x.assign(3 * n, 0.0);
  p.v = p.a = p.dead = p.force = p.x;
  p.inverse_mass.assign(n, 0.0);
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    const Body& body = m.bodies[b];
    const bool moves = body.count > 0;
    if (moves) p.inverse_mass[b + 1] = 1 / body.mass;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = 3 * (b + 1) + k;
      p.x[i] = run.before.bodies[b].x[static_cast<int>(k)];
      p.dead[i] = body.dead[static_cast<int>(k)];
      if (!moves) continue;
      p.v[i] = run.before.nu[as_size(body.first) + k];
      p.a[i] = run.before.rate[as_size(body.first) + k];
    }
  }
  p.links.resize(m.lines.size());
  p.e.resize(m.lines.size());
  p.e_last.resize(m.lines.size());
  p.T.resize(m.lines.size());
  p.change.resize(m.lines.size());
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = run.before.lines[i];
    const Vector3 beside = line.offset[1] - line.offset[0];
    const double half = line.weight * is.L / 2;
    p.links[i] = {line.body[0] + 1,
                  line.body[1] + 1,
                  beside.x(),
                  beside.y(),
                  beside.z(),
                  1 / is.L,
                  line.copies * line.stiffness * is.gone,
                  line.damping,
                  line.copies,
                  line.segment < 0 ? half : 0};
    for (const int body : line.body) p.dead[3 * as_size(body + 1) + 2] -= line.copies * half;
    p.e[i] = is.e;
    p.T[i] = is.T;
    p.change[i] = run.T_rate[i] * run.options.step;
  }
}

/// Forces of a rope's lines; the work of its dampers is added.
struct RopeStep {
  double largest = 0;  ///< tension at an end of any line, of one copy, N
  double error = 0;    ///< of the tension of any line, N
  int branch = 0;
  bool turned = false;  ///< a line became slack or taut
};

template <bool damped>
RopeStep pull_rope(Points& p, int first, int count, double& work) {
  RopeStep step;
  double* const F = p.force.data();
  const double *const X = p.x.data(), *const V = p.v.data();
  for (std::size_t i = as_size(first); i < as_size(first + count); ++i) {
    const Points::Link& link = p.links[i];
    const int a = 3 * link.from, b = 3 * link.to;
    const double x = X[b] - X[a] + link.dx, y = X[b + 1] - X[a + 1] + link.dy, z = X[b + 2] - X[a + 2] + link.dz;
    const double l = std::sqrt(x * x + y * y + z * z), e = l * link.per_length - 1, was = p.e_last[i];
    double T = e > 0 ? link.stiffness * e : 0, damper = 0;
    if constexpr (damped) {
      const double rate = (x * (V[b] - V[a]) + y * (V[b + 1] - V[a + 1]) + z * (V[b + 2] - V[a + 2])) / l;
      const double elastic = T, elastic_before = was > 0 ? link.stiffness * was : 0;
      if (e > 0) T = link.stiffness * std::clamp(e + link.damping * rate * link.per_length, 0.0, 2 * e);
      work += (T - elastic + link.copies * p.T[i] - elastic_before) / (2 * link.per_length) * (e - was);
      damper = (T - elastic - (link.copies * p.T[i] - elastic_before)) / link.copies;
    }
    step.turned = step.turned || (e > 0) != (was > 0);
    p.e[i] = e;
    const double change = T / link.copies - p.T[i], error = step_error(change, p.change[i], damper);
    if (error > step.error) step.error = error;
    p.change[i] = change;
    p.T[i] = T / link.copies;
    const double per = T / l, end = p.T[i] + hung_at_ends(link.hangs * std::abs(z) / l, p.T[i]);
    if (end > step.largest) {
      step.largest = end;
      step.branch = static_cast<int>(i) - first;
    }
    F[a] += per * x;
    F[a + 1] += per * y;
    F[a + 2] += per * z;
    F[b] -= per * x;
    F[b + 1] -= per * y;
    F[b + 2] -= per * z;
  }
  return step;
}

void extend_rope(Run& run, std::size_t r, const RopeStep& step, double t) {
  RopeExtreme& of = run.result.ropes[r];
  of.T.end = step.largest;
  if (step.largest < of.T.min) {
    of.T.min = step.largest;
    of.T.t_min = t;
  }
  if (step.largest <= of.T.max) return;
  of.T.max = step.largest;
  of.T.t_max = t;
  of.branch = step.branch;
  run.T_largest[r] = std::max(run.T_largest[r], step.largest);
}

void pull_all(Run& run, Points& p, double t, double h) {
  std::copy(p.dead.begin(), p.dead.end(), p.force.begin());
  std::swap(p.e, p.e_last);
  for (std::size_t r = 0; r < run.m.first_line.size(); ++r) {
    const auto [first, count] = run.m.first_line[r];
    if (count == 0) continue;
    const bool damped = p.links[first].damping > 0;
    const RopeStep step = damped ? pull_rope<true>(p, first, count, run.ledger.damped)
                                 : pull_rope<false>(p, first, count, run.ledger.damped);
    extend_rope(run, r, step, t);
    run.T_error[r] = std::max(run.T_error[r], step.error);
    for (std::size_t i = as_size(first); step.turned && i < as_size(first + count); ++i) {
      if (p.links[i].stiffness > 0) note_slack(run, i, p.e_last[i], p.e[i], t - h, h);
    }
  }
}

/// What the step after the last one, or an observer, reads.
void scatter(Run& run, const Points& p, double t) {
  const Mechanism& m = run.m;
  Values& v = run.before;
  v.t = v.when = t;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].count == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t c = as_size(m.bodies[b].first) + k, i = 3 * (b + 1) + k;
      v.q[c] += p.x[i] - v.bodies[b].x[static_cast<int>(k)];
      v.bodies[b].x[static_cast<int>(k)] = p.x[i];
      v.bodies[b].v[static_cast<int>(k)] = v.nu[c] = p.v[i];
      v.rate[c] = p.a[i];
    }
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    LineValues& is = v.lines[i];
    is.e = p.e[i];
    is.T = p.T[i];
    is.l = (1 + is.e) * is.L;
    const auto end_z = [&](std::size_t end) { return p.x[3 * as_size(line.body[end] + 1) + 2] + line.offset[end].z(); };
    const double hangs = hung_at_ends(p.links[i].hangs * (end_z(1) - end_z(0)) / is.l, is.T);
    is.end_T = {is.T - hangs, is.T + hangs};
  }
}

}  // namespace

bool steps_as_points(const Run& run) {
  if (run.options.method != TimeMethod::verlet || !run.m.simple) return false;
  const auto fades = [&](const Run::Breaking& one) { return run.before.t < one.from + one.over; };
  if (std::any_of(run.breaking.begin(), run.breaking.end(), fades)) return false;
  for (std::size_t i = 0; i < run.model.events.size(); ++i) {
    if (!run.happened[i] && run.model.events[i].when) return false;
  }
  return true;
}

void step_points(Run& run, Points& p, double limit, long most) {
  const double h = run.options.step, start = run.before.t;
  const long steps = std::min(most, static_cast<long>((limit - start) / h) - 1);
  if (steps < 1) return;
  gather(run, p);
  const std::size_t n = p.inverse_mass.size();
  for (long s = 1; s <= steps; ++s) {
    const double t = start + static_cast<double>(s) * h;
    for (std::size_t i = 0; i < 3 * n; ++i) p.x[i] += h * (p.v[i] += h / 2 * p.a[i]);
    pull_all(run, p, t, h);
    for (std::size_t b = 0; b < n; ++b) {
      for (std::size_t i = 3 * b; i < 3 * b + 3; ++i) p.v[i] += h / 2 * (p.a[i] = p.force[i] * p.inverse_mass[b]);
    }
    if (run.model.observed.empty()) continue;
    scatter(run, p, t);
    extend_observed(run, run.before);
  }
  scatter(run, p, start + static_cast<double>(steps) * h);
  for (std::size_t i = 0; i < p.change.size(); ++i) run.T_rate[i] = p.change[i] / h;
  run.result.steps += steps;
  run.result.largest_step = std::max(run.result.largest_step, h);
  if (run.result.smallest_step == 0) run.result.smallest_step = h;
}

}  // namespace taut::solve::dynamics
