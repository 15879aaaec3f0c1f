#include "taut/solve/rest/newton.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/math/linear_system.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "taut/mechanics/stiff_branch.hpp"
#include "taut/solve/rest/fed_rope.hpp"

namespace taut::solve {
namespace {

constexpr double least_part = 1.0 / 1024;
constexpr double longest_turn = 0.5;       // rad per step
constexpr double longest_move = 0.5;       // of the machine's extent per step
constexpr double shortest_branch = 0.4;    // of its length before the step
constexpr double rounding_strain = 4e-15;  // of EA: what rounded coordinates leave of a balance
constexpr double most_rounding = 1e-8;     // of the largest force: more of it is no balance
constexpr double least_free = 1e-6;        // of what no row determines: less is rounding
constexpr double most_fall = 0.7;          // of a rope's force and weight per step
constexpr double forces_settled = 1e-7;    // of the largest: rounded lengths may leave so much of a last step
constexpr double alone = 0.01;  // of the drag between the ends of a branch: of a body against the ground; turns in full
constexpr double finest_step = 1e-12;  // of the machine's length: a smaller step is rounding

/// Calls `f` with each branch and unknown of a force.
template <class F>
void for_each_force(const mechanics::System& s, const F& f) {
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    const mechanics::Layout::Branch& laid = s.layout.branches[k];
    if (!laid.force) continue;
    const int count = mechanics::force_count(s.model.reevings[laid.reeving]);
    for (int i = 0; i < count; ++i) f(static_cast<int>(k), *laid.force + i);
  }
}

/// The largest change of a force among the unknowns, as a share of the largest force. A slack rope has none.
double force_change(const mechanics::System& s, const mechanics::Evaluation& e, const Eigen::VectorXd& change) {
  double most = 0;
  for_each_force(s, [&](int branch, int unknown) {
    if (!e.branches[branch].slack) most = std::max(most, std::abs(change[unknown]));
  });
  return most > 0 ? most / e.largest_force : 0;
}

/// The scaled linear system of one point.
class Linear {
 public:
  explicit Linear(const mechanics::System& system) : columns_(system.layout.size) {
    columns_.setConstant(system.layout.length);
    for (std::size_t i = 0; i < system.layout.dofs.size(); ++i) {
      if (system.layout.dofs[i].way.about != Vector3::Zero()) columns_[static_cast<Eigen::Index>(i)] = 1;
    }
    for (const mechanics::Layout::Rope& rope : system.layout.ropes) {
      if (rope.open_load) columns_[*rope.open_load] = std::max(1.0, system.layout.heaviest);
    }
    if (system.layout.hold) columns_[system.layout.hold->unknown] = std::max(1.0, system.layout.heaviest);
    mechanics::scale_beams(system, columns_);
  }

  /// Takes the forces that are unknowns in parts of what they are now.
  void scale_forces(const mechanics::System& s, const mechanics::Configuration& c) {
    for_each_force(s, [&](int branch, int unknown) {
      columns_[unknown] = std::max({1.0, s.layout.heaviest, c.forces[branch].norm()});
    });
  }

  void factor(const Entries& J) { system_.factor(J, columns_); }
  /// The scaled step -J^-1 r.
  Eigen::VectorXd solve(const Eigen::VectorXd& r) const { return system_.solve(-r); }
  Eigen::VectorXd unscaled(const Eigen::VectorXd& step) const { return columns_.cwiseProduct(step); }
  bool singular() const { return system_.singular(); }
  Eigen::VectorXd undetermined() const { return system_.undetermined(); }

