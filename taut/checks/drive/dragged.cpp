#include "taut/checks/drive/dragged.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "taut/checks/parts.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/drives.hpp"

namespace taut::checks {
namespace {

using Frame = solve::TransientFrame;

constexpr double least_share = 0.01;  ///< of its length; by less a cylinder swings under the load that it bears

bool moves(const machine::Model& m, int body) {
  return body != machine::ground && !machine::stands_fast(m.bodies[body]);
}

/// The parts of a machine that move together, each known by one of them: bodies that can move, then ropes, drums,
/// motors and cylinders.
class Together {
 public:
  explicit Together(const machine::Model& m)
      : ropes_(m.bodies.size()),
        drums_(ropes_ + m.reevings.size()),
        motors_(drums_ + m.drums.size()),
        cylinders_(motors_ + m.motors.size()),
        of_(cylinders_ + m.actuators.size()) {
    std::iota(of_.begin(), of_.end(), std::size_t{0});
    for (std::size_t r = 0; r < m.reevings.size(); ++r) {
      for (const machine::Node& node : m.reevings[r].nodes) {
        join_body(m, ropes_ + r, node.at.body);
        if (node.drum) join(ropes_ + r, drum(as_size(*node.drum)));
        if (node.motor) join(ropes_ + r, motor(as_size(*node.motor)));
      }
    }
    for (std::size_t i = 0; i < m.actuators.size(); ++i) {
      join_body(m, cylinder(i), m.actuators[i].from_body);
      join_body(m, cylinder(i), m.actuators[i].to_body);
    }
    for (const machine::FaceContact& contact : m.contacts) {
      if (moves(m, contact.body)) join_body(m, as_size(contact.body), m.faces[contact.face].body);
    }
    join_beams(m);
  }

  std::size_t rope(std::size_t i) const { return ropes_ + i; }
  std::size_t drum(std::size_t i) const { return drums_ + i; }
  std::size_t motor(std::size_t i) const { return motors_ + i; }
  std::size_t cylinder(std::size_t i) const { return cylinders_ + i; }
  std::size_t size() const { return of_.size(); }

  std::size_t of(std::size_t part) const {
    while (of_[part] != part) part = of_[part];
    return part;
  }

 private:
  void join(std::size_t a, std::size_t b) { of_[of(a)] = of(b); }
  void join_body(const machine::Model& m, std::size_t part, int body) {
    if (moves(m, body)) join(part, as_size(body));
  }
  void join_beams(const machine::Model& m) {
    std::vector<std::size_t> first(m.beams.size(), of_.size());
    for (std::size_t b = 0; b < m.bodies.size(); ++b) {
      if (!m.bodies[b].beam) continue;
      std::size_t& section = first[as_size(*m.bodies[b].beam)];
      if (section == of_.size()) section = b;
      join(section, b);
    }
  }

  std::size_t ropes_, drums_, motors_, cylinders_;
  std::vector<std::size_t> of_;
};

/// What the drives do with the parts that they move, by part.
struct Driving {
  std::vector<double> power;  ///< of all of them, W; without what a drum gives that turns its rope out
  std::vector<bool> leads;    ///< one that has a speed, or a signal, moves them
  std::vector<bool> moved;    ///< any drive turns, lengthens or moves there

  Driving(const Together& parts, const machine::Model& m, const Frame& moment)
      : power(parts.size(), 0), leads(parts.size(), false), moved(parts.size(), false) {
    for (std::size_t i = 0; i < moment.drums.size(); ++i) {
      const Frame::Drum& is = moment.drums[i];
      const bool out = is.by_torque && is.speed < 0;
      add(parts.of(parts.drum(i)), is, out ? std::min(is.power, 0.0) : is.power);
    }
    for (std::size_t i = 0; i < moment.motors.size(); ++i)
      add(parts.of(parts.motor(i)), moment.motors[i], moment.motors[i].power);
    for (std::size_t i = 0; i < moment.actuators.size(); ++i) {
      const std::size_t part = parts.of(parts.cylinder(i));
      power[part] += moment.actuators[i].power;
      if (moment.actuators[i].F != 0 && moment.actuators[i].speed != 0) moved[part] = true;
    }
    for (std::size_t b = 0; b < m.bodies.size(); ++b) {
      const Frame::Body& is = moment.bodies[b];
      if (m.bodies[b].driven.empty() || !(is.velocity.squaredNorm() > 0 || is.spin.squaredNorm() > 0)) continue;
      leads[parts.of(b)] = moved[parts.of(b)] = true;
    }
  }

