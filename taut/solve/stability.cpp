#include "taut/solve/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/branch_force.hpp"
#include "taut/solve/beam_tables.hpp"
#include "taut/solve/rest/fed_rope.hpp"
#include "taut/solve/rest/places_stiffness.hpp"
#include "taut/solve/stiff_ropes.hpp"

namespace taut::solve {
namespace {

using Triplets = Array<Eigen::Triplet<double, int>>;

constexpr double matrix_rounding = 1e-7;  ///< of the scaled matrix
constexpr double weight_of_bodies = 100;
constexpr double noticed = 0.01;  ///< of the longest span: a push, and a place that is another one

/// Rows of the residual and columns of rope fed in that belong to the coordinates.
struct Coordinates {
  Array<EnergyCurvature::Row> rows;
  Array<int> residual;
  Array<double> factor;                               ///< of the residual's row
  Array<std::pair<int, std::optional<int>>> unknown;  ///< + the first, - the second
};

/// The law of the tensions beside a turn that rope passes; `sign` times its residual grows with the one behind it.
struct PassedRow {
  int row = 0;
  int sign = 1;
};

/// Empty where no rope passes: a clamp, a drive that takes what comes.
std::optional<PassedRow> passed_row(const mechanics::System& s, const mechanics::Layout::Turn& turn,
                                    const mechanics::Layout::Rope& rope) {
  const machine::Reeving& reeving = s.model.reevings[turn.reeving];
  const machine::Node& node = reeving.nodes[turn.node];
  if (node.kind == machine::NodeKind::contact) return PassedRow{.row = *turn.row, .sign = node.tension_drop ? -1 : 1};
  if (node.kind != machine::NodeKind::drive) return std::nullopt;
  if (reeving.given == machine::Given::torque) return PassedRow{.row = rope.row, .sign = -1};
  const bool by_torque = turn.row && (!reeving.also || reeving.also->first == machine::Given::torque);
  return by_torque ? std::optional(PassedRow{.row = *turn.row, .sign = -1}) : std::nullopt;
}

void add_rope(const mechanics::System& s, const mechanics::Evaluation& e, const Array<FedEnd>& fed, int r,
              Coordinates& all) {
  const mechanics::Layout::Rope& rope = s.layout.ropes[r];
  const machine::Reeving& reeving = s.model.reevings[r];
  const auto stretch = [&](double T) { return reeving.copies * (1 + T / reeving.stiffness); };
  for (int k = rope.first; k < rope.first + rope.count; ++k) {
    if (e.branches[k].slack) return;
  }
  for (int t = rope.first_turn; t < rope.first_turn + rope.turn_count; ++t) {
    const mechanics::Layout::Turn& turn = s.layout.turns[t];
    const std::optional<PassedRow> law = passed_row(s, turn, rope);
    if (!law) continue;
    all.rows.push_back({EnergyCurvature::Of::contact, t});
    all.residual.push_back(law->row);
    all.factor.push_back(law->sign * stretch(e.branches[turn.after].T_from));
    all.unknown.emplace_back(s.layout.branches[turn.after].unknown, s.layout.branches[turn.before].unknown);
  }
  for (int i = 0; i < static_cast<int>(fed.size()); ++i) {
    const FedEnd& end = fed[i];
    if (end.rope != r) continue;
    all.rows.push_back({EnergyCurvature::Of::fed_end, i});
    all.residual.push_back(end.row);
    all.factor.push_back(stretch(end.tension));
    all.unknown.emplace_back(s.layout.branches[end.own()].unknown, std::nullopt);
  }
}

Coordinates coordinates_of(const mechanics::System& s, const mechanics::Evaluation& e, const Array<FedEnd>& fed) {
  Coordinates all;
  for (int r = 0; r < static_cast<int>(s.layout.ropes.size()); ++r) add_rope(s, e, fed, r, all);
  for (int i = 0; i < static_cast<int>(s.layout.dofs.size()); ++i) {
    const mechanics::Layout::Dof& dof = s.layout.dofs[i];
    const bool kept =
        s.layout.hold && dof.body == s.layout.coordinate_body && dof.way.along.dot(s.layout.coordinate_along) != 0;
    if (kept) continue;
    all.rows.push_back({EnergyCurvature::Of::freedom, i});
    all.residual.push_back(i);
    all.factor.push_back(1);
    all.unknown.emplace_back(i, std::nullopt);
  }
  return all;
}

/// What an end of a branch keeps of the rope that is drawn onto its round: stretch there, and half an arc that
/// stretches.
struct RoundEnd {
  Vector3 arc = Vector3::Zero();      ///< by the direction of the rope, unstretched
  double by_tension = 0;              ///< m/N
  int body = machine::ground;         ///< the arc is counted from a direction that turns with it,
  Vector3 by_turn = Vector3::Zero();  ///< m/rad
};

RoundEnd round_end(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                   const mechanics::Layout::Branch& laid, bool leaves) {
  RoundEnd r;
  const machine::Reeving& rope = s.model.reevings[laid.reeving];
  const machine::Node& node = rope.nodes[leaves ? laid.from : laid.to];
  if (node.radius == 0) return r;  // a drum keeps its rope, although a machine counts only what is free of it
  const auto k = static_cast<std::size_t>(&laid - s.layout.branches.data());
  const mechanics::Branch& b = e.branches[k];
  const double stretch = 1 + (leaves ? b.T_from : b.T_to) / rope.stiffness;
  const mechanics::BranchEnd end = mechanics::end_at(node, c.bodies);
  r.arc = mechanics::arc_rate(end, leaves ? b.leaves : b.arrives, leaves) / stretch;
  r.body = node.at.body;
  r.by_turn = (leaves ? -end.radius : end.radius) / stretch * end.axis;
  for (std::size_t t = 0; t < s.layout.turns.size(); ++t) {
    const mechanics::Layout::Turn& turn = s.layout.turns[t];
    if (turn.reeving != laid.reeving || (leaves ? turn.after : turn.before) != static_cast<int>(k)) continue;
    r.by_tension = -node.radius * e.bends[t].wrap.value / 2 / (stretch * stretch) / rope.stiffness;
  }
  return r;
}

/// Unstretched rope from the middle of one arc to that of the next, by the unknowns that move the branch.
Array<double> material_rates(const mechanics::System& s, const mechanics::Configuration& c,
                             const mechanics::Evaluation& e, const mechanics::BranchColumns& columns, std::size_t k) {
  const mechanics::Layout::Branch& laid = s.layout.branches[k];
  const RoundEnd from = round_end(s, c, e, laid, true), to = round_end(s, c, e, laid, false);
  const mechanics::Branch& b = e.branches[k];
  Array<double> rates;
  rates.reserve(as_size(columns.count));
  const auto turned = [&](const RoundEnd& end, int unknown) {
    if (as_size(unknown) >= s.layout.dofs.size()) return 0.0;
    const mechanics::Layout::Dof& dof = s.layout.dofs[unknown];
    return dof.body == end.body ? end.by_turn.dot(dof.way.about) : 0.0;
  };
  for (std::size_t j = 0; j < as_size(columns.count); ++j) {
    rates.push_back(columns.length[j] + from.arc.dot(columns.leaves[j]) + to.arc.dot(columns.arrives[j]) +
                    from.by_tension * b.leaves.dot(columns.pull_from[j]) +
                    to.by_tension * b.arrives.dot(columns.pull_to[j]) + turned(from, columns.unknown[j]) +
                    turned(to, columns.unknown[j]));
  }
  return rates;
}

/// The unknowns by the coordinates: rope between the middles of arcs is kept, but for what passes a contact.
SparseRows unknowns_by(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                       const Array<mechanics::BranchColumns>& columns, const Coordinates& all) {
  Triplets units;
  for (int j = 0; j < static_cast<int>(all.rows.size()); ++j) {
    const auto [plus, minus] = all.unknown[j];
    units.emplace_back(plus, j, 1);
    if (minus) units.emplace_back(*minus, j, -1);
  }
  const SparseRows moved(s.layout.size, units);
  Triplets entries;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const int own = s.layout.branches[k].unknown;
    const Array<double> rates = material_rates(s, c, e, columns[k], k);
    for (const auto& [coordinate, sign] : moved.row(own)) entries.emplace_back(own, coordinate, sign / rates.back());
    for (std::size_t j = 0; j + 1 < rates.size(); ++j) {
      const double rate = -rates[j] / rates.back();
      for (const auto& [coordinate, sign] : moved.row(columns[k].unknown[j])) {
        entries.emplace_back(own, coordinate, rate * sign);
      }
    }
  }
  Array<bool> follows(as_size(s.layout.size), false);
  for (const mechanics::Layout::Branch& laid : s.layout.branches) follows[laid.unknown] = true;
  for (const auto& unit : units) {
    if (!follows[unit.row()]) entries.push_back(unit);
  }
  return {s.layout.size, entries};
}

/// Row numbers, the lowest first, each once however often it is put in.
class Ahead {
 public:
  explicit Ahead(int size) : waits_(as_size(size), false) {}
  bool empty() const { return rows_.empty(); }
  void put(int row) {
    if (waits_[row]) return;
    waits_[row] = true;
    rows_.push(row);
  }
  int take() {
    const int row = rows_.top();
    rows_.pop();
    waits_[row] = false;
    return row;
  }

