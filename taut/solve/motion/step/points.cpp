#include "taut/solve/motion/step/points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/math/index.hpp"
#include "taut/solve/motion/step/stable.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double shortest_link = std::numeric_limits<double>::min();  ///< m: a link between strands may have no length

/// Joints of a chain, which no other rope touches.
bool is_joint(const Mechanism& m, int body) { return body >= 0 && m.bodies[body].model < 0; }

/// Numbers the nodes: one strand after another, cut where a rope is held by a body of the model.
void lay_out(const Mechanism& m, Points& p) {
  p.starts.clear();
  p.ends.clear();
  p.line.clear();
  p.joint.clear();
  p.body.clear();
  p.link.resize(m.lines.size());
  Array<int> place(m.bodies.size(), -1);
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (is_joint(m, static_cast<int>(b))) continue;
    place[b] = static_cast<int>(p.body.size());
    p.body.push_back(static_cast<int>(b));
  }
  const auto end_at = [&](const Line& line, std::size_t end) {
    const int b = line.body[end];
    return Points::End{static_cast<int>(p.line.size()), b < 0 ? -1 : place[b], line.offset[end]};
  };
  for (const auto& [first, count] : m.first_line) {
    for (int i = first; i < first + count; ++i) {
      const Line& line = m.lines[i];
      const int before = i > first ? m.lines[i - 1].body[1] : -1;
      const bool goes_on = is_joint(m, before) && before == line.body[0];
      if (goes_on) {
        p.joint.back() = before;
      } else {
        if (i > first) p.ends.push_back(end_at(m.lines[i - 1], 1));
        if (!p.line.empty()) p.line.push_back(-1), p.joint.push_back(-1);
        p.starts.push_back(end_at(line, 0));
      }
      p.link[i] = static_cast<int>(p.line.size());
      p.line.push_back(i);
      p.joint.push_back(-1);
    }
    if (count > 0) p.ends.push_back(end_at(m.lines[first + count - 1], 1));
  }
}

void resize(Points& p, Eigen::Index links) {
  for (Points::Places* of : {&p.x, &p.v, &p.a, &p.free_fall}) of->setZero(links + 1, 3);
  p.share.setZero(links + 1);
  p.force.setZero(links, 3);
  for (Points::Column* of : {&p.L, &p.per_length, &p.stiffness, &p.damping, &p.copies, &p.hangs.front(),
                             &p.hangs.back(), &p.l, &p.e, &p.e_was, &p.T, &p.held, &p.change, &p.error}) {
    of->setZero(links);
  }
  p.e.setConstant(-1);
}

void gather_links(const Run& run, Points& p) {
  const Mechanism& m = run.m;
  p.damped = std::any_of(m.lines.begin(), m.lines.end(), [](const Line& line) { return line.damping > 0; });
  p.changes_known = true;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = run.before.lines[i];
    const Eigen::Index k = p.link[i];
    p.L[k] = is.L;
    p.per_length[k] = 1 / is.L;
    p.stiffness[k] = line.stiffness * is.gone;
    p.damping[k] = line.damping;
    p.copies[k] = line.copies;
    for (std::size_t end = 0; end < 2; ++end) p.hangs[end][k] = bears_half(line, end) ? line.weight * is.L / 2 : 0;
    p.e[k] = is.e;
    p.T[k] = is.T;
    p.held[k] = is.T - p.stiffness[k] * std::max(0.0, is.e);
    p.changes_known = p.changes_known && !std::isnan(run.T_rate[i]);
    p.change[k] = p.changes_known ? run.T_rate[i] * run.options.step : 0;
  }
}

