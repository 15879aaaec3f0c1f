#include "taut/solve/rest/sides.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::solve {
namespace {

using Sides = Array<Array<int>>;

constexpr double hardly_bent = 1e-9;  ///< rad

Sides sides_of(const machine::Model& model) {
  Sides sides;
  for (const machine::Reeving& rope : model.reevings) {
    Array<int>& own = sides.emplace_back();
    for (const machine::Node& node : rope.nodes) own.push_back(node.side);
  }
  return sides;
}

/// The free rope that arrives at a contact, and the one that leaves it.
struct RopeAtContact {
  const BranchResult *before = nullptr, *after = nullptr;
};

RopeAtContact passing_rope(const EquilibriumResult& result, const ContactResult& contact) {
  RopeAtContact b;
  for (const BranchResult& branch : result.branches) {
    if (branch.reeving != contact.reeving) continue;
    if (branch.to == contact.node) b.before = &branch;
    if (branch.from == contact.node) b.after = &branch;
  }
  return b;
}

/// The angle about `axis` from one direction to another, in (-pi, pi].
double turn_about(const Vector3& axis, const Vector3& from, const Vector3& to) {
  const Vector3 a = from - axis * axis.dot(from), b = to - axis * axis.dot(to);
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

/// How a rope passes a sheave.
struct Passing {
  double outside = 0;       ///< how far on the outer side of its bend, rad; 0: on the inner one
  bool comes_back = false;  ///< beside itself, nearer than the sheave is wide: neither side is the inner one
};

Passing passing(const machine::Model& model, const machine::State& state, const ContactResult& contact,
                const RopeAtContact& rope) {
  const Array<machine::Node>& nodes = model.reevings[contact.reeving].nodes;
  const machine::Node& node = nodes[contact.node];
  const Vector3 centre = machine::in_ground(state, node.at);
  const Vector3 in = centre - machine::in_ground(state, nodes[rope.before->from].at);
  const Vector3 out = machine::in_ground(state, nodes[rope.after->to].at) - centre;
  Vector3 axis = node.side < 0 ? Vector3(-node.axis) : node.axis;
  if (node.at.body != machine::ground) axis = state.bodies[node.at.body].orientation * axis;
  // the wrap of a rope without radii, with the sag that it has
  const double wrap = contact.wrap - 2 * std::numbers::pi * node.turns;
  const double bend = wrap - turn_about(axis, rope.before->end - rope.before->start, in) +
                      turn_about(axis, rope.after->end - rope.after->start, out);
  if (bend < -hardly_bent) return {.outside = -bend};
  const double width = std::max(hardly_bent, 2 * node.radius / std::min(in.norm(), out.norm()));
  const bool beside = std::cos(bend) < 0 && std::abs(std::sin(bend)) <= width;
  const bool outer = bend > std::numbers::pi && std::sin(bend - std::numbers::pi) > width;
  return {.outside = outer ? bend - std::numbers::pi : 0, .comes_back = beside};
}

/// Shows each sheave without a given side that its taut rope passes: see(contact, passing).
template <class See>
void each_open(const machine::Model& model, const EquilibriumResult& result, const See& see) {
  for (const ContactResult& contact : result.contacts) {
    const machine::Node& node = model.reevings[contact.reeving].nodes[contact.node];
    if (!node.side_open || contact.state == ContactState::lifted) continue;
    const RopeAtContact rope = passing_rope(result, contact);
    if (rope.before == nullptr || rope.after == nullptr || rope.before->slack || rope.after->slack) continue;
    see(contact, passing(model, result.state, contact, rope));
  }
}

/// A sheave at which the rope comes back beside itself and lies on another side than the description has it: either
/// would do, and an answer must not depend on where its search began.
std::optional<WrongSide> not_as_described(const machine::Model& described, const machine::Model& model,
                                          const EquilibriumResult& result) {
  std::optional<WrongSide> found;
  each_open(model, result, [&](const ContactResult& contact, const Passing& passes) {
    const auto side = [&](const machine::Model& m) { return m.reevings[contact.reeving].nodes[contact.node].side; };
    if (passes.comes_back && side(model) != side(described))
      found = WrongSide{.reeving = contact.reeving, .node = contact.node};
  });
  return found;
}

/// The state with the rope beside a sheave to be found anew.
machine::State turned_over(const machine::Model& model, machine::State state, const WrongSide& wrong) {
  Array<machine::BranchState>& branches = state.branches[wrong.reeving];
  const Array<bool>& touched = state.touched[wrong.reeving];
  const auto count = static_cast<int>(model.reevings[wrong.reeving].nodes.size());
  int before = (wrong.node + count - 1) % count;
  while (!touched[before] && before != wrong.node) before = (before + count - 1) % count;
  for (const int k : {before, wrong.node}) {
    if (as_size(k) < branches.size())
      branches[k] = {.length = branches[k].length, .leaves = Vector3::Zero(), .arrives = Vector3::Zero(), .force = {}};
  }
  return state;
}

/// Not ok where a rope would have to be pressed towards a sheave from outside.
Outcome presses_inwards(const machine::Model& model, const EquilibriumResult& result) {
  for (const ContactResult& c : result.contacts) {
    const machine::Node& node = model.reevings[c.reeving].nodes[c.node];
    if (!node.side_open || c.wrap >= -hardly_bent || c.force.norm() == 0) continue;
    return infeasible(
        fmt::format("rope '{}' finds no side of '{}': on both it would have to be pressed towards the sheave from "
                    "outside; give its 'side', or put the sheave nearer to the rope",
                    model.reevings[c.reeving].name, node.name));
  }
  return {};
}

}  // namespace

bool has_open_sides(const machine::Model& model) {
  return std::any_of(model.reevings.begin(), model.reevings.end(), [](const machine::Reeving& rope) {
    return std::any_of(rope.nodes.begin(), rope.nodes.end(), [](const machine::Node& n) { return n.side_open; });
  });
}

std::optional<WrongSide> wrong_side(const machine::Model& model, const EquilibriumResult& result) {
  std::optional<WrongSide> worst;
  each_open(model, result, [&](const ContactResult& contact, const Passing& passes) {
    if (passes.outside > (worst ? worst->by : 0))
      worst = WrongSide{.reeving = contact.reeving, .node = contact.node, .by = passes.outside};
  });
  return worst;
}

EquilibriumResult on_inner_sides(
    const machine::Model& model, const std::optional<machine::State>& start,
    const std::function<EquilibriumResult(const machine::Model&, const std::optional<machine::State>&)>& solve) {
  if (!has_open_sides(model)) return solve(model, start);
  machine::Model sided = start ? machine::with_sides(model, *start) : model;
  std::optional<machine::State> near = start;
  Array<Sides> tried;
  std::optional<std::pair<EquilibriumResult, double>> best;
  int steps = 0;
  do {
    EquilibriumResult result = solve(sided, near);
    result.closure.iterations = steps += result.closure.iterations;
    result.state.sides = sides_of(sided);
    tried.push_back(result.state.sides);
    if (!result.outcome.ok() && !best) return result;
    if (!result.outcome.ok()) break;
    auto wrong = wrong_side(sided, result);
    if (!wrong) wrong = not_as_described(model, sided, result);
    if (!wrong) return result;
    near = turned_over(sided, result.state, *wrong);
    if (!best || wrong->by < best->second) best = {std::move(result), wrong->by};
    int& side = sided.reevings[wrong->reeving].nodes[wrong->node].side;
    side = -side;
  } while (std::find(tried.begin(), tried.end(), sides_of(sided)) == tried.end());
  best->first.outcome = presses_inwards(model, best->first);
  return std::move(best->first);
}

}  // namespace taut::solve