 private:
  Array<bool> waits_;
  std::priority_queue<int, std::vector<int>, std::greater<>> rows_;
};

/// A B, of A the rows named, each times its factor.
SparseRows product(const SparseRows& A, const Array<int>& rows, const Array<double>& factors, const SparseRows& B,
                   int columns) {
  Triplets entries;
  Array<double> sum(as_size(columns), 0);
  Ahead touched(columns);
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    for (const auto& [k, value] : A.row(rows[i])) {
      for (const auto& [j, factor] : B.row(k)) {
        sum[j] += value * factor;
        touched.put(j);
      }
    }
    while (!touched.empty()) {
      const int j = touched.take();
      entries.emplace_back(i, j, factors[i] * std::exchange(sum[j], 0));
    }
  }
  return {static_cast<int>(rows.size()), entries};
}

std::string_view axis_name(const Vector3& d) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(d[i]) > 1 - 1e-9) return std::string_view("xyz").substr(as_size(i), 1);
  }
  return {};
}

std::string words(const mechanics::System& s, const EnergyCurvature::Row& row) {
  if (row.of == EnergyCurvature::Of::freedom) {
    const mechanics::Layout::Dof& dof = s.layout.dofs[row.index];
    const bool turns = dof.way.about != Vector3::Zero();
    const Vector3& d = turns ? dof.way.about : dof.way.along;
    const std::string_view name = axis_name(d);
    const std::string where =
        name.empty() ? fmt::format("({:.3g}, {:.3g}, {:.3g})", d.x(), d.y(), d.z()) : std::string(name);
    return fmt::format("body '{}' {} {} {}", s.model.bodies[dof.body].name, turns ? "turns over" : "moves away",
                       turns ? "about" : "along", where);
  }
  if (row.of == EnergyCurvature::Of::fed_end) {
    const FedEnd end = fed_ends(s)[row.index];
    const machine::Reeving& rope = s.model.reevings[end.rope];
    return fmt::format("rope '{}' runs in or out at '{}'", rope.name,
                       (end.at_end ? rope.nodes.back() : rope.nodes.front()).name);
  }
  const mechanics::Layout::Turn& t = s.layout.turns[row.index];
  const machine::Reeving& rope = s.model.reevings[t.reeving];
  return fmt::format("rope '{}' runs over '{}'", rope.name, rope.nodes[t.node].name);
}

}  // namespace