void gather(const Run& run, Points& p) {
  const Mechanism& m = run.m;
  lay_out(m, p);
  resize(p, static_cast<Eigen::Index>(p.line.size()));
  gather_links(run, p);
  Array<Vector3> dead(m.bodies.size());
  for (std::size_t b = 0; b < m.bodies.size(); ++b) dead[b] = m.bodies[b].dead;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    for (const int body : m.lines[i].body) {
      if (body >= 0) dead[body].z() -= m.lines[i].copies * m.lines[i].weight * run.before.lines[i].L / 2;
    }
  }
  const auto three = [](const Array<double>& all, const Body& body) {
    return Vector3(all[body.first], all[body.first + 1], all[body.first + 2]);
  };
  for (std::size_t i = 0; i < p.joint.size(); ++i) {
    if (p.joint[i] < 0) continue;
    const Body& body = m.bodies[p.joint[i]];
    const auto node = static_cast<Eigen::Index>(i + 1);
    p.x.row(node) = run.before.bodies[p.joint[i]].x.array().transpose();
    p.v.row(node) = three(run.before.nu, body).array().transpose();
    p.a.row(node) = three(run.before.rate, body).array().transpose();
    p.free_fall.row(node) = dead[p.joint[i]].array().transpose() / body.mass;
    p.share[node] = 1 / body.mass;
  }
  const std::size_t n = p.body.size();
  p.at.assign(n, Vector3::Zero());
  p.velocity = p.rate = p.on_body = p.still = p.at;
  p.body_share.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const Body& body = m.bodies[p.body[k]];
    p.at[k] = run.before.bodies[p.body[k]].x;
    p.still[k] = dead[p.body[k]];
    if (body.count == 0) continue;
    p.body_share[k] = 1 / body.mass;
    p.velocity[k] = three(run.before.nu, body);
    p.rate[k] = three(run.before.rate, body);
  }
}

/// The velocities by `h` of the accelerations.
void hurry(Points& p, double h) {
  p.v += h * p.a;
  for (std::size_t b = 0; b < p.at.size(); ++b) p.velocity[b] += h * p.rate[b];
}

/// The places by the velocities, which are those of the middle of the step.
void drift(Points& p, double h) {
  p.x += h * p.v;
  for (std::size_t b = 0; b < p.at.size(); ++b) p.at[b] += h * p.velocity[b];
}

/// The ends of the strands go with their bodies.
void follow_bodies(Points& p) {
  const auto follow = [&](const Points::End& end) {
    for (int k = 0; k < 3; ++k) {
      p.x(end.node, k) = end.offset[k] + (end.body < 0 ? 0 : p.at[end.body][k]);
      p.v(end.node, k) = end.body < 0 ? 0 : p.velocity[end.body][k];
    }
  };
  for (const Points::End& end : p.starts) follow(end);
  for (const Points::End& end : p.ends) follow(end);
}

/// Tensions by the places, T = EA max(0, min(e + beta e', 2 e)), their errors, and the force of each link on the node
/// before it. The work that the dampers have taken in the step, J. One pass, so that nothing waits for memory.
template <bool damped>
double pull(Points& p) {
  const auto n = static_cast<std::size_t>(p.l.size());
  const double *const x = p.x.col(0).data(), *const y = p.x.col(1).data(), *const z = p.x.col(2).data();
  const double *const u = p.v.col(0).data(), *const v = p.v.col(1).data(), *const w = p.v.col(2).data();
  const double *const L = p.L.data(), *const per_length = p.per_length.data(), *const EA = p.stiffness.data();
  const double *const beta = p.damping.data(), *const copies = p.copies.data();
  double *const l = p.l.data(), *const e = p.e.data(), *const e_was = p.e_was.data(), *const T = p.T.data();
  double *const held = p.held.data(), *const change = p.change.data(), *const error = p.error.data();
  double *const X = p.force.col(0).data(), *const Y = p.force.col(1).data(), *const Z = p.force.col(2).data();
  double taken = 0;
#pragma omp simd reduction(+ : taken)
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i], dz = z[i + 1] - z[i];
    const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double some = length > shortest_link ? length : shortest_link;
    const double was = e[i], is = length * per_length[i] - 1, stretched = is > 0 ? is : 0;
    double tension = EA[i] * stretched, damper = 0;
    if constexpr (damped) {
      const double rate = (dx * (u[i + 1] - u[i]) + dy * (v[i + 1] - v[i]) + dz * (w[i + 1] - w[i])) / some;
      const double strain = stretched + beta[i] * rate * per_length[i];
      const double pulls = strain > 0 ? strain : 0, bounded = pulls < 2 * stretched ? pulls : 2 * stretched;
      const double by_damper = EA[i] * bounded - tension;
      taken += copies[i] * (by_damper + held[i]) * L[i] * (is - was) / 2;
      damper = by_damper - held[i];
      held[i] = by_damper;
      tension += by_damper;
    }
    const double more = tension - T[i], off = step_error(more, change[i], damper);
    error[i] = off > error[i] ? off : error[i];
    change[i] = more;
    T[i] = tension;
    l[i] = length;
    e_was[i] = was;
    e[i] = is;
    const double per = copies[i] * tension / some;
    X[i] = per * dx;
    Y[i] = per * dy;
    Z[i] = per * dz;
  }
  return taken;
}

