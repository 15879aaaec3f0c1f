#include "taut/mechanics/configuration.hpp"

#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::mechanics {

Configuration configuration_of(const Layout& layout, const machine::State& state) {
  Configuration c;
  c.bodies = state.bodies;
  c.open_loads.assign(layout.ropes.size(), 0);
  for (const Layout::Branch& laid : layout.branches) c.branches.push_back(state.branches[laid.reeving][laid.from]);
  for (const Layout::Piece& p : layout.pieces) c.pieces.push_back(state.beams.at(as_size(p.beam)).at(as_size(p.piece)));
  return c;
}

void keep(const Layout& layout, const Configuration& c, machine::State& state) {
  state.bodies = c.bodies;
  for (std::size_t k = 0; k < layout.branches.size(); ++k) {
    state.branches[layout.branches[k].reeving][layout.branches[k].from] = c.branches[k];
  }
  for (std::size_t k = 0; k < layout.pieces.size(); ++k) {
    state.beams.at(as_size(layout.pieces[k].beam)).at(as_size(layout.pieces[k].piece)) = c.pieces[k];
  }
}

namespace {

constexpr double drawn_taut = 0.999;

/// Gives a branch a little less than its straight length. False where it does not stretch.
bool draw_taut(const System& system, const machine::State& state, int branch_index, Configuration& c) {
  const Layout::Branch& laid = system.layout.branches[branch_index];
  const machine::Reeving& rope = system.model.reevings[laid.reeving];
  if (std::isinf(rope.stiffness)) return false;
  c.branches[branch_index] = {};
  c.branches[branch_index].length =
      drawn_taut * machine::straight_length(state, rope.nodes[laid.from], rope.nodes[laid.to]);
  return true;
}

}  // namespace

Configuration usable_start(const System& system, const machine::State& state) {
  Configuration c = configuration_of(system.layout, state);
  Evaluation e;
  for (std::size_t tries = 0; tries <= c.branches.size(); ++tries) {
    const auto no = evaluate(system, c, e);
    if (!no) break;
    if (!draw_taut(system, state, no->branch, c)) break;
  }
  return c;
}

Configuration taut_start(const System& system, const machine::State& state) {
  Configuration c = configuration_of(system.layout, state);
  for (int k = 0; k < static_cast<int>(c.branches.size()); ++k) draw_taut(system, state, k, c);
  return c;
}

}  // namespace taut::mechanics
