#include "taut/solve/motion/run/ledger.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/along.hpp"
#include "taut/solve/motion/parts/chain_load.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"

namespace taut::solve::dynamics {
namespace {

/// What a metre of unstretched rope takes out of a line at one end, J/m: the tension's work less its strain energy.
double per_metre(const Mechanism& m, const Values& v, int i, std::size_t end) {
  const Line& line = m.lines[i];
  const LineValues& is = v.lines[i];
  if (!sags(line, is)) return is.end_T[end] * (1 + is.e) - elastic_tension(line, is) * is.e / 2;
  const double e = end_strain(m, v, i, end), T = line.stiffness * is.gone * e;
  return T * (1 + e / 2) + (is.end_T[end] - T) * is.l / is.hung;
}

/// What an end of a line would have to hold of its weight beyond what its tension allows, N: a slack rope's weight
/// counts in the middle of its branch, where rope that runs in at an end falls to, or is lifted from, without a force.
double hangs_on_nothing(const Line& line, const LineValues& v) {
  if (line.weight == 0 || sags(line, v)) return 0;
  const double rope = free_rope(v), hangs = line.weight * rope * v.t.z() / 2;
  if (rope == 0) return 0;
  return (hangs - hung_at_ends(hangs, v.T)) * v.l / rope;  // a broken one may be shorter than its branch
}

/// What a line's energy falls by per metre of unstretched rope that is let in, J/m; of a slack rope too, which carries
/// less than its weight.
double per_metre_let_in(const Mechanism& m, const Values& values, int i, std::size_t end) {
  const Line& line = m.lines[i];
  const LineValues& v = values.lines[i];
  if (sags(line, v)) return per_metre(m, values, i, end) - line.weight * v.touch[end].z();
  const double middle = borne(line, v.l, 0) * v.touch[0].z() + borne(line, v.l, 1) * v.touch[1].z();
  return v.T * (1 + v.e) - elastic_tension(line, v) * v.e / 2 - line.weight * middle;
}

void set_prices(const Mechanism& m, std::size_t i, const Values& v, Prices& p) {
  p = {};
  const Contact& contact = m.contacts[i];
  const ContactValues& is = v.contacts[i];
  const double out = contact.out < 0 ? 0 : per_metre(m, v, contact.out, 0);
  const double in = contact.in < 0 ? 0 : per_metre(m, v, contact.in, 1);
  const double T_out = contact.out < 0 ? 0 : v.lines[contact.out].end_T[0];
  const double T_in = contact.in < 0 ? 0 : v.lines[contact.in].end_T[1];
  p.passed = out - in;
  p.rolled = -(T_out - T_in) * is.lambda;
  if (contact.load) return;
  if (contact.out >= 0) p.hung -= hangs_on_nothing(m.lines[contact.out], v.lines[contact.out]);
  if (contact.in >= 0) p.hung -= hangs_on_nothing(m.lines[contact.in], v.lines[contact.in]);
  if (contact.in >= 0 && contact.out >= 0) {
    const double lifted = v.lines[contact.out].touch[0].z() - v.lines[contact.in].touch[1].z();
    p.laid_at = -m.lines[contact.in].weight * lifted;
    return;
  }
  const std::size_t line = as_size(contact.in < 0 ? contact.out : contact.in);
  const double onto = contact.in < 0 ? -1 : 1, strain = is.lambda - 1;
  if (given_tension(m, contact, v, v.when)) {
    p.supplied = onto * (T_in + T_out) * (1 + end_strain(m, v, static_cast<int>(line), contact.in < 0 ? 0 : 1));
    p.passed += p.supplied;
  }
  p.laid_by = onto * m.lines[line].stiffness * strain * strain / 2;
  p.passed -= p.laid_by;
  // its weight lies on the drum at the height where it came onto it
  p.laid_at = onto * m.lines[line].weight * v.lines[line].touch[contact.in < 0 ? 0 : 1].z();
}

void add_contact(const Mechanism& m, std::size_t i, const Values& before, const Values& now, Ledger& ledger) {
  const Contact& contact = m.contacts[i];
  const Prices a = ledger.prices[i];
  Prices& b = ledger.prices[i];
  set_prices(m, i, now, b);
  const std::size_t end_line = as_size(contact.in >= 0 ? contact.in : contact.out);
  const bool drum = contact.in < 0 || contact.out < 0;
  // it winds in what is no more
  if (has_no_rope(contact, before.lines) || (drum && has_run_off(now.lines[end_line]))) return;
  const std::size_t c = as_size(contact.column);
  const double passed = contact.copies * (now.q[c] - before.q[c]) / 2;
  const double rolled = contact.copies * (now.contacts[i].rolled - before.contacts[i].rolled) / 2;
  if (contact.load) {
    const double work = passed * (a.passed + b.passed);
    now.contacts[i].holds ? ledger.slipped += work : ledger.supplied -= work;
    ledger.supplied -= rope_load_work(contact, before, now);  // what carries the place
    return;
  }
  const bool bearing = contact.spin < 0 && contact.efficiency > 0 && now.contacts[i].log_by_wrap == 0;
  (bearing ? ledger.bearings : ledger.slipped) += passed * (a.passed + b.passed) + rolled * (a.rolled + b.rolled);
  ledger.laid_by += passed * (a.laid_by + b.laid_by);
  ledger.laid_at += passed * (a.laid_at + b.laid_at);
  ledger.supplied += passed * (a.supplied + b.supplied);
  ledger.hung += passed * (a.hung + b.hung);
}

/// Work of the dampers of a line: where it is slack they do none.
double damped(const Mechanism& m, std::size_t i, const Values& before, const Values& now, bool at_end) {
  const Line& line = m.lines[i];
  const LineValues &b = now.lines[i], &a = at_end ? b : before.lines[i];
  if (sags(line, b)) {
    const auto power = [&](const Values& v) {
      const SagValues& is = v.sags[line.sag];
      return is.damper * is.chord_rate * v.lines[i].L;
    };
    return line.copies * (power(before) + power(now)) / 2 * (now.t - before.t);
  }
  const double more_a = a.T - elastic_tension(line, a), more_b = b.T - elastic_tension(line, b);
  return line.copies * (more_a * a.L + more_b * b.L) / 2 * (std::max(0.0, b.e) - std::max(0.0, before.lines[i].e));
}

/// Strain energy that the fading of a breaking line takes; of a sagging one also what its weight falls. `at_end`: the
/// tension of the end does the step's work, so the strain before is the one that is lost with the stiffness.
double torn(const Mechanism& m, std::size_t i, const Values& values_before, const Values& values_now, bool at_end) {
  const Line& line = m.lines[i];
  const LineValues &before = values_before.lines[i], &now = values_now.lines[i];
  if (line.sag >= 0) {
    const auto held = [&](const Values& v) {
      const SagEnergy energy = sag_energy(line, v.lines[i], v.sags[line.sag]);
      return energy.elastic + energy.below;
    };
    const double after = sags(line, now) ? held(values_now) : held(values_before);
    return line.copies * (before.gone - now.gone) * (at_end ? held(values_before) : (held(values_before) + after) / 2);
  }
  const auto square = [&](const LineValues& v) {
    const double e = std::max(0.0, path_of(line, v) / v.L - 1);  // of what is left at last, too
    return e * e * v.L;
  };
  const double mean = at_end ? square(before) : (square(before) + square(now)) / 2;
  return line.copies * line.stiffness * (before.gone - now.gone) * mean / 2;
}

/// Velocities of a body's origin and about it, or its ways in a step, m, rad.
struct Moves {
  Vector3 along, about;
};

bool is_driven(const Mechanism& m, std::size_t b) {
  return m.bodies[b].model >= 0 && !m.model->bodies[m.bodies[b].model].driven.empty();
}

/// What ropes and couples give a body that goes so, W, or J over ways. `share_of`: of a line, in which it pulls.
template <class Share>
double given_to_body(const Mechanism& m, std::size_t b, const Values& v, const Moves& by, const Share& share_of) {
  const Motion3& body = v.bodies[b];
  double given = power_of_couples(m, static_cast<int>(b), v, by.along, by.about);
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = v.lines[i];
    for (std::size_t end = 0; end < 2; ++end) {
      if (line.body[end] != static_cast<int>(b)) continue;
      const Vector3 moves = by.along + by.about.cross(is.touch[end] - body.x);
      const Vector3 force = sags(line, is) ? sagging_force(line, is, v.sags[line.sag], end)
                            : line.part    ? part_force(line, is, end)
                                           : Vector3((end == 0 ? 1 : -1) * share_of(i) * body_pull(is, end) * is.t -
                                                     line.weight * free_rope(is) / 2 * up());
      given += line.copies * (force + force_along(m, i, end, v)).dot(moves);
    }
  }
  return given;
}

/// Bodies that signals move: their drives give what inertia and weights ask and ropes and couples do not.
double power_of_driven(const Mechanism& m, const Values& v) {
  double power = 0;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (!is_driven(m, b)) continue;
    const Motion3& body = v.bodies[b];
    power += inertia_power(m, static_cast<int>(b), v, body.driven_v, body.driven_w) -
             given_to_body(m, b, v, {body.driven_v, body.driven_w}, [](std::size_t) { return 1.0; });
  }
  return power;
}

