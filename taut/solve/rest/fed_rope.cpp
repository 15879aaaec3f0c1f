#include "taut/solve/rest/fed_rope.hpp"

#include <cmath>

#include "taut/base/array.hpp"

namespace taut::solve {
namespace {

/// Whether what is fed in stops at a turn.
bool stops_feed(const mechanics::System& s, const mechanics::Layout::Turn& turn) {
  const machine::Node& node = mechanics::node_of(s, turn);
  if (node.kind == machine::NodeKind::clamp) return true;
  return node.kind == machine::NodeKind::drive && (!turn.row || !node.tension_drop);
}

void add_fed_end(const mechanics::System& s, int r, machine::Given given, double tension, int row, Array<FedEnd>& all) {
  if (given == machine::Given::length || given == machine::Given::torque) return;
  if (row == s.layout.coordinate_row || row == s.layout.height_row) return;
  const mechanics::Layout::Rope& rope = s.layout.ropes[r];
  FedEnd end{.rope = r,
             .row = row,
             .first = rope.first,
             .last = rope.first + rope.count - 1,
             .at_end = given == machine::Given::tension_at_end,
             .tension = tension};
  for (int t = rope.first_turn; t < rope.first_turn + rope.turn_count; ++t) {
    const mechanics::Layout::Turn& turn = s.layout.turns[t];
    if (!stops_feed(s, turn)) continue;
    if (!end.at_end) {
      end.last = turn.before;
      break;
    }
    end.first = turn.after;
  }
  all.push_back(end);
}

}  // namespace

Array<FedEnd> fed_ends(const mechanics::System& s) {
  Array<FedEnd> all;
  for (int r = 0; r < static_cast<int>(s.layout.ropes.size()); ++r) {
    const machine::Reeving& reeving = s.model.reevings[r];
    const bool length_too =
        reeving.also && (reeving.given == machine::Given::length || reeving.also->first == machine::Given::length);
    if (length_too) continue;
    const bool known = reeving.given != machine::Given::equal;
    add_fed_end(s, r, reeving.given, known ? reeving.value : 0, s.layout.ropes[r].row, all);
    const auto drive = s.layout.ropes[r].drive;
    if (!drive || !reeving.also) continue;
    add_fed_end(s, r, reeving.also->first, reeving.also->second, *s.layout.turns[*drive].row, all);
  }
  return all;
}

double tension_rate(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                    int branch) {
  const mechanics::Layout::Branch& l = s.layout.branches[branch];
  const machine::Reeving& rope = s.model.reevings[l.reeving];
  const mechanics::Branch& b = e.branches[branch];
  const mechanics::BranchRates r = mechanics::rates(mechanics::rope_of(rope, c.branches[branch].length),
                                                    mechanics::end_at(rope.nodes[l.from], c.bodies),
                                                    mechanics::end_at(rope.nodes[l.to], c.bodies), b);
  return b.leaves.dot(r.pull_from_u);
}

std::optional<int> deep_link(const mechanics::System& s, const Array<FedEnd>& fed, const mechanics::Configuration& c,
                             const mechanics::Evaluation& e) {
  for (const FedEnd& end : fed) {
    for (int k = end.first; k <= end.last; ++k) {
      if (!(tension_rate(s, c, e, k) < 0)) return k;
    }
  }
  return std::nullopt;
}

std::optional<int> deep_mainline_link(const mechanics::System& s, const mechanics::Configuration& c,
                                      const mechanics::Evaluation& e) {
  for (const mechanics::Layout::Rope& rope : s.layout.ropes) {
    if (rope.row != s.layout.coordinate_row) continue;
    for (int k = rope.first; k < rope.first + rope.count; ++k) {
      if (s.model.reevings[s.layout.branches[k].reeving].weight > 0 && !(tension_rate(s, c, e, k) < 0)) return k;
    }
  }
  return std::nullopt;
}

std::optional<int> deep_link_at_height(const mechanics::System& s, const machine::Carriage& carriage,
                                       const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  const auto at_carriage = [&](int node) { return node >= carriage.node && node < carriage.node + carriage.rollers; };
  for (const mechanics::Layout::Rope& rope : s.layout.ropes) {
    if (rope.row != s.layout.height_row) continue;
    for (int k = rope.first; k < rope.first + rope.count; ++k) {
      const mechanics::Layout::Branch& branch = s.layout.branches[k];
      if (at_carriage(branch.from) || at_carriage(branch.to)) continue;
      if (s.model.reevings[branch.reeving].weight > 0 && !(tension_rate(s, c, e, k) < 0)) return k;
    }
  }
  return std::nullopt;
}

void draw_fed_taut(const mechanics::System& s, const Array<FedEnd>& fed, mechanics::Configuration& c) {
  const machine::State state{.bodies = c.bodies, .branches = {}, .touched = {}, .beams = {}};
  for (const FedEnd& end : fed) {
    for (int k = end.first; k <= end.last; ++k) {
      const mechanics::Layout::Branch& laid = s.layout.branches[k];
      const machine::Reeving& rope = s.model.reevings[laid.reeving];
      const double length = machine::taut_length(state, rope, rope.nodes[laid.from], rope.nodes[laid.to], end.tension);
      c.branches[k] = {};
      c.branches[k].length = length;
    }
  }
}

}  // namespace taut::solve
