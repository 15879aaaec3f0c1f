#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/array.hpp"
#include "taut/math/fixed_angles.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/chain_load.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/run/run.hpp"

namespace taut::solve::dynamics {
namespace {

using machine::Observed;

constexpr int parts_of_curve = 16;  ///< of a sagging branch in a frame

ContactState state_of_contact(const Contact& contact, const ContactValues& v, const Pressure& p, double omega) {
  if (contact.round && v.wrap < 0) return ContactState::lifted;
  if (p.in <= 0 && p.out <= 0) return ContactState::lifted;
  if (v.grip == Grip::forward || v.grip == Grip::backward) {
    const bool turns = contact.spin < 0 && contact.efficiency > 0 && v.log_by_wrap == 0 && !contact.load;
    return turns ? ContactState::turning : ContactState::slipping;
  }
  if (v.grip == Grip::equal) return ContactState::turning;
  return contact.spin >= 0 && omega != 0 ? ContactState::turning : ContactState::stuck;
}

TransientFrame::Contact contact_of(const Mechanism& m, const Values& v, std::size_t i) {
  const Contact& contact = m.contacts[i];
  const ContactValues& is = v.contacts[i];
  const LineValues &in = v.lines[contact.in], &out = v.lines[contact.out];
  TransientFrame::Contact c;
  c.reeving = contact.reeving;
  c.node = contact.node;
  c.side = m.model->reevings[contact.reeving].nodes[contact.node].side;
  c.T_in = in.end_T[1];
  c.T_out = out.end_T[0];
  c.centrifugal = out.thrust[0];
  c.wrap = wrap_of(m, i, v);
  if (contact.spin >= 0) {
    c.angle = contact.sense * v.spins[contact.spin].angle;
    c.spin = contact.sense * v.spins[contact.spin].omega;
  } else if (contact.radius > 0 && contact.efficiency > 0) {
    c.angle = v.q[contact.column] * is.lambda / contact.radius;
    c.spin = is.flow * is.lambda / contact.radius;
  }
  c.flow = is.lambda * is.flow;
  const bool light = contact.spin < 0 && contact.efficiency > 0;
  c.slip = light && !contact.load ? 0 : is.lambda * (is.flow - is.roll_rate);
  c.state = state_of_contact(contact, is, pressure(contact, v), c.spin);
  c.force = std::max(0.0, c.T_out - out.thrust[0]) * direction(m, v, contact.out, 0) -
            std::max(0.0, c.T_in - in.thrust[1]) * direction(m, v, contact.in, 1);
  return c;
}

/// Whether the brake of a drum is set, and acts in full at t.
bool is_braked(const Mechanism& m, const Spin& spin, const Values& v, double t) {
  if (spin.drum < 0) return false;
  const machine::Drive& drive = v.drum_drive[spin.drum];
  const auto& brake = m.model->drums[spin.drum].brake;
  return drive.brake && brake && t >= drive.brake_since + brake->delay + brake->rise;
}

TransientFrame::Drum turning_of(const Mechanism& m, const Values& v, std::size_t spin) {
  const Spin& of = m.spins[spin];
  TransientFrame::Drum d;
  for (const auto& one : of.contacts) {
    const Contact& contact = m.contacts[one.first];
    const double T = std::max(contact.in < 0 ? 0 : v.lines[contact.in].end_T[1],
                              contact.out < 0 ? 0 : v.lines[contact.out].end_T[0]);
    d.T = std::max(d.T, T);
  }
  const Contact& first = m.contacts[of.contacts.front().first];
  const double radius = working_radius(m, first, v);
  const std::optional<Turning> turning = prescribed(m, of, v, v.when);
  d.held = turning && turning->omega == 0 && turning->alpha == 0 && v.drive(of).kind != machine::DriveKind::pull;
  d.braked = is_braked(m, of, v, v.when) && v.spins[spin].turns == 0;
  const machine::DriveKind drive = v.drive(of).kind;
  const bool gives_way = drive == machine::DriveKind::torque || (of.drum >= 0 && drive == machine::DriveKind::free);
  d.by_torque = (of.drum >= 0 || of.motor >= 0) && gives_way && !v.drive(of).brake;
  d.speed = v.spins[spin].omega * radius;
  if (given_tension(m, first, v, v.when)) {
    const ContactValues& contact = v.contacts[of.contacts.front().first];
    d.speed = first.sense * contact.flow * contact.lambda;
    d.torque = -rope_moment(m, of, v, v);
  } else {
    d.torque = drive_moment(m, static_cast<int>(spin), v);
  }
  d.power = d.torque * d.speed / radius;
  return d;
}

/// Largest and its branch, at the start, at the end.
double rope_tension(const Mechanism& m, const Values& v, int reeving, int* branch) {
  const auto [first, lines] = m.first_line[reeving];
  double largest = 0;
  for (int i = 0; i < lines; ++i) {
    const LineValues& line = v.lines[first + i];
    const double T = std::max(line.end_T[0], line.end_T[1]);
    if (T <= largest) continue;
    largest = T;
    if (branch != nullptr) *branch = i;
  }
  return largest;
}

int contact_at(const Mechanism& m, int reeving, int node) {
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (m.contacts[i].reeving == reeving && m.contacts[i].node == node) return static_cast<int>(i);
  }
  return -1;
}

int spin_of_drum(const Mechanism& m, int drum) {
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    if (m.spins[i].drum == drum) return static_cast<int>(i);
  }
  return -1;
}

