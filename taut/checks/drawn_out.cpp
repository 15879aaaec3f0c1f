#include "taut/checks/drawn_out.hpp"

#include <cstddef>
#include <numeric>

#include "taut/math/index.hpp"

namespace taut::checks {
namespace {

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

  std::size_t drum(std::size_t i) const { return drums_ + i; }
  std::size_t motor(std::size_t i) const { return motors_ + i; }
  std::size_t cylinder(std::size_t i) const { return cylinders_ + i; }
  std::size_t size() const { return of_.size(); }

  std::size_t of(std::size_t part) const {
    while (of_[part] != part) part = of_[part];
    return part;
  }

 private:
  static bool moves(const machine::Model& m, int body) {
    return body != machine::ground && !machine::stands_fast(m.bodies[body]);
  }
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
  std::vector<double> power;  ///< of all of them, W
  std::vector<bool> leads;    ///< one that has a speed, or a signal, moves them

  Driving(const Together& parts, const solve::TransientFrame& moment)
      : power(parts.size(), 0), leads(parts.size(), false) {
    for (std::size_t i = 0; i < moment.drums.size(); ++i) add(parts.of(parts.drum(i)), moment.drums[i]);
    for (std::size_t i = 0; i < moment.motors.size(); ++i) add(parts.of(parts.motor(i)), moment.motors[i]);
    for (std::size_t i = 0; i < moment.actuators.size(); ++i)
      power[parts.of(parts.cylinder(i))] += moment.actuators[i].power;
  }

 private:
  void add(std::size_t part, const solve::TransientFrame::Drum& drive) {
    power[part] += drive.power;
    if (!drive.by_torque && drive.power > 0) leads[part] = true;
  }
};

bool moves_by_signal(const machine::Body& body, const solve::TransientFrame::Body& is) {
  return !body.driven.empty() && (is.velocity.squaredNorm() > 0 || is.spin.squaredNorm() > 0);
}

}  // namespace

std::vector<bool> drawn_out(const machine::Model& model, const solve::TransientFrame& moment) {
  const Together parts(model);
  Driving by(parts, moment);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (moves_by_signal(model.bodies[b], moment.bodies[b])) by.leads[parts.of(b)] = true;
  }
  std::vector<bool> drawn;
  for (std::size_t d = 0; d < model.drums.size(); ++d) {
    const std::size_t all = parts.of(parts.drum(d));
    drawn.push_back(by.power[all] > 0 || by.leads[all]);
  }
  return drawn;
}

}  // namespace taut::checks