 private:
  void add(std::size_t part, const Frame::Drum& drive, double gives) {
    power[part] += gives;
    if (!drive.by_torque && drive.power > 0) leads[part] = true;
    if (drive.speed != 0) moved[part] = true;
  }
};

bool touches(const machine::Model& m, std::size_t rope, const std::vector<bool>& bodies) {
  const auto& nodes = m.reevings[rope].nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const machine::Node& node) {
    return node.at.body != machine::ground && bodies[as_size(node.at.body)];
  });
}

/// Ropes and the bodies whose weight they bear.
struct Hung {
  std::vector<bool> ropes, bodies;
};

/// No drive of it turns: it bears like one that is fixed at its ends.
bool stands(const machine::Reeving& rope, const Frame& is) {
  return std::all_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& node) {
    return (!node.drum || is.drums[*node.drum].speed == 0) && (!node.motor || is.motors[*node.motor].speed == 0);
  });
}

/// Bodies that `bodies` bear, or are borne by, by faces and as sections of a beam.
void add_neighbours(const machine::Model& m, std::vector<bool>& bodies) {
  for (const machine::FaceContact& contact : m.contacts) {
    const int face = m.faces[contact.face].body;
    if (!moves(m, contact.body) || !moves(m, face)) continue;
    if (bodies[as_size(contact.body)] || bodies[as_size(face)])
      bodies[as_size(contact.body)] = bodies[as_size(face)] = true;
  }
  for (std::size_t a = 0; a < m.bodies.size(); ++a) {
    for (std::size_t b = 0; m.bodies[a].beam && bodies[a] && b < m.bodies.size(); ++b) {
      if (m.bodies[b].beam == m.bodies[a].beam) bodies[b] = true;
    }
  }
}

/// All that hangs on these, also by other ropes that no drive moves.
Hung all_hung(const machine::Model& m, const Frame& is, Hung hung) {
  for (std::vector<bool> before; before != hung.bodies;) {
    before = hung.bodies;
    for (std::size_t r = 0; r < m.reevings.size(); ++r) {
      hung.ropes[r] = hung.ropes[r] || (touches(m, r, hung.bodies) && stands(m.reevings[r], is));
      if (!hung.ropes[r]) continue;
      for (const machine::Node& node : m.reevings[r].nodes) {
        if (moves(m, node.at.body)) hung.bodies[as_size(node.at.body)] = true;
      }
    }
    add_neighbours(m, hung.bodies);
  }
  return hung;
}

Vector3 velocity_of(const Frame& is, const machine::Place& place) {
  if (place.body == machine::ground) return Vector3::Zero();
  const Frame::Body& body = is.bodies[place.body];
  return body.velocity + body.spin.cross(body.orientation * place.at);
}

/// Of the weight of a body and the loads on it, W. A signal that moves it all the way bears them.
double power_of_loads(const machine::Model& m, const Frame& is, int b) {
  const machine::Body& body = m.bodies[b];
  if (body.free.empty()) return 0;
  double power = -body.mass * m.gravity * velocity_of(is, {.body = b, .at = body.centre}).z();
  for (const machine::Load& load : m.loads) {
    if (load.at.body != b) continue;
    const Vector3 force =
        load.over_time ? Vector3(load.force.normalized() * machine::at(*load.over_time, is.t).value) : load.force;
    power += force.dot(velocity_of(is, load.at));
  }
  return power;
}

/// How fast a drum takes in an end of a rope, m/s; each rope by the way in which it is wound.
double taken_in(const machine::Model& m, const Frame& is, int rope, bool at_end) {
  for (const solve::DrumResult& end : solve::drums(m, is)) {
    if (end.reeving == rope && end.at_end == at_end) return end.speed.value_or(0);
  }
  return 0;
}

/// How fast a rope rises where it leaves a node, or, `arrives`, comes to it, m/s.
double rises_at(const machine::Model& m, const Frame& is, const Frame::Branch& branch, bool arrives) {
  const int n = arrives ? branch.to : branch.from;
  const machine::Node& node = m.reevings[branch.reeving].nodes[n];
  double flow = 0;
  if (node.drum) {
    flow = (arrives ? 1 : -1) * taken_in(m, is, branch.reeving, arrives);
  } else {
    const auto contact = std::find_if(is.contacts.begin(), is.contacts.end(), [&](const Frame::Contact& one) {
      return one.reeving == branch.reeving && one.node == n;
    });
    if (contact != is.contacts.end()) flow = contact->flow;
  }
  return velocity_of(is, node.at).z() + flow * (arrives ? branch.arrives : branch.leaves).z();
}

