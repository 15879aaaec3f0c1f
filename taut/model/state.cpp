#include "taut/model/state.hpp"

#include "taut/base/expects.hpp"
#include "taut/rope/tangent.hpp"

namespace taut::model {

Vector3 in_ground(const State& state, const Place& place) {
  if (place.body == ground) return place.at;
  const Pose& pose = state.bodies.at(static_cast<std::size_t>(place.body));
  return pose.position + pose.orientation * place.at;
}

namespace {

rope::Round round_at(const State& state, const Node& node) {
  const Vector3 centre = in_ground(state, node.at);
  if (node.radius == 0) return rope::point(centre);
  const bool moves = node.at.body != ground;
  const Matrix3 turned =
      moves ? state.bodies[static_cast<std::size_t>(node.at.body)].orientation : Matrix3(Matrix3::Identity());
  return rope::sheave(centre, turned * node.axis, node.radius, node.side);
}

/// A straight branch: its length, and its directions as angles on its rounds.
rope::TangentLine line_between(const State& state, const Node& from, const Node& to) {
  const rope::Round a = round_at(state, from), b = round_at(state, to);
  if (const auto line = rope::tangent_line(a, b)) return *line;
  rope::TangentLine centres;
  centres.length = (b.centre - a.centre).norm();
  return centres;
}

}  // namespace

double straight_length(const State& state, const Node& from, const Node& to) {
  return line_between(state, from, to).length;
}

State initial_state(const Model& model) {
  State state;
  for (const Body& body : model.bodies) state.bodies.push_back({body.position, body.orientation});
  for (const Reeving& reeving : model.reevings) {
    expects(reeving.nodes.size() >= 2, "a rope runs from somewhere to somewhere");
    state.touched.emplace_back(reeving.nodes.size(), true);
    const auto count = static_cast<std::size_t>(branch_count(reeving));
    std::vector<rope::TangentLine> lines;
    double straight = 0, arcs = 0;
    for (std::size_t k = 0; k < count; ++k) {
      lines.push_back(line_between(state, reeving.nodes[k], reeving.nodes[(k + 1) % reeving.nodes.size()]));
      straight += lines.back().length;
    }
    for (std::size_t k = reeving.closed ? 0 : 1; k < count; ++k) {
      const Node& node = reeving.nodes[k];
      arcs += node.radius *
              rope::wrap_angle(node.side, lines[(k + count - 1) % count].angle_to, lines[k].angle_from, node.turns);
    }
    const double left = reeving.value * (1 + reeving.thermal_strain) - arcs;
    const double scale = reeving.given == Given::length && straight > 0 && left > 0 ? left / straight : 1;
    std::vector<BranchState> branches(count);
    for (std::size_t k = 0; k < count; ++k) branches[k].length = scale * lines[k].length;
    state.branches.push_back(std::move(branches));
  }
  return state;
}

}  // namespace taut::model
