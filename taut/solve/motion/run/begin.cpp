#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/bend.hpp"
#include "taut/mechanics/system.hpp"
#include "taut/solve/motion/parts/build.hpp"
#include "taut/solve/motion/parts/chain_load.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double most_strain = 5;  ///< no cord stretches more, of rubber neither; such a length is a slip

Outcome no_rope_between(const machine::Model& model, const Line& line, const char* how) {
  const machine::Reeving& rope = model.reevings[line.reeving];
  return infeasible(fmt::format("no rope {} from '{}' to '{}' of '{}' where the motion begins", how,
                                rope.nodes[line.from].name, rope.nodes[line.to].name, rope.name));
}

Outcome too_short(const machine::Model& model, const Line& line, const LineValues& is) {
  const machine::Reeving& rope = model.reevings[line.reeving];
  return infeasible(fmt::format(
      "rope '{}' would begin the motion stretched by {:.3g} %: {:.4g} m of rope between '{}' and '{}', {:.4g} m apart; "
      "give it its length",
      rope.name, 100 * is.e, is.L, rope.nodes[line.from].name, rope.nodes[line.to].name, is.l));
}

/// Rope that comes back from the rounds at its ends where a branch that hangs in the state `start` is straight in
/// motion: it leaves and arrives in other directions, so that less or more of it lies there, m.
double back_from_rounds(const Line& line, const Values& v, const DynamicState::Rope& start, std::size_t branch,
                        const Vector3& straight) {
  if (line.sag >= 0 || line.segment >= 0 || branch >= start.leaves.size() || branch >= start.arrives.size()) return 0;
  double length = 0;
  for (const std::size_t end : {0U, 1U}) {
    const Vector3& hangs = end == 0 ? start.leaves[branch] : start.arrives[branch];
    if (hangs == Vector3::Zero() || line.radius[end] == 0 || (line.part && line.at_load[end])) continue;
    const Vector3 axis = to_ground(v.bodies, line.body[end], line.axis[end]);
    const double turned = std::atan2(axis.dot(straight.cross(hangs)), straight.dot(hangs));
    length += (end == 0 ? 1 : -1) * line.side[end] * line.radius[end] * turned;
  }
  return length;
}

/// The same of a part between loads: what comes back lies along the whole free line, with one strain, so that each part
/// has as much of it as of the line's length. Near a round the part beside it would begin with all of it.
double back_from_rounds(const Mechanism& m, const Values& v, const DynamicState& start, int index) {
  const Line& line = m.lines[index];
  const DynamicState::Rope& rope = start.ropes[line.reeving];
  const int first = m.first_line[line.reeving].first;
  int from = index, to = index;
  while (m.lines[from].at_load[0]) --from;
  while (m.lines[to].at_load[1]) ++to;
  const LineValues& is = v.lines[index];
  double back = 0;
  for (int k = from; k <= to; ++k) back += back_from_rounds(m.lines[k], v, rope, as_size(k - first), is.t);
  return back == 0 ? 0 : back * length_of(line, is.l) / is.l;
}

/// A motion that goes on with branches of another shape would begin with a jump of their tension.
Outcome keeps_its_shape(const machine::Model& model, const Line& line, const LineValues& is,
                        const DynamicState::Rope& start, std::size_t branch) {
  const bool goes_on = !start.passed.empty() && branch < start.leaves.size();
  if (!goes_on || is.gone == 0 || line.segment >= 0) return {};
  const bool hung = start.leaves[branch] != Vector3::Zero();
  if (hung == sags(line, is)) return {};
  const machine::Reeving& rope = model.reevings[line.reeving];
  return infeasible(fmt::format("rope '{}' {} between '{}' and '{}' in the motion before: give the 'branches' of that",
                                rope.name, hung ? "hung as a catenary" : "was straight", rope.nodes[line.from].name,
                                rope.nodes[line.to].name));
}

