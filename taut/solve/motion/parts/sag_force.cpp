#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/values.hpp"

// What sagging lines pull their ends with, and their rows.
namespace taut::solve::dynamics {
namespace {

/// Tension along the chord at an end, beside the catenary's: the damper's, less what the momentum of the running rope
/// takes. The rope lifts off before it pushes.
struct AlongChord {
  double T = 0;
  bool bounded = false;
};

AlongChord along_chord(const LineValues& now, const SagValues& is, std::size_t end) {
  const double T = is.damper - now.thrust[end], least = -now.gone * is.lowest;
  return {std::max(T, least), T < least};
}

/// How the damper follows the local unknowns.
std::array<double, 14> damper_slopes(const Scheme& s, const Line& line, const Values& values_now, const LineValues& now,
                                     const SagValues& is, const SagColumns& columns) {
  std::array<double, 14> slopes{};
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  const double square = s.reach * s.reach, lambda = now.l / now.hung;
  const double flows = (now.t.dot(now.apart) - is.chord_rate * now.L) / lambda;
  for (int k = 0; k < line.columns; ++k) {
    const SagColumn& c = columns[as_size(k)];
    const double scale = k < freedoms ? square : 1;
    if (is.bounded != 0) {
      slopes[as_size(k)] = is.bounded * now.gone * scale * c.lowest;
      continue;
    }
    if (is.damper_rate == 0) continue;
    const double l = now.t.dot(c.chord);
    double apart = 0;
    for (const std::size_t end : {0U, 1U}) {  // what turns carries its tangent point along
      if (line.body[end] < 0) continue;
      const bool own = k < freedoms && (k < line.freedoms[0]) == (end == 0);
      const Vector3 moved = values_now.bodies[line.body[end]].w.cross(c.touch[end]);
      apart += (end == 0 ? -1 : 1) * (scale * now.t.dot(moved) + (own ? s.reach * now.t.dot(c.velocity) : 0));
    }
    apart += scale * now.apart.dot(c.chord - l * now.t) / std::max(now.l, 1e-300);
    double rate = (apart - scale * (l - lambda * c.hung) / now.hung * flows - is.chord_rate * scale * c.L) / now.L;
    for (const std::size_t end : {0U, 1U}) {
      if (line.flow[end] != k) continue;
      const bool stuck = values_now.contacts[line.contact[end]].grip == Grip::stuck;
      const double by_flow = stuck ? (s.reach > 0 ? 1 / s.reach : 0) : s.slip_now;
      rate -= (end == 0 ? 1 : -1) * lambda * by_flow / now.L;
    }
    slopes[as_size(k)] = is.damper_rate * rate + is.damper_share * scale * c.stretches;
  }
  return slopes;
}

}  // namespace

std::array<double, 2> windings_of(const Line& line, const Values& before) {
  std::array<double, 2> winding{1, 1};
  for (const std::size_t end : {0U, 1U}) {
    if (line.contact[end] >= 0) winding[end] = before.contacts[line.contact[end]].winding;
  }
  return winding;
}

void pull_sagging(const Line& line, double damping, LineValues& now, SagValues& is) {
  const double share = line.stiffness * now.gone * damping * is.stretches * is.stretches;
  const double most = now.gone * is.lowest;
  is.damper = share * is.chord_rate;
  is.damper_rate = share;
  is.damper_share = is.stretches > 0 ? 2 * is.damper / is.stretches : 0;
  is.bounded = 0;
  if (std::abs(is.damper) > most) {
    is.bounded = static_cast<std::int8_t>(is.damper > 0 ? 1 : -1);
    is.damper = is.bounded * most;
    is.damper_rate = is.damper_share = 0;
  }
  now.e_rate = is.stretches * is.chord_rate;
  now.end_T = {now.gone * is.pull[0].norm() + is.damper, now.gone * is.pull[1].norm() + is.damper};
  now.T = (now.end_T[0] + now.end_T[1]) / 2;
  now.T_e = line.stiffness * now.gone;
  now.T_rate = 0;
}

Vector3 sagging_force(const Line& line, const LineValues& now, const SagValues& is, std::size_t end) {
  const Vector3 pull = now.gone * is.pull[end] + along_chord(now, is, end).T * now.t;
  return (end == 0 ? pull : Vector3(-pull)) - (1 - now.gone) * line.weight * now.hung / 2 * up();
}

double sagging_thrust(const LineValues& now, const SagValues& is, std::size_t end) {
  return is.damper - along_chord(now, is, end).T;
}

void assemble_sagging(Mechanism& m, const Scheme& s, const Values& before, std::size_t i, const Values& values_now,
                      Work& w) {
  const Line& line = m.lines[i];
  const LineValues& now = values_now.lines[i];
  const SagValues& is = values_now.sags[line.sag];
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  line_velocities(line, m.bodies, values_now.bodies, now, w.columns);
  const std::array<Vector3, 2> force{sagging_force(line, now, is, 0), sagging_force(line, now, is, 1)};
  for (int r = 0; r < freedoms; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    w.residual[line.column[as_size(r)]] -= line.copies * force[end].dot(w.columns[as_size(r)].velocity);
  }
  if (!w.tangent) return;
  SagColumns columns;
  sag_columns(line, m.bodies, values_now.bodies, windings_of(line, before), now, is, columns);
  const std::array<double, 14> damper = damper_slopes(s, line, values_now, now, is, columns);
  LineTangent& tangent = w.tangents[i];
  const double square = s.reach * s.reach;
  const std::array<AlongChord, 2> along{along_chord(now, is, 0), along_chord(now, is, 1)};
  for (int k = 0; k < line.columns; ++k) {
    const SagColumn& c = columns[as_size(k)];
    const double scale = k < freedoms ? square : 1;
    tangent.e[as_size(k)] = scale * c.e;
    for (const std::size_t end : {0U, 1U}) {
      tangent.end_T[end][as_size(k)] = scale * now.gone * c.T[end] + damper[as_size(k)];
      tangent.end_e[end][as_size(k)] = scale * c.T[end] / line.stiffness;
      tangent.angle[end][as_size(k)] = scale * c.angle[end];
    }
  }
  auto& values = m.solver.values();
  for (int r = 0; r < freedoms; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    const double sign = end == 0 ? 1 : -1;
    const std::size_t f = as_size(end == 0 ? r : r - line.freedoms[0]);
    const Body& shape = m.bodies[line.body[end]];
    const Vector3& V = w.columns[as_size(r)].velocity;
    const Vector3 moment = shape.turns ? Vector3(force[end].cross(shape.about[f])) : Vector3(Vector3::Zero());
    const int* const places = line.places.data() + static_cast<std::ptrdiff_t>(r) * line.columns;
    for (int k = 0; k < line.columns; ++k) {
      const SagColumn& c = columns[as_size(k)];
      const double scale = k < freedoms ? square : 1;
      const double T = along[end].bounded ? -now.gone * scale * c.lowest : damper[as_size(k)];
      const Vector3 swing = along[end].T / std::max(now.l, 1e-300) * (c.chord - now.t.dot(c.chord) * now.t);
      const Vector3 pull = scale * (now.gone * c.pull[end] + swing) + T * now.t;
      double Q = sign * pull.dot(V) + scale * moment.dot(c.touch[end]);
      Q -= (1 - now.gone) * line.weight * scale * c.hung / 2 * V.z();
      values[places[k]] -= line.copies * Q;
    }
  }
}

double sag_winding_rate(const Mechanism& m, std::size_t line_index, std::size_t end, const Values& now) {
  const Line& line = m.lines[line_index];
  const LineValues& is = now.lines[line_index];
  std::array<double, 2> winding{1, 1};
  for (const std::size_t e : {0U, 1U}) {
    const int contact = line.contact[e];
    if (contact >= 0) winding[e] = winding_stretch(m, now, m.contacts[contact], now.contacts[contact]);
  }
  SagColumns columns;
  sag_columns(line, m.bodies, now.bodies, winding, is, now.sags[line.sag], columns);
  double rate = 0;
  for (int k = 0; k < line.freedoms[0] + line.freedoms[1]; ++k) {
    rate += columns[as_size(k)].angle[end] * now.nu[line.column[as_size(k)]];
  }
  for (const std::size_t e : {0U, 1U}) {
    if (line.flow[e] >= 0) rate += columns[as_size(line.flow[e])].angle[end] * now.contacts[line.contact[e]].flow;
  }
  for (std::size_t k = 0; line.tensioned && k < m.tensioner.size(); ++k) {
    if (m.tensioner[k].first != static_cast<int>(line_index)) continue;
    rate += sag_let_in(line, now.bodies, winding, is, now.sags[line.sag]).angle[end] * now.tension_rate[k];
  }
  return is.radius[end] / winding[end] * rate;
}

}  // namespace taut::solve::dynamics