bool has_rope_loads(const mechanics::System& s) {
  return std::any_of(s.layout.turns.begin(), s.layout.turns.end(), [&](const mechanics::Layout::Turn& t) {
    return mechanics::node_of(s, t).kind == machine::NodeKind::load;
  });
}

std::optional<EnergyCurvature> energy_curvature(const mechanics::System& s, const mechanics::Configuration& c,
                                                const mechanics::Evaluation& e) {
  const Array<FedEnd> fed = s.lengths_kept ? Array<FedEnd>() : fed_ends(s);
  if (!s.layout.pieces.empty() || has_rope_loads(s)) return std::nullopt;
  Entries J;
  Array<mechanics::BranchColumns> columns;
  mechanics::jacobian(s, c, e, J, columns);
  const Coordinates all = coordinates_of(s, e, fed);
  EnergyCurvature curvature{.rows = all.rows, .matrix = {}, .unknowns = unknowns_by(s, c, e, columns, all)};
  Array<double> factors = all.factor;
  for (double& factor : factors) factor = -factor;
  const auto n = static_cast<int>(all.rows.size());
  curvature.matrix = product({J.size(), J.all()}, all.residual, factors, curvature.unknowns, n);
  return curvature;
}

namespace {

/// Rows and columns scaled so that the diagonal is 1, where it is not much smaller than its row.
Array<double> unit_diagonal(const SparseRows& matrix) {
  Array<double> scale(as_size(matrix.rows()), 1);
  for (int i = 0; i < matrix.rows(); ++i) {
    double size = 0, diagonal = 0;
    for (const auto& [column, value] : matrix.row(i)) {
      size = std::max(size, std::abs(value));
      if (column == i) diagonal += value;
    }
    if (size > 0) scale[i] = 1 / std::sqrt(std::max(std::abs(diagonal), 1e-12 * size));
  }
  return scale;
}

/// Elimination of a sparse matrix row by row without pivoting. A neutral pivot is passed by: nothing holds that row,
/// nothing drives it.
class Elimination {
 public:
  explicit Elimination(int size) : work_(as_size(size), 0), ahead_(size) { first_.reserve(as_size(size) + 1); }