/// The way of a body in a step that signals move it.
Moves driven_way(const Mechanism& m, std::size_t b, const Values& before, const Values& now) {
  const Body& shape = m.bodies[b];
  const Motion3 &was = before.bodies[b], &is = now.bodies[b];
  const Eigen::AngleAxisd turned(Matrix3(is.R * was.R.transpose()));
  Moves way{is.x - was.x, turned.angle() * turned.axis()};
  for (std::size_t f = 0; f < as_size(shape.count); ++f) {  // what its freedoms do is none of the drive's
    const double by = now.q[as_size(shape.first) + f] - before.q[as_size(shape.first) + f];
    way.along -= by * shape.along[f];
    way.about -= by * shape.about[f];
  }
  return way;
}

/// Rope that runs over a bend moving with v leaves it with more kinetic energy than it came with: G (t_out - t_in).v.
double power_of_running(const Mechanism& m, const Values& v) {
  double power = 0;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = v.lines[i];
    const bool sagging = sags(line, is);
    for (const std::size_t end : {0U, 1U}) {
      if (line.body[end] < 0 || line.part || (!sagging && is.thrust[end] == 0)) continue;
      const Motion3& body = v.bodies[line.body[end]];
      // a straight rope can't push: it lifts off
      const double G = sagging ? sagging_thrust(is, v.sags[line.sag], end) : is.T - body_pull(is, end);
      power += (end == 0 ? 1 : -1) * line.copies * G * is.t.dot(body.v + body.w.cross(is.touch[end] - body.x));
    }
  }
  return power;
}

