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
  Plot p{.name = "mast_exact_moment",
         .title = "Bending moment over the height, exact",
         .caption = "Towards the span and across it, in the axes of the deflected mast.",
         .x = {.label = "height above the foot", .unit = si::m},
         .y = {.label = "bending moment", .unit = si::N_m},
         .curves = {},
         .marks = {}};
  p.curves = {over_height(m, "towards the span",
                          [](const solve::MastPoint& x) { return structure::section_forces(x.state).bends_to_x; }),
              over_height(m, "across the span",
                          [](const solve::MastPoint& x) { return structure::section_forces(x.state).bends_to_y; })};
  return p;
}

Plot stress_plot(const solve::GuyedMastResult& m, double allowable) {
  Plot p{.name = "mast_exact_stress",
         .title = "Largest stress over the height, exact",
         .caption = "",
         .x = {.label = "height above the foot", .unit = si::m},
         .y = {.label = "stress", .unit = si::Pa},
         .curves = {},
         .marks = {}};
  p.curves = {over_height(m, "N/A + M/W", [](const solve::MastPoint& x) { return x.stress; })};
  p.marks = {{.x = 0, .y = allowable, .label = "allowable", .whole_line = true}};
  return p;
}

Plot deflection_plot(const solve::GuyedMastResult& m) {
  Plot p{.name = "mast_exact_deflection",
         .title = "Deflection over the height, exact",
         .caption = "",
         .x = {.label = "height above the foot", .unit = si::m},
         .y = {.label = "displacement", .unit = si::m.in("mm")},
         .curves = {},
         .marks = {}};
  p.curves = {over_height(m, "towards the span", [](const solve::MastPoint& x) { return x.state.place.x(); }),
              over_height(m, "across the span", [](const solve::MastPoint& x) { return x.state.place.y(); })};
  return p;
}

Drawing plan(const solve::GuyedMast& mast, const solve::GuyedMastResult& m) {
  Drawing d{.name = "guys_plan",
            .title = "Plan of the guys",
            .caption = "The span leaves to the right. Horizontal forces of the guys on the mast, and of the blocks.",
            .shapes = {},
            .unit = si::m,
            .vertical_scale = 1,
            .legend = {{Role::rope, "guyline"},
                       {Role::hidden, "slack guyline"},
                       {Role::force, "force of a guy"},
                       {Role::second_force, "forces of the blocks"}}};
  double reach = 0;
  for (std::size_t i = 0; i < m.guys.size(); ++i) {
    const Vector3& anchor = mast.guys[i].anchor;
    const Vector3& F = m.guys[i].force_on_mast;
    reach = std::max(reach, anchor.head<2>().norm());
    d.shapes.emplace_back(Polyline{.points = {{.x = 0, .y = 0}, {.x = anchor.x(), .y = anchor.y()}},
                                   .role = m.guys[i].slack ? Role::hidden : Role::rope,
                                   .closed = false,
                                   .filled = false});
    d.shapes.emplace_back(Label{.at = {.x = 1.06 * anchor.x(), .y = 1.06 * anchor.y()}, .text = mast.guys[i].name});
    if (!m.guys[i].slack) {
      d.shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = 0},
                                       .fx = F.x(),
                                       .fy = F.y(),
                                       .label = "T_" + mast.guys[i].name,
                                       .role = Role::force,
                                       .towards = false});
    }
  }
  Vector3 sum = Vector3::Zero();
  for (const solve::MastLoad& load : mast.loads) sum += load.force;
  d.shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = 0},
                                   .fx = sum.x(),
                                   .fy = sum.y(),
                                   .label = "Q",
                                   .role = Role::second_force,
                                   .towards = false});
  d.shapes.emplace_back(Polyline{
      .points = {{.x = 0, .y = 0}, {.x = reach, .y = 0}}, .role = Role::axis, .closed = false, .filled = false});
  d.shapes.emplace_back(Circle{
      .center = {.x = 0, .y = 0}, .radius = 0.02 * reach, .role = Role::structure, .from = 0, .to = 0, .filled = true});
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
