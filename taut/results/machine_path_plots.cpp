#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/calc/none.hpp"
#include "taut/results/machine_figures.hpp"
#include "taut/results/plot_curves.hpp"

namespace taut::results {
namespace {

constexpr int clearance_points_per_span = 12;
/// Tension at a share of a span; what is above H and V, the centrifugal tension of a running rope, is the same
/// everywhere.
double tension_at(const solve::BranchResult& s, double share) {
  const double running = s.T_from - std::hypot(s.H, s.V_from);
  return running + std::hypot(s.H, s.V_from + share * (s.V_to - s.V_from));
}

const solve::ContactResult* contact_at(const solve::EquilibriumResult& e, int reeving, int node) {
  const auto at = std::find_if(e.contacts.begin(), e.contacts.end(),
                               [&](const auto& c) { return c.reeving == reeving && c.node == node; });
  return at == e.contacts.end() ? nullptr : &*at;
}

/// One rope's tension over its way, arcs counted. `marks`: where each node stands, or nullptr.
Curve along(const machine::Model& m, const solve::EquilibriumResult& e, int reeving, std::vector<Mark>* marks) {
  const machine::Reeving& rope = m.reevings[reeving];
  Curve curve;
  curve.label = rope.name;
  double way = 0;
  const auto name = [&](int n) {
    const machine::Node& node = rope.nodes[n];
    if (marks != nullptr && node.kind != machine::NodeKind::load) marks->push_back({way, 0, node.name, false});
  };
  for (const solve::BranchResult& s : e.branches) {
    if (s.reeving != reeving) continue;
    if (s.slack) {
      curve.x.push_back(way);
      curve.y.push_back(none);
    }
    if (curve.x.empty()) name(s.from);
    for (int i = 0; i <= clearance_points_per_span && !s.slack; ++i) {
      const double share = static_cast<double>(i) / clearance_points_per_span;
      curve.x.push_back(way + share * s.stretched);
      curve.y.push_back(tension_at(s, share));
    }
    way += s.stretched;
    const auto* c = contact_at(e, reeving, s.to);
    if (c != nullptr) way += std::max(0.0, c->wrap) * rope.nodes[s.to].radius;
    if (!rope.closed || s.to != 0) {
      name(s.to);
    } else if (c != nullptr) {
      curve.x.push_back(way);
      curve.y.push_back(c->T_out);
    }
  }
  return curve;
}

Plot path_plot(const std::string& name, const std::string& title) {
  Plot p;
  p.name = name;
  p.title = title;
  p.x = {.label = "way along the rope", .unit = si::m};
  p.y = {.label = "tension", .unit = si::N};
  return p;
}

/// The names of the path at the height of the first curve there.
void place_marks(const Curve& curve, std::vector<Mark> marks, Plot& p) {
  for (Mark& mark : marks) {
    const auto at = std::lower_bound(curve.x.begin(), curve.x.end(), mark.x - 1e-12);
    const auto i = std::min(static_cast<std::size_t>(at - curve.x.begin()), curve.y.size() - 1);
    mark.y = curve.y[i];
    if (std::isfinite(mark.y)) p.marks.push_back(std::move(mark));
  }
}

/// One rope in all equilibria, or all ropes in each.
void add_one_rope(const MachineRun& run, Result& r) {
  Plot p = path_plot("path_tensions", fmt::format("Tension along {}", run.model.reevings.front().name));
  std::vector<Mark> marks;
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    p.curves.push_back(along(one.model, one.result, 0, p.curves.empty() ? &marks : nullptr));
    p.curves.back().label = one.words;
  }
  if (p.curves.empty()) return;
  place_marks(p.curves.front(), std::move(marks), p);
  keep_largest(p, most_shown_curves);
  r.figures.emplace_back(std::move(p));
}

void add_all_ropes(const study::EquilibriumRun& one, Result& r) {
  Plot p = path_plot("path_tensions" + one.ending, fmt::format("Tension along the ropes, {}", one.words));
  for (std::size_t i = 0; i < one.model.reevings.size(); ++i) {
    p.curves.push_back(along(one.model, one.result, static_cast<int>(i), nullptr));
  }
  keep_largest(p, most_shown_curves);
  r.figures.emplace_back(std::move(p));
}

}  // namespace

void add_path_plots(const MachineRun& run, Result& r) {
  if (!run.paths.empty() || run.equilibria.empty()) return;
  if (run.model.reevings.size() == 1) return add_one_rope(run, r);
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (one.result.outcome.ok()) add_all_ropes(one, r);
  }
}

}  // namespace taut::results
