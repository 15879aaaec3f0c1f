#include "taut/analysis/newton.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "taut/analysis/beam_piece.hpp"
#include "taut/analysis/fed_rope.hpp"
#include "taut/math/dense_lu.hpp"

namespace taut::analysis {
namespace {

constexpr double least_part = 1.0 / 1024;
constexpr double singular_below = 1e-14;
constexpr double longest_turn = 0.5;       // rad per step
constexpr double longest_move = 0.5;       // of the machine's length per step
constexpr double shortest_branch = 0.4;    // of its length before the step
constexpr double rounding_strain = 4e-15;  // of EA: what rounded coordinates leave of a balance

/// The scaled linear system of one point.
class Linear {
 public:
  Linear(const System& system, Eigen::Index n) : columns_(n), rows_(n) {
    columns_.setConstant(system.layout.length);
    for (std::size_t i = 0; i < system.layout.dofs.size(); ++i) {
      if (system.layout.dofs[i].way.about != Vector3::Zero()) columns_[static_cast<Eigen::Index>(i)] = 1;
    }
    for (const Layout::Rope& rope : system.layout.ropes) {
      if (rope.open_load >= 0) columns_[rope.open_load] = std::max(1.0, system.layout.heaviest);
    }
    if (system.layout.hold >= 0) columns_[system.layout.hold] = std::max(1.0, system.layout.heaviest);
    scale_beams(system, columns_);
  }

  void factor(const Eigen::MatrixXd& J) {
    scaled_ = J * columns_.asDiagonal();
    for (Eigen::Index i = 0; i < rows_.size(); ++i) {
      const double size = scaled_.row(i).cwiseAbs().maxCoeff();
      rows_[i] = size > 0 && std::isfinite(size) ? 1 / size : 1;
      scaled_.row(i) *= rows_[i];
    }
    lu_.factor(scaled_);
    singular_ = !(lu_.pivot_ratio() > singular_below);
    if (singular_) {
      orthogonal_.setThreshold(1e-12);
      orthogonal_.compute(scaled_);
    }
  }

  /// The scaled step -J^-1 r, of least length where J is singular.
  Eigen::VectorXd solve(const Eigen::VectorXd& r) const {
    const Eigen::VectorXd right = -rows_.cwiseProduct(r);
    return singular_ ? Eigen::VectorXd(orthogonal_.solve(right)) : lu_.solve(right);
  }

  Eigen::VectorXd unscaled(const Eigen::VectorXd& step) const { return columns_.cwiseProduct(step); }
  bool singular() const { return singular_; }