/// How far freedoms and drives have turned a body about a fixed axis since the start, beyond whole turns too, rad.
double counted_turn(const Run& run, const Values& v, int index, int axis) {
  if (index < 0) return 0;
  const Body& body = run.m.bodies[index];
  double turn = 0;
  for (int f = 0; body.turns && f < body.count; ++f) turn += v.q[body.first + f] * body.about[as_size(f)][axis];
  if (!body.driven) return turn;
  for (const machine::DrivenWay& way : run.model.bodies[body.model].driven) {
    if (way.about[axis] != 0) turn += machine::at(way.signal, v.when).value * way.about[axis];
  }
  return turn;
}

/// An angle about a fixed axis; of what turns about this one alone with its whole turns.
double angle_about(const Matrix3& R, int axis, double counted) {
  constexpr double whole = 2 * std::numbers::pi, same = 1e-12;
  const double angle = fixed_angles(R)[axis];
  return R(axis, axis) < 1 - same ? angle : angle + whole * std::round((counted - angle) / whole);
}

/// As one sees it who stands on another body, in that one's axes.
double observe_from(const Motion3& seat, const Motion3& body, const Vector3& arm, Observed what, double counted) {
  const Vector3 apart = body.x + arm - seat.x;
  const Vector3 rate = body.v + body.w.cross(arm) - seat.v - seat.w.cross(apart);
  const int k = static_cast<int>(what);
  switch (k / 3) {
    case static_cast<int>(Observed::x) / 3:
      return (seat.R.transpose() * apart)[k % 3];
    case static_cast<int>(Observed::vx) / 3:
      return (seat.R.transpose() * rate)[k % 3];
    case static_cast<int>(Observed::rx) / 3:
      return angle_about(seat.R.transpose() * body.R, k % 3, counted);
    default:
      return (seat.R.transpose() * (body.w - seat.w))[k % 3];
  }
}

/// The body of a place: that of a joint is its own.
int body_of(const Run& run, const machine::Observable& what) {
  if (!what.joint) return what.index;
  return run.m
      .lines[run.m.first_line[what.index].first + *what.part * run.model.reevings[what.index].segments + *what.joint]
      .body[0];
}

double observe_place(const Run& run, const Values& v, const machine::Observable& what) {
  const Vector3& origin = run.model.origin;
  Motion3 still;
  still.x = -origin;  // what is observed of the ground counts as the deck does
  const int index = body_of(run, what);
  const Motion3& body = index == machine::ground ? still : v.bodies[index];
  const Vector3 arm = body.R * what.at;
  const int k = static_cast<int>(what.quantity);
  const auto counted = [&](int of) { return counted_turn(run, v, of, k % 3); };
  if (what.seen_from != machine::ground) {
    const double turn = k / 3 == static_cast<int>(Observed::rx) / 3 ? counted(index) - counted(what.seen_from) : 0;
    return observe_from(v.bodies[what.seen_from], body, arm, what.quantity, turn);
  }
  const auto in = [&](Observed first) { return k >= static_cast<int>(first) && k < static_cast<int>(first) + 3; };
  const auto axis = [&](Observed first) { return k - static_cast<int>(first); };
  if (in(Observed::x)) return (body.x + arm + origin)[axis(Observed::x)];
  if (in(Observed::vx)) return (body.v + body.w.cross(arm))[axis(Observed::vx)];
  if (in(Observed::rx)) return angle_about(body.R, axis(Observed::rx), counted(index));
  return body.w[axis(Observed::wx)];
}