 private:
  Eigen::VectorXd columns_;
  LinearSystem system_;
};

/// A branch whose force no row determines.
std::optional<int> undetermined_branch(const mechanics::System& s, const Linear& linear) {
  const Eigen::VectorXd free = linear.undetermined();
  std::optional<int> worst;
  double most = least_free;
  for_each_force(s, [&](int branch, int unknown) {
    if (free.size() == 0 || free[unknown] <= most) return;
    most = free[unknown];
    worst = branch;
  });
  return worst;
}

/// The part of a step that leaves a rope with weight a share of its pull.
double longest_fall(const mechanics::System& s, const mechanics::Configuration& c, int k, const Eigen::VectorXd& step) {
  const mechanics::Layout::Branch& laid = s.layout.branches[k];
  if (!laid.force || s.model.reevings[laid.reeving].weight == 0) return 1;
  const Vector3& force = c.forces[k];
  const double weight = s.model.reevings[laid.reeving].weight * c.branches[k].length;
  const double falls = -force.normalized().dot(step.segment<3>(*laid.force)),
               most = most_fall * (force.norm() + weight);
  return falls > most ? most / falls : 1;
}

/// The largest part of a step, at most 1, that keeps branches from vanishing and bodies from flying away.
double longest_part(const mechanics::System& s, const mechanics::Configuration& c, const Eigen::VectorXd& step) {
  double part = 1;
  for (std::size_t i = 0; i < s.layout.dofs.size(); ++i) {
    const bool turns = s.layout.dofs[i].way.about != Vector3::Zero();
    const double most = turns ? longest_turn : longest_move * s.layout.extent;
    part = std::min(part, most / std::max(most, std::abs(step[static_cast<Eigen::Index>(i)])));
  }
  for (std::size_t k = 0; k < c.branches.size(); ++k) {
    const double change = step[s.layout.branches[k].unknown];
    if (change < 0) part = std::min(part, (1 - shortest_branch) * c.branches[k].length / -change);
    // a rope whose length follows has a second answer, a loop of kilometres whose weight pulls
    const double most = std::max(c.branches[k].length, s.layout.length);
    if (change > most) part = std::min(part, most / change);
    part = std::min(part, longest_fall(s, c, static_cast<int>(k), step));
  }
  return part;
}

bool settled(const mechanics::System& s, const mechanics::Evaluation& e, double tolerance, double ulps = 1) {
  const mechanics::Misfit m = mechanics::misfit(s, e);
  // A machine whose forces are all within the rounding of its stiffest branch bears none: there is no balance to lose.
  const double of_lengths = rounding_strain * s.layout.stiffest;
  const double most = e.largest_force > of_lengths ? most_rounding * e.largest_force : ulps * of_lengths;
  const double rounding = std::min(ulps * of_lengths, most);
  return m.force <= std::max(tolerance * e.largest_force, rounding) &&
         std::max(m.length, m.span) <= tolerance * s.layout.length;
}

/// Calls `f` with each row of a rope that flows over a contact or is fed in, and what flowed: the sum of the lengths
/// of its branches first .. last times a sign. How much passed a contact is what its branches on the side of its fixed
/// end have lost.
template <class F>
void for_each_flow(const mechanics::System& s, const Array<FedEnd>& fed, const F& f) {
  for (const mechanics::Layout::Turn& t : s.layout.turns) {
    const machine::Reeving& reeving = s.model.reevings[t.reeving];
    if (reeving.nodes[t.node].kind != machine::NodeKind::contact) continue;
    const mechanics::Layout::Rope& rope = s.layout.ropes[t.reeving];
    const bool fixed_at_end = reeving.given == machine::Given::tension_at_start;
    const int first = fixed_at_end ? t.after : rope.first, last = fixed_at_end ? rope.first + rope.count - 1 : t.before;
    f(*t.row, first, last, fixed_at_end ? -1 : 1);
  }
  for (const FedEnd& end : fed) f(end.row, end.first, end.last, -1);
}

/// A drag between the ends of each branch: neighbours that fall together fall freely, so that a long chain takes its
/// curve at once, where against the ground it would be drawn taut from its ends, rope by rope.
void add_drag_between(const mechanics::System& s, const mechanics::Configuration& c, double drag, Entries& J) {
  for (const mechanics::Layout::Branch& branch : s.layout.branches) {
    const Array<machine::Node>& nodes = s.model.reevings[branch.reeving].nodes;
    const machine::Place* const ends[] = {&nodes[branch.from].at, &nodes[branch.to].at};
    const auto for_each_dof = [&](const auto& f) {
      for (int side = 0; side < 2; ++side) {
        const int body = ends[side]->body;
        if (body == machine::ground) continue;
        const Vector3 arm = c.bodies[body].orientation * ends[side]->at;
        for (int i = s.layout.first_dof[body]; i < s.layout.first_dof[as_size(body) + 1]; ++i) {
          const machine::Freedom& way = s.layout.dofs[i].way;
          f(i, Vector3((side == 0 ? 1 : -1) * (way.along + way.about.cross(arm))));
        }
      }
    };
    for_each_dof([&](int i, const Vector3& row) {
      for_each_dof([&](int j, const Vector3& column) { J.add(i, j, -drag * row.dot(column)); });
    });
  }
}

/// Lets the bodies and the ropes over their contacts move against a drag (N/m) instead of at once: what moves does so
/// towards equilibrium. A rope flows to where its tension is larger; a fed rope is paid out while its tension is above
/// the given one.
void add_drag(const mechanics::System& s, const mechanics::Configuration& c, const Array<FedEnd>& fed, double drag,
              double ropes, Entries& J) {
  add_drag_between(s, c, drag, J);
  for (int i = 0; i < static_cast<int>(s.layout.dofs.size()); ++i) {
    const bool turns = s.layout.dofs[i].way.about != Vector3::Zero();
    J.add(i, i, -drag * (turns ? s.layout.length * s.layout.length : alone));
  }
  for_each_flow(s, fed, [&](int row, int first, int last, int sign) {
    for (int k = first; k <= last; ++k) J.add(row, s.layout.branches[k].unknown, sign * ropes * drag);
  });
}

/// Whether the forces after a step still push the bodies on along it: their fall is slower than it could be. Where
/// ropes flow too, a pull may push on for ever.
bool pushes_on(const mechanics::System& s, const Array<FedEnd>& fed, const Eigen::VectorXd& step,
               const Eigen::VectorXd& residual) {
  bool flows = false;
  for_each_flow(s, fed, [&](int, int, int, int) { flows = true; });
  const auto freedoms = static_cast<Eigen::Index>(s.layout.dofs.size());
  return !flows && residual.head(freedoms).dot(step.head(freedoms)) > 0;
}

/// A configuration that is tried, evaluated, and the scaled step that follows by the linear system that led there.
struct Trial {
  mechanics::Configuration c;
  mechanics::Evaluation e;
  Eigen::VectorXd next = {};
};

/// Room for the derivatives of an iteration.
struct Rates {
  Entries J;
  Array<mechanics::BranchColumns> columns;
};

/// A Newton step: from where, what it changes, the linear system that gave it and its size as that scales it.
struct NewtonStep {
  const mechanics::Configuration& from;
  mechanics::Change change;
  Linear& linear;
  double size;
};

/// Empty where the linear system gives no numbers.
std::optional<NewtonStep> newton_step(const mechanics::System& s, const mechanics::Configuration& c,
                                      const mechanics::Evaluation& e, Rates& rates, Linear& linear) {
  mechanics::jacobian(s, c, e, rates.J, rates.columns);
  linear.factor(rates.J);
  const Eigen::VectorXd step = linear.solve(e.residual);
  if (!step.allFinite()) return std::nullopt;
  return NewtonStep{.from = c,
                    .change = mechanics::change_of(s, c, e, rates.columns, linear.unscaled(step)),
                    .linear = linear,
                    .size = step.norm()};
}

/// Halves a Newton step until a part of it brings the next step nearer and `fits`. False where no part does.
template <class Fits>
bool gains(const mechanics::System& s, const NewtonStep& step, double tolerance, Trial& tried,
           std::optional<mechanics::NoBranch>& stopped, const Fits& fits) {
  for (double part = longest_part(s, step.from, step.change.step); part > least_part; part /= 2) {
    mechanics::move(s, step.from, step.change, part, tried.c);
    stopped = mechanics::evaluate(s, tried.c, tried.e);
    if (stopped || !tried.e.residual.allFinite()) continue;
    tried.next = step.linear.solve(tried.e.residual);
    if (!(tried.next.norm() <= (1 - part / 4) * step.size) && !settled(s, tried.e, tolerance)) continue;
    if (fits()) return true;
  }
  return false;
}

/// Tries the step that follows by the linear system that led to `c`: forces in balance to the tolerance leave a soft
/// freedom (the pitch of a carriage) open by much more. False where that step is rounding, or too long.
bool refined(const mechanics::System& s, const Linear& linear, const Rates& rates, const mechanics::Configuration& c,
             const mechanics::Evaluation& e, Trial& tried) {
  if (!tried.next.allFinite() || tried.next.norm() <= finest_step) return false;
  const mechanics::Change change = mechanics::change_of(s, c, e, rates.columns, linear.unscaled(tried.next));
  if (longest_part(s, c, change.step) < 1) return false;
  mechanics::move(s, c, change, 1, tried.c);
  return !mechanics::evaluate(s, tried.c, tried.e);
}

}  // namespace

