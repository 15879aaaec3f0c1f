#include <Eigen/Geometry>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/along.hpp"
#include "taut/solve/motion/parts/chain_load.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"

namespace taut::solve::dynamics {
namespace {

/// A force and its moment about a body's origin: on a virtual velocity `along` of the origin and `about` it, their
/// power is force . along + moment . about.
struct Wrench {
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  double power(const Vector3& along, const Vector3& about) const { return force.dot(along) + moment.dot(about); }
};

/// A turning body: what its inertia asks of the forces on it.
struct Inertia {
  Vector3 c, beta, force;  ///< centre of mass, seen from the origin; angular acceleration; mass * that of the centre
  Matrix3 I;               ///< about the centre
  Wrench asks;             ///< c x force + I beta + w x I w
};

Inertia inertia_of(const Mechanism& m, int body, const Values& now) {
  const Body& shape = m.bodies[body];
  const Motion3& is = now.bodies[body];
  const auto [a, beta] = acceleration(m, body, now);
  Inertia of;
  of.c = is.R * shape.centre;
  of.beta = beta;
  of.I = is.R * shape.inertia * is.R.transpose();
  of.force = shape.mass * (a + beta.cross(of.c) + is.w.cross(is.w.cross(of.c)));
  of.asks = {of.force, of.c.cross(of.force) + of.I * beta + is.w.cross(of.I * is.w)};
  return of;
}

/// Each dead force on a body and its place, seen from the origin.
template <typename Use>
void for_each_dead_force(const Mechanism& m, int body, const Values& now, const Use& use) {
  const Body& shape = m.bodies[body];
  const Matrix3& R = now.bodies[body].R;
  if (shape.own_mass > 0) {
    use(Vector3(-shape.own_mass * m.model->gravity * Vector3::UnitZ()), Vector3(R * shape.own_centre));
  }
  if (shape.model < 0) return;
  for (const machine::Load& load : m.model->loads) {
    if (load.at.body == shape.model && !load.over_time) use(load.force, Vector3(R * load.at.at));
  }
}

/// What the inertia of a body asks, less its weight and its dead loads.
Wrench asked_of(const Mechanism& m, int body, const Values& now, const Inertia& of) {
  Wrench asked = of.asks;
  for_each_dead_force(m, body, now, [&](const Vector3& force, const Vector3& at) {
    asked.force -= force;
    asked.moment -= at.cross(force);
  });
  return asked;
}

/// Of a body that only shifts.
void assemble_shifting(Mechanism& m, int body, const Values& now, Work& w) {
  const Body& shape = m.bodies[body];
  auto& values = m.solver.values();
  if (shape.point && !shape.driven) {
    const int* const places = m.body_places.data() + m.body_place_first[body];
    for (int k = 0; k < 3; ++k) {
      const std::size_t c = as_size(shape.first + k);
      w.residual[c] += shape.mass * now.rate[c] - shape.dead[k];
      values[places[std::ptrdiff_t{4} * k]] += shape.mass;
    }
    return;
  }
  const Vector3 driven = now.bodies[body].driven_a;
  const int first_place = m.body_place_first[body];
  for (int i = 0; i < shape.count; ++i) {
    const Vector3& along = shape.along[as_size(i)];
    double g = shape.mass * along.dot(driven) - shape.dead.dot(along);
    for (int j = 0; j < shape.count; ++j) {
      const double mass = shape.mass * along.dot(shape.along[as_size(j)]);
      g += mass * now.rate[shape.first + j];
      values[m.body_places[first_place + i * shape.count + j]] += mass;
    }
    w.residual[shape.first + i] += g;
  }
}

/// How what is asked of a turning body follows its freedom (a, b).
Wrench asked_by(const Mechanism& m, const Scheme& s, int body, const Values& now, const Inertia& of, const Vector3& a,
                const Vector3& b) {
  const double mass = m.bodies[body].mass;
  const Vector3& w = now.bodies[body].w;
  const Vector3 dc = b.cross(of.c), Ib = of.I * b, Iw = of.I * w;
  Wrench by_rate{mass * (a + dc), Ib};
  Wrench by_velocity{mass * (b.cross(w.cross(of.c)) + w.cross(dc)), b.cross(Iw) + w.cross(Ib)};
  // the body turned by b: its centre, its inertia, the levers
  const Vector3 dI_beta = b.cross(of.I * of.beta) - of.I * b.cross(of.beta);
  const Vector3 dI_w = b.cross(Iw) - of.I * b.cross(w);
  Wrench by_place{mass * (of.beta.cross(dc) + w.cross(w.cross(dc))), dc.cross(of.force) + dI_beta + w.cross(dI_w)};
  for_each_dead_force(m, body, now,
                      [&](const Vector3& force, const Vector3& at) { by_place.moment -= b.cross(at).cross(force); });
  const double square = s.reach * s.reach;
  const Vector3 force = by_rate.force + s.reach * by_velocity.force + square * by_place.force;
  return {force, of.c.cross(force) + by_rate.moment + s.reach * by_velocity.moment + square * by_place.moment};
}

void assemble_turning(Mechanism& m, const Scheme& s, int body, const Values& now, Work& w) {
  const Body& shape = m.bodies[body];
  auto& values = m.solver.values();
  const Inertia of = inertia_of(m, body, now);
  const Wrench asked = asked_of(m, body, now, of);
  for (int i = 0; i < shape.count; ++i) {
    w.residual[shape.first + i] += asked.power(shape.along[as_size(i)], shape.about[as_size(i)]);
  }
  const int* const places = m.body_places.data() + m.body_place_first[body];
  for (int j = 0; j < shape.count && w.tangent; ++j) {
    const Wrench by = asked_by(m, s, body, now, of, shape.along[as_size(j)], shape.about[as_size(j)]);
    for (int i = 0; i < shape.count; ++i) {
      values[places[std::ptrdiff_t{i} * shape.count + j]] += by.power(shape.along[as_size(i)], shape.about[as_size(i)]);
    }
  }
}

/// Between two points that shift in space: the same block four times.
void assemble_between_points(Mechanism& m, const Scheme& s, const Line& line, const LineValues& now, Work& w) {
  const double half = line.copies * line.weight * now.L / 2;
  for (int i = 0; i < 3; ++i) {
    const double force = line.copies * now.T * now.t[i], hangs = i == 2 ? half : 0;
    w.residual[line.column[0] + i] -= force - hangs;
    w.residual[line.column[3] + i] += force + hangs;
  }
  if (!w.tangent) return;
  const double square = s.reach * s.reach;
  const double stretched = line.copies * (square * now.T_e / now.L + s.reach * now.T_rate / now.L);
  const double across = line.copies * square * now.T / now.l;
  Vector3 swing = Vector3::Zero();
  if (now.T_rate != 0) {
    swing = (now.apart - now.t.dot(now.apart) * now.t) * (line.copies * square * now.T_rate / (now.L * now.l));
  }
  double* const values = m.solver.values().data();
  const int* const places = line.places.data();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double k = (stretched - across) * now.t[i] * now.t[j] + (i == j ? across : 0) + now.t[i] * swing[j];
      const int at_i = 6 * i + j;
      values[places[at_i]] += k;
      values[places[at_i + 3]] -= k;
      values[places[at_i + 18]] -= k;
      values[places[at_i + 21]] += k;
    }
  }
}