void place_lines(const DynamicState& start, Built& built) {
  Mechanism& m = built.mechanism;
  const machine::Model& model = *m.model;
  Values& v = built.values;
  v.lines.resize(m.lines.size());
  v.sags.resize(as_size(m.sagging));
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    LineValues& line = v.lines[i];
    line.radius = m.lines[i].radius;
    for (const std::size_t end : {0U, 1U}) {
      const int body = m.lines[i].body[end];
      m.lines[i].offset[end] = to_ground(v.bodies, body, m.lines[i].place[end]);
    }
    if (!place_line(m.lines[i], v.bodies, line, line)) {
      built.outcome = no_rope_between(model, m.lines[i], "goes straight");
      return;
    }
    line.angle = {0, 0};
    const auto& whole = start.ropes[m.lines[i].reeving].whole;
    const std::size_t own = i - as_size(m.first_line[m.lines[i].reeving].first);
    if (m.lines[i].part) set_places(start, line, model.reevings[m.lines[i].reeving], m.lines[i]);
    line.L = start_length(m, start, static_cast<int>(i)) + back_from_rounds(m, v, start, static_cast<int>(i));
    line.gone = own < whole.size() && whole[own] == 0 ? 0 : 1;
    built.outcome = keeps_its_shape(model, m.lines[i], line, start.ropes[m.lines[i].reeving], own);
    if (!built.outcome.ok()) return;
    line.e = length_of(m.lines[i], line.l) / line.L - 1;
    if (line.e > most_strain) {
      built.outcome = too_short(model, m.lines[i], line);
      return;
    }
    pull(m.lines[i], line);
    line.end_T = {line.T, line.T};
    if (!sags(m.lines[i], line)) continue;
    SagValues& shape = v.sags[m.lines[i].sag];
    if (!begin_to_hang(m.lines[i], v.bodies, start, static_cast<int>(own), line, shape)) {
      built.outcome = no_rope_between(model, m.lines[i], "hangs");
      return;
    }
    pull_sagging(m.lines[i], 0, line, shape);
  }
}

void fill_contacts(const DynamicState& start, Built& built) {
  const Mechanism& m = built.mechanism;
  const machine::Model& model = *m.model;
  Values& v = built.values;
  v.contacts.resize(m.contacts.size());
  Array<machine::Pose> poses;
  poses.reserve(v.bodies.size());
  for (const Motion3& body : v.bodies) poses.push_back({body.x, body.R});
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Contact& contact = m.contacts[i];
    ContactValues& is = v.contacts[i];
    is.entry = contact.in >= 0 ? contact.in : contact.out;
    is.lambda = 1 + std::max(0.0, entry_strain(m, v, contact, is.entry));
    is.winding = is.lambda;
    if (contact.in < 0 || contact.out < 0) continue;
    const machine::Node& node = model.reevings[contact.reeving].nodes[contact.node];
    is.wrap = mechanics::bend(node, mechanics::end_at(node, poses), direction(m, v, contact.in, 1),
                              direction(m, v, contact.out, 0))
                  .wrap.value;
    const auto& wraps = start.ropes[contact.reeving].wrap;
    if (!wraps.empty() && contact.round) is.wrap += two_pi * std::round((wraps[contact.node] - is.wrap) / (two_pi));
  }
}

/// The rope on the rounds at the ends of the lines: as the state says, or what begins to stretch with them. The state's
/// length of a line is that between its rounds.
void fill_arcs(const DynamicState& start, Built& built) {
  const Mechanism& m = built.mechanism;
  Values& v = built.values;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    LineValues& is = v.lines[i];
    const auto& saved = start.ropes[line.reeving].on_rounds;
    const std::size_t own = 2 * (i - as_size(m.first_line[line.reeving].first));
    for (const std::size_t end : {0U, 1U}) {
      if (!line.arcs[end]) continue;
      const Contact& contact = m.contacts[line.contact[end]];
      const machine::Node& node = m.model->reevings[contact.reeving].nodes[contact.node];
      const double wrap = v.contacts[line.contact[end]].wrap;
      if (own + end < saved.size()) {
        is.arc[end] = saved[own + end];
      } else if (is.gone > 0) {
        is.arc[end] = share_that_stretches(node, wrap) * is.radius[end] * wrap / 2;
      }
    }
    if (is.gone == 0) continue;
    if (sags(line, is)) is.L = is.hung;
    for (const std::size_t end : {0U, 1U})
      is.L += is.arc[end] / (1 + std::max(0.0, end_strain(m, v, static_cast<int>(i), end)));
  }
}