Iteration newton(const mechanics::System& s, mechanics::Configuration& c, mechanics::Evaluation& e, double tolerance,
                 int most_steps) {
  Iteration it;
  it.stopped = mechanics::evaluate(s, c, e);
  if (it.stopped) return it;
  Linear linear(s);
  const Array<FedEnd> fed = fed_ends(s);
  Rates rates;
  Trial tried{.c = c, .e = {}};
  if (settled(s, e, tolerance)) {
    it.converged = true;
    return it;
  }
  for (; it.steps < most_steps; ++it.steps) {
    const auto step = newton_step(s, c, e, rates, linear);
    it.singular = linear.singular();
    if (!step) return it;
    it.deep.reset();
    const auto taut = [&] {
      it.deep = deep_link(s, fed, tried.c, tried.e);
      return !it.deep;
    };
    if (!gains(s, *step, tolerance, tried, it.stopped, taut)) {
      // no step gains: rounding, of tangent points for one, may leave a little more than asked
      it.converged = settled(s, e, 8 * tolerance, 5);
      return it;
    }
    std::swap(c, tried.c);
    std::swap(e, tried.e);
    if (settled(s, e, tolerance)) {
      ++it.steps;
      it.converged = true;
      if (refined(s, linear, rates, c, e, tried) && settled(s, tried.e, tolerance) && taut()) {
        std::swap(c, tried.c);
        std::swap(e, tried.e);
      }
      it.deep.reset();
      return it;
    }
  }
  return it;
}