  /// What is left of the diagonal of the next row once those before it follow.
  double eliminate(const SparseRows& matrix, const Array<double>& scale) {
    const auto i = static_cast<int>(first_.size()) - 1;
    for (const auto& [j, value] : matrix.row(i)) {
      ahead_.put(j);
      work_[j] += scale[i] * value * scale[j];
    }
    ahead_.put(i);
    while (!ahead_.empty()) {
      const int k = ahead_.take();
      const double value = std::exchange(work_[k], 0);
      if (k >= i) {
        upper_.push_back({k, value});
        continue;
      }
      if (pivot(k) <= matrix_rounding || value == 0) continue;
      const double factor = value / pivot(k);
      for (int at = first_[k] + 1; at < first_[k + 1]; ++at) {
        ahead_.put(upper_[at].column);
        work_[upper_[at].column] -= factor * upper_[at].value;
      }
    }
    first_.push_back(static_cast<int>(upper_.size()));
    return pivot(i);
  }

  /// Whether nothing of row `i`, the last one, ties it to rows behind it.
  bool stands_alone(int i) const {
    return std::all_of(upper_.begin() + first_[i] + 1, upper_.end(),
                       [](const SparseRows::Entry& entry) { return std::abs(entry.value) <= matrix_rounding; });
  }

  /// The scaled direction in which row `i`, the last one, moves by 1 and those before it follow.
  Eigen::VectorXd direction(int i) const {
    Eigen::VectorXd v = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(work_.size()));
    v[i] = 1;
    for (int k = i - 1; k >= 0; --k) {
      if (pivot(k) <= matrix_rounding) continue;
      for (int at = first_[k] + 1; at < first_[k + 1]; ++at) v[k] -= upper_[at].value / pivot(k) * v[upper_[at].column];
    }
    return v;
  }

 private:
  /// Each row begins with its diagonal.
  double pivot(int k) const { return upper_[first_[k]].value; }

  Array<int> first_ = {0};
  Array<SparseRows::Entry> upper_;
  Array<double> work_;
  Ahead ahead_;
};

}  // namespace