void fill_drums(const DynamicState& start, Built& built) {
  const Mechanism& m = built.mechanism;
  const machine::Model& model = *m.model;
  Values& v = built.values;
  v.on_drums.resize(as_size(m.on_drums));
  for (const Contact& contact : m.contacts) {
    if (contact.drum < 0) continue;
    const machine::Drum& drum = model.drums[contact.drum];
    OnDrumValues& end = v.on_drums[contact.on_drum];
    end.layer = drum.layer;
    end.content = drum.length_on_drum.value_or(0);
    if (as_size(contact.on_drum) < start.on_drums.size()) {
      const DynamicState::OnDrum& saved = start.on_drums[contact.on_drum];
      end = {saved.content, saved.layer, saved.strain};
    }
    if (!end.strain.empty()) continue;
    const int line = contact.in >= 0 ? contact.in : contact.out;
    double strain = std::max(0.0, end_strain(m, v, line, contact.in >= 0 ? 1 : 0));
    if (drum.wound_at) strain = *drum.wound_at / m.lines[line].stiffness;
    end.strain.assign(as_size(std::max(1, end.layer)), strain);
  }
}

}  // namespace

void classify(Mechanism& m, Arcs arcs) {
  for (Body& body : m.bodies) {
    body.driven = body.model >= 0 && !m.model->bodies[body.model].driven.empty();
    body.dead = -body.own_mass * m.model->gravity * up();
    if (body.model >= 0) body.dead += dead_load(m, body.model);
    m.body_columns += body.count;
  }
  const auto shifts = [&](int body) { return body < 0 || (!m.bodies[body].turns && !m.bodies[body].driven); };
  const auto rests = [&](int body) { return body < 0 || (m.bodies[body].count == 0 && !m.bodies[body].driven); };
  for (Line& line : m.lines) {
    line.plain =
        line.kind == LineKind::points && !line.part && line.sag < 0 && shifts(line.body[0]) && shifts(line.body[1]);
    line.still = rests(line.body[0]) && rests(line.body[1]) && line.sag < 0;
    m.stiffest = std::max(m.stiffest, line.stiffness);
  }
  for (const auto& [line, end] : m.tensioner) m.lines[line].tensioned = true;
  for (Contact& contact : m.contacts) {
    const machine::Reeving& rope = m.model->reevings[contact.reeving];
    contact.load = rope.nodes[contact.node].kind == machine::NodeKind::load;
    m.rope_loads = m.rope_loads || contact.load;
    const bool light = contact.spin < 0;
    contact.bearing_log = light ? -std::log(contact.efficiency) : std::numeric_limits<double>::infinity();
    contact.bearing_ratio = light ? 1 / contact.efficiency : std::numeric_limits<double>::infinity();
  }
  for (Line& line : m.lines) {
    for (const std::size_t end : {0U, 1U}) {
      if (line.contact[end] < 0 || line.at_load[end] || line.radius[end] == 0) continue;
      const Contact& contact = m.contacts[line.contact[end]];
      line.arcs[end] = arcs == Arcs::stretch && contact.in >= 0 && contact.out >= 0 && !contact.load;
    }
  }
  const auto plain = [](const Line& line) { return line.kind == LineKind::points && line.sag < 0; };
  const auto still = [](const Body& body) { return body.count == 0 || body.point; };
  const bool driven = std::any_of(m.model->bodies.begin(), m.model->bodies.end(),
                                  [](const machine::Body& body) { return !body.driven.empty(); });
  m.simple = m.contacts.empty() && m.chain_loads.empty() && m.couples.empty() && m.tensioner.empty() && !driven &&
             std::all_of(m.lines.begin(), m.lines.end(), plain) && std::all_of(m.bodies.begin(), m.bodies.end(), still);
  m.lossless =
      m.simple && std::all_of(m.lines.begin(), m.lines.end(), [](const Line& line) { return line.damping == 0; });
}

