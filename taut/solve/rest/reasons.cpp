#include "taut/solve/rest/reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/base/number.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/rest/fed_rope.hpp"

namespace taut::solve {
namespace {

constexpr double vanishing = 1e-2;  // of the longest span
constexpr double wide_open = 1e-3;  // of a given tension

/// "along x", "about (0, 0.6, 0.8)".
std::string direction(const machine::Freedom& way) {
  const bool turns = way.about != Vector3::Zero();
  const Vector3& d = turns ? way.about : way.along;
  const char* names = "xyz";
  const std::string_view word = turns ? "about" : "along";
  for (int i = 0; i < 3; ++i) {
    if (std::abs(std::abs(d[i]) - 1) < 1e-12) return fmt::format("{} {}", word, names[i]);
  }
  return fmt::format("{} ({:.3g}, {:.3g}, {:.3g})", word, d.x(), d.y(), d.z());
}

std::string branch_words(const mechanics::System& s, int branch_index) {
  const mechanics::Layout::Branch& laid = s.layout.branches[branch_index];
  const machine::Reeving& rope = s.model.reevings[laid.reeving];
  return fmt::format("rope '{}' between '{}' and '{}'", rope.name, rope.nodes[laid.from].name,
                     rope.nodes[laid.to].name);
}

Outcome no_branch(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::NoBranch& no) {
  const mechanics::Layout::Branch& laid = s.layout.branches[no.branch];
  const machine::Reeving& rope = s.model.reevings[laid.reeving];
  const Vector3 chord = mechanics::end_at(rope.nodes[laid.to], c.bodies).centre -
                        mechanics::end_at(rope.nodes[laid.from], c.bodies).centre;
  if (no.why == rope::NoCatenary::too_short) {
    return infeasible(fmt::format(
        "{} does not reach: {:.6g} m of a rope that does not stretch over {:.6g} m; give it more length or a stiffness",
        branch_words(s, no.branch), c.branches[no.branch].length, chord.norm()));
  }
  const double radii = rope.nodes[laid.to].radius + rope.nodes[laid.from].radius;
  if (radii > 0 && chord.norm() <= radii) {
    for (const bool first : {false, true}) {
      const machine::Node &own = rope.nodes[first ? laid.from : laid.to],
                          &other = rope.nodes[first ? laid.to : laid.from];
      if (own.at.body == machine::ground || s.model.bodies[own.at.body].free.empty()) continue;
      return infeasible(fmt::format(
          "body '{}' is drawn up to '{}': {} has no room there (the centres {:.3g} m apart, the radii add up "
          "to {:.3g} m); make it heavier, give the rope more length, or put it farther away",
          s.model.bodies[own.at.body].name, other.name, branch_words(s, no.branch), chord.norm(), radii));
    }
    return infeasible(fmt::format("{} has no room: the centres lie {:.6g} m apart, the radii add up to {:.6g} m",
                                  branch_words(s, no.branch), chord.norm(), radii));
  }
  return not_converged(fmt::format(
      "no equilibrium found: {} finds no line on the way there ({:.6g} m of rope, centres {:.6g} m apart); hold the "
      "bodies it runs to, or change its length",
      branch_words(s, no.branch), c.branches[no.branch].length, chord.norm()));
}

/// The ropes that carry nothing, as words; empty if none.
std::string slack_ropes(const mechanics::System& s, const mechanics::Evaluation& e) {
  std::string words;
  for (std::size_t r = 0; r < s.layout.ropes.size(); ++r) {
    const mechanics::Layout::Rope& rope = s.layout.ropes[r];
    bool slack = true;
    for (int k = rope.first; k < rope.first + rope.count; ++k) slack = slack && e.branches[k].slack;
    if (slack) words += fmt::format("{}'{}'", words.empty() ? "" : ", ", s.model.reevings[r].name);
  }
  return words;
}

/// The freedom whose balance is worst.
std::optional<int> worst_freedom(const mechanics::System& s, const mechanics::Evaluation& e) {
  std::optional<int> worst;
  double most = -HUGE_VAL;
  for (int i = 0; i < static_cast<int>(s.layout.dofs.size()); ++i) {
    const bool turns = s.layout.dofs[i].way.about != Vector3::Zero();
    const double size = std::abs(e.residual[i]) / (turns ? s.layout.length : 1);
    if (size > most) {
      most = size;
      worst = i;
    }
  }
  return worst;
}

/// The branch that all but vanished beside a body that rolls on the rope: a carriage, or a roller without a radius. A
/// sheave with one is part of a block, which is drawn up.
std::optional<int> vanished(const mechanics::System& s, const mechanics::Configuration& c) {
  for (const mechanics::Layout::Turn& t : s.layout.turns) {
    const machine::Node& node = s.model.reevings[t.reeving].nodes[t.node];
    if (node.at.body == machine::ground || (node.radius > 0 && !machine::rides(s.model, node))) continue;
    for (const int branch : {t.before, t.after}) {
      if (c.branches[branch].length < vanishing * s.layout.length) return branch;
    }
  }
  return std::nullopt;
}

bool is_on_free_body(const mechanics::System& s, const machine::Node& node) {
  return node.at.body != machine::ground && !s.model.bodies[node.at.body].free.empty();
}

/// Of a branch that vanished, the end on a free body that was drawn up to its neighbour, in words. Where the rope holds
/// other bodies too, which of them is drawn up follows from the way of the search: together they do not balance.
std::string drawn_up(const mechanics::System& s, const machine::Reeving& rope, const machine::Node& own,
                     const machine::Node& other) {
  std::set<std::string> others;
  for (const machine::Node& node : rope.nodes) {
    if (is_on_free_body(s, node) && node.at.body != own.at.body)
      others.insert(fmt::format("'{}'", s.model.bodies[node.at.body].name));
  }
  const std::string& body = s.model.bodies[own.at.body].name;
  if (rope.given == machine::Given::tension_at_start || rope.given == machine::Given::tension_at_end) {
    return fmt::format(
        "body '{}' is drawn up to '{}': the tension given of rope '{}', which runs through, does not balance there, "
        "and nothing is left between them; give another tension, or a length",
        body, other.name, rope.name);
  }
  if (others.empty()) {
    return fmt::format(
        "body '{}' is drawn up to '{}': rope '{}' between them shrinks to nothing; make it heavier, give the rope more "
        "length, or pull less",
        body, other.name, rope.name);
  }
  return fmt::format(
      "body '{}' and {} do not balance on rope '{}', which runs through until nothing is left of a branch; change "
      "their "
      "weights, or hold one of them",
      body, fmt::join(others, ", "), rope.name);
}

/// The end of a rope on a free body that was drawn up to its neighbour, in words; empty without one.
std::string drawn_up(const mechanics::System& s, const mechanics::Configuration& c) {
  for (std::size_t k = 0; k < s.layout.branches.size(); ++k) {
    const mechanics::Layout::Branch& laid = s.layout.branches[k];
    if (c.branches[k].length >= vanishing * s.layout.length) continue;
    const machine::Reeving& rope = s.model.reevings[laid.reeving];
    const machine::Node &from = rope.nodes[laid.from], &to = rope.nodes[laid.to];
    if (is_on_free_body(s, from)) return drawn_up(s, rope, from, to);
    if (is_on_free_body(s, to)) return drawn_up(s, rope, to, from);
  }
  return {};
}

/// A carriage that is put beyond the places that its rope runs between, in words; empty where it is not.
std::string off_the_line(const mechanics::System& s) {
  if (!s.layout.coordinate_row) return {};
  for (const machine::Carriage& car : s.model.carriages) {
    if (car.body != s.layout.coordinate_body) continue;
    const Array<machine::Node>& nodes = s.model.reevings[car.reeving].nodes;
    const machine::Node* ends[] = {nullptr, nullptr};  // the neighbours on the ground, by their x
    for (const int n : {car.node - 1, car.node + car.rollers}) {
      if (n < 0 || n >= static_cast<int>(nodes.size()) || nodes[n].at.body != machine::ground) return {};
      ends[n < car.node ? 0 : 1] = &nodes[n];
    }
    const auto x_of = [&](const machine::Node* n) { return s.layout.coordinate_along.dot(n->at.at); };
    if (x_of(ends[0]) > x_of(ends[1])) std::swap(ends[0], ends[1]);
    const double reach = std::max(ends[0]->radius, ends[1]->radius);
    if (s.coordinate >= x_of(ends[0]) - reach && s.coordinate <= x_of(ends[1]) + reach) return {};
    const double origin = s.layout.coordinate_along.dot(s.model.origin);
    return fmt::format(
        "'{}' is put at x = {} m, but its rope runs from x = {} m ('{}') to {} m ('{}') "
        "there: choose a place between them",
        car.name, place_number(s.coordinate + origin), place_number(x_of(ends[0]) + origin), ends[0]->name,
        place_number(x_of(ends[1]) + origin), ends[1]->name);
  }
  return {};
}

/// Whether a rope that a body hangs on has its tension given.
bool hangs_on_given_tension(const mechanics::System& s, int body) {
  return std::any_of(s.model.reevings.begin(), s.model.reevings.end(), [&](const machine::Reeving& rope) {
    return rope.given != machine::Given::length &&
           std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const auto& n) { return n.at.body == body; });
  });
}

}  // namespace