void pull_bodies(Points& p) {
  p.on_body = p.still;
  for (const Points::End& start : p.starts) {
    if (start.body >= 0) p.on_body[start.body] += p.force.row(start.node).matrix().transpose();
  }
  for (const Points::End& end : p.ends) {
    if (end.body >= 0) p.on_body[end.body] -= p.force.row(end.node - 1).matrix().transpose();
  }
  for (std::size_t b = 0; b < p.at.size(); ++b) p.rate[b] = p.on_body[b] * p.body_share[b];
}

void accelerate(Points& p) {
  const Eigen::Index inner = p.l.size() - 1;
  for (int k = 0; k < 3; ++k) {
    p.a.col(k).segment(1, inner) =
        p.free_fall.col(k).segment(1, inner) +
        (p.force.col(k).tail(inner) - p.force.col(k).head(inner)) * p.share.segment(1, inner);
  }
}

/// From the forces of one step to the places of the next: accelerate(), hurry() and drift() in one pass.
void go_on_to_next(Points& p, double h) {
  const auto n = static_cast<std::size_t>(p.l.size());
  const double* const share = p.share.data();
  for (int k = 0; k < 3; ++k) {
    double *const x = p.x.col(k).data(), *const v = p.v.col(k).data();
    const double *const F = p.force.col(k).data(), *const g = p.free_fall.col(k).data();
#pragma omp simd
    for (std::size_t i = 1; i < n; ++i) {
      v[i] += h * (g[i] + (F[i] - F[i - 1]) * share[i]);
      x[i] += h * v[i];
    }
  }
  for (std::size_t b = 0; b < p.at.size(); ++b) {
    p.velocity[b] += h * p.rate[b];
    p.at[b] += h * p.velocity[b];
  }
}

/// Tensions at the ends of a link.
std::array<double, 2> end_tensions(const Points& p, Eigen::Index k) {
  const double T = p.T[k], rises = (p.x(k + 1, 2) - p.x(k, 2)) / p.l[k];
  const auto hung = [&](std::size_t end) {
    return p.hangs[end][k] == 0 ? 0 : hung_at_ends(p.hangs[end][k] * rises, T);
  };
  return {T - hung(0), T + hung(1)};
}

/// Of the rope that is in links from first to first + count.
struct LeastTensions {
  double anywhere = std::numeric_limits<double>::infinity();
  double loosest = std::numeric_limits<double>::infinity();  ///< mean of the ends of a branch
};

LeastTensions least_tensions(const Run& run, const Points& p, std::size_t reeving) {
  const auto [first, count] = run.m.first_line[reeving];
  const int pieces = std::max(1, run.model.reevings[reeving].segments);
  LeastTensions least;
  least.anywhere = p.T.segment(p.link[first], p.link[first + count - 1] + 1 - p.link[first]).minCoeff();
  for (int i = first; i + pieces <= first + count; i += pieces) {
    const std::array<double, 2> of_first = end_tensions(p, p.link[i]);
    const std::array<double, 2> of_last = pieces > 1 ? end_tensions(p, p.link[i + pieces - 1]) : of_first;
    least.anywhere = std::min({least.anywhere, of_first[0], of_last[1]});
    least.loosest = std::min(least.loosest, (of_first[0] + of_last[1]) / 2);
  }
  return least;
}

/// Keeps the largest and the least tension of each rope, and where a line became slack or taut in the step.
void watch_ropes(Run& run, const Points& p, double t, double h) {
  for (std::size_t r = 0; r < run.m.first_line.size(); ++r) {
    const auto [first, count] = run.m.first_line[r];
    if (count == 0) continue;
    const Eigen::Index from = p.link[first], links = p.link[first + count - 1] + 1 - from;
    const int pieces = std::max(1, run.model.reevings[r].segments);
    double largest = p.T.segment(from, links).maxCoeff();
    for (int i = first; i + pieces <= first + count; i += pieces) {
      largest = std::max({largest, end_tensions(p, p.link[i])[0], end_tensions(p, p.link[i + pieces - 1])[1]});
    }
    RopeExtreme& of = run.result.ropes[r];
    of.T.end = largest;
    if (!is_broken(run.m, run.before, r)) {
      const LeastTensions least = least_tensions(run, p, r);
      keep_least(least.anywhere, least.loosest, t, of);
    }
    if (largest > of.T.max) {
      of.T.max = largest;
      of.T.t_max = t;
      for (int i = first + count - 1; i >= first; --i) {
        const std::array<double, 2> T = end_tensions(p, p.link[i]);
        if (std::max(T[0], T[1]) >= largest) of.branch = i - first;
      }
      run.T_largest[r] = std::max(run.T_largest[r], largest);
    }
    const bool turned = (p.e.segment(from, links) * p.e_was.segment(from, links)).minCoeff() <= 0;
    for (int i = first; turned && i < first + count; ++i) {
      const Eigen::Index k = p.link[i];
      if (p.stiffness[k] > 0) note_slack(run, as_size(i), p.e_was[k], p.e[k], t - h, h);
    }
  }
}