/// Derivatives of strain, rate, tension and of the rope between the rounds by every local unknown.
struct Slopes {
  std::array<double, 14> free{}, T{};  ///< free rope, tension
};

Slopes slopes_of(const Scheme& s, const Values& before, const Line& line, const LineValues& now,
                 const Array<ContactValues>& now_contacts, const std::array<LineColumn, 14>& columns,
                 const std::array<double, 2>& askew, LineTangent& tangent) {
  Slopes d;
  std::array<double, 14> L{}, arc{};
  const double square = s.reach * s.reach, lambda = 1 + now.e, share = line.share;
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  for (int k = 0; k < freedoms; ++k) {
    const LineColumn& c = columns[as_size(k)];
    for (std::size_t end = 0; end < 2; ++end) {
      tangent.angle[end][as_size(k)] = square * c.angle[end];
      if (line.contact[end] < 0) continue;
      const double on = square * (end == 0 ? 1 : -1) * now.radius[end] * c.angle[end];
      if (line.arcs[end]) arc[as_size(k)] += on;
      if (winds(line, now, end)) L[as_size(k)] -= on / before.contacts[line.contact[end]].winding;
    }
    const double e = (square * share * c.l + arc[as_size(k)] - lambda * L[as_size(k)]) / now.L;
    const bool second = k >= line.freedoms[0];
    double apart = s.reach * (second ? 1 : -1) * now.t.dot(c.velocity) + square * c.t.dot(now.apart);
    apart += s.reach * (askew[0] * now.radius[0] * c.angle[0] - askew[1] * now.radius[1] * c.angle[1]);
    tangent.e[as_size(k)] = e;
    d.T[as_size(k)] = now.T_e * e + now.T_rate * share * apart / now.L;
  }
  for (std::size_t end = 0; end < 2; ++end) {
    const int k = line.flow[end];
    if (k < 0) continue;
    const bool stuck = now_contacts[line.contact[end]].grip == Grip::stuck;
    const double by_flow = stuck ? (s.reach > 0 ? 1 / s.reach : 0) : s.slip_now;
    const double sign = end == 0 ? 1 : -1;
    tangent.e[as_size(k)] = -sign * lambda / now.L;
    const bool later = s.only_rates && now.T_rate > 0;  // slip has a rate there, and no way yet
    L[as_size(k)] = later ? 0 : sign;
    d.T[as_size(k)] = ((later ? 0 : now.T_e) + now.T_rate * by_flow) * tangent.e[as_size(k)];
  }
  const double on = on_rounds(now), stretch = 1 + std::max(0.0, now.e);
  for (std::size_t k = 0; k < as_size(line.columns); ++k) {
    d.free[k] = L[k] - (arc[k] - (now.e > 0 ? on / stretch * tangent.e[k] : 0)) / stretch;
  }
  return d;
}