/// What weights and loads give to all that hangs there, less what ropes lose on rounds and points on faces, W.
double power_of_loads(const machine::Model& m, const Frame& is, const Hung& hung) {
  double power = 0;
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (hung.bodies[b]) power += power_of_loads(m, is, static_cast<int>(b));
  }
  for (const Frame::Branch& branch : is.branches) {
    const machine::Reeving& rope = m.reevings[branch.reeving];
    if (!hung.ropes[as_size(branch.reeving)] || rope.weight == 0) continue;
    const double rises = (rises_at(m, is, branch, false) + rises_at(m, is, branch, true)) / 2;
    power -= rope.copies * rope.weight * branch.unstretched * rises;
  }
  for (const Frame::Contact& contact : is.contacts) {
    const machine::Reeving& rope = m.reevings[contact.reeving];
    if (!hung.ropes[as_size(contact.reeving)] || rope.nodes[contact.node].motor) continue;
    power -= rope.copies * std::max((contact.T_in - contact.T_out) * contact.flow, 0.0);
  }
  for (std::size_t i = 0; i < is.faces.size(); ++i) {
    const int point = m.contacts[i].body, face = m.faces[m.contacts[i].face].body;
    const bool in = (point != machine::ground && hung.bodies[as_size(point)]) ||
                    (face != machine::ground && hung.bodies[as_size(face)]);
    if (in) power -= std::max(-is.faces[i].F * is.faces[i].speed, 0.0);
  }
  return power;
}

/// What drives take that act on the same bodies, W.
struct Taken {
  double most = 0, all = 0;  ///< of one, of all of them
  void add(double power) {
    most = std::max(most, -power);
    all += std::max(-power, 0.0);
  }
};

/// The drives of ropes, by drum and by motor.
struct Drives {
  std::vector<bool> drums, motors;

  explicit Drives(const machine::Model& m) : drums(m.drums.size(), false), motors(m.motors.size(), false) {}
  void add(const machine::Reeving& rope) {
    for (const machine::Node& node : rope.nodes) {
      if (node.drum) drums[as_size(*node.drum)] = true;
      if (node.motor) motors[as_size(*node.motor)] = true;
    }
  }
};

Taken taken_by(const Drives& drives, const Frame& is) {
  Taken taken;
  for (std::size_t d = 0; d < drives.drums.size(); ++d) {
    if (drives.drums[d]) taken.add(is.drums[d].power);
  }
  for (std::size_t k = 0; k < drives.motors.size(); ++k) {
    if (drives.motors[k]) taken.add(is.motors[k].power);
  }
  return taken;
}

/// What the pulls of a rope give to the bodies among these on which it is or bends, W.
double power_of_rope(const machine::Model& m, const Frame& is, int rope, const std::vector<bool>& bodies) {
  const machine::Reeving& of = m.reevings[rope];
  const auto given = [&](int n, const Vector3& at, const Vector3& pull) {
    const int b = of.nodes[n].at.body;
    if (b == machine::ground || !bodies[as_size(b)]) return 0.0;
    const Frame::Body& body = is.bodies[b];
    return pull.dot(body.velocity + body.spin.cross(at - body.position));
  };
  double power = 0;
  const auto same = [](const Frame::Branch& a, const Frame::Branch& b) {
    return a.reeving == b.reeving && a.from == b.from && a.to == b.to;
  };
  for (std::size_t i = 0; i < is.branches.size(); ++i) {
    const Frame::Branch& branch = is.branches[i];
    if (branch.reeving != rope) continue;
    // of a rope in segments the first and the last one of a branch are at its nodes
    const bool first = i == 0 || !same(is.branches[i - 1], branch);
    const bool last = i + 1 == is.branches.size() || !same(is.branches[i + 1], branch);
    if (first) power += given(branch.from, branch.start, branch.T_from * branch.leaves);
    if (last) power += given(branch.to, branch.end, -branch.T_to * branch.arrives);
  }
  return of.copies * power;
}