void price(const Mechanism& m, const Values& v, Ledger& ledger) {
  ledger.prices.resize(m.contacts.size());
  for (std::size_t i = 0; i < m.contacts.size(); ++i) set_prices(m, i, v, ledger.prices[i]);
  ledger.last = powers(m, v);
}

/// Moment of the bearing against a spin whose turning is given: its drive overcomes it, N m.
double against(const SpinValues& is) { return is.omega == 0 ? 0 : std::copysign(is.capacity, is.omega); }

}  // namespace

double drive_moment(const Mechanism& m, int spin, const Values& v) {
  const Spin& of = m.spins[spin];
  if (!prescribed(m, of, v, v.when)) return drive_torque(m, of, v, v.when);
  const double bearing = against(v.spins[spin]);
  double alpha = v.spins[spin].alpha;
  if (of.body >= 0) alpha += (v.bodies[of.body].R * of.axis).dot(acceleration(m, of.body, v).second);
  return of.inertia * alpha + of.drag * v.spins[spin].omega + bearing - rope_moment(m, of, v, v);
}

Powers powers(const Mechanism& m, const Values& v) {
  Powers p;
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const SpinValues& is = v.spins[i];
    const bool set = prescribed(m, m.spins[i], v, v.when).has_value();
    p.bearings += ((set ? against(is) : is.turns * is.capacity) + m.spins[i].drag * is.omega) * is.omega;
    if (m.spins[i].drum < 0 && m.spins[i].motor < 0) continue;
    const bool light = m.spins[i].inertia <= 0 && !set;
    if (!light) p.supplied += drive_moment(m, static_cast<int>(i), v) * is.omega;
  }
  for (std::size_t k = 0; k < m.tensioner.size(); ++k) {
    const auto [line, end] = m.tensioner[k];
    p.supplied -= m.lines[line].copies * per_metre_let_in(m, v, line, as_size(end)) * v.tension_rate[k];
  }
  p.running = power_of_running(m, v) + power_along(m, v);
  return p;
}

