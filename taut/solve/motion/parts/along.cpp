#include "taut/solve/motion/parts/along.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/build.hpp"

namespace taut::solve::dynamics {
namespace {

/// +1 where a line arrives at its contact: the tension on the round is larger there by what accelerates the rope.
double sign_at(std::size_t end) { return end == 1 ? 1 : -1; }

/// Unstretched rope of a line times its mass, kg, at the start.
double mass_of(const Mechanism& m, const DynamicState& start, int line) {
  return m.lines[line].mass * lumped_length(m, start, line);
}

/// Whether the rope at a contact goes as a round with inertia or a drive does.
bool has_rim(const Contact& contact) {
  return contact.spin >= 0 && !contact.load && (contact.drum >= 0 || contact.friction > 0);
}

bool stands(const Mechanism& m, int body) { return body < 0 || (m.bodies[body].count == 0 && !m.bodies[body].driven); }

/// A round without inertia over which rope runs, or a load along the rope.
bool is_passed(const Contact& contact) {
  if (contact.spin >= 0 || contact.in < 0 || contact.out < 0) return false;
  return contact.load || contact.efficiency > 0 || std::isfinite(contact.friction);
}

/// The next line on the side `side` of a contact: 0 along the path.
int line_at(const Contact& contact, std::size_t side) { return side == 0 ? contact.out : contact.in; }

/// Goes from a rim along its rope over light rounds by which it runs as it does at the rim: of the same body, or on
/// bodies that stand, and past loads. What lies there: up to the next rim half of it.
Array<RopeShare> beyond(Mechanism& m, const Contact& from, std::size_t side) {
  const std::size_t far = 1 - side;
  Array<RopeShare> shares;
  for (int line = line_at(from, side); line >= 0;) {
    if (m.lines[line].contact[far] < 0) break;
    const Contact& next = m.contacts[m.lines[line].contact[far]];
    if (has_rim(next)) {
      for (RopeShare& one : shares) one.share /= 2;
      break;
    }
    const bool alike = next.load || next.body == from.body || (stands(m, next.body) && stands(m, from.body));
    if (!is_passed(next) || !alike) break;
    const int after = line_at(next, side);
    shares.push_back({line, 0.5});
    shares.push_back({after, 0.5});
    m.lines[line].along[far] = m.lines[after].along[side] = true;
    line = after;
  }
  return shares;
}

/// Whether the rope on a side of a contact does not run: it ends at an anchor, or beyond rounds that stand.
bool is_held(const Mechanism& m, const Contact& from, std::size_t side) {
  const std::size_t far = 1 - side;
  for (int line = line_at(from, side); line >= 0;) {
    if (m.lines[line].tensioned) return false;
    if (m.lines[line].contact[far] < 0) return stands(m, m.lines[line].body[far]);
    const Contact& next = m.contacts[m.lines[line].contact[far]];
    if (&next == &from || !is_passed(next) || next.load || !stands(m, next.body)) return false;
    line = line_at(next, side);
  }
  return false;
}

/// A body that is nothing but a point where this rope bends has no inertia but that of its mass. Where another rope
/// pulls it, it goes with that one, whatever its own mass.
bool is_but_a_bend(const Mechanism& m, int body, int rope) {
  const auto& loads = m.model->loads;
  const bool is_loaded = std::any_of(loads.begin(), loads.end(),
                                     [&](const machine::Load& load) { return load.at.body == body && load.mass > 0; });
  const bool is_pulled = std::any_of(m.lines.begin(), m.lines.end(), [&](const Line& line) {
    return line.reeving != rope && (line.body[0] == body || line.body[1] == body);
  });
  return m.bodies[body].own_mass == 0 && !is_loaded && !is_pulled;
}

/// The rope whose inertia counts at an end of a line, kg. On a body that can move it is the half that goes with the
/// body: were it more, the kinetic energy of both together could be less than none. Else the rope on rounds is part of
/// it, also on those beyond.
double rope_at(const Mechanism& m, std::size_t i, std::size_t end, const Values& now) {
  const Line& line = m.lines[i];
  const bool carried = line.carried[end] > 0;
  double mass = carried ? line.carried[end] : line.mass * now.lines[i].L / 2;
  if (!line.rim[end]) return mass;
  const Contact& contact = m.contacts[line.contact[end]];
  mass += contact.beyond[1 - end];
  if (carried) return mass;
  for (const RopeShare& one : contact.beyond_arcs[1 - end]) {
    const LineValues& there = now.lines[one.line];
    mass += one.share * line.mass * (there.L - free_rope(there));
  }
  return mass;
}

/// A drum whose rope has a given tension does not turn with it; nor does what has neither inertia nor a drive.
bool turns_with_rope(const Mechanism& m, const Contact& contact, const Values& before, const Values& now) {
  const Spin& spin = m.spins[contact.spin];
  if (given_tension(m, contact, before, now.when)) return false;
  return spin.inertia > 0 || prescribed(m, spin, before, now.when).has_value();
}

/// Velocity and acceleration of the place of a body where the rope leaves it.
struct AtPlace {
  Vector3 v = Vector3::Zero(), a = Vector3::Zero();
};
AtPlace at_place(const Mechanism& m, int body, const Vector3& place, const Values& now) {
  if (body < 0) return {};
  const auto [a, b] = acceleration(m, body, now);
  const Motion3& is = now.bodies[body];
  const Vector3 arm = place - is.x;
  return {is.v + is.w.cross(arm), a + b.cross(arm) + is.w.cross(is.w.cross(arm))};
}

/// The radius of the rope at a contact, positive where the spin's angle grows along the path, m.
double lever(const Contact& contact, const LineValues& is, std::size_t end) { return contact.sense * is.radius[end]; }

/// Rate of a line's direction, 1/s.
Vector3 turning(const LineValues& is) { return (is.apart - is.t * is.t.dot(is.apart)) / is.l; }

/// How a freedom of the body at an end moves the place where the rope leaves it.
Vector3 moves(const Mechanism& m, const Line& line, const LineValues& is, std::size_t end, int freedom,
              const Values& now) {
  const Body& shape = m.bodies[line.body[end]];
  const auto f = as_size(freedom);
  if (!shape.turns) return shape.along[f];
  return shape.along[f] + shape.about[f].cross(is.touch[end] - now.bodies[line.body[end]].x);
}

}  // namespace

void mark_ropes_along(Mechanism& m, const DynamicState& start) {
  for (Contact& contact : m.contacts) {
    for (const std::size_t side : {0U, 1U}) {
      const int index = line_at(contact, side);
      if (index < 0) continue;
      Line& line = m.lines[index];
      if (line.mass == 0 || line.segment >= 0) continue;
      if (has_rim(contact)) {
        line.along[side] = line.rim[side] = line.has_along = true;
        Array<RopeShare> shares = beyond(m, contact, side);
        for (const RopeShare& one : shares) contact.beyond[1 - side] += one.share * mass_of(m, start, one.line);
        contact.beyond_arcs[1 - side] = std::move(shares);
      } else if (is_passed(contact) && !contact.load && is_held(m, contact, side)) {
        line.along[side] = true;
        if (stands(m, contact.body) || is_but_a_bend(m, contact.body, line.reeving)) continue;
        line.held[side] = line.has_along = true;
      }
    }
  }
}

void add_surge(const Mechanism& m, const Scheme& s, const Values& before, std::size_t i, Values& now) {
  const Line& line = m.lines[i];
  LineValues& is = now.lines[i];
  for (const std::size_t end : {0U, 1U}) {
    is.surge[end] = is.surge_share[end] = 0;
    if (s.at_rest || (!line.rim[end] && !line.held[end])) continue;
    const Contact& contact = m.contacts[line.contact[end]];
    if (line.held[end]) {
      // where it sticks, or lies slack on both sides, the rope goes with the body
      const bool passes = before.contacts[line.contact[end]].grip != Grip::stuck && !loose(contact, before);
      is.surge_share[end] = passes ? is.gone : 0;
      continue;
    }
    if (!turns_with_rope(m, contact, before, now)) continue;
    const Vector3& t = direction(m, now, static_cast<int>(i), end);
    const double carried = t.dot(at_place(m, line.body[end], is.touch[end], now).a);
    const double asked = rope_at(m, i, end, now) * (lever(contact, is, end) * now.spins[contact.spin].alpha + carried);
    const double most = most_hung * std::max(0.0, is.end_T[end]);
    is.surge[end] = std::clamp(asked, -most, most);
    is.surge_share[end] = asked == 0 ? 1 : is.surge[end] / asked;
    is.end_T[end] += sign_at(end) * is.surge[end];
  }
}

Vector3 force_along(const Mechanism& m, std::size_t i, std::size_t end, const Values& now) {
  const Line& line = m.lines[i];
  const LineValues& is = now.lines[i];
  if (is.surge_share[end] == 0) return Vector3::Zero();
  const double mass = is.surge_share[end] * rope_at(m, i, end, now);
  if (line.held[end]) {  // of its mass, which the body carries, only what goes across the rope has inertia
    const AtPlace at = at_place(m, line.body[end], is.touch[end], now);
    return mass * (is.t.dot(at.a) * is.t + is.t.dot(at.v) * turning(is));
  }
  const Contact& contact = m.contacts[line.contact[end]];
  const SpinValues& spin = now.spins[contact.spin];
  return -mass * lever(contact, is, end) * (spin.alpha * is.t + spin.omega * turning(is));
}

namespace {

/// How the tension at a rim follows the line's own unknowns, where its surge is as much as the tension bears.
void bound_by_tension(const Line& line, double by_tension, std::array<double, 14>& tangent) {
  for (std::size_t k = 0; k < as_size(line.columns); ++k) tangent[k] *= 1 + by_tension;
}

/// The row of a freedom of a body at the end of a line that is held. `along`: how it moves the place along the line.
void add_held_row(Mechanism& m, std::size_t i, std::size_t end, int freedom, double along, const Values& now) {
  const Line& line = m.lines[i];
  const LineValues& is = now.lines[i];
  auto& values = m.solver.values();
  const int first = end == 0 ? 0 : line.freedoms[0];
  const int* const row = line.places.data() + static_cast<std::ptrdiff_t>(first + freedom) * line.columns;
  const double mass = is.surge_share[end] * rope_at(m, i, end, now);
  for (int g = 0; g < line.freedoms[end]; ++g) {
    values[row[first + g]] -= mass * along * is.t.dot(moves(m, line, is, end, g, now));
  }
}

/// Rows and slopes of an end; how they follow the turning of the line is left out.
void assemble_end(Mechanism& m, std::size_t i, std::size_t end, const Values& now, Work& w) {
  const Line& line = m.lines[i];
  const LineValues& is = now.lines[i];
  auto& tangent = w.tangents[i].end_T[end];
  const bool bounded = is.surge_share[end] < 1;
  if (w.tangent && bounded && line.rim[end]) {
    bound_by_tension(line, sign_at(end) * std::copysign(most_hung, is.surge[end]), tangent);
  }
  if (line.body[end] < 0) return;
  const double mass = rope_at(m, i, end, now);
  const Vector3 force = force_along(m, i, end, now), t = direction(m, now, static_cast<int>(i), end);
  const int first = end == 0 ? 0 : line.freedoms[0], count = line.freedoms[end];
  for (int f = 0; f < count; ++f) {
    const Vector3 V = moves(m, line, is, end, f, now);
    w.residual[line.column[as_size(first + f)]] -= line.copies * force.dot(V);
    if (!w.tangent) continue;
    const double along = line.copies * is.t.dot(V);
    if (line.held[end]) {
      add_held_row(m, i, end, f, along, now);
      continue;
    }
    const Contact& contact = m.contacts[line.contact[end]];
    const int place = m.spin_place_first[contact.spin] + (f + 1) * (count + 1);
    m.solver.values()[m.spin_places[place]] += along * is.surge_share[end] * mass * lever(contact, is, end);
    if (!bounded) tangent[as_size(first + f)] += sign_at(end) * mass * t.dot(V);
  }
}

}  // namespace

void assemble_along(Mechanism& m, std::size_t i, const Values& now, Work& w) {
  for (const std::size_t end : {0U, 1U}) {
    if (now.lines[i].surge_share[end] != 0) assemble_end(m, i, end, now, w);
  }
}

SurgeSlopes surge_slopes(const Mechanism& m, const Contact& contact, const Values& before, const Values& now) {
  SurgeSlopes slopes;
  if (contact.spin < 0 || prescribed(m, m.spins[contact.spin], before, now.when)) return slopes;
  const auto slope = [&](int line, std::size_t end) {
    if (line < 0 || now.lines[line].surge_share[end] < 1) return 0.0;
    return sign_at(end) * rope_at(m, as_size(line), end, now) * lever(contact, now.lines[line], end);
  };
  return {.in = slope(contact.in, 1), .out = slope(contact.out, 0)};
}

double power_along(const Mechanism& m, const Values& now) {
  double power = 0;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = now.lines[i];
    if (!line.has_along) continue;
    for (const std::size_t end : {0U, 1U}) {
      if (is.surge[end] != 0) {
        const double stretch = sags(line, is) ? is.l / is.hung : 1 + is.e;
        power += line.copies * is.surge[end] * stretch * now.contacts[line.contact[end]].flow;
      }
      if (line.body[end] < 0 || is.surge_share[end] == 0) continue;
      power -= line.copies * force_along(m, i, end, now).dot(at_place(m, line.body[end], is.touch[end], now).v);
    }
  }
  return power;
}

}  // namespace taut::solve::dynamics