std::optional<int> too_heavy(const mechanics::System& s, const mechanics::Evaluation& e, const Iteration& iteration) {
  if (!iteration.deep) return std::nullopt;
  const int rope = s.layout.branches[*iteration.deep].reeving;
  for (const FedEnd& end : fed_ends(s)) {
    const int other = s.model.reevings[rope].equal_to;
    const double tension = other < 0 ? end.tension : e.branches[s.layout.ropes[as_size(other)].first].T_from;
    if (end.rope == rope && e.residual[end.row] > wide_open * tension) return rope;
  }
  return std::nullopt;
}

Outcome too_heavy_outcome(const mechanics::System& s, int reeving, double least) {
  for (const FedEnd& end : fed_ends(s)) {
    if (end.rope != reeving) continue;
    const machine::Reeving& rope = s.model.reevings[reeving];
    if (rope.given == machine::Given::equal) {
      return infeasible(
          fmt::format("rope '{}' does not come down to the tension of '{}' at '{}': its own weight pulls harder, and "
                      "with more rope harder still; give it a length",
                      rope.name, s.model.reevings[rope.equal_to].name, rope.nodes.front().name));
    }
    const std::string known = least > 0 ? fmt::format(" (at least {:.4g} N)", least) : std::string();
    return infeasible(fmt::format(
        "rope '{}' does not come down to {:.6g} N at '{}': its own weight pulls harder{}, and with more rope harder "
        "still; give it more tension there, or a length",
        rope.name, end.tension, (end.at_end ? rope.nodes.back() : rope.nodes.front()).name, known));
  }
  return {};
}