double observe_rope(const Run& run, const Values& v, const machine::Observable& what) {
  const auto [first, lines] = run.m.first_line[what.index];
  const int pieces = std::max(1, run.model.reevings[what.index].segments);
  double T = 0, L = 0;
  switch (what.quantity) {
    case Observed::T_start:
      return v.lines[first].end_T[0];
    case Observed::T_end:
      return v.lines[first + lines - 1].end_T[1];
    case Observed::T_max:
      return rope_tension(run.m, v, what.index, nullptr);
    case Observed::length:
      for (int i = first; i < first + lines; ++i) L += free_rope(v.lines[i]);
      return L;
    default:
      for (int i = first + *what.part * pieces; i < first + (*what.part + 1) * pieces; ++i) {
        T = std::max({T, v.lines[i].end_T[0], v.lines[i].end_T[1]});
        L += free_rope(v.lines[i]);
      }
      return what.quantity == Observed::branch_T ? T : L;
  }
}

double observe_sheave(const Run& run, const Values& v, const machine::Observable& what) {
  for (std::size_t k = 0; k < run.m.chain_loads.size(); ++k) {
    const Contact& load = run.m.chain_loads[k].as;
    if (load.reeving != what.index || load.node != what.part) continue;
    const TransientFrame::Contact c = chain_load_frame(run.m, v, k);
    return what.quantity == Observed::T_in ? c.T_in : what.quantity == Observed::T_out ? c.T_out : c.slip;
  }
  const int i = contact_at(run.m, what.index, *what.part);
  if (i < 0 || run.m.contacts[i].in < 0 || run.m.contacts[i].out < 0) return 0;
  const int spin = run.m.contacts[i].spin;
  const double moment = spin >= 0 && run.m.spins[spin].motor >= 0 ? drive_moment(run.m, spin, v) : 0;
  const TransientFrame::Contact c = contact_of(run.m, v, as_size(i));
  switch (what.quantity) {
    case Observed::T_in:
      return c.T_in;
    case Observed::T_out:
      return c.T_out;
    case Observed::sheave_speed:
      return c.spin * run.m.contacts[i].radius;
    case Observed::sheave_omega:
      return c.spin;
    case Observed::sheave_angle:
      return c.angle;
    case Observed::sheave_torque:
      return run.m.contacts[i].sense * moment;
    case Observed::sheave_power:
      return spin < 0 ? 0 : moment * v.spins[spin].omega;
    default:
      return c.slip;
  }
}

double observe_drum(const Run& run, const Values& v, const machine::Observable& what) {
  const int spin = spin_of_drum(run.m, what.index);
  if (spin < 0) return 0;
  if (what.quantity == Observed::drum_length) {
    return content_at(run, run.m.contacts[run.m.spins[spin].contacts.front().first], v);
  }
  const TransientFrame::Drum d = turning_of(run.m, v, as_size(spin));
  switch (what.quantity) {
    case Observed::drum_T:
      return d.T;
    case Observed::drum_speed:
      return d.speed;
    case Observed::drum_torque:
      return d.torque;
    default:
      return d.power;
  }
}

/// The ledger with the step to `v`, which is tried, or is the step's start.
Ledger ledger_at(const Run& run, const Values& v) {
  Ledger ledger = run.ledger;
  if (!(v.t > run.before.t)) return ledger;
  run.options.quasi_static ? add_slow_step(run.m, run.before, v, ledger) : add_step(run.m, run.before, v, ledger);
  return ledger;
}