/// Of all that hangs there. The drive of another rope on these bodies may brake the load of that one: it takes from
/// them no more than its rope does.
Taken taken_from(const machine::Model& m, const Frame& is, const Hung& hung) {
  Drives own(m);
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    if (hung.ropes[r]) own.add(m.reevings[r]);
  }
  Taken taken = taken_by(own, is);
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    if (hung.ropes[r] || !touches(m, r, hung.bodies)) continue;
    Drives others(m);
    others.add(m.reevings[r]);
    for (std::size_t d = 0; d < own.drums.size(); ++d) others.drums[d] = others.drums[d] && !own.drums[d];
    for (std::size_t k = 0; k < own.motors.size(); ++k) others.motors[k] = others.motors[k] && !own.motors[k];
    const double by_rope = -power_of_rope(m, is, static_cast<int>(r), hung.bodies);
    taken.add(-std::min(taken_by(others, is).all, std::max(by_rope, 0.0)));
  }
  for (std::size_t i = 0; i < is.actuators.size(); ++i) {
    const int from = m.actuators[i].from_body, to = m.actuators[i].to_body;
    const bool on =
        (from != machine::ground && hung.bodies[as_size(from)]) || (to != machine::ground && hung.bodies[as_size(to)]);
    if (on) taken.add(is.actuators[i].power);
  }
  return taken;
}

/// The ropes of a drum in a moment. One may run off it while another is taken in.
struct OnDrum {
  int ropes = 0;
  double net = 0;         ///< what all of them give it as they turn it, W
  bool runs_out = false;  ///< one that bears something does
  bool falls = false;     ///< one that bears nothing runs off it

  OnDrum(const machine::Model& m, const Frame& is, std::size_t drum) {
    for (const solve::DrumResult& end : solve::drums(m, is)) {
      if (as_size(end.drum) != drum) continue;
      ++ropes;
      const double speed = end.speed.value_or(0);
      net -= m.reevings[end.reeving].copies * end.pull * speed;
      runs_out = runs_out || (end.pull > 0 && speed < 0);
      falls = falls || (!(end.pull > 0) && speed < 0);
    }
  }
};

/// A drum by a torque, or by none, that a load may turn back. A torque that turns a rope out helps a load that does
/// more, and any load where the drum's drag takes less than half of what both give: they speed it up.
bool gives_way(const machine::Drum& drum, const Frame::Drum& is, const OnDrum& on) {
  if (!is.by_torque || is.braked) return false;
  if (is.power < 0) return true;
  if (!on.runs_out || is.torque == 0) return on.runs_out;
  const double omega = is.power / is.torque;
  return on.net > is.power || on.net + is.power > 2 * drum.drag * omega * omega;
}

/// Somewhere in a motion.
bool may_pull(const machine::Model& m, int drum) {
  return m.drums[drum].drive.kind == machine::DriveKind::pull ||
         std::any_of(m.events.begin(), m.events.end(), [&](const machine::Event& e) {
           return e.kind == machine::EventKind::drive && !e.of_motor && e.index == drum &&
                  e.drive.kind == machine::DriveKind::pull;
         });
}

std::string against(double torque, bool back, const Display& display) {
  if (torque == 0) return ", which turns freely: set its brake, or give a drive";
  return fmt::format(" {} its torque of {}", back ? "against" : "along with", display.brief(std::abs(torque), si::N_m));
}

}  // namespace

/// A moment of a motion, and what its loads do to drives.
class Dragged::Moment {
 public:
  Moment(const machine::Model& model, const Frame& frame, const std::string& before)
      : m(model), is(frame), words(fmt::format("{}: at its end, t = {:.4g} s,", before, frame.t)) {}

  template <class Such>
  Hung hung_on_ropes(const Such& such) const {
    Hung hung = nothing();
    for (std::size_t r = 0; r < m.reevings.size(); ++r) {
      const auto& nodes = m.reevings[r].nodes;
      hung.ropes[r] = std::any_of(nodes.begin(), nodes.end(), such);
    }
    return all_hung(m, is, std::move(hung));
  }
  Hung hung_on_rope(int rope) const {
    Hung hung = nothing();
    hung.ropes[as_size(rope)] = true;
    return all_hung(m, is, std::move(hung));
  }
  Hung hung_on_cylinder(std::size_t i) const {
    Hung hung = nothing();
    for (const int body : {m.actuators[i].from_body, m.actuators[i].to_body}) {
      if (moves(m, body)) hung.bodies[as_size(body)] = true;
    }
    return all_hung(m, is, std::move(hung));
  }

  /// Whether other drives work on the same parts: on those of Together::drum(i), say.
  bool is_led(std::size_t (Together::*kind)(std::size_t) const, std::size_t i) const {
    const Together parts(m);
    const Driving by(parts, m, is);
    const std::size_t part = parts.of((parts.*kind)(i));
    return by.power[part] > 0 || by.leads[part];
  }
  bool nothing_drives(int rope) const {
    const Together parts(m);
    return !Driving(parts, m, is).moved[parts.of(parts.rope(as_size(rope)))];
  }

