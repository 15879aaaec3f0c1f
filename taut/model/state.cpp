#include "taut/model/state.hpp"

#include "taut/base/expects.hpp"

namespace taut::model {

Vector3 in_ground(const State& state, const Place& place) {
  if (place.body == ground) return place.at;
  const Pose& pose = state.bodies.at(static_cast<std::size_t>(place.body));
  return pose.position + pose.orientation * place.at;
}

State initial_state(const Model& model) {
  State state;
  for (const Body& body : model.bodies) state.bodies.push_back({body.position, body.orientation});
  for (const Reeving& rope : model.reevings) {
    expects(rope.nodes.size() >= 2, "a rope runs from somewhere to somewhere");
    state.touched.emplace_back(rope.nodes.size(), true);
    std::vector<BranchState> branches(static_cast<std::size_t>(branch_count(rope)));
    double total = 0;
    for (std::size_t k = 0; k < branches.size(); ++k) {
      const Vector3 from = in_ground(state, rope.nodes[k].at);
      const Vector3 to = in_ground(state, rope.nodes[(k + 1) % rope.nodes.size()].at);
      branches[k].length = (to - from).norm();
      total += branches[k].length;
    }
    const double scale = rope.given == Given::length && total > 0 ? rope.value * (1 + rope.thermal_strain) / total : 1;
    for (BranchState& branch : branches) branch.length *= scale;
    state.branches.push_back(std::move(branches));
  }
  return state;
}

}  // namespace taut::model
