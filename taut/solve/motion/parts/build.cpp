#include "taut/solve/motion/parts/build.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/bend.hpp"
#include "taut/mechanics/system.hpp"
#include "taut/solve/motion/parts/along.hpp"
#include "taut/solve/motion/parts/chain_load.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/parts/rope_load.hpp"

namespace taut::solve::dynamics {
namespace {

int count(std::size_t n) { return static_cast<int>(n); }

bool is_load(const machine::Reeving& rope, int node) { return rope.nodes[node].kind == machine::NodeKind::load; }

/// A direction square to the axis.
Vector3 normal_to(const Vector3& axis) { return axis.unitOrthogonal(); }

class Builder {
 public:
  Builder(const machine::Model& model, const DynamicState& start, const TransientOptions& options)
      : model_(model), start_(start), options_(options) {
    built_.mechanism.model = &model;
  }

  Built run() {
    add_bodies();
    for (int r = 0; r < count(model_.reevings.size()); ++r) add_rope(r);
    add_contacts();
    add_chain_loads(m(), options_.method);
    add_spins();
    list_chains();
    number();
    add_couples(m());
    list_places();
    classify(built_.mechanism, options_.arcs);
    lump_masses(m(), start_);
    mark_ropes_along(m(), start_);
    fill_values(start_, built_);
    measure_loaded_spans(built_.mechanism, start_);
    if (built_.outcome.ok()) built_.outcome = check(built_.mechanism, start_, built_.values);
    return std::move(built_);
  }

 private:
  Mechanism& m() { return built_.mechanism; }

  void add_bodies() {
    for (int b = 0; b < count(model_.bodies.size()); ++b) {
      const machine::Body& given = model_.bodies[b];
      Body body;
      body.model = b;
      body.count = given.of_rope ? 0 : count(given.free.size());
      expects(body.count <= 6, "a body has six freedoms at most");
      for (std::size_t f = 0; f < as_size(body.count); ++f) {
        body.along[f] = given.free[f].along;
        body.about[f] = given.free[f].about;
        body.turns = body.turns || given.free[f].about != Vector3::Zero();
      }
      body.own_mass = given.mass;
      body.own_centre = given.centre;
      mark_point(body);
      m().bodies.push_back(body);
    }
  }

  static void mark_point(Body& body) {
    body.point = body.count == 3 && !body.turns && body.along[0] == Vector3::UnitX() &&
                 body.along[1] == Vector3::UnitY() && body.along[2] == Vector3::UnitZ();
  }

  int add_inner_node() {
    Body body;
    body.count = 3;
    body.along = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    body.about.fill(Vector3::Zero());
    body.point = true;
    m().bodies.push_back(body);
    return count(m().bodies.size()) - 1;
  }

  Line line_between(int r, int from, int to) const {
    const machine::Reeving& rope = model_.reevings[r];
    Line line;
    line.reeving = r;
    line.from = from;
    line.to = to;
    line.stiffness = rope.stiffness;
    line.damping = start_.damping_time.empty() ? rope.damping_time : start_.damping_time[r];
    line.copies = rope.copies;
    if (options_.rope_mass) {
      line.weight = rope.weight / (1 + rope.thermal_strain);
      // without gravity a rope weighs nothing, its mass stays
      line.mass = rope.weight > 0 ? line.weight / model_.gravity : rope.mass / (1 + rope.thermal_strain);
    }
    for (const std::size_t end : {0U, 1U}) {
      // beyond loads, whose parts have both ends of the whole free line
      const machine::Node& node = rope.nodes[line_end(rope, end == 0 ? from : to, end)];
      line.body[end] = node.at.body;
      line.place[end] = node.at.at;
      line.axis[end] = node.axis;
      line.zero[end] = normal_to(node.axis);
      line.radius[end] = node.radius;
      line.side[end] = node.side;
    }
    set_part(built_.mechanism, rope, line);
    return line;
  }

