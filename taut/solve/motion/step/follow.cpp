#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/bend.hpp"
#include "taut/solve/motion/parts/along.hpp"
#include "taut/solve/motion/parts/chain_load.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/parts/line.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"
#include "taut/solve/motion/parts/values.hpp"

namespace taut::solve::dynamics {
namespace {

/// Of the machine's first size and of its way: a branch with more rope is where an iteration has run away, to the loop
/// so deep that its weight alone makes the tension asked for.
constexpr double most_rope = 1000;

bool runs_away(const Mechanism& m, const LineValues& line) {
  return line.L > most_rope * std::max(m.size_of_machine, line.l);
}

constexpr double infinite = std::numeric_limits<double>::infinity();

Matrix3 turned_by(const Vector3& rotation) {
  const double angle = rotation.norm();
  if (angle == 0) return Matrix3::Identity();
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

/// Place, velocity and acceleration that signals give a body, and its orientation by them.
void drive_body(const machine::Body& shape, double t, Vector3& shift, Matrix3& turn, Motion3& now) {
  shift.setZero();
  turn.setIdentity();
  now.driven_v = now.driven_w = now.driven_a = now.driven_b = Vector3::Zero();
  for (const machine::DrivenWay& way : shape.driven) {
    const machine::SignalValue s = machine::at(way.signal, t);
    shift += s.value * way.along;
    now.driven_v += s.rate * way.along;
    now.driven_a += s.acceleration * way.along;
    if (way.about == Vector3::Zero()) continue;
    const Matrix3 by = Eigen::AngleAxisd(s.value, way.about).toRotationMatrix();
    turn = by * turn;
    // what was turned before is carried along
    const Vector3 w = by * now.driven_w;
    now.driven_b = by * now.driven_b + s.acceleration * way.about + s.rate * way.about.cross(w);
    now.driven_w = w + s.rate * way.about;
  }
}

void move_body(const Mechanism& m, const Values& before, std::size_t b, double t, Values& now) {
  const Body& shape = m.bodies[b];
  const Motion3& was = before.bodies[b];
  Motion3& is = now.bodies[b];
  if (shape.point && !shape.driven) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t c = as_size(shape.first + k);
      is.x[k] = was.x[k] + (now.q[c] - before.q[c]);
      is.v[k] = now.nu[c];
    }
    return;
  }
  Vector3 shift = Vector3::Zero(), turn = Vector3::Zero();
  is.v = is.w = Vector3::Zero();
  for (std::size_t f = 0; f < as_size(shape.count); ++f) {
    const std::size_t c = as_size(shape.first) + f;
    const double by = now.q[c] - before.q[c];
    shift += by * shape.along[f];
    is.v += now.nu[c] * shape.along[f];
    if (!shape.turns) continue;
    turn += by * shape.about[f];
    is.w += now.nu[c] * shape.about[f];
  }
  if (!shape.driven) {
    is.x = was.x + shift;
    is.turned = turn;
    if (shape.turns) is.R = turned_by(turn) * was.R;
    return;
  }
  const machine::Body& given = m.model->bodies[shape.model];
  Vector3 shift_before, shift_now;
  Matrix3 turn_before, turn_now;
  drive_body(given, before.when, shift_before, turn_before, is);
  drive_body(given, t, shift_now, turn_now, is);
  const Eigen::AngleAxisd carried(Matrix3(turn_now * turn_before.transpose()));
  is.x = was.x + shift + shift_now - shift_before;
  is.turned = turn + carried.angle() * carried.axis();
  is.R = turned_by(turn) * carried.toRotationMatrix() * was.R;
  is.v += is.driven_v;
  is.w += is.driven_w;
}

/// Velocities and accelerations of a body that moves without inertia.
void stop(Motion3& body) {
  for (Vector3* of : {&body.v, &body.w, &body.driven_v, &body.driven_w, &body.driven_a, &body.driven_b}) of->setZero();
}

void turn_spins(const Mechanism& m, const Scheme& s, const Values& before, double t, Values& now) {
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const Spin& spin = m.spins[i];
    SpinValues& is = now.spins[i];
    const std::size_t c = as_size(spin.column);
    if (const auto set = prescribed(m, spin, before, t)) {
      now.rate[c] = s.at_rest ? 0 : set->alpha;
      now.nu[c] = s.at_rest ? 0 : set->omega;
      now.q[c] = before.q[c] + s.h * (before.nu[c] + now.nu[c]) / 2;
      if (s.elapsed > 0) {  // the whole way of the step as what the freedoms' velocities are then
        const auto was = prescribed(m, spin, before, t - s.elapsed);
        now.nu[c] = s.elapsed * (set->omega + (was ? was->omega : 0)) / 2 / s.reach;
        now.q[c] = before.q[c] + s.reach * now.nu[c];
      }
    }
    is.angle = now.q[c];
    is.omega = now.nu[c];
    is.alpha = now.rate[c];
  }
}