/// What the step after the last one, or an observer, reads.
void scatter(Run& run, const Points& p, double t) {
  const Mechanism& m = run.m;
  Values& v = run.before;
  v.t = v.when = t;
  const auto put = [&](std::size_t b, const Vector3& x, const Vector3& velocity, const Vector3& rate) {
    for (int k = 0; k < 3; ++k) {
      const int c = m.bodies[b].first + k;
      v.q[c] += x[k] - v.bodies[b].x[k];
      v.nu[c] = velocity[k];
      v.rate[c] = rate[k];
    }
    v.bodies[b].x = x;
    v.bodies[b].v = velocity;
  };
  for (std::size_t k = 0; k < p.body.size(); ++k) {
    if (p.body_share[k] > 0) put(as_size(p.body[k]), p.at[k], p.velocity[k], p.rate[k]);
  }
  for (std::size_t i = 0; i < p.joint.size(); ++i) {
    const auto node = static_cast<Eigen::Index>(i + 1);
    if (p.joint[i] >= 0) put(as_size(p.joint[i]), p.x.row(node), p.v.row(node), p.a.row(node));
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Eigen::Index k = p.link[i];
    LineValues& is = v.lines[i];
    is.e = p.e[k];
    is.T = p.T[k];
    is.l = (1 + is.e) * is.L;
    is.end_T = end_tensions(p, k);
  }
}

}  // namespace

bool steps_as_points(const Run& run) {
  if (run.options.method != TimeMethod::verlet || !run.m.simple) return false;
  if (run.options.moment && run.options.closely) return false;  // a moment is seen after a step by itself
  const auto fades = [&](const Run::Breaking& one) { return run.before.t < one.from + one.over; };
  if (std::any_of(run.breaking.begin(), run.breaking.end(), fades)) return false;
  for (std::size_t i = 0; i < run.model.events.size(); ++i) {
    if (!run.happened[i] && run.model.events[i].when) return false;
  }
  return true;
}

void step_points(Run& run, Points& p, double limit, long most) {
  const double h = run.options.step, start = run.before.t;
  long steps = std::min(most, static_cast<long>((limit - start) / h) - 1);
  // who looks at moments does so after the single step that follows
  if (run.options.moment) steps = std::min(steps, static_cast<long>(run.options.moment_step / h) - 1);
  if (steps < 1 || run.m.lines.empty()) return;
  gather(run, p);
  const bool observed = !run.model.observed.empty();
  hurry(p, h / 2);
  drift(p, h);
  for (long s = 1; s <= steps; ++s) {
    const double t = start + static_cast<double>(s) * h;
    ++run.result.steps;  // those who measure tell the first value by it
    follow_bodies(p);
    run.ledger.damped += p.damped ? pull<true>(p) : pull<false>(p);
    if (s == 1 && !p.changes_known) p.error.setZero();
    pull_bodies(p);
    watch_ropes(run, p, t, h);
    if (s < steps && !observed) {
      go_on_to_next(p, h);
      continue;
    }
    accelerate(p);
    hurry(p, h / 2);
    if (s == steps) break;
    scatter(run, p, t);
    measure(run, run.before);
    hurry(p, h / 2);
    drift(p, h);
  }
  scatter(run, p, start + static_cast<double>(steps) * h);
  if (observed) measure(run, run.before);
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    double& largest = run.T_error[run.m.lines[i].reeving];
    largest = std::max(largest, p.error[p.link[i]]);
    run.T_rate[i] = p.change[p.link[i]] / h;
  }
  run.result.largest_step = std::max(run.result.largest_step, h);
  if (run.result.smallest_step == 0) run.result.smallest_step = h;
}

}  // namespace taut::solve::dynamics