std::optional<Eigen::VectorXd> negative_direction(const SparseRows& matrix) {
  const Array<double> scale = unit_diagonal(matrix);
  Elimination elimination(matrix.rows());
  for (int i = 0; i < matrix.rows(); ++i) {
    if (elimination.eliminate(matrix, scale) >= -matrix_rounding) continue;
    Eigen::VectorXd direction = elimination.direction(i);
    for (int j = 0; j <= i; ++j) direction[j] *= scale[j];
    return direction;
  }
  return std::nullopt;
}

namespace {

/// Of the bodies that no beam holds, in a machine with forces along its ropes, which have no potential.
std::optional<EnergyCurvature> curvature_of_places(const mechanics::System& s, const mechanics::Configuration& c) {
  mechanics::Evaluation e;
  const std::optional<PlacesStiffness> all = places_stiffness(s, c, e);
  if (!all) return std::nullopt;
  Array<bool> with_beams(all->freedoms.size(), false);
  for (const int row : rows_with_beams(s, *all)) with_beams[row] = true;
  Array<int> left;
  for (int i = 0; i < static_cast<int>(all->freedoms.size()); ++i) {
    if (!with_beams[i]) left.push_back(i);
  }
  EnergyCurvature found;
  Triplets stiffness, units;
  for (int i = 0; i < static_cast<int>(left.size()); ++i) {
    found.rows.push_back({EnergyCurvature::Of::freedom, all->freedoms[left[i]]});
    units.emplace_back(all->freedoms[left[i]], i, 1);
    for (int j = 0; j < static_cast<int>(left.size()); ++j) {
      const double value = all->matrix(left[i], left[j]);
      if (value != 0) stiffness.emplace_back(i, j, value);
    }
  }
  found.matrix = {static_cast<int>(left.size()), stiffness};
  found.unknowns = {s.layout.size, units};
  return found;
}

/// The ropes whose tension is held, in words; empty without one.
std::string of_given_tension(const mechanics::System& s) {
  std::string names;
  for (const FedEnd& end : fed_ends(s)) {
    const std::string& name = s.model.reevings[end.rope].name;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", name);
  }
  return names.empty() ? names : fmt::format(", or give a length instead of the tension of {}", names);
}

/// A fed rope that is a deep loop, with its name; ok without one.
Outcome no_deep_loop(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  const Array<FedEnd> fed = fed_ends(s);
  const auto deep = deep_link(s, fed, c, e);
  if (!deep) return {};
  const mechanics::Layout::Branch& laid = s.layout.branches[*deep];
  const machine::Reeving& rope = s.model.reevings[laid.reeving];
  return infeasible(fmt::format(
      "rope '{}' has its given tension only as a loop of {:.4g} m between '{}' and '{}', {:.4g} m apart, in which more "
      "rope pulls harder: it runs out at the least push; give it more tension, or a length",
      rope.name, c.branches[*deep].length, rope.nodes[laid.from].name, rope.nodes[laid.to].name,
      e.branches[*deep].chord.norm()));
}

}  // namespace

namespace {

/// Directions that no force opposes and none drives: a neutral pivot that is not tied to rows behind it. By the rows.
Array<Eigen::VectorXd> neutral_directions(const SparseRows& matrix) {
  const Array<double> scale = unit_diagonal(matrix);
  Elimination elimination(matrix.rows());
  Array<Eigen::VectorXd> found;
  for (int i = 0; i < matrix.rows(); ++i) {
    if (std::abs(elimination.eliminate(matrix, scale)) > matrix_rounding || !elimination.stands_alone(i)) continue;
    Eigen::VectorXd direction = elimination.direction(i);
    for (int j = 0; j <= i; ++j) direction[j] *= scale[j];
    found.push_back(std::move(direction));
  }
  return found;
}

/// How the places of the bodies move in a direction of the coordinates.
Array<Vector3> ways(const mechanics::System& s, const EnergyCurvature& curvature, const Eigen::VectorXd& direction) {
  Array<Vector3> way(s.model.bodies.size(), Vector3::Zero());
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    const EnergyCurvature::Row& row = curvature.rows[i];
    if (row.of != EnergyCurvature::Of::freedom) continue;
    const mechanics::Layout::Dof& dof = s.layout.dofs[row.index];
    way[dof.body] += direction[i] * dof.way.along;
  }
  return way;
}

