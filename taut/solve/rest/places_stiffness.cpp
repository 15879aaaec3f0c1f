#include "taut/solve/rest/places_stiffness.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "taut/math/index.hpp"
#include "taut/solve/definite.hpp"
#include "taut/solve/stiff_ropes.hpp"

namespace taut::solve {
namespace {

/// The machine without its beams, and without what prescribes a place: its ropes as long as they are. `kept`: the
/// freedom along which a force held a carriage.
mechanics::Layout without_beams(const mechanics::Layout& layout, std::optional<int>& kept) {
  mechanics::Layout bare = layout;
  bare.pieces.clear();
  if (!layout.pieces.empty()) bare.size = layout.pieces.front().unknown;
  kept.reset();
  if (bare.hold) {
    --bare.size;  // the last one before the beams
    double most = 0;
    for (int i = bare.first_dof[bare.coordinate_body]; i < bare.first_dof[as_size(bare.coordinate_body) + 1]; ++i) {
      const double along = std::abs(bare.dofs[i].way.along.dot(bare.coordinate_along));
      if (along > most) most = along, kept = i;
    }
  }
  bare.hold.reset();
  bare.coordinate_row.reset();
  bare.height_row.reset();
  return bare;
}

/// By body, whether it is the place of a rope load: a point of its rope at a share of it, as free as that.
Array<bool> points_of_ropes(const mechanics::System& s) {
  Array<bool> found(s.model.bodies.size(), false);
  for (const mechanics::Layout::Turn& turn : s.layout.turns) {
    const machine::Node& node = mechanics::node_of(s, turn);
    if (node.kind == machine::NodeKind::load) found[node.at.body] = true;
  }
  return found;
}

}  // namespace

std::optional<PlacesStiffness> places_stiffness(const mechanics::System& s, const mechanics::Configuration& c,
                                                mechanics::Evaluation& e) {
  const std::optional<Softer> soft = with_softer_ropes(s, c, found_by_length);
  std::optional<int> kept;
  const mechanics::Layout bare = without_beams(soft ? soft->layout : s.layout, kept);
  const mechanics::System rest{
      .model = soft ? soft->model : s.model, .layout = bare, .coordinate = s.coordinate, .losses = s.losses};
  mechanics::Configuration now = soft ? soft->c : c;
  if (mechanics::evaluate(rest, now, e)) return std::nullopt;
  Entries J;
  Array<mechanics::BranchColumns> columns;
  mechanics::jacobian(rest, now, e, J, columns);
  PlacesStiffness found;
  Array<int> order;
  const Array<bool> of_ropes = points_of_ropes(rest);
  for (int i = 0; i < bare.size; ++i) {
    if (i >= static_cast<int>(bare.dofs.size()) || of_ropes[bare.dofs[i].body]) {
      order.push_back(i);
    } else if (i != kept) {
      found.freedoms.push_back(i);
    }
  }
  const auto eliminated = static_cast<int>(order.size());
  order.insert(order.end(), found.freedoms.begin(), found.freedoms.end());
  const std::optional<Eigen::MatrixXd> condensed = condense(J.dense(), order, eliminated);
  if (!condensed) return std::nullopt;
  found.matrix = -*condensed;
  return found;
}

Array<int> rows_with_beams(const mechanics::System& s, const PlacesStiffness& all) {
  std::set<int> bodies;
  for (const machine::Beam& beam : s.model.beams) {
    for (const machine::BeamPiece& piece : beam.pieces) bodies.insert({piece.start.body, piece.end.body});
  }
  const auto count = static_cast<int>(all.freedoms.size());
  Array<int> found, ahead;
  Array<char> known(all.freedoms.size(), 0);
  const auto take = [&](int i) {
    if (known[i] != 0) return;
    known[i] = 1;
    found.push_back(i);
    ahead.push_back(i);
  };
  for (int i = 0; i < count; ++i) {
    if (bodies.contains(s.layout.dofs[all.freedoms[i]].body)) take(i);
  }
  while (!ahead.empty()) {
    const int i = ahead.back();
    ahead.pop_back();
    for (int j = 0; j < count; ++j) {
      if (all.matrix(i, j) != 0 || all.matrix(j, i) != 0) take(j);
    }
  }
  return found;
}

}  // namespace taut::solve