 private:
  Eigen::VectorXd columns_, rows_;
  Eigen::MatrixXd scaled_;
  DenseLu lu_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> orthogonal_;
  bool singular_ = false;
};

/// The largest part of a step, at most 1, that keeps branches from vanishing and bodies from flying away.
double longest_part(const System& s, const Configuration& c, const Eigen::VectorXd& step) {
  double part = 1;
  for (std::size_t i = 0; i < s.layout.dofs.size(); ++i) {
    const bool turns = s.layout.dofs[i].way.about != Vector3::Zero();
    const double most = turns ? longest_turn : longest_move * s.layout.length;
    part = std::min(part, most / std::max(most, std::abs(step[static_cast<Eigen::Index>(i)])));
  }
  for (std::size_t k = 0; k < c.links.size(); ++k) {
    const double change = step[s.layout.links[k].unknown];
    if (change < 0) part = std::min(part, (1 - shortest_branch) * c.links[k].length / -change);
    // a rope whose length follows has a second answer, a loop of kilometres whose weight pulls
    const double most = std::max(c.links[k].length, s.layout.length);
    if (change > most) part = std::min(part, most / change);
  }
  return part;
}

bool settled(const System& s, const Evaluation& e, double tolerance, double ulps = 1) {
  const Misfit m = misfit(s, e);
  const double rounding = ulps * rounding_strain * s.layout.stiffest;
  return m.force <= std::max(tolerance * e.largest_force, rounding) &&
         std::max(m.length, m.span) <= tolerance * s.layout.length;
}

/// Lets the bodies and the ropes over their contacts move against a drag (N/m) instead of at once: what moves does so
/// towards equilibrium. A rope flows to where its tension is larger; how much passed a contact is what its branches
/// on the side of its fixed end have lost. A fed rope is paid out while its tension is above the given one.
void add_drag(const System& s, const std::vector<FedEnd>& fed, double drag, double ropes, Eigen::MatrixXd& J) {
  for (std::size_t i = 0; i < s.layout.dofs.size(); ++i) {
    const bool turns = s.layout.dofs[i].way.about != Vector3::Zero();
    const auto k = static_cast<Eigen::Index>(i);
    J(k, k) -= drag * (turns ? s.layout.length * s.layout.length : 1);
  }
  for (const Layout::Turn& t : s.layout.turns) {
    const model::Reeving& reeving = s.model.reevings[static_cast<std::size_t>(t.reeving)];
    if (reeving.nodes[static_cast<std::size_t>(t.node)].kind != model::NodeKind::contact) continue;
    const Layout::Rope& rope = s.layout.ropes[static_cast<std::size_t>(t.reeving)];
    const bool fixed_at_end = reeving.given == model::Given::tension_at_start;
    const int first = fixed_at_end ? t.after : rope.first, last = fixed_at_end ? rope.first + rope.count : t.after;
    for (int k = first; k < last; ++k) {
      J(t.row, s.layout.links[static_cast<std::size_t>(k)].unknown) += fixed_at_end ? -ropes * drag : ropes * drag;
    }
  }
  for (const FedEnd& end : fed) {
    for (int k = end.first; k <= end.last; ++k) {
      J(end.row, s.layout.links[static_cast<std::size_t>(k)].unknown) -= ropes * drag;
    }
  }
}

}  // namespace

Iteration newton(const System& s, Configuration& c, Evaluation& e, double tolerance, int most_steps) {
  Iteration it;
  it.stopped = evaluate(s, c, e);
  if (it.stopped) return it;
  Linear linear(s, s.layout.size);
  const std::vector<FedEnd> fed = fed_ends(s);
  Eigen::MatrixXd J;
  std::vector<BranchColumns> columns;
  Configuration tried = c;
  Evaluation there;
  for (; it.steps < most_steps; ++it.steps) {
    if (settled(s, e, tolerance)) {
      it.converged = true;
      return it;
    }
    jacobian(s, c, e, J, columns);
    linear.factor(J);
    it.singular = linear.singular();
    const Eigen::VectorXd step = linear.solve(e.residual);
    if (!step.allFinite()) return it;
    const Change change = change_of(s, c, e, columns, linear.unscaled(step));
    const double size = step.norm();
    bool accepted = false;
    it.deep = -1;
    for (double part = longest_part(s, c, change.step); part > least_part; part /= 2) {
      move(s, c, change, part, tried);
      it.stopped = evaluate(s, tried, there);
      if (it.stopped || !there.residual.allFinite()) continue;
      const double next = linear.solve(there.residual).norm();
      if (!(next <= (1 - part / 4) * size) && !settled(s, there, tolerance)) continue;
      it.deep = deep_link(s, fed, tried, there);
      accepted = it.deep < 0;
      if (accepted) break;
    }
    if (!accepted) {
      // no step gains: rounding, of tangent points for one, may leave a little more than asked
      it.converged = settled(s, e, 8 * tolerance, 5);
      return it;
    }
    std::swap(c, tried);
    std::swap(e, there);
  }
  it.converged = settled(s, e, tolerance);
  return it;
}

Iteration relax(const System& s, Configuration& c, Evaluation& e, int most_steps, double most_growth, double ropes) {
  Iteration it;
  it.stopped = evaluate(s, c, e);
  if (it.stopped) return it;
  Linear linear(s, s.layout.size);
  const std::vector<FedEnd> fed = fed_ends(s);
  Eigen::MatrixXd J;
  std::vector<BranchColumns> columns;
  Configuration tried = c;
  Evaluation there;
  double drag = e.largest_force / s.layout.length;
  double now = misfit(s, e).force;
  for (; it.steps < most_steps; ++it.steps) {
    if (settled(s, e, 1e-4)) {
      it.converged = true;
      return it;
    }
    jacobian(s, c, e, J, columns);
    add_drag(s, fed, drag, ropes, J);
    linear.factor(J);
    const Change change = change_of(s, c, e, columns, linear.unscaled(linear.solve(e.residual)));
    if (!change.step.allFinite()) return it;
    move(s, c, change, longest_part(s, c, change.step), tried);
    it.stopped = evaluate(s, tried, there);
    const bool fails = it.stopped || !there.residual.allFinite();
    const double then = fails ? 0 : misfit(s, there).force;
    it.deep = fails ? -1 : deep_link(s, fed, tried, there);
    if (fails || it.deep >= 0 || !(then <= most_growth * now)) {
      drag *= 8;
      if (!(drag < 1e12 * e.largest_force / s.layout.length)) return it;
      continue;
    }
    std::swap(c, tried);
    std::swap(e, there);
    drag *= std::clamp(then / now, 0.2, 2.0);
    now = then;
  }
  return it;
}

}  // namespace taut::analysis