  void add_rope(int r) {
    const machine::Reeving& rope = model_.reevings[r];
    const int nodes = count(rope.nodes.size()), branches = machine::branch_count(rope);
    const int first = count(m().lines.size());
    m().inside.emplace_back();
    for (int k = 0; k < branches; ++k) {
      const Line whole = line_between(r, k, (k + 1) % nodes);
      const int pieces = std::max(1, rope.segments);
      for (int s = 0; s < pieces; ++s) {
        Line line = whole;
        if (pieces > 1) line.segment = s;
        if (s > 0 || (pieces > 1 && is_load(rope, k))) {  // a chain runs through its loads
          line.body[0] = m().inside.back().back();
          line.place[0].setZero();
          line.radius[0] = 0;
          line.inner[0] = true;
        }
        if (s + 1 < pieces || (pieces > 1 && is_load(rope, (k + 1) % nodes))) {
          m().inside.back().push_back(add_inner_node());
          line.body[1] = m().inside.back().back();
          line.place[1].setZero();
          line.radius[1] = 0;
          line.inner[1] = true;
        }
        set_kind(line);
        mark_sagging(line, k);
        m().lines.push_back(line);
      }
    }
    m().first_line.emplace_back(first, count(m().lines.size()) - first);
  }

  /// Whether a body, if it turns at all, turns about this direction only.
  bool keeps(int body, const Vector3& axis) const {
    if (body < 0) return true;
    const Body& shape = built_.mechanism.bodies[body];
    for (int f = 0; f < shape.count; ++f) {
      if (shape.about[as_size(f)].cross(axis).norm() > 1e-12) return false;
    }
    if (shape.model < 0) return true;
    const auto& driven = model_.bodies[shape.model].driven;
    return std::all_of(driven.begin(), driven.end(),
                       [&](const auto& way) { return way.about.cross(axis).norm() <= 1e-12; });
  }

  Vector3 axis_in_ground(const Line& line, std::size_t end) const {
    const int body = line.body[end];
    return body < 0 ? line.axis[end] : Vector3(start_.bodies[body].orientation * line.axis[end]);
  }

  void set_kind(Line& line) const {
    const bool first = line.radius[0] > 0, second = line.radius[1] > 0;
    if (!first && !second) return;
    const Vector3 axis = axis_in_ground(line, first ? 0 : 1);
    const bool parallel = !first || !second || axis.cross(axis_in_ground(line, 1)).norm() < 1e-12;
    const bool stays = (!first || keeps(line.body[0], axis)) && (!second || keeps(line.body[1], axis));
    line.kind = parallel && stays ? LineKind::planar : LineKind::skew;
  }

  /// Branches that hang as catenaries: with weight, in one piece, without a load on their way.
  void mark_sagging(Line& line, int branch) {
    if (options_.branches == Branches::straight || line.segment >= 0 || line.part || !(line.weight > 0)) return;
    const double length = start_.ropes[line.reeving].length[branch];
    const bool all = options_.branches == Branches::catenary;
    if (all || sags_by_weight(line, start_, branch, length, options_.light)) line.sag = m().sagging++;
  }

  /// A node between two branches, or a drum at an end.
  void add_contact(int r, int node, int in, int out) {
    const machine::Reeving& rope = model_.reevings[r];
    const machine::Node& given = rope.nodes[node];
    Contact contact;
    contact.reeving = r;
    contact.node = node;
    contact.in = in;
    contact.out = out;
    contact.body = given.at.body;
    contact.radius = given.radius;
    contact.friction = given.law.friction;
    contact.efficiency = given.law.efficiency;
    contact.round = given.radius > 0;
    contact.driven = given.motor.has_value();
    if (given.motor && model_.motors[*given.motor].working_arc)
      contact.working_arc = *model_.motors[*given.motor].working_arc;
    contact.support = given.support;
    contact.copies = rope.copies;
    contact.drum = given.drum.value_or(-1);
    if (given.drum) contact.on_drum = m().on_drums++;
    if (options_.rope_mass) contact.mass = m().lines[in >= 0 ? in : out].mass;
    const int index = count(m().contacts.size());
    if (in >= 0) m().lines[in].contact[1] = index;
    if (out >= 0) m().lines[out].contact[0] = index;
    m().contacts.push_back(contact);
  }