double observe_energy(const Run& run, const Values& v, Observed what) {
  const EnergyLedger e = told(ledger_at(run, v));
  switch (what) {
    case Observed::kinetic:
      return e.kinetic;
    case Observed::elastic:
      return e.elastic;
    case Observed::potential:
      return e.potential;
    case Observed::dissipated:
      return e.dissipated();
    case Observed::supplied:
      return e.supplied;
    default:
      return e.residual;
  }
}

}  // namespace

double observe_as_it_is(const Run& run, const Values& v, const machine::Observable& what) {
  if (what.quantity <= Observed::wz) return observe_place(run, v, what);
  if (what.quantity <= Observed::length) return observe_rope(run, v, what);
  if (what.quantity <= Observed::slip) return observe_sheave(run, v, what);
  if (what.quantity <= Observed::drum_power) return observe_drum(run, v, what);
  if (what.quantity == Observed::signal) return machine::at(run.model.signals[what.index], v.t).value;
  if (what.quantity >= Observed::kinetic) return observe_energy(run, v, what.quantity);
  return observe_couple(run.m, v, what);
}

namespace {

double uncounted_speed(const Mechanism& m, const Values& v, std::size_t i, std::size_t end) {
  const Line& line = m.lines[i];
  if (line.contact[end] < 0) return 0;
  const ContactValues& contact = v.contacts[line.contact[end]];
  const bool in_full = line.rim[end] ? v.lines[i].surge_share[end] == 1 : line.along[end];
  if (!in_full) return contact.flow * contact.lambda;
  return line.rim[end] ? contact.slip_rate * contact.lambda : 0;
}

}  // namespace

TransientFrame frame_of(const Mechanism& m, const Values& v) {
  TransientFrame f;
  f.t = v.t;
  const Vector3& origin = m.model->origin;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].model < 0) continue;
    const Motion3& is = v.bodies[b];
    f.bodies.push_back({is.x + origin, is.v, acceleration(m, static_cast<int>(b), v).first, is.R, is.w});
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = v.lines[i];
    const double l = length_of(line, is.l);
    const Vector3 start =
        line.at_load[0] ? Vector3(is.touch[0] + (line.ahead * is.l + line.ahead_more) * is.t) : is.touch[0];
    const Vector3 end = line.at_load[1] ? Vector3(start + l * is.t) : is.touch[1];
    f.branches.push_back({line.reeving,
                          line.from,
                          line.to,
                          is.end_T[0],
                          is.end_T[1],
                          free_rope(is),
                          l,
                          start + origin,
                          end + origin,
                          is.t,
                          is.t,
                          is.gone > 0,
                          {uncounted_speed(m, v, i, 0), uncounted_speed(m, v, i, 1)},
                          {}});
    if (!sags(line, is)) continue;
    const SagValues& shape = v.sags[line.sag];
    f.branches.back().stretched = sag_stretched(line, is, shape);
    f.branches.back().leaves = shape.direction[0];
    f.branches.back().arrives = shape.direction[1];
    f.branches.back().curve = sag_curve(line, is, shape, parts_of_curve);
    for (Vector3& point : f.branches.back().curve) point += origin;
  }
  for (const auto& inside : m.inside) {
    f.inside.emplace_back();
    for (const int body : inside) f.inside.back().push_back(v.bodies[body].x + origin);
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (m.contacts[i].in >= 0 && m.contacts[i].out >= 0) f.contacts.push_back(contact_of(m, v, i));
  }
  for (std::size_t i = 0; i < m.chain_loads.size(); ++i) f.contacts.push_back(chain_load_frame(m, v, i));
  for (const Contact& contact : m.contacts) {
    if (contact.drum < 0) continue;
    const OnDrumValues& end = v.on_drums[contact.on_drum];
    f.on_drums.push_back({contact.reeving, contact.drum, contact.in >= 0, end.content, end.layer});
  }
  f.drums.resize(m.model->drums.size());
  f.motors.resize(m.model->motors.size());
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const Spin& spin = m.spins[i];
    if (spin.drum >= 0) {
      f.drums[spin.drum] = turning_of(m, v, i);
    } else if (spin.motor >= 0) {
      f.motors[spin.motor] = turning_of(m, v, i);
    }
  }
  f.faces.reserve(v.faces.size());
  for (std::size_t i = 0; i < v.faces.size(); ++i) f.faces.push_back(face_frame(m, v, i));
  f.actuators = actuator_frames(v);
  return f;
}

