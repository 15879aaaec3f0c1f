#include "taut/solve/stiff_ropes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/mechanics/stiff_branch.hpp"

namespace taut::solve {
namespace {

constexpr double usual_strain = 1e-3;     ///< of a rope at work
constexpr double rounded_length = 4e-15;  ///< of EA: what rounded coordinates leave of a tension
constexpr double rough_balance = 1e-9;    ///< of a force
constexpr double rounded_way = 1e-15;     ///< of a way between places that do not move
constexpr double open_way = 1e-9;         ///< of one over bodies, where the iteration has failed

std::string branch_of(const mechanics::System& s, int index) {
  const mechanics::Layout::Branch& l = s.layout.branches[index];
  const machine::Reeving& rope = s.model.reevings[l.reeving];
  return fmt::format("rope '{}' between '{}' and '{}'", rope.name, rope.nodes[l.from].name, rope.nodes[l.to].name);
}

/// The branch with the largest force of those that do not stretch.
std::optional<int> hardest(const mechanics::System& s, const mechanics::Evaluation& e) {
  std::optional<int> worst;
  for (int k = 0; k < static_cast<int>(e.branches.size()); ++k) {
    if (!std::isinf(s.model.reevings[s.layout.branches[k].reeving].stiffness)) continue;
    if (!worst || e.branches[k].T_to > e.branches[*worst].T_to) worst = k;
  }
  return worst;
}

/// By how much a rope that does not stretch is shorter than its way, as a share; 0 where that is not certain: where
/// bodies stand as the equations that are left open have them, a little is their error.
struct Shortage {
  double share = 0, length = 0, way = 0;
};

Shortage shortage(const mechanics::System& s, const mechanics::Evaluation& e, std::size_t r, bool converged) {
  const machine::Reeving& rope = s.model.reevings[r];
  const mechanics::Layout::Rope& l = s.layout.ropes[r];
  const bool follows = l.row == s.layout.coordinate_row || l.row == s.layout.height_row;
  if (!std::isinf(rope.stiffness) || rope.given != machine::Given::length || follows) return {};
  const bool fixed = std::all_of(rope.nodes.begin(), rope.nodes.end(),
                                 [](const machine::Node& node) { return node.at.body == machine::ground; });
  if (converged && !fixed) return {};
  Shortage found{.share = 0, .length = rope.value * (1 + rope.thermal_strain), .way = 0};
  for (int k = l.first; k < l.first + l.count; ++k) found.way += e.branches[k].chord.norm();
  for (int t = l.first_turn; t < l.first_turn + l.turn_count; ++t) found.way += mechanics::arc(s, e, t).length;
  const double share = found.way / found.length - 1;
  if (share > (fixed ? rounded_way : open_way)) found.share = share;
  return found;
}

/// A rope that does not stretch, shorter than its way, in words; empty without one.
std::string short_rope(const mechanics::System& s, const mechanics::Evaluation& e, bool converged) {
  Shortage worst;
  const std::string* name = nullptr;
  for (std::size_t r = 0; r < s.model.reevings.size(); ++r) {
    const Shortage own = shortage(s, e, r, converged);
    if (!(own.share > worst.share)) continue;
    worst = own;
    name = &s.model.reevings[r].name;
  }
  if (name == nullptr) return {};
  return fmt::format(
      "rope '{}' does not reach: {:.12g} m of a rope that does not stretch over a way of {:.12g} m; give it more "
      "length or a stiffness",
      *name, worst.length, worst.way);
}

Outcome why_unsettled(const mechanics::System& s, const mechanics::Evaluation& e, const Iteration& it) {
  if (const std::string why = short_rope(s, e, it.converged); !why.empty()) return infeasible(why);
  if (it.undetermined) {
    return infeasible(
        fmt::format("the tension of {} is not determined: ropes that do not stretch, or hardly, share their load in "
                    "more than one way here; give the ropes the stiffness that they have, or leave out what holds "
                    "the same twice",
                    branch_of(s, *it.undetermined)));
  }
  const mechanics::Misfit m = mechanics::misfit(s, e);
  const int worst = hardest(s, e).value_or(0);
  return not_converged(
      fmt::format("the tensions of ropes that hardly stretch did not settle ({:.3g} N and {:.3g} m are open; largest: "
                  "{:.6g} N in {}); give the ropes the stiffness that they have",
                  m.force, std::max(m.length, m.span), e.branches[worst].T_to, branch_of(s, worst)));
}

}  // namespace

double force_scale(const machine::Model& model, const mechanics::Layout& layout) {
  double force = layout.heaviest;
  for (const machine::Reeving& rope : model.reevings) {
    const bool tension = rope.given == machine::Given::tension_at_start || rope.given == machine::Given::tension_at_end;
    if (tension) force = std::max(force, rope.value);
  }
  if (force > 0) return std::max(force, 1e-6);
  for (const machine::Reeving& rope : model.reevings) {
    if (std::isfinite(rope.stiffness)) force = std::max(force, usual_strain * rope.stiffness);
  }
  return std::max(force, 1e-6);
}

bool has_stiff_ropes(const machine::Model& model, double force) {
  return std::any_of(model.reevings.begin(), model.reevings.end(),
                     [&](const machine::Reeving& rope) { return rope.stiffness > found_by_length * force; });
}

machine::Model softened(machine::Model model, double most) {
  for (machine::Reeving& rope : model.reevings) rope.stiffness = std::min(rope.stiffness, most);
  return model;
}

machine::State with_stiffness(machine::State state, const machine::Model& before, const machine::Model& after) {
  for (std::size_t r = 0; r < after.reevings.size(); ++r) {
    const double was = before.reevings[r].stiffness, is = after.reevings[r].stiffness;
    if (was == is) continue;
    for (machine::BranchState& branch : state.branches[r]) {
      if (!branch.force) continue;
      const double T = std::hypot(branch.force->H, branch.force->V);
      branch.length *= (1 + T / was) / (1 + T / is);
    }
  }
  return state;
}

std::optional<Softer> with_softer_ropes(const mechanics::System& s, const mechanics::Configuration& c,
                                        double stiffest) {
  double force = force_scale(s.model, s.layout);
  const auto stiff = [&](const machine::Reeving& rope) { return rope.stiffness > stiffest * force; };
  const bool by_force = !c.forces.empty();
  if (!by_force && std::none_of(s.model.reevings.begin(), s.model.reevings.end(), stiff)) return std::nullopt;
  Softer soft{.model = {}, .layout = s.layout, .c = c};
  mechanics::Evaluation e;
  if (mechanics::evaluate(s, soft.c, e)) return std::nullopt;
  // ropes may hold more against each other than they carry
  for (const mechanics::Branch& b : e.branches) force = std::max({force, b.T_from, b.T_to});
  soft.model = softened(s.model, stiffest * force);
  soft.c.forces.clear();
  for (std::size_t k = 0; k < c.branches.size(); ++k) {
    mechanics::Layout::Branch& laid = soft.layout.branches[k];
    if (laid.force) soft.layout.size -= mechanics::force_count(s.model.reevings[laid.reeving]);
    laid.force.reset();
    if (e.branches[k].slack) continue;
    const double was = s.model.reevings[laid.reeving].stiffness, is = soft.model.reevings[laid.reeving].stiffness;
    const Vector3 F = (e.branches[k].pull_from + e.branches[k].pull_to) / 2;
    machine::BranchState& branch = soft.c.branches[k];
    branch.force = rope::CatenaryForce{.H = std::hypot(F.x(), F.y()), .V = F.z()};
    branch.length *= (1 + F.norm() / was) / (1 + F.norm() / is);
  }
  return soft;
}

bool is_rough(const mechanics::System& s, const mechanics::Evaluation& e) {
  const double largest = e.largest_force;
  if (mechanics::misfit(s, e).force > rough_balance * largest) return true;
  for (std::size_t r = 0; r < s.layout.ropes.size(); ++r) {
    const machine::Reeving& rope = s.model.reevings[r];
    const int row = s.layout.ropes[r].row;
    if (rope.given == machine::Given::length || row == s.layout.coordinate_row || row == s.layout.height_row) continue;
    if (std::abs(e.residual[row]) > rough_balance * std::abs(rope.value)) return true;
  }
  return false;
}

StiffAnswer with_stiff_ropes(const machine::Model& model, const StiffAnswer& near, double coordinate, double softest,
                             const EquilibriumOptions& options) {
  StiffAnswer s;
  const double force = force_scale(model, near.layout);
  const double limit = options.tolerance * force / rounded_length;
  s.layout = mechanics::with_forces(near.layout, model, limit, std::min(softest, found_by_length * force));
  const mechanics::System system{.model = model, .layout = s.layout, .coordinate = coordinate};
  s.c = mechanics::with_forces(system, near.c, near.e);
  for (std::size_t k = 0; k < s.c.branches.size(); ++k) {
    const double is = model.reevings[s.layout.branches[k].reeving].stiffness, was = std::min(softest, is);
    const double T = std::max(0.0, s.c.forces[k].norm());
    const bool pulls = near.e.branches[k].T_to > 0;
    if (s.layout.branches[k].force && pulls) s.c.branches[k].length *= (1 + T / was) / (1 + T / is);
  }
  const Iteration it = newton_with_forces(system, s.c, s.e, options.tolerance, options.iterations);
  s.steps = it.steps;
  if (!it.converged || it.undetermined) s.outcome = why_unsettled(system, s.e, it);
  return s;
}

}  // namespace taut::solve