  void add_contacts() {
    for (int r = 0; r < count(model_.reevings.size()); ++r) {
      const machine::Reeving& rope = model_.reevings[r];
      const auto [first, lines] = m().first_line[r];
      const int per_branch = std::max(1, rope.segments), nodes = count(rope.nodes.size());
      for (int k = 0; k < nodes; ++k) {
        const machine::Node& node = rope.nodes[k];
        const bool end = !rope.closed && (k == 0 || k == nodes - 1);
        if (node.kind == machine::NodeKind::clamp || (end && !node.drum)) continue;
        if (rope.segments > 1 && node.kind == machine::NodeKind::load) continue;
        const int out = end && k > 0 ? -1 : first + k * per_branch;
        const int in = end && k == 0 ? -1 : first + (k > 0 ? k * per_branch : lines) - 1;
        add_contact(r, k, in, out);
      }
    }
    for (const machine::Tensioner& tensioner : model_.tensioners) {
      const auto [first, lines] = m().first_line[tensioner.reeving];
      m().tensioner.emplace_back(tensioner.at_start ? first : first + lines - 1, tensioner.at_start ? 0 : 1);
    }
  }

  void add_spins() {
    Array<int> of_drum(model_.drums.size(), -1);
    std::map<int, int> of_wheel;
    for (int i = 0; i < count(m().contacts.size()); ++i) {
      Contact& contact = m().contacts[i];
      const machine::Node& node = model_.reevings[contact.reeving].nodes[contact.node];
      const double along = node.side;
      Spin spin;
      spin.body = contact.body;
      spin.motor = node.motor.value_or(-1);
      if (node.drum) {
        contact.sense = contact.in < 0 ? -1 : 1;  // taking in
        int& known = of_drum[*node.drum];
        if (known < 0) {
          known = count(m().spins.size());
          spin.axis = contact.sense * along * node.axis;
          spin.inertia = model_.drums[*node.drum].inertia;
          spin.drag = model_.drums[*node.drum].drag;
          spin.drum = *node.drum;
          m().spins.push_back(spin);
        }
        // wound the other way than the first one, it is let out where that is taken in
        if ((contact.sense * along * node.axis).dot(m().spins[known].axis) < 0) contact.sense = -contact.sense;
        contact.spin = known;
      } else if (node.motor || (node.inertia > 0 && node.law.efficiency > 0 && !options_.quasi_static)) {
        contact.spin = count(m().spins.size());
        if (node.wheel) contact.spin = of_wheel.try_emplace(*node.wheel, contact.spin).first->second;
        spin.axis = along * node.axis;
        const double wheels = node.wheel ? 1 : contact.copies;
        spin.inertia = wheels * node.inertia;
        spin.drag = wheels * node.drag;
        if (contact.spin == count(m().spins.size())) m().spins.push_back(spin);
        // a rope that runs over it the other way than the first one
        if (spin.axis.dot(m().spins[contact.spin].axis) < 0) contact.sense = -1;
      }
      if (contact.spin >= 0) m().spins[contact.spin].contacts.emplace_back(i, contact.sense);
    }
  }

  /// Where rope runs on or off at an end.
  void list_chains() {
    for (const auto& [first, lines] : m().first_line) {
      Array<Chain> of_rope;
      for (int i = first; i < first + lines; ++i) {
        const Line& line = m().lines[i];
        const bool goes_on = i > first && line.body[0] >= 0 && m().bodies[line.body[0]].model < 0;
        if (!goes_on) of_rope.push_back({i, 0});
        ++of_rope.back().count;
      }
      const auto tensioned = [&](int line) {
        return std::any_of(m().tensioner.begin(), m().tensioner.end(), [&](const auto& t) { return t.first == line; });
      };
      for (const Chain& chain : of_rope) {
        const int last = chain.first + chain.count - 1;
        const bool runs = m().lines[chain.first].contact[0] >= 0 || m().lines[last].contact[1] >= 0;
        if (chain.count > 1 && (runs || tensioned(chain.first) || tensioned(last))) m().chains.push_back(chain);
      }
    }
  }

  void number();
  void list_places();