Outcome reason(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
               const Iteration& iteration) {
  if (const std::string why = off_the_line(s); !why.empty()) return infeasible(why);
  if (iteration.stopped) return no_branch(s, c, *iteration.stopped);
  const auto worst = worst_freedom(s, e);
  const std::string slack = slack_ropes(s, e);
  const mechanics::Misfit m = mechanics::misfit(s, e);
  if (!worst) {
    if (const auto rope = too_heavy(s, e, iteration)) return too_heavy_outcome(s, *rope, 0);
    return not_converged(
        fmt::format("the ropes did not settle: {:.3g} N and {:.3g} m are open after the last step; are the given "
                    "lengths and tensions possible on these paths?",
                    m.force, m.length));
  }
  const mechanics::Layout::Dof& dof = s.layout.dofs[*worst];
  const std::string& body = s.model.bodies[dof.body].name;
  const double open = e.residual[*worst];
  const std::string_view unit = dof.way.about != Vector3::Zero() ? "N m" : "N";
  if (const auto branch = vanished(s, c)) {
    return infeasible(
        fmt::format("{} shrinks to nothing: what rolls there runs against its neighbour; hold it by a "
                    "mainline, or clamp it",
                    branch_words(s, *branch)));
  }
  if (const auto rope = too_heavy(s, e, iteration)) return too_heavy_outcome(s, *rope, 0);
  if (const std::string why = drawn_up(s, c); !why.empty()) return infeasible(why);
  if (!slack.empty()) {
    return infeasible(fmt::format("nothing balances {:.6g} {} on body '{}' {}: slack: {}; shorten it, or hold the body",
                                  open, unit, body, direction(dof.way), slack));
  }
  const bool given = hangs_on_given_tension(s, dof.body);
  if (iteration.singular && !given) {
    return infeasible(
        fmt::format("body '{}' is not held {}: {:.6g} {} stay open; add a rope, or take that freedom away", body,
                    direction(dof.way), open, unit));
  }
  const std::string_view advice =
      given ? "the tensions given do not balance its load, whatever the place: give other tensions, or lengths"
            : "try other lengths or weights, or hold the body by another rope";
  return not_converged(fmt::format("no equilibrium found: {:.6g} {} stay open on body '{}' {}; {}", open, unit, body,
                                   direction(dof.way), advice));
}

}  // namespace taut::solve