/// The tensions at the ends: what hangs there counts.
void end_slopes(const Scheme& s, const Line& line, const LineValues& now, const std::array<LineColumn, 14>& columns,
                const Slopes& d, LineTangent& tangent) {
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  const double half = line.weight * free_rope(now) * now.t.z() / 2;
  const HungByTension share = line.weight > 0 ? hung_by_tension(half, now.T, s.fresh) : HungByTension{};
  for (int k = 0; k < line.columns; ++k) {
    const double turned = k < freedoms ? s.reach * s.reach * free_rope(now) * columns[as_size(k)].t.z() : 0;
    const double hangs = line.weight / 2 * (d.free[as_size(k)] * now.t.z() + turned), T = d.T[as_size(k)];
    tangent.end_T[0][as_size(k)] = T - (bears_half(line, 0) ? hung_slope(share[0], hangs, T) : 0);
    tangent.end_T[1][as_size(k)] = T + (bears_half(line, 1) ? hung_slope(share[1], hangs, T) : 0);
  }
}

/// Weight and tension on the freedoms of the bodies at its ends.
void add_pull(const Line& line, const LineValues& now, Work& w) {
  const double half = line.weight * free_rope(now) / 2;
  for (int r = 0; r < line.freedoms[0] + line.freedoms[1]; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    const double T = (end == 0 ? 1 : -1) * body_pull(now, end);
    const Vector3& V = w.columns[as_size(r)].velocity;
    w.residual[line.column[as_size(r)]] -= line.copies * (T * now.t.dot(V) - half * V.z());
  }
}