// What follows is inlined where it stands in the innermost loops: the calls alone would be a tenth of a tackle's time.

/// Unstretched length and strain. The rope that the turning of a line lays on a drum lies there at its `winding`.
[[gnu::always_inline]] inline void stretch(const Mechanism& m, const Scheme& s, const Values& before, std::size_t i,
                                           Values& now) {
  const Line& line = m.lines[i];
  const LineValues& was = before.lines[i];
  LineValues& is = now.lines[i];
  double L = was.L;
  const bool sagging = sags(line, is), off = has_run_off(was);
  for (std::size_t end = 0; end < 2; ++end) {
    if (line.contact[end] < 0) continue;
    const std::size_t k = as_size(line.contact[end]), c = as_size(m.contacts[k].column);
    const bool none = (s.only_rates && slips_later(m, s, m.contacts[k])) || has_no_rope(m.contacts[k], before.lines);
    double out = none ? 0 : now.q[c] - before.q[c];
    if (!sagging && !off && winds(line, is, end))
      out -= is.radius[end] / before.contacts[k].winding * (is.angle[end] - was.angle[end]);
    L += end == 0 ? out : -out;
  }
  for (std::size_t k = 0; line.tensioned && k < m.tensioner.size(); ++k) {
    if (m.tensioner[k].first == static_cast<int>(i)) L += now.tensioned[k] - before.tensioned[k];
  }
  is.L = L;
  is.hung = 0;
  if (sagging) {
    const std::size_t k = as_size(line.sag);
    is.arc = was.arc;
    if (!hang(line, now.bodies, windings_of(line, before), before.sags[k], is.L, was.angle, is, now.sags[k]))
      is.L = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  lay_on_rounds(line, was, is);
  if (is.gone > 0) {
    is.e = path_of(line, is) / L - 1;
    return;
  }
  if (off) is.L = L = std::max(L, was.L);                       // a drum may go on to wind in what is no more
  is.e = L > 0 ? std::min(0.0, path_of(line, is) / L - 1) : 0;  // nothing holds a dead end: it has no stretch
}

/// The angle by which a rope is pressed on its groove: all of its turning, out of the plane of a round too. (Its
/// derivative counts as that of the wrap: the ways out of the plane change it little.)
double pressed_by(const Mechanism& m, const Contact& contact, const Values& now, double wrap) {
  const double along = std::max(0.0, wrap);
  if (contact.driven) return std::min(along, contact.working_arc);
  if (!contact.round) return along;
  const Line& line = m.lines[contact.in];
  const Vector3 n = line.side[1] * to_ground(now.bodies, line.body[1], line.axis[1]);
  const Vector3 &in = direction(m, now, contact.in, 1), &out = direction(m, now, contact.out, 0);
  return mechanics::turning(n, in, out, {.value = wrap}).value;
}

/// Angle of the arc, and what its law allows.
void bound(const Mechanism& m, const Scheme& s, const Values& before, std::size_t i, Values& now) {
  const Contact& contact = m.contacts[i];
  ContactValues& is = now.contacts[i];
  is.log_ratio = is.log_by_wrap = 0;
  is.ratio = 1;
  if (contact.in < 0 || contact.out < 0) return;
  const std::size_t in = as_size(contact.in), out = as_size(contact.out);
  const bool everywhere = std::isinf(contact.friction);
  if (contact.round) {
    is.wrap = before.contacts[i].wrap + now.lines[out].angle[0] - before.lines[out].angle[0] - now.lines[in].angle[1] +
              before.lines[in].angle[1];
  } else if (!everywhere) {
    is.wrap = wrap_of(m, i, now);
  }
  if (contact.load) {
    const RopeLoadStep load = rope_load(m, contact, now.when, before.contacts[i].flow, s.lossless);
    is.drop = load.drop;
    is.holds = load.holds;
    return;
  }
  if (s.lossless) {
    // a rope over a driven sheave would run round, or off its load, by itself
    const machine::Node& node = m.model->reevings[contact.reeving].nodes[contact.node];
    const bool held = node.kind == machine::NodeKind::drive || node.tension_drop;
    if (held && contact.spin >= 0) is.log_ratio = infinite;
    return;
  }
  const double grip = everywhere ? infinite : contact.friction * pressed_by(m, contact, now, is.wrap);
  if (contact.bearing_log <= grip) {
    is.log_ratio = contact.bearing_log;
    is.ratio = contact.bearing_ratio;
  } else {
    is.log_ratio = grip;
    is.ratio = std::exp(grip);
    if (is.wrap > 0 && is.wrap < contact.working_arc) is.log_by_wrap = contact.friction;
  }
  if (s.losses == 1 || std::isinf(is.log_ratio)) return;
  is.log_ratio *= s.losses;
  is.log_by_wrap *= s.losses;
  is.ratio = std::exp(is.log_ratio);
}

[[gnu::always_inline]] inline void flow(const Mechanism& m, const Scheme& s, const Values& before, const Work& w,
                                        std::size_t i, Values& now) {
  const Contact& contact = m.contacts[i];
  const ContactValues& was = before.contacts[i];
  ContactValues& is = now.contacts[i];
  const std::size_t c = as_size(contact.column);
  is.entry = was.entry;
  is.lambda = is.entry >= 0 ? 1 + std::max(0.0, entry_strain(m, now, contact, is.entry)) : was.lambda;
  is.roll_rate = 0;
  if (contact.spin >= 0) {
    is.roll_rate = contact.sense * now.spins[contact.spin].omega * working_radius(m, contact, before) / is.lambda;
  }
  now.nu[c] = is.roll_rate;
  now.rate[c] = 0;
  if (is.grip == Grip::stuck) {
    is.slipped = was.slipped;
    is.rolled = now.q[c] - is.slipped;
    is.slip_rate = 0;
    is.flow = s.reach > 0 ? (is.rolled - w.q_star[c]) / s.reach : is.roll_rate;
    return;
  }
  is.rolled = w.q_star[c] + s.reach * is.roll_rate;
  is.slipped = now.q[c] - is.rolled;
  const double slips = is.slipped - was.slipped;
  if (s.h == 0) {
    is.slip_rate = slips_in_a_moment(m, s, contact) ? s.slip_now * slips : was.slip_mean;
  } else {
    is.slip_rate = s.slip_now * slips + s.slip_before * was.slip_mean;
  }
  is.flow = is.roll_rate + is.slip_rate;
}

/// The flow that counts for the thrust of the rope. In very short steps a rate is noise over nothing: it would
/// drive the tensions, and they the rate. So it follows within the time in which that can't grow.
void steady_flow(const Mechanism& m, const Scheme& s, const Values& before, std::size_t i, Values& now) {
  constexpr double calm = 20, least_speed = 1, growth = 2;
  const Contact& contact = m.contacts[i];
  const ContactValues& was = before.contacts[i];
  ContactValues& is = now.contacts[i];
  double stiffness = 0;
  for (const int line : {contact.in, contact.out}) {
    if (line >= 0) stiffness += m.lines[line].stiffness / before.lines[line].L;
  }
  const double time = calm * contact.mass * std::max(least_speed, std::abs(was.steady)) / stiffness;
  // and within a step only as far as rims and loads may take it: loose rope that finds its place has no momentum
  const double most = growth * std::abs(was.steady) + least_speed;
  is.steady = was.steady + s.h / (s.h + time) * (std::clamp(is.flow, -most, most) - was.steady);
}

/// Velocity of the rope's touching points, fixed to their bodies, apart. Coordinate by coordinate: in chains and
/// tackles this is what is done most often of all.
[[gnu::always_inline]] inline void set_apart(const Line& line, const Array<Motion3>& bodies, LineValues& is) {
  double x = 0, y = 0, z = 0;
  for (std::size_t end = 0; end < 2; ++end) {
    if (line.body[end] < 0) continue;
    const Motion3& body = bodies[line.body[end]];
    const double sign = end == 1 ? 1 : -1;
    x += sign * body.v[0];
    y += sign * body.v[1];
    z += sign * body.v[2];
    if (line.plain) continue;
    const Vector3 turning = body.w.cross(is.touch[end] - body.x);
    x += sign * turning[0];
    y += sign * turning[1];
    z += sign * turning[2];
  }
  is.apart[0] = x;
  is.apart[1] = y;
  is.apart[2] = z;
}

/// Rope that a contact lets into a line at its end, m/s; and what its momentum takes of the tension there.
[[gnu::always_inline]] inline double flow_at(const Mechanism& m, const Line& line, std::size_t end, const Values& now,
                                             LineValues& is) {
  if (line.contact[end] < 0) return 0;
  const ContactValues& contact = now.contacts[line.contact[end]];
  if (line.mass > 0) {
    const double mass = m.contacts[line.contact[end]].mass;
    is.thrust[end] = mass * contact.lambda * contact.steady * contact.steady;
  }
  return end == 0 ? contact.flow : -contact.flow;
}

[[gnu::always_inline]] inline void strain_rate(const Mechanism& m, const Scheme& s, const Values& before, std::size_t i,
                                               Values& now) {
  const Line& line = m.lines[i];
  LineValues& is = now.lines[i];
  is.e_rate = 0;
  // it matters for dampers, and for how the stretch of rope on rounds goes on
  const bool sagging = sags(line, is), runs = line.contact[0] >= 0 || line.contact[1] >= 0;
  const bool matters = line.damping > 0 || runs || sagging;
  if (sagging) now.sags[line.sag].chord_rate = 0;
  if (!s.at_rest && matters) {
    double flows = flow_at(m, line, 0, now, is) + flow_at(m, line, 1, now, is);
    for (std::size_t k = 0; line.tensioned && k < m.tensioner.size(); ++k) {
      if (m.tensioner[k].first == static_cast<int>(i)) flows += now.tension_rate[k];
    }
    set_apart(line, now.bodies, is);
    const double askew = line.damping > 0 && !sagging ? askew_rate(line, now.bodies, is) : 0;
    is.e_rate = (line.share * dot(is.t, is.apart) - (1 + is.e) * flows + askew) / is.L;
    if (line.part) is.e_rate += turned_strain_rate(line, now.bodies, before.contacts, is);
    if (is.gone == 0) is.e_rate = 0;
    if (sagging) now.sags[line.sag].chord_rate = (dot(is.t, is.apart) - is.l / is.hung * flows) / is.L;
  }
  if (sagging) {
    pull_sagging(line, line.damping, is, now.sags[line.sag]);
    return;
  }
  s.only_rates ? pull_without_bounds(line, line.damping, is) : pull(line, is);
  is.end_T[0] = is.end_T[1] = is.T;
  if (line.weight == 0) return;
  const double hangs = hung_at_ends(line.weight * free_rope(is) * is.t.z() / 2, is.T);
  if (bears_half(line, 0)) is.end_T[0] -= hangs;
  if (bears_half(line, 1)) is.end_T[1] += hangs;
}

}  // namespace