void record_frame(Run& run, const Values& v) {
  TransientResult& result = run.result;
  result.frames.push_back(frame_of(run.m, v));
  result.frames.back().energy = told(run.ledger);
  const double lacks = std::abs(result.frames.back().energy.residual);
  if (!(lacks <= run.lacks)) {
    run.lacks = lacks;
    result.t_open = v.t;
  }
  for (std::size_t i = 0; i < run.model.observed.size(); ++i) {
    result.observed[i].push_back(observe(run, v, run.model.observed[i]));
  }
  run.shown = v.t;
  for (Run::Watched& one : run.watched) one.low = one.high = one.shown = one.now;
  if (!run.options.take) return;
  run.options.take(result);
  if (result.frames.size() <= 2) return;
  result.frames.erase(result.frames.begin() + 1);
  for (Array<double>& values : result.observed) values.erase(values.begin() + 1);
}

bool is_broken(const Mechanism& m, const Values& v, std::size_t reeving) {
  const auto [first, lines] = m.first_line[reeving];
  const auto from = v.lines.begin() + first;
  return std::any_of(from, from + lines, [](const LineValues& line) { return line.gone < 1; });
}

namespace {

/// What may turn between output steps: the largest tensions of ropes, those at the ends of their branches, where the
/// others of a rope may hide their peaks, and loads over time.
void watch(Run& run, const Values& v, bool first) {
  if (!run.options.moment) return;
  std::size_t i = 0;
  const auto see = [&](double value, double largest) {
    if (i == run.watched.size()) run.watched.emplace_back();
    Run::Watched& one = run.watched[i++];
    one.last = first ? value : one.now;
    one.now = value;
    one.largest = largest;
  };
  for (std::size_t r = 0; r < run.model.reevings.size(); ++r) {
    const auto [begin, lines] = run.m.first_line[r];
    const int pieces = std::max(1, run.model.reevings[r].segments);
    see(run.result.ropes[r].T.end, run.T_largest[r]);
    for (int k = begin; k + pieces <= begin + lines; k += pieces) {
      see(v.lines[k].end_T[0], run.T_largest[r]);
      see(v.lines[k + pieces - 1].end_T[1], run.T_largest[r]);
    }
  }
  for (const machine::Load& load : run.model.loads) {
    if (!load.over_time) continue;
    const double value = machine::at(*load.over_time, v.when).value;
    const double before = i < run.watched.size() ? run.watched[i].largest : 0;
    see(value, std::max(before, std::abs(value)));
  }
}

}  // namespace

void keep_least(double least, double loosest, double t, RopeExtreme& of) {
  if (least < of.T.min) {
    of.T.min = least;
    of.T.t_min = t;
  }
  if (loosest < of.T_loosest) {
    of.T_loosest = loosest;
    of.t_loosest = t;
  }
}

namespace {

/// The least tension anywhere in a rope: one that sags has it at its lowest point.
double least_tension(const Mechanism& m, const Values& v, std::size_t reeving) {
  const auto [first, lines] = m.first_line[reeving];
  double least = std::numeric_limits<double>::infinity();
  for (int i = first; i < first + lines; ++i) {
    const LineValues& is = v.lines[i];
    least = std::min({least, is.end_T[0], is.end_T[1]});
    if (!sags(m.lines[i], is)) continue;
    const SagValues& shape = v.sags[m.lines[i].sag];
    least = std::min(least, is.gone * shape.lowest + shape.damper);
  }
  return least;
}

/// The least mean of the tensions at the ends of one of its branches.
double loosest_tension(const Mechanism& m, const Values& v, std::size_t reeving) {
  const auto [first, lines] = m.first_line[reeving];
  const int pieces = std::max(1, m.model->reevings[reeving].segments);
  double least = std::numeric_limits<double>::infinity();
  for (int i = first; i + pieces <= first + lines; i += pieces) {
    least = std::min(least, (v.lines[i].end_T[0] + v.lines[i + pieces - 1].end_T[1]) / 2);
  }
  return least;
}

}  // namespace