namespace {

/// The kinetic energy of a body, and what its weight holds.
Stored stored_in_body(const Mechanism& m, std::size_t b, const Values& v) {
  Stored s;
  const Body& shape = m.bodies[b];
  const Motion3& is = v.bodies[b];
  if (shape.mass > 0) {
    const Vector3 velocity = is.v + is.w.cross(is.R * shape.centre);
    s.kinetic += shape.mass * velocity.squaredNorm() / 2;
  }
  if (shape.turns || is.w != Vector3::Zero()) {
    const Vector3 w = is.R.transpose() * is.w;
    s.kinetic += w.dot(shape.inertia * w) / 2;
  }
  if (shape.own_mass > 0) s.potential += shape.own_mass * m.model->gravity * (is.x + is.R * shape.own_centre).z();
  return s;
}

/// What the dead loads of the bodies that `counts` says hold, J.
template <class Counts>
double held_by_loads(const Mechanism& m, const Values& v, const Counts& counts) {
  double held = 0;
  for (const machine::Load& load : m.model->loads) {
    if (load.at.body < 0 || load.over_time || !counts(load.at.body)) continue;
    const Motion3& is = v.bodies[load.at.body];
    held -= load.force.dot(is.x + is.R * load.at.at);
  }
  return held;
}

/// What the drives of bodies that signals move give in a step: over their ways, as the strain of the ropes grows by
/// them; where nothing but the drive moves a body, its inertia and its weight ask what it holds more.
double work_of_driven(const Mechanism& m, const Values& before, const Values& now) {
  const auto share_taut = [&](std::size_t i) {
    const double was = before.lines[i].e, is = now.lines[i].e;
    return (was > 0) == (is > 0) ? 1.0 : std::max(was, is) / std::abs(is - was);
  };
  double work = 0;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (!is_driven(m, b)) continue;
    const Moves way = driven_way(m, b, before, now);
    for (const Values* v : {&before, &now}) {
      work -= given_to_body(m, b, *v, way, share_taut) / 2;
      const Motion3& body = v->bodies[b];
      if (m.bodies[b].count > 0)
        work += (now.t - before.t) / 2 * inertia_power(m, static_cast<int>(b), *v, body.driven_v, body.driven_w);
    }
    if (m.bodies[b].count > 0) continue;
    const auto of_it = [&](int body) { return body == static_cast<int>(b); };
    const Stored was = stored_in_body(m, b, before), is = stored_in_body(m, b, now);
    work += is.kinetic + is.potential - was.kinetic - was.potential;
    work += held_by_loads(m, now, of_it) - held_by_loads(m, before, of_it);
  }
  return work;
}

}  // namespace

Stored stored_in_bodies(const Mechanism& m, const Values& v) {
  Stored s;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    const Stored one = stored_in_body(m, b, v);
    s.kinetic += one.kinetic;
    s.potential += one.potential;
  }
  s.potential += held_by_loads(m, v, [](int) { return true; });
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const Spin& spin = m.spins[i];
    double omega = v.spins[i].omega;
    if (spin.body >= 0) omega += (v.bodies[spin.body].R * spin.axis).dot(v.bodies[spin.body].w);
    s.kinetic += spin.inertia * omega * omega / 2;
  }
  return s;
}

Stored stored(const Mechanism& m, const Values& v) {
  Stored s = stored_in_bodies(m, v);
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = v.lines[i];
    if (sags(line, is)) {
      const SagEnergy energy = sag_energy(line, is, v.sags[line.sag]);
      s.elastic += line.copies * is.gone * energy.elastic;
      s.potential += line.copies * is.gone * energy.below;
    } else {
      s.elastic += line.copies * elastic_tension(line, is) * std::max(0.0, is.e) * is.L / 2;
    }
    const double height = borne(line, is.l, 0) * is.touch[0].z() + borne(line, is.l, 1) * is.touch[1].z();
    s.potential += line.copies * line.weight * free_rope(is) * height;
  }
  s.elastic += energy_of_faces(m, v);
  return s;
}

Ledger open_ledger(const Mechanism& m, const Values& v) {
  Ledger ledger;
  ledger.start = ledger.now = stored(m, v);
  price(m, v, ledger);
  return ledger;
}

namespace {

void add_turnover(Ledger& ledger) {
  const double change = std::max({std::abs(ledger.now.kinetic - ledger.start.kinetic),
                                  std::abs(ledger.now.elastic - ledger.start.elastic),
                                  std::abs(ledger.now.potential - ledger.start.potential), std::abs(ledger.supplied),
                                  ledger.damped + ledger.slipped + ledger.bearings + ledger.broken + ledger.faces +
                                      std::abs(ledger.hung) + std::abs(ledger.askew) + ledger.numerical,
                                  ledger.now.elastic, ledger.now.kinetic});
  ledger.turnover = std::max(ledger.turnover, change);
}

/// All that goes by ways and not by time.
void add_ways(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger, bool at_end = false) {
  add_wound(m, before, now, ledger, at_end);
  for (std::size_t i = 0; i < m.contacts.size(); ++i) add_contact(m, i, before, now, ledger);
  const CoupleWork work = work_of_couples(m, before, now);
  ledger.faces += work.lost;
  ledger.supplied += work.supplied;
  const ChainLoadWork along = work_of_chain_loads(m, before, now);
  ledger.slipped += along.lost;
  ledger.supplied += along.supplied;
}

/// The ways of a step as if they had taken a second: for the mean of the powers at its start and at its end.
void move_in_a_second(const Mechanism& m, const Values& before, const Values& now, Values& v) {
  std::fill(v.rate.begin(), v.rate.end(), 0.0);
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    Motion3& moves = v.bodies[b];
    moves.w = moves.driven_a = moves.driven_b = moves.driven_v = moves.driven_w = Vector3::Zero();
    if (!m.bodies[b].driven) continue;
    const Moves way = driven_way(m, b, before, now);
    moves.driven_v = way.along;
    moves.driven_w = way.about;
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    v.spins[i].omega = now.spins[i].angle - before.spins[i].angle;
    v.spins[i].alpha = 0;
  }
  for (std::size_t k = 0; k < m.tensioner.size(); ++k) v.tension_rate[k] = now.tensioned[k] - before.tensioned[k];
}

