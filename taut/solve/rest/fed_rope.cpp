#include "taut/solve/rest/fed_rope.hpp"

#include <cmath>

#include "taut/math/index.hpp"

namespace taut::analysis {
namespace {

/// Whether what is fed in stops at a turn.
bool stops_feed(const System& s, const Layout::Turn& turn) {
  const model::Node& node = node_of(s, turn);
  if (node.kind == model::NodeKind::clamp) return true;
  return node.kind == model::NodeKind::drive && (turn.row < 0 || !node.tension_drop);
}

void add_fed_end(const System& s, int r, model::Given given, double tension, int row, std::vector<FedEnd>& all) {
  if (given != model::Given::tension_at_start && given != model::Given::tension_at_end) return;
  if (row == s.layout.coordinate_row || row == s.layout.height_row) return;
  const Layout::Rope& rope = s.layout.ropes[at(r)];
  FedEnd end{r, row, rope.first, rope.first + rope.count - 1, given == model::Given::tension_at_end, tension};
  for (int t = rope.first_turn; t < rope.first_turn + rope.turn_count; ++t) {
    const Layout::Turn& turn = s.layout.turns[at(t)];
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

std::vector<FedEnd> fed_ends(const System& s) {
  std::vector<FedEnd> all;
  for (int r = 0; r < static_cast<int>(s.layout.ropes.size()); ++r) {
    const model::Reeving& reeving = s.model.reevings[at(r)];
    const bool length_too =
        reeving.also && (reeving.given == model::Given::length || reeving.also->first == model::Given::length);
    if (length_too) continue;
    add_fed_end(s, r, reeving.given, reeving.value, s.layout.ropes[at(r)].row, all);
    const int drive = s.layout.ropes[at(r)].drive;
    if (drive < 0 || !reeving.also) continue;
    add_fed_end(s, r, reeving.also->first, reeving.also->second, s.layout.turns[at(drive)].row, all);
  }
  return all;
}

double tension_rate(const System& s, const Configuration& c, const Evaluation& e, int link) {
  const Layout::Link& l = s.layout.links[at(link)];
  const model::Reeving& rope = s.model.reevings[at(l.reeving)];
  const Branch& b = e.branches[at(link)];
  const BranchRates r = rates(rope_of(rope, c.links[at(link)].length), end_at(rope.nodes[at(l.from)], c.bodies),
                              end_at(rope.nodes[at(l.to)], c.bodies), b);
  return b.leaves.dot(r.pull_from_u);
}

int deep_link(const System& s, const std::vector<FedEnd>& fed, const Configuration& c, const Evaluation& e) {
  for (const FedEnd& end : fed) {
    for (int k = end.first; k <= end.last; ++k) {
      if (!(tension_rate(s, c, e, k) < 0)) return k;
    }
  }
  return -1;
}

int deep_mainline_link(const System& s, const Configuration& c, const Evaluation& e) {
  for (const Layout::Rope& rope : s.layout.ropes) {
    if (rope.row != s.layout.coordinate_row) continue;
    for (int k = rope.first; k < rope.first + rope.count; ++k) {
      if (s.model.reevings[at(s.layout.links[at(k)].reeving)].weight > 0 && !(tension_rate(s, c, e, k) < 0)) return k;
    }
  }
  return -1;
}

void draw_fed_taut(const System& s, const std::vector<FedEnd>& fed, Configuration& c) {
  const model::State state{c.bodies, {}, {}, {}};
  for (const FedEnd& end : fed) {
    for (int k = end.first; k <= end.last; ++k) {
      const Layout::Link& link = s.layout.links[at(k)];
      const model::Reeving& rope = s.model.reevings[at(link.reeving)];
      const double length =
          model::taut_length(state, rope, rope.nodes[at(link.from)], rope.nodes[at(link.to)], end.tension);
      c.links[at(k)] = {};
      c.links[at(k)].length = length;
    }
  }
}

}  // namespace taut::analysis
