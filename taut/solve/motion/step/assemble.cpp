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

/// Acceleration of the centre of mass and rate of the angular momentum of a body: mass * a, I b + w x I w.
struct Inertia {
  Vector3 c, force, moment;  ///< centre seen from the origin; moment about the centre
  Matrix3 I;
};

Inertia inertia_of(const Mechanism& m, int body, const Values& now) {
  const Body& shape = m.bodies[body];
  const Motion3& is = now.bodies[body];
  const auto [a, b] = acceleration(m, body, now);
  Inertia of;
  of.c = is.R * shape.centre;
  of.I = is.R * shape.inertia * is.R.transpose();
  of.force = shape.mass * (a + b.cross(of.c) + is.w.cross(is.w.cross(of.c)));
  of.moment = of.I * b + is.w.cross(of.I * is.w);
  return of;
}

/// Weight and dead loads of a body on a virtual velocity.
double dead_power(const Mechanism& m, int body, const Values& now, const Vector3& along, const Vector3& about) {
  const Body& shape = m.bodies[body];
  const Motion3& is = now.bodies[body];
  double power = 0;
  if (shape.own_mass > 0) {
    const Vector3 c = is.R * shape.own_centre;
    power -= shape.own_mass * m.model->gravity * (along + about.cross(c)).z();
  }
  if (shape.model < 0) return power;
  for (const machine::Load& load : m.model->loads) {
    if (load.at.body == shape.model && !load.over_time) power += load.force.dot(along + about.cross(is.R * load.at.at));
  }
  return power;
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

/// How inertia and dead forces of a turning body at row i follow its freedom j.
double turning_entry(const Mechanism& m, const Scheme& s, int body, const Values& now, const Inertia& of, int i,
                     int j) {
  const Body& shape = m.bodies[body];
  const Motion3& is = now.bodies[body];
  const Vector3 &A = shape.along[as_size(i)], &B = shape.about[as_size(i)];
  const Vector3 &a = shape.along[as_size(j)], &b = shape.about[as_size(j)];
  const Vector3 lever = A + B.cross(of.c);
  double entry = shape.mass * (a + b.cross(of.c)).dot(lever) + B.dot(of.I * b);
  const Vector3 Iw = of.I * is.w;
  entry += s.reach * (shape.mass * (b.cross(is.w.cross(of.c)) + is.w.cross(b.cross(of.c))).dot(lever) +
                      B.dot(b.cross(Iw) + is.w.cross(of.I * b)));
  // the body turned by b: its centre, its inertia, the lever, the weights
  const Vector3 beta = acceleration(m, body, now).second;
  const Vector3 dc = b.cross(of.c);
  double turned = shape.mass * (beta.cross(dc) + is.w.cross(is.w.cross(dc))).dot(lever) + of.force.dot(B.cross(dc));
  const Vector3 dI_beta = b.cross(of.I * beta) - of.I * b.cross(beta);
  const Vector3 dI_w = b.cross(Iw) - of.I * b.cross(is.w);
  turned += B.dot(dI_beta + is.w.cross(dI_w));
  turned += shape.own_mass * m.model->gravity * B.cross(b.cross(is.R * shape.own_centre)).z();
  if (shape.model >= 0) {
    for (const machine::Load& load : m.model->loads) {
      if (load.at.body == shape.model && !load.over_time) turned -= load.force.dot(B.cross(b.cross(is.R * load.at.at)));
    }
  }
  return entry + s.reach * s.reach * turned;
}

void assemble_turning(Mechanism& m, const Scheme& s, int body, const Values& now, Work& w) {
  const Body& shape = m.bodies[body];
  auto& values = m.solver.values();
  const Inertia of = inertia_of(m, body, now);
  for (int i = 0; i < shape.count; ++i) {
    const Vector3 &along = shape.along[as_size(i)], &about = shape.about[as_size(i)];
    w.residual[shape.first + i] +=
        of.force.dot(along + about.cross(of.c)) + about.dot(of.moment) - dead_power(m, body, now, along, about);
    for (int j = 0; j < shape.count && w.tangent; ++j) {
      values[m.body_places[m.body_place_first[body] + i * shape.count + j]] += turning_entry(m, s, body, now, of, i, j);
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
  auto& values = m.solver.values();
  const double square = s.reach * s.reach, half = line.weight * free_rope(now) / 2;
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  for (int r = 0; r < freedoms; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    const std::size_t f = as_size(end == 0 ? r : r - line.freedoms[0]);
    const double T = (end == 0 ? 1 : -1) * body_pull(now, end);
    const double sign = T == 0 ? 0 : end == 0 ? 1 : -1;
    const Vector3& V = w.columns[as_size(r)].velocity;
    const double along = now.t.dot(V);
    const Body& shape = m.bodies[line.body[end]];
    const int* const places = line.places.data() + static_cast<std::ptrdiff_t>(r) * line.columns;
    for (int k = 0; k < line.columns; ++k) {
      double Q = sign * d.T[as_size(k)] * along - line.weight / 2 * d.free[as_size(k)] * V.z();
      if (k < freedoms) {
        const LineColumn& c = w.columns[as_size(k)];
        Q += square * T * c.t.dot(V);
        if (shape.turns) {
          const Vector3 moved = shape.about[f].cross(c.touch[end]);
          Q += square * (T * now.t.dot(moved) - half * moved.z());
        }
      }
      values[places[k]] -= line.copies * Q;
    }
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
  const Inertia of = inertia_of(m, body, now);
  return of.force.dot(along + about.cross(of.c)) + about.dot(of.moment) - dead_power(m, body, now, along, about);
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