  const machine::Model& model_;
  const DynamicState& start_;
  const TransientOptions& options_;
  Built built_;
};

void Builder::number() {
  Mechanism& m = built_.mechanism;
  for (Body& body : m.bodies) {
    body.first = m.size;
    m.size += body.count;
  }
  for (Contact& contact : m.contacts) contact.column = m.size++;
  for (Spin& spin : m.spins) spin.column = m.size++;
  for (Line& line : m.lines) {
    for (const std::size_t end : {0U, 1U}) {
      if (line.body[end] < 0) continue;
      const Body& body = m.bodies[line.body[end]];
      line.freedoms[end] = body.count;
      for (int f = 0; f < body.count; ++f) line.column[as_size(line.columns++)] = body.first + f;
    }
    for (const std::size_t end : {0U, 1U}) {
      if (line.contact[end] < 0) continue;
      line.flow[end] = line.columns;
      line.column[as_size(line.columns++)] = m.contacts[line.contact[end]].column;
    }
    const auto point = [&](std::size_t end) { return line.body[end] >= 0 && m.bodies[line.body[end]].point; };
    line.between_points = line.sag < 0 && line.kind == LineKind::points && line.columns == 6 && point(0) && point(1);
  }
  for (Contact& contact : m.contacts) {
    for (const int i : {contact.in, contact.out}) {
      if (i < 0) continue;
      const Line& line = m.lines[i];
      contact.columns.insert(contact.columns.end(), line.column.begin(), line.column.begin() + line.columns);
    }
    contact.columns.push_back(contact.column);
    if (contact.spin >= 0) contact.columns.push_back(m.spins[contact.spin].column);
  }
}

void Builder::list_places() {
  Mechanism& m = built_.mechanism;
  Array<Array<int>> cliques, of_body, of_spin;
  for (const Body& body : m.bodies) {
    of_body.emplace_back();
    for (int f = 0; f < body.count; ++f) of_body.back().push_back(body.first + f);
  }
  for (const Spin& spin : m.spins) {
    of_spin.push_back({spin.column});
    if (spin.body < 0) continue;
    const auto& freedoms = of_body[spin.body];
    of_spin.back().insert(of_spin.back().end(), freedoms.begin(), freedoms.end());
  }
  cliques = of_body;
  cliques.insert(cliques.end(), of_spin.begin(), of_spin.end());
  for (const Line& line : m.lines) cliques.emplace_back(line.column.begin(), line.column.begin() + line.columns);
  for (const Couple& couple : m.couples) {
    cliques.emplace_back(couple.column.begin(), couple.column.begin() + couple.freedoms[0] + couple.freedoms[1]);
  }
  for (const Contact& contact : m.contacts) {
    for (const int c : contact.columns) {
      if (c != contact.column) cliques.push_back({contact.column, c});
      if (contact.spin >= 0 && c != m.spins[contact.spin].column) {
        cliques.push_back({m.spins[contact.spin].column, c});
      }
    }
  }
  m.solver = StaticLu(m.size, cliques);
  const auto square = [&](const auto& columns, std::size_t n, Array<int>& places) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) places.push_back(m.solver.place(columns[i], columns[j]));
    }
  };
  for (const auto& columns : of_body) {
    m.body_place_first.push_back(count(m.body_places.size()));
    square(columns, columns.size(), m.body_places);
  }
  for (const auto& columns : of_spin) {
    m.spin_place_first.push_back(count(m.spin_places.size()));
    square(columns, columns.size(), m.spin_places);
  }
  for (Line& line : m.lines) square(line.column, as_size(line.columns), line.places);
  for (Couple& couple : m.couples) {
    square(couple.column, as_size(couple.freedoms[0] + couple.freedoms[1]), couple.places);
  }
  for (Contact& contact : m.contacts) {
    for (const int c : contact.columns) {
      contact.row.push_back(m.solver.place(contact.column, c));
      if (contact.spin >= 0) contact.spin_row.push_back(m.solver.place(m.spins[contact.spin].column, c));
    }
  }
}

}  // namespace

Built build(const machine::Model& model, const DynamicState& start, const TransientOptions& options) {
  return Builder(model, start, options).run();
}

}  // namespace taut::solve::dynamics