void assemble_line(Mechanism& m, const Scheme& s, const Values& before, std::size_t i, const Values& values_now,
                   Work& w) {
  const Line& line = m.lines[i];
  const LineValues& now = values_now.lines[i];
  if (!w.tangent) {
    line_velocities(line, m.bodies, values_now.bodies, now, w.columns);
    line.part ? add_part(line, now, w) : add_pull(line, now, w);
    return;
  }
  LineTangent& tangent = w.tangents[i];
  line_columns(line, m.bodies, values_now.bodies, now, w.columns);
  line.part ? add_part(line, now, w) : add_pull(line, now, w);
  const bool matters = line.damping > 0 && !s.at_rest;
  const std::array<double, 2> askew = matters ? askew_of(line, values_now.bodies, now) : std::array<double, 2>{};
  const Slopes d = slopes_of(s, before, line, now, values_now.contacts, w.columns, askew, tangent);
  end_slopes(s, line, now, w.columns, d, tangent);
  if (line.part) {
    add_part_slopes(m, s, line, now, tangent, d.free, w);
    return;
  }
  double* const values = m.solver.values().data();
  const double square = s.reach * s.reach, half = line.weight * free_rope(now) / 2;
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  for (int r = 0; r < freedoms; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    const double T = (end == 0 ? 1 : -1) * body_pull(now, end);
    const Vector3& V = w.columns[as_size(r)].velocity;
    const double along = T == 0 ? 0 : (end == 0 ? 1 : -1) * line.copies * now.t.dot(V);
    const double down = line.copies * line.weight / 2 * V.z();
    const int* const places = line.places.data() + static_cast<std::ptrdiff_t>(r) * line.columns;
    for (int k = 0; k < line.columns; ++k) values[places[k]] -= along * d.T[as_size(k)] - down * d.free[as_size(k)];
    // the line turns, and its end moves on the body: V follows
    const Vector3 turns = line.copies * square * T * V;
    for (int k = 0; k < freedoms; ++k) values[places[k]] -= turns.dot(w.columns[as_size(k)].t);
    const Body& shape = m.bodies[line.body[end]];
    if (!shape.turns) continue;
    const std::size_t f = as_size(end == 0 ? r : r - line.freedoms[0]);
    const Vector3 pulls = line.copies * square * (T * now.t - half * Vector3::UnitZ());
    const Vector3 moves = pulls.cross(shape.about[f]);
    for (int k = 0; k < freedoms; ++k) values[places[k]] -= moves.dot(w.columns[as_size(k)].touch[end]);
  }
}

}  // namespace

Vector3 dead_load(const Mechanism& m, int model_body) {
  Vector3 force = Vector3::Zero();
  for (const machine::Load& load : m.model->loads) {
    if (load.at.body == model_body && !load.over_time) force += load.force;
  }
  return force;
}

double inertia_power(const Mechanism& m, int body, const Values& now, const Vector3& along, const Vector3& about) {
  return asked_of(m, body, now, inertia_of(m, body, now)).power(along, about);
}

void assemble(Mechanism& m, const Scheme& s, const Values& before, const Values& now, Work& w) {
  std::fill(w.residual.begin(), w.residual.end(), 0.0);
  m.solver.set_zero();
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].count == 0) continue;
    if (m.bodies[b].turns) {
      assemble_turning(m, s, static_cast<int>(b), now, w);
    } else {
      assemble_shifting(m, static_cast<int>(b), now, w);
    }
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const bool hangs = sags(m.lines[i], now.lines[i]);
    if (m.lines[i].sag >= 0) w.hangs[m.lines[i].sag] = hangs ? 1 : 0;
    if (hangs) {
      assemble_sagging(m, s, before, i, now, w);
    } else if (m.lines[i].between_points) {
      assemble_between_points(m, s, m.lines[i], now.lines[i], w);
    } else if (m.lines[i].plain) {
      assemble_plain(m, s, i, now, w);
    } else {
      assemble_line(m, s, before, i, now, w);
    }
    if (m.lines[i].has_along && !s.at_rest) assemble_along(m, i, now, w);
  }
  if (!m.chain_loads.empty()) assemble_chain_loads(m, s, now, w);
  assemble_contacts(m, s, before, now, w);
  assemble_couples(m, s, now, w);
}

}  // namespace taut::solve::dynamics