bool follow(const Mechanism& m, const Scheme& s, const Values& before, const Work& w, double t, Values& now) {
  now.t = t;
  const double h = s.creeps ? s.elapsed : s.h;
  now.when = h > 0 ? t - 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), h) : t;
  for (std::size_t c = 0; c < as_size(m.body_columns); ++c) {
    now.nu[c] = w.nu_star[c] + s.reach * now.rate[c];
    now.q[c] = w.q_star[c] + s.reach * now.nu[c];
  }
  for (const Spin& spin : m.spins) {
    const std::size_t c = as_size(spin.column);
    now.nu[c] = w.nu_star[c] + s.reach * now.rate[c];
    now.q[c] = w.q_star[c] + s.reach * now.nu[c];
  }
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    move_body(m, before, b, now.when, now);
    if (s.creeps) stop(now.bodies[b]);
  }
  turn_spins(m, s, before, now.when, now);
  for (std::size_t k = 0; k < m.tensioner.size(); ++k) {
    const machine::SignalValue change = machine::at(m.model->tensioners[k].change, now.when);
    now.tensioned[k] = change.value;
    now.tension_rate[k] = change.rate;
  }
  const std::size_t lines = m.lines.size(), contacts = m.contacts.size();
  for (std::size_t i = 0; i < lines; ++i) {
    const Line& line = m.lines[i];
    LineValues& is = now.lines[i];
    if (line.plain) {
      if (!follow_plain(m, i, now)) return false;
    } else {
      const bool placed = line.still && is.radius == before.lines[i].radius;
      if (!placed && !place_line(line, now.bodies, before.lines[i], is)) return false;
    }
    stretch(m, s, before, i, now);
    if (!(left_in(is) > 0) || !std::isfinite(is.l) || runs_away(m, is)) return false;
  }
  if (m.rope_loads) place_rope_loads(m, now);
  for (std::size_t i = 0; i < contacts; ++i) {
    bound(m, s, before, i, now);
    flow(m, s, before, w, i, now);
    if (m.contacts[i].mass != 0) steady_flow(m, s, before, i, now);
  }
  for (std::size_t i = 0; i < lines; ++i) {
    strain_rate(m, s, before, i, now);
    if (m.lines[i].has_along) add_surge(m, s, before, i, now);
  }
  if (!m.chain_loads.empty()) follow_chain_loads(m, s, before, now);
  follow_couples(m, s, before, now);
  return true;
}

