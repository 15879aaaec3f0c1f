#include "taut/app/exact/mast_section_figures.hpp"

#include <algorithm>
#include <cmath>

namespace taut::app {
namespace {

using solve::GuyedMast;
using solve::GuyedMastResult;
using solve::MastPoint;

/// One curve over the height, of every third point: more than the eye can use already.
template <class F>
Curve over_height(const solve::GuyedMastResult& m, const char* label, F&& y) {
  Curve c;
  c.label = label;
  for (std::size_t i = 0; i < m.points.size(); i += 3) {
    c.x.push_back(m.points[i].height);
    c.y.push_back(y(m.points[i]));
  }
  c.x.push_back(m.points.back().height);
  c.y.push_back(y(m.points.back()));
  return c;
}

Plot moment_plot(const solve::GuyedMastResult& m) {
  Plot p{"mast_exact_moment",
         "Bending moment over the height, exact",
         "Towards the span and across it, in the axes of the deflected mast.",
         {"height above the foot", si::m},
         {"bending moment", si::N_m},
         {},
         {}};
  p.curves = {over_height(m, "towards the span",
                          [](const solve::MastPoint& x) { return structure::section_forces(x.state).bends_to_x; }),
              over_height(m, "across the span",
                          [](const solve::MastPoint& x) { return structure::section_forces(x.state).bends_to_y; })};
  return p;
}

Plot stress_plot(const solve::GuyedMastResult& m, double allowable) {
  Plot p{"mast_exact_stress",
         "Largest stress over the height, exact",
         "",
         {"height above the foot", si::m},
         {"stress", si::Pa},
         {},
         {}};
  p.curves = {over_height(m, "N/A + M/W", [](const solve::MastPoint& x) { return x.stress; })};
  p.marks = {{0, allowable, "allowable", true}};
  return p;
}

Plot deflection_plot(const solve::GuyedMastResult& m) {
  Plot p{"mast_exact_deflection",
         "Deflection over the height, exact",
         "",
         {"height above the foot", si::m},
         {"displacement", si::m.in("mm")},
         {},
         {}};
  p.curves = {over_height(m, "towards the span", [](const solve::MastPoint& x) { return x.state.place.x(); }),
              over_height(m, "across the span", [](const solve::MastPoint& x) { return x.state.place.y(); })};
  return p;
}

Drawing plan(const solve::GuyedMast& mast, const solve::GuyedMastResult& m) {
  Drawing d{"guys_plan",
            "Plan of the guys",
            "The span leaves to the right. Horizontal forces of the guys on the mast, and of the blocks.",
            {},
            si::m,
            1,
            {{Role::rope, "guyline"},
             {Role::hidden, "slack guyline"},
             {Role::force, "force of a guy"},
             {Role::second_force, "forces of the blocks"}}};
  double reach = 0;
  for (std::size_t i = 0; i < m.guys.size(); ++i) {
    const Vector3& anchor = mast.guys[i].anchor;
    const Vector3& F = m.guys[i].force_on_mast;
    reach = std::max(reach, anchor.head<2>().norm());
    d.shapes.emplace_back(
        Polyline{{{0, 0}, {anchor.x(), anchor.y()}}, m.guys[i].slack ? Role::hidden : Role::rope, false, false});
    d.shapes.emplace_back(Label{{1.06 * anchor.x(), 1.06 * anchor.y()}, mast.guys[i].name});
    if (!m.guys[i].slack) {
      d.shapes.emplace_back(ForceArrow{{0, 0}, F.x(), F.y(), "T_" + mast.guys[i].name, Role::force, false});
    }
  }
  Vector3 sum = Vector3::Zero();
  for (const solve::MastLoad& load : mast.loads) sum += load.force;
  d.shapes.emplace_back(ForceArrow{{0, 0}, sum.x(), sum.y(), "Q", Role::second_force, false});
  d.shapes.emplace_back(Polyline{{{0, 0}, {reach, 0}}, Role::axis, false, false});
  d.shapes.emplace_back(Circle{{0, 0}, 0.02 * reach, Role::structure, 0, 0, true});
  return d;
}

}  // namespace

void add_mast_figures(const solve::GuyedMast& mast, const solve::GuyedMastResult& m, double allowable, Result& r) {
  if (!m.guys.empty()) r.figures.emplace_back(plan(mast, m));
  r.figures.emplace_back(moment_plot(m));
  r.figures.emplace_back(stress_plot(m, allowable));
  r.figures.emplace_back(deflection_plot(m));
}

}  // namespace taut::app