  /// Whether loads give more than drives take, and than `beside`, W, so that they gain speed. Where others lead, their
  /// work may be what is taken: then no single drive takes as much as the loads give.
  bool loads_drag(const Hung& hung, bool led, double beside) const {
    const Taken taken = taken_from(m, is, hung);
    return power_of_loads(m, is, hung) > std::max(beside, led ? taken.most : taken.all);
  }
  /// What they give beside what drives take, W.
  double loads_give(const Hung& hung) const { return power_of_loads(m, is, hung) - taken_from(m, is, hung).all; }
  /// Whether they give more than twice what drives take: most of it speeds them up.
  bool loads_fall(const Hung& hung) const { return power_of_loads(m, is, hung) > 2 * taken_from(m, is, hung).all; }

  const machine::Model& m;
  const Frame& is;
  const std::string words;

 private:
  Hung nothing() const {
    return {.ropes = std::vector<bool>(m.reevings.size(), false), .bodies = std::vector<bool>(m.bodies.size(), false)};
  }
};

void Dragged::take_drums(const Moment& now, std::map<Which, Way>& gives) const {
  for (std::size_t i = 0; i < now.is.drums.size(); ++i) {
    const Frame::Drum& is = now.is.drums[i];
    const auto d = static_cast<int>(i);
    const machine::Drum& drum = now.m.drums[d];
    const auto on = [&](const machine::Node& node) { return node.drum == d; };
    OnDrum ropes(now.m, now.is, i);
    // the pulls of ropes that run in and out swing about each other: what their loads give is steady
    if (ropes.ropes > 1 && ropes.runs_out && is.by_torque)
      ropes.net = std::max(ropes.net, now.loads_give(now.hung_on_ropes(on)));
    const bool by_torque = gives_way(drum, is, ropes);
    const bool by_pull = !is.by_torque && !is.braked && !is.held && is.power < 0 && may_pull(now.m, d);
    const bool slack = is.by_torque && !is.braked && is.power > 0 && ropes.falls;
    if (!by_torque && !by_pull && !slack) continue;
    const bool led = now.is_led(&Together::drum, i), sure = by_torque && !led && ropes.ropes == 1;
    if (!sure && !now.loads_drag(now.hung_on_ropes(on), led, 0)) continue;
    const std::string pull = " against its pull of " + display_.brief(is.T, si::N);
    gives[{by_pull ? Kind::pulling_drum : Kind::drum, d}] = {
        .least = drum.core_radius,
        .speed = is.speed,
        .part = {.kind = PartKind::drum, .name = drum.name},
        .words = fmt::format("{} the load drags '{}' at {}{}", now.words, drum.name,
                             display_.brief(std::abs(is.speed), si::m_per_s),
                             by_pull ? pull : against(is.torque, is.power < 0, display_))};
  }
}

/// A motor that helps its loads counts as dragged where they do more than it.
void Dragged::take_motors(const Moment& now, std::map<Which, Way>& gives) const {
  for (std::size_t i = 0; i < now.is.motors.size(); ++i) {
    const Frame::Drum& is = now.is.motors[i];
    if (!is.by_torque || is.speed == 0) continue;
    const auto k = static_cast<int>(i);
    const auto on = [&](const machine::Node& node) { return node.motor == k; };
    if (!now.loads_drag(now.hung_on_ropes(on), now.is_led(&Together::motor, i), is.power)) continue;
    double radius = 0;
    for (const machine::Reeving& rope : now.m.reevings) {
      const auto node = std::find_if(rope.nodes.begin(), rope.nodes.end(), on);
      if (node != rope.nodes.end()) radius = node->radius;
    }
    const std::string& name = now.m.motors[k].name;
    gives[{Kind::motor, k}] = {.least = radius,
                               .speed = is.speed,
                               .part = {.kind = PartKind::sheave, .name = name},
                               .words = fmt::format("{} the load drags '{}' at {}{}", now.words, name,
                                                    display_.brief(std::abs(is.speed), si::m_per_s),
                                                    against(is.torque, is.power < 0, display_))};
  }
}