double wrap_of(const Mechanism& m, std::size_t contact, const Values& v) {
  const Contact& of = m.contacts[contact];
  if (of.round || of.in < 0 || of.out < 0) return v.contacts[contact].wrap;
  const Vector3 &a = direction(m, v, of.in, 1), &b = direction(m, v, of.out, 0);
  const double wrap = std::atan2(a.cross(b).norm(), a.dot(b));
  return (b - a).dot(of.support) > 0 ? -wrap : wrap;
}

bool slips_in_a_moment(const Mechanism& m, const Scheme& s, const Contact& contact) {
  return s.slip_now > 0 && m.lines[contact.in >= 0 ? contact.in : contact.out].damping > 0;
}

bool slips_later(const Mechanism& m, const Scheme& s, const Contact& contact) {
  const auto hangs = [&](int line) { return line >= 0 && m.lines[line].sag >= 0; };
  return s.only_rates && !hangs(contact.in) && !hangs(contact.out) && slips_in_a_moment(m, s, contact);
}

std::pair<Vector3, Vector3> acceleration(const Mechanism& m, int body, const Values& now) {
  const Body& shape = m.bodies[body];
  Vector3 a = now.bodies[body].driven_a, b = now.bodies[body].driven_b;
  for (std::size_t f = 0; f < as_size(shape.count); ++f) {
    const double rate = now.rate[as_size(shape.first) + f];
    a += rate * shape.along[f];
    if (shape.turns) b += rate * shape.about[f];
  }
  return {a, b};
}

}  // namespace taut::solve::dynamics