double start_length(const Mechanism& m, const DynamicState& start, int line) {
  const int reeving = m.lines[line].reeving;
  return start.ropes[reeving].length[line - m.first_line[reeving].first];
}

double lumped_length(const Mechanism& m, const DynamicState& start, int line) {
  const int reeving = m.lines[line].reeving;
  const auto& lumped = start.ropes[reeving].lumped;
  const std::size_t own = as_size(line - m.first_line[reeving].first);
  return own < lumped.size() ? lumped[own] : start_length(m, start, line);
}

void fill_values(const DynamicState& start, Built& built) {
  Mechanism& m = built.mechanism;
  const machine::Model& model = *m.model;
  Values& v = built.values;
  v.t = v.when = start.t;
  v.q.assign(as_size(m.size), 0.0);
  v.nu = v.rate = v.q;
  v.bodies.resize(m.bodies.size());
  std::size_t inner = 0;
  Array<Vector3> places, velocities;
  for (const auto& rope : start.ropes) {
    places.insert(places.end(), rope.inside.begin(), rope.inside.end());
    velocities.insert(velocities.end(), rope.inside_velocity.begin(), rope.inside_velocity.end());
  }
  velocities.resize(places.size(), Vector3::Zero());
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    Motion3& is = v.bodies[b];
    if (m.bodies[b].model < 0) {
      expects(inner < places.size(), "a place for each node of a rope in segments");
      is.v = velocities[inner];
      is.x = places[inner++];
    } else {
      const DynamicState::Body& given = start.bodies[b];
      is.x = given.position;
      is.R = given.orientation;
      is.v = given.velocity;
      is.w = given.spin;
    }
    for (int f = 0; f < m.bodies[b].count; ++f) {
      const Vector3 &along = m.bodies[b].along[as_size(f)], &about = m.bodies[b].about[as_size(f)];
      v.nu[m.bodies[b].first + f] = is.v.dot(along) + is.w.dot(about);
    }
  }
  v.drum_drive = start.drum_drive;
  v.motor_drive = start.motor_drive;
  if (v.drum_drive.empty()) {
    for (const auto& drum : model.drums) v.drum_drive.push_back(drum.drive);
  }
  if (v.motor_drive.empty()) {
    for (const auto& motor : model.motors) v.motor_drive.push_back(motor.drive);
  }
  v.spins.resize(m.spins.size());
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const Contact& contact = m.contacts[m.spins[i].contacts.front().first];
    const auto& rope = start.ropes[contact.reeving];
    if (rope.spin.empty()) continue;
    v.nu[m.spins[i].column] = contact.sense * rope.spin[contact.node];
    v.q[m.spins[i].column] = contact.sense * rope.angle[contact.node];
  }
  v.tensioned.assign(m.tensioner.size(), 0.0);
  v.tension_rate = v.tensioned;
  for (std::size_t k = 0; k < m.tensioner.size(); ++k)
    v.tensioned[k] = machine::at(model.tensioners[k].change, v.t).value;
  place_lines(start, built);
  if (m.rope_loads) place_rope_loads(m, v);
  place_chain_loads(start, m, v);
  fill_contacts(start, built);
  fill_arcs(start, built);
  fill_drums(start, built);
  fill_couples(start, m, v);
  for (const LineValues& line : v.lines) m.size_of_machine = std::max(m.size_of_machine, line.l);
}

}  // namespace taut::solve::dynamics
