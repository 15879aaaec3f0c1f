#include "taut/checks/off_groove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/solve/quantities.hpp"

namespace taut::checks {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double widest_throat = 60;  ///< deg

/// Orientation of what carries a node. `bodies` have an `orientation` each.
template <class Bodies>
Matrix3 turned(const Bodies& bodies, const machine::Node& node) {
  return node.at.body == machine::ground ? Matrix3(Matrix3::Identity()) : bodies[node.at.body].orientation;
}

}  // namespace

void OffGroove::keep(const machine::Reeving& rope, const machine::Node& node, const Matrix3& turned,
                     const Vector3& along, const std::string& words) {
  if (node.radius <= 0 || !(along.norm() > 0)) return;
  const double sine = std::abs(along.normalized().dot(turned * node.axis));
  if (sine <= std::sin(widest_throat / 2 * degree)) return;
  Worst& worst = worst_[{rope.name, node.name}];
  if (sine > worst.sine) worst = {.sine = sine, .where = words};
}

void OffGroove::take(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  for (const solve::BranchResult& s : e.branches) {
    if (s.slack || !(std::max(s.T_from, s.T_to) > 0)) continue;
    const machine::Reeving& rope = m.reevings[s.reeving];
    const machine::Node &from = rope.nodes[s.from], &to = rope.nodes[s.to];
    keep(rope, from, turned(e.state.bodies, from), solve::pull_on_start(s), words);
    keep(rope, to, turned(e.state.bodies, to), solve::pull_on_end(s), words);
  }
}

void OffGroove::take(const machine::Model& m, const solve::TransientFrame& frame, const std::set<std::string>& broken,
                     const std::string& words) {
  for (std::size_t i = 0; i < frame.branches.size(); ++i) {
    const solve::TransientFrame::Branch& s = frame.branches[i];
    if (!s.whole || !(std::max(s.T_from, s.T_to) > 0) || broken.contains(m.reevings[s.reeving].name)) continue;
    // of a rope in segments the first and the last piece touch the rounds
    const auto of_same = [&](const solve::TransientFrame::Branch& other) {
      return other.reeving == s.reeving && other.from == s.from && other.to == s.to;
    };
    const bool first = i == 0 || !of_same(frame.branches[i - 1]);
    const bool last = i + 1 == frame.branches.size() || !of_same(frame.branches[i + 1]);
    const machine::Reeving& rope = m.reevings[s.reeving];
    const machine::Node &from = rope.nodes[s.from], &to = rope.nodes[s.to];
    if (first) keep(rope, from, turned(frame.bodies, from), s.leaves, words);
    if (last) keep(rope, to, turned(frame.bodies, to), s.arrives, words);
  }
}

void OffGroove::add_warnings(Result& r, const Display& display) const {
  for (const auto& [place, worst] : worst_) {
    const AboutPart about(r, {.kind = PartKind::rope, .name = place.first});
    const double angle = std::asin(std::min(worst.sine, 1.0));
    warn_unsafe(r, fmt::format("{}: {} runs {} out of the plane of '{}': no groove holds it (throats open {} at most); "
                               "turn the 'axis' or guide the rope",
                               worst.where, place.first, display.brief(angle, si::rad), place.second,
                               display.brief(widest_throat * degree, si::rad)));
  }
}

}  // namespace taut::checks
