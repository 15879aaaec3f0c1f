#include "taut/solve/motion/parts/rope_load.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::solve::dynamics {
namespace {

const machine::RopeLoad& load_at(const Mechanism& m, const Contact& contact) {
  return m.model->reevings[contact.reeving].nodes[contact.node].load;
}

/// Mean direction of the rope at the point.
Vector3 direction_at(const Contact& contact, const Values& v) {
  return (v.lines[contact.in].t + v.lines[contact.out].t).normalized();
}

double difference_at(const Contact& contact, const Values& v) {
  const LineValues &in = v.lines[contact.in], &out = v.lines[contact.out];
  return out.end_T[0] - in.end_T[1];
}

/// Unstretched length of the free rope at the very start, from round to round, in which a load lies, m.
double loaded_span(const Mechanism& m, const Contact& contact, const DynamicState& start) {
  const machine::Reeving& rope = m.model->reevings[contact.reeving];
  const int nodes = static_cast<int>(rope.nodes.size()), per_branch = std::max(1, rope.segments);
  const auto is_load = [&](int k) { return rope.nodes[(k + nodes) % nodes].kind == machine::NodeKind::load; };
  int from = contact.node, to = contact.node;
  while (is_load(from)) --from;
  while (is_load(to)) ++to;
  const auto [first, lines] = m.first_line[contact.reeving];
  double length = 0;
  for (int k = from * per_branch; k < to * per_branch; ++k) {
    length += lumped_length(m, start, first + (k + lines) % lines);
  }
  return length;
}

}  // namespace

void measure_loaded_spans(Mechanism& m, const DynamicState& start) {
  for (Contact& contact : m.contacts) {
    if (contact.load) contact.load_length = loaded_span(m, contact, start);
  }
  for (ChainLoad& load : m.chain_loads) load.as.load_length = loaded_span(m, load.as, start);
}

RopeLoadStep rope_load(const Mechanism& m, const Contact& contact, double when, double flow, bool lossless) {
  const machine::RopeLoad& given = load_at(m, contact);
  const double force = given.signal ? machine::at(*given.signal, when).value : given.force + given.rate;
  const double size = given.part > 0 ? force * given.part * contact.load_length : force;
  if (!given.by_motion) return {-given.sense * size, false};
  if (lossless) return {0, true};
  if (given.sense < 0) return {std::abs(size), true};
  const int haul = m.model->reevings[contact.reeving].haul;
  return {flow > 0 || (flow == 0 && haul > 0) ? -size : size, false};
}

Grip grip_at_load(const RopeLoadStep& load, double difference, double slip) {
  if (!load.holds || load.drop == 0) return Grip::equal;
  return difference - load.drop + slip > 0    ? Grip::forward
         : -difference - load.drop - slip > 0 ? Grip::backward
                                              : Grip::stuck;
}

double asked_difference(const ContactValues& is) { return is.grip == Grip::backward ? -is.drop : is.drop; }

int line_end(const machine::Reeving& rope, int node, std::size_t end) {
  const int nodes = static_cast<int>(rope.nodes.size());
  while (rope.nodes[node].kind == machine::NodeKind::load) node = (node + (end == 0 ? nodes - 1 : 1)) % nodes;
  return node;
}

void set_part(const Mechanism& m, const machine::Reeving& rope, Line& line) {
  if (rope.segments > 1) return;
  const machine::Node &from = rope.nodes[line.from], &to = rope.nodes[line.to];
  line.at_load = {from.kind == machine::NodeKind::load, to.kind == machine::NodeKind::load};
  line.part = line.at_load[0] || line.at_load[1];
  if (!line.part) return;
  const auto stands = [&](int body) {
    return body < 0 || (m.bodies[body].count == 0 && m.model->bodies[body].driven.empty());
  };
  // of how much of the line's length a place follows
  const auto follows = [&](const machine::Node& node) {
    return stands(line.body[0]) ? 0.0 : stands(line.body[1]) ? 1.0 : node.load.share;
  };
  line.ahead = line.at_load[0] ? follows(from) : 0;
  line.share = (line.at_load[1] ? follows(to) : 1) - line.ahead;
  line.middle = ((line.at_load[0] ? from.load.share : 0) + (line.at_load[1] ? to.load.share : 1)) / 2;
}

void set_places(const DynamicState& start, const LineValues& now, const machine::Reeving& rope, Line& line) {
  // a motion that goes on has the places among its bodies
  const bool anew = start.ropes[line.reeving].passed.empty();
  const auto place = [&](const machine::Node& node) {
    if (anew) return node.load.share * now.l;
    return now.t.dot(start.bodies[node.at.body].position - now.touch[0]);
  };
  const double ends = line.at_load[1] ? place(rope.nodes[line.to]) : now.l;
  line.ahead_more = line.at_load[0] ? place(rope.nodes[line.from]) - line.ahead * now.l : 0;
  line.more = ends - (line.ahead + line.share) * now.l - line.ahead_more;
}

