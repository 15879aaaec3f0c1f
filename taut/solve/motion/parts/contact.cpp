#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/along.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"
#include "taut/solve/motion/parts/values.hpp"

namespace taut::solve::dynamics {
namespace {

/// Columns of a contact: those of its line `in`, those of `out`, its own, its spin's.
std::size_t own_column(const Mechanism& m, const Contact& contact) {
  std::size_t k = 0;
  if (contact.in >= 0) k += as_size(m.lines[contact.in].columns);
  if (contact.out >= 0) k += as_size(m.lines[contact.out].columns);
  return k;
}

/// The place of the line's column k in the contact's own list.
template <class Visit>
void for_columns(const Mechanism& m, const Contact& contact, const Work& w, Visit visit) {
  if (!w.tangent) return;
  std::size_t k = 0;
  for (const bool out : {false, true}) {
    const int i = out ? contact.out : contact.in;
    if (i < 0) continue;
    const LineTangent& tangent = w.tangents[i];
    const bool hangs = m.lines[i].sag >= 0 && w.hangs[m.lines[i].sag];
    for (int c = 0; c < m.lines[i].columns; ++c, ++k) {
      const std::size_t end = out ? 0 : 1;
      const double e = hangs ? tangent.end_e[end][as_size(c)] : tangent.e[as_size(c)];
      visit(k, out, tangent.end_T[end][as_size(c)], tangent.angle[end][as_size(c)], e);
    }
  }
}

/// a T_out - b T_in = difference, with the wrap's part.
void tension_row(Mechanism& m, const Contact& contact, const Work& w, double a, double b, double by_wrap) {
  if (!w.tangent) return;
  double* const values = m.solver.values().data();
  const int* place = contact.row.data();
  const auto add = [&](int line, std::size_t end, double by_T, double by_angle) {
    const LineTangent& tangent = w.tangents[line];
    const std::size_t columns = as_size(m.lines[line].columns);
    for (std::size_t c = 0; c < columns; ++c, ++place) {
      values[*place] += by_T * tangent.end_T[end][c] + by_angle * tangent.angle[end][c];
    }
  };
  if (contact.in >= 0) add(contact.in, 1, -b, -by_wrap);
  if (contact.out >= 0) add(contact.out, 0, a, by_wrap);
}

/// Rolls with its rim: passed = slipped + rolled.
void rolling_row(Mechanism& m, const Scheme& s, std::size_t i, const Values& before, const Values& now, Work& w) {
  const Contact& contact = m.contacts[i];
  const ContactValues& is = now.contacts[i];
  auto& values = m.solver.values();
  const std::size_t c = as_size(contact.column), own = own_column(m, contact);
  const double scale = std::max(stiffness_at(m, contact, now), 1.0);
  // what has slipped is that of before, also where it was still taken as slipping when it was followed
  w.residual[c] += scale * (now.q[c] - before.contacts[i].slipped - w.q_star[c] - s.reach * is.roll_rate);
  values[contact.row[own]] += scale;
  if (contact.spin < 0) return;
  const double rim = contact.sense * working_radius(m, contact, before) / is.lambda;
  values[contact.row[own + 1]] -= scale * s.reach * s.reach * rim;
  if (is.entry < 0 || now.lines[is.entry].e <= 0) return;
  for_columns(m, contact, w, [&](std::size_t k, bool out, double, double, double e) {
    if ((out ? contact.out : contact.in) != is.entry) return;
    values[contact.row[k]] += scale * s.reach * is.roll_rate / is.lambda * e;
  });
}

/// The drum's rope has a given tension; a slack one counts as a spring that may push, by what it is shorter than its
/// branch: that is linear in the rope passed. Where its rope is broken the drum stays as it is.
void pull_row(Mechanism& m, const Contact& contact, double given, const Values& before, const Values& now, Work& w) {
  auto& values = m.solver.values();
  const int line = contact.in >= 0 ? contact.in : contact.out;
  const std::size_t end = contact.in >= 0 ? 1 : 0;
  const LineValues& is = now.lines[line];
  const bool slack = is.T <= 0;
  const double EA = m.lines[line].stiffness * is.gone;
  if (!(EA > 0)) {
    w.residual[contact.column] += now.q[contact.column] - before.q[contact.column];
    values[contact.row[own_column(m, contact)]] += 1;
    return;
  }
  const double share = is.L / path_of(m.lines[line], is);
  w.residual[contact.column] += (slack ? EA * is.e * share : is.end_T[end]) - given;
  for_columns(m, contact, w, [&](std::size_t k, bool, double T, double, double e) {
    values[contact.row[k]] += slack ? EA * e * share * share : T;
  });
}

constexpr double slack_share = 1e-6;  ///< of its stiffness that a slack branch keeps in derivatives

/// A branch without tension does not answer to its rope. Where it lies on both sides of a taut one, their two contacts
/// would not know which of them passes rope on: neither does, by the little stiffness that is left in the derivatives.
/// The damper counts: in short steps it makes the taut one far stiffer than it is. Without losses the energy along an
/// iteration tells how far it may go, and the less is left the fewer of them are needed.
void keep_slack_apart(Mechanism& m, const Scheme& s, const Contact& contact, const Values& now) {
  const auto spare_of = [&](int i) {
    const Line& line = m.lines[i];
    if (now.lines[i].T > 0) return 0.0;
    if (s.losses == 0) return line.stiffness / std::max(now.lines[i].L, now.lines[i].l);
    return line.stiffness * (1 + line.damping * s.slip_now) / some_length(now.lines[i]);
  };
  const double spare = spare_of(contact.in) + spare_of(contact.out);
  if (spare == 0) return;
  const double share = s.fresh && s.losses > 0 ? rough_slack_share : slack_share;
  m.solver.values()[contact.row[own_column(m, contact)]] -= share * spare;
}

/// Where a closed rope slips at all of its contacts, the derivatives would not know how much of it runs round.
void keep_from_circling(Mechanism& m, const Contact& contact, const Values& now) {
  constexpr double circling_share = 1e-9;  // of the stiffness there
  if (!m.model->reevings[contact.reeving].closed) return;
  m.solver.values()[contact.row[own_column(m, contact)]] -= circling_share * stiffness_at(m, contact, now);
}

/// The part of a T_out - b T_in that follows the acceleration of the contact's spin.
void surge_row(Mechanism& m, const Contact& contact, double a, double b, const Values& before, const Values& now) {
  if (contact.spin < 0) return;
  const SurgeSlopes surge = surge_slopes(m, contact, before, now);
  m.solver.values()[contact.row[own_column(m, contact) + 1]] += a * surge.out - b * surge.in;
}

void law_row(Mechanism& m, const Scheme& s, std::size_t i, const Values& before, const Values& now, Work& w) {
  const Contact& contact = m.contacts[i];
  const Pressure p = pressure(contact, now);
  const ContactValues& is = now.contacts[i];
  const double ratio = is.ratio;
  double& g = w.residual[contact.column];
  if (contact.load) {
    g += p.out - p.in - asked_difference(is);
    tension_row(m, contact, w, 1, 1, 0);
    keep_from_circling(m, contact, now);
    return;
  }
  switch (is.grip) {
    case Grip::forward:
      g += p.out - ratio * p.in;
      tension_row(m, contact, w, 1, ratio, -ratio * p.in * is.log_by_wrap);
      surge_row(m, contact, 1, ratio, before, now);
      break;
    case Grip::backward:
      g += ratio * p.out - p.in;
      tension_row(m, contact, w, ratio, 1, ratio * p.out * is.log_by_wrap);
      surge_row(m, contact, ratio, 1, before, now);
      break;
    default:
      g += p.out - p.in;
      tension_row(m, contact, w, 1, 1, 0);
      surge_row(m, contact, 1, 1, before, now);
      break;
  }
  keep_slack_apart(m, s, contact, now);
  keep_from_circling(m, contact, now);
}

void assemble_flow(Mechanism& m, const Scheme& s, std::size_t i, const Values& before, const Values& now, Work& w) {
  const Contact& contact = m.contacts[i];
  if (const auto given = contact.drum < 0 ? std::nullopt : given_tension(m, contact, before, now.when, now)) {
    pull_row(m, contact, *given, before, now, w);
    return;
  }
  if (now.contacts[i].grip == Grip::stuck) {
    rolling_row(m, s, i, before, now, w);
    return;
  }
  if (loose(contact, now)) {  // the rope stays divided as it is
    m.solver.values()[contact.row[own_column(m, contact)]] += 1;
    return;
  }
  law_row(m, s, i, before, now, w);
}

void assemble_spin(Mechanism& m, const Scheme& s, std::size_t i, const Values& before, const Values& now, Work& w) {
  const Spin& spin = m.spins[i];
  const SpinValues& is = now.spins[i];
  auto& values = m.solver.values();
  const std::size_t c = as_size(spin.column);
  const int first = m.spin_place_first[i];
  const bool set = prescribed(m, spin, before, now.when).has_value();
  const bool light = spin.inertia <= 0;
  if (set || light) {
    values[m.spin_places[first]] += 1;
    if (light && !set) w.residual[c] += now.rate[c];
    if (light) return;
  }
  const int freedoms = spin.body < 0 ? 0 : m.bodies[spin.body].count;
  // absolute spin: that of the carrying body about the axis adds
  double carried = 0;
  Vector3 axis = spin.axis;
  if (spin.body >= 0) {
    axis = now.bodies[spin.body].R * spin.axis;
    carried = axis.dot(acceleration(m, spin.body, now).second);
  }
  const double change = spin.inertia * (is.alpha + carried);
  for (int r = 0; r < freedoms; ++r) {
    const Body& body = m.bodies[spin.body];
    if (!body.turns) break;
    const double share = axis.dot(body.about[as_size(r)]);
    w.residual[body.first + r] += share * change;
    for (int k = 0; k < freedoms; ++k) {
      values[m.spin_places[first + (r + 1) * (freedoms + 1) + k + 1]] +=
          share * spin.inertia * axis.dot(body.about[as_size(k)]);
    }
    if (set) continue;
    values[m.spin_places[first + (r + 1) * (freedoms + 1)]] += share * spin.inertia;
    if (is.turns != 0 || is.capacity <= 0) {
      values[m.spin_places[first + r + 1]] += share * spin.inertia;
    }
  }
  if (set) return;
  if (is.turns == 0 && is.capacity > 0) {  // the bearing sticks
    const double scale = spin.inertia;
    w.residual[c] += scale * (s.reach > 0 ? now.nu[c] / s.reach : now.rate[c]);
    values[m.spin_places[first]] += scale;
    return;
  }
  w.residual[c] +=
      change - drive_torque(m, spin, before, now.when) + is.turns * is.capacity - rope_moment(m, spin, before, now);
  values[m.spin_places[first]] += spin.inertia;
  if (!s.at_rest) {
    w.residual[c] += spin.drag * is.omega;
    values[m.spin_places[first]] += s.reach * spin.drag;
  }
  for (const auto& [index, sense] : spin.contacts) {
    const Contact& contact = m.contacts[index];
    const double lever = sense * contact.copies * working_radius(m, contact, before);
    const BearingSlope slope = bearing_slope(m, contact, before, now);
    const SurgeSlopes surge = surge_slopes(m, contact, before, now);
    values[m.spin_places[first]] +=
        lever * (surge.in - surge.out) + is.turns * (slope.in * surge.in + slope.out * surge.out);
    for_columns(m, contact, w, [&](std::size_t k, bool out, double T, double, double) {
      values[contact.spin_row[k]] += (out ? -lever : lever) * T + is.turns * (out ? slope.out : slope.in) * T;
    });
  }
}

void decide_grip(const Mechanism& m, const Scheme& s, std::size_t i, const Values& before, Values& now) {
  const Contact& contact = m.contacts[i];
  ContactValues& is = now.contacts[i];
  if (contact.in < 0 || contact.out < 0) {
    is.grip = given_tension(m, contact, before, now.when) ? Grip::equal : Grip::stuck;
    return;
  }
  const Pressure p = pressure(contact, now);
  if (!contact.load && std::isinf(is.log_ratio)) {
    is.grip = Grip::stuck;
    return;
  }
  if (!contact.load && (is.log_ratio == 0 || p.in <= 0 || p.out <= 0)) {
    is.grip = Grip::equal;
    return;
  }
  // what has slipped in the step, as a force; at an unchanged time what slips goes on slipping
  const double damping = m.lines[contact.in].damping;
  double slip = 0;
  if (is.grip != Grip::stuck) {
    const double stiffness = stiffness_at(m, contact, now) * (1 + damping * std::max(0.0, s.slip_now));
    slip = stiffness * (is.slipped - before.contacts[i].slipped);
  }
  const bool goes_on = s.slip_now == 0 || (contact.load && damping == 0);
  if (s.h == 0 && goes_on && before.contacts[i].slip_mean != 0) slip = 1e300 * before.contacts[i].slip_mean;
  if (contact.load) {
    is.grip = grip_at_load({is.drop, is.holds}, p.out - p.in, slip);
    return;
  }
  const double ratio = is.ratio;
  const Grip was = is.grip;
  is.grip = p.out - ratio * p.in + slip > 0   ? Grip::forward
            : p.in - ratio * p.out - slip > 0 ? Grip::backward
                                              : Grip::stuck;
  // from one direction to the other by way of rest: an iteration that jumps over it goes in circles
  const bool turns_round =
      (was == Grip::forward && is.grip == Grip::backward) || (was == Grip::backward && is.grip == Grip::forward);
  if (s.fresh && turns_round) is.grip = Grip::stuck;
}

void decide_bearing(const Mechanism& m, const Scheme& s, std::size_t i, const Values& before, Values& now) {
  const Spin& spin = m.spins[i];
  SpinValues& is = now.spins[i];
  is.capacity = friction_of_spin(m, spin, before, now);
  if (is.capacity <= 0 || prescribed(m, spin, before, now.when)) {
    is.turns = 0;
    return;
  }
  const double moment = is.turns != 0 ? is.turns * is.capacity : held_moment(m, spin, is, before, now);
  // at an unchanged time a spin that rests begins to turn where its acceleration goes
  const double push = s.reach > 0     ? spin.inertia / s.reach * is.omega
                      : is.omega != 0 ? 1e300 * is.omega
                                      : spin.inertia * is.alpha;
  const double pushed = moment + push;
  is.turns = static_cast<std::int8_t>(pushed > is.capacity ? 1 : pushed < -is.capacity ? -1 : 0);
  is.bearing = is.turns != 0 ? is.turns * is.capacity : moment;
}

}  // namespace

bool loose(const Contact& contact, const Values& now) {
  // a tension below 0 is one that dampers hold while rates alone are sought (Scheme::only_rates): no slack rope
  const auto slack = [&](int line, std::size_t end) {
    return line >= 0 && now.lines[line].end_T[end] <= 0 && now.lines[line].T >= 0;
  };
  return slack(contact.in, 1) && slack(contact.out, 0);
}

double loose_flow(const Contact& contact, const ContactValues& was, const Values& before) {
  const auto slack = [&](int line) { return line >= 0 && before.lines[line].e <= 0; };
  return slack(contact.in) && slack(contact.out) ? 0 : was.flow;
}

double rope_moment(const Mechanism& m, const Spin& spin, const Values& before, const Values& now) {
  double moment = 0;
  for (const auto& [index, sense] : spin.contacts) {
    const Contact& contact = m.contacts[index];
    const double T_in = contact.in >= 0 ? now.lines[contact.in].end_T[1] : 0;
    const double T_out = contact.out >= 0 ? now.lines[contact.out].end_T[0] : 0;
    moment += sense * contact.copies * working_radius(m, contact, before) * (T_out - T_in);
  }
  return moment;
}

double held_moment(const Mechanism& m, const Spin& spin, const SpinValues& is, const Values& before,
                   const Values& now) {
  double moment = drive_torque(m, spin, before, now.when) - spin.inertia * is.alpha;
  if (spin.body >= 0) {
    const Vector3 axis = now.bodies[spin.body].R * spin.axis;
    moment -= spin.inertia * axis.dot(acceleration(m, spin.body, now).second);
  }
  return moment + rope_moment(m, spin, before, now);
}

BearingSlope bearing_slope(const Mechanism& m, const Contact& contact, const Values& before, const Values& now) {
  BearingSlope slope;
  if (contact.in < 0 || contact.out < 0 || contact.efficiency >= 1) return slope;
  const double share =
      contact.copies * working_radius(m, contact, before) * (1 - contact.efficiency) / (1 + contact.efficiency);
  const LineValues &in = now.lines[contact.in], &out = now.lines[contact.out];
  const Vector3 &t_in = direction(m, now, contact.in, 1), &t_out = direction(m, now, contact.out, 0);
  const Vector3 F = (out.end_T[0] - out.thrust[0]) * t_out - (in.end_T[1] - in.thrust[1]) * t_in;
  const double size = F.norm();
  slope.capacity = share * size;
  if (size == 0) return slope;
  slope.out = share * F.dot(t_out) / size;
  slope.in = -share * F.dot(t_in) / size;
  return slope;
}

void assemble_contacts(Mechanism& m, const Scheme& s, const Values& before, const Values& now, Work& w) {
  for (std::size_t i = 0; i < m.contacts.size(); ++i) assemble_flow(m, s, i, before, now, w);
  for (std::size_t i = 0; i < m.spins.size(); ++i) assemble_spin(m, s, i, before, now, w);
}

bool decide(const Mechanism& m, const Scheme& s, const Values& before, Values& now) {
  bool changed = false;
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Grip was = now.contacts[i].grip;
    decide_grip(m, s, i, before, now);
    changed = changed || was != now.contacts[i].grip;
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const std::int8_t was = now.spins[i].turns;
    decide_bearing(m, s, i, before, now);
    changed = changed || was != now.spins[i].turns;
  }
  return changed;
}

}  // namespace taut::solve::dynamics
