#pragma once
#include <Eigen/Geometry>
#include <random>

#include "taut/solve/motion/transient.hpp"
#include "test/support/machines.hpp"

/// Machines by chance: one to four ropes over up to three sheaves, saddles or blocks each, on one to four bodies that
/// shift, turn or swing; drums with drives and brakes, tensioners, ropes in segments, breaks. The same seed gives the
/// same machine everywhere. Places are such that a straight rope goes from each round to the next.
namespace taut_test {

class RandomMachine {
 public:
  explicit RandomMachine(unsigned seed) : random_(seed) {}

  machine::Model machine() {
    m_.gravity = 9.81;
    const int ropes = 1 + pick(4), bodies = 1 + pick(ropes);
    for (int b = 0; b < bodies; ++b) add_body(b);
    for (int r = 0; r < ropes; ++r) add_rope(r);
    if (pick(2) == 0) add_break(pick(ropes));
    if (ropes > 1 && pick(4) == 0) add_break(pick(ropes));
    return std::move(m_);
  }

  taut::solve::TransientOptions options() {
    taut::solve::TransientOptions o;
    o.duration = 2;
    o.output_step = 0.02;
    o.tolerance = 1e-3;
    // a drum that pulls as it likes has no equilibrium
    const bool settles = pick(3) == 0 && !pulled_;
    o.start = settles ? taut::solve::Start::settled : taut::solve::Start::assembled;
    return o;
  }

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 5U) / static_cast<double>(1U << 27U));
  }
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  /// Bodies hang side by side, 6 m apart.
  void add_body(int b) {
    static constexpr const char* ways[] = {"z", "xz", "xyz", "xzY", "xyzXYZ"};
    machine::Body one =
        body("body " + std::to_string(b), {6.0 * b, 0, between(-4, 0)}, between(20, 2000), ways[pick(5)]);
    const double size = between(0.3, 1);
    one.inertia = one.mass * size * size * Vector3(0.8, 1, 1.2);
    if (pick(3) == 0) one.centre = {0, 0, -between(0, 0.5)};
    m_.bodies.push_back(one);
  }

  machine::Signal ramp(double to) {
    machine::Signal signal;
    signal.law = machine::Moves{0, {{between(0, 1), to, between(0.1, 1), machine::Change::smooth}}};
    return signal;
  }

  /// A round or point over which the rope turns between two others.
  machine::Node turn_at(const std::string& name, const Vector3& at, int on) {
    machine::Node node = over(name, at, on);
    if (pick(3) > 0) node.radius = between(0.1, 0.4);
    switch (pick(6)) {
      case 0:  // saddle or locked
        node.law = {between(0, 0.4), 0};
        break;
      case 1:
        node.law = {between(0.05, 0.5), between(0.9, 1)};
        break;
      case 2:
        node.law.efficiency = between(0.9, 1);
        break;
      case 3:
        node.law.efficiency = between(0.9, 1);
        if (node.radius > 0) node.inertia = between(0.01, 20);
        if (node.radius > 0 && pick(2) == 0) node.law.friction = between(0.05, 0.5);
        break;
      default:
        break;
    }
    return node;
  }

  Vector3 ground_of(const machine::Place& place) const {
    return place.body < 0 ? place.at : Vector3(m_.bodies[static_cast<std::size_t>(place.body)].position + place.at);
  }

  double weight_of_all() const {
    double mass = 0;
    for (const machine::Body& one : m_.bodies) mass += one.mass;
    return mass * m_.gravity / static_cast<double>(m_.bodies.size());
  }

  void add_drum(machine::Node& node, int turns_to) {
    node.radius = between(0.15, 0.5);
    node.side = turns_to;
    node.drum = static_cast<int>(m_.drums.size());
    machine::Drum drum;
    drum.name = node.name;
    drum.core_radius = node.radius - 0.01;
    drum.inertia = pick(2) == 0 ? 0 : between(1, 100);
    switch (pick(5)) {
      case 0:
        drum.drive.kind = machine::DriveKind::speed;
        drum.drive.signal = ramp(between(-0.5, 0.5));
        break;
      case 1:
        drum.drive.kind = machine::DriveKind::pull;
        pulled_ = true;
        drum.drive.signal = ramp(between(0.5, 1.5) * weight_of_all() / 4);
        break;
      case 2:
        drum.drive.kind = machine::DriveKind::torque;
        pulled_ = true;
        drum.drive.signal = ramp(between(0.5, 1.5) * weight_of_all() / 4 * node.radius);
        break;
      default:
        break;
    }
    if (pick(4) == 0) {
      machine::Event brake;
      brake.words = "brake";
      brake.kind = machine::EventKind::brake;
      brake.at = between(0.2, 1.8);
      brake.index = *node.drum;
      m_.events.push_back(brake);
    }
    m_.drums.push_back(drum);
  }

  /// Rope r holds body r: by its end, or by a block; its other end is a pin, or holds the next body too.
  void add_rope(int r) {
    const int bodies = static_cast<int>(m_.bodies.size()), on = std::min(r, bodies - 1);
    const std::string name = "rope " + std::to_string(r);
    const double x = m_.bodies[static_cast<std::size_t>(on)].position.x(), y = 0.2 * (r % 3);
    const auto block = [&](int k, double aside) {
      return turn_at(name + " block " + std::to_string(k), {aside, y, between(0, 0.3)}, on);
    };
    const auto above = [&](int k, double at_x) {
      return turn_at(name + " head " + std::to_string(k), {at_x, y, between(5, 9)}, machine::ground);
    };
    std::vector<machine::Node> path = {anchor(name + " start", {x - between(1.5, 3), y, between(4, 9)})};
    double falls = 1;
    switch (pick(5)) {
      case 0:  // the body at the end
        break;
      case 1:
        path.push_back(above(0, x - between(-0.2, 0.2)));
        break;
      case 2:
        path.push_back(above(0, x - 1));
        path.push_back(above(1, x + 0.5));
        break;
      case 3:  // a block
        path = {anchor(name + " start", {x - between(0.7, 1), y, between(4, 9)}), block(0, 0)};
        falls = 2;
        break;
      default:  // two blocks, three falls or four
        path = {anchor(name + " start", {x - between(1.7, 2), y, between(5, 9)}), block(0, -1), above(0, x),
                block(1, 1)};
        falls = 4;
        break;
    }
    if (falls > 1) {
      const bool next = pick(3) == 0 && on + 1 < bodies;
      path.push_back(above(1, next ? x + 4 : x + 2));
      path.push_back(next ? anchor_on(name + " end", on + 1, {-0.2, y, 0.1})
                          : anchor(name + " end", {x + between(3, 4), y, between(4, 9)}));
    } else {
      path.push_back(anchor_on(name + " end", on, {between(-0.2, 0.2), y, between(0, 0.3)}));
    }
    set_sides(path);
    if (pick(3) == 0) add_drum(path.front(), path.size() % 2 == 0 ? 1 : -1);
    finish(name, std::move(path), m_.bodies[static_cast<std::size_t>(on)].mass * m_.gravity / falls);
  }

  /// Each round on the inner side of its corner.
  void set_sides(std::vector<machine::Node>& path) const {
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      const Vector3 here = ground_of(path[k].at);
      const Vector3 in = here - ground_of(path[k - 1].at), out = ground_of(path[k + 1].at) - here;
      path[k].side = in.cross(out).y() > 0 ? 1 : -1;
    }
  }

  /// `carries`: what it would in equilibrium, about, N.
  void finish(const std::string& name, std::vector<machine::Node> path, double carries) {
    const int index = static_cast<int>(m_.reevings.size());
    const bool drum = path.front().drum.has_value();
    machine::Reeving rope = reeve(name, std::move(path), 0, pick(2) == 0 ? 0 : between(1, 40), between(1e5, 2e7));
    rope.given = machine::Given::tension_at_start;
    rope.value = pick(4) == 0 ? 0 : between(0.3, 2) * carries;
    if (pick(2) == 0) rope.damping_ratio = between(0, 0.3);
    if (pick(4) == 0) rope.copies = 2;
    if (rope.weight > 0 && pick(4) == 0) rope.segments = 2 + pick(5);
    if (!drum && pick(5) == 0) {
      machine::Tensioner tensioner;
      tensioner.reeving = index;
      tensioner.change = ramp(between(-0.3, 0.3));
      m_.tensioners.push_back(tensioner);
    }
    m_.reevings.push_back(std::move(rope));
  }

  void add_break(int reeving) {
    machine::Event event;
    event.words = "break";
    event.kind = machine::EventKind::breaks;
    event.at = between(0.1, 1.9);
    event.index = reeving;
    event.over = pick(3) == 0 ? between(1e-3, 0.05) : 0;
    m_.events.push_back(event);
  }

  machine::Model m_;
  bool pulled_ = false;
  std::mt19937 random_;
};

}  // namespace taut_test