/// Moment that a bearing holds or takes: all that its ropes and its drive ask of it, N m.
double bearing_moment(const Mechanism& m, std::size_t i, const Values& v) {
  if (v.spins[i].capacity <= 0) return 0;
  if (prescribed(m, m.spins[i], v, v.when)) return against(v.spins[i]);
  return drive_torque(m, m.spins[i], v, v.when) + rope_moment(m, m.spins[i], v, v);
}

}  // namespace

void add_step(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger, bool at_end) {
  if (at_end) price(m, now, ledger);
  const double half = (now.t - before.t) / 2;
  const Powers p = powers(m, now);
  const auto add = [&](double Powers::*what) { return half * (p.*what + ledger.last.*what); };
  ledger.bearings += add(&Powers::bearings);
  ledger.supplied += add(&Powers::supplied);
  ledger.running += add(&Powers::running);
  ledger.supplied += at_end ? 2 * half * power_of_driven(m, now) : work_of_driven(m, before, now);
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    if (m.lines[i].damping > 0) ledger.damped += damped(m, i, before, now, at_end);
    if (before.lines[i].gone != now.lines[i].gone) ledger.broken += torn(m, i, before, now, at_end);
  }
  add_ways(m, before, now, ledger, at_end);
  if (at_end) ledger.numerical += taken_by_euler(m, before, now);
  ledger.last = p;
  ledger.now = stored(m, now);
  add_turnover(ledger);
}

void add_slow_step(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger) {
  Values first = before, last = now;
  move_in_a_second(m, before, now, first);
  move_in_a_second(m, before, now, last);
  for (const Values* v : {&first, &last}) ledger.supplied += (powers(m, *v).supplied + power_of_driven(m, *v)) / 2;
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    ledger.bearings += last.spins[i].omega * (bearing_moment(m, i, first) + bearing_moment(m, i, last)) / 2;
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    if (before.lines[i].gone != now.lines[i].gone) ledger.broken += torn(m, i, before, now, false);
  }
  add_ways(m, before, now, ledger);
  ledger.now = stored(m, now);
  ledger.now.kinetic = 0;
  add_turnover(ledger);
}

void add_fall(const Mechanism& m, const Values& before, const Values& now, double& where, Ledger& ledger) {
  const double residual = told(ledger).residual;
  add_slow_step(m, before, now, ledger);
  where -= told(ledger).residual - residual;
  add_turnover(ledger);
}

void add_jump(const Mechanism& m, const Values& now, double& where, Ledger& ledger) {
  const Stored s = stored(m, now);
  where += ledger.now.kinetic + ledger.now.elastic + ledger.now.potential - s.kinetic - s.elastic - s.potential;
  ledger.now = s;
  price(m, now, ledger);
}

EnergyLedger told(const Ledger& l) {
  EnergyLedger e;
  e.kinetic = l.now.kinetic + l.running;
  e.elastic = l.now.elastic + l.laid_by;
  e.potential = l.now.potential + l.laid_at;
  e.damped = l.damped;
  e.slipped = l.slipped;
  e.bearings = l.bearings;
  e.broken = l.broken;
  e.contacts = l.faces;
  e.slack = l.hung;
  e.flanges = l.askew;
  e.numerical = l.numerical;
  e.supplied = l.supplied;
  e.turnover = l.turnover;
  const double before = l.start.kinetic + l.start.elastic + l.start.potential;
  e.residual = e.kinetic + e.elastic + e.potential - before - l.supplied + e.dissipated();
  return e;
}

}  // namespace taut::solve::dynamics
