#include "taut/machine/state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/rounds.hpp"
#include "taut/math/index.hpp"

namespace taut::machine {

Vector3 in_ground(const State& state, const Place& place) {
  if (place.body == ground) return place.at;
  const Pose& pose = state.bodies.at(static_cast<std::size_t>(place.body));
  return pose.position + pose.orientation * place.at;
}

namespace {

/// A straight branch: its length, and its directions as angles on its rounds.
rope::TangentLine line_between(const State& state, const Node& from, const Node& to) {
  const rope::Round a = round_at(state, from), b = round_at(state, to);
  if (const auto line = rope::tangent_line(a, b)) return *line;
  rope::TangentLine centres;
  centres.from = a.centre;
  centres.to = b.centre;
  centres.length = (b.centre - a.centre).norm();
  return centres;
}

/// Lengths of the branches of a rope at one common tension, after the parabola: each its line, longer by c (w b)^2/(24
/// T^2) and shorter by the stretch.
double length_at(const Reeving& reeving, const rope::TangentLine& line, double T) {
  const double across = std::hypot(line.to.x() - line.from.x(), line.to.y() - line.from.y());
  const double sag = reeving.weight * across / T;
  return line.length * (1 + sag * sag / 24) / (1 + T / reeving.stiffness);
}

/// A line's length at a tension without sag; see taut_length.
double without_sag(const Reeving& reeving, const rope::TangentLine& line, double T) {
  return std::isinf(reeving.stiffness) ? length_at(reeving, line, 2 * T) : line.length / (1 + T / reeving.stiffness);
}

/// The tension at which they add up to `total`; the logarithm of the tension halved.
double common_tension(const Reeving& reeving, const Array<rope::TangentLine>& lines, double total) {
  double longest = 0;
  for (const rope::TangentLine& line : lines) longest = std::max(longest, line.length);
  const double weight = reeving.weight * longest;
  double low = std::log(1e-2 * weight);
  double high = std::log(std::isinf(reeving.stiffness) ? 1e6 * weight : std::max(weight, reeving.stiffness));
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    double sum = 0;
    for (const rope::TangentLine& line : lines) sum += length_at(reeving, line, std::exp(middle));
    (sum > total ? low : high) = middle;
  }
  return std::exp(low);
}

/// The straight branches of a rope along its path.
Array<rope::TangentLine> lines_of(const State& state, const Reeving& reeving) {
  const auto count = static_cast<std::size_t>(branch_count(reeving));
  Array<rope::TangentLine> lines;
  for (std::size_t k = 0; k < count; ++k) {
    lines.push_back(line_between(state, reeving.nodes[k], reeving.nodes[(k + 1) % reeving.nodes.size()]));
  }
  return lines;
}

/// What lies on its rounds between them, m.
double arcs_between(const Reeving& reeving, const Array<rope::TangentLine>& lines) {
  const std::size_t count = lines.size();
  double arcs = 0;
  for (std::size_t k = reeving.closed ? 0 : 1; k < count; ++k) {
    const Node& node = reeving.nodes[k];
    double wrap = rope::wrap_angle(node.side, lines[(k + count - 1) % count].angle_to, lines[k].angle_from);
    if (wrap >= 1.5 * std::numbers::pi) wrap -= 2 * std::numbers::pi;  // the rope passes above the round
    arcs += node.radius * (wrap + 2 * std::numbers::pi * node.turns);
  }
  return arcs;
}

/// The branches that a rope begins with: its length shared among its lines, or that of each at the given tension.
Array<BranchState> first_branches(const Reeving& reeving, const Array<rope::TangentLine>& lines) {
  Array<BranchState> branches(lines.size());
  if (reeving.given == Given::tension_at_start || reeving.given == Given::tension_at_end) {
    for (std::size_t k = 0; k < lines.size(); ++k) branches[k].length = without_sag(reeving, lines[k], reeving.value);
    return branches;
  }
  double straight = 0;
  for (const rope::TangentLine& line : lines) straight += line.length;
  const double left = reeving.value * (1 + reeving.thermal_strain) - arcs_between(reeving, lines);
  const bool shared = reeving.given == Given::length && left > 0;
  if (shared && reeving.weight > 0) {
    const double T = common_tension(reeving, lines, left);
    double sum = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) sum += branches[k].length = length_at(reeving, lines[k], T);
    for (BranchState& branch : branches) branch.length *= left / sum;
    return branches;
  }
  const double scale = shared && straight > 0 ? left / straight : 1;
  for (std::size_t k = 0; k < lines.size(); ++k) branches[k].length = scale * lines[k].length;
  return branches;
}

}  // namespace

Model with_sides(Model model, const State& state) {
  for (std::size_t r = 0; r < std::min(model.reevings.size(), state.sides.size()); ++r) {
    Array<Node>& nodes = model.reevings[r].nodes;
    if (state.sides[r].size() != nodes.size()) continue;
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k].side = state.sides[r][k];
  }
  return model;
}

double straight_length(const State& state, const Node& from, const Node& to) {
  return line_between(state, from, to).length;
}

std::pair<Vector3, Vector3> straight_ends(const State& state, const Node& from, const Node& to) {
  const rope::TangentLine line = line_between(state, from, to);
  return {line.from, line.to};
}

double taut_length(const State& state, const Reeving& reeving, const Node& from, const Node& to, double tension) {
  return without_sag(reeving, line_between(state, from, to), tension);
}

State initial_state(const Model& model) {
  State state;
  for (const Body& body : model.bodies) state.bodies.push_back({body.position, body.orientation});
  for (const Reeving& reeving : model.reevings) {
    expects(reeving.nodes.size() >= 2, "a rope runs from somewhere to somewhere");
    state.touched.emplace_back(reeving.nodes.size(), true);
    state.branches.push_back(first_branches(reeving, lines_of(state, reeving)));
  }
  for (const Beam& beam : model.beams) {
    Array<PieceState>& pieces = state.beams.emplace_back();
    for (const BeamPiece& piece : beam.pieces) {
      PieceState& s = pieces.emplace_back();
      const bool moves = piece.start.body != ground;
      s.axes = moves ? Matrix3(state.bodies[piece.start.body].orientation * piece.start_axes) : piece.start_axes;
    }
  }
  return state;
}

bool is_of(const Model& model, const State& state) {
  const std::size_t ropes = model.reevings.size();
  if (state.bodies.size() != model.bodies.size() || state.branches.size() != ropes || state.touched.size() != ropes)
    return false;
  for (std::size_t r = 0; r < ropes; ++r) {
    if (state.branches[r].size() != as_size(branch_count(model.reevings[r]))) return false;
    if (state.touched[r].size() != model.reevings[r].nodes.size()) return false;
  }
  if (state.beams.size() != model.beams.size()) return false;
  for (std::size_t b = 0; b < model.beams.size(); ++b) {
    if (state.beams[b].size() != model.beams[b].pieces.size()) return false;
  }
  return true;
}

}  // namespace taut::machine
