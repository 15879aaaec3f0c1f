#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/step/step.hpp"

namespace taut::solve::dynamics {
namespace {

Vector3 place_on(const Motion3& body, const Vector3& place) { return body.x + body.R * place; }

void pull_lines(const Mechanism& m, const Values& before, Values& now, Work& w) {
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    LineValues& is = now.lines[i];
    for (std::size_t end = 0; end < 2; ++end) {
      const int body = line.body[end];
      is.touch[end] = body < 0                   ? line.place[end]
                      : m.bodies[body].model < 0 ? now.bodies[body].x
                                                 : place_on(now.bodies[body], line.place[end]);
    }
    const Vector3 d = is.touch[1] - is.touch[0];
    is.l = d.norm();
    is.t = d * (1 / is.l);
    is.L = before.lines[i].L;
    is.e = is.l / is.L - 1;
    if (line.damping > 0) {
      const auto velocity = [&](int body) { return body < 0 ? Vector3(Vector3::Zero()) : now.bodies[body].v; };
      is.e_rate = is.t.dot(velocity(line.body[1]) - velocity(line.body[0])) / is.L;
    }
    pull(line, is);
    const double half = line.weight * is.L / 2;
    const double hangs = hung_at_ends(half * is.t.z(), is.T);
    is.end_T = {is.T - (bears_half(line, 0) ? hangs : 0), is.T + (bears_half(line, 1) ? hangs : 0)};
    const Vector3 force = line.copies * is.T * is.t;
    for (std::size_t end = 0; end < 2; ++end) {
      if (line.body[end] < 0 || m.bodies[line.body[end]].count == 0) continue;
      double* const Q = w.residual.data() + m.bodies[line.body[end]].first;
      const double sign = end == 0 ? 1 : -1;
      Q[0] += sign * force.x();
      Q[1] += sign * force.y();
      Q[2] += sign * force.z() - line.copies * half;
    }
  }
}

/// Accelerations of point masses by lines between points.
void accelerate_points(const Mechanism& m, const Values& before, Values& now, Work& w) {
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    const Body& body = m.bodies[b];
    for (std::size_t k = 0; k < as_size(body.count); ++k) {
      const std::size_t c = as_size(body.first) + k;
      now.bodies[b].x[static_cast<int>(k)] = before.bodies[b].x[static_cast<int>(k)] + w.q_star[c] - before.q[c];
      now.bodies[b].v[static_cast<int>(k)] = now.nu[c] = w.nu_star[c];
      now.q[c] = w.q_star[c];
      w.residual[c] = k == 2 ? -body.own_mass * m.model->gravity : 0;
    }
  }
  pull_lines(m, before, now, w);
  for (const Body& body : m.bodies) {
    if (body.count == 0) continue;
    const double share = 1 / body.mass;
    const auto c = as_size(body.first);
    for (std::size_t k = 0; k < 3; ++k) now.rate[c + k] = w.residual[c + k] * share;
    if (body.model < 0) continue;
    const Vector3 load = dead_load(m, body.model);
    for (std::size_t k = 0; k < 3; ++k) now.rate[c + k] += load[static_cast<int>(k)] * share;
  }
}

/// Whether friction holds a spin that stands: what its ropes and its drive ask of it is within its capacity.
bool held_at_rest(const Mechanism& m, const Spin& spin, const SpinValues& is, const Values& v) {
  if (is.capacity <= 0 || prescribed(m, spin, v, v.when)) return false;
  SpinValues stands = is;
  stands.alpha = 0;
  return std::abs(held_moment(m, spin, stands, v, v)) <= is.capacity;
}

/// Dry friction brings a spin to rest and no further. One that would turn back between two kicks, and that friction
/// holds where it stands, comes to rest in that time.
bool comes_to_rest(const Mechanism& m, std::size_t i, const Values& v, double was, double would) {
  return was * would < 0 && held_at_rest(m, m.spins[i], v.spins[i], v);
}

}  // namespace

StepEnd verlet_step(Mechanism& m, const Scheme& s, Values& before, double t, Values& now, Work& w, Newton& newton) {
  for (std::size_t c = 0; c < as_size(m.size); ++c) {
    w.nu_star[c] = before.nu[c] + s.h / 2 * before.rate[c];
    w.q_star[c] = before.q[c] + s.h * w.nu_star[c];
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const auto c = as_size(m.spins[i].column);
    if (!comes_to_rest(m, i, before, before.nu[c], w.nu_star[c])) continue;
    w.nu_star[c] = 0;
    w.q_star[c] = before.q[c];
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Contact& contact = m.contacts[i];
    const ContactValues& was = before.contacts[i];
    // at the half step, as all that moves: by the rate at the start a sheave with inertia would gain energy
    const double omega = contact.spin >= 0 ? w.nu_star[m.spins[contact.spin].column] : 0;
    w.q_star[contact.column] =
        was.rolled + s.h * contact.sense * omega * working_radius(m, contact, before) / was.lambda;
  }
  if (m.simple) {
    now.t = now.when = t;
    accelerate_points(m, before, now, w);
  } else {
    const StepEnd end = iterate(m, s, before, t, now, w, newton);
    if (end != StepEnd::ok) return end;
  }
  const auto kick = [&](int first, int count) {
    for (std::size_t c = as_size(first); c < as_size(first + count); ++c)
      now.nu[c] = w.nu_star[c] + s.h / 2 * now.rate[c];
  };
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    const Body& body = m.bodies[b];
    if (body.count == 0) continue;
    kick(body.first, body.count);
    Motion3& is = now.bodies[b];
    if (body.point) {
      is.v =
          Vector3(now.nu[body.first], now.nu[as_size(body.first) + 1], now.nu[as_size(body.first) + 2]) + is.driven_v;
      continue;
    }
    is.v = is.driven_v;
    is.w = is.driven_w;
    for (std::size_t f = 0; f < as_size(body.count); ++f) {
      is.v += now.nu[as_size(body.first) + f] * body.along[f];
      is.w += now.nu[as_size(body.first) + f] * body.about[f];
    }
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const auto c = as_size(m.spins[i].column);
    if (!prescribed(m, m.spins[i], before, now.when)) kick(m.spins[i].column, 1);
    if (comes_to_rest(m, i, now, w.nu_star[c], now.nu[c])) {
      now.nu[c] = now.rate[c] = 0;
      now.spins[i].alpha = 0;
      now.spins[i].turns = 0;
    }
    now.spins[i].omega = now.nu[c];
  }
  return StepEnd::ok;
}

double stability_limit(const Mechanism& m, const Values& v) {
  double damping = 0;
  for (const Line& line : m.lines) damping = std::max(damping, line.damping);
  const double omega = highest_frequency(m, v), half = damping * omega * omega / 2 + bounds_of_couples(m, v).rate / 2;
  return 2 / (std::sqrt(omega * omega + half * half) + half);
}

}  // namespace taut::solve::dynamics