void record_extremes(Run& run, const Values& v) {
  const bool first = run.result.steps == 0;
  measure(run, v);
  for (std::size_t r = 0; r < run.model.reevings.size(); ++r) {
    RopeExtreme& of = run.result.ropes[r];
    int branch = 0;
    const double T = rope_tension(run.m, v, static_cast<int>(r), &branch);
    if (first || T > of.T.max) of.branch = branch;
    const Extreme before = of.T;
    extend(of.T, T, v.t, first);
    of.T.min = before.min;
    of.T.t_min = before.t_min;
    if (first) of.T.min = of.T_loosest = std::numeric_limits<double>::infinity();
    if (first || !is_broken(run.m, v, r)) {
      keep_least(least_tension(run.m, v, r), loosest_tension(run.m, v, r), v.t, of);
    }
    if (first) of.T_static = run.options.from ? run.options.from->ropes[r].T_static : T;
    run.T_largest[r] = std::max(run.T_largest[r], T);
  }
  watch(run, v, first);
}

namespace {

void add_brake_ways(Run& run) {
  run.result.brake_ways.resize(run.model.drums.size());
  for (std::size_t i = 0; i < run.m.spins.size(); ++i) {
    const Spin& spin = run.m.spins[i];
    if (spin.drum < 0) continue;
    BrakeWay& of = run.result.brake_ways[spin.drum];
    if (!is_braked(run.m, spin, run.now, run.before.t)) {
      if (of.acts && !of.stood && !of.let_go) of.let_go = run.before.t;
      of.acts = of.stood = false;
      continue;
    }
    of.acted = of.acts = true;
    const double speed =
        std::abs(run.now.spins[i].omega) * working_radius(run.m, run.m.contacts[spin.contacts.front().first], run.now);
    if (!of.let_go) of.speed = speed;
    const bool sticks = run.now.spins[i].turns == 0;
    of.stood = of.stood || sticks;
    if (!of.stood || sticks) continue;
    if (of.way == 0) of.since = run.before.t;
    of.way += run.scheme.h * speed;
  }
}

}  // namespace

void add_ways(Run& run) {
  add_brake_ways(run);
  const double half = run.scheme.h / 2;
  std::size_t k = 0;
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    const Contact& contact = run.m.contacts[i];
    if (contact.in < 0 || contact.out < 0) continue;
    if (k == run.result.ways.size()) run.result.ways.emplace_back();
    ContactWays& ways = run.result.ways[k++];
    const bool light = contact.spin < 0 && contact.efficiency > 0;
    if (light && !contact.load) continue;  // it goes with the rope
    for (const Values* v : {&run.before, &run.now}) {
      const ContactValues& is = v->contacts[i];
      ways.slipped += half * is.lambda * std::abs(is.flow - is.roll_rate);
      if (contact.spin >= 0) ways.rim += half * contact.radius * std::abs(v->spins[contact.spin].omega);
    }
  }
}

void show_moment(Run& run, const Values& before, const Values& now) {
  constexpr double close = 1e-2;  // a sum of forces peaks by no more beside a moment, and where it is smooth by less
  if (!run.options.moment) return;
  const auto turned = [](const Run::Watched& one) {
    return (one.last > one.now && one.last > one.high) || (one.last < one.now && one.last < one.low);
  };
  const auto differs = [](const Run::Watched& one) { return std::abs(one.now - one.shown) > close * one.largest; };
  const auto show = [&run](const Values& v, double Run::Watched::*then) {
    for (Run::Watched& one : run.watched) {
      one.low = std::min(one.low, one.*then);
      one.high = std::max(one.high, one.*then);
      one.shown = one.*then;
    }
    run.shown = v.t;
    run.options.moment(run.result, frame_of(run.m, v));
  };
  const bool turns = std::any_of(run.watched.begin(), run.watched.end(), turned);
  const bool touches = !std::equal(before.faces.begin(), before.faces.end(), now.faces.begin(), now.faces.end(),
                                   [](const FaceValues& a, const FaceValues& b) { return a.closed == b.closed; });
  if (turns) show(before, &Run::Watched::last);
  const bool changes = run.options.closely && std::any_of(run.watched.begin(), run.watched.end(), differs);
  const bool late = !turns && now.t - run.shown >= run.options.moment_step;
  if (touches || changes || late) show(now, &Run::Watched::now);
}

}  // namespace taut::solve::dynamics