void place_rope_loads(const Mechanism& m, Values& now) {
  const auto velocity = [&](const Line& line, const LineValues& is, std::size_t end) {
    if (line.body[end] < 0) return Vector3(Vector3::Zero());
    const Motion3& body = now.bodies[line.body[end]];
    return Vector3(body.v + body.w.cross(is.touch[end] - body.x));
  };
  for (const Contact& contact : m.contacts) {
    if (!contact.load) continue;
    const Line& line = m.lines[contact.out];
    const LineValues& is = now.lines[contact.out];
    Motion3& place = now.bodies[contact.body];
    place.x = is.touch[0] + (line.ahead * is.l + line.ahead_more) * is.t;
    place.v = (1 - line.ahead) * velocity(line, is, 0) + line.ahead * velocity(line, is, 1);
  }
}

double turned_strain_rate(const Line& line, const Array<Motion3>& bodies, const Array<ContactValues>& contacts,
                          const LineValues& now) {
  if (line.kind != LineKind::planar) return 0;
  std::array<Vector3, 2> velocity{Vector3::Zero(), Vector3::Zero()};
  std::array<double, 2> radius{}, carried{};
  for (const std::size_t end : {0U, 1U}) {
    Vector3 axis = line.axis[end];
    if (line.body[end] >= 0) {
      const Motion3& body = bodies[line.body[end]];
      velocity[end] = body.v + body.w.cross(now.centre[end] - body.x);
      carried[end] = body.w.dot(now.axis);
      axis = body.R * axis;
    }
    radius[end] = (axis.dot(now.axis) < 0 ? -1 : 1) * line.side[end] * now.radius[end];
  }
  const Vector3 apart = velocity[1] - velocity[0], across = now.axis.cross(now.flat);
  const double turn = across.dot(apart) / now.flat_l;
  const double flat_rate = now.flat.dot(apart) + (radius[1] - radius[0]) * turn;
  const double out = now.axis.dot(now.centre[1] - now.centre[0]);
  const double l_rate = (now.flat_l * flat_rate + out * now.axis.dot(apart)) / now.l;
  double wound = 0;  // into the line, unstretched, m/s
  double laid = 0;   // on its rounds, m/s
  for (const std::size_t end : {0U, 1U}) {
    if (line.contact[end] < 0 || line.at_load[end]) continue;
    const double rate = (end == 0 ? 1 : -1) * radius[end] * (turn - carried[end]);
    (line.arcs[end] ? laid : wound) += line.arcs[end] ? rate : -rate / contacts[line.contact[end]].winding;
  }
  return (line.share * (l_rate - now.t.dot(now.apart)) + laid - (1 + now.e) * wound) / now.L;
}

Vector3 part_force(const Line& line, const LineValues& now, std::size_t end) {
  const double pull = line.at_load[end] ? 0 : (end == 0 ? 1 : -1) * (tension_of_branch(now, end) - now.thrust[end]);
  const double weight = line.weight * free_rope(now) * borne(line, now.l, end);
  return (pull + weight * now.t.z()) * now.t - weight * Vector3::UnitZ();
}

void add_part(const Line& line, const LineValues& now, Work& w) {
  for (int r = 0; r < line.freedoms[0] + line.freedoms[1]; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    w.residual[line.column[as_size(r)]] -= line.copies * part_force(line, now, end).dot(w.columns[as_size(r)].velocity);
  }
}

void add_part_slopes(Mechanism& m, const Scheme& s, const Line& line, const LineValues& now, const LineTangent& tangent,
                     const std::array<double, 14>& L, Work& w) {
  auto& values = m.solver.values();
  const double square = s.reach * s.reach;
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  for (int r = 0; r < freedoms; ++r) {
    const std::size_t end = r < line.freedoms[0] ? 0 : 1;
    const double sign = line.at_load[end] ? 0 : end == 0 ? 1 : -1;
    const double per_metre = line.weight * borne(line, now.l, end), weight = per_metre * free_rope(now);
    const double pull = sign * (tension_of_branch(now, end) - now.thrust[end]) + weight * now.t.z();
    const Vector3& V = w.columns[as_size(r)].velocity;
    const double along = now.t.dot(V);
    const Body& shape = m.bodies[line.body[end]];
    const Vector3 force = part_force(line, now, end);
    const Vector3 about =
        shape.turns ? shape.about[as_size(end == 0 ? r : r - line.freedoms[0])] : Vector3(Vector3::Zero());
    for (int k = 0; k < line.columns; ++k) {
      double Q = (sign * tangent.end_T[end][as_size(k)] + per_metre * L[as_size(k)] * now.t.z()) * along -
                 per_metre * L[as_size(k)] * V.z();
      if (k < freedoms) {
        const LineColumn& c = w.columns[as_size(k)];
        Q += square * (pull * c.t.dot(V) + weight * c.t.z() * along + force.dot(about.cross(c.touch[end])));
      }
      values[line.places[r * line.columns + k]] -= line.copies * Q;
    }
  }
}

double rope_load_work(const Contact& contact, const Values& before, const Values& now) {
  const auto body = as_size(contact.body);
  const Vector3 way = now.bodies[body].x - before.bodies[body].x;
  const double a = difference_at(contact, before) * direction_at(contact, before).dot(way);
  const double b = difference_at(contact, now) * direction_at(contact, now).dot(way);
  return contact.copies * (a + b) / 2;
}

}  // namespace taut::solve::dynamics
