#include "taut/solve/rest/lift.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/rope/span.hpp"

namespace taut::solve {
namespace {

constexpr int lift_halvings = 60;
constexpr int most_releases = 3;
constexpr double lift_rounding = 1e-9;  ///< of a tension or a length: neither lifts nor presses

bool may_lift(const machine::Node& node) {
  return node.may_lift && node.support != Vector3::Zero() && node.kind == machine::NodeKind::contact;
}

/// The rope's force on a support in the direction away from it, N.
double pull(const mechanics::System& s, const mechanics::Evaluation& e, const mechanics::Layout::Turn& t) {
  const mechanics::Branch &in = e.branches[t.before], &out = e.branches[t.after];
  if (in.slack || out.slack) return 0;
  const Vector3& support = s.model.reevings[t.reeving].nodes[t.node].support;
  return (out.pull_from - in.pull_to).dot(support) - lift_rounding * (in.T_to + out.T_from);
}

void release(const mechanics::Layout::Turn& t, const mechanics::Layout::Branch& before, machine::State& state) {
  auto& branches = state.branches[t.reeving];
  machine::BranchState& whole = branches[before.from];
  whole = {.length = whole.length + branches[t.node].length,
           .leaves = Vector3::Zero(),
           .arrives = Vector3::Zero(),
           .force = std::nullopt};
  branches[t.node] = {};
  state.touched[t.reeving][t.node] = false;
}

/// Where a lifted node lies beside its rope.
struct Beside {
  double s = 0;      ///< unstretched length from the branch's start, m
  double below = 0;  ///< how far the rope lies on the wrong side of the support, m
};

Beside beside(const Vector3& support_point, const Vector3& support, const Vector3& start, const rope::Span& span) {
  const Vector3 along = span.chord.normalized();
  double low = 0, high = span.rope.length;
  for (int i = 0; i < lift_halvings; ++i) {
    const double middle = (low + high) / 2;
    const bool behind = (start + rope::point_at(span, middle) - support_point).dot(along) < 0;
    (behind ? low : high) = middle;
  }
  const Vector3 point = start + rope::point_at(span, low);
  return {.s = low, .below = (support_point - point).dot(support)};
}

struct Return {
  const mechanics::Layout::Branch* branch = nullptr;
  int node = 0;
  Beside where;
};

/// The lifted support that its rope lies deepest below.
Return deepest(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  Return worst;
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    const mechanics::Layout::Branch& laid = s.layout.branches[k];
    const machine::Reeving& rope = s.model.reevings[laid.reeving];
    const int nodes = static_cast<int>(rope.nodes.size());
    for (int n = (laid.from + 1) % nodes; n != laid.to; n = (n + 1) % nodes) {
      const machine::Node& node = rope.nodes[n];
      if (!may_lift(node)) continue;
      const mechanics::Branch& b = e.branches[k];
      const auto span =
          laid.force ? tl::expected<rope::Span, rope::NoCatenary>(b.span)
                     : rope::solve_span(mechanics::rope_of(rope, c.branches[k].length), b.chord, c.branches[k].force);
      if (!span) continue;
      const Vector3 start = mechanics::end_at(rope.nodes[laid.from], c.bodies).centre + b.offset_from;
      const Vector3 top = mechanics::end_at(node, c.bodies).centre + node.radius * node.support;
      const Beside where = beside(top, node.support, start, *span);
      if (where.below > std::max(worst.where.below, lift_rounding * s.layout.length))
        worst = {.branch = &laid, .node = n, .where = where};
    }
  }
  return worst;
}

}  // namespace

bool change_touch(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                  machine::State& state, Array<Array<int>>& let_go) {
  const mechanics::Layout::Turn* lifts = nullptr;
  double most = 0;
  for (const mechanics::Layout::Turn& t : s.layout.turns) {
    if (!may_lift(s.model.reevings[t.reeving].nodes[t.node])) continue;
    if (let_go[t.reeving][t.node] >= most_releases) continue;
    const double force = pull(s, e, t);
    if (force <= most) continue;
    most = force;
    lifts = &t;
  }
  if (lifts) {
    ++let_go[lifts->reeving][lifts->node];
    release(*lifts, s.layout.branches[lifts->before], state);
    return true;
  }
  const Return back = deepest(s, c, e);
  if (!back.branch) return false;
  auto& branches = state.branches[back.branch->reeving];
  const double whole = branches[back.branch->from].length;
  const double before = std::clamp(back.where.s, 0.01 * whole, 0.99 * whole);
  branches[back.branch->from] = {
      .length = before, .leaves = Vector3::Zero(), .arrives = Vector3::Zero(), .force = std::nullopt};
  branches[back.node] = {
      .length = whole - before, .leaves = Vector3::Zero(), .arrives = Vector3::Zero(), .force = std::nullopt};
  state.touched[back.branch->reeving][back.node] = true;
  return true;
}

}  // namespace taut::solve