/// Where the ropes' forces are no unknowns.
std::string indifferent_by_lengths(const mechanics::System& s, const mechanics::Configuration& c,
                                   const mechanics::Evaluation& e) {
  Array<Vector3> moved(s.model.bodies.size(), Vector3::Zero());
  const double most = noticed * s.layout.length;
  bool any = false;
  for (int body = 0; body < static_cast<int>(moved.size()); ++body) {
    if (s.model.bodies[body].of_rope) continue;
    moved[body] = c.bodies[body].position - s.model.bodies[body].position;
    any = any || moved[body].norm() > most;
  }
  const auto curvature = any && !s.layout.coordinate_row ? energy_curvature(s, c, e) : std::nullopt;
  if (!curvature) return {};
  std::string words;
  for (const Eigen::VectorXd& direction : neutral_directions(curvature->matrix)) {
    const Array<Vector3> way = ways(s, *curvature, direction);
    double along = 0, size = 0;
    for (std::size_t body = 0; body < way.size(); ++body) {
      along += way[body].dot(moved[body]);
      size += way[body].squaredNorm();
    }
    if (size <= matrix_rounding * matrix_rounding * direction.squaredNorm()) continue;
    for (std::size_t body = 0; body < way.size(); ++body) {
      const double far_by = std::abs(along) / size * way[body].norm();
      if (!(far_by > most)) continue;
      words += fmt::format("{}'{}' by {:.3g} m", words.empty() ? "" : ", ", s.model.bodies[body].name, far_by);
    }
  }
  return words;
}

}  // namespace

std::string indifferent(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  // what a tension holds across a rope shows beside what the rope holds along itself
  auto soft = with_softer_ropes(s, c, std::sqrt(1 / matrix_rounding));
  if (!soft) return indifferent_by_lengths(s, c, e);
  const mechanics::System softer{.model = soft->model, .layout = soft->layout, .coordinate = s.coordinate};
  mechanics::Evaluation there;
  return mechanics::evaluate(softer, soft->c, there) ? std::string() : indifferent_by_lengths(softer, soft->c, there);
}

Stability stability(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e) {
  Stability result;
  result.outcome = no_deep_loop(s, c, e);
  if (!result.outcome.ok()) return result;
  if (!s.layout.pieces.empty()) {
    result.outcome = beams_stay(s, c);
    result.beam = !result.outcome.ok();
    if (result.beam) return result;
  }
  const auto curvature = has_rope_loads(s) ? curvature_of_places(s, c) : energy_curvature(s, c, e);
  if (!curvature) return result;
  const auto direction = negative_direction(curvature->matrix);
  if (!direction) return result;
  // a body that moves tells more than the ropes that follow it
  Eigen::Index most = 0;
  double size = 0;
  for (Eigen::Index i = 0; i < direction->size(); ++i) {
    const EnergyCurvature::Row& row = curvature->rows[i];
    const bool moves = row.of == EnergyCurvature::Of::freedom;
    const bool turns = moves && s.layout.dofs[row.index].way.about != Vector3::Zero();
    const double unit = moves ? weight_of_bodies * (turns ? s.layout.length : 1) : 1;
    const double weight = unit * std::abs((*direction)[i]);
    if (weight <= size) continue;
    size = weight;
    most = i;
  }
  const EnergyCurvature::Row& row = curvature->rows[most];
  result.rope = row.of != EnergyCurvature::Of::freedom;
  result.push = curvature->unknowns.times(*direction);
  result.push *= noticed * s.layout.length / result.push.cwiseAbs().maxCoeff();
  // a fall from a place of symmetry, which nothing pushes, leads back to it
  const char* const beside = result.rope ? "" : ", or describe it a little off this place, where it is meant to rest";
  result.outcome = infeasible(
      fmt::format("the equilibrium found is not one to stay in: at the least push {}; hold it by another rope, or "
                  "change lengths or weights{}{}",
                  words(s, row), of_given_tension(s), beside));
  return result;
}

}  // namespace taut::solve