void Dragged::take_cylinders(const Moment& now, std::map<Which, Way>& gives) const {
  for (std::size_t i = 0; i < now.is.actuators.size(); ++i) {
    const Frame::Actuator& is = now.is.actuators[i];
    const machine::Actuator& cylinder = now.m.actuators[i];
    const bool bears = is.F != 0;
    if (is.speed == 0 || (bears && (cylinder.kind == machine::ActuatorKind::speed || is.power >= 0))) continue;
    const Hung hung = now.hung_on_cylinder(i);
    if (!(bears ? now.loads_drag(hung, now.is_led(&Together::cylinder, i), 0) : now.loads_fall(hung))) continue;
    const std::string holds =
        bears ? " against its force of " + display_.brief(std::abs(is.F), si::N) : ", which moves freely";
    gives[{Kind::cylinder, static_cast<int>(i)}] = {
        .least = least_share * is.length,
        .speed = is.speed,
        .part = {.kind = PartKind::cylinder, .name = cylinder.name},
        .words = fmt::format("{} the load drags '{}' at {}{}", now.words, cylinder.name,
                             display_.brief(std::abs(is.speed), si::m_per_s), holds)};
  }
}

/// Of a rope without drives, on which no drive works: loads fall on it, and the friction of a support does not hold
/// them. What runs over sheaves alone is meant to.
void Dragged::take_supports(const Moment& now, std::map<Which, Way>& gives) const {
  for (std::size_t c = 0; c < now.is.contacts.size(); ++c) {
    const Frame::Contact& is = now.is.contacts[c];
    const machine::Reeving& rope = now.m.reevings[is.reeving];
    const machine::Node& node = rope.nodes[is.node];
    const bool slips = is.state == solve::ContactState::slipping && machine::is_saddle(node) && node.law.friction > 0;
    if (!slips || !now.nothing_drives(is.reeving)) continue;
    const bool falls = std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& on) {
      if (!moves(now.m, on.at.body)) return false;
      const Frame::Body& body = now.is.bodies[on.at.body];
      return body.velocity.z() < 0 && body.acceleration.z() < 0;
    });
    if (!falls || !(power_of_loads(now.m, now.is, now.hung_on_rope(is.reeving)) > 0)) continue;
    gives[{Kind::support, static_cast<int>(c)}] = {
        .least = node.radius,
        .speed = is.flow,
        .part = part_at(now.m, node),
        .words = fmt::format("{} '{}' slips over '{}' at {}, and its load falls: the friction does not hold it",
                             now.words, rope.name, node.name, display_.brief(std::abs(is.flow), si::m_per_s))};
  }
}

void Dragged::take_moment(const machine::Model& m, const Frame& moment, double time, const std::string& words) {
  std::map<Which, Way> gives;
  const Moment now(m, moment, words);
  take_drums(now, gives);
  take_motors(now, gives);
  take_cylinders(now, gives);
  take_supports(now, gives);
  for (auto& [which, way] : gives) {
    const auto before = ways_.find(which);
    way.way = (before == ways_.end() ? 0 : before->second.way) + std::abs(way.speed) * std::max(time, 0.0);
  }
  ways_ = std::move(gives);
}

/// Whether its drive is, when the motion ends, one that can give way. A frame does not tell a pull from a speed, nor
/// the mode of a cylinder.
bool Dragged::still_so(const machine::Model& m, const solve::DynamicState& end, const Which& which, double speed) {
  const auto& [kind, i] = which;
  if (end.bodies.empty()) return true;  // it has none: the motion was given up
  if (kind == Kind::pulling_drum) {
    const machine::Drive& drive = end.drum_drive[i];
    return drive.kind == machine::DriveKind::pull && !drive.brake;
  }
  if (kind != Kind::cylinder) return true;
  const machine::ActuatorMode mode = end.actuator_mode[i];
  if (mode == machine::ActuatorMode::free) return true;
  const machine::Actuator& cylinder = m.actuators[i];
  if (mode == machine::ActuatorMode::lock || cylinder.kind == machine::ActuatorKind::speed) return false;
  // a law gives way to go the way of its reference
  const double sense = mode == machine::ActuatorMode::retract ? -1 : 1;
  return cylinder.kind == machine::ActuatorKind::force ||
         speed * sense * machine::at(cylinder.signal, end.t).value <= 0;
}

std::map<Part, std::string> Dragged::at_end(const machine::Model& m, const solve::TransientResult& motion) {
  std::map<Part, std::string> told;
  for (const auto& [which, way] : ways_) {
    if (way.way >= way.least && still_so(m, motion.state, which, way.speed)) told.try_emplace(way.part, way.words);
  }
  ways_.clear();
  return told;
}

}  // namespace taut::checks
