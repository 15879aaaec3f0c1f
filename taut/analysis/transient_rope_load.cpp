#include "taut/analysis/transient_rope_load.hpp"

#include <algorithm>
#include <cmath>

namespace taut::analysis::dynamics {
namespace {

const model::RopeLoad& load_at(const Mechanism& m, const Contact& contact) {
  return m.model->reevings[at(contact.reeving)].nodes[at(contact.node)].load;
}

/// Mean direction of the rope at the point.
Vector3 direction_at(const Contact& contact, const Values& v) {
  return (v.lines[at(contact.in)].t + v.lines[at(contact.out)].t).normalized();
}

double difference_at(const Contact& contact, const Values& v) {
  const LineValues &in = v.lines[at(contact.in)], &out = v.lines[at(contact.out)];
  return out.end_T[0] - in.end_T[1];
}

/// Unstretched length of the free rope, from round to round, in which a load lies, m.
double loaded_span(const Mechanism& m, const Contact& contact, const DynamicState& start) {
  const model::Reeving& rope = m.model->reevings[at(contact.reeving)];
  const int nodes = static_cast<int>(rope.nodes.size()), per_branch = std::max(1, rope.segments);
  const auto is_load = [&](int k) { return rope.nodes[at((k + nodes) % nodes)].kind == model::NodeKind::load; };
  int from = contact.node, to = contact.node;
  while (is_load(from)) --from;
  while (is_load(to)) ++to;
  const auto [first, lines] = m.first_line[at(contact.reeving)];
  double length = 0;
  for (int k = from * per_branch; k < to * per_branch; ++k) {
    length += start_length(m, start, first + (k + lines) % lines);
  }
  return length;
}

}  // namespace

void measure_loaded_spans(Mechanism& m, const DynamicState& start) {
  for (Contact& contact : m.contacts) {
    if (contact.load) contact.load_length = loaded_span(m, contact, start);
  }
}

RopeLoadStep rope_load(const Mechanism& m, const Contact& contact, double when, double flow, bool lossless) {
  const model::RopeLoad& given = load_at(m, contact);
  const double force = given.signal ? model::at(*given.signal, when).value : given.force + given.rate;
  const double size = given.part > 0 ? force * given.part * contact.load_length : force;
  if (!given.by_motion) return {-given.sense * size, false};
  if (lossless) return {0, true};
  if (given.sense < 0) return {std::abs(size), true};
  const int haul = m.model->reevings[at(contact.reeving)].haul;
  return {flow > 0 || (flow == 0 && haul > 0) ? -size : size, false};
}

Grip grip_at_load(const RopeLoadStep& load, double difference, double slip) {
  if (!load.holds || load.drop == 0) return Grip::equal;
  return difference - load.drop + slip > 0    ? Grip::forward
         : -difference - load.drop - slip > 0 ? Grip::backward
                                              : Grip::stuck;
}

double asked_difference(const ContactValues& is) { return is.grip == Grip::backward ? -is.drop : is.drop; }

void assemble_rope_load(Mechanism& m, const Contact& contact, const Values& now, Work& w) {
  const Body& body = m.bodies[at(contact.body)];
  const Vector3 t = direction_at(contact, now);
  const double difference = difference_at(contact, now);
  auto& values = m.solver.values();
  for (std::size_t f = 0; f < at(body.count); ++f) {
    const double share = contact.copies * t.dot(body.along[f]);
    w.residual[at(body.first) + f] += share * difference;
    if (!w.tangent) continue;
    for (const bool out : {false, true}) {
      const std::size_t i = at(out ? contact.out : contact.in);
      const Line& line = m.lines[i];
      const std::size_t row = f + (out ? 0 : at(line.freedoms[0]));
      const auto& slopes = w.tangents[i].end_T[out ? 0 : 1];
      for (std::size_t k = 0; k < at(line.columns); ++k) {
        values[at(line.places[row * at(line.columns) + k])] += (out ? share : -share) * slopes[k];
      }
    }
  }
}

double rope_load_work(const Contact& contact, const Values& before, const Values& now) {
  const auto body = at(contact.body);
  const Vector3 way = now.bodies[body].x - before.bodies[body].x;
  const double a = difference_at(contact, before) * direction_at(contact, before).dot(way);
  const double b = difference_at(contact, now) * direction_at(contact, now).dot(way);
  return contact.copies * (a + b) / 2;
}

}  // namespace taut::analysis::dynamics
