#include "taut/results/described_state.hpp"

#include <tuple>

namespace taut::results {
namespace {

/// Branches and contacts of a rope, and its longest branch as the one that a name stands at.
void lay_straight(const machine::Model& m, int reeving, solve::EquilibriumResult& e) {
  const machine::Reeving& rope = m.reevings[reeving];
  const auto count = static_cast<int>(rope.nodes.size());
  solve::RopeResult whole;
  double longest = -1;
  for (int k = 0; k < machine::branch_count(rope); ++k) {
    solve::BranchResult b;
    b.reeving = reeving;
    b.from = k;
    b.to = (k + 1) % count;
    b.slack = true;
    std::tie(b.start, b.end) = machine::straight_ends(e.state, rope.nodes[b.from], rope.nodes[b.to]);
    b.chord = (b.end - b.start).norm();
    if (b.chord > longest) {
      longest = b.chord;
      whole.branch = static_cast<int>(e.branches.size());
    }
    e.branches.push_back(b);
  }
  e.ropes.push_back(whole);
  for (int n = rope.closed ? 0 : 1; n < (rope.closed ? count : count - 1); ++n) {
    solve::ContactResult c;
    c.reeving = reeving;
    c.node = n;
    e.contacts.push_back(c);
  }
}

/// The ends of its pieces.
solve::BeamResult as_built(const machine::Model& m, int beam, const machine::State& state) {
  solve::BeamResult b;
  b.beam = beam;
  const auto add = [&](const machine::Place& place) {
    solve::BeamPoint p;
    p.place = machine::in_ground(state, place);
    b.points.push_back(p);
  };
  for (const machine::BeamPiece& piece : m.beams[beam].pieces) {
    if (b.points.empty()) add(piece.start);
    add(piece.end);
  }
  return b;
}

}  // namespace

solve::EquilibriumResult described_state(const machine::Model& m) {
  solve::EquilibriumResult e;
  e.outcome = infeasible("this is the machine as described, not an equilibrium");
  e.state = machine::initial_state(m);
  for (std::size_t i = 0; i < m.reevings.size(); ++i) lay_straight(m, static_cast<int>(i), e);
  for (std::size_t i = 0; i < m.beams.size(); ++i) e.beams.push_back(as_built(m, static_cast<int>(i), e.state));
  return e;
}

}  // namespace taut::results