Iteration newton_with_forces(const mechanics::System& s, mechanics::Configuration& c, mechanics::Evaluation& e,
                             double tolerance, int most_steps) {
  Iteration it;
  it.stopped = mechanics::evaluate(s, c, e);
  if (it.stopped) return it;
  Linear linear(s);
  Rates rates;
  Trial tried{.c = c, .e = {}};
  double before = HUGE_VAL;
  for (; it.steps < most_steps; ++it.steps) {
    linear.scale_forces(s, c);
    const auto step = newton_step(s, c, e, rates, linear);
    it.singular = linear.singular();
    if (!step) return it;
    const double open = force_change(s, e, step->change.step);
    const bool closed = settled(s, e, tolerance);
    const bool known = open <= tolerance || (open > before / 2 && open <= forces_settled);
    if (closed && known) {
      it.converged = true;
      it.undetermined = undetermined_branch(s, linear);
      return it;
    }
    before = closed ? open : HUGE_VAL;
    if (!gains(s, *step, tolerance, tried, it.stopped, [] { return true; })) {
      it.converged = settled(s, e, 8 * tolerance, 5) && open <= forces_settled;
      it.undetermined = undetermined_branch(s, linear);
      return it;
    }
    std::swap(c, tried.c);
    std::swap(e, tried.e);
  }
  return it;
}

Iteration relax(const mechanics::System& s, mechanics::Configuration& c, mechanics::Evaluation& e, int most_steps,
                double most_growth, double ropes) {
  Iteration it;
  it.stopped = mechanics::evaluate(s, c, e);
  if (it.stopped) return it;
  Linear linear(s);
  const Array<FedEnd> fed = fed_ends(s);
  Entries J;
  Array<mechanics::BranchColumns> columns;
  mechanics::Configuration tried = c;
  mechanics::Evaluation there;
  double drag = e.largest_force / s.layout.length;
  double now = mechanics::misfit(s, e).force;
  for (; it.steps < most_steps; ++it.steps) {
    if (settled(s, e, 1e-4)) {
      it.converged = true;
      return it;
    }
    mechanics::jacobian(s, c, e, J, columns);
    add_drag(s, c, fed, drag, ropes, J);
    linear.factor(J);
    const mechanics::Change change = mechanics::change_of(s, c, e, columns, linear.unscaled(linear.solve(e.residual)));
    if (!change.step.allFinite()) return it;
    mechanics::move(s, c, change, longest_part(s, c, change.step), tried);
    it.stopped = mechanics::evaluate(s, tried, there);
    const bool fails = it.stopped || !there.residual.allFinite();
    const double then = fails ? 0 : mechanics::misfit(s, there).force;
    it.deep = fails ? std::nullopt : deep_link(s, fed, tried, there);
    if (fails || it.deep || !(then <= most_growth * now)) {
      drag *= 8;
      if (!(drag < 1e12 * e.largest_force / s.layout.extent)) return it;
      continue;
    }
    const bool on = pushes_on(s, fed, change.step, there.residual);
    std::swap(c, tried);
    std::swap(e, there);
    drag *= std::clamp(then / now, 0.2, on ? 0.5 : 2.0);
    now = then;
  }
  return it;
}

}  // namespace taut::solve
